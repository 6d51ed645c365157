#pragma once
// Looking a dressed garment over: figures and faults, each named with its place.
#include "sim/cloth/cloth.h"
#include "sim/dress/drape.h"
#include "sim/dress/report.h"
#include "sim/dress/sewing.h"
#include "sim/mesh/plain_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

// What counts as a fault.
struct FaultLimits {
    double depth = 0.0005;      // m, of a vertex inside the body
    double stretch_p99 = 0.02;  // warp or weft, beyond the strain limit of the fabric
    double stretch_max = 0.12;  // the same
};

// Fills in mesh counts, contact, stretch, open seams and faults.
void inspect(const Cloth& cloth, const BodyCollider& body, const Pattern& pattern, const SewingResult& sewing,
             const DrapeResult& draped, DressReport& report, const FaultLimits& limits = {});

// The leaf triangles as they hang, with the material coordinates and level of each.
PlainMesh plain_mesh(const Cloth& cloth, const std::vector<std::string>& panel_names);

// "'front' beside 'left_sleeve' at x 0.123 y 1.340 z 0.051 m": where a person would look.
std::string describe_place(const Cloth& cloth, const Pattern& pattern, VertexId vertex);

}  // namespace selvedge
