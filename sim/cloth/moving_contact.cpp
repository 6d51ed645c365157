#include "sim/cloth/moving_contact.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "sim/cloth/cloth.h"
#include "sim/cloth/contact.h"
#include "sim/cloth/kernels.h"
#include "sim/cloth/solver_state.h"
#include "sim/core/morton.h"

namespace selvedge::sim {
namespace {

constexpr float kCrease = 0.3F;          // cosine: normals of two sides of a crease enclose more than 73 degrees
constexpr float kFacing = -0.5F;         // cosine: two sides face each other from 120 degrees on
constexpr float kSampleRecovery = 0.1F;  // m/s, the same of points between them, with velocity: cloth hops by 0.5 mm

// What a vertex in a crease keeps from both sides, m: where these face each other and leave less room than that, both
// keep the same less.
struct CreaseOffsets {
    std::array<float, 2> kept{};
    bool is_pinched = false;
};

CreaseOffsets offsets_in(const CreaseContact& crease, const Vec3f& x, float share) {
    const auto& [own, other] = crease.sides;
    const std::array<PlaneNow, 2> now{plane_now(own.plane, x, share), plane_now(other.plane, x, share)};
    const auto wanted = [&](std::size_t k) {
        return crease.sides[k].offset.start + share * crease.sides[k].offset.change;
    };
    const float lack = wanted(0) + wanted(1) - now[0].height - now[1].height;
    if (now[0].normal.dot(now[1].normal) > kFacing || lack <= 0)
        return {.kept = {wanted(0), wanted(1)}, .is_pinched = wanted(0) < 0 || wanted(1) < 0};
    return {.kept = {wanted(0) - lack / 2, wanted(1) - lack / 2}, .is_pinched = true};
}

// Whether two sides fall away from each other: cloth slides over a ridge or a tip from one to the other. Not if they
// face opposite ways: then they may belong to two limbs that overlap.
template <class Side>
bool is_ridge(const Side& a, const Side& b) {
    if (a.normal.dot(b.normal) <= kFacing) return false;
    const Vec3f way = b.point - a.point;
    return a.normal.dot(way) <= 0 && b.normal.dot(way) >= 0;
}

// Sixteen contact points that look for the triangles nearest to them.
struct Searchers {
    PointGroup group{};
    std::array<float, kBlock> offset{};          // m
    std::array<float, kBlock> own_reach{};       // m, of vertices only
    std::array<std::uint32_t, kBlock> vertex{};  // of vertices only
    std::size_t count = 0;
    float reach = 0;  // m, of all

    void fill() {
        for (std::size_t i = count; i < kBlock; ++i) group.start(i, group.point(0), 0);
    }
};

class ContactFinder {
 public:
    // In a sub-step that ends at this share of the step; 0 at its start.
    ContactFinder(Cloth& cloth, const MovingBodyCollider& body, const ContactOptions& options, float substeps,
                  float share)
        : cloth_(cloth),
          contacts_(cloth.solver->contacts),
          moving_(cloth.solver->contacts.moving),
          body_(body),
          offset_(options.offset),
          substeps_(substeps),
          seconds_(cloth.substep * substeps),
          share_(share) {}

    void find() {
        moving_.vertices.clear();
        moving_.creases.clear();
        moving_.free.clear();
        moving_.pinched = 0;
        moving_.last.resize(cloth_.x.size());
        in_block_ = kBlock;
        for (Vec4f& query : contacts_.query_point) query.w() = kFarAway;  // the planes keep the vertices out
        if (moving_.order_made_at != cloth_.adaptations) make_order();
        for (const std::uint32_t v : moving_.order) {
            Searchers& searchers = moving_.last[v].triangle == LastContact::kNone ? far_ : near_;
            add(v, searchers);
            if (searchers.count == kBlock) search_vertices(searchers);
        }
        search_vertices(near_);
        search_vertices(far_);
        find_samples();
    }

    // For the free vertices that have left their balls.
    void find_again() {
        const auto has_left = [&](const FreeVertex& free) {
            const Vec3f x = position(free.vertex), move = x - cloth_.solver->before[free.vertex].head<3>();
            return (x - share_ * body_.surface().drift() - free.centre).norm() + move.norm() > free.radius;
        };
        const auto left = std::partition(moving_.free.begin(), moving_.free.end(), std::not_fn(has_left));
        const std::vector<FreeVertex> again(left, moving_.free.end());
        moving_.free.erase(left, moving_.free.end());
        for (const FreeVertex& free : again) {
            add(free.vertex, far_);
            if (far_.count == kBlock) search_vertices(far_);
        }
        search_vertices(far_);
    }

 private:
    // By the Morton code of their positions, so that sixteen that search together are near each other.
    void make_order() {
        moving_.order_made_at = cloth_.adaptations;
        std::vector<CodedPoint> keys;
        for (const VertexId v : cloth_.mesh.leaf_vertices()) {
            if (cloth_.inverse_mass[v.value] <= 0) continue;
            keys.push_back({morton_code(cloth_.x[v.value].head<3>()), v.value});
        }
        sort_by_code(keys);
        moving_.order.clear();
        for (const CodedPoint& key : keys) moving_.order.push_back(key.index);
    }

    Vec3f position(std::uint32_t v) const {
        return share_ > 0 ? cloth_.solver->points[v].head<3>() : cloth_.x[v].head<3>();
    }

    // That the vertex goes until the end of the step, m, if its velocity stays as it is.
    Vec3f way_of(std::uint32_t v) const {
        const Vec4f& before = share_ > 0 ? cloth_.solver->before[v] : cloth_.x_prev[v];
        return (position(v) - before.head<3>()) * substeps_ * (1 - share_);
    }

    // Searches from the middle of the vertex' way relative to the surface, outside of its last plane.
    void add(std::uint32_t v, Searchers& searchers) {
        const LastContact& last = moving_.last[v];
        const Vec3f &drift = body_.surface().drift(), x = position(v) - share_ * drift, way = way_of(v);
        Vec3f p = x + (way - (1 - share_) * last.motion) / 2;
        if (last.triangle != LastContact::kNone) p += last.normal * std::max(0.0F, -last.normal.dot(p - last.point));
        const float offset = offset_ + contacts_.standoff[v];
        const Vec3f end = x + way - (1 - share_) * drift;
        const float reach = offset + std::max((p - x).norm(), (p - end).norm()) + kUnforeseen;
        const float radius = reach + body_.longest_deformation();
        const std::size_t i = searchers.count++;
        searchers.group.start(i, p, radius);
        start_with(last.triangle, i, searchers.group);
        searchers.reach = std::max(searchers.reach, reach);
        searchers.own_reach[i] = reach;
        searchers.offset[i] = offset;
        searchers.vertex[i] = v;
    }

    void start_with(std::uint32_t triangle, std::size_t slot, PointGroup& group) const {
        if (triangle != LastContact::kNone)
            group.start_with(slot, body_.surface().distance_to(triangle, group.point(slot)));
    }

    void search_vertices(Searchers& searchers) {
        if (searchers.count == 0) return;
        searchers.fill();
        body_.surface().find_nearest(searchers.group, searchers.reach);
        for (std::size_t i = 0; i < searchers.count; ++i) set_vertex(searchers, i);
        searchers.count = 0;
        searchers.reach = 0;
    }

    void set_vertex(const Searchers& searchers, std::size_t i) {
        const std::uint32_t v = searchers.vertex[i], nearest = searchers.group.triangle[i];
        LastContact& last = moving_.last[v];
        const Vec3f p = searchers.group.point(i), x = position(v);
        if (nearest == NearestTriangle::kNone) {
            last = {};
            moving_.free.push_back({v, p, searchers.own_reach[i] - searchers.offset[i]});
            return;
        }
        const std::uint32_t triangle = on_own_side(last, nearest, p, searchers.own_reach[i]);
        const TangentPlane plane = body_.plane_at(triangle, p);
        const auto other = second_side(last, triangle, nearest, plane, p, searchers.offset[i]);
        last = {.triangle = triangle,
                .point = plane.point + plane.motion,
                .normal = (plane.normal + plane.turn).normalized(),
                .motion = plane.motion};
        const ContactOffset offset = offset_from(plane, x, searchers.offset[i]);
        if (other) {
            const TangentPlane second = body_.plane_at(*other, p);
            if (second.normal.dot(plane.normal) < kCrease && !is_ridge(plane, second)) {
                last.second = *other;
                moving_.creases.push_back({{.vertices = {v, v, v}, .friction = contacts_.friction[v]},
                                           {{{plane, offset}, {second, offset_from(second, x, searchers.offset[i])}}}});
                last.is_pinched = offsets_in(moving_.creases.back(), x, share_).is_pinched;
                return;
            }
        }
        if (in_block_ == kBlock) {
            moving_.vertices.push_back(dummies());
            in_block_ = 0;
        }
        MovingVertexBlock& block = moving_.vertices.back();
        block.vertices[in_block_] = 4 * v;
        block.friction[in_block_] = contacts_.friction[v];
        set_side(block.side, in_block_++, {plane, offset});
    }

    // What a point keeps from a plane: no more than its height now, and what it recovers in the step.
    ContactOffset offset_from(const TangentPlane& plane, const Vec3f& x, float offset,
                              float recovery = kRecovery) const {
        const float lack = std::max(0.0F, offset - plane_now(plane, x, share_).height);
        const float change = std::min(lack, recovery * seconds_);
        return {.start = offset - lack - share_ * change, .change = change};
    }

    // The nearest triangle, or one on the side of a crease that the vertex was on. A pinched vertex follows its sides
    // over the surface: what is nearest to it may be the far side of a hand.
    std::uint32_t on_own_side(const LastContact& last, std::uint32_t nearest, const Vec3f& p, float reach) const {
        if (last.triangle == LastContact::kNone) return nearest;
        if (last.is_pinched) return body_.surface().walk_nearest(last.triangle, p, last.normal, {.least = kCrease});
        const SurfaceBvh& surface = body_.surface();
        if (surface.face_normal(nearest).dot(last.normal) > kCrease) return nearest;
        const float radius =
            std::max(reach + body_.longest_deformation(), std::sqrt(surface.distance_to(last.triangle, p).squared));
        const auto own = surface.nearest_facing(p, last.normal, {.least = kCrease}, radius);
        return own && !is_ridge(surface.closest_on(*own, p), surface.closest_on(nearest, p)) ? *own : nearest;
    }

    // The other side of a crease, which is sought where the vertex touches.
    std::optional<std::uint32_t> second_side(const LastContact& last, std::uint32_t own, std::uint32_t nearest,
                                             const TangentPlane& plane, const Vec3f& p, float offset) const {
        if (last.is_pinched) return body_.surface().walk_nearest(last.second, p, plane.normal, {.most = kCrease});
        if (own != nearest) return nearest;
        if (plane.normal.dot(p - plane.point) > offset + kUnforeseen) return std::nullopt;
        return body_.surface().nearest_facing(p, plane.normal, {.most = kCrease}, 2 * offset + kUnforeseen);
    }

    MovingVertexBlock dummies() const {
        MovingVertexBlock block;
        block.vertices.fill(static_cast<std::uint32_t>(4 * cloth_.x.size()));
        for (std::size_t at = 0; at < kBlock; ++at) clear_side(block.side, at);
        return block;
    }

    // By the Morton code of their positions too: the samples of most blocks have no vertex in common, and so are far
    // apart.
    void find_samples() {
        moving_.samples.resize(contacts_.samples.size());
        moving_.is_sample_near.assign(contacts_.samples.size(), 0);
        std::vector<CodedPoint> order;
        for (std::size_t index = 0; index < contacts_.samples.size(); ++index) {
            for (std::size_t at = 0; at < kBlock; ++at) {
                clear_side(moving_.samples[index], at);
                if (contacts_.samples[index].shares[0][at] <= 0) continue;
                order.push_back({morton_code(sample_place(index, at).first), std::uint32_t(index * kBlock + at)});
            }
        }
        sort_by_code(order);
        for (std::size_t first = 0; first < order.size(); first += kBlock)
            find_samples(std::span(order).subspan(first, std::min(kBlock, order.size() - first)));
    }

    // Where the sample is, and the way that it goes until the end of the step, m.
    std::pair<Vec3f, Vec3f> sample_place(std::size_t index, std::size_t at) const {
        const SampleBlock& block = contacts_.samples[index];
        Vec3f p = Vec3f::Zero(), way = Vec3f::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            if (block.shares[k][at] <= 0) continue;
            const std::uint32_t v = block.vertices[k][at] / 4;
            p += block.shares[k][at] * cloth_.x[v].head<3>();
            way += block.shares[k][at] * way_of(v);
        }
        return {p, way};
    }

    void find_samples(std::span<const CodedPoint> near) {
        Searchers searchers{.count = near.size()};
        for (std::size_t i = 0; i < near.size(); ++i) {
            const std::size_t index = near[i].index / kBlock, at = near[i].index % kBlock;
            const auto [p, way] = sample_place(index, at);
            const float reach = offset_ + (way - body_.surface().drift()).norm() + kUnforeseen;
            // A triangle beyond the reach need not be the nearest: nearer ones may be left out.
            searchers.group.start(i, p, reach);
            start_with(moving_.last[contacts_.samples[index].vertices[0][at] / 4].triangle, i, searchers.group);
            if (searchers.group.triangle[i] == NearestTriangle::kNone)
                searchers.group.start(i, p, reach + body_.longest_deformation());
            searchers.reach = std::max(searchers.reach, reach);
        }
        searchers.fill();
        body_.surface().find_nearest(searchers.group, searchers.reach);
        for (std::size_t i = 0; i < near.size(); ++i) {
            const std::uint32_t triangle = searchers.group.triangle[i];
            if (triangle == NearestTriangle::kNone) continue;
            const std::size_t index = near[i].index / kBlock, at = near[i].index % kBlock;
            const Vec3f p = searchers.group.point(i);
            const TangentPlane plane = body_.plane_at(triangle, p);
            if (is_on_other_side(contacts_.samples[index], at, plane.normal)) continue;
            set_side(moving_.samples[index], at, {plane, offset_from(plane, p, offset_, kSampleRecovery)});
            moving_.is_sample_near[index] = 1;
        }
    }

    // Whether a corner of the sample is pinched, or on a side of the body that the normal does not belong to.
    bool is_on_other_side(const SampleBlock& block, std::size_t at, const Vec3f& normal) const {
        for (std::size_t k = 0; k < 3; ++k) {
            if (block.shares[k][at] <= 0) continue;
            const LastContact& last = moving_.last[block.vertices[k][at] / 4];
            if (last.is_pinched) return true;
            if (last.triangle != LastContact::kNone && last.normal.dot(normal) < kCrease) return true;
        }
        return false;
    }

    Cloth& cloth_;
    ContactState& contacts_;
    MovingContacts& moving_;
    const MovingBodyCollider& body_;
    float offset_, substeps_;
    float seconds_;                  // of the step
    float share_;                    // of the step that has passed
    Searchers near_{}, far_{};       // apart: a known triangle limits the search
    std::size_t in_block_ = kBlock;  // slots used in the last block of vertices
};

// A pinched vertex is held in the middle, without friction.
void hold_in_crease(const CreaseContact& crease, const StepShare& share, float friction_scale, SolverState& solver) {
    const std::uint32_t v = crease.carrier.vertices[0];
    const CreaseOffsets offsets = offsets_in(crease, solver.points[v].head<3>(), share.end);
    std::array<BodySide, 2> sides = crease.sides;
    if (offsets.is_pinched)
        for (std::size_t k = 0; k < 2; ++k) sides[k].offset = {.start = offsets.kept[k]};
    solver.contacts.moving.last[v].is_pinched = offsets.is_pinched;
    solver.contacts.moving.pinched += offsets.is_pinched ? 1 : 0;
    constexpr int kIterations = 2;  // over both sides: what the second side pushes back into the first comes out again
    for (int i = 0; i < kIterations; ++i) {
        for (const BodySide& side : sides) {
            const Vec3f x = solver.points[v].head<3>();
            push_out(crease.carrier, met(side, x, share), offsets.is_pinched ? 0 : friction_scale, solver.points,
                     solver.before);
        }
    }
}

}  // namespace

void find_moving_contacts(Cloth& cloth, const MovingBodyCollider& body, const ContactOptions& options, int substeps) {
    ContactFinder(cloth, body, options, static_cast<float>(substeps), 0).find();
}

bool is_pinched(const MovingContacts& contacts, VertexId vertex) {
    return vertex.value < contacts.last.size() && contacts.last[vertex.value].is_pinched;
}

std::vector<std::uint8_t> pinched_vertices(const MovingContacts& contacts) {
    std::vector<std::uint8_t> pinched;
    for (const CreaseContact& crease : contacts.creases) {
        if (!contacts.last[crease.carrier.vertices[0]].is_pinched) continue;
        pinched.resize(contacts.last.size(), 0);
        pinched[crease.carrier.vertices[0]] = 1;
    }
    return pinched;
}

std::optional<float> distance_between(const MovingContacts& contacts, std::span<const VertexId> vertices,
                                      std::span<const float> shares, const Vec3f& x) {
    constexpr float kSmooth = 0.9F;  // cosine: where normals turn by more than 26 degrees, the curvature may change
    if (std::ranges::any_of(vertices, [&](VertexId v) { return is_pinched(contacts, v); })) return kFarAway;
    Vec3f normal = Vec3f::Zero();
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        if (vertices[k].value >= contacts.last.size()) return std::nullopt;
        const LastContact& last = contacts.last[vertices[k].value];
        if (last.triangle == LastContact::kNone) return std::nullopt;
        normal += shares[k] * last.normal;
    }
    normal.normalize();
    float distance = 0;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const LastContact& last = contacts.last[vertices[k].value];
        if (last.normal.dot(normal) < kSmooth) return std::nullopt;
        distance += shares[k] * (last.normal + normal).dot(x - last.point) / 2;
    }
    return distance;
}

void note_split(MovingContacts& contacts, VertexId c, VertexId a, VertexId b) {
    const std::size_t count = std::max({a.value, b.value, c.value}) + std::size_t(1);
    if (contacts.last.size() < count) contacts.last.resize(count);
    LastContact &first = contacts.last[a.value], &second = contacts.last[b.value], &made = contacts.last[c.value];
    made = {};
    if (first.is_pinched || second.is_pinched) {
        made = first.is_pinched ? first : second;
        return;
    }
    const bool are_near = first.triangle != LastContact::kNone && second.triangle != LastContact::kNone;
    if (!are_near || first.normal.dot(second.normal) < kCrease) return;
    made = first;
    made.point = (first.point + second.point) / 2;
    made.normal = (first.normal + second.normal).normalized();
    made.motion = (first.motion + second.motion) / 2;
}

void push_out_samples_on_planes(Cloth& cloth, const Kernels& loops, const StepShare& share,
                                const ContactOptions& options) {
    ContactState& contacts = cloth.solver->contacts;
    const MovingContacts& moving = contacts.moving;
    for (std::size_t i = 0; i < contacts.samples.size(); ++i) {
        if (moving.is_sample_near[i] == 0) continue;
        loops.push_samples_on_planes(contacts.samples[i], moving.samples[i], share, options.friction_scale,
                                     floats(cloth.solver->points), floats(cloth.solver->before));
    }
}

void hold_vertices_on_planes(Cloth& cloth, const MovingBodyCollider& body, const Kernels& loops, const StepShare& share,
                             float longest_move, const ContactOptions& options) {
    SolverState& solver = *cloth.solver;
    ContactState& contacts = solver.contacts;
    const ContactLimits limits{.longest_move = longest_move,
                               .floor = options.floor + options.offset,
                               .offset = options.offset,
                               .friction_scale = options.friction_scale};
    contacts.scratch.to_query.resize(cloth.x.size() + kBlock);
    loops.project_vertices(floats(solver.points), floats(solver.before),
                           {floats(contacts.query_point), floats(contacts.plane)}, contacts.friction.data(),
                           cloth.x.size(), limits, contacts.scratch.to_query.data());
    ContactFinder(cloth, body, options, 1 / share.length, share.end).find_again();
    loops.hold_on_planes(contacts.moving.vertices, share, options.friction_scale, floats(solver.before),
                         floats(solver.points));
    contacts.moving.pinched = 0;
    for (const CreaseContact& crease : contacts.moving.creases)
        hold_in_crease(crease, share, options.friction_scale, solver);
}

void end_moving_contacts(Cloth& cloth, const ContactOptions& options) {
    ContactState& contacts = cloth.solver->contacts;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const LastContact& last = contacts.moving.last[v.value];
        const Vec4f& x = cloth.solver->points[v.value];
        contacts.query_point[v.value] = {x.x(), x.y(), x.z(), ContactCacheArrays::kUnknown};
        if (last.triangle == LastContact::kNone) {
            contacts.plane[v.value] = {0, 1, 0, kFarAway};
            continue;
        }
        const float above = last.normal.dot(x.head<3>() - last.point);
        const float height = above - options.offset - contacts.standoff[v.value];
        contacts.plane[v.value] = {last.normal.x(), last.normal.y(), last.normal.z(), height};
        contacts.query_point[v.value].w() = 0;
    }
}

}  // namespace selvedge::sim
