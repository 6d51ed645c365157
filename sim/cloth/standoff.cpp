#include "sim/cloth/standoff.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/cloth/moving_contact.h"
#include "sim/cloth/solver_state.h"
#include "sim/collide/collider.h"
#include "sim/collide/moving_body.h"

namespace selvedge::sim {
namespace {

// What the middles of the elements at each vertex lack, m: the largest; negative where all have room.
class Lacks {
 public:
    Lacks(const Cloth& cloth, const Collider& body) : cloth_(cloth), body_(body) {
        by_vertex_.resize(cloth.x.size(), -kMaxStandoff);
    }

    std::vector<float> find() {
        for (const LeafEdge& leaf : cloth_.mesh.leaf_edges()) {
            const AdaptiveEdge& edge = cloth_.mesh.edge(leaf.edge);
            const Corners corners{edge.ends[0], edge.ends[1], edge.ends[1]};
            if (add(corners, {0.5F, 0.25F, 0.25F}) || !is_at_moving_body(edge.ends)) continue;
            add(corners, {0.75F, 0.125F, 0.125F});
            add(corners, {0.25F, 0.375F, 0.375F});
        }
        constexpr float kThird = 1.0F / 3.0F, kSixth = 1.0F / 6.0F;
        for (const LeafTriangle& leaf : cloth_.mesh.leaf_triangles()) {
            if (add(leaf.v, {kThird, kThird, kThird}) || !is_at_moving_body(leaf.v)) continue;
            add(leaf.v, {4 * kSixth, kSixth, kSixth});
            add(leaf.v, {kSixth, 4 * kSixth, kSixth});
            add(leaf.v, {kSixth, kSixth, 4 * kSixth});
        }
        query();
        return std::move(by_vertex_);
    }

 private:
    using Corners = std::array<VertexId, 3>;
    static constexpr float kReach = kChordClearance + kMaxStandoff;  // m: points that are farther away have room

    // Whether one of the vertices is near a body that moves. Where they are not all on one smooth side of it, the cloth
    // between them may be deepest beside its middle.
    bool is_at_moving_body(std::span<const VertexId> vertices) const {
        if (!body_.moving()) return false;
        const std::vector<LastContact>& last = cloth_.solver->contacts.moving.last;
        return std::ranges::any_of(vertices, [&](VertexId v) {
            return v.value < last.size() && last[v.value].triangle != LastContact::kNone;
        });
    }

    // Adds a point between the corners. If their planes leave more room than kMaxStandoff, that tells its distance;
    // else the body is asked, for there may be a bump between them. Returns whether they are on one smooth side of it.
    bool add(const Corners& corners, const std::array<float, 3>& shares) {
        Vec3f x = Vec3f::Zero();
        for (std::size_t k = 0; k < 3; ++k) x += shares[k] * cloth_.x[corners[k].value].head<3>();
        const std::optional<float> known =
            body_.moving() ? distance_between(cloth_.solver->contacts.moving, corners, shares, x) : std::nullopt;
        if (known && *known > kMaxStandoff) {
            note(corners, *known);
            return true;
        }
        points_.push_back(x);
        corners_.push_back(corners);
        return known.has_value();
    }

    void query() {
        if (points_.empty()) return;
        if (const MovingBodyCollider* const moving = body_.moving()) return query(*moving);
        std::vector<ContactBlock> blocks((points_.size() + kContactLanes - 1) / kContactLanes);
        for (std::size_t i = 0; i < blocks.size() * kContactLanes; ++i)
            blocks[i / kContactLanes].set_point(i % kContactLanes, points_[std::min(i, points_.size() - 1)]);
        body_.contacts(blocks, kReach);
        for (std::size_t i = 0; i < corners_.size(); ++i)
            note(corners_[i], blocks[i / kContactLanes].distance[i % kContactLanes]);
    }

    void query(const MovingBodyCollider& body) {
        std::vector<SearchPoint> searched;
        for (std::size_t i = 0; i < points_.size(); ++i) searched.push_back({points_[i], triangle_near(corners_[i])});
        const auto found = body.closest(searched, std::max(kReach, MovingBodyCollider::kDeepest));
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (found[i]) note(corners_[i], found[i]->distance);
    }

    // The triangle of the body that is nearest to the first of the corners that is near the body.
    std::uint32_t triangle_near(const Corners& corners) const {
        const std::vector<LastContact>& last = cloth_.solver->contacts.moving.last;
        for (const VertexId v : corners)
            if (v.value < last.size() && last[v.value].triangle != LastContact::kNone) return last[v.value].triangle;
        return LastContact::kNone;
    }

    void note(const Corners& corners, float distance) {
        for (const VertexId v : corners)
            by_vertex_[v.value] = std::max(by_vertex_[v.value], kChordClearance - distance);
    }

    const Cloth& cloth_;
    const Collider& body_;
    std::vector<float> by_vertex_;
    std::vector<Corners> corners_;
    std::vector<Vec3f> points_;  // in the middle of these, or beside it, m
};

// The height of a vertex above its offset surface, m, by the cached plane; nothing is known where it is far away.
float height_of(const Cloth& cloth, std::size_t v) {
    const ContactState& contacts = cloth.solver->contacts;
    if (contacts.query_point[v].w() < ContactCacheArrays::kInvalidBelow) return std::numeric_limits<float>::max();
    const Vec3f moved = (cloth.x[v] - contacts.query_point[v]).head<3>();
    if (moved.squaredNorm() > kPlaneReach * kPlaneReach) return std::numeric_limits<float>::max();
    return contacts.plane[v].w() + contacts.plane[v].head<3>().dot(moved);
}

void set_standoff(Cloth& cloth, std::size_t v, float standoff) {
    ContactState& contacts = cloth.solver->contacts;
    const float raise = standoff - contacts.standoff[v];
    contacts.standoff[v] = standoff;
    contacts.plane[v].w() -= raise;
    if (contacts.query_point[v].w() >= ContactCacheArrays::kInvalidBelow) contacts.query_point[v].w() -= raise;
    const float height = height_of(cloth, v);
    if (height >= 0 || cloth.inverse_mass[v] <= 0) return;
    const Vec4f out = with_zero_w(Vec3f(contacts.plane[v].head<3>() * std::min(-height, std::max(raise, 0.0F))));
    cloth.x[v] += out;
    cloth.x_prev[v] += out;
}

}  // namespace

void free_standoffs(Cloth& cloth, const StandoffOptions& options) {
    cloth.solver->contacts.standoff.assign(cloth.x.size() + 1, options.free);
    forget_contacts(cloth);
}

void update_standoffs(Cloth& cloth, const Collider& body, const StandoffOptions& options) {
    constexpr float kLowering = 0.5F;    // share of the room that is given back at once: neighbours give back theirs
    constexpr float kTouching = 0.001F;  // m, height above which a vertex does not touch
    const std::vector<float> lacks = Lacks(cloth, body).find();
    std::vector<float>& standoff = cloth.solver->contacts.standoff;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const float lack = lacks[v.value], now = standoff[v.value];
        const float height = lack <= -kMaxStandoff ? kMaxStandoff + kTouching : height_of(cloth, v.value);
        float next = now;
        if (lack > 0) {
            next = now + lack;
        } else if (height <= kTouching || height == std::numeric_limits<float>::max()) {
            next = std::max(0.0F, now - std::min(-kLowering * lack, options.lowering));
        } else if (now < options.free) {
            next = std::min(options.free, now + height - kTouching);  // into free room: pushes nothing
        } else {
            next = std::max(options.free, now - options.lowering);
        }
        next = std::min(next, kMaxStandoff);
        if (next != now) set_standoff(cloth, v.value, next);
    }
}

}  // namespace selvedge::sim
