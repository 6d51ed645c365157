// selvedge render MESH: draws an exported garment, with or without a body.
#include <cstdio>
#include <memory>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/film.h"
#include "app/options.h"
#include "app/picture.h"
#include "app/progress_bar.h"
#include "render/image/image.h"
#include "render/output/interface_fonts.h"
#include "sim/core/error.h"
#include "sim/core/printable.h"
#include "sim/exchange/mesh_file.h"
#include "sim/pattern/named_file.h"

namespace selvedge::app {
namespace {

struct RenderArguments {
    std::string garment;
    BodyOptions body;
    std::string output;
    PictureOptions picture;
    TurntableOptions turntable;
    bool is_quiet = false;
    std::string fabric;  // empty: the default
};

void check_outputs(const RenderArguments& arguments) {
    if (arguments.output.empty() && arguments.turntable.file.empty())
        throw sim::InputError("", "render", "nothing to write: name a picture with -o or a film with --turntable");
    if (!arguments.output.empty()) check_output(arguments.output, kPictureExtensions);
    check_turntable(arguments.turntable, arguments.picture);
    std::vector<std::filesystem::path> inputs{arguments.garment};
    if (arguments.body.is_file()) inputs.emplace_back(arguments.body.source);
    sim::Pattern drawn;
    drawn.fabric = arguments.fabric;
    drawn.surface = arguments.picture.design;
    for (const std::string& file : named_files(drawn)) inputs.emplace_back(file);
    std::vector<std::filesystem::path> outputs{arguments.output, arguments.turntable.file};
    std::erase(outputs, std::filesystem::path());
    check_distinct(outputs, inputs);
}

int render(RenderArguments& arguments) {
    check_outputs(arguments);
    show_design(arguments.picture, arguments.fabric);
    check_can_draw(arguments.picture);
    arguments.picture.legend_font = render::read_legend_font();
    check_can_show(arguments.picture.show, !arguments.body.source.empty(), false);
    const sim::DrawMesh garment = sim::read_garment(arguments.garment);
    std::shared_ptr<const sim::Body> body;
    if (!arguments.body.source.empty()) body = make_body(arguments.body).body;
    const RenderSubject subject{.garment = garment, .body = body.get()};
    if (!arguments.output.empty()) {
        write_png(arguments.output, draw_picture(subject, arguments.picture));
        std::printf("wrote %s\n", sim::printable(arguments.output).c_str());
    }
    if (!arguments.turntable.file.empty()) {
        ProgressBar bar(progress_bar_options(arguments.is_quiet));
        write_turntable(subject, arguments.picture, arguments.turntable, bar.progress());
        bar.finish();
        std::printf("wrote %s\n", sim::printable(arguments.turntable.file.string()).c_str());
    }
    return 0;
}

}  // namespace

void add_render_command(Command& app, int& exit_code) {
    auto arguments = std::make_shared<RenderArguments>();
    Command& command = add_command(app, "render", "Draw a garment from an OBJ or GLB file");
    add_option(command, "MESH", arguments->garment, "Garment, as dress exports it (.obj or .glb)",
               {.is_required = true});
    add_body_options(command, arguments->body, "Body that wears it: a file, or mannequin[:bust=92,...]");
    add_option(command, "-o,--output", arguments->output, "PNG file to write");
    add_flag(command, "-q,--quiet", arguments->is_quiet, "Show no progress");
    add_text_option(command, "--fabric", "A shipped fabric or a fabric file: how it takes light", {.type = "NAME|FILE"},
                    [arguments](const std::string& name) {
                        arguments->picture.material = render::material_of(sim::find_fabric(name));
                        arguments->fabric = name;
                    });
    add_picture_options(command, arguments->picture);
    add_turntable_options(command, arguments->turntable);
    set_footer(command,
               "Examples:\n"
               "  selvedge render tshirt.obj --body body.obj -o tshirt.png --view three-quarter\n"
               "  selvedge render tshirt.glb -o mesh.png --show edges --size 2048x2048\n"
               "  selvedge render tshirt.glb -o check.png --tartan 'K/8 W/8' --sett-size 4\n"
               "  selvedge render tshirt.glb -o roses.png --design roses.jpg --sett-size 12\n"
               "  selvedge render tshirt.glb --body body.obj -o side.png --camera 60,-10,2 --frame garment\n"
               "  selvedge render tshirt.glb --body body.obj --turntable tshirt.mp4 --size 720x960");
    set_action(command, [arguments, &exit_code] { exit_code = render(*arguments); });
}

}  // namespace selvedge::app
