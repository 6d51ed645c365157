#include "sim/paper/placement_record.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/core/math.h"
#include "sim/paper/decimal_text.h"
#include "sim/paper/record_words.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/limits.h"
#include "sim/pattern/pattern_read.h"

namespace selvedge::sim {
namespace {

constexpr double kMillimetre = 1e-3;     // m
constexpr std::size_t kMostStarts = 16;  // that are written; all pairs of them are tried
constexpr double kSameDistance = 1e-4;   // m, between two distances that agree
constexpr double kLeastTurn = 1e-5;      // rad: less is the rounding of the file

std::string in_mm(const Vec2d& p) {
    return decimal_text(p.x() / kMillimetre) + " " + decimal_text(p.y() / kMillimetre);
}

Vec2d start_of_edge(const Panel& panel, std::size_t edge) {
    return panel.vertices[as_size(panel.edges[edge].start)];
}

// Evenly spread over the outline.
void add_starts(const Panel& panel, std::vector<std::string>& phrases) {
    const std::size_t step = (panel.edges.size() + kMostStarts - 1) / kMostStarts;
    for (std::size_t e = 0; e < panel.edges.size(); e += step)
        phrases.push_back("start " + std::to_string(e) + " " + in_mm(start_of_edge(panel, e)));
}

// On one line, and without the sign that parts phrases in SVG.
std::string one_phrase(std::string text) {
    for (char& c : text) {
        if (c == ';' || static_cast<unsigned char>(c) < 0x20) c = ' ';
    }
    return text;
}

bool read_wrap(std::string_view key, RecordWords& words, DrawnPlacement& placement) {
    if (key == "cylinder") {
        placement.stated.wrap_radius = kMillimetre * words.real();
        if (placement.stated.wrap_radius < 0) words.refuse();
        return words.is_good() && words.is_at_end();
    }
    const Vec2d apex = kMillimetre * words.point();
    const double sine = words.real();
    if (!(std::abs(sine) >= kLeastConeSine && std::abs(sine) <= 1)) return false;
    placement.stated.wrap_cone = WrapCone{.apex = apex, .sine = sine};
    return words.is_good() && words.is_at_end();
}

// From the paper to the panel frame: by the two starts whose distance is as it was and that put the most others in
// place; of equal ones, the farthest apart. Where a few corners were moved, the others tell. None: no two agree.
std::optional<Eigen::Affine2d> map_to_frame(const DrawnPath& outline,
                                            const std::vector<std::pair<int, Vec2d>>& starts) {
    std::vector<std::pair<Vec2d, Vec2d>> pairs;  // on the paper, in the frame
    for (const auto& [edge, in_frame] : starts) {
        if (as_size(edge) >= outline.edges.size()) return std::nullopt;
        pairs.emplace_back(outline.vertices[as_size(outline.edges[as_size(edge)].start)], in_frame);
    }
    std::optional<Eigen::Affine2d> best;
    std::pair<std::ptrdiff_t, double> most{0, 0};  // in place, and distance, m
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        for (std::size_t j = i + 1; j < pairs.size(); ++j) {
            const Vec2d from = pairs[j].first - pairs[i].first, to = pairs[j].second - pairs[i].second;
            if (to.norm() < 10 * kSameDistance || std::abs(from.norm() - to.norm()) > kSameDistance) continue;
            const double turn = std::atan2(cross2(from, to), from.dot(to));
            Eigen::Affine2d map = Eigen::Affine2d::Identity();
            map.translate(pairs[i].second);
            if (std::abs(turn) > kLeastTurn) map.rotate(turn);
            map.translate(-pairs[i].first);
            const auto count = std::ranges::count_if(
                pairs, [&](const auto& pair) { return (map * pair.first - pair.second).norm() < 2 * kSameDistance; });
            if (std::pair(count, to.norm()) <= most) continue;
            most = {count, to.norm()};
            best = map;
        }
    }
    return best;
}

// Whether a garment file may have such a panel.
bool is_near_origin(const Panel& panel) {
    Eigen::AlignedBox2d box = outline_box(panel);
    if (panel.wrap_cone) box.extend(panel.wrap_cone->apex);
    for (const OutlineEdge& edge : panel.edges) {
        for (const Vec2d& control : edge.control) box.extend(control);
    }
    return box.min().cwiseAbs().maxCoeff() < kMaxCoordinate && box.max().cwiseAbs().maxCoeff() < kMaxCoordinate;
}

}  // namespace

bool has_portable_placement(const Pattern& pattern) {
    return !is_body_file(pattern.body);
}

std::vector<std::string> placement_phrases(const Panel& panel) {
    std::vector<std::string> phrases;
    add_starts(panel, phrases);
    const Vec3d at = panel.translation / kMillimetre;
    phrases.push_back("at " + decimal_text(at.x()) + " " + decimal_text(at.y()) + " " + decimal_text(at.z()));
    if (!panel.rotation.isIdentity(1e-12)) {
        const Vec3d zyx = panel.rotation.eulerAngles(2, 1, 0) / kDegree;
        phrases.push_back("turned " + decimal_text(zyx[2]) + " " + decimal_text(zyx[1]) + " " + decimal_text(zyx[0]));
    }
    if (panel.is_mirrored) phrases.emplace_back("mirrored");
    if (panel.wrap_radius > 0) phrases.push_back("cylinder " + decimal_text(panel.wrap_radius / kMillimetre));
    if (panel.wrap_cone)
        phrases.push_back("cone " + in_mm(panel.wrap_cone->apex) + " " + decimal_text(panel.wrap_cone->sine));
    if (panel.layer != 0) phrases.push_back("layer " + std::to_string(panel.layer));
    if (!panel.label.empty()) phrases.push_back("label " + one_phrase(panel.label));
    for (const int pin : panel.pins) {
        const auto edge = std::ranges::find(panel.edges, pin, &OutlineEdge::start);
        if (edge != panel.edges.end()) phrases.push_back("pin " + std::to_string(edge - panel.edges.begin()));
    }
    if (!panel.is_worn) phrases.emplace_back("unworn");
    return phrases;
}

std::string body_phrase(const Pattern& pattern) {
    return decimal_text(pattern.body_height / kMillimetre) + " " + one_phrase(pattern.body);
}

bool read_placement_phrase(std::string_view phrase, DrawnPlacement& placement) {
    RecordWords words(phrase);
    const std::string_view key = words.word();
    if (key == "cylinder" || key == "cone") return read_wrap(key, words, placement);
    if (key == "label") return placement.stated.label = words.rest(), true;
    if (key == "mirrored") {
        placement.stated.is_mirrored = true;
    } else if (key == "unworn") {
        placement.stated.is_worn = false;
    } else if (key == "start") {
        const int edge = words.whole();
        placement.starts.emplace_back(edge, kMillimetre * words.point());
        if (placement.starts.size() > kMostStarts) words.refuse();
    } else if (key == "at") {
        placement.stated.translation = kMillimetre * words.point_in_space();
        if (placement.stated.translation.cwiseAbs().maxCoeff() > kMaxCoordinate) words.refuse();
    } else if (key == "turned") {
        placement.stated.rotation = rotation_from_degrees(words.point_in_space());
    } else if (key == "layer") {
        const double layer = std::round(words.real());
        if (std::abs(layer) > kHighestLayer) words.refuse();
        if (words.is_good()) placement.stated.layer = static_cast<int>(layer);
    } else if (key == "pin") {
        placement.pinned_edges.push_back(words.whole());
    } else {
        return false;
    }
    return words.is_good() && words.is_at_end();
}

std::optional<DrawnBody> read_body_phrase(std::string_view phrase) {
    RecordWords words(phrase);
    const double height = kMillimetre * words.real();
    const std::string text = words.rest();
    const bool is_height = height >= kLeastBodyHeight && height <= kGreatestBodyHeight;
    if (!words.is_good() || !is_height || is_body_file(text)) return std::nullopt;
    return DrawnBody{.text = text, .height = height};
}

bool place_as_drawn(Panel& panel, const DrawnPath& outline, const DrawnPlacement& placement) {
    if (panel.edges.size() != outline.edges.size()) return false;
    const std::optional<Eigen::Affine2d> map = map_to_frame(outline, placement.starts);
    if (!map) return false;
    Panel placed = mapped_panel(panel, *map);
    take_changes(placed, placement.stated);
    if (placed.wrap_cone) placed.wrap_radius = 0;
    for (const int edge : std::set(placement.pinned_edges.begin(), placement.pinned_edges.end())) {
        if (as_size(edge) < placed.edges.size()) placed.pins.push_back(placed.edges[as_size(edge)].start);
    }
    if (!is_near_origin(placed)) return false;
    panel = std::move(placed);
    return true;
}

}  // namespace selvedge::sim
