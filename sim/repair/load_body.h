#pragma once
// Loads a body from an OBJ, glTF, GLB or FBX file: reads it in a guarded child process (guarded_import.h), leaves out
// what is not of the person in it (find_person.h), converts it to metres with y up, and repairs it to a closed surface
// (surface_repair.h). Keeps the file's bones, skin weights and
// clips. Also loads motion alone, without a surface.
#include <filesystem>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/repair/find_person.h"
#include "sim/repair/surface_repair.h"

namespace selvedge::sim {

struct ImportedScene;  // sim/repair/guarded_import.h

// Auto: by height and depth. Poser: of the program of that name, 8.6 feet.
enum class LengthUnit { Auto, Metres, Decimetres, Centimetres, Millimetres, Inches, Feet, Poser };

struct LoadBodyOptions {
    LengthUnit unit = LengthUnit::Auto;
    UpAxis up = UpAxis::Auto;     // Auto: that with which a person stands; the longer of y and z, but y for glTF, first
    bool must_be_person = false;  // refuses a surface on which no person is found, or one of an impossible stature
    bool stands_on_floor = true;  // moves the lowest point to y = 0; otherwise the height stays as in the file
    RepairOptions repair = {};
};

struct LoadBodyReport {
    LengthUnit unit = LengthUnit::Metres;  // as used
    bool is_unit_assumed = true;           // not requested
    UpAxis up = UpAxis::Y;                 // as used
    int quarter_turns = 0;                 // by which the person was turned to face the front
    std::vector<std::string>
        left_out;  // pieces that are not of the person: a description with the reason for each kind
    RepairReport repair;
    int joined_pieces = 0;           // of a body of parts, round which one surface was made; 0: it is of one piece
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
    bool is_y_up = false;  // the file of motion alone says so
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
