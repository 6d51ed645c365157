#pragma once
// The physical properties of a fabric, and the fabrics that ship with the program. Warp yarns run parallel to the
// panel's grainline, weft yarns perpendicular to it. The file format is in patterns/FORMAT.md.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/file.h"
#include "sim/pattern/surface_design.h"

namespace selvedge::sim {

struct Fabric {
    std::string name = "cotton_shirting";
    double area_density = 0.12;     // kg/m^2
    double stretch_warp = 8000;     // N/m
    double stretch_weft = 5000;     // N/m
    double shear = 56;              // N/m per rad
    double bending_warp = 9e-6;     // N m
    double bending_weft = 6e-6;     // N m
    double bending_hysteresis = 0;  // N, 2HB of the Kawabata (KES) bending test
    double shear_hysteresis = 0;    // N/m, 2HG of the Kawabata (KES) shear test
    double thickness = 0.00028;     // m
    double friction = 0.35;         // Coulomb coefficient, cloth on body
    double damping = 0.6;           // 1/s, of all motion
    double air_drag = 0.0;          // kg/(m^2 s), force per area and speed
    double strain_limit = 0.03;     // largest strain along warp and weft; beyond it the cloth is inextensible
    double gloss = 0.008;           // appearance: specular reflectance, 0..1
    double roughness = 0.35;        // width of the highlight, 0..1
    double sheen = 0.045;           // reflectance of surface fibres at grazing angles, 0..1
    std::optional<SurfaceDesign> surface = {};  // what it shows; none: what the pattern says

    bool operator==(const Fabric&) const = default;
};

// A shipped fabric (patterns/fabrics) by name, or the fabric in a file if the text ends in .json. Empty text: the
// default fabric. Throws InputError that lists the known names, or names the value that is missing or out of range.
Fabric find_fabric(std::string_view name_or_file);

// The fabric with others fused to it, all with the same grain: masses, thicknesses, stiffnesses and internal frictions
// add up, and the least extensible one limits the strain. The bending stiffness is a lower bound: fabrics that cannot
// slide on each other resist bending by more. Surface, appearance and damping are those of `shell`. Throws InputError
// if a sum is out of the range of fabric files; `place` is what the fabric is for, in the message.
Fabric bonded(Fabric shell, std::span<const Fabric> interlinings, const std::string& place = {});

// The names of the shipped fabrics, in alphabetical order.
std::vector<std::string> fabric_names();

// The files of the shipped fabrics, as embedded in the program.
std::span<const EmbeddedFile> embedded_fabrics();

// Parses the text of a fabric file; `file` is its name in error messages. Throws InputError.
Fabric parse_fabric(std::string_view text, const std::string& file);

}  // namespace selvedge::sim
