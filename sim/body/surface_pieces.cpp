#include "sim/body/surface_pieces.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>

namespace selvedge {

namespace {

constexpr int kNone = -1;

// A triangle's side k runs from its corner k to the next. Sorted, the sides at an undirected edge are neighbours.
struct Side {
    int low;
    int high;
    int triangle;
    int k;
    auto operator<=>(const Side&) const = default;
    bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Side> sorted_sides(const Triangles& triangles) {
    std::vector<Side> sides;
    sides.reserve(triangles.size() * 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
            sides.push_back({low, high, int(t), int(k)});
        }
    std::sort(sides.begin(), sides.end());
    return sides;
}

// Triangles joined over edges, however many meet there.
class Groups {
 public:
    explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
    int find(int i) {
        while (parent_[std::size_t(i)] != i) {
            int& parent = parent_[std::size_t(i)];
            parent = parent_[std::size_t(parent)];
            i = parent;
        }
        return i;
    }
    void join(int a, int b) {
        const int root_a = find(a);
        const int root_b = find(b);
        parent_[std::size_t(std::max(root_a, root_b))] = std::min(root_a, root_b);
    }

 private:
    std::vector<int> parent_;
};

struct Topology {
    std::vector<std::array<int, 3>> neighbours;  // over side k; kNone at a boundary or where more than two meet
    std::vector<int> piece;                      // per triangle
    std::vector<SurfacePiece> pieces;
};

Topology connect(const Triangles& triangles) {
    const std::vector<Side> sides = sorted_sides(triangles);
    Topology topology;
    topology.neighbours.assign(triangles.size(), {kNone, kNone, kNone});
    Groups groups(triangles.size());
    std::vector<int> crowded;  // a triangle of each edge where more than two meet
    for (std::size_t first = 0; first < sides.size();) {
        std::size_t last = first + 1;
        while (last < sides.size() && sides[last].same_edge(sides[first])) ++last;
        for (std::size_t i = first + 1; i < last; ++i) groups.join(sides[first].triangle, sides[i].triangle);
        if (last - first == 2) {
            const Side& a = sides[first];
            const Side& b = sides[first + 1];
            topology.neighbours[std::size_t(a.triangle)][std::size_t(a.k)] = b.triangle;
            topology.neighbours[std::size_t(b.triangle)][std::size_t(b.k)] = a.triangle;
        }
        if (last - first > 2) crowded.push_back(sides[first].triangle);
        first = last;
    }
    std::map<int, int> piece_of_group;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto [found, is_new] = piece_of_group.try_emplace(groups.find(int(t)), int(topology.pieces.size()));
        if (is_new) topology.pieces.emplace_back();
        topology.piece.push_back(found->second);
        topology.pieces[std::size_t(found->second)].triangles.push_back(int(t));
    }
    for (const int t : crowded)
        topology.pieces[std::size_t(topology.piece[std::size_t(t)])].flaw = "more than two triangles meet at an edge";
    return topology;
}

bool has_directed_edge(const std::array<int, 3>& triangle, int from, int to) {
    for (std::size_t k = 0; k < 3; ++k)
        if (triangle[k] == from && triangle[(k + 1) % 3] == to) return true;
    return false;
}

// Whether both triangles run along their common edge in opposite directions, as neighbours should.
bool agree(const std::array<int, 3>& a, const std::array<int, 3>& b) {
    for (std::size_t k = 0; k < 3; ++k)
        if (has_directed_edge(b, a[(k + 1) % 3], a[k])) return true;
    return false;
}

// Spreads the first triangle's side over its piece.
void orient(Triangles& triangles, const Topology& topology, std::vector<bool>& is_set, SurfacePiece& piece) {
    std::vector<int> waiting{piece.triangles.front()};
    is_set[std::size_t(waiting.front())] = true;
    while (!waiting.empty()) {
        const std::size_t t = std::size_t(waiting.back());
        waiting.pop_back();
        for (const int n : topology.neighbours[t]) {
            if (n == kNone) continue;
            std::array<int, 3>& neighbour = triangles[std::size_t(n)];
            const bool is_new = !is_set[std::size_t(n)];
            if (is_new) waiting.push_back(n);
            is_set[std::size_t(n)] = true;
            if (agree(triangles[t], neighbour)) continue;
            if (!is_new) {
                piece.flaw = "it has one side only";
                return;
            }
            std::swap(neighbour[1], neighbour[2]);
        }
    }
}

// Boundary edges chained to loops. Where a vertex has several, the path is cut at its first return, so that no loop
// visits a vertex twice.
std::vector<std::vector<int>> chain(std::multimap<int, int> edges) {
    std::vector<std::vector<int>> loops;
    while (!edges.empty()) {
        std::vector<int> path{edges.begin()->first};
        std::map<int, std::size_t> place{{path.front(), 0}};
        for (auto edge = edges.begin(); edge != edges.end(); edge = edges.find(path.back())) {
            const int next = edge->second;
            edges.erase(edge);
            const auto seen = place.find(next);
            if (seen == place.end()) {
                place[next] = path.size();
                path.push_back(next);
                continue;
            }
            const std::size_t from = seen->second;
            loops.emplace_back(path.begin() + std::ptrdiff_t(from), path.end());
            for (std::size_t i = from + 1; i < path.size(); ++i) place.erase(path[i]);
            path.resize(from + 1);
        }
    }
    return loops;
}

// Pre: no edge of the piece is crowded, so that one without a neighbour is a boundary. The neighbours are those of the
// sides before triangles were turned, hence found anew by their vertices.
std::vector<std::vector<int>> find_holes(const Triangles& triangles, const Topology& topology,
                                         const SurfacePiece& piece) {
    std::multimap<int, int> edges;
    for (const int t : piece.triangles) {
        const std::array<int, 3>& triangle = triangles[std::size_t(t)];
        const std::array<int, 3>& neighbours = topology.neighbours[std::size_t(t)];
        if (std::find(neighbours.begin(), neighbours.end(), kNone) == neighbours.end()) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto has_edge = [&](int n) {
                return n != kNone && has_directed_edge(triangles[std::size_t(n)], triangle[(k + 1) % 3], triangle[k]);
            };
            if (std::none_of(neighbours.begin(), neighbours.end(), has_edge))
                edges.emplace(triangle[k], triangle[(k + 1) % 3]);
        }
    }
    return chain(std::move(edges));
}

}  // namespace

std::vector<SurfacePiece> find_pieces(Triangles& triangles) {
    Topology topology = connect(triangles);
    std::vector<bool> is_set(triangles.size(), false);
    for (SurfacePiece& piece : topology.pieces) {
        if (piece.flaw.empty()) orient(triangles, topology, is_set, piece);
        if (piece.flaw.empty()) piece.holes = find_holes(triangles, topology, piece);
    }
    return std::move(topology.pieces);
}

double signed_volume6(const std::vector<Vec3d>& x, const Triangles& triangles, const SurfacePiece& piece) {
    // From a point of the piece, for less rounding.
    const Vec3d& from = x[std::size_t(triangles[std::size_t(piece.triangles.front())][0])];
    double sum = 0;
    for (const int t : piece.triangles) {
        const auto [a, b, c] = triangles[std::size_t(t)];
        sum += (x[std::size_t(a)] - from).dot((x[std::size_t(b)] - from).cross(x[std::size_t(c)] - from));
    }
    return sum;
}

double area(const std::vector<Vec3d>& x, const Triangles& triangles, const SurfacePiece& piece) {
    double sum = 0;
    for (const int t : piece.triangles) {
        const auto [a, b, c] = triangles[std::size_t(t)];
        sum += (x[std::size_t(b)] - x[std::size_t(a)]).cross(x[std::size_t(c)] - x[std::size_t(a)]).norm() / 2;
    }
    return sum;
}

}  // namespace selvedge
