#include "sim/cloth/collision_criterion.h"

#include <algorithm>
#include <limits>

#include "sim/adaptive/foresight.h"
#include "sim/body/collider.h"

namespace selvedge {
namespace {

// Of each edge its middle and those of the triangles beside it, at the edge's own level.
constexpr std::size_t kPoints = 3;

constexpr float kNotAsked = std::numeric_limits<float>::lowest();  // m: no depth, and cuts nothing

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

// The edges that were noted, and what they speak for, each once.
void CollisionCriterion::gather(const AdaptiveMesh& mesh) const {
    for (const EdgeId e : batch.asked) batch.depths[e.value] = kNotAsked;
    batch.asked.clear();
    batch.depths.resize(mesh.edges().capacity(), kNotAsked);
    const auto add = [&](EdgeId e) {
        if (batch.depths[e.value] != kNotAsked) return;
        batch.depths[e.value] = 0;
        batch.asked.push_back(e);
    };
    for (const EdgeId e : batch.edges) {
        add(e);
        any_finer_edge(mesh, e, limits, [&](EdgeId finer) {
            if (!mesh.is_split(finer)) add(finer);
            return false;
        });
    }
}

std::span<const EdgeId> CollisionCriterion::look(const AdaptiveMesh& mesh) const {
    const std::span<const EdgeId> edges = noted();
    if (edges.empty()) return edges;
    gather(mesh);
    const std::vector<EdgeId>& asked = batch.asked;
    batch.blocks.resize((kPoints * asked.size() + kContactLanes - 1) / kContactLanes);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const std::array<Vec4f, kPoints> points = middles(mesh, asked[i], x);
        for (std::size_t k = 0; k < kPoints; ++k) put_point(batch.blocks, kPoints * i + k, points[k]);
    }
    const Vec4f& any = x[mesh.end(edges.back(), 0).value];
    for (std::size_t lane = kPoints * asked.size(); lane < kContactLanes * batch.blocks.size(); ++lane) {
        put_point(batch.blocks, lane, any);
    }
    // What is farther away than this neither splits nor keeps anything, however far it is.
    body.contacts(batch.blocks, offset - std::min(split_depth, rejoin_depth));
    for (std::size_t i = 0; i < asked.size(); ++i) batch.depths[asked[i].value] = depth(mesh, i);
    return edges;
}

bool CollisionCriterion::finer_edges_cut(const AdaptiveMesh& mesh, EdgeId e) const {
    return any_finer_edge(mesh, e, limits, [&](EdgeId finer) { return cuts(finer); });
}

// How deep the deepest of the i'th asked edge's points lies below the offset surface, m.
float CollisionCriterion::depth(const AdaptiveMesh& mesh, std::size_t i) const {
    const AdaptiveEdge& edge = mesh.edge(batch.asked[i]);
    const auto depth_of = [&](std::size_t k) {
        const std::size_t lane = kPoints * i + k;
        return offset - batch.blocks[lane / kContactLanes].distance[lane % kContactLanes];
    };
    float deepest = depth_of(0);
    for (std::size_t side = 0; side < 2; ++side) {
        if (edge.sides[side]) deepest = std::max(deepest, depth_of(1 + side));
    }
    return deepest;
}

}  // namespace selvedge
