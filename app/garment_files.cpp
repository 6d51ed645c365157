#include "app/garment_files.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "app/arguments.h"
#include "app/garment_options.h"
#include "app/options.h"
#include "sim/core/error.h"
#include "sim/core/numbers.h"
#include "sim/dress/dressing.h"
#include "sim/exchange/garmentcode_element.h"
#include "sim/exchange/mesh_file.h"

namespace selvedge::app {
namespace {

using Path = std::filesystem::path;

render::ClothThickness parse_thickness(const std::string& text) {
    if (text == "fabric") return {};
    constexpr Limits<double> limits = render::kThicknessesMm;
    const std::optional<std::vector<double>> numbers = sim::parse_number_list(text);
    if (!numbers || numbers->size() != 1 || numbers->front() < limits.least || numbers->front() > limits.most)
        throw sim::InputError("", "--thickness", "'" + text + "' is neither from 0.01 to 50 mm nor 'fabric'");
    return {.metres = numbers->front() / 1000};
}

}  // namespace

void add_garment_file_options(Command& command, GarmentFileOptions& options) {
    add_option(command, "--export", options.files, "The garment as .obj, .glb, .ply or .stl; may be repeated",
               {.type = "FILE", .group = "Output", .takes_one_value = true});
    add_number<int>(command, "--texture-size", render::kTextureSizesPx,
                    "Side of the textures of .glb and .obj, in pixels (default 2048)",
                    {.type = "PX", .group = "Output"},
                    [&options](int size_px) { options.content.atlas.size_px = size_px; });
    add_flag(command, "--no-textures{false}", options.has_textures,
             "Exports without colour; an .obj is in metric coordinates", {.group = "Output"});
    add_flag(command, "--with-body", options.has_body, "Exports hold the body too", {.group = "Output"});
    add_text_option(
        command, "--thickness",
        "Exports are closed solids with two sides, so thick: a number of mm, or 'fabric' for the fabrics' own",
        {.type = "MM|fabric", .group = "Output", .needs = {"--export"}},
        [&options](const std::string& text) { options.thickness = parse_thickness(text); });
    add_flag(command, "--export-surface", options.has_curved_surface, "Exports carry the curved surface (--surface)",
             {.group = "Output", .needs = {"--surface", "--export"}});
    add_option(command, "--export-garmentcode", options.garmentcode_folder,
               "Folder for the files of an element of GarmentCodeData: NAME_sim.obj and "
               ".ply, segmentation, vertex labels, specification",
               {.type = "DIR", .group = "Output"});
}

void check_garment_files(const GarmentFileOptions& options) {
    for (const Path& file : options.files) {
        check_output(file, sim::mesh_extensions());
        check_format(file, options);
    }
    const Path& folder = options.garmentcode_folder;
    if (folder.empty()) return;
    std::error_code error;
    if (std::filesystem::exists(folder, error) && !std::filesystem::is_directory(folder, error))
        throw sim::InputError(folder.string(), "--export-garmentcode", "is a file: a folder is needed");
    if (std::filesystem::is_directory(folder, error)) {
        for (const Path& file : sim::garmentcode_paths(folder, "any")) check_output(file);
    } else {
        check_output(folder.has_filename() ? folder : folder.parent_path());  // it will be made
    }
}

std::vector<Path> outputs_of(const GarmentFileOptions& options, const Path& garment) {
    std::vector<Path> outputs = options.files;
    if (options.has_textures) {
        for (const Path& file : options.files) std::ranges::copy(sim::paths_beside(file), std::back_inserter(outputs));
    }
    if (!options.garmentcode_folder.empty())
        std::ranges::copy(sim::garmentcode_paths(options.garmentcode_folder, element_name(garment)),
                          std::back_inserter(outputs));
    return outputs;
}

std::string element_name(const Path& garment) {
    constexpr std::string_view kEnding = "_specification";
    std::string name = garment.stem().string();
    if (name.size() > kEnding.size() && name.ends_with(kEnding)) name.resize(name.size() - kEnding.size());
    return name;
}

}  // namespace selvedge::app
