// selvedge: the program's entry point. Each subcommand has a file of its own.
#include "app/arguments.h"
#include "app/command_line.h"
#include "app/commands.h"
#include "app/version_text.h"
#include "render/output/shipped_files.h"

int main(int argc, char** argv) {
    selvedge::render::use_shipped_fonts();
    selvedge::app::Command app{"Selvedge: cut, sew and drape garments on an adaptive mesh."};
    set_version(app, [] { return selvedge::app::version_text(selvedge::app::program_build()); });
    require_command(app);
    set_footer(app, "Example: selvedge dress patterns/tshirt.json --render tshirt.png");

    int exit_code = 0;
    selvedge::app::add_dress_command(app, exit_code);
    selvedge::app::add_animate_command(app, exit_code);
    selvedge::app::add_batch_command(app, exit_code);
    selvedge::app::add_edit_command(app, exit_code);
    selvedge::app::add_check_command(app, exit_code);
    selvedge::app::add_mannequin_command(app, exit_code);
    selvedge::app::add_import_command(app, exit_code);
    selvedge::app::add_match_command(app, exit_code);
    selvedge::app::add_print_command(app, exit_code);
    selvedge::app::add_render_command(app, exit_code);
    selvedge::app::add_diff_command(app, exit_code);
    selvedge::app::add_bench_command(app);
    return selvedge::app::run_command_line(app, argc, argv, exit_code);
}
