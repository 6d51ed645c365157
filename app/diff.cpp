// selvedge diff A.png B.png: compares two pictures, and shows where they differ.
#include <cstdio>
#include <memory>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/options.h"
#include "render/image/image.h"
#include "sim/core/printable.h"

namespace selvedge::app {
namespace {

struct DiffArguments {
    std::string first;
    std::string second;
    std::string output;
    bool allows_rounding = false;
};

std::string size_text(const render::Image& image) {
    return std::to_string(image.width_px) + "x" + std::to_string(image.height_px);
}

std::string output_path(const DiffArguments& arguments) {
    if (!arguments.output.empty()) return arguments.output;
    return std::filesystem::path(arguments.second).stem().string() + ".diff.png";
}

int diff(const DiffArguments& arguments) {
    const render::Image first = render::read_png(arguments.first);
    const render::Image second = render::read_png(arguments.second);
    const render::Comparison comparison = compare(first, second);
    const bool is_same = arguments.allows_rounding ? is_alike(comparison) : comparison.is_exact();
    if (is_same) {
        std::printf("%s\n", comparison.is_exact() ? "same" : ("alike: " + describe(comparison)).c_str());
        return 0;
    }
    if (!comparison.has_same_size) {
        std::printf("sizes differ: %s is %s, %s is %s\n", sim::printable(arguments.first).c_str(),
                    size_text(first).c_str(), sim::printable(arguments.second).c_str(), size_text(second).c_str());
    } else {
        std::printf("%s\n", describe(comparison).c_str());
    }
    const std::string output = output_path(arguments);
    check_distinct({output}, {arguments.first, arguments.second});
    write_png(output, difference_picture(first, second));
    std::printf("wrote %s\n", sim::printable(output).c_str());
    return 1;
}

}  // namespace

void add_diff_command(Command& app, int& exit_code) {
    auto arguments = std::make_shared<DiffArguments>();
    Command& command = add_command(app, "diff", "Compare two pictures; exit 1 when they differ");
    add_option(command, "A", arguments->first, "PNG picture", {.is_required = true});
    add_option(command, "B", arguments->second, "PNG picture", {.is_required = true});
    add_option(command, "-o,--output", arguments->output,
               "Difference picture, written when they differ (default: B's name with .diff.png, here)");
    add_flag(command, "--rounding", arguments->allows_rounding,
             "Let pass what another CPU's rounding explains: at most 3/255, with 0.01 % of pixels beyond");
    set_footer(command, "Example: selvedge diff before.png after.png -o difference.png");
    set_action(command, [arguments, &exit_code] { exit_code = diff(*arguments); });
}

}  // namespace selvedge::app
