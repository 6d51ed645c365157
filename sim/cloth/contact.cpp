#include "sim/cloth/contact.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "sim/cloth/cloth.h"
#include "sim/cloth/kernels.h"
#include "sim/cloth/solver_blocks.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/standoff.h"
#include "sim/collide/collider.h"
#include "sim/core/blocks.h"

namespace selvedge::sim {
namespace {

// The assumed error of a collider's distance, m: at least kMinMargin, chosen by experiment, and at least what the
// collider reports.
float slack_margin(const Collider& body) {
    constexpr float kMinMargin = 0.0007F;  // m
    return std::max(kMinMargin, body.max_error());
}

ContactLimits limits_for(const Collider& body, const ContactOptions& options) {
    return {.floor = options.floor + options.offset,
            .offset = options.offset,
            .margin = slack_margin(body),
            .friction_scale = options.friction_scale};
}

Vec4f nothing_known() {
    return {0, 0, 0, ContactCacheArrays::kUnknown};
}

// A vertex shared by several fabrics gets the largest of their friction coefficients.
void add_friction(const Cloth& cloth, ContactState& contacts, TriangleId t) {
    const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
    const float mu = static_cast<float>(cloth.material.fabrics[triangle.panel].friction);
    for (const VertexId v : triangle.vertices) contacts.friction[v.value] = std::max(contacts.friction[v.value], mu);
}

float longest_edge(const std::array<Vec2f, 3>& u) {
    return std::sqrt(std::max({(u[1] - u[0]).squaredNorm(), (u[2] - u[1]).squaredNorm(), (u[0] - u[2]).squaredNorm()}));
}

// Triangles with longer edges are sampled by area, no more closely than a mesh of triangles too small to be sampled is
// by its edges. In a coarse mesh of a finely drawn outline, most are slivers, whose lattices would have hundreds of
// points each.
constexpr float kLongestOnLattice = 0.2F;  // m

// Calls take(shares of the corners) for the inner points of a lattice with that many parts per side.
template <class Take>
void for_each_on_lattice(int parts, const Take& take) {
    for (int i = 1; i < parts - 1; ++i) {
        for (int j = 1; j < parts - i; ++j) {
            const float part = 1.0F / static_cast<float>(parts);
            take(std::array<float, 3>{part * static_cast<float>(i), part * static_cast<float>(j),
                                      part * static_cast<float>(parts - i - j)});
        }
    }
}

// The same for points in rows along the longest edge: height / spacing rows, at least one, each in the middle of its
// strip, with its points spread evenly over it. So a sample stands for an area of spacing x spacing.
template <class Take>
void for_each_in_rows(const std::array<Vec2f, 3>& u, float spacing, const Take& take) {
    std::size_t first = 0;  // corner at which the longest edge begins
    for (std::size_t k = 1; k < 3; ++k) {
        if ((u[(k + 1) % 3] - u[k]).squaredNorm() > (u[(first + 1) % 3] - u[first]).squaredNorm()) first = k;
    }
    const std::size_t second = (first + 1) % 3, third = (first + 2) % 3;
    const Vec2f base = u[second] - u[first], side = u[third] - u[first];
    const float length = base.norm();
    const float height = std::abs(base.x() * side.y() - base.y() * side.x()) / length;
    const auto count = [&](float extent) { return std::max(1, static_cast<int>(std::lround(extent / spacing))); };
    const int rows = count(height);
    for (int row = 0; row < rows; ++row) {
        const float up = (static_cast<float>(row) + 0.5F) / static_cast<float>(rows);
        const int points = count((1 - up) * length);
        for (int i = 0; i < points; ++i) {
            const float along = (1 - up) * (static_cast<float>(i) + 0.5F) / static_cast<float>(points);
            std::array<float, 3> shares{};
            shares[first] = 1 - up - along;
            shares[second] = along;
            shares[third] = up;
            take(shares);
        }
    }
}

// Adds and removes the samples of edges and triangles.
class SampleLists {
 public:
    explicit SampleLists(Cloth& cloth) : cloth_(cloth), contacts_(cloth.solver->contacts) {}

    void make_all() {
        contacts_.vertices = cloth_.mesh.vertex_capacity();
        contacts_.coloring.start(contacts_.vertices + 1, BlockColoring::Colorless::InTurn);
        contacts_.coloring.assign();
        contacts_.samples.clear();
        contacts_.next.clear();
        contacts_.of_triangle.assign(cloth_.mesh.triangles().capacity(), kNoBlockSlot);
        contacts_.of_edge.assign(cloth_.mesh.edges().capacity(), kNoBlockSlot);
        for (const LeafEdge& edge : cloth_.mesh.leaf_edges()) add(edge.edge);
        for (const LeafTriangle& triangle : cloth_.mesh.leaf_triangles()) add(triangle.triangle);
        contacts_.inserted = 0;
    }

    void change() {
        const LeafChanges& changes = cloth_.mesh.changes();
        contacts_.of_triangle.resize(cloth_.mesh.triangles().capacity(), kNoBlockSlot);
        contacts_.of_edge.resize(cloth_.mesh.edges().capacity(), kNoBlockSlot);
        for (const EdgeId e : changes.edges_removed) remove(e);
        for (const TriangleId t : changes.triangles_removed) remove(t);
        for (const EdgeId e : changes.edges_added) add(e);
        for (const TriangleId t : changes.triangles_added) add(t);
    }

 private:
    // Such edges need no samples. One case is not covered: a triangle with a side that is too short to be split is
    // never divided evenly, so the edges inside of it stay as long as they are, also those that the limits allow to be
    // split.
    bool is_split_on_contact(EdgeId e) const { return contacts_.split && contacts_.split->allow(cloth_.mesh, e); }

    // Samples an edge evenly, so that the distance between samples is at most the spacing.
    void add(EdgeId e) {
        if (is_split_on_contact(e)) return;
        const AdaptiveEdge& edge = cloth_.mesh.edge(e);
        const int count = static_cast<int>(std::ceil(edge.rest_length / contacts_.spacing)) - 1;
        std::uint32_t next = kNoBlockSlot;
        for (int i = 1; i <= count; ++i) {
            const float t = static_cast<float>(i) / static_cast<float>(count + 1);
            const std::uint32_t slot = put_edge({edge.ends[0].value, edge.ends[1].value}, t);
            contacts_.next[slot] = next;
            next = slot;
        }
        contacts_.of_edge[e.value] = next;
    }

    // Samples a triangle within: at its centroid, at the inner points of a finer lattice, or in rows if it is large.
    void add(TriangleId t) {
        const AdaptiveTriangle& triangle = cloth_.mesh.triangle(t);
        const float longest = longest_edge(triangle.u);
        if (longest < contacts_.sampled_edge) return;
        if (std::ranges::any_of(triangle.edges, [&](EdgeId e) { return is_split_on_contact(e); })) return;
        const std::array<std::uint32_t, 3> v{triangle.vertices[0].value, triangle.vertices[1].value,
                                             triangle.vertices[2].value};
        const float friction = static_cast<float>(cloth_.material.fabrics[triangle.panel].friction);
        std::uint32_t next = kNoBlockSlot;
        const auto sample = [&](const std::array<float, 3>& shares) {
            const std::uint32_t slot = put(contacts_.coloring.insert(v), v, shares, friction);
            contacts_.next[slot] = next;
            next = slot;
        };
        if (longest > kLongestOnLattice) {
            for_each_in_rows(triangle.u, std::max(contacts_.spacing, contacts_.sampled_edge / 2), sample);
        } else {
            for_each_on_lattice(std::max(3, static_cast<int>(std::ceil(longest / contacts_.spacing))), sample);
        }
        contacts_.of_triangle[t.value] = next;
    }

    void remove(EdgeId e) {
        for (std::uint32_t slot = contacts_.of_edge[e.value]; slot != kNoBlockSlot; slot = contacts_.next[slot]) {
            const SampleBlock& block = contacts_.samples[slot / kBlock];
            const std::size_t at = slot % kBlock;
            contacts_.coloring.remove<2>(slot, {block.vertices[0][at] / 4, block.vertices[1][at] / 4});
            clear(slot);
        }
        contacts_.of_edge[e.value] = kNoBlockSlot;
    }

    void remove(TriangleId t) {
        for (std::uint32_t slot = contacts_.of_triangle[t.value]; slot != kNoBlockSlot; slot = contacts_.next[slot]) {
            contacts_.coloring.remove(slot, corners_at(contacts_.samples[slot / kBlock], slot % kBlock));
            clear(slot);
        }
        contacts_.of_triangle[t.value] = kNoBlockSlot;
    }

    std::uint32_t put_edge(const std::array<std::uint32_t, 2>& v, float t) {
        const auto dummy = static_cast<std::uint32_t>(contacts_.vertices);
        return put(contacts_.coloring.insert(v), {v[0], v[1], dummy}, {1 - t, t, 0},
                   std::max(contacts_.friction[v[0]], contacts_.friction[v[1]]));
    }

    std::uint32_t put(std::uint32_t slot, const std::array<std::uint32_t, 3>& v, const std::array<float, 3>& shares,
                      float friction) {
        if (contacts_.coloring.block_count() > contacts_.samples.size()) {
            append_block(contacts_.samples, dummy_samples(contacts_.coloring.is_in_turn(contacts_.samples.size())));
            contacts_.next.resize(contacts_.samples.size() * kBlock, kNoBlockSlot);
        }
        SampleBlock& block = contacts_.samples[slot / kBlock];
        const std::size_t at = slot % kBlock;
        for (std::size_t k = 0; k < 3; ++k) {
            block.vertices[k][at] = 4 * v[k];
            block.shares[k][at] = shares[k];
        }
        block.friction[at] = friction;
        block.slack[at] = ContactCacheArrays::kUnknown;
        ++contacts_.inserted;
        return slot;
    }

    void clear(std::uint32_t slot) {
        const SampleBlock free = dummy_samples(contacts_.coloring.is_in_turn(slot / kBlock));
        copy_slot(free, contacts_.samples[slot / kBlock], slot % kBlock);
    }

    SampleBlock dummy_samples(bool is_in_turn) const {
        SampleBlock block = dummy_block<SampleBlock>(contacts_.vertices);
        block.slack.fill(kFarAway);
        block.in_turn.fill(is_in_turn ? 1 : 0);
        return block;
    }

    Cloth& cloth_;
    ContactState& contacts_;
};

void size_contacts(Cloth& cloth, ContactState& contacts) {
    contacts.query_point.resize(cloth.x.size() + 1, nothing_known());
    contacts.plane.resize(cloth.x.size() + 1, Vec4f::Zero());
    contacts.friction.resize(cloth.x.size() + 1, 0.0F);
}

// The slots of samples between vertices of which one at least meets the trunk only.
std::uint16_t trunk_only_slots(const SampleBlock& samples, const std::vector<bool>& is_trunk_only) {
    unsigned slots = 0;
    for (std::size_t at = 0; at < kBlock; ++at) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (samples.shares[k][at] > 0 && is_trunk_only[samples.vertices[k][at] / 4]) slots |= 1U << at;
        }
    }
    return static_cast<std::uint16_t>(slots);
}

constexpr unsigned kAllSlots = (1U << kBlock) - 1;

// Queries these slots, and the others where that costs nothing.
void query(SolverState& solver, const SampleBlock& samples, ContactBlock& block, const Collider& body, float reach,
           unsigned slots) {
    unsigned trunk_only = kAllSlots & ~slots;
    if (!solver.contacts.is_trunk_only.empty()) trunk_only |= trunk_only_slots(samples, solver.contacts.is_trunk_only);
    const auto apart = static_cast<std::uint16_t>(trunk_only);
    body.contacts_apart({&block, 1}, {&apart, 1}, reach);
}

// The same for vertices; to_query: their offsets in the arrays of points.
void query(SolverState& solver, const Collider& body, float reach) {
    ContactState& contacts = solver.contacts;
    auto& [to_query, blocks, trunk_only] = contacts.scratch;
    if (contacts.is_trunk_only.empty()) return body.contacts(blocks, reach);
    trunk_only.assign(blocks.size(), 0);
    for (std::size_t i = 0; i < blocks.size() * kBlock; ++i) {
        const unsigned slot = contacts.is_trunk_only[to_query[i] / 4] ? 1U << i % kBlock : 0;
        trunk_only[i / kBlock] = static_cast<std::uint16_t>(trunk_only[i / kBlock] | slot);
    }
    body.contacts_apart(blocks, trunk_only, reach);
}

// The same as Kernels::store_query, for one slot.
void store_query_at(const ContactBlock& result, std::size_t at, const ContactLimits& limits, SampleBlock& samples) {
    const float height = result.distance[at] - limits.offset;
    const bool is_new = samples.slack[at] < ContactCacheArrays::kInvalidBelow;
    samples.sunk[at] = is_new ? std::max(-height, 0.0F) : 0.0F;
    set_values(samples.side.point, at, result.point(at));
    samples.slack[at] = height - limits.margin;
    set_values(samples.side.normal, at, {result.nx[at], result.ny[at], result.nz[at]});
    samples.side.height[at] = height;
}

// The same for these slots.
void store_queries(const ContactBlock& result, unsigned slots, const Kernels& loops, const ContactLimits& limits,
                   SampleBlock& samples) {
    if (slots == kAllSlots) return loops.store_query(result, limits, samples);
    for (unsigned left = slots; left != 0; left &= left - 1)
        store_query_at(result, static_cast<std::size_t>(std::countr_zero(left)), limits, samples);
}

// The block with this slot alone near anything: a collider is done with the others at once.
ContactBlock alone(const ContactBlock& block, std::size_t at) {
    ContactBlock one;
    for (std::size_t i = 0; i < kContactLanes; ++i)
        one.set_point(i, i == at ? block.point(at) : Vec3f(Vec3f::Constant(kFarAway)));
    return one;
}

// For a block in turn. All samples query the collider at once; each that the previous ones have moved since queries
// again, alone.
void meet_in_turn(SolverState& solver, SampleBlock& samples, const Kernels& loops, const Collider& body,
                  const ContactLimits& limits) {
    ContactBlock now, found;
    bool has_found = false;
    for (std::size_t at = 0; at < kBlock;) {
        at = loops.push_samples_in_turn(samples, at, limits, floats(solver.points), floats(solver.before));
        if (at == kBlock) return;
        loops.locate_samples(samples, floats(solver.points), now);
        if (!has_found || now.point(at) != found.point(at)) {
            ContactBlock block = has_found ? alone(now, at) : now;
            const unsigned slots = has_found ? 1U << at : kAllSlots;
            query(solver, samples, block, body, limits.offset + kPlaneReach, slots);
            if (!has_found) found = block;
            found.set_point(at, block.point(at));
            found.set(at, {block.distance[at], {block.nx[at], block.ny[at], block.nz[at]}});
            has_found = true;
        }
        store_query_at(found, at, limits, samples);
        if (samples.slack[at] < ContactCacheArrays::kInvalidBelow) ++at;
    }
}

// Handles one block of samples: queries the collider if needed, and projects samples that touch. Blocks are processed
// in sequence, so each starts from the positions that the previous ones left. Returns how far its samples may move
// before they have to be looked at again, m.
float meet_samples(SolverState& solver, SampleBlock& samples, const Kernels& loops, const Collider& body,
                   const ContactLimits& limits) {
    ContactBlock block;
    const SampleState state = loops.locate_samples(samples, floats(solver.points), block);
    if (state.to_query == 0 && !state.touches) return state.free;
    if (samples.in_turn[0] != 0) {
        meet_in_turn(solver, samples, loops, body, limits);
        return 0;
    }
    const unsigned slots = state.to_query == 0 || body.costs_by_slot() ? state.to_query : kAllSlots;
    if (slots != 0) query(solver, samples, block, body, limits.offset + kPlaneReach, slots);
    store_queries(block, slots, loops, limits, samples);
    loops.push_samples(samples, limits, floats(solver.points), floats(solver.before));
    return slots == kAllSlots ? *std::ranges::min_element(samples.slack) : 0;
}

void forget_skips(ContactState& contacts) {
    contacts.skips.last.clear();
    contacts.skips.skip_until.clear();
}

// Adds the motion of the vertices since the last call.
void follow_motion(Cloth& cloth, const Kernels& loops) {
    SampleSkips& skips = cloth.solver->contacts.skips;
    std::vector<Vec4f>& points = cloth.solver->points;
    if (skips.last.size() == points.size() && skips.skip_until.size() == cloth.solver->contacts.samples.size()) {
        skips.moved += static_cast<double>(loops.longest_motion(floats(points), floats(skips.last), cloth.x.size()));
        return;
    }
    skips.last = points;
    skips.moved = 0;
    skips.skip_until.assign(cloth.solver->contacts.samples.size(), 0);
}

}  // namespace

void refresh_contacts(Cloth& cloth, const ContactOptions& options, const SplitOnContact& split) {
    ContactState& contacts = cloth.solver->contacts;
    reactivate(cloth);
    contacts.faces.clear();
    size_contacts(cloth, contacts);
    std::fill(contacts.friction.begin(), contacts.friction.end(), 0.0F);
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) add_friction(cloth, contacts, leaf.triangle);
    contacts.spacing = options.sample_spacing;
    contacts.sampled_edge = options.sampled_edge;
    contacts.split = split;
    SampleLists(cloth).make_all();
    forget_skips(contacts);
}

bool are_contacts_made_for(const Cloth& cloth, const ContactOptions& options, const SplitOnContact& split) {
    const ContactState& contacts = cloth.solver->contacts;
    return contacts.vertices == cloth.mesh.vertex_capacity() && contacts.spacing == options.sample_spacing &&
           contacts.sampled_edge == options.sampled_edge && contacts.split == split;
}

void update_contacts(Cloth& cloth, const ContactOptions& options, const SplitOnContact& split) {
    ContactState& contacts = cloth.solver->contacts;
    if (!are_contacts_made_for(cloth, options, split) ||
        contacts.inserted > 2 * cloth.mesh.leaf_triangles().size() + 64 * kBlock) {
        refresh_contacts(cloth, options, split);
        return;
    }
    contacts.faces.clear();
    const LeafChanges& changes = cloth.mesh.changes();
    for (const VertexId v : changes.vertices_removed) contacts.friction[v.value] = 0;
    for (const VertexId v : changes.vertices_added) {
        contacts.query_point[v.value] = nothing_known();
        contacts.friction[v.value] = 0;
    }
    for (const TriangleId t : changes.triangles_added) add_friction(cloth, contacts, t);
    SampleLists(cloth).change();
    forget_skips(contacts);
}

void forget_contacts(Cloth& cloth) {
    keep_far_contacts(cloth, std::numeric_limits<float>::infinity());
    cloth.solver->contacts.moving.last.clear();
}

void keep_far_contacts(Cloth& cloth, float by) {
    reactivate(cloth);
    ContactState& contacts = cloth.solver->contacts;
    forget_skips(contacts);
    // Entries that are left have no tangent plane in reach when their slack is used up.
    const auto lower = [by](float slack) {
        return slack - by > kPlaneReach ? slack - by : ContactCacheArrays::kUnknown;
    };
    for (Vec4f& query : contacts.query_point) query.w() = lower(query.w());
    for (FaceContact& face : contacts.faces) face.slack = FaceContact::kUnknown;
    for (SampleBlock& block : contacts.samples) {
        for (std::size_t at = 0; at < kBlock; ++at) {
            if (block.shares[0][at] > 0) block.slack[at] = lower(block.slack[at]);
        }
    }
}

void set_contact_offset(Cloth& cloth, float offset) {
    ContactState& contacts = cloth.solver->contacts;
    const float lower = contacts.offset - offset;
    contacts.offset = offset;
    if (lower == 0) return;
    forget_skips(contacts);
    for (std::size_t v = 0; v < contacts.query_point.size(); ++v) {
        contacts.plane[v].w() += lower;
        if (contacts.query_point[v].w() >= ContactCacheArrays::kInvalidBelow) contacts.query_point[v].w() += lower;
    }
    for (SampleBlock& block : contacts.samples) {
        for (std::size_t at = 0; at < kBlock; ++at) {
            block.side.height[at] += lower;
            if (block.slack[at] >= ContactCacheArrays::kInvalidBelow) block.slack[at] += lower;
        }
    }
}

std::size_t sample_count(const ContactState& contacts) {
    std::size_t count = 0;
    for (std::size_t slot = 0; slot < contacts.samples.size() * kBlock; ++slot) {
        count += contacts.samples[slot / kBlock].shares[0][slot % kBlock] > 0 ? 1 : 0;
    }
    return count;
}

std::optional<Vec3f> sample_at(const ContactState& contacts, std::size_t slot, const std::vector<Vec4f>& x) {
    const SampleBlock& block = contacts.samples[slot / kBlock];
    const std::size_t at = slot % kBlock;
    if (block.shares[0][at] <= 0) return std::nullopt;
    Vec3f sum = Vec3f::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        if (block.shares[k][at] > 0) sum += block.shares[k][at] * x[block.vertices[k][at] / 4].head<3>();
    }
    return sum;
}

std::size_t push_out_samples(Cloth& cloth, const Kernels& loops, const Collider& body, const ContactOptions& options) {
    constexpr double kRounding = 0.00001;  // m, more than the rounding errors of positions within 10 m of the origin
    ContactState& contacts = cloth.solver->contacts;
    if (contacts.samples.empty()) return 0;
    const ContactLimits limits = limits_for(body, options);
    follow_motion(cloth, loops);
    SampleSkips& skips = contacts.skips;
    std::size_t seen = 0;
    for (std::size_t i = 0; i < contacts.samples.size(); ++i) {
        if (skips.moved < skips.skip_until[i]) continue;
        ++seen;
        const float free = meet_samples(*cloth.solver, contacts.samples[i], loops, body, limits);
        skips.skip_until[i] = skips.moved + static_cast<double>(free) - kRounding;
    }
    return seen;
}

void hold_vertices(Cloth& cloth, const Kernels& loops, const Collider& body, float longest_move,
                   const ContactOptions& options) {
    ContactState& contacts = cloth.solver->contacts;
    SolverState& solver = *cloth.solver;
    ContactLimits limits = limits_for(body, options);
    limits.longest_move = longest_move;
    const ContactCacheArrays known{floats(contacts.query_point), floats(contacts.plane)};
    std::vector<std::uint32_t>& to_query = contacts.scratch.to_query;
    std::vector<ContactBlock>& blocks = contacts.scratch.blocks;
    to_query.resize(cloth.x.size() + kBlock);
    const std::size_t count = loops.project_vertices(floats(solver.points), floats(solver.before), known,
                                                     contacts.friction.data(), cloth.x.size(), limits, to_query.data());
    if (count == 0) return;
    const std::uint32_t dummy = static_cast<std::uint32_t>(4 * (solver.points.size() - 1));
    std::fill_n(to_query.begin() + static_cast<std::ptrdiff_t>(count), kBlock, dummy);
    blocks.resize((count + kBlock - 1) / kBlock);
    for (std::size_t i = 0; i < blocks.size() * kBlock; ++i) {
        blocks[i / kBlock].set_point(i % kBlock, solver.points[to_query[i] / 4].head<3>());
    }
    query(solver, body, limits.offset + kMaxStandoff + kPlaneReach);
    for (std::size_t i = 0; i < blocks.size() * kBlock; ++i) {
        blocks[i / kBlock].distance[i % kBlock] -= contacts.standoff[to_query[i] / 4];
    }
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        loops.store_query_and_project(blocks[i], &to_query[i * kBlock], contacts.friction.data(), limits,
                                      floats(solver.before), floats(solver.points), known);
    }
}

Vec3f outside(const Vec3f& x, const Vec3f& outward, const Collider& body, float offset) {
    constexpr float kReach = 0.05F;  // m, of the ray either way; chosen by experiment
    const Contact contact = body.contact(x);
    if (contact.distance >= offset) return x;
    const Vec3f nearest = x + contact.normal * (offset - contact.distance);
    if (contact.normal.dot(outward) >= 0 || outward.squaredNorm() <= 0) return nearest;
    const Vec3f direction = outward.normalized();
    const auto ahead = body.first_hit(x, x + direction * kReach);
    if (ahead) return ahead->point + direction * offset;
    const auto behind = body.first_hit(x, x - direction * kReach);
    return behind && contact.distance > 0 ? Vec3f(behind->point + direction * offset) : nearest;
}

}  // namespace selvedge::sim
