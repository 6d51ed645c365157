#include "sim/print/paper_sheet.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

constexpr double kNotchSize = 0.004;  // m, depth of a notch's sign

// ---- Signs.

// The signs of a notch at the cut line, pointing inward, and the line that joins it to the sewing line.
void add_notch(const NotchLine& notch, std::vector<PaperStroke>& strokes) {
    const Vec2d inward = -notch.outward, along(-notch.outward.y(), notch.outward.x());
    const double s = kNotchSize;
    const auto add = [&](std::vector<Vec2d> points) { strokes.push_back({PaperLayer::Notches, std::move(points)}); };
    for (int i = 0; i < notch.count; ++i) {
        const Vec2d base = notch.on_cut + along * (i - (notch.count - 1) / 2.0) * s;
        const auto at = [&](double across, double deep) {
            return Vec2d(base + along * across * s + inward * deep * s);
        };
        switch (notch.kind) {
            case NotchKind::Slit:
                add({at(0, 0), at(0, 1)});
                break;
            case NotchKind::V:
                add({at(-0.4, 0), at(0, 1), at(0.4, 0)});
                break;
            case NotchKind::T:
                add({at(0, 0), at(0, 1)});
                add({at(-0.4, 1), at(0.4, 1)});
                break;
            case NotchKind::Castle:
                add({at(-0.4, 0), at(-0.4, 1), at(0.4, 1), at(0.4, 0)});
                break;
            case NotchKind::U: {
                std::vector<Vec2d> arc;
                constexpr int kSteps = 12;
                for (int k = 0; k <= kSteps; ++k) {
                    const double angle = std::numbers::pi * k / kSteps;
                    arc.push_back(at(-0.4 * std::cos(angle), std::sin(angle)));
                }
                add(std::move(arc));
                break;
            }
        }
    }
    if ((notch.on_cut - notch.on_outline).norm() > s) add({notch.on_outline, notch.on_cut});
}

void add_drill_point(const Vec2d& at, std::vector<PaperStroke>& strokes) {
    constexpr double kRadius = 0.003;  // m
    constexpr int kSteps = 24;
    PaperStroke circle{PaperLayer::Drill, {}, true};
    for (int k = 0; k < kSteps; ++k) {
        const double angle = 2 * std::numbers::pi * k / kSteps;
        circle.points.emplace_back(at + kRadius * Vec2d(std::cos(angle), std::sin(angle)));
    }
    strokes.push_back(std::move(circle));
    for (const Vec2d& arm : {Vec2d(kRadius, 0), Vec2d(0, kRadius)})
        strokes.push_back({PaperLayer::Drill, {at - arm, at + arm}});
}

void add_grain_line(const std::vector<Vec2d>& line, std::vector<PaperStroke>& strokes) {
    constexpr double kHead = 0.008;  // m
    const Vec2d along = (line.back() - line.front()).normalized(), across(-along.y(), along.x());
    strokes.push_back({PaperLayer::Grain, line});
    for (const double way : {-1.0, 1.0}) {
        const Vec2d tip = way < 0 ? line.front() : line.back();
        const Vec2d back = tip - way * kHead * along;
        strokes.push_back({PaperLayer::Grain, {back + 0.3 * kHead * across, tip, back - 0.3 * kHead * across}});
    }
}

bool is_chosen(const LayerChoice& layers, PaperLayer layer) {
    return layers[static_cast<std::size_t>(layer)];
}

// ---- On cloth.

std::vector<Vec2d> turned(const std::vector<Vec2d>& points, double angle) {
    std::vector<Vec2d> out;
    for (const Vec2d& p : points) out.push_back(Eigen::Rotation2Dd(angle) * p);
    return out;
}

class LayoutMaker {
 public:
    LayoutMaker(const Pattern& pattern, const CuttingOptions& options) : pattern_(pattern), options_(options) {
        if (pattern.matched_sett) repeat_ = pattern.matched_sett->repeat;
    }

    std::vector<PaperSheet> make() {
        const std::vector<PaperPiece> pieces = paper_pieces(pattern_);
        for (const PaperPiece& piece : pieces) {
            const std::string fabric = fabric_of(piece);
            const auto found = std::ranges::find(sheets_, fabric, &PaperSheet::fabric);
            PaperSheet& sheet = found != sheets_.end() ? *found : add_sheet(fabric);
            add_copies(piece, sheet);
        }
        for (std::size_t s = 0; s < sheets_.size(); ++s) arrange(sheets_[s], items_[s]);
        return std::move(sheets_);
    }

 private:
    const Panel& panel_of(const PaperPiece& piece) const {
        return pattern_.panels[static_cast<std::size_t>(piece.panel)];
    }

    std::string fabric_of(const PaperPiece& piece) const {
        const Panel& panel = panel_of(piece);
        if (!panel.fabric.empty()) return panel.fabric;
        return pattern_.fabric.empty() ? options_.fabric : pattern_.fabric;
    }

    PaperSheet& add_sheet(const std::string& fabric) {
        PaperSheet sheet{.title = pattern_.name};
        sheet.fabric = fabric;
        sheet.is_folded = options_.is_folded && !repeat_;
        if (options_.is_folded && repeat_)
            sheet.notes.emplace_back("the sett is matched, so the fabric is cut open, not folded");
        if (!pattern_.tartan.empty() && !repeat_)
            sheet.notes.emplace_back("the sett is not matched (selvedge match), so panels lie anywhere on it");
        sheet.repeat = repeat_;
        sheets_.push_back(std::move(sheet));
        items_.emplace_back();
        return sheets_.back();
    }

    bool is_mirrored_pair(const PaperPiece& piece) const {
        const Panel& panel = panel_of(piece);
        return std::ranges::any_of(pattern_.panels, [&](const Panel& other) { return other.mirror_of == panel.name; });
    }

    void add_copies(const PaperPiece& piece, PaperSheet& sheet) {
        const Panel& panel = panel_of(piece);
        NestItem item{.name = panel.name, .outline = piece.cut, .turns = {-panel.grain_angle}};
        int copies = panel.pieces;
        if (repeat_) {
            item.repeat = repeat_;
            item.phase = panel.sett_offset;
        } else if (sheet.is_folded) {
            if (!panel.mirror_of.empty()) return;  // it lies under the panel that it mirrors
            copies = fold(piece, item, sheet);
        }
        if (!options_.is_one_way && !item.repeat && !item.axis_at)
            item.turns.push_back(item.turns[0] + std::numbers::pi);
        const PaperPiece drawn = item.axis_at ? seen_on_fold(piece, item) : piece;
        for (int k = 0; k < copies; ++k) {
            sheet.pieces.push_back(drawn);
            items_[static_cast<std::size_t>(&sheet - sheets_.data())].push_back(item);
        }
    }

    // How often an outline is cut through both layers.
    int fold(const PaperPiece& piece, NestItem& item, PaperSheet& sheet) const {
        const Panel& panel = panel_of(piece);
        if (is_mirrored_pair(piece)) return panel.pieces;
        const std::vector<Vec2d> upright = turned(piece.cut, item.turns[0]);
        const std::optional<double> axis = fold_axis(upright);
        if (axis && panel.pieces % 2 == 1) {
            item.outline = turned(right_of(upright, *axis), -item.turns[0]);
            item.axis_at = axis;
            return panel.pieces;
        }
        if (axis) return panel.pieces / 2;
        sheet.notes.push_back(panel.name + ": cut from one layer; the other is left over");
        return panel.pieces;
    }

    // Of a piece on the fold the right half is seen: its grain line lies there, and its label says so.
    static PaperPiece seen_on_fold(PaperPiece piece, const NestItem& item) {
        for (PaperLine& line : piece.lines) {
            if (line.layer != PaperLayer::Grain) continue;
            std::vector<Vec2d> upright = turned(line.points, item.turns[0]);
            for (Vec2d& p : upright) p.x() = *item.axis_at + std::abs(p.x() - *item.axis_at);
            line.points = turned(upright, -item.turns[0]);
        }
        for (std::string& line : piece.label.lines) {
            if (!line.starts_with("cut ")) continue;
            line.insert(std::min(line.find_first_not_of("0123456789", 4), line.size()), " on fold");
            break;
        }
        return piece;
    }

    void arrange(PaperSheet& sheet, const std::vector<NestItem>& items) const {
        const double width = sheet.is_folded ? options_.width / 2 : options_.width;
        const Nest nested =
            nest(items, {.width = width, .gap = options_.gap, .most_work = NestOptions{}.most_work / sheets_.size()});
        sheet.places = nested.places;
        sheet.size = {width, nested.length};
    }

    const Pattern& pattern_;
    const CuttingOptions& options_;
    std::optional<Vec2d> repeat_;
    std::vector<PaperSheet> sheets_;
    std::vector<std::vector<NestItem>> items_;  // as the sheets
};

}  // namespace

std::vector<PaperStroke> strokes_of(const PaperPiece& piece, const LayerChoice& layers) {
    std::vector<PaperStroke> strokes;
    const bool has_cut = is_chosen(layers, PaperLayer::Cut);
    if (has_cut) strokes.push_back({PaperLayer::Cut, piece.cut, true});
    if (is_chosen(layers, PaperLayer::Sew) && (piece.has_allowance || !has_cut))
        strokes.push_back({PaperLayer::Sew, piece.sew, true});
    for (const PaperLine& line : piece.lines) {
        if (!is_chosen(layers, line.layer)) continue;
        if (line.layer == PaperLayer::Grain) {
            add_grain_line(line.points, strokes);
        } else {
            strokes.push_back({.layer = line.layer, .points = line.points, .is_fold_edge = line.is_fold_edge});
        }
    }
    if (is_chosen(layers, PaperLayer::Notches)) {
        for (const NotchLine& notch : piece.notches) add_notch(notch, strokes);
        for (const NotchLine& notch : piece.leg_notches) add_notch(notch, strokes);
    }
    if (is_chosen(layers, PaperLayer::Drill)) {
        for (const Vec2d& at : piece.drill_points) add_drill_point(at, strokes);
    }
    return strokes;
}

std::vector<PaperStroke> strokes_of(const PaperSheet& sheet, const LayerChoice& layers) {
    std::vector<PaperStroke> strokes;
    for (std::size_t i = 0; i < sheet.pieces.size(); ++i) {
        for (PaperStroke& stroke : strokes_of(sheet.pieces[i], layers)) {
            for (Vec2d& p : stroke.points) p = sheet.places[i].at(p);
            strokes.push_back(std::move(stroke));
        }
    }
    return strokes;
}

PaperSheet paper_sheet(const Pattern& pattern, const std::vector<PaperPiece>& pieces, double width,
                       const NestOptions& search) {
    constexpr double kGap = 0.01;  // m
    PaperSheet sheet{.title = pattern.name, .pieces = pieces};
    std::vector<NestItem> items;
    for (const PaperPiece& piece : pieces) {
        const Panel& panel = pattern.panels[static_cast<std::size_t>(piece.panel)];
        items.push_back({.name = panel.name, .outline = piece.cut});
        width = std::max(width, piece.box().sizes().x() + 1e-6);
    }
    const Nest nested =
        nest(items, {.width = width, .gap = kGap, .orders = search.orders, .most_work = search.most_work});
    sheet.places = nested.places;
    sheet.size = {width, nested.length};
    sheet.work = nested.work;
    return sheet;
}

std::vector<PaperSheet> cutting_layouts(const Pattern& pattern, const CuttingOptions& options) {
    return LayoutMaker(pattern, options).make();
}

}  // namespace selvedge::sim
