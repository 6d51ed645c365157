#include "sim/cloth/collision_criterion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/adaptive/criteria.h"
#include "sim/cloth/moving_contact.h"
#include "sim/cloth/standoff.h"
#include "sim/collide/collider.h"

namespace selvedge::sim {
namespace {

constexpr float kNotEvaluated = std::numeric_limits<float>::lowest();  // m: the depth of an edge that was not evaluated

void put_point(std::vector<ContactBlock>& blocks, std::size_t i, const Vec4f& p) {
    if (i / kContactLanes >= blocks.size()) blocks.emplace_back();
    blocks[i / kContactLanes].set_point(i % kContactLanes, p.head<3>());
}

}  // namespace

void CollisionCriterion::note(EdgeId e) const {
    if (batch.is_evaluated) batch.edges.clear();
    batch.is_evaluated = false;
    batch.edges.push_back(e);
}

std::span<const EdgeId> CollisionCriterion::noted() const {
    const bool is_new = !batch.is_evaluated;
    batch.is_evaluated = true;
    return is_new ? std::span<const EdgeId>(batch.edges) : std::span<const EdgeId>();
}

// Collects the noted edges and the finer edges that look-ahead needs, each once.
void CollisionCriterion::gather(const AdaptiveMesh& mesh) const {
    for (const EdgeId e : batch.evaluated) batch.depths[e.value] = kNotEvaluated;
    batch.evaluated.clear();
    batch.depths.resize(mesh.edges().capacity(), kNotEvaluated);
    const auto add = [&](EdgeId e) {
        if (batch.depths[e.value] != kNotEvaluated) return;
        batch.depths[e.value] = 0;
        batch.evaluated.push_back(e);
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
    put_points(mesh);
    // Points farther away than this reach neither depth threshold, so their exact distance is not needed.
    const float most = standoff == nullptr ? 0 : kMaxStandoff;
    body.contacts(batch.blocks, offset + most - std::min(split_depth, rejoin_depth));
    for (std::size_t i = 0; i < batch.evaluated.size(); ++i) batch.depths[batch.evaluated[i].value] = depth(mesh, i);
    return edges;
}

// The sample points of each edge: its middle, further points if it is long, and the centroids of the triangles beside
// it, at the edge's own level.
void CollisionCriterion::put_points(const AdaptiveMesh& mesh) const {
    batch.blocks.clear();
    batch.first.clear();
    batch.least.clear();
    std::size_t count = 0;
    const auto put = [&](std::span<const VertexId> corners, std::span<const float> shares, const Vec4f& p) {
        const auto known = moving ? distance_between(*moving, corners, shares, p.head<3>()) : std::nullopt;
        if (known) {
            batch.least.back() = std::min(batch.least.back(), *known);
        } else {
            put_point(batch.blocks, count++, p);
        }
    };
    for (const EdgeId id : batch.evaluated) {
        batch.first.push_back(count);
        batch.least.push_back(std::numeric_limits<float>::max());
        const AdaptiveEdge& edge = mesh.edge(id);
        const Vec4f &a = x[edge.ends[0].value], &b = x[edge.ends[1].value];
        const int parts = 2 * std::max(1, static_cast<int>(std::ceil(edge.rest_length / spacing / 2)));
        for (int k = 1; k < parts; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(parts);
            put(edge.ends, std::array{1 - t, t}, a + (b - a) * t);
        }
        for (const TriangleId side : edge.sides) {
            if (!side) continue;
            const std::array<VertexId, 3>& v = mesh.triangle(side).vertices;
            constexpr float kThird = 1.0F / 3.0F;
            put(v, std::array{kThird, kThird, kThird}, (x[v[0].value] + x[v[1].value] + x[v[2].value]) * kThird);
        }
    }
    batch.first.push_back(count);
    const Vec4f& any = x[mesh.end(batch.evaluated.back(), 0).value];
    for (std::size_t lane = count; lane < kContactLanes * batch.blocks.size(); ++lane) {
        put_point(batch.blocks, lane, any);
    }
}

bool CollisionCriterion::finer_edges_cut(const AdaptiveMesh& mesh, EdgeId e) const {
    return any_finer_edge(mesh, e, limits, [&](EdgeId finer) { return cuts(finer); });
}

// The maximum depth of the sample points of the i'th evaluated edge below the offset surface, m.
float CollisionCriterion::depth(const AdaptiveMesh& mesh, std::size_t i) const {
    float least = batch.least[i];
    for (std::size_t lane = batch.first[i]; lane < batch.first[i + 1]; ++lane) {
        least = std::min(least, batch.blocks[lane / kContactLanes].distance[lane % kContactLanes]);
    }
    return height(mesh, batch.evaluated[i]) - least;
}

// The distance from the body that the ends of an edge keep, m, on average.
float CollisionCriterion::height(const AdaptiveMesh& mesh, EdgeId e) const {
    if (standoff == nullptr) return offset;
    return offset + ((*standoff)[mesh.end(e, 0).value] + (*standoff)[mesh.end(e, 1).value]) / 2;
}

}  // namespace selvedge::sim
