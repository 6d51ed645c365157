#include "sim/paper/part_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/math.h"
#include "sim/paper/closed_chains.h"
#include "sim/paper/cut_line.h"
#include "sim/paper/drawing_unit.h"
#include "sim/paper/drawn_allowances.h"
#include "sim/paper/drawn_darts.h"
#include "sim/paper/drawn_outline.h"
#include "sim/paper/fold_edge.h"
#include "sim/paper/outline_place.h"
#include "sim/paper/outline_repair.h"
#include "sim/paper/path_builder.h"
#include "sim/paper/placement_record.h"
#include "sim/paper/polyline_outline.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr double kChordError = 1e-4;  // m, of lines from curves
constexpr double kLargestPanel = 30;  // m; further from the origin, panels are moved to it

std::string in_cm(double metres) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g cm", 100 * metres);
    return text.data();
}

DrawnPath scaled(DrawnPath path, double scale) {
    transform(path, Eigen::Affine2d(Eigen::Scaling(scale)));
    return path;
}

class PartReader {
 public:
    PartReader(const DrawnPart& part, const Drawing& drawing, double scale, const std::optional<double>& allowance,
               const std::string& file)
        : part_(part),
          scale_(scale),
          down_(drawing.is_y_down ? -1 : 1),
          has_seams_(!drawing.seams.empty()),
          allowance_(allowance),
          file_(file) {}

    PartPanel read() {
        read_.panel = panel();
        return std::move(read_);
    }

 private:
    // None: the part has no closed outline.
    std::optional<Panel> panel() {
        std::optional<Panel> outline = read_outline();
        if (!outline) return std::nullopt;
        panel_ = std::move(*outline);
        panel_.name = part_.name;
        check_outline();
        cut_darts();
        add_marks();
        add_grain();
        add_lines();
        unfold();
        lay_ribs();
        const Vec2d middle = outline_box(panel_).center();
        if (middle.norm() > kLargestPanel)
            panel_ = mapped_panel(panel_, Eigen::Affine2d(Eigen::Translation2d(-middle)));
        place();
        if (part_.cut.pieces) panel_.pieces = std::clamp(*part_.cut.pieces, 1, kMostPieces);
        return panel_;
    }

    Vec2d in_file(const Vec2d& place) const { return Vec2d(place.x(), down_ * place.y()) / scale_; }

    void note(const std::string& text) { read_.notes.push_back(part_.name + ": " + text); }

    const DrawnPath* largest(LineKind kind) const {
        const DrawnPath* found = nullptr;
        for (const DrawnPath& path : part_.paths) {
            if (path.kind != kind || !path.is_closed || path.edges.size() < 2) continue;
            if (!found || size_of(path) > size_of(*found)) found = &path;
        }
        return found;
    }

    // Without the small faults of its drawing, which are told.
    Panel mended(Panel panel) {
        if (panel.edges.size() < 3) return panel;
        const OutlineRepairs repairs = repair_outline(panel);
        if (!repairs.is_any()) return panel;
        drop_short_edges(panel);
        drop_unused_vertices(panel);
        if (repairs.retraced > 0) note("a line of the outline runs forth and back: taken off");
        if (repairs.slits > 0) note("edges of the outline lie on each other: moved apart by 0.2 mm");
        if (repairs.loops > 0) {
            const Vec2d at = in_file(repairs.place);
            std::array<char, 128> text{};
            std::snprintf(text.data(), text.size(),
                          "the outline crosses itself near (%.6g, %.6g): a loop of %s was cut off", at.x(), at.y(),
                          in_cm(repairs.longest_loop).c_str());
            note(text.data());
        }
        return panel;
    }

    std::optional<Panel> read_outline() {
        const DrawnPath* path = largest(LineKind::Cut);
        const DrawnPath* sewn = largest(LineKind::Sew);
        const auto joined = sewn ? std::nullopt : joined_outline(part_.paths, kJoinGap / scale_);
        if (joined) {
            note("the outline is drawn as lines that meet: joined");
            sewn = &joined->outline;
            joined_ = joined->used;
        }
        if (sewn) {
            read_.is_mirrored = sewn->edges.size() > 1 && outline_area(as_panel(scaled(*sewn, scale_))) < 0;
            Panel panel = mended(outline_of(scaled(*sewn, scale_)));
            if (panel.edges.size() >= 2) add_allowances(panel);
            if (!path || panel.edges.size() < 2 || find_outline_crossings(panel, {.most = 1}).empty()) return panel;
            const double width = distance_between(panel, outline_of(scaled(*path, scale_)));
            note("the sewing line crosses itself: taken from the cut line instead, " + in_cm(width) + " inside it");
            return inset_panel(outline_of(scaled(*path, scale_)), width);
        }
        const bool is_cut = path != nullptr;
        if (!path) path = largest(LineKind::Unknown);
        if (!path) return std::nullopt;
        Panel panel = mended(outline_of(scaled(*path, scale_)));
        if (panel.edges.size() < 2) return std::nullopt;
        panel.name = part_.name;
        if (!allowance_) {
            if (is_cut) note("only the cut line is drawn: taken as the sewing line; --allowance takes it off");
            return panel;
        }
        if (*allowance_ == 0) return panel;
        note("seam allowance of " + in_cm(*allowance_) + " taken off the cut line");
        Panel inner = inset_panel(panel, *allowance_);
        inner.allowance = *allowance_;
        return inner;
    }

    void add_allowances(Panel& panel) const {
        std::vector<Panel> cuts;
        for (const DrawnPath& path : part_.paths) {
            if (path.kind == LineKind::Cut && !path.edges.empty()) cuts.push_back(as_panel(scaled(path, scale_)));
        }
        measure_allowances(panel, cuts);
    }

    // The median distance of a line from another, m.
    static double distance_between(const Panel& inner, const Panel& outer) {
        std::vector<double> distances;
        for (const OutlineEdge& edge : inner.edges) {
            for (const double t : {0.25, 0.5, 0.75})
                distances.push_back(nearest_place(outer, outline_point(inner, edge, t)).distance);
        }
        const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
        std::ranges::nth_element(distances, middle);
        return *middle;
    }

    void check_outline() {
        if (panel_.edges.size() > kMaxEdges)
            throw InputError(file_, part_.name, std::to_string(panel_.edges.size()) + " edges: at most 5000");
        const double size = panel_.edges.empty() ? 0 : outline_box(panel_).sizes().maxCoeff();
        if (size > kLargestPanel)
            throw InputError(file_, part_.name, "the outline is " + in_cm(size) + " long: no panel is");
        std::vector<OutlineCrossing> crossings;
        if (panel_.edges.size() > 1) crossings = find_outline_crossings(panel_, {.most = 1});
        // The two halves of a bow cancel out: its place is told, not its area.
        if (panel_.edges.size() < 2 || (crossings.empty() && std::abs(outline_area(panel_)) < kSmallestArea))
            throw InputError(file_, part_.name, "the outline encloses no area");
        if (crossings.empty()) return;
        const Vec2d at = in_file(crossings[0].place);
        std::array<char, 96> text{};
        std::snprintf(text.data(), text.size(), "the outline crosses or touches itself near (%.6g, %.6g)", at.x(),
                      at.y());
        throw InputError(file_, part_.name, text.data());
    }

    // A drawing whose seams name edges has its darts in its outlines.
    void cut_darts() {
        if (has_seams_ || part_.placement) return;
        std::vector<DrawnPath> lines;
        std::vector<std::size_t> indices;
        for (std::size_t i = 0; i < part_.paths.size(); ++i) {
            const LineKind kind = part_.paths[i].kind;
            const bool may_be = kind == LineKind::Internal || kind == LineKind::Unknown || kind == LineKind::Help;
            if (!may_be || std::ranges::find(joined_, i) != joined_.end()) continue;
            lines.push_back(scaled(part_.paths[i], scale_));
            indices.push_back(i);
        }
        const DrawnDarts darts = cut_drawn_darts(panel_, lines);
        for (const std::size_t line : darts.lines) joined_.push_back(indices[line]);
        if (darts.count == 0) return;
        note((darts.count == 1 ? "a dart is" : std::to_string(darts.count) + " darts are") +
             std::string(" drawn inside the outline: cut into it"));
    }

    void add_marks() {
        constexpr double kReach = 0.03;      // m, from the sewing line to a notch at the cut line
        constexpr double kSamePlace = 1e-5;  // m: at a corner a notch belongs to the edge that the file names
        for (const DrawnMark& mark : part_.marks) {
            const Vec2d at = scale_ * mark.at;
            if (mark.kind == MarkKind::Drill || mark.kind == MarkKind::Button) panel_.drill_points.push_back(at);
            if (mark.kind != MarkKind::Notch) continue;
            OutlinePlace place = nearest_place(panel_, at);
            if (place.distance > kReach) continue;
            if (mark.edge && as_size(*mark.edge) < panel_.edges.size()) {
                const OutlinePlace named = place_on_edge(panel_, as_size(*mark.edge), at);
                if (named.distance < place.distance + kSamePlace) place = named;
            }
            panel_.notches.push_back({.edge = place.edge, .t = place.t, .kind = mark.notch, .count = mark.count});
        }
    }

    // By the longest of its lines: the others are its arrowheads.
    void add_grain() {
        double length = 0;
        for (const DrawnPath& path : part_.paths) {
            if (path.kind != LineKind::Grain || path.vertices.size() < 2) continue;
            Vec2d along = path.vertices.back() - path.vertices.front();
            if (along.norm() <= length) continue;
            length = along.norm();
            if (along.y() < 0 || (along.y() == 0 && along.x() > 0)) along = -along;
            panel_.grain_angle = std::atan2(-along.x(), along.y());
        }
    }

    void add_lines() {
        for (std::size_t i = 0; i < part_.paths.size(); ++i) {
            const DrawnPath& path = part_.paths[i];
            if (std::ranges::find(joined_, i) != joined_.end()) continue;  // it is the outline
            const bool is_fold = path.kind == LineKind::FoldLine;
            const bool is_mark = path.kind == LineKind::Internal || path.kind == LineKind::Cutout;
            if ((!is_fold && !is_mark) || path.edges.empty()) continue;
            InternalLine line = path.line;
            line.name = path.name;
            line.use = is_fold ? LineUse::Fold : LineUse::Mark;
            if (read_.is_mirrored) move_fields(line, {.map = Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0))});
            const Panel curve = as_panel(scaled(path, scale_));
            for (const OutlineEdge& edge : curve.edges) {
                std::vector<Vec2d> points = outline_polyline(curve, edge, kChordError);
                if (!line.points.empty()) points.erase(points.begin());
                line.points.insert(line.points.end(), points.begin(), points.end());
            }
            panel_.internal_lines.push_back(std::move(line));
        }
    }

    // The straight edge that both ends of a fold's line lie on.
    std::optional<int> edge_under(const DrawnPath& fold) const {
        constexpr double kOffLine = 0.002;  // m
        const Vec2d from = scale_ * fold.vertices.front(), to = scale_ * fold.vertices.back();
        std::optional<int> best;
        double least = kOffLine;
        for (std::size_t e = 0; e < panel_.edges.size(); ++e) {
            const OutlineEdge& edge = panel_.edges[e];
            if (edge.kind != CurveKind::Line) continue;
            const Vec2d start = panel_.vertices[as_size(edge.start)];
            const Vec2d along = (panel_.vertices[as_size(edge.end)] - start).normalized();
            const double off = std::max(std::abs(cross2(along, from - start)), std::abs(cross2(along, to - start)));
            const double length = outline_length(panel_, edge), middle = along.dot((from + to) / 2 - start);
            if (off >= least || middle < 0 || middle > length) continue;
            least = off;
            best = static_cast<int>(e);
        }
        return best;
    }

    void unfold() {
        for (const DrawnPath& path : part_.paths) {
            if (path.kind != LineKind::FoldEdge || path.vertices.size() < 2) continue;
            const std::optional<int> edge = edge_under(path);
            if (!edge) {
                note("a fold is drawn, but no straight edge lies on it: not unfolded");
                continue;
            }
            return unfold_over(*edge);
        }
        if (part_.cut.is_on_fold.value_or(false)) unfold_by_text();
    }

    void unfold_over(int edge) {
        const Vec2d start = panel_.vertices[as_size(panel_.edges[as_size(edge)].start)];
        const Vec2d end = panel_.vertices[as_size(panel_.edges[as_size(edge)].end)];
        if (!has_grain_line()) panel_.grain_angle = upright_angle(end - start);
        const Panel whole = unfolded(panel_, edge);
        read_.is_unfolded = find_outline_crossings(whole, {.most = 1}).empty();
        if (read_.is_unfolded)
            panel_ = whole;
        else
            note("unfolded, it would cross itself: left as it is drawn");
    }

    // A text says that it is cut on the fold, and no line says where that is.
    void unfold_by_text() {
        std::vector<DrawnText> texts = part_.texts;
        for (DrawnText& text : texts) text.at *= scale_;
        const FoldEdge fold = find_fold_edge(panel_, texts);
        if (!fold.edge) {
            note(fold.is_any
                     ? "cut on the fold by its text, but several edges could be the fold: not unfolded"
                     : "cut on the fold by its text, but no straight edge along the grain is found: not unfolded");
            return;
        }
        note("cut on the fold by its text: unfolded over the straight edge of " +
             in_cm(outline_length(panel_, panel_.edges[as_size(*fold.edge)])));
        unfold_over(*fold.edge);
    }

    // Ribbing gives across its ribs, so that those of a band run from edge to edge, unless its grain is drawn.
    void lay_ribs() {
        if (part_.cut.material != "ribbing" || has_grain_line()) return;
        const Vec2d size = outline_box(panel_, kChordError).sizes();
        panel_.grain_angle = size.x() < size.y() ? std::numbers::pi / 2 : 0;
    }

    void place() {
        if (!part_.placement) return;
        const DrawnPath* outline = largest(LineKind::Sew);
        read_.is_placed =
            outline && !read_.is_mirrored && place_as_drawn(panel_, scaled(*outline, scale_), *part_.placement);
        if (!read_.is_placed) note("scaled, mirrored or changed since it was printed: the garment is placed anew");
    }

    bool has_grain_line() const {
        return std::ranges::any_of(part_.paths, [](const DrawnPath& path) { return path.kind == LineKind::Grain; });
    }

    static double upright_angle(Vec2d along) {
        if (along.y() < 0) along = -along;
        return std::atan2(-along.x(), along.y());
    }

    const DrawnPart& part_;
    double scale_;
    double down_;  // -1 where y runs down in the file
    bool has_seams_;
    std::optional<double> allowance_;
    const std::string& file_;
    Panel panel_;
    PartPanel read_;
    std::vector<std::size_t> joined_;  // lines of the part that make its outline together
};

}  // namespace

PartPanel panel_of_part(const DrawnPart& part, const Drawing& drawing, double scale,
                        const std::optional<double>& allowance, const std::string& file) {
    return PartReader(part, drawing, scale, allowance, file).read();
}

}  // namespace selvedge::sim
