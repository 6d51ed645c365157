#include "render/output/garment_files.h"

#include <string>
#include <utility>

#include "render/output/baked_textures.h"
#include "render/scene/scene.h"
#include "sim/core/error.h"
#include "sim/dress/dressing.h"
#include "sim/exchange/mesh_file.h"
#include "sim/exchange/thick_cloth.h"

namespace selvedge::render {

void check_format(const std::filesystem::path& file, const GarmentFileOptions& options) {
    if (options.has_body && !sim::mesh_format_of(file).takes_body)
        throw sim::InputError(file.string(), "--with-body", "this format has no room for a body: use --export-body");
}

namespace {

// Of each panel, m.
std::vector<float> thickness_of_panels(const ClothThickness& thickness, const sim::Pattern& pattern) {
    if (thickness.metres) return std::vector<float>(pattern.panels.size(), static_cast<float>(*thickness.metres));
    std::vector<float> of_panels;
    for (const sim::Fabric& fabric : fabrics_of(pattern)) of_panels.push_back(static_cast<float>(fabric.thickness));
    return of_panels;
}

}  // namespace

void GarmentFiles::write(const std::filesystem::path& file) {
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
        ClothItem cloth{.mesh = thin_mesh(), .sett = {}};
        const std::vector<ClothItem> cloths = picture_.looks->parts(std::move(cloth), *picture_.pattern);
        textures_ = bake_pngs(thin_mesh(), cloths, options_.content.atlas);
    }
    return *textures_;
}

}  // namespace selvedge::render
