#include "sim/adaptive/orient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/core/disjoint_sets.h"

namespace selvedge::sim {
namespace {

// Triangles that belong together: their area and their lowest panel.
struct Sum {
    double area = 0;  // m^2
    int panel = std::numeric_limits<int>::max();

    void add(double more_area, int other_panel) {
        area += more_area;
        panel = std::min(panel, other_panel);
    }
};

// The pieces between right_wrong edges, each at the index of its lowest triangle.
struct Pieces {
    std::vector<std::size_t> of;                   // by triangle
    std::vector<std::vector<std::size_t>> beside;  // by piece: the pieces across its right_wrong edges
    std::vector<Sum> sum;                          // by piece
};

Pieces make_pieces(std::span<const OrientedEdge> edges, std::span<const OrientedTriangle> triangles) {
    DisjointSets sets(triangles.size());
    for (const OrientedEdge& edge : edges) {
        if (!edge.right_wrong) sets.join(static_cast<int>(edge.first), static_cast<int>(edge.second));
    }
    Pieces pieces;
    pieces.beside.resize(triangles.size());
    pieces.sum.resize(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        pieces.of.push_back(static_cast<std::size_t>(sets.find(static_cast<int>(t))));
        pieces.sum[pieces.of[t]].add(triangles[t].area, triangles[t].panel);
    }
    for (const OrientedEdge& edge : edges) {
        if (!edge.right_wrong) continue;
        pieces.beside[pieces.of[edge.first]].push_back(pieces.of[edge.second]);
        pieces.beside[pieces.of[edge.second]].push_back(pieces.of[edge.first]);
    }
    return pieces;
}

enum class Side : std::uint8_t { Unknown, Right, Turned };

// Orients the pieces that are connected with `first`, breadth first.
void orient_part(const Pieces& pieces, std::size_t first, std::vector<Side>& sides) {
    constexpr double kSame = 1e-3;  // relative difference of areas that may be due to rounding
    const auto opposite = [](Side side) { return side == Side::Right ? Side::Turned : Side::Right; };
    std::vector<std::size_t> found{first};
    Sum right, turned;
    sides[first] = Side::Right;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Sum& own = pieces.sum[found[i]];
        (sides[found[i]] == Side::Right ? right : turned).add(own.area, own.panel);
        for (const std::size_t next : pieces.beside[found[i]]) {
            if (sides[next] != Side::Unknown) continue;
            sides[next] = opposite(sides[found[i]]);
            found.push_back(next);
        }
    }
    const bool is_same = std::abs(right.area - turned.area) <= kSame * right.area;
    if (is_same ? right.panel <= turned.panel : right.area > turned.area) return;
    for (const std::size_t piece : found) sides[piece] = opposite(sides[piece]);
}

}  // namespace

std::vector<bool> find_turned(std::span<const OrientedEdge> edges, std::span<const OrientedTriangle> triangles) {
    const Pieces pieces = make_pieces(edges, triangles);
    std::vector<Side> sides(triangles.size(), Side::Unknown);
    std::vector<bool> is_turned;
    is_turned.reserve(triangles.size());
    for (const std::size_t piece : pieces.of) {
        if (sides[piece] == Side::Unknown) orient_part(pieces, piece, sides);
        is_turned.push_back(sides[piece] == Side::Turned);
    }
    return is_turned;
}

}  // namespace selvedge::sim
