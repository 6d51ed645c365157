#pragma once
// The subcommands of the program. Each function adds one to the command line; its action stores the exit code: 0
// success, 1 differences or warnings, 2 invalid input, 3 the garment was dressed with a defect, 4 it does not fit,
// 128 + n stopped by signal n.

namespace selvedge::app {

class Command;

void add_animate_command(Command& app, int& exit_code);
void add_batch_command(Command& app, int& exit_code);
void add_bench_command(Command& app);
void add_check_command(Command& app, int& exit_code);
void add_diff_command(Command& app, int& exit_code);
void add_dress_command(Command& app, int& exit_code);
void add_edit_command(Command& app, int& exit_code);
void add_mannequin_command(Command& app, int& exit_code);
void add_import_command(Command& app, int& exit_code);
void add_match_command(Command& app, int& exit_code);
void add_print_command(Command& app, int& exit_code);
void add_render_command(Command& app, int& exit_code);

}  // namespace selvedge::app
