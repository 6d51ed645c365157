// selvedge render MESH: a picture of a garment that was exported before, with or without a body.
#include <cstdio>
#include <memory>

#include "app/body_options.h"
#include "app/commands.h"
#include "app/output_files.h"
#include "app/picture.h"
#include "render/image/png.h"
#include "sim/exchange/mesh_file.h"

namespace selvedge {
namespace {

struct RenderArguments {
    std::string garment;
    BodyOptions body;
    std::string output;
    PictureOptions picture;
};

int render(const RenderArguments& arguments) {
    check_output(arguments.output, kPictureExtensions);
    const PlainMesh garment = read_garment(arguments.garment);
    std::optional<Body> body;
    if (!arguments.body.source.empty()) body = make_body(arguments.body).body;
    write_png(arguments.output, draw_picture(garment, body ? &*body : nullptr, arguments.picture));
    std::printf("wrote %s\n", arguments.output.c_str());
    return 0;
}

}  // namespace

void add_render_command(CLI::App& app, int& exit_code) {
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App* command = app.add_subcommand("render", "Draw a garment from an OBJ or GLB file");
    command->add_option("MESH", arguments->garment, "Garment, as dress exports it (.obj or .glb)")->required();
    add_body_options(*command, arguments->body, "Body that wears it: a file, or mannequin[:bust=92,...]");
    command->add_option("-o,--output", arguments->output, "PNG file to write")->required();
    add_picture_options(*command, arguments->picture);
    command->footer(
        "Examples:\n"
        "  selvedge render tshirt.obj --body body.obj -o tshirt.png --view three-quarter\n"
        "  selvedge render tshirt.glb -o levels.png --show level --size 2048x2048\n"
        "  selvedge render tshirt.glb -o check.png --tartan 'K/8 W/8' --sett-size 4");
    command->callback([arguments, &exit_code] { exit_code = render(*arguments); });
}

}  // namespace selvedge
