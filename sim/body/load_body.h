#pragma once
// Bodies from files that others made: OBJ, glTF and GLB, read in a guarded child process (guarded_import.h), turned to
// metres and y up, and made one closed surface (surface_repair.h). Bones and skin weights stay where the file has them.
#include <filesystem>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/surface_repair.h"

namespace selvedge::sim {

enum class LengthUnit { Auto, Metres, Centimetres, Millimetres };  // Auto: by the height
enum class UpAxis { Auto, Y, Z };                                  // Auto: the longer one of y and z; glTF is y up

struct LoadBodyOptions {
    LengthUnit unit = LengthUnit::Auto;
    UpAxis up = UpAxis::Auto;
    bool stands_on_floor = true;  // moves the lowest point to y = 0; else it stays where the file has it
    RepairOptions repair = {};
};

struct LoadBodyReport {
    LengthUnit unit = LengthUnit::Metres;  // as taken
    UpAxis up = UpAxis::Y;                 // as taken
    double floor_shift = 0;                // m, by which it was lifted
    RepairReport repair;
    std::vector<std::string> notes;  // all that was changed, a sentence each; empty when nothing was
};

// Throws InputError when the file cannot be read, is no body, or is too broken to be closed.
// Post: the surface is closed, manifold within each piece, and turned outward.
Body load_body(const std::filesystem::path& path, const LoadBodyOptions& options = {},
               LoadBodyReport* report = nullptr);

}  // namespace selvedge::sim
