#include "sim/body/surface_repair.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "sim/body/surface_bvh.h"
#include "sim/body/surface_pieces.h"
#include "sim/body/weld.h"
#include "sim/core/error.h"

namespace selvedge {

namespace {

void weld_vertices(Surface& surface, double distance, RepairReport& report) {
    const std::vector<int> same = weld(surface.x, distance);
    for (std::size_t i = 0; i < same.size(); ++i)
        if (same[i] != int(i)) ++report.welded_vertices;
    for (std::array<int, 3>& triangle : surface.triangles)
        for (int& v : triangle) v = same[std::size_t(v)];
}

// Those that lost a corner to welding, and all but the first of those on the same three vertices.
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
    for (const auto& [key, t] : keys) kept.push_back(t);
    std::sort(kept.begin(), kept.end());
    report.dropped_triangles += int(surface.triangles.size() - kept.size());
    std::vector<std::array<int, 3>> triangles;
    for (const std::size_t t : kept) triangles.push_back(surface.triangles[t]);
    surface.triangles = std::move(triangles);
}

double perimeter(const std::vector<Vec3d>& x, const std::vector<int>& loop) {
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        length += (x[std::size_t(loop[(i + 1) % loop.size()])] - x[std::size_t(loop[i])]).norm();
    return length;
}

Vec3d middle(const std::vector<Vec3d>& x, const std::vector<int>& loop) {
    Vec3d sum = Vec3d::Zero();
    for (const int v : loop) sum += x[std::size_t(v)];
    return sum / double(loop.size());
}

std::string centimetres(double metres) {
    return std::to_string(int(std::lround(metres * 100))) + " cm";
}

void judge_holes(const Surface& surface, const RepairOptions& options, SurfacePiece& piece) {
    for (const std::vector<int>& hole : piece.holes) {
        const double length = perimeter(surface.x, hole);
        if (length <= options.largest_hole || !piece.flaw.empty()) continue;
        const Vec3d at = middle(surface.x, hole);
        piece.flaw = "it is open: a hole of " + centimetres(length) + " round, at a height of " + centimetres(at.y());
    }
}

// A fan about the rim's mean, which runs against the rim.
void cap_holes(Surface& surface, SurfacePiece& piece, RepairReport& report) {
    for (const std::vector<int>& hole : piece.holes) {
        const int centre = int(surface.x.size());
        surface.x.push_back(middle(surface.x, hole));
        surface.origin.push_back(surface.origin[std::size_t(hole.front())]);
        for (std::size_t i = 0; i < hole.size(); ++i) {
            piece.triangles.push_back(int(surface.triangles.size()));
            surface.triangles.push_back({hole[(i + 1) % hole.size()], hole[i], centre});
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

bool lies_inside(const Surface& surface, const SurfacePiece& piece, const SurfaceBvh& main) {
    for (const int t : piece.triangles)
        for (const int v : surface.triangles[std::size_t(t)]) {
            const auto closest =
                main.closest(surface.x[std::size_t(v)].cast<float>(), std::numeric_limits<float>::infinity());
            if (!closest || closest->distance >= 0) return false;
        }
    return true;
}

SurfaceBvh tree_of(const Surface& surface, const SurfacePiece& piece) {
    Body body;
    body.x = surface.x;
    for (const int t : piece.triangles) body.triangles.push_back(surface.triangles[std::size_t(t)]);
    return SurfaceBvh(body);
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

std::string describe(const SurfacePiece& piece, const std::string& why) {
    return "a piece of " + std::to_string(piece.triangles.size()) + " triangles: " + why;
}

// Closes and turns each piece; those left without a flaw are kept.
std::vector<SurfacePiece> close_pieces(Surface& surface, std::vector<SurfacePiece> pieces, const std::string& file,
                                       const RepairOptions& options, RepairReport& report) {
    const std::size_t main = largest(surface, pieces);
    for (SurfacePiece& piece : pieces) {
        judge_holes(surface, options, piece);
        if (!piece.flaw.empty()) continue;
        cap_holes(surface, piece, report);
        turn_outward(surface, piece);
    }
    if (!pieces[main].flaw.empty()) throw InputError(file, "", "its surface cannot be closed: " + pieces[main].flaw);
    if (pieces.size() > 1) {
        const SurfaceBvh tree = tree_of(surface, pieces[main]);
        for (std::size_t i = 0; i < pieces.size(); ++i)
            if (i != main && pieces[i].flaw.empty() && lies_inside(surface, pieces[i], tree))
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

// The kept pieces' triangles one after another, and only the vertices that they use, in their old order.
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

Surface repair(Surface surface, const std::string& file, const RepairOptions& options, RepairReport& report) {
    report = {};
    surface.origin.clear();
    for (std::size_t v = 0; v < surface.x.size(); ++v) surface.origin.push_back(int(v));
    weld_vertices(surface, options.weld_distance, report);
    drop_degenerate(surface, report);
    if (surface.triangles.empty()) throw InputError(file, "", "its triangles have no area");

    const std::vector<std::array<int, 3>> before = surface.triangles;
    std::vector<SurfacePiece> pieces = find_pieces(surface.triangles);
    pieces = close_pieces(surface, std::move(pieces), file, options, report);
    report.pieces = int(pieces.size());
    report.turned_triangles = count_turned(before, surface.triangles);
    return gather(surface, pieces);
}

}  // namespace selvedge
