#include "sim/adaptive/adaptive_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "sim/adaptive/configuration_tables.h"
#include "sim/adaptive/orient.h"
#include "sim/core/error.h"
#include "sim/mesh/sew.h"

namespace selvedge::sim {
std::uint64_t TransitionCounts::between_states(std::size_t from, std::size_t to) const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < kConfigurations; ++i) {
        for (std::size_t j = 0; j < kConfigurations; ++j) {
            const auto a = static_cast<Configuration>(i), b = static_cast<Configuration>(j);
            if (state_of(a) == from && state_of(b) == to) sum += by_configuration[i][j];
        }
    }
    return sum;
}

TriangleId AdaptiveMesh::leaf_at(EdgeId e, int side) const {
    const TriangleId owner = edges_[e].sides[static_cast<std::size_t>(side)];
    if (!owner) return owner;
    const AdaptiveTriangle& t = triangles_[owner];
    if (is_leaf(t)) return owner;
    const std::uint8_t slot = layout(t.configuration).slot_at_unsplit[index_of(t, e)];
    return slot == kNoSlot ? TriangleId{} : t.internal_triangles[slot];
}

int AdaptiveMesh::side_of(TriangleId t, std::size_t k) const {
    const EdgeId e = triangles_[t].edges[k];
    const AdaptiveEdge& edge = edges_[e];
    if (!edge.right_wrong) return edge.ends[0] == triangles_[t].vertices[k] ? 0 : 1;
    return edge.sides[0] == t || leaf_at(e, 0) == t ? 0 : 1;
}

bool AdaptiveMesh::is_cut(EdgeId e) const {
    const AdaptiveEdge& edge = edges_[e];
    return edge.right_wrong && triangles_[edge.sides[0]].turned == triangles_[edge.sides[1]].turned;
}

// The sides of an edge are triangles of the edge's own level. An unsplit edge of an S1..S6 triangle also borders one of
// its irregular internal triangles, one level deeper; testing that one would make S1 -> S4 and S1 -> S7 impossible.
bool AdaptiveMesh::may_split(EdgeId e) const {
    const AdaptiveEdge& edge = edges_[e];
    const auto is_regular = [&](TriangleId side) { return !side || triangles_[side].regular; };
    return !edge.centre && edge.level < options_.max_level && is_regular(edge.sides[0]) && is_regular(edge.sides[1]);
}

bool AdaptiveMesh::may_rejoin(EdgeId e) const {
    if (!is_split(e) || !has_leaf_children(e)) return false;
    // A marked triangle passed this test already, when another of its edges was rejoined.
    const auto lets_go = [&](TriangleId side) { return !side || triangles_[side].marked || has_leaf_children(side); };
    return lets_go(edges_[e].sides[0]) && lets_go(edges_[e].sides[1]);
}

bool AdaptiveMesh::has_leaf_children(EdgeId e) const {
    const std::array<EdgeId, 2>& children = edges_[e].children;
    return !edges_[children[0]].centre && !edges_[children[1]].centre;
}

// The three internal edges and the six child edges of an S7 triangle are the edges of its four children. None of them
// is split if all four children are leaves. In the other states internal triangles are always leaves.
bool AdaptiveMesh::has_leaf_children(TriangleId t) const {
    const AdaptiveTriangle& owner = triangles_[t];
    if (owner.configuration != Configuration::C10) return true;
    const auto is_whole = [&](TriangleId child) { return is_leaf(triangles_[child]); };
    return std::all_of(owner.internal_triangles.begin(), owner.internal_triangles.end(), is_whole);
}

// change_configuration() asserts that both sides are regular.
VertexId AdaptiveMesh::split(EdgeId e) {
    AdaptiveEdge& edge = edges_[e];
    SELVEDGE_ASSERT(!edge.centre && edge.level < options_.max_level);
    const VertexId centre = vertices_.take<1>()[0];
    edge.children = edges_.take<2>();
    edge.centre = centre;
    grow_lists_with_pools();
    const auto level = static_cast<std::uint8_t>(edge.level + 1);
    const float half = 0.5F * edge.rest_length;
    edges_[edge.children[0]].set({edge.ends[0], centre}, {}, half, level);
    edges_[edge.children[1]].set({centre, edge.ends[1]}, {}, half, level);
    for (const EdgeId child : edge.children) edges_[child].right_wrong = edge.right_wrong;
    vertices_[centre] = {.parent = e, .level = level, .on_cut = has_cuts_ && is_cut(e)};
    splitting_.push_back(e);
    mark_sides(e);
    return centre;
}

// The transition asserts that no internal triangle that it releases is refined.
void AdaptiveMesh::rejoin(EdgeId e) {
    SELVEDGE_ASSERT(is_split(e) && has_leaf_children(e));
    edges_[e].rejoining = true;
    rejoining_.push_back(e);
    mark_sides(e);
}

void AdaptiveMesh::mark_sides(EdgeId e) {
    for (const TriangleId side : edges_[e].sides) {
        if (!side || triangles_[side].marked) continue;
        triangles_[side].marked = true;
        marked_.push_back(side);
    }
}

// Removes last to first, so that no entry moves if all edges of a level were split.
void AdaptiveMesh::list_split() {
    for (std::size_t i = splitting_.size(); i-- > 0;) {
        levels_.remove_unsplit(edges_[splitting_[i]].level, splitting_[i]);
    }
    for (const EdgeId e : splitting_) {
        const AdaptiveEdge& edge = edges_[e];
        levels_.add_split(edge.level, e);
        for (const EdgeId child : edge.children) levels_.add_unsplit(edge.level + 1, child);
        tracker_.note(e);
    }
    splitting_.clear();
}

// In the reverse order of split(), so that a later split gets the same ids.
void AdaptiveMesh::release_rejoined() {
    for (; !rejoining_.empty(); rejoining_.pop_back()) {
        const EdgeId e = rejoining_.back();
        AdaptiveEdge& edge = edges_[e];
        for (std::size_t i = 2; i-- > 0;) {
            levels_.remove_unsplit(edge.level + 1, edge.children[i]);
            tracker_.note_released(edge.children[i]);
            edges_.release(edge.children[i]);
        }
        levels_.remove_split(edge.level, e);
        levels_.add_unsplit(edge.level, e);
        tracker_.note_released(edge.centre);
        tracker_.note(e);
        vertices_.release(edge.centre);
        edge.children = {};
        edge.centre = {};
        edge.rejoining = false;
    }
}

void AdaptiveMesh::grow_lists() {
    levels_.grow(edges_.capacity(), triangles_.capacity());
    tracker_.grow(vertices_.capacity(), edges_.capacity(), triangles_.capacity());
    listed_capacity_ = vertices_.capacity() + edges_.capacity() + triangles_.capacity();
}

// For a base vertex the first base triangle of each fan is stored. A centre has one fan; it starts beside a child edge
// of its parent. Children of edges split since the last retriangulate() have no sides yet and are skipped.
AdaptiveMesh::FanStep AdaptiveMesh::first_at(VertexId v, std::size_t fan) const {
    if (v.value < base_vertices_) {
        const std::size_t place = fan_starts_[v.value] + fan;
        if (place >= fan_starts_[v.value + 1]) return {};
        FanStep at{first_inside(fans_[place].triangle, v), false};
        if (!fans_[place].is_clockwise) return at;
        // The walk starts at the anticlockwise end of the base triangle, where the surface ends.
        for (FanStep next = next_at(v, at); next.triangle; next = next_at(v, at)) at = next;
        return {at.triangle, true};
    }
    if (fan > 0) return {};
    const AdaptiveEdge& parent = edges_[vertices_[v].parent];
    const std::size_t child = parent.sides[0] ? 1 : 0, side = 1 - child;  // the side that the child has on its left
    EdgeId e = parent.children[child];
    while (edges_[e].centre && edges_[edges_[e].children[1 - child]].sides[side]) e = edges_[e].children[1 - child];
    return {leaf_at(e, static_cast<int>(side)), false};
}

TriangleId AdaptiveMesh::first_inside(TriangleId owner, VertexId v) const {
    while (!is_leaf(triangles_[owner])) {
        const AdaptiveTriangle& t = triangles_[owner];
        owner = t.internal_triangles[layout(t.configuration).slot_at_corner[corner_at(t, v)]];
    }
    return owner;
}

AdaptiveMesh::FanStep AdaptiveMesh::next_at(VertexId v, FanStep at) const {
    const AdaptiveTriangle& t = triangles_[at.triangle];
    const std::size_t k = (corner_at(t, v) + (at.is_clockwise ? 0 : 2)) % 3;
    const EdgeId e = t.edges[k];
    return {leaf_at(e, 1 - side_of(at.triangle, k)), at.is_clockwise != edges_[e].right_wrong};
}

// Construction of level 0 from a triangle mesh.

namespace {

// One side of a base edge: the triangle, and its corner where the edge starts in anticlockwise direction.
struct BaseSide {
    int low = 0;  // the edge's vertices, by index
    int high = 0;
    std::uint32_t triangle = 0;
    std::size_t corner = 0;
    bool rises = false;  // the triangle has the edge in the direction low to high

    bool is_of_same_edge(const BaseSide& other) const { return low == other.low && high == other.high; }
    auto key() const { return std::tuple(low, high, triangle, corner); }
};

std::vector<BaseSide> sides_by_edge(std::span<const GarmentTriangle> base) {
    std::vector<BaseSide> sides;
    sides.reserve(3 * base.size());
    for (std::uint32_t t = 0; t < base.size(); ++t) {
        const std::array<int, 3>& v = base[t].vertices;
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = v[k], to = v[(k + 1) % 3];
            sides.push_back({std::min(from, to), std::max(from, to), t, k, from < to});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const BaseSide& a, const BaseSide& b) { return a.key() < b.key(); });
    return sides;
}

void require_manifold(std::span<const BaseSide> edge) {
    const std::string place = "edge " + std::to_string(edge[0].low) + "-" + std::to_string(edge[0].high);
    if (edge[0].low == edge[0].high) throw InputError("", place, "both ends are the same vertex");
    if (edge.size() > 2) throw InputError("", place, "is shared by " + std::to_string(edge.size()) + " triangles");
}

// Directed as its first triangle has it if that is right_wrong, else from the lower vertex to the higher one.
AdaptiveEdge make_base_edge(std::span<const BaseSide> edge, double rest_length) {
    AdaptiveEdge made;
    made.ends = {VertexId(static_cast<std::uint32_t>(edge[0].low)), VertexId(static_cast<std::uint32_t>(edge[0].high))};
    made.rest_length = static_cast<float>(rest_length);
    made.right_wrong = edge.size() == 2 && edge[0].rises == edge[1].rises;
    if (made.right_wrong) {
        if (!edge[0].rises) std::swap(made.ends[0], made.ends[1]);
        made.sides = {TriangleId(edge[0].triangle), TriangleId(edge[1].triangle)};
    } else {
        for (const BaseSide& side : edge) made.sides[side.rises ? 0 : 1] = TriangleId(side.triangle);
    }
    return made;
}

AdaptiveTriangle make_base_triangle(const GarmentTriangle& from) {
    SELVEDGE_ASSERT(from.panel >= 0 && from.panel <= 0xFFFF);
    AdaptiveTriangle triangle;
    triangle.panel = static_cast<std::uint16_t>(from.panel);
    for (std::size_t k = 0; k < 3; ++k) {
        triangle.vertices[k] = VertexId(static_cast<std::uint32_t>(from.vertices[k]));
        triangle.u[k] = from.u[k].cast<float>();
    }
    return triangle;
}

double side_length(std::span<const GarmentTriangle> base, const BaseSide& side) {
    const GarmentTriangle& t = base[side.triangle];
    return static_cast<double>(t.lines[side.corner].drawn_to) * (t.u[(side.corner + 1) % 3] - t.u[side.corner]).norm();
}

double edge_length(std::span<const GarmentTriangle> base, std::span<const BaseSide> edge, double seam_ease) {
    const double length = side_length(base, edge.front());
    if (edge.size() == 1) return length;
    return seam_rest_length(length, side_length(base, edge.back()), {.ease = seam_ease});
}

}  // namespace

AdaptiveMesh::AdaptiveMesh(const GarmentMesh& base, const AdaptiveMeshOptions& options)
    : AdaptiveMesh(base.x.size(), base.triangles, options) {
    SELVEDGE_ASSERT(base.links.empty());
}

AdaptiveMesh::AdaptiveMesh(std::size_t vertex_count, std::span<const GarmentTriangle> triangles,
                           const AdaptiveMeshOptions& options)
    : options_(options), base_vertices_(vertex_count), base_triangles_(triangles.size()) {
    SELVEDGE_ASSERT(options.max_level >= 0 && options.max_level <= kDeepestLevel);
    for (std::size_t i = 0; i < base_vertices_; ++i) vertices_.create({});
    for (const GarmentTriangle& triangle : triangles) triangles_.create(make_base_triangle(triangle));
    for (const GarmentTriangle& triangle : triangles) base_lines_.push_back(triangle.lines);
    add_base_edges(triangles);
    add_base_fans();
    orient_base();
    levels_.set_deepest(options.max_level);
    grow_lists();
    list_base();
    refresh_lists();
}

void AdaptiveMesh::list_base() {
    for (std::uint32_t i = 0; i < base_vertices_; ++i) tracker_.note(VertexId(i));
    for (std::uint32_t i = 0; i < base_edges_; ++i) tracker_.note(EdgeId(i));
    for (std::uint32_t i = 0; i < base_triangles_; ++i) tracker_.note(TriangleId(i));
    for (std::uint32_t i = 0; i < base_edges_; ++i) levels_.add_unsplit(0, EdgeId(i));
}

// The neighbour round a vertex of the base mesh, before any triangle is refined.
AdaptiveMesh::FanStep AdaptiveMesh::base_neighbour(VertexId v, FanStep at) const {
    const AdaptiveTriangle& t = triangles_[at.triangle];
    const std::size_t k = (corner_at(t, v) + (at.is_clockwise ? 0 : 2)) % 3;
    const AdaptiveEdge& edge = edges_[t.edges[k]];
    const auto other = static_cast<std::size_t>(1 - side_of(at.triangle, k));
    return {edge.sides[other], at.is_clockwise != edge.right_wrong};
}

// A closed fan starts with its lowest id. An open fan starts with the triangle that has no neighbour on its clockwise
// side; with right_wrong edges two triangles may be like that, or none: then with the lower id of the two at its ends.
// Marks the fan's corners, three per triangle, as visited.
AdaptiveMesh::FanStep AdaptiveMesh::start_of_fan(VertexId v, TriangleId t, std::vector<bool>& is_visited) const {
    const auto visit = [&](TriangleId at) { is_visited[3 * at.value + corner_at(triangles_[at], v)] = true; };
    FanStep at{t, true};
    TriangleId lowest = t;
    for (FanStep next = base_neighbour(v, at); next.triangle; next = base_neighbour(v, at)) {
        visit(at.triangle);
        lowest = std::min(lowest, at.triangle);
        if (next.triangle == t) return {lowest, false};
        at = next;
    }
    const FanStep start{at.triangle, !at.is_clockwise};
    at = start;
    for (FanStep next = base_neighbour(v, at); next.triangle; next = base_neighbour(v, at)) {
        visit(at.triangle);
        at = next;
    }
    visit(at.triangle);
    const FanStep other{at.triangle, !at.is_clockwise};
    if (start.is_clockwise != other.is_clockwise) return start.is_clockwise ? other : start;
    return start.triangle < other.triangle ? start : other;
}

void AdaptiveMesh::add_base_fans() {
    std::vector<bool> is_visited(3 * base_triangles_, false);
    std::vector<std::pair<VertexId, FanStep>> found;
    for (std::uint32_t i = 0; i < base_triangles_; ++i) {
        const TriangleId t(i);
        for (std::size_t k = 0; k < 3; ++k) {
            if (is_visited[3 * i + k]) continue;
            const VertexId v = triangles_[t].vertices[k];
            found.emplace_back(v, start_of_fan(v, t, is_visited));
        }
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return std::tie(a.first, a.second.triangle) < std::tie(b.first, b.second.triangle);
    });
    fan_starts_.assign(base_vertices_ + 1, 0);
    for (const auto& [v, start] : found) {
        fans_.push_back(start);
        ++fan_starts_[v.value + 1];
    }
    std::partial_sum(fan_starts_.begin(), fan_starts_.end(), fan_starts_.begin());
}

void AdaptiveMesh::orient_base() {
    std::vector<OrientedEdge> inner;
    for (std::uint32_t i = 0; i < base_edges_; ++i) {
        const AdaptiveEdge& edge = edges_[EdgeId(i)];
        has_right_wrong_edges_ = has_right_wrong_edges_ || edge.right_wrong;
        if (edge.sides[0] && edge.sides[1])
            inner.push_back({edge.sides[0].value, edge.sides[1].value, edge.right_wrong});
    }
    if (!has_right_wrong_edges_) return;
    std::vector<OrientedTriangle> triangles;
    for (std::uint32_t i = 0; i < base_triangles_; ++i) {
        const AdaptiveTriangle& t = triangles_[TriangleId(i)];
        triangles.push_back({std::abs(double(material_area(t.u))), t.panel});
    }
    const std::vector<bool> is_turned = find_turned(inner, triangles);
    for (std::uint32_t i = 0; i < base_triangles_; ++i) triangles_[TriangleId(i)].turned = is_turned[i];
    for (std::uint32_t i = 0; i < base_edges_; ++i) {
        if (!is_cut(EdgeId(i))) continue;
        has_cuts_ = true;
        for (const VertexId v : edges_[EdgeId(i)].ends) vertices_[v].on_cut = true;
    }
}

void AdaptiveMesh::add_base_edges(std::span<const GarmentTriangle> base) {
    const std::vector<BaseSide> sides = sides_by_edge(base);
    for (std::size_t first = 0; first < sides.size();) {
        std::size_t last = first;
        while (last < sides.size() && sides[last].is_of_same_edge(sides[first])) ++last;
        const std::span<const BaseSide> edge(sides.data() + first, last - first);
        require_manifold(edge);
        const EdgeId id = edges_.create(make_base_edge(edge, edge_length(base, edge, options_.seam_ease)));
        for (const BaseSide& side : edge) triangles_[TriangleId(side.triangle)].edges[side.corner] = id;
        first = last;
    }
    base_edges_ = edges_.size();
}

// Retriangulation: transitions of a triangle from one configuration to another.  (thesis 3.3.4-3.3.5)

using namespace configuration_tables;

// One function per pair of configurations, of which compilation leaves only code over what they do not share.
struct AdaptiveMesh::Change {
    using Function = void (*)(AdaptiveMesh&, TriangleId);
    using Table = std::array<std::array<Function, kConfigurations>, kConfigurations>;

    template <std::size_t kFrom, std::size_t kTo>
    struct One;

    template <std::size_t kFrom, std::size_t... kTo>
    static constexpr std::array<Function, kConfigurations> make_row(std::index_sequence<kTo...>) {
        return {[] {
            if constexpr (kFrom == kTo) {
                return Function{nullptr};
            } else {
                return Function{One<kFrom, kTo>::make};
            }
        }()...};
    }

    template <std::size_t... kFrom>
    static constexpr Table make_table(std::index_sequence<kFrom...>) {
        return {make_row<kFrom>(std::make_index_sequence<kConfigurations>{})...};
    }
};

namespace {

template <std::size_t kCount, class F>
[[gnu::always_inline]] inline void for_each_slot(F&& f) {
    [&]<std::size_t... kSlot>(std::index_sequence<kSlot...>) {
        (f(std::integral_constant<std::size_t, kSlot>{}), ...);
    }
    (std::make_index_sequence<kCount>{});
}

template <std::size_t kSlots>
constexpr std::size_t count_new(const std::array<std::uint8_t, kSlots>& from,
                                const std::array<std::uint8_t, kSlots>& over, std::size_t count) {
    std::size_t fresh = 0;
    for (std::size_t i = 0; i < count; ++i) fresh += from[i] == kNoSlot && over[i] == kNoSlot;
    return fresh;
}

template <std::size_t kSlots>
constexpr bool is_released(const std::array<bool, kSlots>& drops, const std::array<std::uint8_t, kSlots>& over,
                           std::size_t slot) {
    if (!drops[slot]) return false;
    for (const std::uint8_t taken : over) {
        if (taken == slot) return false;
    }
    return true;
}

// The slot of the triangle that has an internal edge in its own direction (side 0) or in the opposite one (side 1).
constexpr std::uint8_t slot_beside(const Layout& layout, std::size_t edge, std::size_t side) {
    for (std::uint8_t i = 0; i < layout.triangle_count; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (layout.triangles[i].edges[k] != kFirstInternalEdge + edge) continue;
            if ((layout.triangles[i].points[k] == layout.edges[edge].points[0]) == (side == 0)) return i;
        }
    }
    return kNoSlot;
}

}  // namespace

template <std::size_t kFrom, std::size_t kTo>
struct AdaptiveMesh::Change::One {
    static constexpr const Layout& from = kLayouts[kFrom];
    static constexpr const Layout& to = kLayouts[kTo];
    static constexpr const Transition& plan = kTransitions[kFrom][kTo];
    static constexpr bool makes_regular = static_cast<Configuration>(kTo) == Configuration::C10;
    static constexpr bool made_regular = static_cast<Configuration>(kFrom) == Configuration::C10;
    static constexpr std::size_t new_triangles = count_new(plan.triangle_from, plan.triangle_over, to.triangle_count);
    static constexpr std::size_t new_edges = count_new(plan.edge_from, plan.edge_over, to.edge_count);

    AdaptiveMesh& mesh;
    AdaptiveTriangle& owner;
    std::array<VertexId, 3> centres;
    std::array<std::array<EdgeId, 2>, 3> children;  // of the external edges, in the owner's direction
    std::array<std::size_t, 3> side_of;             // by external edge: the side on which the owner lies, 0 or 1
    std::array<TriangleId, 4> triangles;
    std::array<EdgeId, 3> edges;

    static void make(AdaptiveMesh& mesh, TriangleId id) {
        SELVEDGE_ASSERT(mesh.triangles_[id].regular);
        One one{mesh, mesh.triangles_[id], {}, {}, {}, {}, {}};
        one.look_round(id);
        one.release_edges_and_triangles();
        one.take_ids();
        one.write_edges();
        one.write_triangles();
        one.finish(id);
    }

    static constexpr bool splits(const Layout& layout, std::size_t k) { return (layout.split >> k & 1U) != 0; }

    // Reads the external edges that are split before or after the transition. Clears the owner's side of the children
    // of edges that no longer count as split, unless the edge is rejoining.
    void look_round(TriangleId id) {
        for_each_slot<3>([&](auto k) {
            if constexpr (splits(from, k) || splits(to, k)) {
                const AdaptiveEdge& external = mesh.edges_[owner.edges[k]];
                const std::size_t first = external.ends[0] == owner.vertices[k] ? 0 : 1;
                const std::size_t side = external.right_wrong && external.sides[0] != id ? 1 : first;
                side_of[k] = side;
                centres[k] = external.centre;
                children[k] = {external.children[first], external.children[1 - first]};
                if constexpr (!splits(to, k)) {
                    if (external.rejoining) return;  // the children will be freed
                    for (const EdgeId child : children[k]) mesh.edges_[child].sides[side] = {};
                }
            }
        });
    }

    // Releases last to first, so that later transitions get the same ids in the same order.
    void release_edges_and_triangles() {
        for_each_slot<from.triangle_count>([&](auto i) {
            constexpr std::size_t slot = from.triangle_count - 1U - i;
            if constexpr (is_released(plan.drops_triangle, plan.triangle_over, slot)) {
                const TriangleId id = owner.internal_triangles[slot];
                SELVEDGE_ASSERT(is_leaf(mesh.triangles_[id]));
                mesh.tracker_.note_released(id);
                mesh.triangles_.release(id);
            }
        });
        for_each_slot<from.edge_count>([&](auto i) {
            constexpr std::size_t slot = from.edge_count - 1U - i;
            if constexpr (is_released(plan.drops_edge, plan.edge_over, slot)) {
                const EdgeId id = owner.internal_edges[slot];
                mesh.tracker_.note_released(id);
                mesh.levels_.remove_unsplit(owner.level + 1, id);
                mesh.edges_.release(id);
            }
        });
    }

    void take_ids() {
        const std::array<TriangleId, new_triangles> free_triangles = mesh.triangles_.template take<new_triangles>();
        const std::array<EdgeId, new_edges> free_edges = mesh.edges_.template take<new_edges>();
        if constexpr (new_triangles + new_edges > 0) mesh.grow_lists_with_pools();
        for_each_slot<to.triangle_count>([&](auto i) {
            if constexpr (plan.triangle_from[i] != kNoSlot) {
                triangles[i] = owner.internal_triangles[plan.triangle_from[i]];
            } else if constexpr (plan.triangle_over[i] != kNoSlot) {
                triangles[i] = owner.internal_triangles[plan.triangle_over[i]];
                mesh.tracker_.note_rewritten(triangles[i]);
            } else {
                triangles[i] = free_triangles[count_new(plan.triangle_from, plan.triangle_over, i)];
            }
        });
        for_each_slot<to.edge_count>([&](auto i) {
            if constexpr (plan.edge_from[i] != kNoSlot) {
                edges[i] = owner.internal_edges[plan.edge_from[i]];
            } else if constexpr (plan.edge_over[i] != kNoSlot) {
                edges[i] = owner.internal_edges[plan.edge_over[i]];
                mesh.tracker_.note_rewritten(edges[i]);
            } else {
                edges[i] = free_edges[count_new(plan.edge_from, plan.edge_over, i)];
                mesh.levels_.add_unsplit(owner.level + 1, edges[i]);
            }
        });
    }

    template <LocalPoint kPoint>
    VertexId point() const {
        if constexpr (kPoint < 3) {
            return owner.vertices[kPoint];
        } else {
            return centres[kPoint - 3U];
        }
    }

    template <LocalPoint kPoint>
    Vec2f material() const {
        if constexpr (kPoint < 3) {
            return owner.u[kPoint];
        } else {
            return 0.5F * (owner.u[kPoint - 3U] + owner.u[(kPoint - 2U) % 3U]);
        }
    }

    template <LocalEdge kEdge>
    EdgeId edge() const {
        if constexpr (kEdge < 3) {
            return owner.edges[kEdge];
        } else if constexpr (kEdge < kFirstInternalEdge) {
            return children[(kEdge - 3U) / 2U][(kEdge - 3U) % 2U];
        } else {
            return edges[kEdge - kFirstInternalEdge];
        }
    }

    void write_edges() {
        for_each_slot<to.edge_count>([&](auto i) {
            constexpr InternalEdge drawn = to.edges[i];
            constexpr std::size_t left = slot_beside(to, i, 0), right = slot_beside(to, i, 1);
            AdaptiveEdge& edge = mesh.edges_[edges[i]];
            if constexpr (plan.edge_from[i] == kNoSlot) {
                const float length = (material<drawn.points[1]>() - material<drawn.points[0]>()).norm();
                const std::array<VertexId, 2> ends{point<drawn.points[0]>(), point<drawn.points[1]>()};
                if constexpr (plan.edge_over[i] == kNoSlot) {
                    edge.set(ends, {triangles[left], triangles[right]}, length, inner_level());
                } else {
                    edge.ends = ends;
                    edge.sides = {triangles[left], triangles[right]};
                    edge.rest_length = length;
                }
            } else {
                if constexpr (plan.triangle_from[left] == kNoSlot) edge.sides[0] = triangles[left];
                if constexpr (plan.triangle_from[right] == kNoSlot) edge.sides[1] = triangles[right];
            }
        });
    }

    void write_triangles() {
        for_each_slot<to.triangle_count>([&](auto i) {
            AdaptiveTriangle& triangle = mesh.triangles_[triangles[i]];
            if constexpr (plan.triangle_from[i] == kNoSlot) {
                write<i>(triangle);
            } else if constexpr (makes_regular != made_regular) {
                triangle.regular = makes_regular;
            }
        });
    }

    // Whether the triangle whose id is reused has the same point or edge at this corner, so that no write is needed.
    static constexpr bool has_point(std::size_t slot, std::size_t k) {
        const std::uint8_t old = plan.triangle_over[slot];
        return old != kNoSlot && from.triangles[old].points[k] == to.triangles[slot].points[k];
    }
    static constexpr bool has_edge(std::size_t slot, std::size_t k) {
        const std::uint8_t old = plan.triangle_over[slot];
        const LocalEdge edge = to.triangles[slot].edges[k];
        return old != kNoSlot && edge < kFirstInternalEdge && from.triangles[old].edges[k] == edge;
    }

    // An unsplit external edge lies one level above and keeps the owner as its side.
    template <std::size_t kSlot>
    void write(AdaptiveTriangle& triangle) {
        constexpr InternalTriangle drawn = to.triangles[kSlot];
        for_each_slot<3>([&](auto k) {
            if constexpr (!has_point(kSlot, k)) {
                triangle.vertices[k] = point<drawn.points[k]>();
                triangle.u[k] = material<drawn.points[k]>();
            }
            if constexpr (has_edge(kSlot, k)) return;
            const EdgeId e = edge<drawn.edges[k]>();
            triangle.edges[k] = e;
            if constexpr (drawn.edges[k] >= 3 && drawn.edges[k] < kFirstInternalEdge) {
                mesh.edges_[e].sides[side_of[(drawn.edges[k] - 3U) / 2U]] = triangles[kSlot];
            }
        });
        if constexpr (makes_regular != made_regular || plan.triangle_over[kSlot] == kNoSlot) {
            triangle.regular = makes_regular;
        }
        if constexpr (plan.triangle_over[kSlot] != kNoSlot) return;
        triangle.internal_triangles = {};
        triangle.internal_edges = {};
        triangle.panel = owner.panel;
        triangle.turned = owner.turned;
        triangle.level = inner_level();
        triangle.configuration = Configuration::C0;
        triangle.marked = false;
    }

    std::uint8_t inner_level() const { return static_cast<std::uint8_t>(owner.level + 1); }

    void finish(TriangleId id) {
        // NOLINTBEGIN(misc-redundant-expression): only where `from` and `to` have as many slots
        for_each_slot<4>([&](auto i) {
            if constexpr (i < from.triangle_count || i < to.triangle_count) owner.internal_triangles[i] = triangles[i];
        });
        for_each_slot<3>([&](auto i) {
            if constexpr (i < from.edge_count || i < to.edge_count) owner.internal_edges[i] = edges[i];
        });
        // NOLINTEND(misc-redundant-expression)
        owner.configuration = static_cast<Configuration>(kTo);
        if constexpr (from.triangle_count == 0) mesh.levels_.add_refined(owner.level, id);
        if constexpr (to.triangle_count == 0) mesh.levels_.remove_refined(owner.level, id);
        if constexpr (from.triangle_count == 0 || to.triangle_count == 0) mesh.tracker_.note_refined(id);
        mesh.tracker_.note(id);
    }
};

void AdaptiveMesh::change_configuration(TriangleId id, Configuration to) {
    static constexpr Change::Table kTable = Change::make_table(std::make_index_sequence<kConfigurations>{});
    const Configuration from = triangles_[id].configuration;
    if (from != to) kTable[index_of(from)][index_of(to)](*this, id);
}

int AdaptiveMesh::retriangulate(int level, TransitionCounts* counts) {
    NoObserver watch;
    return retriangulate(level, counts, MinimalChange{}, watch);
}

Diagonal AdaptiveMesh::diagonal(const AdaptiveTriangle& t, const InternalEdge& drawn) const {
    const auto vertex = [&](LocalPoint p) { return p < 3 ? t.vertices[p] : edges_[t.edges[p - 3U]].centre; };
    const auto material = [&](LocalPoint p) -> Vec2f {
        if (p < 3) return t.u[p];
        return 0.5F * (t.u[p - 3U] + t.u[(p - 2U) % 3]);
    };
    return {vertex(drawn.points[0]), vertex(drawn.points[1]), material(drawn.points[0]), material(drawn.points[1])};
}

SplitMask AdaptiveMesh::split_mask(const AdaptiveTriangle& t) const {
    unsigned mask = 0;
    for (std::size_t k = 0; k < 3; ++k) mask |= is_split(t.edges[k]) ? 1U << k : 0U;
    return static_cast<SplitMask>(mask);
}

}  // namespace selvedge::sim
