#pragma once
// The lines of panels along which edges of the adaptive mesh lie, at any level.
#include <array>
#include <cstdint>
#include <optional>

#include "sim/adaptive/adaptive_mesh.h"

namespace selvedge::sim {

// An outline edge.
struct PanelLine {
    std::uint16_t panel = 0;
    int edge = 0;  // index into Panel::edges

    bool operator==(const PanelLine&) const = default;
};

// The base edge that an edge is a part of; none inside of a base triangle.
EdgeId base_of(const AdaptiveMesh& mesh, EdgeId e);

// The lines on which an edge lies, by its sides: a seam may lie on one of each panel. Those of a split edge are its
// children's. None inside of panels, and in a mesh that was not made of a pattern.
std::array<std::optional<PanelLine>, 2> lines_of(const AdaptiveMesh& mesh, EdgeId e);

}  // namespace selvedge::sim
