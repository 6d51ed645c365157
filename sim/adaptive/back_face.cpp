#include "sim/adaptive/back_face.h"

#include <algorithm>
#include <cmath>

namespace selvedge::sim {
namespace {

constexpr int kRejoinShift = 16;
static_assert(kDeepestLevel < kRejoinShift);

}  // namespace

Visibility::Visibility(const ViewPoint& view, const BackFaceOptions& options)
    : view_(view),
      min_facing_split_(-std::sin(options.split_margin)),
      min_facing_rejoin_(-std::sin(options.rejoin_margin)) {
    SELVEDGE_ASSERT(options.split_margin < options.rejoin_margin);
}

void Visibility::start(const AdaptiveMesh& mesh) {
    vertex_seen_.resize(mesh.vertex_capacity());
    leaf_seen_.assign(mesh.triangles().capacity(), 0);
    seen_levels_.assign(mesh.vertex_capacity(), 0);
}

float Visibility::facing(const Vec3f& at, const Vec3f& normal) const {
    return normal.dot(view_.is_orthographic ? view_.eye : Vec3f((view_.eye - at).normalized()));
}

Visibility::Seen Visibility::seen_plane(const std::array<Vec3f, 3>& x) const {
    return seen(facing((x[0] + x[1] + x[2]) / 3.0F, (x[1] - x[0]).cross(x[2] - x[0]).normalized()));
}

void Visibility::pass_up(const AdaptiveMesh& mesh) {
    for (int level = mesh.max_level(); level >= 0; --level) {
        for (const TriangleId id : mesh.refined_triangles(level)) {
            const AdaptiveTriangle& t = mesh.triangle(id);
            for (std::size_t i = 0; i < layout(t.configuration).triangle_count; ++i)
                leaf_seen_[id.value] |= leaf_seen_[t.internal_triangles[i].value];
            mark_corners(t.vertices, leaf_seen_[id.value], 1U << level);
        }
    }
}

void Visibility::mark_leaf(const LeafTriangle& leaf, Seen how) {
    constexpr std::uint32_t kAllLevels = (1U << kRejoinShift) - 1;
    leaf_seen_[leaf.triangle.value] = how;
    mark_corners(leaf.v, how, kAllLevels & ~((1U << leaf.level) - 1));
}

void Visibility::mark_corners(const std::array<VertexId, 3>& corners, Seen how, std::uint32_t levels) {
    const std::uint32_t bits = ((how & 1) != 0 ? levels : 0U) | ((how & 2) != 0 ? levels << kRejoinShift : 0U);
    for (const VertexId v : corners) seen_levels_[v.value] |= bits;
}

bool Visibility::is_hidden(const AdaptiveMesh& mesh, EdgeId e) const {
    const AdaptiveEdge& edge = mesh.edge(e);
    const std::uint32_t bit = 1U << (edge.level + (mesh.is_split(e) ? kRejoinShift : 0));
    const auto is_seen = [&](VertexId v) { return (seen_levels_[v.value] & bit) != 0; };
    const auto touches_seen = [&](TriangleId side) {
        if (!side) return false;
        const std::array<VertexId, 3>& v = mesh.triangle(side).vertices;
        return std::any_of(v.begin(), v.end(), is_seen);
    };
    return !touches_seen(edge.sides[0]) && !touches_seen(edge.sides[1]);
}

}  // namespace selvedge::sim
