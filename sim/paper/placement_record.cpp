#include "sim/paper/placement_record.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "sim/paper/decimal_text.h"
#include "sim/paper/record_words.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/pattern_read.h"

namespace selvedge::sim {
namespace {

constexpr double kMillimetre = 1e-3;                       // m
constexpr double kFarthest = 100;                          // m, that a panel can be placed from the origin
constexpr double kDegree = std::numbers::pi / 180;         // rad
constexpr double kLeastSine = 0.01, kGreatestSine = 1;     // of a cone, as in garment files
constexpr double kLeastHeight = 0.3, kGreatestHeight = 3;  // m, of a body, as in garment files
constexpr double kShortest = 1e-6;                         // m, between two places that tell a direction

std::size_t as_size(int index) {
    return static_cast<std::size_t>(index);
}

std::string in_mm(const Vec2d& p) {
    return decimal_text(p.x() / kMillimetre) + " " + decimal_text(p.y() / kMillimetre);
}

Vec2d start_of_edge(const Panel& panel, std::size_t edge) {
    return panel.vertices[as_size(panel.edges[edge].start)];
}

// The first edge, and the one that begins farthest from its start.
std::string frame_phrase(const Panel& panel) {
    std::size_t far = 0;
    const auto distance = [&](std::size_t e) { return (start_of_edge(panel, e) - start_of_edge(panel, 0)).norm(); };
    for (std::size_t e = 1; e < panel.edges.size(); ++e) {
        if (distance(e) > distance(far)) far = e;
    }
    return "frame 0 " + in_mm(start_of_edge(panel, 0)) + " " + std::to_string(far) + " " +
           in_mm(start_of_edge(panel, far));
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
        placement.wrap_radius = kMillimetre * words.real();
        if (placement.wrap_radius < 0) words.refuse();
        return words.is_good();
    }
    const Vec2d apex = kMillimetre * words.point();
    const double sine = words.real();
    if (!(std::abs(sine) >= kLeastSine && std::abs(sine) <= kGreatestSine)) return false;
    placement.wrap_cone = WrapCone{apex, sine};
    return words.is_good();
}

}  // namespace

bool has_portable_placement(const Pattern& pattern) {
    return !is_body_file(pattern.body);
}

std::vector<std::string> placement_phrases(const Panel& panel) {
    std::vector<std::string> phrases{frame_phrase(panel)};
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
    if (key == "label") return placement.label = words.rest(), true;
    if (key == "mirrored") return placement.is_mirrored = true;
    if (key == "unworn") return placement.is_worn = false, true;
    if (key == "frame") {
        for (const std::size_t k : {0U, 1U}) {
            placement.edges[k] = words.whole();
            placement.starts[k] = kMillimetre * words.point();
        }
    } else if (key == "at") {
        placement.translation = kMillimetre * words.point_in_space();
        if (placement.translation.cwiseAbs().maxCoeff() > kFarthest) words.refuse();
    } else if (key == "turned") {
        placement.rotation = rotation_from_degrees(words.point_in_space());
    } else if (key == "layer") {
        const double layer = std::round(words.real());
        if (std::abs(layer) > kHighestLayer) words.refuse();
        if (words.is_good()) placement.layer = static_cast<int>(layer);
    } else if (key == "pin") {
        placement.pinned_edges.push_back(words.whole());
    } else {
        return false;
    }
    return words.is_good();
}

std::optional<DrawnBody> read_body_phrase(std::string_view phrase) {
    RecordWords words(phrase);
    const double height = kMillimetre * words.real();
    const std::string text = words.rest();
    const bool is_height = height >= kLeastHeight && height <= kGreatestHeight;
    if (!words.is_good() || !is_height || is_body_file(text)) return std::nullopt;
    return DrawnBody{.text = text, .height = height};
}

bool place_as_drawn(Panel& panel, const DrawnPath& outline, const DrawnPlacement& placement) {
    const auto has = [&](int edge) { return as_size(edge) < outline.edges.size(); };
    if (!has(placement.edges[0]) || !has(placement.edges[1]) || panel.edges.size() != outline.edges.size())
        return false;
    const auto drawn = [&](int edge) { return outline.vertices[as_size(outline.edges[as_size(edge)].start)]; };
    const Vec2d from = drawn(placement.edges[1]) - drawn(placement.edges[0]);
    const Vec2d to = placement.starts[1] - placement.starts[0];
    if (from.norm() < kShortest || to.norm() < kShortest) return false;
    const double turn = std::atan2(cross2(from, to), from.dot(to));
    // What is drawn upright stays so to the last bit: a cone's axis must be parallel to y.
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    map.translate(placement.starts[0]);
    if (std::abs(turn) > kDegree * 1e-3) map.rotate(turn);
    map.translate(-drawn(placement.edges[0]));
    panel = mapped_panel(panel, map);
    panel.translation = placement.translation;
    panel.rotation = placement.rotation;
    panel.is_mirrored = placement.is_mirrored;
    panel.wrap_cone = placement.wrap_cone;
    panel.wrap_radius = placement.wrap_cone ? 0 : placement.wrap_radius;
    panel.layer = placement.layer;
    panel.label = placement.label;
    panel.is_worn = placement.is_worn;
    for (const int edge : std::set(placement.pinned_edges.begin(), placement.pinned_edges.end())) {
        if (has(edge)) panel.pins.push_back(panel.edges[as_size(edge)].start);
    }
    return true;
}

}  // namespace selvedge::sim
