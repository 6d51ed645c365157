#include "sim/proposals/chain_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "sim/core/math.h"
#include "sim/proposals/panel_role.h"

namespace selvedge::sim {
namespace {

std::string in_cm(double metres) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f", 100 * metres);
    return text.data();
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

// Whether another seam begins at this fraction of the chain: a corner of the panels that it joins.
bool is_at_seam(const OpenBoundary& boundary, const Chain& chain, double at) {
    const std::vector<double> starts = boundary.starts(chain);
    for (std::size_t k = 0; k + 1 < chain.atoms.size(); ++k) {
        if (std::abs(starts[k + 1] - at) < 1e-9 && boundary.next(chain.atoms[k]).seams > 0) return true;
    }
    return false;
}

// How many ends of the seam lie within the chain: at a notch, or where the outline turns a little.
struct InnerEnds {
    int at_notch = 0;
    int at_turn = 0;
};
InnerEnds inner_ends(const OpenBoundary& boundary, const ChainView& view) {
    InnerEnds ends;
    const std::vector<double> starts = boundary.starts(view.chain);
    for (const double end : {view.from, view.to}) {
        if (end <= 0 || end >= 1 || is_at_seam(boundary, view.chain, end)) continue;
        const bool is_notched = std::ranges::any_of(notches_of(boundary, view.chain), [&](const AtomNotch& notch) {
            const double share = boundary.atom(view.chain.atoms[notch.atom]).length / view.chain.length;
            constexpr double kBeside = 0.003;  // m
            return std::abs(starts[notch.atom] + notch.t * share - end) * view.chain.length < kBeside;
        });
        ++(is_notched ? ends.at_notch : ends.at_turn);
    }
    return ends;
}

}  // namespace

void weigh_notches(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b,
                   bool may_differ) {
    const InnerEnds ends_a = inner_ends(boundary, a), ends_b = inner_ends(boundary, b);
    if (ends_a.at_notch + ends_b.at_notch > 0) add(evidence, 1.0, "ends at a notch");
    constexpr double kTurnedEnd = -0.6;  // odds: a seam seldom ends where the outline turns only a little
    add(evidence, kTurnedEnd * (ends_a.at_turn + ends_b.at_turn));
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
    constexpr double kOtherKind = 0.5, kWrongKind = -2.5;  // odds of a notch at the same place
    if (wrong > 0) add(evidence, may_differ ? kOtherKind : kWrongKind * wrong);
    if (met + wrong == 0) add(evidence, -0.8);
}

namespace {

// ---- Lengths and ends.

// Whether one side may be much longer. A yoke's seam is gathered only where it lies between yoke and trunk.
bool may_be_gathered(const PanelRole& a, const PanelRole& b, bool are_of_one_kind) {
    using enum GarmentPart;
    return (are_of_one_kind && are_parts(a.part, b.part, Torso, Yoke)) || are_parts(a.part, b.part, Skirt, Waistband) ||
           are_parts(a.part, b.part, Skirt, Torso) || are_parts(a.part, b.part, Sleeve, Cuff) ||
           are_parts(a.part, b.part, Leg, Cuff);
}

bool is_sewn_to_another(const OpenBoundary& boundary, const ChainView& view) {
    const int own = boundary.atom(view.chain.atoms[0]).span.panel;
    return std::ranges::any_of(boundary.joined_panels(own), [&](int panel) { return panel != own; });
}

// Cuffs and waistbands have one edge that they belong to; of ribbing, they are shorter than that.
double odds_of_band(const OpenBoundary& boundary, const ChainView& a, const ChainView& b, const PanelRole& role_a,
                    const PanelRole& role_b) {
    using enum GarmentPart;
    constexpr double kLeast = 0.6, kMost = 1.15;  // of the edge's length
    const bool is_first = is_one_of(role_a.part, {Cuff, Waistband});
    const GarmentPart band = is_first ? role_a.part : role_b.part;
    const GarmentPart edge = is_first ? role_b.part : role_a.part;
    const bool belong =
        band == Cuff ? is_one_of(edge, {Sleeve, Leg}) : band == Waistband && is_one_of(edge, {Torso, Skirt, Leg});
    const double share = is_first ? length_of(a) / length_of(b) : length_of(b) / length_of(a);
    const bool are_loops = a.chain.is_loop && b.chain.is_loop;
    // A cuff's other edge stays open.
    const bool is_free = band != Cuff || !is_sewn_to_another(boundary, is_first ? a : b);
    if (belong && !is_free) return -6;
    return belong && are_loops && share > kLeast && share < kMost ? 3.5 : 0;
}

}  // namespace

void weigh_lengths(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b,
                   const PanelRole& role_a, const PanelRole& role_b, bool are_of_one_kind) {
    using enum GarmentPart;
    const double one = length_of(a), other = length_of(b);
    const double part = std::abs(one - other) / std::max(one, other);
    const std::string text = "lengths " + in_cm(one) + " and " + in_cm(other) + " cm";
    const bool is_cap = are_parts(role_a.part, role_b.part, Sleeve, Torso);
    const bool is_stretched = role_a.part == Binding || role_b.part == Binding;
    const double band = odds_of_band(boundary, a, b, role_a, role_b);
    add(evidence, band);
    if (part < 0.0015) return add(evidence, 2.8, text);
    if (part < 0.006) return add(evidence, 2.2, text);
    if (part < 0.015) return add(evidence, 1.4, text);
    if (band > 0) return add(evidence, -0.2, text + " (stretched)");
    if (part < 0.035) return add(evidence, is_cap ? 1.2 : 0.4, text);
    if (part < 0.08 && is_cap) return add(evidence, 0.6, text + " (ease)");
    if (part < 0.15 && is_stretched) return add(evidence, 0.6, text + " (stretched)");
    if (part < 0.08) return add(evidence, -1, text);
    if (part < 0.6 && may_be_gathered(role_a, role_b, are_of_one_kind))
        return add(evidence, -0.2, text + " (gathered)");
    if (part < 0.15) return add(evidence, -3, text);
    evidence.is_possible = false;
}

void weigh_ends(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b) {
    const auto of = [](double angle) {
        const double off = std::abs(angle - std::numbers::pi) * 180 / std::numbers::pi;
        return off < 8 ? 0.7 : off < 20 ? 0.3 : off < 45 ? -0.3 : -0.9;
    };
    if (a.chain.is_loop || b.chain.is_loop) return;
    // Where both chains meet already, their angle says nothing.
    const bool has_start = a.from == 0 && b.to == 1 && boundary.next(b.chain.atoms.back()).atom != a.chain.atoms[0];
    const bool has_end = a.to == 1 && b.from == 0 && boundary.next(a.chain.atoms.back()).atom != b.chain.atoms[0];
    if (has_start) add(evidence, of(a.chain.angle_before + b.chain.angle_after));
    if (has_end) add(evidence, of(a.chain.angle_after + b.chain.angle_before));
}

void weigh_going_on(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b) {
    constexpr double kGoesOn = 1;  // odds
    if (a.chain.is_loop || b.chain.is_loop) return;
    const auto meet = [&](const ChainView& before, const ChainView& after) {
        const OpenBoundary::Step step = boundary.next(before.chain.atoms.back());
        return before.to == 1 && after.from == 0 && step.seams > 0 && step.atom == after.chain.atoms.front();
    };
    if (meet(a, b) || meet(b, a)) add(evidence, kGoesOn, "goes on from another seam");
}

void weigh_joints(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b) {
    const std::vector<double> on_a = joints_of(boundary, a), on_b = joints_of(boundary, b);
    int met = 0;
    for (const double t : on_a) {
        for (const double s : on_b) met += std::abs(t - (1 - s)) < 0.015 ? 1 : 0;
    }
    if (met > 0) add(evidence, std::min(1.0, 0.4 * met));
}

}  // namespace selvedge::sim
