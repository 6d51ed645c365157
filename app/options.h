#pragma once
// The body that a garment is put on: a mannequin from measurements, or a file that others made. Shared by dress and
// render.
#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/scene/camera.h"
#include "render/surface/curved_mesh.h"
#include "sim/body/body.h"
#include "sim/body/load_body.h"

namespace CLI {
class App;
}

namespace selvedge::app {

struct BodyOptions {
    std::string source;  // "mannequin[:bust=92,...]" or a file; empty: none was named
    sim::LoadBodyOptions load;

    bool is_file() const;
};

struct NotedBody {
    sim::Body body;
    std::vector<std::string> notes;  // what could not be met, or was changed, a sentence each
};

// Adds -b,--body, --body-unit and --body-up. A mannequin's measures are checked while the command line is read.
// `options` must outlive the command line.
void add_body_options(CLI::App& command, BodyOptions& options, const std::string& help);

// Pre: a source is named. Throws InputError as make_mannequin and load_body do.
NotedBody make_body(const BodyOptions& options);

// --camera: where the picture is taken from, in numbers.

// Either a direction, in which the scene is framed and then magnified, or the eye and what it looks at.
struct CameraChoice {
    render::Direction direction;
    float zoom = 1;
    std::optional<std::array<Vec3f, 2>> eye_and_target;  // m
};

// "azimuth,elevation[,zoom]" in degrees, or "x,y,z,x,y,z" in metres. Throws InputError.
CameraChoice parse_camera(const std::string& text);

// All of `text` as finite numbers between commas, or none where it is anything else.
std::optional<std::vector<double>> parse_numbers(std::string_view text);

// Drawing the cloth curved: the options that dress and render share.

struct SurfaceChoice {
    std::optional<render::SurfaceKind> kind;  // none: the cloth's own triangles, as they were simulated
    std::optional<int> level;                 // none: adaptive
    bool coarsens_back_faces = false;
    render::LightNormals light_normals = render::LightNormals::Recomputed;
};

// Adds --surface, --surface-level, --surface-normals and --back-face-coarsening, checked while the command line is
// read. `choice` must outlive the command line.
void add_surface_options(CLI::App& command, SurfaceChoice& choice);

// The garment as it is drawn. view: of whoever looks at it, if there is one. body: not to dip into, may be null.
// Throws InputError as curved_mesh() does.
sim::PlainMesh drawn_mesh(const sim::PlainMesh& garment, const sim::Body* body, const SurfaceChoice& choice,
                          const std::optional<sim::ViewPoint>& view = {});

// Files that a subcommand will write, looked at before its work begins: nobody should wait for what cannot be kept.

// For check_output.
inline constexpr std::array<std::string_view, 1> kPictureExtensions{".png"};
inline constexpr std::array<std::string_view, 2> kMeshExtensions{".obj", ".glb"};

// Throws InputError when the folder is not there or may not be written to, when something stands there that is no file,
// or when the name ends in none of the extensions, in small or capital letters (none given: any will do).
void check_output(const std::filesystem::path& path, std::span<const std::string_view> extensions = {});

// Throws InputError when two outputs are one file, or an output is a file that is read.
void check_apart(const std::vector<std::filesystem::path>& outputs, const std::vector<std::filesystem::path>& inputs);

}  // namespace selvedge::app
