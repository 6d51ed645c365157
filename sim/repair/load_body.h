#pragma once
// Loads a body from an OBJ, glTF, GLB or FBX file: reads it in a guarded child process (guarded_import.h), converts it
// to metres with y up, and repairs it to a closed surface (surface_repair.h). Keeps the file's bones, skin weights and
// clips. Also loads motion alone, without a surface.
#include <filesystem>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/repair/surface_repair.h"

namespace selvedge::sim {

struct ImportedScene;  // sim/repair/guarded_import.h

enum class LengthUnit { Auto, Metres, Decimetres, Centimetres, Millimetres, Inches };  // Auto: by height and depth
enum class UpAxis { Auto, Y, Z };  // Auto: the longer of y and z; y for glTF

struct LoadBodyOptions {
    LengthUnit unit = LengthUnit::Auto;
    UpAxis up = UpAxis::Auto;
    bool stands_on_floor = true;  // moves the lowest point to y = 0; otherwise the height stays as in the file
    RepairOptions repair = {};
};

struct LoadBodyReport {
    LengthUnit unit = LengthUnit::Metres;  // as used
    bool is_unit_assumed = true;           // not requested
    UpAxis up = UpAxis::Y;                 // as used
    RepairReport repair;
    std::vector<std::string> notes;  // one sentence per change; empty when nothing was changed
};

// Body::file of a body that is read from this path, which need not exist.
std::string canonical_name(const std::filesystem::path& path);

// Throws InputError when the file cannot be read, is not a body, or its surface cannot be closed. Post: the surface is
// closed, each piece is manifold and has outward orientation.
Body load_body(const std::filesystem::path& path, const LoadBodyOptions& options = {},
               LoadBodyReport* report = nullptr);

// A skeleton and what it can do.
struct BodyClips {
    Body body;  // its bones; without a surface if only motion was loaded
    std::vector<Clip> clips;
};

// A body with the clips of its file. Throws as load_body(), and where check_clip() does.
BodyClips load_moving_body(const std::filesystem::path& path, const LoadBodyOptions& options = {},
                           LoadBodyReport* report = nullptr);

// The same of a scene that was read from this path already.
BodyClips body_of(ImportedScene scene, const std::filesystem::path& path, const LoadBodyOptions& options = {},
                  LoadBodyReport* report = nullptr);

// Skeleton and clips of a BVH, FBX, glTF or GLB file, in the file's unit and axes: for retarget(). All nodes of the
// file are bones. Throws InputError.
BodyClips load_motion(const std::filesystem::path& path);

}  // namespace selvedge::sim
