#pragma once
// From a pattern to its unsewn mesh: every panel triangulated, placed in the room, and linked to its neighbours along
// the seams.  (SPEC 3.1)
#include <vector>

#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/sample_outline.h"
#include "sim/mesh/triangulate.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// Which unsewn vertices the seams make one.

// Union-find whose representative is the lowest index of each group, so that results do not depend on the order of
// joins.
class DisjointSets {
 public:
    explicit DisjointSets(std::size_t count);
    int find(int element);
    void join(int a, int b);

 private:
    std::vector<int> parent_;
};

// Per vertex, the lowest vertex among those that chains of links connect it to (itself where there are none).
// Pre: links are in range.
std::vector<int> leads_of_linked(const GarmentMesh& mesh);

// From the unsewn mesh to the sewn one, in which linked vertices are one.  (SPEC 3.1, 3.2)

struct SewnMesh {
    GarmentMesh mesh;
    std::vector<int> sewn_vertex;  // per vertex of the unsewn mesh: its vertex in `mesh`
};

// Joins linked vertices, also where several seams meet in one point, at the mean of their positions. Triangles keep
// their order and their corners' material coordinates; vertices keep their order by first appearance.
SewnMesh merge_seams(const GarmentMesh& unsewn);

// The unsewn garment. Along a seam, sample i of one side is linked to sample i (or n - i) of the other, ends included.
// Post: merge_seams() of the result has no triangle with two equal vertices and no edge with three triangles, unless
// the pattern itself sews three edges together.
// Throws InputError for a self-crossing outline (naming the panel), for a seam to a missing edge or of an edge with
// itself, and for a panel that would need more than options.max_triangles.
GarmentMesh assemble(const Pattern& pattern, const MeshOptions& options = {});

// What panels were cut into the last time, and from what.
struct KeptPanelMesh {
    std::vector<Vec2d> vertices;
    std::vector<OutlineEdge> edges;
    std::vector<int> segments;
    MeshOptions options;
    PanelMesh mesh;
};

// The same garment, but panels whose outline and segments are in `kept` are not cut anew. Post: `kept` is of this one.
GarmentMesh assemble(const Pattern& pattern, const MeshOptions& options, std::vector<KeptPanelMesh>& kept);

// Sewing must not fold a mesh onto itself: an inner edge from one seam to another may find both its ends merged with
// the ends of a second edge, or with each other, and then triangles collapse or three of them share an edge. (SPEC 3.1)

// Splits such inner edges in the middle until sewing brings no two of them together; edges on outlines are never
// touched. Returns how many were split.
//
//     A ______ A'     A and A' are sewn together: the chord AA' would vanish
//      \  |  /
//       \ | /  ->  each split edge gets a vertex of its own, and its triangles two or more
//        \|/
int separate_coinciding_edges(GarmentMesh& unsewn);

// Lengths at and across a seam, where the material coordinates of the two sides disagree.  (SPEC 3.2; thesis fig. 4.6)

// One side's copy of an edge AB in its own material coordinates, m.
struct EdgeCopy {
    Vec2d a;
    Vec2d b;
};

struct SeamLengthOptions {
    double ease = 0.05;  // up to this relative difference of the sides both give way; beyond it the longer side gathers
};

// The rest length of a seam edge whose sides are left_length and right_length long, m: their average, or the shorter
// when the longer is to be gathered. Symmetric in its arguments.
double seam_rest_length(double left_length, double right_length, const SeamLengthOptions& options = {});

// The point `opposite` of the triangle that holds `from`, in the coordinates of the triangle that holds `into`, after
// rotating and moving `from` (no stretching) until it lies along `into` with the mid-points coinciding.
// Pre: neither copy has zero length; both triangles are counter-clockwise, a and b are the same vertices in both.
Vec2d unfold_across(const EdgeCopy& into, const EdgeCopy& from, const Vec2d& opposite);

}  // namespace selvedge::sim
