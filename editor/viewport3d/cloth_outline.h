#pragma once
// Panels' outlines as they lie on the cloth: the mesh's boundary of each panel, seams included, found by material
// coordinates.
#include <cstdint>
#include <vector>

#include "sim/mesh/plain_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

struct ClothOutline {
    std::vector<std::uint32_t> vertices;  // of the mesh, counter-clockwise, round: the last is joined to the first
    std::vector<std::size_t> starts;      // of each edge of the panel: where in `vertices` it begins

    bool is_empty() const { return vertices.empty(); }
    bool operator==(const ClothOutline&) const = default;
};

// One per panel of the pattern; empty where the mesh does not have it. The mesh may be of a pattern that has changed
// since: edges then begin at the places nearest to where they should.
std::vector<ClothOutline> find_outlines(const sim::PlainMesh& mesh, const sim::Pattern& pattern);

// Pre: the outline is not empty, x is the mesh's.
std::vector<Vec3f> whole_path(const ClothOutline& outline, const std::vector<Vec3f>& x);  // ends where it begins
std::vector<Vec3f> edge_path(const ClothOutline& outline, std::size_t edge, const std::vector<Vec3f>& x);
const Vec3f& start_of(const ClothOutline& outline, std::size_t edge, const std::vector<Vec3f>& x);

}  // namespace selvedge::editor
