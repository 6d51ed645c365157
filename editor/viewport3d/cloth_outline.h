#pragma once
// Finds each panel's outline on the cloth: the boundary of the panel's part of the mesh, including its seams. Material
// coordinates tell where that boundary runs.
#include <cstdint>
#include <vector>

#include "sim/mesh/draw_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

struct ClothOutline {
    std::vector<std::uint32_t> vertices;  // mesh vertices, counter-clockwise; the last connects to the first
    std::vector<std::size_t> starts;      // per panel edge: the index in `vertices` of its first vertex

    bool is_empty() const { return vertices.empty(); }
    bool operator==(const ClothOutline&) const = default;
};

// Returns one outline per panel of the pattern; empty if the mesh does not contain the panel. The mesh may come from an
// older version of the pattern: each edge then starts at the outline vertex nearest to its expected start.
std::vector<ClothOutline> find_outlines(const sim::DrawMesh& mesh, const sim::Pattern& pattern);

// Pre: the outline is not empty; x holds the positions (m) of the mesh's vertices. whole_path() repeats its first point
// at the end.
std::vector<Vec3f> whole_path(const ClothOutline& outline, const std::vector<Vec3f>& x);  // closed
std::vector<Vec3f> edge_path(const ClothOutline& outline, std::size_t edge, const std::vector<Vec3f>& x);
const Vec3f& start_of(const ClothOutline& outline, std::size_t edge, const std::vector<Vec3f>& x);

}  // namespace selvedge::editor
