// Retriangulation: how a triangle passes from one configuration to another.  (thesis 3.3; SPEC 1.2)
#include <algorithm>
#include <utility>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/adaptive/configuration_tables.h"

namespace selvedge {

using namespace configuration_tables;

// One function per pair of configurations: the tables are read when it is compiled, what is left is straight-line code
// over the elements that the two do not share.
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

// The slot of the triangle that runs along an internal edge from its first point to its second, or the other way.
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
    std::array<std::size_t, 3> side_of;             // on which side of its external edges the owner lies
    std::array<TriangleId, 4> triangles;
    std::array<EdgeId, 3> edges;

    static void make(AdaptiveMesh& mesh, TriangleId id) {
        SELVEDGE_ASSERT(mesh.triangles_[id].regular);
        One one{mesh, mesh.triangles_[id], {}, {}, {}, {}, {}};
        one.look_round();
        one.release_edges_and_triangles();
        one.take_ids();
        one.write_edges();
        one.write_triangles();
        one.finish(id);
    }

    static constexpr bool splits(const Layout& layout, std::size_t k) { return (layout.split >> k & 1U) != 0; }

    // Reads the external edges that are split before or after, and takes the children of those that no longer are away
    // from what bordered them.
    void look_round() {
        for_each_slot<3>([&](auto k) {
            if constexpr (splits(from, k) || splits(to, k)) {
                const AdaptiveEdge& external = mesh.edges_[owner.edges[k]];
                const std::size_t side = external.ends[0] == owner.vertices[k] ? 0 : 1;
                side_of[k] = side;
                centres[k] = external.centre;
                children[k] = {external.children[side], external.children[1 - side]};
                if constexpr (!splits(to, k)) {
                    if (external.rejoining) return;  // they go, too
                    for (const EdgeId child : children[k]) mesh.edges_[child].sides[side] = {};
                }
            }
        });
    }

    // Last to first, so that the same ids come back in the same order.
    void release_edges_and_triangles() {
        for_each_slot<from.triangle_count>([&](auto i) {
            constexpr std::size_t slot = from.triangle_count - 1U - i;
            if constexpr (is_released(plan.drops_triangle, plan.triangle_over, slot)) {
                const TriangleId id = owner.internal_triangles[slot];
                SELVEDGE_ASSERT(is_leaf(mesh.triangles_[id]));
                mesh.keeper_.note_released(id);
                mesh.triangles_.release(id);
            }
        });
        for_each_slot<from.edge_count>([&](auto i) {
            constexpr std::size_t slot = from.edge_count - 1U - i;
            if constexpr (is_released(plan.drops_edge, plan.edge_over, slot)) {
                const EdgeId id = owner.internal_edges[slot];
                mesh.keeper_.note_released(id);
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
                mesh.keeper_.note_rewritten(triangles[i]);
            } else {
                triangles[i] = free_triangles[count_new(plan.triangle_from, plan.triangle_over, i)];
            }
        });
        for_each_slot<to.edge_count>([&](auto i) {
            if constexpr (plan.edge_from[i] != kNoSlot) {
                edges[i] = owner.internal_edges[plan.edge_from[i]];
            } else if constexpr (plan.edge_over[i] != kNoSlot) {
                edges[i] = owner.internal_edges[plan.edge_over[i]];
                mesh.keeper_.note_rewritten(edges[i]);
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

    // What the triangle whose place it takes has at the same corner need not be written again.
    static constexpr bool has_point(std::size_t slot, std::size_t k) {
        const std::uint8_t old = plan.triangle_over[slot];
        return old != kNoSlot && from.triangles[old].points[k] == to.triangles[slot].points[k];
    }
    static constexpr bool has_edge(std::size_t slot, std::size_t k) {
        const std::uint8_t old = plan.triangle_over[slot];
        const LocalEdge edge = to.triangles[slot].edges[k];
        return old != kNoSlot && edge < kFirstInternalEdge && from.triangles[old].edges[k] == edge;
    }

    // An external edge that is left whole lies one level above and keeps the owner as its side.
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
        triangle.level = inner_level();
        triangle.configuration = Configuration::C0;
        triangle.marked = false;
    }

    std::uint8_t inner_level() const { return static_cast<std::uint8_t>(owner.level + 1); }

    void finish(TriangleId id) {
        for_each_slot<4>([&](auto i) {
            if constexpr (i < from.triangle_count || i < to.triangle_count) owner.internal_triangles[i] = triangles[i];
        });
        for_each_slot<3>([&](auto i) {
            if constexpr (i < from.edge_count || i < to.edge_count) owner.internal_edges[i] = edges[i];
        });
        owner.configuration = static_cast<Configuration>(kTo);
        if constexpr (from.triangle_count == 0) mesh.levels_.add_refined(owner.level, id);
        if constexpr (to.triangle_count == 0) mesh.levels_.remove_refined(owner.level, id);
        if constexpr (from.triangle_count == 0 || to.triangle_count == 0) mesh.keeper_.note_refined(id);
        mesh.keeper_.note(id);
    }
};

void AdaptiveMesh::change_configuration(TriangleId id, Configuration to) {
    static constexpr Change::Table kTable = Change::make_table(std::make_index_sequence<kConfigurations>{});
    const Configuration from = triangles_[id].configuration;
    if (from != to) kTable[index_of(from)][index_of(to)](*this, id);
}

int AdaptiveMesh::retriangulate(int level, TransitionCounts* counts) {
    NoWatch watch;
    return retriangulate(level, counts, LeastWork{}, watch);
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

}  // namespace selvedge
