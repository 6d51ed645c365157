#include "editor/geometry/seam_edit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "editor/geometry/draft.h"
#include "editor/geometry/edge_remap.h"
#include "editor/geometry/panel_edit.h"
#include "editor/geometry/sewing.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {
namespace {

std::array<Vec2d, 2> ends_on_sheet(const sim::Pattern& pattern, const sim::SeamSide& side, const Vec2d& origin) {
    const sim::Panel& panel = panel_of(pattern, side.panel);
    const sim::OutlineEdge& edge = edge_of(pattern, side);
    return {origin + panel.vertices[as_size(edge.start)], origin + panel.vertices[as_size(edge.end)]};
}

std::array<Vec3d, 2> ends_in_world(const sim::Pattern& pattern, const sim::SeamSide& side) {
    const sim::Panel& panel = panel_of(pattern, side.panel);
    const sim::OutlineEdge& edge = edge_of(pattern, side);
    return {panel.place(panel.vertices[as_size(edge.start)]), panel.place(panel.vertices[as_size(edge.end)])};
}

bool is_placed(const sim::Panel& panel) {
    return !panel.translation.isZero(0) || !panel.rotation.isIdentity(0);
}

bool do_cross(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
    const auto side = [](const Vec2d& from, const Vec2d& to, const Vec2d& p) {
        return sim::cross2(to - from, p - from);
    };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

// Crossing test: of the two ways to pair the ends, the pairing that crosses has the larger total length.
template <class Point>
bool is_longer_than_swapped(const std::array<Point, 2>& first, const std::array<Point, 2>& second) {
    const double paired = (first[0] - second[0]).norm() + (first[1] - second[1]).norm();
    const double swapped = (first[0] - second[1]).norm() + (first[1] - second[0]).norm();
    return paired > swapped * (1 + 1e-6) + 1e-9;
}

// Scales one side of a seam about the fixed point that equalize_seam describes.
class SideScaler {
 public:
    // `run`: consecutive edges of one panel, in outline order.
    SideScaler(sim::Pattern& draft, const std::vector<sim::SeamSide>& run, const std::vector<sim::SeamSide>& other)
        : draft_(draft), run_(run), other_(other) {}

    void scale(double factor) {
        sim::Panel& panel = draft_.panels[as_size(run_.front().panel)];
        const int first = edge_of(draft_, run_.front()).start, last = edge_of(draft_, run_.back()).end;
        const int count = edge_count(panel);
        const int before = edge_before(panel, run_.front().edge);
        const int after = (run_.back().edge + 1) % count;
        const bool start_holds = holds_other(first);
        const bool end_holds = holds_other(last);
        if (start_holds && end_holds) {
            throw GeometryError("Both ends of the edge are ends of the other side too.",
                                {place_of(draft_, run_.front())});
        }
        const bool is_start_free = !start_holds && !seam_at(draft_, {run_.front().panel, before});
        const bool is_end_free = !end_holds && !seam_at(draft_, {run_.back().panel, after});
        const Vec2d start = panel.vertices[as_size(first)];
        const Vec2d end = panel.vertices[as_size(last)];
        Vec2d centre = (start + end) / 2;
        if (start_holds || (is_end_free && !is_start_free)) centre = start;
        if (end_holds || (is_start_free && !is_end_free)) centre = end;
        sim::VertexMove move{std::vector<bool>(panel.vertices.size(), false), Eigen::Affine2d::Identity()};
        for (const sim::SeamSide& side : run_) {
            const sim::OutlineEdge& edge = edge_of(draft_, side);
            move.is_moved[as_size(edge.start)] = move.is_moved[as_size(edge.end)] = true;
        }
        move.map.linear() *= factor;
        move.map.translation() = centre - factor * centre;
        move_outline(panel, move);
    }

 private:
    bool holds_other(int vertex) const {
        return std::any_of(other_.begin(), other_.end(), [&](const sim::SeamSide& side) {
            const sim::OutlineEdge& edge = edge_of(draft_, side);
            return side.panel == run_.front().panel && (edge.start == vertex || edge.end == vertex);
        });
    }

    sim::Pattern& draft_;
    const std::vector<sim::SeamSide>& run_;
    const std::vector<sim::SeamSide>& other_;
};

}  // namespace

int sew_edges(sim::Pattern& pattern, const sim::Seam& seam) {
    if (seam.first == seam.second) {
        throw GeometryError("An edge is not sewn to itself.", {place_of(pattern, seam.first)});
    }
    for (const sim::SeamSide& side : {seam.first, seam.second}) {
        edge_of(pattern, side);
        const auto found = seam_at(pattern, side);
        if (!found) continue;
        throw GeometryError("This edge of panel " + panel_of(pattern, side.panel).name + " is sewn already, by seam " +
                                seam_name(pattern, pattern.seams[as_size(*found)]) + ".",
                            {place_of(pattern, side)});
    }
    return edit_pattern(pattern, [&](sim::Pattern& draft) {
        draft.seams.push_back(seam);
        return static_cast<int>(draft.seams.size()) - 1;
    });
}

void remove_seams(sim::Pattern& pattern, std::vector<int> seams) {
    for (const int seam : seams) seam_of(pattern, seam);
    std::sort(seams.begin(), seams.end());
    seams.erase(std::unique(seams.begin(), seams.end()), seams.end());
    for (auto seam = seams.rbegin(); seam != seams.rend(); ++seam) pattern.seams.erase(pattern.seams.begin() + *seam);
}

std::array<double, 2> seam_lengths(const sim::Pattern& pattern, const sim::Seam& seam) {
    return {outline_length(panel_of(pattern, seam.first.panel), edge_of(pattern, seam.first)),
            outline_length(panel_of(pattern, seam.second.panel), edge_of(pattern, seam.second))};
}

void equalize_seam(sim::Pattern& pattern, int seam) {
    edit_pattern(pattern, [&](sim::Pattern& draft) {
        const std::vector<int> seams = sewing_of(draft, seam);
        const std::vector<sim::SeamSide> first = edges_of_run(draft, seams, SewingRun::First);
        const std::vector<sim::SeamSide> second = edges_of_run(draft, seams, SewingRun::Second);
        const int panel = second.front().panel;
        for (std::size_t i = 1; i < second.size(); ++i) {
            const int next = (second[i - 1].edge + 1) % edge_count(draft.panels[as_size(panel)]);
            if (second[i] == sim::SeamSide{panel, next}) continue;
            throw GeometryError("The second side has parts on several panels or apart: even it by hand.",
                                {place_of(draft, second[i])});
        }
        const auto [length, other_length] = sewing_lengths(draft, seam);
        SideScaler(draft, second, first).scale(length / other_length);
        for (const int part : seams) draft.seams[as_size(part)].is_eased = false;
    });
}

bool is_crossed(const sim::Pattern& pattern, const sim::Seam& seam) {
    const sim::Panel& first = panel_of(pattern, seam.first.panel);
    const sim::Panel& second = panel_of(pattern, seam.second.panel);
    if (is_placed(first) && is_placed(second)) {
        std::array<Vec3d, 2> ends = ends_in_world(pattern, seam.second);
        if (seam.is_reversed) std::swap(ends[0], ends[1]);
        return is_longer_than_swapped(ends_in_world(pattern, seam.first), ends);
    }
    const std::vector<Vec2d> origins = sheet_positions(pattern);
    const std::array<Vec2d, 2> own = ends_on_sheet(pattern, seam.first, origins[as_size(seam.first.panel)]);
    std::array<Vec2d, 2> ends = ends_on_sheet(pattern, seam.second, origins[as_size(seam.second.panel)]);
    if (seam.is_reversed) std::swap(ends[0], ends[1]);
    if (seam.first.panel == seam.second.panel) return is_longer_than_swapped(own, ends);
    return do_cross(own[0], ends[0], own[1], ends[1]);
}

// Sewing one run of edges to another (1:N).

namespace {

constexpr double kJointSnap = 1e-4;  // m, joints closer than this are merged
constexpr double kSame = 1e-9;       // fractions closer than this are equal

// A run of spans with the position of each joint as a fraction of the run's length.
struct Run {
    std::vector<EdgeSpan> spans;
    std::vector<double> reached;  // 0, then the position at the end of each span
    double length = 0;            // m
};

Run measured(const sim::Pattern& pattern, const std::vector<EdgeSpan>& spans) {
    if (spans.empty()) throw GeometryError("One side of the seam is empty.");
    Run run{spans, {0}, 0};
    for (EdgeSpan& span : run.spans) {
        const sim::SeamSide side{span.panel, span.edge};
        const double length = outline_length(panel_of(pattern, span.panel), edge_of(pattern, side));
        if (!(span.from >= 0 && span.from < span.to && span.to <= 1)) {
            throw GeometryError("The part of the edge that is to be sewn has no length.", {place_of(pattern, side)});
        }
        if (span.from * length < kJointSnap) span.from = 0;
        if ((1 - span.to) * length < kJointSnap) span.to = 1;
        if (seam_at(pattern, side)) {
            throw GeometryError("This edge of panel " + panel_of(pattern, span.panel).name + " is sewn already.",
                                {place_of(pattern, side)});
        }
        run.length += length * (span.to - span.from);
        run.reached.push_back(run.length);
    }
    for (double& reached : run.reached) reached /= run.length;
    return run;
}

// A joint: its position on each run, as a fraction of the run's length.
struct Joint {
    double first = 0;
    double second = 0;
};

std::vector<Joint> joints_of(const Run& first, const Run& second, bool is_reversed) {
    const auto across = [&](double share) { return is_reversed ? 1 - share : share; };
    const double snap = kJointSnap / std::min(first.length, second.length);
    std::vector<Joint> joints;
    for (const double share : first.reached) joints.push_back({share, across(share)});
    for (const double share : second.reached) {
        const auto near = std::find_if(joints.begin(), joints.end(), [&](const Joint& joint) {
            return std::abs(joint.first - across(share)) < snap;
        });
        if (near != joints.end()) {
            near->second = share;
        } else {
            joints.push_back({across(share), share});
        }
    }
    std::sort(joints.begin(), joints.end(), [](const Joint& a, const Joint& b) { return a.first < b.first; });
    return joints;
}

// The part of a span between two fractions of the run's length. Pre: no joint lies between them.
EdgeSpan piece_of(const Run& run, double low, double high) {
    const double middle = (low + high) / 2;
    const auto above = std::upper_bound(run.reached.begin() + 1, run.reached.end() - 1, middle);
    const auto i = static_cast<std::size_t>(above - run.reached.begin() - 1);
    EdgeSpan piece = run.spans[i];
    const double begin = run.reached[i];
    const double width = run.reached[i + 1] - begin;
    const double size = piece.to - piece.from;
    if (high < run.reached[i + 1] - kSame) piece.to = piece.from + size * (high - begin) / width;
    if (low > begin + kSame) piece.from += size * (low - begin) / width;
    return piece;
}

// Splits edges at the ends of the pieces and returns the new edge index of each piece.
class PieceCutter {
 public:
    explicit PieceCutter(const std::vector<EdgeSpan>& pieces) {
        for (const EdgeSpan& piece : pieces) {
            std::vector<double>& cuts = cuts_[{piece.panel, piece.edge}];
            for (const double t : {piece.from, piece.to}) {
                const bool is_known =
                    std::any_of(cuts.begin(), cuts.end(), [&](double cut) { return std::abs(cut - t) < kSame; });
                if (t > 0 && t < 1 && !is_known) cuts.push_back(t);
            }
            std::sort(cuts.begin(), cuts.end());
        }
    }

    // From the last cut to the first, so that edges that are not split yet keep their indices.
    void cut(sim::Pattern& draft) const {
        for (auto entry = cuts_.rbegin(); entry != cuts_.rend(); ++entry) {
            double whole = 1;
            for (auto t = entry->second.rbegin(); t != entry->second.rend(); ++t) {
                split_alone(draft, entry->first, *t / whole);
                whole = *t;
            }
        }
    }

    sim::SeamSide edge_of_piece(const EdgeSpan& piece) const {
        int edge = piece.edge;
        for (const auto& [side, cuts] : cuts_) {
            if (side.panel != piece.panel || side.edge > piece.edge) continue;
            const double until = side.edge < piece.edge ? 1 : piece.from + kSame;
            edge += static_cast<int>(std::count_if(cuts.begin(), cuts.end(), [&](double t) { return t <= until; }));
        }
        return {piece.panel, edge};
    }

 private:
    std::map<sim::SeamSide, std::vector<double>> cuts_;  // fractions of the edge's length, ascending
};

void check_disjoint(const sim::Pattern& pattern, std::vector<EdgeSpan> pieces) {
    std::sort(pieces.begin(), pieces.end(), [](const EdgeSpan& a, const EdgeSpan& b) {
        return std::tie(a.panel, a.edge, a.from) < std::tie(b.panel, b.edge, b.from);
    });
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const EdgeSpan& one = pieces[i - 1];
        const EdgeSpan& next = pieces[i];
        if (one.panel != next.panel || one.edge != next.edge || next.from >= one.to - kSame) continue;
        throw GeometryError("A part of an edge would be sewn twice.", {place_of(pattern, {next.panel, next.edge})});
    }
}

}  // namespace

std::vector<int> sew_runs(sim::Pattern& pattern, const std::vector<EdgeSpan>& first,
                          const std::vector<EdgeSpan>& second, bool is_reversed) {
    const Run run = measured(pattern, first);
    const Run other = measured(pattern, second);
    const std::vector<Joint> joints = joints_of(run, other, is_reversed);
    std::vector<EdgeSpan> pieces;
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const auto [low, high] = std::minmax(joints[i].second, joints[i + 1].second);
        pieces.push_back(piece_of(run, joints[i].first, joints[i + 1].first));
        pieces.push_back(piece_of(other, low, high));
    }
    check_disjoint(pattern, pieces);
    const PieceCutter cutter(pieces);
    return edit_pattern(pattern, [&](sim::Pattern& draft) {
        cutter.cut(draft);
        std::vector<int> seams;
        for (std::size_t i = 0; i < pieces.size(); i += 2) {
            seams.push_back(static_cast<int>(draft.seams.size()));
            draft.seams.push_back({.first = cutter.edge_of_piece(pieces[i]),
                                   .second = cutter.edge_of_piece(pieces[i + 1]),
                                   .is_reversed = is_reversed});
        }
        if (seams.size() > 1) {
            const std::string name = free_sewing_name(draft);
            for (const int seam : seams) draft.seams[as_size(seam)].sewing = name;
        }
        return seams;
    });
}

}  // namespace selvedge::editor
