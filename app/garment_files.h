#pragma once
// The files of a dressed garment for other programs, and the options of dress that ask for them.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/picture.h"
#include "sim/body/body.h"
#include "sim/exchange/garment_export.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::app {

class Command;

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

// Adds --export, --texture-size, --no-textures, --with-body, --thickness, --export-surface and --export-garmentcode,
// and validates them while parsing. Pre: the command has --surface. `options` must outlive the parsing.
void add_garment_file_options(Command& command, GarmentFileOptions& options);

// Throws InputError if a file cannot be written, or its format cannot hold what is asked for.
void check_garment_files(const GarmentFileOptions& options);

// All files that may be written, those beside others included. garment: the file that is dressed.
std::vector<std::filesystem::path> outputs_of(const GarmentFileOptions& options, const std::filesystem::path& garment);

// The name of a garment's element of GarmentCodeData: "rand_12" of rand_12_specification.json and of rand_12.json.
std::string element_name(const std::filesystem::path& garment);

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

}  // namespace selvedge::app
