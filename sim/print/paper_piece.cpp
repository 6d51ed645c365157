#include "sim/print/paper_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "sim/pattern/fabric_file.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

constexpr std::array<std::string_view, kPaperLayers> kLayerNames{"cut",     "sew",   "fold",     "grain",
                                                                 "notches", "drill", "internal", "labels"};

std::vector<Vec2d> sewing_line(const Panel& panel, double chord_error) {
    std::vector<Vec2d> line;
    for (const OutlineEdge& edge : panel.edges) {
        const std::vector<Vec2d> points = outline_polyline(panel, edge, chord_error);
        line.insert(line.end(), points.begin(), points.end() - 1);
    }
    return line;
}

// ---- Where a label and a grain line have room.

// What is drawn inside a piece: open lines.
using Drawn = std::vector<std::vector<Vec2d>>;

Drawn drawn_inside(const PaperPiece& piece) {
    Drawn drawn;
    for (const PaperLine& line : piece.lines) drawn.push_back(line.points);
    constexpr double kRadius = 0.003;  // m, of a drill point's sign
    for (const Vec2d& at : piece.drill_points) {
        for (const Vec2d& arm : {Vec2d(kRadius, 0), Vec2d(0, kRadius)}) drawn.push_back({at - arm, at + arm});
    }
    return drawn;
}

double distance_to_drawn(const Vec2d& point, const Drawn& drawn) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::vector<Vec2d>& line : drawn) {
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            least = std::min(least, distance_to_segment(point, line[i], line[i + 1]));
    }
    return least;
}

bool meets_box(const Drawn& drawn, const Eigen::AlignedBox2d& box) {
    return std::ranges::any_of(drawn, [&](const std::vector<Vec2d>& line) {
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            if (segment_meets_box(line[i], line[i + 1], box)) return true;
        }
        return false;
    });
}

bool is_rectangle_inside(const Eigen::AlignedBox2d& box, const std::vector<Vec2d>& outline) {
    if (!is_inside(box.center(), outline)) return false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        if (segment_meets_box(outline[i], outline[(i + 1) % outline.size()], box)) return false;
    }
    return true;
}

constexpr int kSpots = 24;  // places tried along each side of the panel's box

std::vector<Vec2d> spots_in(const std::vector<Vec2d>& outline) {
    Eigen::AlignedBox2d box;
    for (const Vec2d& p : outline) box.extend(p);
    std::vector<Vec2d> spots;
    for (int i = 0; i < kSpots; ++i) {
        for (int j = 0; j < kSpots; ++j) {
            const Vec2d share((i + 0.5) / kSpots, (j + 0.5) / kSpots);
            const Vec2d spot = box.min() + share.cwiseProduct(box.sizes());
            if (is_inside(spot, outline)) spots.push_back(spot);
        }
    }
    return spots;
}

// Where a label may lie, as far as the caller says.
using MayLie = std::function<bool(const Eigen::AlignedBox2d&)>;

// A place for the middle of a label.
struct LabelSpot {
    Vec2d at;
    double room = 0;  // m, to the outline and to what is drawn inside
};

// Those with the most room first.
std::vector<LabelSpot> by_room(const std::vector<Vec2d>& spots, const std::vector<Vec2d>& outline, const Drawn& drawn) {
    std::vector<LabelSpot> sorted;
    for (const Vec2d& spot : spots)
        sorted.push_back({spot, std::min(distance_to_outline(spot, outline), distance_to_drawn(spot, drawn))});
    std::ranges::stable_sort(sorted, std::ranges::greater(), &LabelSpot::room);
    return sorted;
}

// Moves the label to the first spot where it fits. Returns whether there is one.
bool fit_label(PaperLabel& label, const std::vector<Vec2d>& outline, const Drawn& drawn,
               const std::vector<LabelSpot>& spots, const MayLie& may_lie = {}) {
    for (const LabelSpot& spot : spots) {
        label.at = spot.at;
        const Eigen::AlignedBox2d box = label_box(label);
        if (spot.room < box.sizes().minCoeff() / 2) return false;  // those that follow have even less room
        if (is_rectangle_inside(box, outline) && !meets_box(drawn, box) && (!may_lie || may_lie(box))) return true;
    }
    return false;
}

constexpr std::array kLabelHeights{0.008, 0.006, 0.0045, 0.0035, 0.0025};  // m

// The largest text of which the label fits; none if it does not.
std::optional<PaperLabel> largest_label(PaperLabel label, const std::vector<Vec2d>& outline, const Drawn& drawn,
                                        const std::vector<LabelSpot>& spots) {
    for (const double height : kLabelHeights) {
        label.height = height;
        if (fit_label(label, outline, drawn, spots)) return label;
    }
    return std::nullopt;
}

// Rather small than over lines that are drawn inside; up the panel if the text is much larger then.
void place_label(PaperLabel& label, const PaperPiece& piece, const std::vector<Vec2d>& spots) {
    constexpr double kMuch = 1.7;  // times
    const std::vector<Vec2d>& outline = piece.sew;
    for (const Drawn& drawn : {drawn_inside(piece), Drawn()}) {
        const std::vector<LabelSpot> sorted = by_room(spots, outline, drawn);
        PaperLabel turned = label;
        turned.runs_up = true;
        const std::optional<PaperLabel> level = largest_label(label, outline, drawn, sorted);
        if (level && kMuch * level->height > kLabelHeights.front()) return void(label = *level);
        const std::optional<PaperLabel> upright = largest_label(turned, outline, drawn, sorted);
        if (level && (!upright || upright->height < kMuch * level->height)) return void(label = *level);
        if (upright) return void(label = *upright);
    }
    label.height = kLabelHeights.back();
    // Nowhere: beside the panel's middle, over its outline.
    Eigen::AlignedBox2d box;
    for (const Vec2d& p : outline) box.extend(p);
    label.at = spots.empty() ? Vec2d(box.center()) : spots[spots.size() / 2];
}

struct Stretch {
    double from = 0, to = 0;  // m, along the direction from the spot
};

// How far a line through a spot runs inside.
Stretch stretch_inside(const Vec2d& spot, const Vec2d& along, const std::vector<Vec2d>& outline) {
    Stretch stretch{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2d a = outline[i] - spot, side = outline[(i + 1) % outline.size()] - outline[i];
        const double area = cross2(along, side);
        if (area == 0) continue;
        const double s = cross2(a, side) / area, t = cross2(a, along) / area;
        if (t < 0 || t > 1) continue;
        if (s >= 0) stretch.to = std::min(stretch.to, s);
        if (s < 0) stretch.from = std::max(stretch.from, s);
    }
    if (!std::isfinite(stretch.from) || !std::isfinite(stretch.to)) return {};
    return stretch;
}

// A line along the warp, 60 % of what is inside, beside the label and other lines where there is room.
PaperLine grain_line(const Panel& panel, const PaperPiece& piece, const std::vector<Vec2d>& spots) {
    const Vec2d along(-std::sin(panel.grain_angle), std::cos(panel.grain_angle));
    const Eigen::AlignedBox2d label = label_box(piece.label);
    const Drawn drawn = drawn_inside(piece);
    constexpr double kShare = 0.6, kMost = 0.5;  // of the stretch inside; m
    // Weights of a stretch near the outline, over the label, and on another line.
    constexpr double kBeside = 0.5, kOverLabel = 0.25, kOnLine = 0.5;
    constexpr double kNear = 0.004;  // m
    PaperLine line{PaperLayer::Grain, {}};
    double best = 0;
    for (const Vec2d& spot : spots) {
        const Stretch inside = stretch_inside(spot, along, piece.sew);
        const double length = std::min(kMost, kShare * (inside.to - inside.from));
        const Vec2d middle = spot + along * (inside.from + inside.to) / 2;
        const Vec2d from = middle - along * length / 2, to = middle + along * length / 2;
        double merit = length;
        Eigen::AlignedBox2d box(from.cwiseMin(to), from.cwiseMax(to));
        if (box.intersects(label)) merit *= kOverLabel;
        if (merit <= best * (1 + 1e-9)) continue;  // the other weights only lessen it
        double clear = std::numeric_limits<double>::infinity(), over = 0;
        constexpr int kSteps = 8;
        for (int k = 0; k <= kSteps; ++k) {
            const Vec2d p = from + (to - from) * k / kSteps;
            clear = std::min(clear, distance_to_outline(p, piece.sew));
            over += distance_to_drawn(p, drawn) < kNear ? 1.0 / (kSteps + 1) : 0;
        }
        if (clear < std::max(kNear, std::min(piece.label.height, length / 8))) merit *= kBeside;
        merit *= 1 - kOnLine * over;
        if (merit > best * (1 + 1e-9)) best = merit, line.points = {from, to};
    }
    return line;
}

// ---- The label's text.

bool has_twin(const Pattern& pattern, const Panel& panel) {
    return panel.mirror_of.empty() &&
           std::ranges::any_of(pattern.panels, [&](const Panel& other) { return other.mirror_of == panel.name; });
}

std::string cut_text(const Panel& panel, int count, bool are_pairs) {
    const std::string pieces = "cut " + std::to_string(count);
    if (!are_pairs) return pieces;
    return pieces + (count == 2 ? " (1 pair, mirrored)" : " (" + std::to_string(panel.pieces) + " pairs, mirrored)");
}

std::vector<std::string> label_of(const Pattern& pattern, const Panel& panel, const PaperPiece& piece, bool are_pairs) {
    std::vector<std::string> lines{panel.name};
    const std::string garment = panel.garment.empty() ? pattern.name : panel.garment;
    if (!garment.empty()) lines.push_back(garment + (pattern.size.empty() ? "" : ", size " + pattern.size));
    if (garment.empty() && !pattern.size.empty()) lines.push_back("size " + pattern.size);
    lines.push_back(cut_text(panel, piece.cut_from_fabric, are_pairs));
    if (piece.is_on_fold) lines.back() += " on fold";
    const std::string& fabric = panel.fabric.empty() ? pattern.fabric : panel.fabric;
    if (!fabric.empty()) lines.back() += " of " + fabric_title(fabric);
    for (const std::string& interlining : panel.interlinings) lines.push_back("fuse with " + fabric_title(interlining));
    const bool has_fold =
        std::ranges::any_of(panel.internal_lines, [](const InternalLine& line) { return line.use == LineUse::Fold; });
    if (has_fold && !piece.is_on_fold) lines.emplace_back("fold along the marked line");
    return lines;
}

// ---- Halves to cut on a fold.

bool has_upright_grain(const Panel& panel) {
    return std::abs(std::sin(panel.grain_angle)) < 1e-6;
}

// The parts of an open line right of an upright.
std::vector<PaperLine> open_right_of(const PaperLine& line, double x) {
    std::vector<PaperLine> parts;
    std::vector<Vec2d> part;
    const auto end_part = [&] {
        if (part.size() > 1) parts.push_back({line.layer, part, line.is_dart_fold});
        part.clear();
    };
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const Vec2d& to = line.points[i];
        if (i > 0 && (line.points[i - 1].x() >= x) != (to.x() >= x)) {
            const Vec2d& from = line.points[i - 1];
            part.push_back(from + (to - from) * (x - from.x()) / (to.x() - from.x()));
            if (to.x() < x) end_part();
        }
        if (to.x() >= x) part.push_back(to);
    }
    end_part();
    return parts;
}

// The half right of the axis; the axis itself is a fold line.
void halve(PaperPiece& piece, double axis) {
    constexpr double kOnAxis = 1e-4;  // m
    piece.cut = right_of(piece.cut, axis);
    piece.sew = right_of(piece.sew, axis);
    for (std::vector<NotchLine>* notches : {&piece.notches, &piece.leg_notches})
        std::erase_if(*notches, [&](const NotchLine& notch) { return notch.on_outline.x() < axis - kOnAxis; });
    std::erase_if(piece.drill_points, [&](const Vec2d& point) { return point.x() < axis - kOnAxis; });
    std::vector<PaperLine> lines;
    for (const PaperLine& line : piece.lines) {
        const bool is_axis = line.layer == PaperLayer::Fold && std::ranges::all_of(line.points, [&](const Vec2d& p) {
                                 return std::abs(p.x() - axis) < kOnAxis;
                             });
        if (is_axis) continue;
        for (PaperLine& part : open_right_of(line, axis)) lines.push_back(std::move(part));
    }
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec2d& p : piece.cut) {
        if (p.x() > axis + kOnAxis) continue;
        low = std::min(low, p.y());
        high = std::max(high, p.y());
    }
    lines.push_back({.layer = PaperLayer::Fold, .points = {Vec2d(axis, low), Vec2d(axis, high)}, .is_fold_edge = true});
    piece.lines = std::move(lines);
    piece.is_on_fold = true;
}

void add_darts(PaperPiece& piece, const CutLine& cut) {
    for (const DartLines& dart : cut.darts) {
        piece.leg_notches.insert(piece.leg_notches.end(), {dart.begin, dart.end});
        piece.lines.push_back({PaperLayer::Fold, {dart.fold[0], dart.fold[1]}, true});
    }
}

// Which way the folded cloth of darts is pressed, one line of the label; empty: there are none. is_cut_so: the cut line
// is made for it.
std::string pressing_text(const std::vector<Dart>& darts, bool is_cut_so) {
    if (!darts.empty() && !is_cut_so) return "press darts as they are cut";
    const auto level = std::ranges::count_if(darts, &Dart::is_level);
    const auto upright = static_cast<std::ptrdiff_t>(darts.size()) - level;
    if (level > 0 && upright > 0) return "press level darts down, upright darts to the centre";
    if (level > 0) return level == 1 ? "press the dart down" : "press darts down";
    if (upright > 0) return upright == 1 ? "press the dart to the centre" : "press darts to the centre";
    return {};
}

PaperPiece piece_of(const Pattern& pattern, std::size_t index, bool are_pairs, const PaperPieceOptions& options) {
    const Panel& panel = pattern.panels[index];
    PaperPiece piece{.panel = static_cast<int>(index), .cut_from_fabric = panel.pieces * (are_pairs ? 2 : 1)};
    const std::vector<Dart> darts = find_darts(panel, piece.panel, pattern.seams);
    const CutLine cut =
        cut_line(panel, {.pattern_allowance = pattern.allowance, .chord_error = options.chord_error, .darts = darts});
    piece.sew = sewing_line(panel, options.chord_error);
    piece.has_allowance = std::ranges::any_of(
        panel.edges, [&](const OutlineEdge& edge) { return allowance_of(panel, edge, pattern.allowance) > 0; });
    piece.cut = piece.has_allowance ? cut.outline : piece.sew;
    piece.notches = cut.notches;
    if (piece.has_allowance) add_darts(piece, cut);
    piece.drill_points = panel.drill_points;
    for (const InternalLine& line : panel.internal_lines) {
        if (line.points.size() < 2) continue;
        piece.lines.push_back({line.use == LineUse::Fold ? PaperLayer::Fold : PaperLayer::Internal, line.points});
    }
    const std::optional<double> axis =
        options.are_halved && has_upright_grain(panel) ? fold_axis(piece.cut) : std::nullopt;
    if (axis) halve(piece, *axis);
    piece.label.lines = label_of(pattern, panel, piece, are_pairs);
    const bool is_cut_so = !piece.has_allowance || (cut.darts.size() == darts.size() &&
                                                    std::ranges::all_of(cut.darts, &DartLines::is_as_wanted));
    if (const std::string pressing = pressing_text(darts, is_cut_so); !pressing.empty())
        piece.label.lines.push_back(pressing);
    const std::vector<Vec2d> spots = spots_in(piece.sew);
    place_label(piece.label, piece, spots);
    PaperLine grain = grain_line(panel, piece, spots);
    if (!grain.points.empty()) piece.lines.push_back(std::move(grain));
    return piece;
}

}  // namespace

std::vector<Vec2d> right_of(const std::vector<Vec2d>& line, double x) {
    std::vector<Vec2d> kept;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec2d &a = line[i], &b = line[(i + 1) % line.size()];
        if (a.x() >= x) kept.push_back(a);
        if ((a.x() >= x) != (b.x() >= x)) kept.push_back(a + (b - a) * (x - a.x()) / (b.x() - a.x()));
    }
    return kept;
}

std::optional<double> fold_axis(const std::vector<Vec2d>& line) {
    constexpr double kOff = 0.5e-3;  // m
    Eigen::AlignedBox2d box;
    for (const Vec2d& p : line) box.extend(p);
    const double x = box.center().x();
    const bool is_symmetric = std::ranges::all_of(line, [&](const Vec2d& p) {
        return distance_to_outline({2 * x - p.x(), p.y()}, line) <= kOff;
    });
    return is_symmetric ? std::optional(x) : std::nullopt;
}

double text_width(std::string_view line) {
    constexpr double kCharacterWidth = 0.56;  // over the height
    const auto characters =
        std::ranges::count_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
    return kCharacterWidth * static_cast<double>(std::max<std::ptrdiff_t>(1, characters));
}

Eigen::AlignedBox2d label_box(const PaperLabel& label) {
    double longest = 0;
    for (const std::string& line : label.lines) longest = std::max(longest, text_width(line));
    Vec2d half(label.height * longest / 2, label.height * static_cast<double>(label.lines.size()) / 2);
    if (label.runs_up) std::swap(half.x(), half.y());
    return {label.at - half, label.at + half};
}

void move_label(PaperPiece& piece, const std::vector<Eigen::AlignedBox2d>& boxes) {
    constexpr double kLeast = 0.5;  // of its size
    const auto is_allowed = [&](const Eigen::AlignedBox2d& label) {
        return std::ranges::any_of(boxes, [&](const Eigen::AlignedBox2d& box) { return box.contains(label); });
    };
    if (is_allowed(label_box(piece.label))) return;
    PaperLabel label = piece.label;
    const Drawn drawn = drawn_inside(piece);
    const std::vector<LabelSpot> spots = by_room(spots_in(piece.sew), piece.sew, drawn);
    for (const double height : kLabelHeights) {
        if (height > piece.label.height || height < kLeast * piece.label.height) continue;
        label.height = height;
        if (fit_label(label, piece.sew, drawn, spots, is_allowed)) return void(piece.label = label);
    }
}

double PaperLabel::angle(double turn) const {
    constexpr double kHalf = std::numbers::pi / 2, kEven = 1e-6;  // rad
    const double angle = std::remainder(turn + (runs_up ? kHalf : 0), 2 * std::numbers::pi);
    if (angle > kHalf + kEven) return angle - std::numbers::pi;
    if (angle <= -kHalf + kEven) return angle + std::numbers::pi;
    return angle;
}

std::string_view layer_name(PaperLayer layer) {
    return kLayerNames[static_cast<std::size_t>(layer)];
}

std::optional<PaperLayer> find_layer(std::string_view name) {
    const auto found = std::ranges::find(kLayerNames, name);
    if (found == kLayerNames.end()) return std::nullopt;
    return static_cast<PaperLayer>(found - kLayerNames.begin());
}

Eigen::AlignedBox2d PaperPiece::box() const {
    Eigen::AlignedBox2d box;
    for (const Vec2d& p : cut) box.extend(p);
    return box;
}

std::vector<PaperPiece> paper_pieces(const Pattern& pattern, const PaperPieceOptions& options) {
    std::vector<PaperPiece> pieces;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const Panel& panel = pattern.panels[p];
        const bool is_image = std::ranges::any_of(pattern.panels, [&](const Panel& other) {
            return !panel.mirror_of.empty() && other.name == panel.mirror_of && other.mirror_of.empty();
        });
        if (is_image && !options.draws_mirror_images) continue;
        const bool are_pairs = !options.draws_mirror_images && has_twin(pattern, panel);
        pieces.push_back(piece_of(pattern, p, are_pairs, options));
    }
    return pieces;
}

}  // namespace selvedge::sim
