#pragma once
// From a pattern to its seamed mesh (thesis 4.2, figs. 4.1 and 4.3): assemble() triangulates the panels, places them in
// 3D and links them along the seams; merge_seams() merges linked vertices. Also prevents degenerate triangles at seams,
// and computes lengths at and across seams, where material coordinates are discontinuous (thesis 4.3).
#include <memory>
#include <span>
#include <vector>

#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// For each of that many vertices, the lowest vertex that it is connected to by a chain of links (itself if it has no
// links). Pre: links are in range.
std::vector<int> representatives_of_links(std::size_t vertices, std::span<const SeamLink> links);

// Sews the mesh in place: merges each group of linked vertices into one vertex at the mean of their positions, also
// where several seams meet. Triangles keep their order and their corners' material coordinates. Vertices keep the order
// of their first appearance. Returns, for each vertex of the unsewn mesh, its vertex in the sewn one.
std::vector<int> merge_seams(GarmentMesh& mesh);

// The unsewn garment mesh. Along a seam, sample i of one side is linked to sample i (or n - i) of the other, ends
// included. Post: once merge_seams() has sewn it, it has no triangle with two equal vertices and no edge with three
// triangles, unless the pattern itself sews three edges together. Panels that are not worn have no triangles. Throws
// InputError for an invalid outline (names the panel, see triangulate()), for a seam to a missing edge or of an edge to
// itself, for a panel that needs more than options.max_triangles, and if no panel is worn.
GarmentMesh assemble(const Pattern& pattern, const MeshOptions& options = {});

// The meshes of a garment's panels, with what each was made from: kept from one assemble() to the next.
struct PanelMeshCache {
    std::shared_ptr<const struct CachedPanelMeshes> meshes{};
};

// As above, but takes from the cache the meshes of panels with unchanged outline, segments and options. Post: the cache
// holds the panels of this garment.
GarmentMesh assemble(const Pattern& pattern, const MeshOptions& options, PanelMeshCache& cache);

// Prevents degenerate triangles after sewing. If sewing merges both ends of an interior edge with the ends of another
// edge, or with each other, triangles would collapse or three of them would share an edge. This function splits such
// interior edges at their midpoints until no two edges coincide after sewing. Outline edges are never split.
// Returns the number of splits.
//
//     A ______ A'     A and A' are sewn together: the edge AA' would vanish
//      \  |  /
//       \ | /  ->  each split edge gets a new vertex, and its triangles are divided into two or more
//        \|/
int separate_coinciding_edges(GarmentMesh& unsewn);

// The largest relative difference in length of two sides that are eased together; beyond it the longer side gathers.
inline constexpr double kSeamEase = 0.05;

struct SeamLengthOptions {
    double ease = kSeamEase;
};

// The rest length, m, of a seam edge from the lengths of its two sides: their average, or the shorter one if they
// differ by more than options.ease (gathers). Symmetric in its arguments.  (thesis 4.3.1, fig. 4.5: always the average)
double seam_rest_length(double left_length, double right_length, const SeamLengthOptions& options = {});

}  // namespace selvedge::sim
