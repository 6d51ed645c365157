#include "sim/cloth/collision_criterion.h"

#include <algorithm>

#include "sim/body/collider.h"

namespace selvedge {
namespace {

// Of each edge its middle and those of the triangles beside it, at the edge's own level.
constexpr std::size_t kPoints = 3;

std::array<Vec4f, kPoints> middles(const AdaptiveMesh& mesh, EdgeId id, const std::vector<Vec4f>& x) {
    const AdaptiveEdge& edge = mesh.edge(id);
    std::array<Vec4f, kPoints> points;
    points.fill((x[edge.ends[0].value] + x[edge.ends[1].value]) * 0.5F);
    for (std::size_t side = 0; side < 2; ++side) {
        if (!edge.sides[side]) continue;
        const std::array<VertexId, 3>& v = mesh.triangle(edge.sides[side]).vertices;
        points[1 + side] = (x[v[0].value] + x[v[1].value] + x[v[2].value]) * (1.0F / 3.0F);
    }
    return points;
}

void put_point(std::vector<ContactBlock>& blocks, std::size_t i, const Vec4f& p) {
    blocks[i / kContactLanes].set_point(i % kContactLanes, p.head<3>());
}

}  // namespace

void CollisionCriterion::note(EdgeId e) const {
    if (batch.is_looked_at) batch.edges.clear();
    batch.is_looked_at = false;
    batch.edges.push_back(e);
}

std::span<const EdgeId> CollisionCriterion::noted() const {
    const bool is_new = !batch.is_looked_at;
    batch.is_looked_at = true;
    return is_new ? std::span<const EdgeId>(batch.edges) : std::span<const EdgeId>();
}

std::span<const EdgeId> CollisionCriterion::look(const AdaptiveMesh& mesh) const {
    const std::span<const EdgeId> edges = noted();
    if (edges.empty()) return edges;
    batch.depths.resize(mesh.edges().capacity());
    batch.blocks.resize((kPoints * edges.size() + kContactLanes - 1) / kContactLanes);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const std::array<Vec4f, kPoints> points = middles(mesh, edges[i], x);
        for (std::size_t k = 0; k < kPoints; ++k) put_point(batch.blocks, kPoints * i + k, points[k]);
    }
    const Vec4f& any = x[mesh.end(edges.back(), 0).value];
    for (std::size_t lane = kPoints * edges.size(); lane < kContactLanes * batch.blocks.size(); ++lane) {
        put_point(batch.blocks, lane, any);
    }
    // What is farther away than this neither splits nor keeps anything, however far it is.
    const float reach = touch > 0 ? offset + touch : offset - std::min(split_depth, rejoin_depth);
    body.contacts(batch.blocks, reach);
    for (std::size_t i = 0; i < edges.size(); ++i) batch.depths[edges[i].value] = depth(mesh, i);
    return edges;
}

// How deep the deepest of the i'th edge's points lies below the offset surface, or, held off, below its ends or
// corners, m.
float CollisionCriterion::depth(const AdaptiveMesh& mesh, std::size_t i) const {
    const AdaptiveEdge& edge = mesh.edge(batch.edges[i]);
    const auto depth_of = [&](std::size_t k, std::span<const VertexId> corners) {
        const std::size_t lane = kPoints * i + k;
        const float below = offset - batch.blocks[lane / kContactLanes].distance[lane % kContactLanes];
        return touch > 0 && below > -touch ? below + std::max(0.0F, height(corners)) : below;
    };
    float deepest = depth_of(0, edge.ends);
    for (std::size_t side = 0; side < 2; ++side) {
        if (edge.sides[side]) deepest = std::max(deepest, depth_of(1 + side, mesh.triangle(edge.sides[side]).vertices));
    }
    return deepest;
}

// Mean, of the corners above the offset surface, m.
float CollisionCriterion::height(std::span<const VertexId> corners) const {
    float sum = 0;
    for (const VertexId v : corners) sum += body.contact(x[v.value].head<3>()).distance - offset;
    return sum / static_cast<float>(corners.size());
}

}  // namespace selvedge
