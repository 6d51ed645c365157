#pragma once
// The files of a dressed garment for other programs: its mesh in any format of sim/exchange/mesh_file.h, with textures
// of its cloth, the body, a thickness, or the curved surface.
#include <filesystem>
#include <optional>
#include <vector>

#include "render/output/picture.h"
#include "sim/body/body.h"
#include "sim/core/numbers.h"
#include "sim/exchange/garment_export.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::render {

// How thick the cloth of an export is.
struct ClothThickness {
    std::optional<double> metres{};  // of all panels; none: as thick as the fabric of each
};

struct GarmentFileOptions {
    std::vector<std::filesystem::path> files;
    sim::GarmentExport content;
    bool has_textures = true;
    bool has_body = false;                      // in the same files
    bool has_curved_surface = false;            // instead of the simulated triangles
    std::optional<ClothThickness> thickness{};  // none: without
    // Of an element of GarmentCodeData (sim/exchange/garmentcode_element.h); empty: none.
    std::filesystem::path garmentcode_folder{};
};

inline constexpr sim::Limits<double> kThicknessesMm{0.01, 50};
inline constexpr sim::Limits<int> kTextureSizesPx{64, 16384};

// Throws InputError if the format of the file cannot hold what is asked for.
void check_format(const std::filesystem::path& file, const GarmentFileOptions& options);

// Exports of one garment, which share its mesh and textures. The arguments must outlive it.
class GarmentFiles {
 public:
    // picture: what the cloth looks like. Pre: it has a pattern, and looks.
    GarmentFiles(const GarmentFileOptions& options, const PictureOptions& picture, const sim::DrawMesh& garment,
                 const sim::Body& body)
        : options_(options), picture_(picture), garment_(garment), body_(body) {}

    // Throws InputError.
    void write(const std::filesystem::path& file);

 private:
    const sim::DrawMesh& thin_mesh();
    const sim::DrawMesh& mesh();
    const sim::GarmentTextures& textures();

    const GarmentFileOptions& options_;
    const PictureOptions& picture_;
    const sim::DrawMesh& garment_;
    const sim::Body& body_;
    std::optional<sim::DrawMesh> thin_mesh_;
    std::optional<sim::DrawMesh> thick_mesh_;
    std::optional<sim::GarmentTextures> textures_;
};

}  // namespace selvedge::render
