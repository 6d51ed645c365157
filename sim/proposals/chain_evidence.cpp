#include "sim/proposals/chain_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <optional>

#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSamples = 24;  // of a chain, for its shape

std::size_t as_size(int index) {
    return static_cast<std::size_t>(index);
}

std::string in_cm(double metres) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f", 100 * metres);
    return text.data();
}

// Adds evidence in words.
void add(Evidence& evidence, double odds, const std::string& reason = {}) {
    evidence.odds += odds;
    if (!reason.empty()) evidence.reason += (evidence.reason.empty() ? "" : "; ") + reason;
}

std::vector<int> panels_of(const OpenBoundary& boundary, const ChainView& view) {
    std::vector<int> panels;
    const std::vector<double> starts = boundary.starts(view.chain);
    const double shift = starts[as_size(view.first)];
    const std::size_t count = view.chain.atoms.size();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = (as_size(view.first) + k) % count;
        const double from = std::fmod(starts[i] - shift + 1, 1.0);
        const double to = from + boundary.atom(view.chain.atoms[i]).length / view.chain.length;
        if (to <= view.from + 1e-9 || from >= view.to - 1e-9) continue;
        const int panel = boundary.atom(view.chain.atoms[i]).span.panel;
        if (std::ranges::find(panels, panel) == panels.end()) panels.push_back(panel);
    }
    return panels;
}

bool is_one_of(GarmentPart part, std::initializer_list<GarmentPart> parts) {
    return std::ranges::find(parts, part) != parts.end();
}

bool are_parts(GarmentPart a, GarmentPart b, GarmentPart one, GarmentPart other) {
    return (a == one && b == other) || (a == other && b == one);
}

// ---- Shape.

std::vector<Vec2d> sampled(const OpenBoundary& boundary, const ChainView& view) {
    std::vector<Vec2d> points;
    for (int i = 0; i <= kSamples; ++i) {
        const ChainPlace place = place_on(boundary, view, static_cast<double>(i) / kSamples);
        points.push_back(boundary.point(place.atom, place.t));
    }
    return points;
}

double length_of(const std::vector<Vec2d>& points) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    return length;
}

// Root mean square distance of two curves over their length, after the best rotation. (Kabsch 1976)
double shape_difference(std::vector<Vec2d> a, std::vector<Vec2d> b, bool is_mirrored) {
    const auto centre = [](std::vector<Vec2d>& points) {
        Vec2d mean = Vec2d::Zero();
        for (const Vec2d& p : points) mean += p;
        mean /= static_cast<double>(points.size());
        const double length = length_of(points);
        for (Vec2d& p : points) p = (p - mean) / std::max(length, 1e-12);
    };
    centre(a);
    centre(b);
    if (is_mirrored) {
        for (Vec2d& p : b) p.x() = -p.x();
    }
    double cosine = 0, sine = 0, squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        cosine += a[i].dot(b[i]);
        sine += cross2(b[i], a[i]);
        squares += a[i].squaredNorm() + b[i].squaredNorm();
    }
    return std::sqrt(std::max(0.0, squares - 2 * std::hypot(cosine, sine)) / static_cast<double>(a.size()));
}

double straightness(const std::vector<Vec2d>& points) {
    return (points.back() - points.front()).norm() / std::max(length_of(points), 1e-12);
}

void weigh_shape(Evidence& evidence, const std::vector<Vec2d>& a, std::vector<Vec2d> b) {
    std::ranges::reverse(b);
    if (straightness(a) > 0.9995 && straightness(b) > 0.9995) return add(evidence, 0.3);
    const double flat = shape_difference(a, b, false), mirrored = shape_difference(a, b, true);
    const double least = std::min(flat, mirrored);
    if (least < 0.0015) return add(evidence, 2.0, "same shape");
    if (least < 0.006) return add(evidence, 1.0, "like shape");
    if (least < 0.025) return add(evidence, 0);
    add(evidence, least < 0.06 ? -0.7 : -2);
}

// ---- Direction.

constexpr double kUpright = 0.75;  // least rise of an upright stretch

// The rise of a stretch over its length, -1..1: of an upright one about 1 or -1.
double rise(const std::vector<Vec2d>& points) {
    return (points.back().y() - points.front().y()) / std::max(length_of(points), 1e-12);
}

// The parts of a view that lie on one atom each.
std::vector<std::pair<Vec2d, Vec2d>> chords_of(const OpenBoundary& boundary, const ChainView& view) {
    std::vector<double> stops = joints_of(boundary, view);
    stops.insert(stops.begin(), 0);
    stops.push_back(1);
    std::vector<std::pair<Vec2d, Vec2d>> chords;
    constexpr double kInside = 1e-7;  // so that a joint's place is on the atom that is meant
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const ChainPlace from = place_on(boundary, view, stops[i] + kInside);
        const ChainPlace to = place_on(boundary, view, stops[i + 1] - kInside);
        chords.emplace_back(boundary.point(from.atom, from.t), boundary.point(to.atom, to.t));
    }
    return chords;
}

// How far the cloth's edge looks up, -1..1: -1 at a hem, 0 at a side, 1 at the top.
double facing_up(const OpenBoundary& boundary, const ChainView& view) {
    double up = 0;
    for (const auto& [from, to] : chords_of(boundary, view)) up -= to.x() - from.x();
    return up / length_of(view);
}

// How far the stretch bulges out of its panel, as an area over the square of its length: negative for an armhole.
double bulge(const std::vector<Vec2d>& points) {
    double area = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        area += cross2(points[i - 1] - points[0], points[i] - points[0]) / 2;
    const double length = length_of(points);
    return area / std::max(1e-12, length * length);
}

// Whether neither neighbour in its panel is curved, as the hem of a sleeve lies between its two straight seams.
bool is_sleeve_hem(const OpenBoundary& boundary, const ChainView& view) {
    constexpr double kCurved = 0.012;
    const EdgeSpan& first = boundary.atom(view.chain.atoms.front()).span;
    const EdgeSpan& last = boundary.atom(view.chain.atoms.back()).span;
    const Panel& panel = boundary.pattern().panels[as_size(first.panel)];
    const std::size_t count = panel.edges.size();
    const auto is_curved = [&](std::size_t edge) {
        return std::abs(bulge(outline_polyline(panel, panel.edges[edge], 1e-3))) > kCurved;
    };
    return !is_curved((as_size(first.edge) + count - 1) % count) && !is_curved((as_size(last.edge) + 1) % count);
}

// Two hems are not sewn to each other, nor two waists, nor two armholes or necklines.
void weigh_facing(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b,
                  GarmentPart part_a, GarmentPart part_b, bool are_twins) {
    using enum GarmentPart;
    if (part_a == Sleeve && part_b == Sleeve) {  // may be drawn along the arm
        if (is_sleeve_hem(boundary, a) && is_sleeve_hem(boundary, b)) add(evidence, -5);
        return;
    }
    const double up_a = facing_up(boundary, a), up_b = facing_up(boundary, b);
    constexpr double kLevel = 0.75;
    if (up_a < -kLevel && up_b < -kLevel) return add(evidence, -5);
    if (std::min(up_a, up_b) < -kLevel && std::max(up_a, up_b) > kLevel) return add(evidence, 0.8);
    const bool has_shoulder = is_one_of(part_a, {Torso, Yoke, Hood, Unknown}) || is_one_of(part_b, {Torso, Yoke, Hood});
    if (up_a > kLevel && up_b > kLevel && (!has_shoulder || (are_twins && part_a != Hood))) add(evidence, -5);
}

void weigh_bulges(Evidence& evidence, const std::vector<Vec2d>& a, const std::vector<Vec2d>& b, bool may_be_hollow) {
    constexpr double kConcave = -0.03, kConvex = 0.06;
    if (may_be_hollow) return;
    const double one = bulge(a), other = bulge(b);
    if (one < kConcave && other < kConcave) return add(evidence, -4);
    if (one > kConvex && other > kConvex) add(evidence, -2);
}

bool is_single(const std::vector<int>& panels) {
    return panels.size() == 1;
}

// What is up in one panel is up in the other, if both are drawn upright.
void weigh_upright(Evidence& evidence, const std::vector<Vec2d>& a, const std::vector<Vec2d>& b) {
    const double rise_a = rise(a), rise_b = -rise(b);  // b is sewn backwards
    if (std::abs(rise_a) < kUpright && std::abs(rise_b) < kUpright) return;
    if (std::abs(rise_a) > kUpright && std::abs(rise_b) > kUpright) {
        if (rise_a * rise_b > 0) return add(evidence, 0.8);
        evidence.is_possible = false;
        return;
    }
    if (std::min(std::abs(rise_a), std::abs(rise_b)) < 0.35) add(evidence, -1.5);
}

// ---- Roles.

// The odds for two different panels whose parts the names tell.
double odds_of_parts(const PanelRole& a, const PanelRole& b) {
    using enum GarmentPart;
    if (a.part == Accessory || b.part == Accessory) return -6;
    if (a.part == Unknown || b.part == Unknown) return 0;
    if (a.part == b.part) {
        const bool are_opposite = a.face != b.face && a.face != Face::None && b.face != Face::None;
        const bool are_choices = a.part == Sleeve && a.face == Face::None && b.face == Face::None;  // long or short
        return are_opposite ? 1.5 : are_choices ? -4 : 0.3;
    }
    struct Row {
        GarmentPart one, other;
        double odds;
    };
    constexpr std::array rows = std::to_array<Row>(
        {{Torso, Sleeve, 1.2},      {Torso, Yoke, 1.2},       {Yoke, Sleeve, 0.8},     {Torso, Collar, 0.8},
         {Torso, CollarStand, 1.0}, {Yoke, CollarStand, 0.6}, {Yoke, Collar, 0.4},     {Collar, CollarStand, 1.2},
         {Torso, Hood, 1.0},        {Sleeve, Cuff, 1.5},      {Waistband, Skirt, 1.5}, {Waistband, Leg, 1.5},
         {Waistband, Torso, 1.0},   {Torso, Skirt, 1.2},      {Torso, Leg, 1.0},       {Yoke, Leg, 0.8},
         {Yoke, Skirt, 0.8},        {Torso, Binding, 0.8},    {Sleeve, Binding, 0.3},  {Leg, Cuff, 0.8},
         {Leg, Binding, 0.3},       {Skirt, Binding, 0.3}});
    for (const Row& row : rows) {
        if (are_parts(a.part, b.part, row.one, row.other)) return row.odds;
    }
    return -4;
}

// The side of the wearer that a stretch lies on: by the panel's name, or where it lies on a symmetric panel.
Flank flank_of(const PanelFacts& facts, const std::vector<Vec2d>& points) {
    if (facts.role.flank != Flank::None) return facts.role.flank;
    if (!facts.is_symmetric || facts.role.face == Face::None) return Flank::None;
    double mean = 0;
    for (const Vec2d& p : points) mean += p.x() - facts.axis;
    mean /= static_cast<double>(points.size());
    if (std::abs(mean) < 0.05 * facts.width) return Flank::None;
    // Seen from outside, a front's right is the wearer's left; a back's is the wearer's right.
    return (mean > 0) == (facts.role.face == Face::Front) ? Flank::Left : Flank::Right;
}

// Names the pair in the report.
std::string text_of(const PanelRole& role, const Panel& panel) {
    return role.part == GarmentPart::Unknown ? panel.name : std::string(name_of(role.part));
}

bool are_twins(const std::vector<PanelFacts>& facts, int a, int b) {
    const PanelRole& one = facts[as_size(a)].role;
    const PanelRole& other = facts[as_size(b)].role;
    if (facts[as_size(a)].twin == b) return true;
    return one.part == other.part && one.face == other.face && one.flank != other.flank && one.flank != Flank::None &&
           other.flank != Flank::None;
}

// Whether one chain runs over the mirror image of what the other runs over, as left and right armholes do.
bool have_twins(const std::vector<PanelFacts>& facts, const std::vector<int>& a, const std::vector<int>& b) {
    return std::ranges::any_of(
        a, [&](int one) { return std::ranges::any_of(b, [&](int other) { return are_twins(facts, one, other); }); });
}

constexpr double kNever = -100;  // odds

// Mirror images are sewn to each other in the middle of the body, when their other sides have found their seams.
double odds_of_twins(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, int a, int b,
                     bool are_chains) {
    const PanelFacts& one = facts[as_size(a)];
    if (is_one_of(one.role.part, {GarmentPart::Sleeve, GarmentPart::Cuff})) return kNever;
    if (are_chains) return one.role.part == GarmentPart::Leg ? 1.5 : kNever;
    if (one.role.face == Face::Front && one.role.part == GarmentPart::Torso && one.has_opening) return -4;
    const auto is_joined = [&](int panel) { return boundary.joined_panels(panel).size() > 0; };
    return is_joined(a) && is_joined(b) ? 0.3 : -2.5;
}

void weigh_two_panels(Evidence& evidence, const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, int a,
                      int b, bool are_chains) {
    const PanelFacts& one = facts[as_size(a)];
    const PanelFacts& other = facts[as_size(b)];
    if (are_twins(facts, a, b)) return add(evidence, odds_of_twins(boundary, facts, a, b, are_chains));
    const double odds = odds_of_parts(one.role, other.role);
    if (odds <= -6) evidence.is_possible = false;
    add(evidence, odds);
    if (are_chains && one.role.part == other.role.part) return add(evidence, -2);
    if (are_chains) return;
    const std::vector<int> joined = boundary.joined_panels(a);
    const auto is_joined_to = [&](int panel) { return std::ranges::find(joined, panel) != joined.end(); };
    if (is_joined_to(b)) {
        add(evidence, 0.8);
    } else if (other.twin >= 0 && other.twin != a && is_joined_to(other.twin)) {
        add(evidence, -2);
    }
}

// Halves of a torso that are sewn at one side would close round a leg at the other.
void weigh_other_side(Evidence& evidence, const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, int a,
                      int b, const std::vector<Vec2d>& points) {
    const PanelFacts& one = facts[as_size(a)];
    if (a == b || (one.twin < 0 && one.role.flank == Flank::None) || std::abs(rise(points)) < kUpright) return;
    const double x = points[points.size() / 2].x();
    for (const int atom : boundary.atoms_between(a, b)) {
        const Vec2d from = boundary.point(atom, 0), to = boundary.point(atom, 1);
        const bool is_upright = std::abs(to.y() - from.y()) > kUpright * (to - from).norm();
        if (is_upright && std::abs((from.x() + to.x()) / 2 - x) > 0.5 * one.width) return add(evidence, -5);
    }
}

void weigh_flanks(Evidence& evidence, Flank a, Flank b) {
    if (a == Flank::None || b == Flank::None) return;
    add(evidence, a == b ? 0.7 : -2.5);
}

// ---- A panel with itself.

// The legs of a dart: neighbours in one panel, from the mouth inwards and out again.
bool is_dart(const OpenBoundary& boundary, const ChainView& a, const ChainView& b) {
    constexpr double kApex = 2 * kPi - 0.6;  // rad, inside the cloth; a V-neck is wider
    const auto are_legs = [&](const ChainView& one, const ChainView& other) {
        const OpenBoundary::Step step = boundary.next(one.chain.atoms.back());
        return step.atom == other.chain.atoms.front() && step.seams == 0 && step.angle > kApex;
    };
    return are_legs(a, b) || are_legs(b, a);
}

// Whether a notch near an end of a strip says that it goes on beyond the seam, for a button.
bool has_overlap(const OpenBoundary& boundary, int atom) {
    constexpr double kNear = 0.15;
    const Panel& panel = boundary.pattern().panels[as_size(boundary.atom(atom).span.panel)];
    return std::ranges::any_of(panel.notches, [&](const Notch& notch) {
        const double length = outline_length(panel, panel.edges[as_size(notch.edge)]);
        const double to_end = std::min(notch.t, 1 - notch.t);
        return to_end < kNear && to_end * length > 0.004;
    });
}

void weigh_one_panel(Evidence& evidence, const OpenBoundary& boundary, const PanelFacts& facts, const ChainView& a,
                     const ChainView& b, const std::vector<Vec2d>& points_a, const std::vector<Vec2d>& points_b) {
    using enum GarmentPart;
    if (is_dart(boundary, a, b)) return add(evidence, 4, "legs of a dart");
    const GarmentPart part = facts.role.part;
    const bool is_tube = is_one_of(part, {Sleeve, Leg, Skirt, Cuff, Binding, Waistband});
    if (!is_tube || facts.has_other_face) return add(evidence, -3);
    if (part == Waistband && has_overlap(boundary, a.chain.atoms[0])) return add(evidence, -3);
    const auto middle = [](const std::vector<Vec2d>& points) { return points[points.size() / 2]; };
    const Vec2d apart = (middle(points_a) - middle(points_b)).cwiseAbs();
    const double longer = std::max(facts.width, facts.height), shorter = std::min(facts.width, facts.height);
    constexpr double kStrip = 2.5;  // longer than that: only its ends close it
    const bool is_strip = longer > kStrip * shorter;
    const bool are_opposite = is_strip ? apart.norm() > 0.8 * longer : apart.x() > 0.5 * facts.width;
    if (are_opposite) return add(evidence, part == Waistband ? 0.5 : 1.5, "closes a tube");
    add(evidence, -3);
}

// ---- Notches.

struct ChainNotch {
    double at = 0;  // m, from the start of the view
    int count = 1;
};

std::vector<ChainNotch> notches_on(const OpenBoundary& boundary, const ChainView& view) {
    const std::vector<double> starts = boundary.starts(view.chain);
    const double shift = starts[as_size(view.first)];
    std::vector<ChainNotch> found;
    for (const AtomNotch& notch : notches_of(boundary, view.chain)) {
        const double share = boundary.atom(view.chain.atoms[notch.atom]).length / view.chain.length;
        const double at = std::fmod(starts[notch.atom] - shift + 1, 1.0) + notch.t * share;
        const double in_view = (at - view.from) * view.chain.length;
        constexpr double kAtEnd = 0.003;  // m: a notch at an end marks the end
        if (in_view < kAtEnd || in_view > length_of(view) - kAtEnd) continue;
        found.push_back({in_view, notch.count});
    }
    return found;
}

// Whether only a part of the chain is sewn: parts begin and end at notches.
bool is_part(const ChainView& view) {
    return view.from > 0 || view.to < 1;
}

// The part of the length by which a notch may lie elsewhere, for ease lies between notches.
void weigh_notches(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b) {
    if (is_part(a) || is_part(b)) add(evidence, 1.0, "ends at a notch");
    const std::vector<ChainNotch> on_a = notches_on(boundary, a), on_b = notches_on(boundary, b);
    if (on_a.empty() && on_b.empty()) return;
    if (on_a.empty() || on_b.empty()) return add(evidence, -0.3);
    const double length = length_of(b);
    const double ease = std::abs(length_of(a) - length) + 0.004;  // m
    int met = 0, wrong = 0;
    for (const ChainNotch& notch : on_a) {
        double least = std::numeric_limits<double>::infinity();
        int count = 0;
        for (const ChainNotch& other : on_b) {
            const double distance = std::abs(notch.at - (length - other.at));
            if (distance < least) least = distance, count = other.count;
        }
        if (least > ease) continue;
        ++(count == notch.count ? met : wrong);
    }

    if (met > 0) add(evidence, std::min(3.0, 1.5 * met), met == 1 ? "a notch meets" : "notches meet");
    if (wrong > 0) add(evidence, -2.5 * wrong);
    if (met + wrong == 0) add(evidence, -0.8);
}

// ---- Lengths and ends.

bool may_be_gathered(const PanelRole& a, const PanelRole& b) {
    using enum GarmentPart;
    return are_parts(a.part, b.part, Torso, Yoke) || are_parts(a.part, b.part, Skirt, Waistband) ||
           are_parts(a.part, b.part, Skirt, Torso) || are_parts(a.part, b.part, Sleeve, Cuff) ||
           are_parts(a.part, b.part, Leg, Cuff);
}

void weigh_lengths(Evidence& evidence, const ChainView& a, const ChainView& b, const PanelRole& role_a,
                   const PanelRole& role_b) {
    using enum GarmentPart;
    const double one = length_of(a), other = length_of(b);
    const double part = std::abs(one - other) / std::max(one, other);
    const std::string text = "lengths " + in_cm(one) + " and " + in_cm(other) + " cm";
    const bool is_cap = are_parts(role_a.part, role_b.part, Sleeve, Torso);
    const bool is_stretched = role_a.part == Binding || role_b.part == Binding;
    if (part < 0.0015) return add(evidence, 2.8, text);
    if (part < 0.006) return add(evidence, 2.2, text);
    if (part < 0.015) return add(evidence, 1.4, text);
    if (part < 0.035) return add(evidence, is_cap ? 1.2 : 0.4, text);
    if (part < 0.08 && is_cap) return add(evidence, 0.6, text + " (ease)");
    if (part < 0.15 && is_stretched) return add(evidence, 0.6, text + " (stretched)");
    if (part < 0.08) return add(evidence, -1, text);
    if (part < 0.6 && may_be_gathered(role_a, role_b)) return add(evidence, -0.2, text + " (gathered)");
    if (part < 0.15) return add(evidence, -3, text);
    evidence.is_possible = false;
}

// Across a seam, the outline goes on without a corner.
void weigh_ends(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b) {
    const auto of = [](double angle) {
        const double off = std::abs(angle - kPi) * 180 / kPi;
        return off < 8 ? 0.7 : off < 20 ? 0.3 : off < 45 ? -0.3 : -0.9;
    };
    if (a.chain.is_loop || b.chain.is_loop) return;
    // Where both chains meet already, their angle says nothing.
    const bool has_start = a.from == 0 && b.to == 1 && boundary.next(b.chain.atoms.back()).atom != a.chain.atoms[0];
    const bool has_end = a.to == 1 && b.from == 0 && boundary.next(a.chain.atoms.back()).atom != b.chain.atoms[0];
    if (has_start) add(evidence, of(a.chain.angle_before + b.chain.angle_after));
    if (has_end) add(evidence, of(a.chain.angle_after + b.chain.angle_before));
}

// Seams that end at the same place of both chains: a side seam under the middle of a sleeve's.
void weigh_joints(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b) {
    const std::vector<double> on_a = joints_of(boundary, a), on_b = joints_of(boundary, b);
    int met = 0;
    for (const double t : on_a) {
        for (const double s : on_b) met += std::abs(t - (1 - s)) < 0.015 ? 1 : 0;
    }
    if (met > 0) add(evidence, std::min(1.0, 0.4 * met));
}

// Fronts lie on fronts, left on left, all along a seam that runs over several panels.
void weigh_faces(Evidence& evidence, const OpenBoundary& boundary, const std::vector<PanelFacts>& facts,
                 const ChainView& a, const ChainView& b) {
    constexpr double kWorth = 1.5;  // of full agreement
    int faces = 0, flanks = 0;
    const auto place = [&](const ChainView& view, double t) {
        const ChainPlace at = place_on(boundary, view, t);
        const PanelFacts& panel = facts[as_size(boundary.atom(at.atom).span.panel)];
        return std::pair(panel.role.face, flank_of(panel, {boundary.point(at.atom, at.t)}));
    };
    for (int i = 0; i < kSamples; ++i) {
        const double t = (i + 0.5) / kSamples;
        const auto [face_a, flank_a] = place(a, t);
        const auto [face_b, flank_b] = place(b, 1 - t);
        if (face_a != Face::None && face_b != Face::None) faces += face_a == face_b ? 1 : -1;
        if (flank_a != Flank::None && flank_b != Flank::None) flanks += flank_a == flank_b ? 1 : -1;
    }
    add(evidence, kWorth * (faces + flanks) / kSamples);
}

// Bindings are named after the opening that they edge: necks lie on both sides of the body, armholes on one.
void weigh_binding(Evidence& evidence, const OpenBoundary& boundary, const std::vector<PanelFacts>& facts,
                   const ChainView& binding, const ChainView& opening) {
    const Panel& panel = boundary.pattern().panels[as_size(boundary.atom(binding.chain.atoms[0]).span.panel)];
    if (!boundary.joined_panels(boundary.atom(binding.chain.atoms[0]).span.panel).empty()) add(evidence, -4);
    const std::vector<std::string> words = words_of_name(panel.name);
    const auto has = [&](std::string_view start) {
        return std::ranges::any_of(words, [&](const std::string& word) { return word.starts_with(start); });
    };
    int left = 0, right = 0;
    for (int i = 0; i < kSamples; ++i) {
        const ChainPlace at = place_on(boundary, opening, (i + 0.5) / kSamples);
        const PanelFacts& own = facts[as_size(boundary.atom(at.atom).span.panel)];
        const Flank flank = flank_of(own, {boundary.point(at.atom, at.t)});
        left += flank == Flank::Left ? 1 : 0;
        right += flank == Flank::Right ? 1 : 0;
    }
    const bool is_one_sided = std::min(left, right) == 0 && left + right > 0;
    const bool is_low = facing_up(boundary, opening) < -0.5;
    if (has("neck")) add(evidence, !is_one_sided && !is_low ? 3.5 : -4, "named after the neck");
    if (has("arm")) add(evidence, is_one_sided ? 3.5 : -4, "named after the arm");
    if (has("hem") || has("waist")) add(evidence, is_low ? 2.5 : -3);
}

// The lowest place of a closed chain is the lowest of the other: the underarm.
void weigh_lowest(Evidence& evidence, const std::vector<Vec2d>& a, const std::vector<Vec2d>& b) {
    const auto share = [](const std::vector<Vec2d>& points) {
        const auto [low, high] = std::ranges::minmax_element(points, {}, [](const Vec2d& p) { return p.y(); });
        return (points.front().y() - low->y()) / std::max(1e-9, high->y() - low->y());
    };
    if (share(a) < 0.1 && share(b) < 0.1) add(evidence, 0.8);
    if ((share(a) < 0.1) != (share(b) < 0.1)) add(evidence, -0.8);
}

}  // namespace

Evidence weigh(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const ChainView& first,
               const ChainView& second) {
    constexpr double kPrior = -4.0;  // of two chains taken at random
    Evidence evidence;
    evidence.odds = kPrior;
    const std::vector<int> panels_a = panels_of(boundary, first), panels_b = panels_of(boundary, second);
    const PanelFacts& a = facts[as_size(panels_a[0])];
    const PanelFacts& b = facts[as_size(panels_b[0])];
    weigh_lengths(evidence, first, second, a.role, b.role);
    if (!evidence.is_possible) return evidence;
    const std::vector<Vec2d> points_a = sampled(boundary, first), points_b = sampled(boundary, second);
    const bool are_single = is_single(panels_a) && is_single(panels_b);
    if (are_single && panels_a == panels_b) {
        weigh_one_panel(evidence, boundary, a, first, second, points_a, points_b);
    } else {
        const auto flank = [&](const PanelFacts& one, const std::vector<int>& panels,
                               const std::vector<Vec2d>& points) {
            return is_single(panels) ? flank_of(one, points) : Flank::None;
        };
        const Pattern& pattern = boundary.pattern();
        add(evidence, 0,
            text_of(a.role, pattern.panels[as_size(panels_a[0])]) + " to " +
                text_of(b.role, pattern.panels[as_size(panels_b[0])]));
        if (!are_single && a.role.part != GarmentPart::Leg && have_twins(facts, panels_a, panels_b))
            evidence.is_possible = false;
        weigh_two_panels(evidence, boundary, facts, panels_a[0], panels_b[0], !are_single);
        if (!are_twins(facts, panels_a[0], panels_b[0]))
            weigh_flanks(evidence, flank(a, panels_a, points_a), flank(b, panels_b, points_b));
    }
    const bool are_alike =
        a.role.part == b.role.part || a.role.part == GarmentPart::Unknown || b.role.part == GarmentPart::Unknown;
    if (are_single && are_alike) {
        weigh_shape(evidence, points_a, points_b);
        const bool are_crotches_or_hoods =
            is_one_of(a.role.part, {GarmentPart::Leg, GarmentPart::Hood}) && are_twins(facts, panels_a[0], panels_b[0]);
        weigh_bulges(evidence, points_a, points_b, are_crotches_or_hoods);
        if (is_one_of(a.role.part, {GarmentPart::Torso, GarmentPart::Skirt}) && a.role.part == b.role.part)
            weigh_other_side(evidence, boundary, facts, panels_a[0], panels_b[0], points_a);
        if (!is_dart(boundary, first, second)) weigh_upright(evidence, points_a, points_b);
    }
    if (panels_a != panels_b)
        weigh_facing(evidence, boundary, first, second, a.role.part, b.role.part,
                     are_twins(facts, panels_a[0], panels_b[0]));
    const bool are_loops = first.chain.is_loop && second.chain.is_loop;
    if (are_loops && a.role.part == b.role.part && a.role.part != GarmentPart::Unknown) evidence.is_possible = false;
    if (a.role.part == GarmentPart::Binding && b.role.part != GarmentPart::Binding)
        weigh_binding(evidence, boundary, facts, first, second);
    if (b.role.part == GarmentPart::Binding && a.role.part != GarmentPart::Binding)
        weigh_binding(evidence, boundary, facts, second, first);
    if (!are_single) weigh_faces(evidence, boundary, facts, first, second);
    if (are_parts(a.role.part, b.role.part, GarmentPart::Torso, GarmentPart::Sleeve) && first.chain.is_loop &&
        second.chain.is_loop) {
        weigh_lowest(evidence, points_a, points_b);
    }
    weigh_ends(evidence, boundary, first, second);
    weigh_joints(evidence, boundary, first, second);
    weigh_notches(evidence, boundary, first, second);
    return evidence;
}

}  // namespace selvedge::sim
