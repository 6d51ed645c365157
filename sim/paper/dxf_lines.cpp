#include "sim/paper/dxf_lines.h"

#include <algorithm>
#include <set>

#include "sim/core/error.h"
#include "sim/paper/dxf_layers.h"
#include "sim/paper/polyline_outline.h"
#include "sim/pattern/polyline.h"

namespace selvedge::sim {
namespace {

using PointList = std::vector<Vec2d>;

constexpr std::size_t kMostJoined = 20000;  // open lines of a layer: more are a hatching

// A run of a joined line: consecutive points between two ends that are corners.
struct Run {
    PointList points;
    bool is_segments = false;  // of LINEs, which may be pieces of a curve
};

// The links of a chain as one closed line. LINEs side by side are one run, for they may be pieces of a curve: its
// corners are found by its turns. Where other lines meet is a corner.
DxfLine chained(const std::vector<const DxfLine*>& lines, const ClosedChain& chain) {
    DxfLine out = *lines.front();
    out.points.clear();
    out.corners.clear();
    std::vector<Run> runs;
    for (std::size_t k = 0; k < chain.size(); ++k) {
        PointList points = lines[k]->points;
        if (chain[k].is_reversed) std::ranges::reverse(points);
        const bool goes_on = lines[k]->is_segment && !runs.empty() && runs.back().is_segments;
        if (!goes_on) runs.push_back({.points = {points.front()}, .is_segments = lines[k]->is_segment});
        runs.back().points.insert(runs.back().points.end(), points.begin() + 1, points.end());
    }
    for (const Run& run : runs) {
        const int first = static_cast<int>(out.points.size());
        if (runs.size() > 1) {
            for (const int corner : find_corners(run.points, false)) {
                if (as_size(corner) + 1 < run.points.size()) out.corners.push_back(first + corner);
            }
        }
        out.points.insert(out.points.end(), run.points.begin(), run.points.end() - 1);
    }
    out.points.push_back(out.points.front());
    out.is_closed = true;
    out.is_segment = false;
    return out;
}

// Puts the chains of some lines of a piece into their place.
void replace_with_chains(DxfPiece& piece, const std::vector<std::size_t>& members, const ClosedChains& found,
                         DxfJoints& joints) {
    std::set<std::size_t> used;
    for (const std::size_t i : found.repeated) used.insert(members[i]);
    std::vector<DxfLine> outlines;
    for (const ClosedChain& chain : found.chains) {
        std::vector<const DxfLine*> lines;
        for (const ChainLink& link : chain) {
            lines.push_back(&piece.lines[members[link.line]]);
            used.insert(members[link.line]);
        }
        outlines.push_back(chained(lines, chain));
        joints.outlines += chain.size() > 1 ? 1 : 0;
    }
    joints.widest_gap = std::max(joints.widest_gap, found.widest_gap);
    std::vector<DxfLine> kept;
    for (std::size_t i = 0; i < piece.lines.size(); ++i) {
        if (!used.contains(i)) kept.push_back(std::move(piece.lines[i]));
    }
    std::ranges::stable_sort(outlines, {}, &DxfLine::line);
    std::ranges::move(outlines, std::back_inserter(kept));
    piece.lines = std::move(kept);
}

std::vector<std::size_t> open_lines(const DxfPiece& piece, int layer) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < piece.lines.size(); ++i) {
        if (piece.lines[i].layer == layer && !piece.lines[i].is_closed) open.push_back(i);
    }
    return open;
}

void join_layer(DxfPiece& piece, int layer, double gap, DxfJoints& joints) {
    const std::vector<std::size_t> open = open_lines(piece, layer);
    if (open.empty() || open.size() > kMostJoined) return;
    std::vector<PointList> lines;
    for (const std::size_t i : open) lines.push_back(piece.lines[i].points);
    replace_with_chains(piece, open, find_closed_chains(lines, {.gap = gap}), joints);
}

// The largest of the areas into which open lines of the sewing layer divide the boundary.
void close_along_boundary(DxfPiece& piece, double gap, DxfJoints& joints) {
    const DxfLine* boundary = largest_closed(piece, kBoundaryLayer);
    const std::vector<std::size_t> open = open_lines(piece, kSewLayer);
    if (!boundary || open.empty() || open.size() > kMostJoined || largest_closed(piece, kSewLayer)) return;
    std::vector<PointList> lines{boundary->points};
    for (const std::size_t i : open) lines.push_back(piece.lines[i].points);
    const CutLines cut = cut_where_they_meet(lines, gap);
    const ClosedChains faces =
        find_closed_chains(cut.lines, {.gap = gap, .branches = Branches::Faces, .least_share = 0});
    const auto is_sewn = [&](const ClosedChain& chain) {
        return std::ranges::any_of(chain, [&](const ChainLink& link) { return cut.origin[link.line] > 0; });
    };
    const auto found = std::ranges::find_if(faces.chains, is_sewn);
    if (found == faces.chains.end()) return;
    std::vector<DxfLine> parts;
    for (const ChainLink& link : *found) {
        parts.push_back(piece.lines[open.front()]);
        parts.back().points = cut.lines[link.line];
        parts.back().is_segment = false;
    }
    std::vector<const DxfLine*> pointers;
    for (const DxfLine& part : parts) pointers.push_back(&part);
    DxfLine outline = chained(pointers, *found);
    std::erase_if(piece.lines, [](const DxfLine& line) { return line.layer == kSewLayer && !line.is_closed; });
    piece.lines.push_back(std::move(outline));
    ++joints.outlines;
}

// A boundary that ends at both ends of the fold line goes along it.
void close_along_fold(DxfPiece& piece, double gap, DxfJoints& joints) {
    if (largest_closed(piece, kBoundaryLayer)) return;
    std::vector<std::size_t> open = open_lines(piece, kBoundaryLayer);
    const std::vector<std::size_t> folds = open_lines(piece, kFoldLayer);
    if (open.empty() || folds.empty() || open.size() + folds.size() > kMostJoined) return;
    std::vector<PointList> lines;
    for (const std::size_t i : open) lines.push_back(piece.lines[i].points);
    const std::size_t first_copy = piece.lines.size();
    for (const std::size_t i : folds) {
        DxfLine copy = piece.lines[i];  // the fold line stays
        copy.layer = kBoundaryLayer;
        lines.push_back(copy.points);
        open.push_back(piece.lines.size());
        piece.lines.push_back(std::move(copy));
    }
    const ClosedChains found = find_closed_chains(lines, {.gap = gap});
    if (found.chains.empty()) {
        piece.lines.resize(first_copy);
        return;
    }
    replace_with_chains(piece, open, found, joints);
}

}  // namespace

double extent_of(const DxfLine& line) {
    const Eigen::AlignedBox2d box = box_around(line.points);
    return box.isEmpty() ? 0 : box.sizes().norm();
}

double gap_of(const DxfLine& line) {
    return line.is_closed ? 0 : (line.points.front() - line.points.back()).norm();
}

const DxfLine* largest_closed(const DxfPiece& piece, int layer) {
    const DxfLine* found = nullptr;
    for (const DxfLine& line : piece.lines) {
        if (line.layer != layer || !line.is_closed || line.points.size() < 4) continue;
        if (!found || extent_of(line) > extent_of(*found)) found = &line;
    }
    return found;
}

const DxfLine* find_sewing_line(const DxfPiece& piece) {
    if (const DxfLine* sewn = largest_closed(piece, kSewLayer)) return sewn;
    const DxfLine* boundary = largest_closed(piece, kBoundaryLayer);
    const DxfLine* inner = largest_closed(piece, kInternalLayer);
    constexpr double kNearly = 0.7;
    return boundary && inner && extent_of(*inner) > kNearly * extent_of(*boundary) ? inner : nullptr;
}

void join_outlines(DxfPiece& piece, double gap, DxfJoints& joints) {
    for (const int layer : {kBoundaryLayer, kSewLayer, kCutoutLayer}) join_layer(piece, layer, gap, joints);
    close_along_fold(piece, gap, joints);
    close_along_boundary(piece, gap, joints);
}

void join_loose(DxfPiece& loose, double gap, DxfJoints& joints) {
    std::vector<std::size_t> open;
    std::vector<KeyedLine> lines;
    for (std::size_t i = 0; i < loose.lines.size(); ++i) {
        const DxfLine& line = loose.lines[i];
        const LineKind kind = kind_of_layer(line.layer);
        if (line.is_closed || is_notch_layer(line.layer) || is_quality_layer(line.layer) ||
            kind == LineKind::FoldEdge || kind == LineKind::Grain)
            continue;
        open.push_back(i);
        lines.push_back({line.points, {line.style}});
    }
    if (open.empty() || open.size() > kMostJoined) return;
    replace_with_chains(loose, open, join_in_passes(lines, gap, {Branches::Faces, Branches::Faces}), joints);
}

DrawnPath as_drawn(const DxfLine& line, LineKind kind) {
    DrawnPath path;
    path.kind = kind;
    path.is_closed = line.is_closed;
    path.place = "line " + std::to_string(line.line);
    for (const Vec2d& p : line.points) {
        if (path.vertices.empty() || p != path.vertices.back()) path.vertices.push_back(p);
    }
    if (line.is_closed && path.vertices.size() > 1 && path.vertices.front() == path.vertices.back())
        path.vertices.pop_back();
    const int count = static_cast<int>(path.vertices.size());
    for (int i = 0; i + (line.is_closed ? 0 : 1) < count; ++i)
        path.edges.push_back({.start = i, .end = line.is_closed ? (i + 1) % count : i + 1});
    return path;
}

DrawnPath path_of(const DxfPiece& piece, const DxfLine& line, LineKind kind,
                  const std::optional<double>& metres_per_unit) {
    constexpr double kTolerance = 1e-4;  // m
    constexpr double kOnLine = 1e-4;     // of the line's size
    constexpr double kShare = 1e-4;      // of the line's size, where no unit is known
    PolylineOptions options{.tolerance = metres_per_unit ? kTolerance / *metres_per_unit : kShare * extent_of(line)};
    std::vector<Vec2d> points = line.points;
    if (line.is_closed && points.front() == points.back()) points.pop_back();
    const bool is_outline = kind == LineKind::Sew || kind == LineKind::Cut || kind == LineKind::Unknown;
    const double reach = kOnLine * extent_of(line);
    const bool has_turns = std::ranges::any_of(piece.points, [](const auto& one) { return one.first == kTurnLayer; });
    if (!has_turns || !is_outline) options.corners = line.corners;
    for (const std::pair<int, Vec2d>& point : piece.points) {
        const Vec2d& at = point.second;
        if (point.first != kTurnLayer || !is_outline) continue;
        const auto nearest = std::ranges::min_element(points, {}, [&](const Vec2d& p) { return (p - at).norm(); });
        if ((*nearest - at).norm() < reach) options.corners.push_back(static_cast<int>(nearest - points.begin()));
    }
    DrawnPath path = outline_of_points(points, line.is_closed, options);
    path.kind = kind;
    path.place = "line " + std::to_string(line.line);
    return path;
}

}  // namespace selvedge::sim
