#include "sim/proposals/chain_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <optional>

#include "sim/core/math.h"
#include "sim/pattern/outline.h"
#include "sim/proposals/chain_shape.h"
#include "sim/proposals/elbow_evidence.h"
#include "sim/proposals/outline_neighbours.h"
#include "sim/proposals/twin_evidence.h"

namespace selvedge::sim {
namespace {

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

// Both sides of a seam that is weighed.
struct Sides {
    const ChainView& a;
    const ChainView& b;
    std::vector<int> panels_a, panels_b;  // that they run over
    std::vector<Vec2d> points_a, points_b;

    bool are_single() const { return panels_a.size() == 1 && panels_b.size() == 1; }
};

// Whether the panels are one and its mirror image at most, as the halves of a back are.
bool is_of_one_kind(const std::vector<PanelFacts>& facts, const std::vector<int>& panels) {
    return panels.size() == 1 || (panels.size() == 2 && facts[as_size(panels[0])].twin == panels[1]);
}

// ---- Shape and direction.

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

// Two hems are not sewn to each other, nor two waists, nor two armholes or necklines.
void weigh_facing(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b,
                  const PanelRole& role_a, const PanelRole& role_b) {
    using enum GarmentPart;
    const GarmentPart part_a = role_a.part, part_b = role_b.part;
    if (part_a == Sleeve && part_b == Sleeve) {  // may be drawn along the arm
        if (is_sleeve_hem(boundary, a) && is_sleeve_hem(boundary, b)) add(evidence, -5);
        return;
    }
    const double up_a = facing_up(boundary, a), up_b = facing_up(boundary, b);
    constexpr double kLevel = 0.75;
    // Skirts and trousers hang from their waistband, and a bodice ends in it.
    const auto hangs_wrong = [&](GarmentPart part, double up) {
        return (is_one_of(part, {Leg, Skirt}) && up < -kLevel) || (part == Torso && up > kLevel);
    };
    const bool are_levels = part_a != part_b && is_one_of(part_a, {Waistband, Torso, Leg, Skirt}) &&
                            is_one_of(part_b, {Waistband, Torso, Leg, Skirt});
    if (are_levels && (hangs_wrong(part_a, up_a) || hangs_wrong(part_b, up_b))) return add(evidence, -6);
    // Hems may be cut in teeth.
    constexpr double kTooth = 0.6;
    const bool are_faces = part_a == Torso && part_b == Torso && role_a.face != role_b.face;
    const double low = are_faces ? -kTooth : -kLevel;
    if (up_a < low && up_b < low) return add(evidence, -5);
    if (std::min(up_a, up_b) < -kLevel && std::max(up_a, up_b) > kLevel) {
        // What hangs from a panel is of its face; a front's hem is not sewn to a back's top.
        const bool are_opposite = role_a.face != role_b.face && role_a.face != Face::None && role_b.face != Face::None;
        const bool is_yoke_above = (part_a == Yoke && part_b == Torso && role_b.face == Face::Back && up_a < 0) ||
                                   (part_b == Yoke && part_a == Torso && role_a.face == Face::Back && up_b < 0);
        if (is_yoke_above) return add(evidence, 4, "the back hangs from the yoke");
        return add(evidence, are_opposite && part_a == part_b ? -5 : 0.8);
    }
    const bool has_shoulder = is_one_of(part_a, {Torso, Yoke, Hood, Unknown}) || is_one_of(part_b, {Torso, Yoke, Hood});
    if (up_a > kLevel && up_b > kLevel && !has_shoulder) add(evidence, -5);
}

void weigh_bulges(Evidence& evidence, const std::vector<Vec2d>& a, const std::vector<Vec2d>& b) {
    constexpr double kConcave = -0.03, kConvex = 0.06;
    const double one = bulge(a), other = bulge(b);
    if (one < kConcave && other < kConcave) return add(evidence, -4);
    if (one > kConvex && other > kConvex) add(evidence, -2);
}

bool is_single(const std::vector<int>& panels) {
    return panels.size() == 1;
}

// Panels on both sides of a seam: whether there is a sleeve, and whether there is another panel.
struct Shared {
    bool is_sleeve = false, is_other = false;
};
Shared shared_panels(const std::vector<int>& a, const std::vector<int>& b, const std::vector<PanelFacts>& facts) {
    Shared shared;
    for (const int panel : a) {
        if (std::ranges::find(b, panel) == b.end()) continue;
        (facts[as_size(panel)].role.part == GarmentPart::Sleeve ? shared.is_sleeve : shared.is_other) = true;
    }
    return shared;
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

// Whether a half of the body would be sewn to both sides of a panel that spans its middle, or to the side of its mirror
// image. points: of the chain on the whole panel.
bool is_on_wrong_side(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, int half, int whole,
                      const std::vector<Vec2d>& points) {
    const PanelFacts& facts_of_whole = facts[as_size(whole)];
    const int twin = facts[as_size(half)].twin;
    if (twin < 0 || !facts_of_whole.is_symmetric) return false;
    const auto side_of = [&](double x) {
        const double off = x - facts_of_whole.axis;
        return std::abs(off) < 0.05 * facts_of_whole.width ? 0 : off < 0 ? -1 : 1;
    };
    double mean = 0;
    for (const Vec2d& p : points) mean += p.x() / static_cast<double>(points.size());
    const int side = side_of(mean);
    const auto is_sewn_at = [&](int panel, int where) {
        return std::ranges::any_of(boundary.atoms_between(whole, panel), [&](int atom) {
            return where != 0 && side_of((boundary.point(atom, 0).x() + boundary.point(atom, 1).x()) / 2) == where;
        });
    };
    return is_sewn_at(half, -side) || is_sewn_at(twin, side);
}

// Whether a level line at the top runs from the side of a whole panel inwards, and leaves room for the neck.
bool is_level_shoulder(const PanelFacts& facts, const std::vector<Vec2d>& points) {
    const double from = points.front().x(), to = points.back().x();
    return facts.is_symmetric && (is_at_side(facts, from) || is_at_side(facts, to)) &&
           std::abs(from - to) < kWidestShoulder * facts.width;
}

// The shoulders of a front and a back or a yoke: straight, at the top, and sloping away from the neck, which meets the
// neck; or level, from the sides inwards.
double odds_of_shoulders(const OpenBoundary& boundary, const PanelFacts& facts_a, const PanelFacts& facts_b,
                         const Sides& sides) {
    const PanelRole &a = facts_a.role, &b = facts_b.role;
    constexpr double kUp = 0.75, kSlope = 0.08;
    const auto is_front = [](const PanelRole& one) {
        return one.part == GarmentPart::Torso && one.face == Face::Front;
    };
    const auto is_behind = [](const PanelRole& one) {
        return one.part == GarmentPart::Yoke || (one.part == GarmentPart::Torso && one.face == Face::Back);
    };
    if (!(is_front(a) && is_behind(b)) && !(is_front(b) && is_behind(a))) return 0;
    if (facing_up(boundary, sides.a) < kUp || facing_up(boundary, sides.b) < kUp) return 0;
    const double rise_a = rise_along(boundary, sides.a), rise_b = rise_along(boundary, sides.b);
    const bool are_straight = std::min(straightness(sides.points_a), straightness(sides.points_b)) > 0.99;
    if (std::min(std::abs(rise_a), std::abs(rise_b)) < kSlope) {
        const bool are_shoulders = sides.are_single() && are_straight && is_level_shoulder(facts_a, sides.points_a) &&
                                   is_level_shoulder(facts_b, sides.points_b);
        return are_shoulders ? 2 : 0;
    }
    if (rise_a * rise_b > 0) return -4;  // the neck would meet the tip
    return are_straight || !sides.are_single() ? 2 : 0;
}

// Whether panels a and b are sewn along an upright line on the other side of panel a than x.
bool are_sewn_opposite(const OpenBoundary& boundary, const PanelFacts& facts, int a, int b, double x) {
    return std::ranges::any_of(boundary.atoms_between(a, b), [&](int atom) {
        const Vec2d from = boundary.point(atom, 0), to = boundary.point(atom, 1);
        const bool is_upright = std::abs(to.y() - from.y()) > kUpright * (to - from).norm();
        return is_upright && std::abs((from.x() + to.x()) / 2 - x) > 0.5 * facts.width;
    });
}

// Whether the garment has other sleeves of one panel already, so that this one is a choice, as a short one.
bool is_other_choice(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, int sleeve) {
    using enum GarmentPart;
    const PanelFacts& own = facts[as_size(sleeve)];
    if (own.role.part != Sleeve || own.role.face != Face::None) return false;
    for (std::size_t q = 0; q < facts.size(); ++q) {
        const int other = static_cast<int>(q);
        if (other == sleeve || other == own.twin || facts[q].role.part != Sleeve || facts[q].role.face != Face::None ||
            facts[q].twin < 0)
            continue;
        const std::vector<int> joined = boundary.joined_panels(other);
        if (std::ranges::any_of(joined, [&](int p) { return is_one_of(facts[as_size(p)].role.part, {Torso, Yoke}); }))
            return true;
    }
    return false;
}

// Of panels that are numbered in a row, the next ones are sewn to each other, side to side, on one side of the body.
void weigh_row(Evidence& evidence, const Pattern& pattern, const std::vector<PanelFacts>& facts, const Sides& sides) {
    const int a = sides.panels_a[0], b = sides.panels_b[0];
    const PanelFacts &one = facts[as_size(a)], &other = facts[as_size(b)];
    if (one.rank == 0 || other.rank == 0) return;
    const auto is_image = [&](int panel) { return !pattern.panels[as_size(panel)].mirror_of.empty(); };
    const bool is_across = one.twin >= 0 && other.twin >= 0 && is_image(a) != is_image(b);
    const bool is_level = std::min(std::abs(rise(sides.points_a)), std::abs(rise(sides.points_b))) < kUpright;
    if (is_across || is_level) evidence.is_possible = false;
    const int apart = std::abs(one.rank - other.rank);
    constexpr double kNext = 3.5, kFar = -2;  // odds
    if (apart == 1) return add(evidence, kNext, "next in their row");
    if (apart < one.row_length - 1) add(evidence, kFar);
}

// A side panel lies between front and back: both are sewn to it, and not to each other.
void weigh_side_panel(Evidence& evidence, const PanelFacts& one, const PanelFacts& other, const Sides& sides) {
    constexpr double kToIt = 1.5, kPastIt = -5;  // odds
    const bool are_upright = std::min(std::abs(rise(sides.points_a)), std::abs(rise(sides.points_b))) > kUpright;
    if (!one.has_side_panel || !are_upright) return;
    const auto is_face = [](const PanelFacts& panel) {
        return panel.role.part == GarmentPart::Torso && panel.role.face != Face::None && !panel.is_outer;
    };
    if ((one.is_side && is_face(other)) || (other.is_side && is_face(one))) return add(evidence, kToIt);
    if (is_face(one) && is_face(other) && one.role.face != other.role.face) add(evidence, kPastIt);
}

void weigh_two_panels(Evidence& evidence, const OpenBoundary& boundary, const std::vector<PanelFacts>& facts,
                      const Sides& sides) {
    using enum GarmentPart;
    const int a = sides.panels_a[0], b = sides.panels_b[0];
    const PanelFacts& one = facts[as_size(a)];
    const PanelFacts& other = facts[as_size(b)];
    const double odds = odds_of_parts(one.role, other.role);
    if (sides.are_single()) weigh_row(evidence, boundary.pattern(), facts, sides);
    if (odds <= -6) evidence.is_possible = false;
    add(evidence, odds);
    if (one.role.part != other.role.part &&
        (is_other_choice(boundary, facts, a) || is_other_choice(boundary, facts, b)))
        evidence.is_possible = false;
    const double shoulders = odds_of_shoulders(boundary, one, other, sides);
    add(evidence, shoulders, shoulders > 0 ? "shoulders" : "");
    if (!sides.are_single()) return add(evidence, one.role.part == other.role.part && !(shoulders > 0) ? -2 : 0);
    if (is_on_wrong_side(boundary, facts, a, b, sides.points_b) ||
        is_on_wrong_side(boundary, facts, b, a, sides.points_a))
        evidence.is_possible = false;
    // Inner panels are sewn to inner ones over the shoulder, and to outer ones of the same face.
    const bool is_lane_known = (one.is_inner || one.is_outer) && (other.is_inner || other.is_outer);
    if (is_lane_known && one.role.part == other.role.part) {
        const bool is_same_lane = one.is_inner == other.is_inner, is_same_face = one.role.face == other.role.face;
        add(evidence, is_same_lane != is_same_face ? 0.7 : -3);
    }
    weigh_side_panel(evidence, one, other, sides);
    const std::vector<int> joined = boundary.joined_panels(a);
    const auto is_joined_to = [&](int panel) { return std::ranges::find(joined, panel) != joined.end(); };
    const bool is_upright = std::abs(rise(sides.points_a)) > kUpright;
    if (is_joined_to(b)) {
        // The second seam of two halves of a tube is next to certain.
        const bool closes = is_one_of(one.role.part, {Leg, Sleeve}) && one.role.part == other.role.part && is_upright &&
                            are_sewn_opposite(boundary, one, a, b, sides.points_a[kChainSamples / 2].x());
        add(evidence, closes ? 3.5 : 0.8);
    } else if (other.twin >= 0 && other.twin != a && is_joined_to(other.twin) && !one.is_symmetric) {
        add(evidence, -2);
    }
}

// Whether one chain lies on the left of the body and the other on the right, as both armholes do.
bool are_on_opposite_sides(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const ChainView& a,
                           const ChainView& b) {
    int known = 0, opposite = 0;
    for (int i = 0; i < kChainSamples; ++i) {
        const auto flank_at = [&](const ChainView& view, double t) {
            const ChainPlace at = place_on(boundary, view, t);
            return flank_of(facts[as_size(boundary.atom(at.atom).span.panel)], {boundary.point(at.atom, at.t)});
        };
        const double t = (i + 0.5) / kChainSamples;
        const Flank one = flank_at(a, t), other = flank_at(b, 1 - t);
        if (one == Flank::None || other == Flank::None) continue;
        ++known;
        opposite += one != other ? 1 : 0;
    }
    return known > kChainSamples / 2 && opposite > 0.9 * known;
}

// Halves of a torso that are sewn at one side would close round a leg at the other.
void weigh_other_side(Evidence& evidence, const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, int a,
                      int b, const std::vector<Vec2d>& points) {
    const PanelFacts& one = facts[as_size(a)];
    if (a == b || (one.twin < 0 && one.role.flank == Flank::None) || std::abs(rise(points)) < kUpright) return;
    if (are_sewn_opposite(boundary, one, a, b, points[points.size() / 2].x())) add(evidence, -5);
}

void weigh_flanks(Evidence& evidence, Flank a, Flank b) {
    if (a == Flank::None || b == Flank::None) return;
    add(evidence, a == b ? 0.7 : -2.5);
}

// ---- A panel with itself.

// How sure it is that both are the legs of a dart: neighbours in one panel, from the mouth inwards and out again. A
// wide dart has equal legs, and is no V-neck: its tip is not on the axis of a symmetric panel.
double odds_of_dart(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const ChainView& a,
                    const ChainView& b) {
    constexpr double kNarrow = 2 * std::numbers::pi - 0.6, kWide = 2 * std::numbers::pi - 1.4;  // rad, inside the cloth
    constexpr double kEqual = 0.006, kOffAxis = 0.05;
    const auto of_legs = [&](const ChainView& one, const ChainView& other) -> double {
        const OpenBoundary::Step step = boundary.next(one.chain.atoms.back());
        if (step.atom != other.chain.atoms.front() || step.seams != 0 || step.angle < kWide) return 0;
        if (step.angle > kNarrow) return 4;
        const double longer = std::max(length_of(one), length_of(other));
        if (std::abs(length_of(one) - length_of(other)) > kEqual * longer) return 0;
        const PanelFacts& panel = facts[as_size(boundary.atom(step.atom).span.panel)];
        const double off = std::abs(boundary.point(step.atom, 0).x() - panel.axis);
        return panel.is_symmetric && off < kOffAxis * panel.width ? 0 : 3;
    };
    return std::max(of_legs(a, b), of_legs(b, a));
}

bool is_dart(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const ChainView& a,
             const ChainView& b) {
    return odds_of_dart(boundary, facts, a, b) > 0;
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

// Whether both lines are the two that close the panel round a limb or the body: its ends if it is a strip. A cuff that
// could close either way closes so that it is as long as the hems that it can edge.
bool close_a_tube(const PanelFacts& facts, const Vec2d& apart) {
    constexpr double kStrip = 2.5;  // longer than that: only its ends close it
    const double longer = std::max(facts.width, facts.height), shorter = std::min(facts.width, facts.height);
    if (longer > kStrip * shorter) return apart.norm() > 0.8 * longer;
    if (facts.role.part != GarmentPart::Cuff || !(facts.opening > 0)) return apart.x() > 0.5 * facts.width;
    const auto misfit = [&](double length) { return std::abs(std::log(length / facts.opening)); };
    const bool is_across = misfit(facts.width) <= misfit(facts.height);
    return is_across ? apart.x() > 0.5 * facts.width : apart.y() > 0.5 * facts.height;
}

void weigh_one_panel(Evidence& evidence, const OpenBoundary& boundary, const std::vector<PanelFacts>& all,
                     const Sides& sides) {
    using enum GarmentPart;
    if (const double dart = odds_of_dart(boundary, all, sides.a, sides.b); dart > 0) {
        evidence.is_dart = true;
        return add(evidence, dart, "legs of a dart");
    }
    const PanelFacts& facts = all[as_size(sides.panels_a[0])];
    const GarmentPart part = facts.role.part;
    const bool is_tube = is_one_of(part, {Sleeve, Leg, Skirt, Cuff, Binding, Waistband});
    if (!is_tube || facts.has_other_face) return add(evidence, -3);
    const auto middle = [](const std::vector<Vec2d>& points) { return points[points.size() / 2]; };
    const Vec2d apart = (middle(sides.points_a) - middle(sides.points_b)).cwiseAbs();
    const bool closes = close_a_tube(facts, apart);
    if (closes && part == Waistband && has_overlap(boundary, sides.a.chain.atoms[0])) return add(evidence, -3);
    if (closes) return add(evidence, part == Waistband ? 0.5 : 1.5, "closes a tube");
    if (is_one_of(part, {Cuff, Binding, Waistband})) evidence.is_possible = false;
    add(evidence, -3);
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
    for (int i = 0; i < kChainSamples; ++i) {
        const double t = (i + 0.5) / kChainSamples;
        const auto [face_a, flank_a] = place(a, t);
        const auto [face_b, flank_b] = place(b, 1 - t);
        if (face_a != Face::None && face_b != Face::None) faces += face_a == face_b ? 1 : -1;
        if (flank_a != Flank::None && flank_b != Flank::None) flanks += flank_a == flank_b ? 1 : -1;
    }
    add(evidence, kWorth * (faces + flanks) / kChainSamples);
}

// How many samples of a view lie on the left and on the right of the body.
std::pair<int, int> count_flanks(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts,
                                 const ChainView& view) {
    std::pair<int, int> counts{0, 0};
    for (int i = 0; i < kChainSamples; ++i) {
        const ChainPlace at = place_on(boundary, view, (i + 0.5) / kChainSamples);
        const PanelFacts& own = facts[as_size(boundary.atom(at.atom).span.panel)];
        const Flank flank = flank_of(own, {boundary.point(at.atom, at.t)});
        counts.first += flank == Flank::Left ? 1 : 0;
        counts.second += flank == Flank::Right ? 1 : 0;
    }
    return counts;
}

bool lies_on_both_sides(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const ChainView& view) {
    const auto [left, right] = count_flanks(boundary, facts, view);
    return std::min(left, right) > kChainSamples / 6;
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
    const auto [left, right] = count_flanks(boundary, facts, opening);
    const bool is_one_sided = std::min(left, right) == 0 && left + right > 0;
    const bool is_low = facing_up(boundary, opening) < -0.5;
    const bool has_collar = std::ranges::any_of(facts, [](const PanelFacts& one) {
        return is_one_of(one.role.part, {GarmentPart::Hood, GarmentPart::Collar, GarmentPart::CollarStand});
    });
    if (has("neck") && has_collar) return add(evidence, -6);
    if (has("neck")) add(evidence, !is_one_sided && !is_low ? 3.5 : -4, "named after the neck");
    if (has("arm")) add(evidence, is_one_sided ? 3.5 : -4, "named after the arm");
    if (has("hem") || has("waist")) add(evidence, is_low ? 2.5 : -3);
}

// The cap of a sleeve is highest at the shoulder and lowest under the arm, as the armhole is, wherever the seams of a
// sleeve of two panels end.
void weigh_heights(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b) {
    constexpr double kAlike = 0.7;      // correlation of heights that speaks neither for nor against it
    constexpr double kWorth = 3;        // odds per correlation
    constexpr double kUpsideDown = -2;  // odds
    constexpr double kOpposite = -0.3;  // correlation, of two panels that lie on the paper as they are worn
    std::vector<double> other = heights_along(boundary, b);
    std::ranges::reverse(other);
    const double alike = correlation(heights_along(boundary, a), other);
    const bool are_loops = a.chain.is_loop && b.chain.is_loop;
    // The halves of a sleeve that is open below may be drawn along the arm, where their heights say nothing.
    if (!are_loops && alike > kOpposite && alike < kAlike) return;
    add(evidence, std::max(kUpsideDown, kWorth * (alike - kAlike)));
}

// Whether b is where the mirror image of a lies, by the places of their middles in their panels.
bool are_mirrored_places(const PanelFacts& facts_a, const PanelFacts& facts_b, const std::vector<Vec2d>& a,
                         const std::vector<Vec2d>& b) {
    constexpr double kNear = 0.12;  // of the panel's width
    const Vec2d one = a[a.size() / 2], other = b[b.size() / 2];
    const double x = (one.x() - facts_a.axis) + (other.x() - facts_b.axis);
    return std::abs(x) < kNear * facts_a.width && std::abs(one.y() - other.y()) < 0.02 + 0.05 * facts_a.height;
}

// Whether the seam closes the garment in the middle of the body: between mirror images, and the ends of a band.
bool closes_in_the_middle(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const Sides& sides) {
    using enum GarmentPart;
    if (std::abs(rise_along(boundary, sides.a)) < kUpright || std::abs(rise_along(boundary, sides.b)) < kUpright)
        return false;
    bool has_twins = false;
    for (int i = 0; i < kChainSamples; ++i) {
        const double t = (i + 0.5) / kChainSamples;
        const int one = boundary.atom(place_on(boundary, sides.a, t).atom).span.panel;
        const int other = boundary.atom(place_on(boundary, sides.b, 1 - t).atom).span.panel;
        const PanelFacts& panel = facts[as_size(one)];
        const bool is_band = one == other && is_one_of(panel.role.part, {Waistband, Collar, CollarStand, Binding});
        const bool is_twin = panel.twin == other && is_one_of(panel.role.part, {Torso, Skirt, Yoke}) &&
                             !panel.is_outer && !(panel.has_opening && panel.role.face == Face::Front);
        if (!is_band && !is_twin) return false;
        has_twins = has_twins || is_twin;
    }
    return has_twins;
}

void weigh_place(Evidence& evidence, const OpenBoundary& boundary, const std::vector<PanelFacts>& facts,
                 const Sides& sides) {
    const PanelFacts& a = facts[as_size(sides.panels_a[0])];
    const PanelFacts& b = facts[as_size(sides.panels_b[0])];
    const auto flank = [&](const PanelFacts& one, const std::vector<int>& panels, const std::vector<Vec2d>& points) {
        return is_single(panels) ? flank_of(one, points) : Flank::None;
    };
    const Pattern& pattern = boundary.pattern();
    add(evidence, 0,
        text_of(a.role, pattern.panels[as_size(sides.panels_a[0])]) + " to " +
            text_of(b.role, pattern.panels[as_size(sides.panels_b[0])]));
    if (!sides.are_single() && closes_in_the_middle(boundary, facts, sides)) {
        constexpr double kOddsOfClosing = 6;  // makes up for what speaks against mirror images
        return add(evidence, kOddsOfClosing, "closes in the middle");
    }
    const bool may_cross = is_one_of(a.role.part, {GarmentPart::Leg, GarmentPart::Hood});
    if (!may_cross && (are_on_opposite_sides(boundary, facts, sides.a, sides.b) ||
                       (!sides.are_single() && have_twins(facts, sides.panels_a, sides.panels_b)))) {
        evidence.is_possible = false;
        return;
    }
    if (sides.are_single() && leaves_no_armhole(boundary, facts, sides.a, sides.b)) {
        evidence.is_possible = false;
        return;
    }
    constexpr double kOneWithItself = -4;  // odds: a seam over several panels that has one panel on both sides
    constexpr double kSideAndSleeve = 2;   // odds: the side is sewn in one with the sleeve that is in it
    const Shared shared = shared_panels(sides.panels_a, sides.panels_b, facts);
    if (!sides.are_single() && shared.is_other) add(evidence, kOneWithItself);
    if (!sides.are_single() && shared.is_sleeve) add(evidence, kSideAndSleeve, "side and sleeve in one");
    weigh_two_panels(evidence, boundary, facts, sides);
    weigh_flanks(evidence, flank(a, sides.panels_a, sides.points_a), flank(b, sides.panels_b, sides.points_b));
}

void weigh_looks(Evidence& evidence, const OpenBoundary& boundary, const std::vector<PanelFacts>& facts,
                 const Sides& sides) {
    using enum GarmentPart;
    const PanelFacts& a = facts[as_size(sides.panels_a[0])];
    const PanelFacts& b = facts[as_size(sides.panels_b[0])];
    const bool are_alike = a.role.part == b.role.part || a.role.part == Unknown || b.role.part == Unknown;
    // The strip between the sides of a hood is straight.
    const bool is_hood_strip = a.role.part == Hood && b.role.part == Hood && a.is_symmetric != b.is_symmetric;
    if (is_hood_strip) add(evidence, bulge(sides.points_a) > 0.05 || bulge(sides.points_b) > 0.05 ? 2 : -2);
    if (sides.are_single() && are_alike && !is_hood_strip) {
        weigh_shape(evidence, sides.points_a, sides.points_b);
        // The underarm of a sleeve may be hollow on both sides.
        const bool closes_sleeve = sides.panels_a == sides.panels_b && a.role.part == Sleeve;
        if (!closes_sleeve) weigh_bulges(evidence, sides.points_a, sides.points_b);
        if (is_one_of(a.role.part, {Torso, Skirt}) && a.role.part == b.role.part)
            weigh_other_side(evidence, boundary, facts, sides.panels_a[0], sides.panels_b[0], sides.points_a);
        if (!is_dart(boundary, facts, sides.a, sides.b)) weigh_upright(evidence, sides.points_a, sides.points_b);
    }
    if (sides.panels_a != sides.panels_b) weigh_facing(evidence, boundary, sides.a, sides.b, a.role, b.role);
    const bool are_loops = sides.a.chain.is_loop && sides.b.chain.is_loop;
    if (are_loops && a.role.part == b.role.part && a.role.part != Unknown) evidence.is_possible = false;
    if (a.role.part == Binding && b.role.part != Binding) weigh_binding(evidence, boundary, facts, sides.a, sides.b);
    if (b.role.part == Binding && a.role.part != Binding) weigh_binding(evidence, boundary, facts, sides.b, sides.a);
    if (!sides.are_single()) weigh_faces(evidence, boundary, facts, sides.a, sides.b);
    if (are_parts(a.role.part, b.role.part, Torso, Sleeve) && !sides.are_single()) {
        constexpr double kBothSides = -5;  // odds: a neckline is no armhole
        if (lies_on_both_sides(boundary, facts, a.role.part == Torso ? sides.a : sides.b)) add(evidence, kBothSides);
    }
    if (are_parts(a.role.part, b.role.part, Torso, Sleeve) && sides.are_single()) {
        constexpr double kRound = 0.9, kStraight = 0.95;  // straightness
        constexpr double kNoArmhole = -5;                 // odds: a cap is not sewn to a side
        const double cap = straightness(a.role.part == Sleeve ? sides.points_a : sides.points_b);
        const double armhole = straightness(a.role.part == Torso ? sides.points_a : sides.points_b);
        if (cap < kRound && armhole > kStraight) add(evidence, kNoArmhole);
    }
    if (are_parts(a.role.part, b.role.part, Torso, Sleeve)) {
        constexpr double kRings = 1;  // odds: an armhole and a cap that are rings
        if (are_loops) add(evidence, kRings);
        const bool is_of_halves = !is_single(a.role.part == Sleeve ? sides.panels_a : sides.panels_b);
        if (are_loops || is_of_halves) weigh_heights(evidence, boundary, sides.a, sides.b);
        if (!sides.are_single()) {
            const bool is_cap = a.role.part == Sleeve;
            add(evidence, odds_of_elbow(boundary, facts, is_cap ? sides.b : sides.a, is_cap ? sides.a : sides.b));
        }
    }
}

}  // namespace

Evidence weigh(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const ChainView& first,
               const ChainView& second) {
    constexpr double kPrior = -4.0;  // of two chains taken at random
    Evidence evidence;
    evidence.odds = kPrior;
    // No seam is gathered to less than this: the rest need not be looked at.
    constexpr double kLeastShare = 0.39;
    const double one = length_of(first), other = length_of(second);
    if (std::min(one, other) < kLeastShare * std::max(one, other)) {
        evidence.is_possible = false;
        return evidence;
    }
    Sides sides{.a = first,
                .b = second,
                .panels_a = panels_of(boundary, first),
                .panels_b = panels_of(boundary, second),
                .points_a = {},
                .points_b = {}};
    const PanelFacts& a = facts[as_size(sides.panels_a[0])];
    const PanelFacts& b = facts[as_size(sides.panels_b[0])];
    const bool are_of_one_kind = is_of_one_kind(facts, sides.panels_a) && is_of_one_kind(facts, sides.panels_b);
    weigh_lengths(evidence, boundary, first, second, a.role, b.role, are_of_one_kind);
    if (!evidence.is_possible) return evidence;
    sides.points_a = sampled(boundary, first);
    sides.points_b = sampled(boundary, second);
    const bool is_one_panel = sides.are_single() && sides.panels_a == sides.panels_b;
    if (sides.are_single() && !is_one_panel && are_twins(facts, sides.panels_a[0], sides.panels_b[0])) {
        evidence.is_possible = are_mirrored_places(a, b, sides.points_a, sides.points_b);
        evidence.odds =
            odds_of_twins(boundary, facts, sides.panels_a[0], sides.panels_b[0], first.chain, sides.points_a);
        add(evidence, 0, "mirror images that meet in the middle");
        return evidence;
    }
    if (is_one_panel)
        weigh_one_panel(evidence, boundary, facts, sides);
    else
        weigh_place(evidence, boundary, facts, sides);
    if (!evidence.is_possible) return evidence;
    weigh_looks(evidence, boundary, facts, sides);
    weigh_ends(evidence, boundary, first, second);
    weigh_joints(evidence, boundary, first, second);
    if (are_parts(a.role.part, b.role.part, GarmentPart::Torso, GarmentPart::Sleeve))
        weigh_going_on(evidence, boundary, first, second);
    // A double notch says "back", also on what meets a back.
    const bool is_to_back = (a.is_side && b.role.face == Face::Back) || (b.is_side && a.role.face == Face::Back);
    const bool are_faces =
        is_to_back || (a.role.face != Face::None && b.role.face != Face::None && a.role.face != b.role.face);
    weigh_notches(evidence, boundary, first, second, sides.are_single() && are_faces);
    return evidence;
}

}  // namespace selvedge::sim
