#pragma once
// The internal triangles of each configuration, and the tables derived from them at compile time. Private to
// configuration.cpp and adaptive_mesh.cpp; other files use configuration.h.  (thesis 3.3)
#include <initializer_list>

#include "sim/adaptive/configuration.h"

namespace selvedge::sim::configuration_tables {

using Points = std::array<LocalPoint, 3>;

inline constexpr LocalPoint V0 = 0, V1 = 1, V2 = 2, M0 = 3, M1 = 4, M2 = 5;

// The four basic patterns; every other refined configuration is one of them rotated by one or two corners.
inline constexpr std::initializer_list<Points> kOneSplit = {{V0, M0, V2}, {M0, V1, V2}};
inline constexpr std::initializer_list<Points> kTwoSplit = {{M0, V1, M1}, {V0, M0, V2}, {M0, M1, V2}};
inline constexpr std::initializer_list<Points> kTwoSplitOther = {{M0, V1, M1}, {V0, M0, M1}, {V0, M1, V2}};
inline constexpr std::initializer_list<Points> kThreeSplit = {{V0, M0, M2}, {V1, M1, M0}, {V2, M2, M1}, {M0, M1, M2}};

constexpr LocalPoint turned(LocalPoint p, unsigned turns) {
    const unsigned base = p < 3 ? 0 : 3;
    return static_cast<LocalPoint>(base + (p - base + turns) % 3);
}

// Rotated by `turns` corners, then reordered to start with its smallest point.
constexpr Points turned(const Points& points, unsigned turns) {
    const Points t{turned(points[0], turns), turned(points[1], turns), turned(points[2], turns)};
    std::size_t least = 0;
    if (t[1] < t[least]) least = 1;
    if (t[2] < t[least]) least = 2;
    return {t[least], t[(least + 1) % 3], t[(least + 2) % 3]};
}

constexpr InternalEdge between(LocalPoint a, LocalPoint b) {
    return a < b ? InternalEdge{{a, b}} : InternalEdge{{b, a}};
}

// The local edge between two points on the same external edge; kNoSlot for any other pair.
constexpr LocalEdge external_edge(const InternalEdge& edge) {
    for (std::uint8_t k = 0; k < 3; ++k) {
        const auto start = static_cast<LocalPoint>(k), end = turned(start, 1), middle = static_cast<LocalPoint>(3 + k);
        if (edge == between(start, end)) return k;
        if (edge == between(start, middle)) return static_cast<LocalEdge>(3 + 2 * k);
        if (edge == between(middle, end)) return static_cast<LocalEdge>(4 + 2 * k);
    }
    return kNoSlot;
}

constexpr std::uint8_t slot_of(const Layout& layout, const InternalEdge& edge) {
    for (std::uint8_t i = 0; i < layout.edge_count; ++i) {
        if (layout.edges[i] == edge) return i;
    }
    return kNoSlot;
}

constexpr std::uint8_t slot_of(const Layout& layout, const Points& points) {
    for (std::uint8_t i = 0; i < layout.triangle_count; ++i) {
        if (layout.triangles[i].points == points) return i;
    }
    return kNoSlot;
}

// The local number of an edge of an internal triangle. Adds the edge to the layout if it is a new internal edge.
constexpr LocalEdge find_or_add(Layout& layout, const InternalEdge& edge) {
    const LocalEdge external = external_edge(edge);
    if (external != kNoSlot) return external;
    std::uint8_t slot = slot_of(layout, edge);
    if (slot == kNoSlot) {
        slot = layout.edge_count++;
        layout.edges[slot] = edge;
    }
    return static_cast<LocalEdge>(kFirstInternalEdge + slot);
}

constexpr Layout draw(std::initializer_list<Points> drawing, unsigned turns) {
    Layout layout;
    for (const Points& drawn : drawing) {
        const std::uint8_t slot = layout.triangle_count++;
        InternalTriangle& triangle = layout.triangles[slot];
        triangle.points = turned(drawn, turns);
        for (std::size_t k = 0; k < 3; ++k) {
            const LocalPoint a = triangle.points[k], b = triangle.points[(k + 1) % 3];
            triangle.edges[k] = find_or_add(layout, between(a, b));
            if (triangle.edges[k] < 3) layout.slot_at_unsplit[triangle.edges[k]] = slot;
            if (a < 3 && (triangle.edges[k] == a || triangle.edges[k] == 3 + 2 * a)) layout.slot_at_corner[a] = slot;
            if (a >= 3) layout.split = static_cast<SplitMask>(layout.split | 1U << (a - 3));
        }
    }
    return layout;
}

inline constexpr std::array<Layout, kConfigurations> kLayouts = {
    Layout{},           draw(kOneSplit, 0),      draw(kOneSplit, 1),  draw(kOneSplit, 2),
    draw(kTwoSplit, 0), draw(kTwoSplitOther, 0), draw(kTwoSplit, 1),  draw(kTwoSplitOther, 1),
    draw(kTwoSplit, 2), draw(kTwoSplitOther, 2), draw(kThreeSplit, 0)};

// The number of corners and edges that need not be rewritten when b reuses the element of a.
constexpr int similarity(const InternalTriangle& a, const InternalTriangle& b) {
    int same = 0;
    for (std::size_t k = 0; k < 3; ++k) same += int{a.points[k] == b.points[k]} + int{a.edges[k] == b.edges[k]};
    return same;
}

constexpr int similarity(const InternalEdge& a, const InternalEdge& b) {
    return int{a.points[0] == b.points[0]} + int{a.points[1] == b.points[1]};
}

// Pairs each created element with a removed one whose id it reuses; the most similar pairs first.
template <class Element, std::size_t kSlots>
constexpr std::array<std::uint8_t, kSlots> take_over(const std::array<Element, kSlots>& old,
                                                     std::array<bool, kSlots> left,
                                                     const std::array<Element, kSlots>& made,
                                                     const std::array<std::uint8_t, kSlots>& made_from,
                                                     std::size_t count) {
    std::array<std::uint8_t, kSlots> over{};
    over.fill(kNoSlot);
    for (;;) {
        int most = -1;
        std::size_t slot = 0;
        std::uint8_t place = kNoSlot;
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = 0; j < kSlots; ++j) {
                if (made_from[i] != kNoSlot || over[i] != kNoSlot || !left[j]) continue;
                if (similarity(old[j], made[i]) <= most) continue;
                most = similarity(old[j], made[i]);
                slot = i;
                place = static_cast<std::uint8_t>(j);
            }
        }
        if (place == kNoSlot) return over;
        over[slot] = place;
        left[place] = false;
    }
}

constexpr Transition compare(const Layout& from, const Layout& to) {
    Transition plan;
    for (std::uint8_t i = 0; i < to.triangle_count; ++i) {
        plan.triangle_from[i] = slot_of(from, to.triangles[i].points);
        plan.work += plan.triangle_from[i] == kNoSlot;
    }
    for (std::uint8_t i = 0; i < to.edge_count; ++i) {
        plan.edge_from[i] = slot_of(from, to.edges[i]);
        plan.work += plan.edge_from[i] == kNoSlot;
    }
    for (std::uint8_t i = 0; i < from.triangle_count; ++i) {
        plan.drops_triangle[i] = slot_of(to, from.triangles[i].points) == kNoSlot;
        plan.work += plan.drops_triangle[i];
    }
    for (std::uint8_t i = 0; i < from.edge_count; ++i) {
        plan.drops_edge[i] = slot_of(to, from.edges[i]) == kNoSlot;
        plan.work += plan.drops_edge[i];
    }
    plan.triangle_over =
        take_over(from.triangles, plan.drops_triangle, to.triangles, plan.triangle_from, to.triangle_count);
    plan.edge_over = take_over(from.edges, plan.drops_edge, to.edges, plan.edge_from, to.edge_count);
    return plan;
}

using TransitionTable = std::array<std::array<Transition, kConfigurations>, kConfigurations>;

constexpr TransitionTable compare_all() {
    TransitionTable table{};
    for (std::size_t from = 0; from < kConfigurations; ++from) {
        for (std::size_t to = 0; to < kConfigurations; ++to) table[from][to] = compare(kLayouts[from], kLayouts[to]);
    }
    return table;
}

inline constexpr TransitionTable kTransitions = compare_all();

constexpr std::array<std::array<Configuration, 8>, kConfigurations> choose_least_work() {
    std::array<std::array<Configuration, 8>, kConfigurations> chosen{};
    for (std::size_t from = 0; from < kConfigurations; ++from) {
        std::array<int, 8> least{};
        least.fill(1000);
        for (std::size_t to = 0; to < kConfigurations; ++to) {
            const std::size_t split = kLayouts[to].split;
            if (kTransitions[from][to].work >= least[split]) continue;
            least[split] = kTransitions[from][to].work;
            chosen[from][split] = static_cast<Configuration>(to);
        }
    }
    return chosen;
}

inline constexpr std::array<std::array<Configuration, 8>, kConfigurations> kMinimalChange = choose_least_work();

inline constexpr std::array<std::uint8_t, 8> kStateOfSplit = {0, 1, 2, 4, 3, 6, 5, 7};

}  // namespace selvedge::sim::configuration_tables
