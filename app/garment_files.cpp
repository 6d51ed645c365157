#include "app/garment_files.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "app/arguments.h"
#include "app/baked_textures.h"
#include "app/garment_options.h"
#include "app/options.h"
#include "render/scene/scene.h"
#include "sim/core/error.h"
#include "sim/dress/dressing.h"
#include "sim/exchange/garmentcode_element.h"
#include "sim/exchange/mesh_file.h"
#include "sim/exchange/thick_cloth.h"

namespace selvedge::app {
namespace {

using Path = std::filesystem::path;

ClothThickness parse_thickness(const std::string& text) {
    if (text == "fabric") return {};
    constexpr double kLeastMm = 0.01, kMostMm = 50;
    const std::optional<std::vector<double>> numbers = parse_numbers(text);
    if (!numbers || numbers->size() != 1 || numbers->front() < kLeastMm || numbers->front() > kMostMm)
        throw sim::InputError("", "--thickness", "'" + text + "' is neither from 0.01 to 50 mm nor 'fabric'");
    return {.metres = numbers->front() / 1000};
}

// Of each panel, m.
std::vector<float> thickness_of_panels(const ClothThickness& thickness, const sim::Pattern& pattern) {
    if (thickness.metres) return std::vector<float>(pattern.panels.size(), static_cast<float>(*thickness.metres));
    std::vector<float> of_panels;
    for (const sim::Fabric& fabric : fabrics_of(pattern)) of_panels.push_back(static_cast<float>(fabric.thickness));
    return of_panels;
}

}  // namespace

void add_garment_file_options(Command& command, GarmentFileOptions& options) {
    add_option(command, "--export", options.files, "The garment as .obj, .glb, .ply or .stl; may be repeated",
               {.type = "FILE", .group = "Output", .takes_one_value = true});
    add_number<int>(
        command, "--texture-size", {64, 16384}, "Side of the textures of .glb and .obj, in pixels (default 2048)",
        {.type = "PX", .group = "Output"}, [&options](int size_px) { options.content.atlas.size_px = size_px; });
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
        if (options.has_body && !sim::mesh_format_of(file).takes_body)
            throw sim::InputError(file.string(), "--with-body",
                                  "this format has no room for a body: use --export-body");
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

void GarmentFiles::write(const Path& file) {
    sim::GarmentExport content = options_.content;
    if (options_.has_body) content.body = &body_;
    if (options_.has_textures && sim::mesh_format_of(file).takes_textures) content.textures = textures();
    write_garment(mesh(), file, content);
}

const sim::DrawMesh& GarmentFiles::thin_mesh() {
    if (!thin_mesh_) {
        const SurfaceChoice surface = options_.has_curved_surface ? picture_.surface : SurfaceChoice{};
        thin_mesh_ = drawn_mesh(garment_, &body_, surface);
    }
    return *thin_mesh_;
}

const sim::DrawMesh& GarmentFiles::mesh() {
    if (!options_.thickness) return thin_mesh();
    if (!thick_mesh_)
        thick_mesh_ = with_thickness(thin_mesh(), thickness_of_panels(*options_.thickness, *picture_.pattern));
    return *thick_mesh_;
}

const sim::GarmentTextures& GarmentFiles::textures() {
    if (!textures_) {
        render::ClothItem cloth{.mesh = thin_mesh(), .sett = {}};
        const std::vector<render::ClothItem> cloths = picture_.looks->parts(std::move(cloth), *picture_.pattern);
        textures_ = bake_pngs(thin_mesh(), cloths, options_.content.atlas);
    }
    return *textures_;
}

}  // namespace selvedge::app
