// selvedge bench picture: what a picture costs, the first and those after it.
#include <memory>

#include "app/bench.h"
#include "app/body_options.h"
#include "bench/picture/picture.h"
#include "sim/exchange/mesh_file.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge {
namespace {

struct PictureArguments {
    std::string garment;
    BodyOptions body;
    PictureExperiment experiment;
    std::string json;
};

int run(const PictureArguments& arguments) {
    check_json_output(arguments.json);
    Scene scene;
    ClothItem cloth;
    cloth.mesh = read_garment(arguments.garment);
    cloth.sett = find_tartan(kDefaultTartan);
    scene.cloths.push_back(std::move(cloth));
    if (!arguments.body.source.empty()) scene.bodies.push_back(make_body_item(make_body(arguments.body).body));
    const Table table = table_of(measure_pictures(scene, arguments.experiment));
    print_table(table);
    write_json_output(arguments.json, document_of({table}));
    return 0;
}

}  // namespace

void add_bench_picture(CLI::App& bench, int& exit_code) {
    auto arguments = std::make_shared<PictureArguments>();
    PictureExperiment& experiment = arguments->experiment;
    CLI::App* command = bench.add_subcommand("picture", "The first picture, and those after it");
    command->add_option("MESH", arguments->garment, "Garment, as dress exports it (.obj or .glb)")->required();
    add_body_options(*command, arguments->body, "Body that wears it: a file, or mannequin[:bust=92,...]");
    command->add_option("--triangles", experiment.triangles, "Of the cloth, at least (default 20000)")
        ->check(CLI::Range(1, 5000000));
    command->add_option("--pictures", experiment.pictures, "Of each kind (default 12)")->check(CLI::Range(1, 1000));
    command->add_option("--side", experiment.render.width_px, "Of the square picture, px (default 1024)")
        ->check(CLI::Range(16, 8192));
    add_json_option(*command, arguments->json);
    command->footer(
        "Example:\n"
        "  selvedge dress patterns/tshirt.json --export tshirt.glb --export-body body.glb\n"
        "  selvedge bench picture tshirt.glb --body body.glb --json picture.json");
    command->callback([arguments, &exit_code] {
        arguments->experiment.render.height_px = arguments->experiment.render.width_px;
        exit_code = run(*arguments);
    });
}

}  // namespace selvedge
