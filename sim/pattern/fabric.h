#pragma once
// What a cloth is made of, in physical units. Warp runs along the panel's grainline, weft across it.  (SPEC 2)
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/file.h"

namespace selvedge::sim {

struct Fabric {
    std::string name = "cotton_shirting";
    double area_density = 0.12;     // kg/m^2
    double stretch_warp = 8000;     // N/m
    double stretch_weft = 5000;     // N/m
    double shear = 56;              // N/m per rad
    double bending_warp = 9e-6;     // N m
    double bending_weft = 6e-6;     // N m
    double bending_hysteresis = 0;  // N, KES 2HB
    double shear_hysteresis = 0;    // N/m, KES 2HG
    double thickness = 0.00028;     // m
    double friction = 0.35;         // Coulomb, against a body
    double damping = 0.6;           // 1/s, of all motion
    double air_drag = 0.0;          // kg/(m^2 s), per area and speed
    double strain_limit = 0.03;     // beyond this warp or weft strain the cloth no longer gives
    double gloss = 0.008;           // how it takes light: share that is mirrored,
    double roughness = 0.35;        // spread of the highlight, 0..1,
    double sheen = 0.045;           // share that fibres on its surface catch at the rim
};

// The fabric of a shipped name (patterns/fabrics), or of a file when the text ends in .json; empty: the default.
// Throws InputError: it lists the known names, or says which figure is wrong.
Fabric find_fabric(std::string_view name_or_file);

// The fabrics that ship, in the order of the alphabet.
std::vector<std::string> fabric_names();

// Their files, as compiled into the program.
std::span<const EmbeddedFile> embedded_fabrics();

// A fabric from the text of a fabric file; `file` names it in errors. Throws InputError.
Fabric parse_fabric(std::string_view text, const std::string& file);

}  // namespace selvedge::sim
