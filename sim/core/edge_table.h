#pragma once
// The edges of a triangle mesh, each with the sides of triangles that lie on it: one at a border, two inside a surface,
// more where a surface is faulty.
#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace selvedge::sim {

// The side of a triangle from its corner k to the next.
template <class Index>
struct TriangleSide {
    Index low = 0, high = 0;  // its vertices
    Index triangle = 0;
    Index k = 0;
    bool rises = false;  // from the lower vertex to the higher one

    auto operator<=>(const TriangleSide&) const = default;
    // The corner at the lower or the higher vertex, 0..2.
    Index corner(bool at_low) const { return at_low == rises ? k : (k + 1) % 3; }
};

// Edges in the order of their vertices, lower ones first; the sides of an edge in the order of their triangles.
template <class Index>
class EdgeTable {
 public:
    using Edge = std::span<const TriangleSide<Index>>;  // never empty

    // vertices_of(triangle): its three vertices.
    template <class Triangles, class Get = std::identity>
    explicit EdgeTable(const Triangles& triangles, Get vertices_of = {}) {
        sides_.reserve(3 * std::size(triangles));
        Index t = 0;
        for (const auto& triangle : triangles) {
            const std::array<Index, 3>& v = std::invoke(vertices_of, triangle);
            for (Index k = 0; k < 3; ++k) {
                const Index from = v[static_cast<std::size_t>(k)], to = v[static_cast<std::size_t>((k + 1) % 3)];
                sides_.push_back({std::min(from, to), std::max(from, to), t, k, from < to});
            }
            ++t;
        }
        std::ranges::sort(sides_);
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            if (i == 0 || sides_[i].low != sides_[i - 1].low || sides_[i].high != sides_[i - 1].high) {
                first_.push_back(i);
            }
        }
        first_.push_back(sides_.size());
    }

    std::size_t size() const { return first_.size() - 1; }
    Edge operator[](std::size_t edge) const {
        return Edge(sides_).subspan(first_[edge], first_[edge + 1] - first_[edge]);
    }
    // All of them, as long as the table lives.
    std::vector<Edge> edges() const&& = delete;
    std::vector<Edge> edges() const& {
        std::vector<Edge> all;
        all.reserve(size());
        for (std::size_t e = 0; e < size(); ++e) all.push_back((*this)[e]);
        return all;
    }

 private:
    std::vector<TriangleSide<Index>> sides_;
    std::vector<std::size_t> first_;  // side of each edge, and the number of sides
};

}  // namespace selvedge::sim
