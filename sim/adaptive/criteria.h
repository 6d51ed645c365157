#pragma once
// Criteria that look at the surface alone. Each holds references to the state's arrays (not spans: an adaption may grow
// them), indexed by vertex id; splits must set them for the new centre.  (SPEC 1.3)
#include <cmath>
#include <vector>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/vec.h"

namespace selvedge {

struct CurvatureOptions {
    float split_angle = 0.35F;   // rad, a larger angle between the normals of an edge's ends asks for a split
    float rejoin_angle = 0.10F;  // rad, below split_angle

    bool operator==(const CurvatureOptions&) const = default;
};

// Split edges where the cloth bends, rejoin them where it lies flat: at both ends and at the centre, or a symmetric
// bump would be flattened away.  (thesis 3.4)
// Normal: a vector of three, or of four with a fourth 0; unit.
template <class Normal>
class CurvatureCriterion {
 public:
    explicit CurvatureCriterion(const std::vector<Normal>& normals, const CurvatureOptions& options = {})
        : normals_(normals),
          split_cosine_(std::cos(options.split_angle)),
          rejoin_cosine_(std::cos(options.rejoin_angle)) {
        SELVEDGE_ASSERT(options.rejoin_angle < options.split_angle);
    }

    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const {
        const AdaptiveEdge& edge = mesh.edge(e);
        return dot(edge.ends[0], edge.ends[1]) < split_cosine_;
    }
    bool wants_split(const AdaptiveMesh&, const LeafEdge& e) const { return dot(e.a, e.b) < split_cosine_; }

    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const {
        const AdaptiveEdge& edge = mesh.edge(e);
        return dot(edge.ends[0], edge.ends[1]) > rejoin_cosine_ && dot(edge.ends[0], edge.centre) > rejoin_cosine_ &&
               dot(edge.centre, edge.ends[1]) > rejoin_cosine_;
    }

 private:
    float dot(VertexId a, VertexId b) const { return normals_[a.value].dot(normals_[b.value]); }

    const std::vector<Normal>& normals_;
    float split_cosine_;
    float rejoin_cosine_;
};

struct LengthOptions {
    float split_compression = 0.05F;   // of the rest length; an edge compressed by more asks for a split
    float rejoin_compression = 0.02F;  // below split_compression
};

// Split edges that are compressed against their rest length: there the cloth must wrinkle.
// Position is any vector type whose first three coefficients are the position, m.
template <class Position>
class LengthCriterion {
 public:
    explicit LengthCriterion(const std::vector<Position>& x, const LengthOptions& options = {})
        : x_(x), split_share_(1.0F - options.split_compression), rejoin_share_(1.0F - options.rejoin_compression) {
        SELVEDGE_ASSERT(split_share_ < rejoin_share_);
    }

    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const { return is_shorter(mesh, e, split_share_); }
    bool wants_split(const AdaptiveMesh&, const LeafEdge& e) const {
        return is_shorter(e.a, e.b, split_share_ * e.rest_length);
    }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const { return !is_shorter(mesh, e, rejoin_share_); }

 private:
    bool is_shorter(const AdaptiveMesh& mesh, EdgeId e, float share) const {
        const AdaptiveEdge& edge = mesh.edge(e);
        return is_shorter(edge.ends[0], edge.ends[1], share * edge.rest_length);
    }
    // limit: m
    bool is_shorter(VertexId from, VertexId to, float limit) const {
        const Vec3f a = x_[from.value].template head<3>();
        const Vec3f b = x_[to.value].template head<3>();
        return (b - a).squaredNorm() < limit * limit;
    }

    const std::vector<Position>& x_;
    float split_share_;
    float rejoin_share_;
};

}  // namespace selvedge
