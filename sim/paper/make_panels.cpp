#include "sim/paper/make_panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "sim/core/error.h"
#include "sim/core/lower_case.h"
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
#include "sim/paper/size_names.h"
#include "sim/paper/upright_panels.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/outline.h"
#include "sim/proposals/panel_role.h"

namespace selvedge::sim {
namespace {

// "sleeve" for "left_sleeve", of which the other is cut, too: seams tell which is which.
std::string without_side(const std::string& name) {
    const std::string small = lower_case(name);
    for (const std::string_view side : {"left", "right"}) {
        const std::size_t at = small.find(side);
        if (at == std::string::npos || small.size() != name.size()) continue;
        std::string rest = name.substr(0, at), after = name.substr(at + side.size());
        const auto is_gap = [](char c) { return c == '_' || c == ' ' || c == '-'; };
        while (!after.empty() && is_gap(after.front())) after.erase(0, 1);
        if (after.empty()) {
            while (!rest.empty() && is_gap(rest.back())) rest.pop_back();
        }
        return rest + after;
    }
    return name;
}

constexpr double kChordError = 1e-4;  // m, of lines from curves
constexpr double kLargestPanel = 30;  // m; further from the origin, panels are moved to it

std::string in_cm(double metres) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g cm", 100 * metres);
    return text.data();
}

// ---- Sizes.

std::vector<std::string> sizes_of(const Drawing& drawing) {
    std::vector<std::string> sizes;
    for (const DrawnPart& part : drawing.parts) {
        if (!part.size.empty() && std::ranges::find(sizes, part.size) == sizes.end()) sizes.push_back(part.size);
    }
    return sizes;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

// ---- From a drawn path to an outline.

DrawnPath scaled(DrawnPath path, double scale) {
    transform(path, Eigen::Affine2d(Eigen::Scaling(scale)));
    return path;
}

// ---- Parts.

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

    // None: the part has no closed outline.
    std::optional<Panel> read() {
        std::optional<Panel> panel = read_outline();
        if (!panel) return std::nullopt;
        panel_ = std::move(*panel);
        panel_.name = part_.name;
        check_outline();
        cut_darts();
        add_marks();
        add_grain();
        add_lines();
        unfold();
        const Vec2d middle = outline_box(panel_).center();
        if (middle.norm() > kLargestPanel)
            panel_ = mapped_panel(panel_, Eigen::Affine2d(Eigen::Translation2d(-middle)));
        place();
        if (part_.cut.pieces) panel_.pieces = std::clamp(*part_.cut.pieces, 1, kMostPieces);
        return panel_;
    }

    std::vector<std::string> notes;
    bool is_placed = false;    // as the part says
    bool is_mirrored = false;  // the sewing line runs clockwise: its edges are in the opposite order

 private:
    Vec2d in_file(const Vec2d& place) const { return Vec2d(place.x(), down_ * place.y()) / scale_; }

    void note(const std::string& text) { notes.push_back(part_.name + ": " + text); }

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
            is_mirrored = sewn->edges.size() > 1 && outline_area(as_panel(scaled(*sewn, scale_))) < 0;
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
            if (is_mirrored) move_fields(line, {.map = Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0))});
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
        if (find_outline_crossings(whole, {.most = 1}).empty())
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

    void place() {
        if (!part_.placement) return;
        const DrawnPath* outline = largest(LineKind::Sew);
        is_placed = outline && !is_mirrored && place_as_drawn(panel_, scaled(*outline, scale_), *part_.placement);
        if (!is_placed) note("scaled, mirrored or changed since it was printed: the garment is placed anew");
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
    std::vector<std::size_t> joined_;  // lines of the part that make its outline together
};

// ---- The pattern.

class PanelMaker {
 public:
    PanelMaker(const Drawing& drawing, const std::string& file, const MakePanelsOptions& options)
        : drawing_(drawing), file_(file), options_(options) {}

    PanelsOfDrawing make() {
        out_.notes = drawing_.notes;
        out_.hints = std::filesystem::path(file_).stem().string() + " ";
        out_.pattern.name = drawing_.title;
        out_.sizes = sizes_of(drawing_);
        choose_size();
        choose_scale();
        std::vector<int> first_panel;
        for (const DrawnPart& part : drawing_.parts) {
            first_panel.push_back(static_cast<int>(out_.pattern.panels.size()));
            if (!part.size.empty() && part.size != out_.pattern.size) continue;
            add_part(part);
        }
        if (out_.pattern.panels.empty()) {
            throw InputError(
                file_, "",
                "no closed outline: " + (first_open_.empty() ? "nothing that could be a panel" : first_open_));
        }
        doubt_scale();
        if (!drawing_.is_upright && drawing_.seams.empty() && turn_upright(out_.pattern.panels))
            out_.notes.emplace_back("the parts lie on their sides: turned upright");
        add_seams(first_panel);
        finish_pairs();
        place_on_body();
        share_fabric();
        if (drawing_.allowance) out_.pattern.allowance = std::clamp(*drawing_.allowance, 0.0, kWidestAllowance);
        return std::move(out_);
    }

 private:
    void choose_size() {
        if (!options_.size.empty()) {
            const auto size = find_size(options_.size);
            if (!size) {
                throw InputError(file_, "",
                                 out_.sizes.empty() ? "the file names no sizes"
                                                    : "no size '" + options_.size + "': " + joined(out_.sizes));
            }
            out_.pattern.size = *size;
            return;
        }
        if (out_.sizes.empty()) return;
        const auto sample = find_size(drawing_.sample_size);
        std::vector<std::string> sorted = out_.sizes;
        sort_sizes(sorted);
        out_.pattern.size = sample ? *sample : sorted[(sorted.size() - 1) / 2];
        if (out_.sizes.size() > 1) {
            out_.notes.push_back("sizes " + joined(out_.sizes) + ": took " + out_.pattern.size +
                                 (sample ? ", the sample size" : "") + "; --size takes another");
        }
    }

    // The size of the file that is meant, in whatever case it is written; none: it has no such size.
    std::optional<std::string> find_size(const std::string& wanted) const {
        if (std::ranges::find(out_.sizes, wanted) != out_.sizes.end()) return wanted;
        const auto found = std::ranges::find_if(
            out_.sizes, [&](const std::string& size) { return lower_case(size) == lower_case(wanted); });
        return found == out_.sizes.end() ? std::nullopt : std::optional(*found);
    }

    void choose_scale() {
        if (options_.metres_per_unit || drawing_.metres_per_unit) {
            scale_ = options_.metres_per_unit ? *options_.metres_per_unit : *drawing_.metres_per_unit;
            return;
        }
        const DrawingUnit unit = guess_unit(drawing_);
        scale_ = unit.metres;
        out_.is_unit_guessed = true;
        out_.notes.push_back(std::string("the file names no unit: 1 unit taken as 1 ") + unit.name +
                             " from the size of the parts; --unit sets another");
    }

    void doubt_scale() {
        double largest = 0;
        for (const Panel& panel : out_.pattern.panels)
            largest = std::max(largest, outline_box(panel, 1e-3).sizes().maxCoeff());
        if (const std::string doubt = doubt_of_size(largest, scale_); !doubt.empty()) out_.notes.push_back(doubt);
    }

    static bool is_other_material(const std::string& material) {
        const PanelRole role = role_of_name(material);
        return role.part == GarmentPart::Accessory;
    }

    void add_part(const DrawnPart& part) {
        for (const DrawnText& text : part.texts) out_.hints += text.text + " ";
        const std::optional<double> allowance = options_.allowance ? options_.allowance : drawing_.allowance;
        PartReader reader(part, drawing_, scale_, allowance, file_);
        std::optional<Panel> panel;
        try {
            panel = reader.read();
        } catch (const InputError& error) {
            if (drawing_.parts.size() == 1 || !drawing_.seams.empty()) throw;
            out_.notes.push_back(part.name + ": " + error.problem() + ": left out");
            return;
        }
        out_.notes.insert(out_.notes.end(), reader.notes.begin(), reader.notes.end());
        if (!panel) {
            const std::string open = open_outline(part);
            out_.notes.push_back(part.name + ": no closed outline, left out" + (open.empty() ? "" : ": " + open));
            if (first_open_.empty()) first_open_ = open;
            return;
        }
        const PanelRole role = role_of_name(panel->name), told = role_of_name(part.category);
        const bool is_named = role.part != GarmentPart::Unknown || role.face != Face::None;
        if (!is_named && (told.part != GarmentPart::Unknown || told.face != Face::None))
            panel->name += " " + part.category;
        panel->name = free_name(panel->name.empty() ? "panel" : panel->name);
        if (is_shipped_fabric(part.cut.material)) {
            panel->fabric = part.cut.material;
        } else if (part.cut.material == "ribbing") {
            panel->fabric = "jersey";  // the shipped knit
            out_.ribbing.push_back(panel->name);
            out_.notes.push_back(panel->name + ": cut from ribbing, which is taken for jersey");
        } else if (is_other_material(part.cut.material)) {
            panel->is_worn = false;
            out_.notes.push_back(panel->name + ": cut from " + part.cut.material + ", not worn");
        }
        is_placed_ = is_placed_ && reader.is_placed;
        is_mirrored_.push_back(reader.is_mirrored);
        is_pair_.push_back(is_pair(part));
        out_.pattern.panels.push_back(std::move(*panel));
    }

    // "parts.front.paths.seam is open by 3 mm": of the part's longest open line that could be its outline; empty: it
    // has none.
    std::string open_outline(const DrawnPart& part) const {
        const DrawnPath* longest = nullptr;
        for (const DrawnPath& path : part.paths) {
            const bool may_be =
                path.kind == LineKind::Sew || path.kind == LineKind::Cut || path.kind == LineKind::Unknown;
            if (!may_be || path.is_closed || path.edges.size() < 2) continue;
            if (!longest || size_of(path) > size_of(*longest)) longest = &path;
        }
        if (!longest) return {};
        return longest->place + " is " + open_by(gap_of(*longest), scale_);
    }

    // Whether the part is cut twice, once mirrored; none: the drawing does not say.
    static std::optional<bool> is_pair(const DrawnPart& part) {
        const CutInstructions& cut = part.cut;
        if (cut.pieces && *cut.pieces % 2 != 0) return false;
        // "Cut 2, mirrored, on the fold" without a fold edge: two pieces from folded cloth.
        const bool has_fold_edge =
            std::ranges::any_of(part.paths, [](const DrawnPath& path) { return path.kind == LineKind::FoldEdge; });
        if (cut.is_on_fold.value_or(false) && (has_fold_edge || !cut.are_mirrored.value_or(false))) return false;
        if (cut.are_mirrored) return *cut.are_mirrored && cut.pieces.value_or(2) >= 2;
        return std::nullopt;
    }

    std::string free_name(const std::string& wanted) const {
        const auto is_taken = [&](const std::string& name) {
            return std::ranges::any_of(out_.pattern.panels, [&](const Panel& panel) { return panel.name == name; });
        };
        std::string name = wanted;
        for (int number = 2; is_taken(name); ++number) name = wanted + "_" + std::to_string(number);
        return name;
    }

    // Seams that the file states. A part that was unfolded or left out has none.
    void add_seams(const std::vector<int>& first_panel) {
        for (Seam seam : drawing_.seams) {
            bool is_whole = true;
            for (SeamSide* side : {&seam.first, &seam.second}) {
                if (side->panel < 0 || as_size(side->panel) >= first_panel.size()) {
                    is_whole = false;
                    continue;
                }
                side->panel = first_panel[as_size(side->panel)];
                is_whole = is_whole && as_size(side->panel) < out_.pattern.panels.size() && side->edge >= 0 &&
                           as_size(side->edge) < out_.pattern.panels[as_size(side->panel)].edges.size();
            }
            if (!is_whole) {
                out_.notes.push_back("a seam names an edge that is not there: left out");
                continue;
            }
            for (SeamSide* side : {&seam.first, &seam.second}) {
                if (!is_mirrored_[as_size(side->panel)]) continue;
                // The same corners stay together.
                side->edge = static_cast<int>(out_.pattern.panels[as_size(side->panel)].edges.size()) - 1 - side->edge;
                seam.is_reversed = !seam.is_reversed;
            }
            out_.pattern.seams.push_back(std::move(seam));
        }
        has_seams_ = !drawing_.seams.empty();
    }

    void place_on_body() {
        if (!drawing_.body || !is_placed_) return;
        out_.is_placed = true;
        out_.pattern.body = drawing_.body->text;
        out_.pattern.body_height = drawing_.body->height;
    }

    // What all panels are cut from is the fabric of the garment.
    void share_fabric() {
        const std::string fabric = out_.pattern.panels.front().fabric;
        if (!std::ranges::all_of(out_.pattern.panels, [&](const Panel& panel) { return panel.fabric == fabric; }))
            return;
        out_.pattern.fabric = fabric;
        for (Panel& panel : out_.pattern.panels) panel.fabric.clear();
    }

    // Adds the second panel of each mirrored pair. A drawing with seams or a body of its own has all panels.
    void finish_pairs() {
        if (has_seams_ || drawing_.body) return;
        const std::vector<PanelRole> roles = roles_of(out_.pattern, out_.hints);
        const std::size_t count = out_.pattern.panels.size();
        for (std::size_t p = 0; p < count; ++p) {
            const bool is_told = is_pair_[p].has_value();
            const bool is_lone = roles[p].flank == Flank::None && !has_twin(p, count);
            const bool is_wanted = is_told ? *is_pair_[p] : is_lone && is_one_of_a_pair(p, roles[p]);
            if (!is_wanted || is_inner_layer(p, roles[p])) continue;
            if (!is_told)
                out_.notes.push_back(out_.pattern.panels[p].name + ": taken for one of a pair, by its name or shape");
            add_mirror_image(p);
        }
    }

    // Whether a second piece lies under the first: the part spans the middle of the body already, as a yoke that is cut
    // twice.
    bool is_inner_layer(std::size_t p, const PanelRole& role) const {
        using enum GarmentPart;
        const bool comes_once = role.part == Collar || role.part == CollarStand || role.part == Yoke ||
                                role.part == Waistband || role.part == Hood ||
                                (role.part == Torso && role.face != Face::None);
        return comes_once && is_mirrored_in_itself(out_.pattern.panels[p], 0);
    }

    // By its name, or because it is the front or the back of one half of the body, or lies beside the middle of a
    // garment that is cut on the fold there.
    bool is_one_of_a_pair(std::size_t p, const PanelRole& role) const {
        using enum GarmentPart;
        const Panel& panel = out_.pattern.panels[p];
        if (comes_in_pairs(role, panel.name)) return true;
        const bool may_lie_beside = role.part == Unknown || role.part == Torso || role.part == Skirt;
        const bool has_fold = std::ranges::any_of(drawing_.parts, [](const DrawnPart& part) {
            return std::ranges::any_of(part.paths,
                                       [](const DrawnPath& path) { return path.kind == LineKind::FoldEdge; });
        });
        if (has_fold && may_lie_beside && !is_mirrored_in_itself(panel, 0) && !is_mirrored_in_itself(panel, 1))
            return true;
        const bool is_face =
            (role.face != Face::None && (role.part == GarmentPart::Torso || role.part == GarmentPart::Skirt)) ||
            role.part == GarmentPart::Hood || role.part == GarmentPart::Yoke;
        return is_face && !is_mirrored_in_itself(panel, 0) && !is_mirrored_in_itself(panel, 1);
    }

    // Whether the file draws the mirror image itself.
    bool has_twin(std::size_t p, std::size_t count) const {
        const Panel& panel = out_.pattern.panels[p];
        for (std::size_t q = 0; q < count; ++q) {
            const Panel& other = out_.pattern.panels[q];
            if (q == p || other.edges.size() != panel.edges.size()) continue;
            const double area = outline_area(panel);
            if (std::abs(outline_area(other) - area) < 1e-6 * area) return true;
        }
        return false;
    }

    void add_mirror_image(std::size_t p) {
        Panel image = mapped_panel(out_.pattern.panels[p], Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
        Panel& panel = out_.pattern.panels[p];
        panel.pieces = std::max(1, panel.pieces / 2);
        image.pieces = panel.pieces;
        if (const std::string name = without_side(panel.name); !name.empty() && free_name(name) == name)
            panel.name = name;
        image.mirror_of = panel.name;
        image.name = free_name(panel.name + "_mirrored");
        out_.pattern.panels.push_back(std::move(image));
    }

    const Drawing& drawing_;
    const std::string& file_;
    const MakePanelsOptions& options_;
    double scale_ = 1;
    bool has_seams_ = false;
    bool is_placed_ = true;                     // so far, every panel
    std::vector<bool> is_mirrored_;             // per panel of the drawing: see PartReader
    std::string first_open_;                    // place and gap of the first outline that is open
    std::vector<std::optional<bool>> is_pair_;  // per panel of the drawing
    PanelsOfDrawing out_;
};

}  // namespace

PanelsOfDrawing make_panels(const Drawing& drawing, const std::string& file, const MakePanelsOptions& options) {
    return PanelMaker(drawing, file, options).make();
}

}  // namespace selvedge::sim
