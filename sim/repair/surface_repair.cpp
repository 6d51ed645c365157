#include "sim/repair/surface_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "sim/body/section.h"
#include "sim/core/assert.h"
#include "sim/core/disjoint_sets.h"
#include "sim/core/edge_table.h"
#include "sim/core/error.h"
#include "sim/core/printable.h"

namespace selvedge::sim {
namespace {

constexpr double kSamePlace = 1e-12;  // m, or in the unit of a file: coordinates that are equal in the file

// Merges only vertices on open edges. Vertices of parts that are closed already may come as near as they like.
void weld_open_edges(Surface& surface, double distance, RepairReport& report) {
    std::vector<bool> is_open(surface.x.size(), false);
    const EdgeTable<int> table(surface.triangles);
    for (const auto edge : table.edges()) {
        if (edge.size() == 1) is_open[std::size_t(edge[0].low)] = is_open[std::size_t(edge[0].high)] = true;
    }
    std::vector<int> vertices;
    std::vector<Vec3d> x;
    for (std::size_t v = 0; v < is_open.size(); ++v) {
        if (!is_open[v]) continue;
        vertices.push_back(int(v));
        x.push_back(surface.x[v]);
    }
    const std::vector<int> same = weld(x, distance);
    std::vector<int> replacement(surface.x.size());
    std::iota(replacement.begin(), replacement.end(), 0);
    for (std::size_t i = 0; i < same.size(); ++i) {
        replacement[std::size_t(vertices[i])] = vertices[std::size_t(same[i])];
        if (same[i] != int(i)) ++report.welded_vertices;
    }
    for (std::array<int, 3>& triangle : surface.triangles)
        for (int& v : triangle) v = replacement[std::size_t(v)];
}

// Drops triangles with a repeated vertex after welding, and duplicates: of those with the same vertices the first
// stays.
void drop_degenerate(Surface& surface, RepairReport& report) {
    std::vector<std::pair<std::array<int, 3>, std::size_t>> keys;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        std::array<int, 3> key = surface.triangles[t];
        std::sort(key.begin(), key.end());
        if (key[0] != key[1] && key[1] != key[2]) keys.emplace_back(key, t);
    }
    std::sort(keys.begin(), keys.end());
    const auto same_key = [](const auto& a, const auto& b) { return a.first == b.first; };
    keys.erase(std::unique(keys.begin(), keys.end(), same_key), keys.end());
    std::vector<std::size_t> kept;
    kept.reserve(keys.size());
    for (const auto& [key, t] : keys) kept.push_back(t);
    std::sort(kept.begin(), kept.end());
    report.dropped_triangles += int(surface.triangles.size() - kept.size());
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(kept.size());
    for (const std::size_t t : kept) triangles.push_back(surface.triangles[t]);
    surface.triangles = std::move(triangles);
}

Vec3d middle(const std::vector<Vec3d>& x, const std::vector<int>& loop) {
    Vec3d sum = Vec3d::Zero();
    for (const int v : loop) sum += x[std::size_t(v)];
    return sum / double(loop.size());
}

std::string centimetres(double metres) {
    return std::to_string(int(std::lround(metres * 100))) + " cm";
}

// The rim of a hole as a loop in its own plane.
struct Rim {
    SectionLoop loop;
    Plane plane;       // its normal points out of the hole
    double girth = 0;  // m, of its convex hull, or twice its reach if it is not flat: scans have ragged rims
};

Rim rim_of(const std::vector<Vec3d>& x, const std::vector<int>& hole) {
    Rim rim;
    rim.loop.centre = middle(x, hole);
    Vec3d area = Vec3d::Zero();
    for (std::size_t i = 0; i < hole.size(); ++i) {
        rim.loop.points.push_back(x[std::size_t(hole[i])]);
        const Vec3d a = rim.loop.points.back() - rim.loop.centre;
        area -= a.cross(x[std::size_t(hole[(i + 1) % hole.size()])] - rim.loop.centre) / 2;
    }
    rim.loop.area = area.norm();
    rim.plane = {.point = rim.loop.centre, .normal = rim.loop.area > 0 ? Vec3d(area / rim.loop.area) : Vec3d::UnitY()};
    Eigen::AlignedBox3d box;
    for (const Vec3d& p : rim.loop.points) box.extend(p);
    rim.girth = std::max(tape_length(rim.loop, rim.plane), 2 * box.sizes().maxCoeff());
    return rim;
}

// Whether a scan missed the top of a head there: a round hole that looks upward, all of it above the neck, no longer
// than a head is round.
bool is_crown(const Surface& surface, const RepairOptions& options, const std::vector<int>& hole) {
    // 574 mm round, 16 mm standard deviation for men (Gordon et al. 2014, Natick/TR-15/007); four of them, and hair.
    constexpr double kLargestHead = 0.66;  // m
    constexpr double kLeastCrown = 0.10;   // m: what is smaller may be flat
    constexpr double kRound = 0.7;         // of a circle's area for its length
    constexpr double kUpward = 0.8;        // cosine of the angle between the hole's normal and the vertical
    if (!options.head_from) return false;
    for (const int v : hole)
        if (surface.x[std::size_t(v)].y() < *options.head_from) return false;
    const Rim rim = rim_of(surface.x, hole);
    if (rim.girth < kLeastCrown || rim.girth > kLargestHead || std::abs(rim.plane.normal.y()) < kUpward) return false;
    return 4 * std::numbers::pi * rim.loop.area > kRound * rim.girth * rim.girth;
}

void judge_holes(const Surface& surface, const RepairOptions& options, SurfacePiece& piece) {
    for (const std::vector<int>& hole : piece.holes) {
        const Rim rim = rim_of(surface.x, hole);
        if (rim.girth <= options.largest_hole || !piece.flaw.empty() || is_crown(surface, options, hole)) continue;
        piece.flaw = "it is open: a hole of " + centimetres(rim.girth) + " round, at a height of " +
                     centimetres(rim.loop.centre.y());
    }
}

// Closes a hole with a triangle fan around a point, oriented consistently with the surface.
void add_fan(Surface& surface, SurfacePiece& piece, const std::vector<int>& hole, const Vec3d& tip) {
    const int centre = int(surface.x.size());
    surface.x.push_back(tip);
    surface.origin.push_back(surface.origin[std::size_t(hole.front())]);
    for (std::size_t i = 0; i < hole.size(); ++i) {
        piece.triangles.push_back(int(surface.triangles.size()));
        surface.triangles.push_back({hole[(i + 1) % hole.size()], hole[i], centre});
    }
}

// Half the mean of breadth and depth of a head, m: of the piece above a height.
double head_radius(const Surface& surface, const SurfacePiece& piece, double from) {
    Eigen::AlignedBox3d box;
    for (const int t : piece.triangles)
        for (const int v : surface.triangles[std::size_t(t)])
            if (surface.x[std::size_t(v)].y() >= from) box.extend(surface.x[std::size_t(v)]);
    return box.isEmpty() ? 0 : (box.sizes().x() + box.sizes().z()) / 4;
}

// Where a fan closes a hole: in the middle of its rim, or in a hollow, as at an armpit or a crotch that a scan did not
// see, farther in: where the surface would go on to if it ran straight from its rim to the middle.
Vec3d fan_tip(const Surface& surface, const SurfacePiece& piece, const std::vector<int>& hole) {
    constexpr double kLeastGirth = 0.2;  // m: of less, the middle is near enough
    constexpr double kHollow = 0.3;      // cosine, from which on the way goes against the surface's normals
    const Rim rim = rim_of(surface.x, hole);
    const Vec3d& centre = rim.loop.centre;
    if (rim.girth < kLeastGirth) return centre;
    const double side = signed_volume6(surface.x, surface.triangles, piece) < 0 ? -1 : 1;
    std::map<std::pair<int, int>, bool> is_rim;
    for (std::size_t i = 0; i < hole.size(); ++i) is_rim[{hole[i], hole[(i + 1) % hole.size()]}] = true;
    Vec3d way = Vec3d::Zero(), outward = Vec3d::Zero();
    double length = 0;
    for (const int t : piece.triangles) {
        const std::array<int, 3>& triangle = surface.triangles[std::size_t(t)];
        for (std::size_t k = 0; k < 3; ++k) {
            if (!is_rim.contains({triangle[k], triangle[(k + 1) % 3]})) continue;
            const Vec3d& from = surface.x[std::size_t(triangle[k])];
            const Vec3d edge = surface.x[std::size_t(triangle[(k + 1) % 3])] - from;
            const Vec3d normal = side * edge.cross(surface.x[std::size_t(triangle[(k + 2) % 3])] - from);
            if (!(normal.norm() > 0)) continue;
            const Vec3d into_hole = side * edge.cross(normal).normalized();
            const Vec3d middle = from + edge / 2;
            way += edge.norm() * (middle + (centre - middle).norm() * into_hole - centre);
            outward += edge.norm() * normal.normalized();
            length += edge.norm();
        }
    }
    // Soles go on downward, out of their hole, though the feet over them face upward.
    const bool is_hollow =
        way.dot(outward) < -kHollow * way.norm() * outward.norm() && side * way.dot(rim.plane.normal) < 0;
    return is_hollow && length > 0 ? Vec3d(centre + way / length) : centre;
}

// Closes the hole at a crown with rings that go on as an egg of the head's size.
void add_dome(Surface& surface, SurfacePiece& piece, const std::vector<int>& hole, double head) {
    constexpr int kRings = 6;
    Rim rim = rim_of(surface.x, hole);
    if (rim.plane.normal.y() < 0) rim.plane.normal = -rim.plane.normal;  // of a surface that is inside out
    const double across = std::sqrt(rim.loop.area / std::numbers::pi);
    // Of men's heads, half the height from chin to crown is 116 mm, a quarter of breadth and length together 88 mm
    // (Gordon et al. 2014, Natick/TR-15/007).
    constexpr double kTaller = 1.3;
    const double ball = std::max(head, across);
    const auto height_at = [&](double r) { return kTaller * std::sqrt(ball * ball - r * r); };
    std::vector<int> outer = hole;
    for (int ring = 1; ring < kRings; ++ring) {
        const double share = 1 - double(ring) / kRings;
        const Vec3d rise = (height_at(share * across) - height_at(across)) * rim.plane.normal;
        std::vector<int> inner;
        for (const int v : hole) {
            inner.push_back(int(surface.x.size()));
            surface.x.push_back(rim.loop.centre + share * (surface.x[std::size_t(v)] - rim.loop.centre) + rise);
            surface.origin.push_back(surface.origin[std::size_t(v)]);
        }
        for (std::size_t i = 0; i < hole.size(); ++i) {
            const std::size_t next = (i + 1) % hole.size();
            for (const std::array<int, 3>& triangle :
                 {std::array{outer[next], outer[i], inner[i]}, std::array{outer[next], inner[i], inner[next]}}) {
                piece.triangles.push_back(int(surface.triangles.size()));
                surface.triangles.push_back(triangle);
            }
        }
        outer = std::move(inner);
    }
    add_fan(surface, piece, outer, rim.loop.centre + (height_at(0) - height_at(across)) * rim.plane.normal);
}

void cap_holes(Surface& surface, const RepairOptions& options, SurfacePiece& piece, RepairReport& report) {
    for (const std::vector<int>& hole : piece.holes) {
        if (is_crown(surface, options, hole)) {
            add_dome(surface, piece, hole, head_radius(surface, piece, *options.head_from));
            ++report.capped_crowns;
        } else {
            add_fan(surface, piece, hole, fan_tip(surface, piece, hole));
        }
        ++report.capped_holes;
    }
    piece.holes.clear();
}

void turn_outward(Surface& surface, const SurfacePiece& piece) {
    if (signed_volume6(surface.x, surface.triangles, piece) >= 0) return;
    for (const int t : piece.triangles)
        std::swap(surface.triangles[std::size_t(t)][1], surface.triangles[std::size_t(t)][2]);
}

// The triangles of a closed surface, binned into columns along y so that a ray along y tests few of them.
class Columns {
 public:
    Columns(const Surface& surface, const SurfacePiece& piece) : surface_(surface) {
        for (const int t : piece.triangles)
            for (const int v : surface.triangles[std::size_t(t)]) {
                const Vec2d p = flat(v);
                low_ = low_.cwiseMin(p);
                high_ = high_.cwiseMax(p);
            }
        for (const int t : piece.triangles) {
            Vec2d low = Vec2d::Constant(std::numeric_limits<double>::infinity());
            Vec2d high = -low;
            for (const int v : surface.triangles[std::size_t(t)]) {
                low = low.cwiseMin(flat(v));
                high = high.cwiseMax(flat(v));
            }
            for (int i = column(low, 0); i <= column(high, 0); ++i)
                for (int j = column(low, 1); j <= column(high, 1); ++j)
                    columns_[std::size_t(i * kSide + j)].push_back(t);
        }
    }

    // Whether the upward ray from the vertex crosses the surface an odd number of times.
    bool encloses(int vertex) const {
        const Vec2d p = flat(vertex);
        if ((p.array() < low_.array()).any() || (p.array() > high_.array()).any()) return false;
        bool is_inside = false;
        for (const int t : columns_[std::size_t(column(p, 0) * kSide + column(p, 1))])
            if (is_above(t, p, surface_.x[std::size_t(vertex)].y())) is_inside = !is_inside;
        return is_inside;
    }

 private:
    static constexpr int kSide = 64;  // columns along x and along z

    Vec2d flat(int v) const { return {surface_.x[std::size_t(v)].x(), surface_.x[std::size_t(v)].z()}; }

    int column(const Vec2d& p, int axis) const {
        const double width = std::max(high_[axis] - low_[axis], std::numeric_limits<double>::min());
        return std::clamp(int((p[axis] - low_[axis]) / width * kSide), 0, kSide - 1);
    }

    // Whether p, a, b have positive orientation. The result for an edge a, b has the same bits for both of its
    // triangles, and zero counts as positive, so that a ray through an edge meets just one of them.
    bool is_left(const Vec2d& p, int a, int b) const {
        const bool is_turned = a > b;
        if (is_turned) std::swap(a, b);
        const Vec2d from = flat(a) - p;
        const Vec2d to = flat(b) - p;
        return (from.x() * to.y() - from.y() * to.x() >= 0) != is_turned;
    }

    bool is_above(int triangle, const Vec2d& p, double height) const {
        const auto [a, b, c] = surface_.triangles[std::size_t(triangle)];
        const bool is_left_of_first = is_left(p, a, b);
        if (is_left_of_first != is_left(p, b, c) || is_left_of_first != is_left(p, c, a)) return false;
        const Vec3d& at = surface_.x[std::size_t(a)];
        const Vec3d normal = (surface_.x[std::size_t(b)] - at).cross(surface_.x[std::size_t(c)] - at);
        if (normal.y() == 0) return false;
        return at.y() - (normal.x() * (p.x() - at.x()) + normal.z() * (p.y() - at.z())) / normal.y() > height;
    }

    const Surface& surface_;
    Vec2d low_ = Vec2d::Constant(std::numeric_limits<double>::infinity());
    Vec2d high_ = Vec2d::Constant(-std::numeric_limits<double>::infinity());
    std::vector<std::vector<int>> columns_ = std::vector<std::vector<int>>(std::size_t{kSide} * kSide);
};

bool lies_inside(const Surface& surface, const SurfacePiece& piece, const Columns& main) {
    for (const int t : piece.triangles)
        for (const int v : surface.triangles[std::size_t(t)])
            if (!main.encloses(v)) return false;
    return true;
}

std::size_t largest(const Surface& surface, const std::vector<SurfacePiece>& pieces) {
    std::size_t best = 0;
    double best_area = -1;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double piece_area = area(surface.x, surface.triangles, pieces[i]);
        if (piece_area > best_area) {
            best = i;
            best_area = piece_area;
        }
    }
    return best;
}

// The piece with the vertex nearest to a point.
std::size_t nearest(const Surface& surface, const std::vector<SurfacePiece>& pieces, const Vec3d& point) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (const int t : pieces[i].triangles)
            for (const int v : surface.triangles[std::size_t(t)]) {
                const double distance = (surface.x[std::size_t(v)] - point).squaredNorm();
                if (distance >= least) continue;
                best = i;
                least = distance;
            }
    }
    return best;
}

std::string describe(const SurfacePiece& piece, const std::string& why) {
    return "a piece of " + count_text(piece.triangles.size(), "triangle") + ": " + why;
}

// Closes and orients each piece; returns the pieces without a flaw.
std::vector<SurfacePiece> close_pieces(Surface& surface, std::vector<SurfacePiece> pieces, const std::string& file,
                                       const RepairOptions& options, RepairReport& report) {
    const std::size_t main = options.main_at ? nearest(surface, pieces, *options.main_at) : largest(surface, pieces);
    for (SurfacePiece& piece : pieces) {
        judge_holes(surface, options, piece);
        if (!piece.flaw.empty()) continue;
        cap_holes(surface, options, piece, report);
        turn_outward(surface, piece);
    }
    if (!pieces[main].flaw.empty()) throw InputError(file, "", "its surface cannot be closed: " + pieces[main].flaw);
    if (pieces.size() > 1) {
        const Columns columns(surface, pieces[main]);
        for (std::size_t i = 0; i < pieces.size(); ++i)
            if (i != main && pieces[i].flaw.empty() && lies_inside(surface, pieces[i], columns))
                pieces[i].flaw = "it lies inside the body";
    }
    std::vector<SurfacePiece> kept;
    for (SurfacePiece& piece : pieces) {
        if (piece.flaw.empty())
            kept.push_back(std::move(piece));
        else
            report.dropped_pieces.push_back(describe(piece, piece.flaw));
    }
    return kept;
}

// Concatenates the kept pieces' triangles; keeps only the vertices that they use, in their original order.
Surface gather(const Surface& surface, const std::vector<SurfacePiece>& pieces) {
    std::vector<int> place(surface.x.size(), -1);
    for (const SurfacePiece& piece : pieces)
        for (const int t : piece.triangles)
            for (const int v : surface.triangles[std::size_t(t)]) place[std::size_t(v)] = 0;
    Surface gathered;
    for (std::size_t v = 0; v < surface.x.size(); ++v) {
        if (place[v] < 0) continue;
        place[v] = int(gathered.x.size());
        gathered.x.push_back(surface.x[v]);
        gathered.origin.push_back(surface.origin[v]);
    }
    for (const SurfacePiece& piece : pieces)
        for (const int t : piece.triangles) {
            std::array<int, 3> triangle = surface.triangles[std::size_t(t)];
            for (int& v : triangle) v = place[std::size_t(v)];
            gathered.triangles.push_back(triangle);
        }
    return gathered;
}

int count_turned(const std::vector<std::array<int, 3>>& before, const std::vector<std::array<int, 3>>& after) {
    int turned = 0;
    for (std::size_t t = 0; t < before.size(); ++t)
        if (before[t] != after[t]) ++turned;
    return turned;
}

}  // namespace

void weld_surface(Surface& surface, double distance, RepairReport& report) {
    surface.origin.clear();
    for (std::size_t v = 0; v < surface.x.size(); ++v) surface.origin.push_back(int(v));
    // Readers split vertices at seams of their texture, and some files share none: copies at one place come first.
    for (const double near : {std::min(kSamePlace, distance), distance}) {
        weld_open_edges(surface, near, report);
        drop_degenerate(surface, report);
    }
    report.cuts = cut_crowded_edges(surface.x, surface.origin, surface.triangles);
}

Surface repair(Surface surface, const std::string& file, const RepairOptions& options, RepairReport& report) {
    report = {};
    weld_surface(surface, options.weld_distance, report);
    if (surface.triangles.empty()) throw InputError(file, "", "its triangles have no area");

    const std::vector<std::array<int, 3>> before = surface.triangles;
    std::vector<SurfacePiece> pieces = find_pieces(surface.triangles);
    pieces = close_pieces(surface, std::move(pieces), file, options, report);
    report.pieces = int(pieces.size());
    report.turned_triangles = count_turned(before, surface.triangles);
    return gather(surface, pieces);
}

namespace {

constexpr int kNone = -1;

struct Topology {
    std::vector<std::array<int, 3>> neighbours;  // across side k; kNone at a boundary
    std::vector<int> piece;                      // per triangle
    std::vector<SurfacePiece> pieces;
};

Topology connect(const Triangles& triangles) {
    const EdgeTable<int> table(triangles);
    Topology topology;
    topology.neighbours.assign(triangles.size(), {kNone, kNone, kNone});
    DisjointSets groups(triangles.size());
    for (const auto edge : table.edges()) {
        SELVEDGE_ASSERT(edge.size() <= 2);
        if (edge.size() < 2) continue;
        const auto &a = edge[0], &b = edge[1];
        groups.join(a.triangle, b.triangle);
        topology.neighbours[std::size_t(a.triangle)][std::size_t(a.k)] = b.triangle;
        topology.neighbours[std::size_t(b.triangle)][std::size_t(b.k)] = a.triangle;
    }
    std::map<int, int> piece_of_group;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto [found, is_new] = piece_of_group.try_emplace(groups.find(int(t)), int(topology.pieces.size()));
        if (is_new) topology.pieces.emplace_back();
        topology.piece.push_back(found->second);
        topology.pieces[std::size_t(found->second)].triangles.push_back(int(t));
    }
    return topology;
}

bool has_directed_edge(const std::array<int, 3>& triangle, int from, int to) {
    for (std::size_t k = 0; k < 3; ++k)
        if (triangle[k] == from && triangle[(k + 1) % 3] == to) return true;
    return false;
}

// Whether the triangles traverse their common edge in opposite directions, as consistently oriented neighbours do.
bool agree(const std::array<int, 3>& a, const std::array<int, 3>& b) {
    for (std::size_t k = 0; k < 3; ++k)
        if (has_directed_edge(b, a[(k + 1) % 3], a[k])) return true;
    return false;
}

// Propagates the orientation of the piece's first triangle over the piece.
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

// Chains boundary edges into loops. Where a vertex has several boundary edges, a loop is split off when the path
// returns to a vertex, so that no loop visits a vertex twice.
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

// topology.neighbours follows the side numbers before triangles were flipped, so each side's neighbour is found again
// by its vertices.
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
    // Relative to a point of the piece, to reduce rounding errors.
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

namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
    std::size_t operator()(const Cell& cell) const noexcept {
        std::uint64_t hash = 0;
        for (const std::int64_t part : cell) hash = (hash ^ std::uint64_t(part)) * 0x9E3779B97F4A7C15U + (hash >> 29U);
        return std::size_t(hash);
    }
};

// The representatives, hashed by cell. Cells are 8 times the distance wide, so most searches visit one cell. No result
// depends on the order of the hash map.
class Representatives {
 public:
    Representatives(const std::vector<Vec3d>& x, double distance) : x_(x), distance_(distance), next_(x.size(), kNone) {
        cells_.reserve(x.size());
    }

    int find_or_add(int point) {
        const Vec3d& p = x_[std::size_t(point)];
        const Cell low = cell_of(p - Vec3d::Constant(distance_));
        const Cell high = cell_of(p + Vec3d::Constant(distance_));
        int best = kNone;
        Cell cell{};
        for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
            for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
                for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2]) best = earlier(best, search(cell, p));
        if (best != kNone) return best;
        const auto [head, is_new] = cells_.try_emplace(cell_of(p), kNone);
        next_[std::size_t(point)] = head->second;
        head->second = point;
        return point;
    }

 private:
    static constexpr int kNone = -1;

    static int earlier(int a, int b) { return a == kNone ? b : (b == kNone ? a : std::min(a, b)); }

    Cell cell_of(const Vec3d& p) const {
        const Vec3d scaled = p / (8 * distance_);
        return {std::int64_t(std::floor(scaled.x())), std::int64_t(std::floor(scaled.y())),
                std::int64_t(std::floor(scaled.z()))};
    }

    int search(const Cell& cell, const Vec3d& p) const {
        const auto head = cells_.find(cell);
        int best = kNone;
        for (int i = head == cells_.end() ? kNone : head->second; i != kNone; i = next_[std::size_t(i)])
            if ((x_[std::size_t(i)] - p).norm() <= distance_) best = earlier(best, i);
        return best;
    }

    const std::vector<Vec3d>& x_;
    double distance_;
    std::vector<int> next_;  // next representative in the same cell
    std::unordered_map<Cell, int, CellHash> cells_;
};

}  // namespace

std::vector<int> weld(const std::vector<Vec3d>& x, double distance) {
    SELVEDGE_ASSERT(distance > 0);
    Representatives representatives(x, distance);
    std::vector<int> same(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) same[i] = representatives.find_or_add(int(i));
    return same;
}

}  // namespace selvedge::sim
