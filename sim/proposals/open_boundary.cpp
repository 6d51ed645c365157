#include "sim/proposals/open_boundary.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <set>

#include "sim/core/assert.h"
#include "sim/core/math.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {}  // namespace

OpenBoundary::OpenBoundary(const Pattern& pattern)
    : pattern_(&pattern),
      of_panel_(pattern.panels.size()),
      points_(std::make_shared<PanelPoints>(pattern.panels.size())) {
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const Panel& panel = pattern.panels[p];
        if (!panel.is_worn) continue;
        for (std::size_t e = 0; e < panel.edges.size(); ++e) {
            of_panel_[p].push_back(atom_count());
            (*points_)[p].push_back({.lengths = measure_lengths(panel, panel.edges[e])});
            atoms_.push_back({{static_cast<int>(p), static_cast<int>(e), 0, 1}, outline_length(panel, panel.edges[e])});
        }
    }
    for (const Seam& seam : pattern.seams) {
        if (!panel_of(pattern, seam.first).is_worn || !panel_of(pattern, seam.second).is_worn) continue;
        sew(of_panel_[as_size(seam.first.panel)][as_size(seam.first.edge)],
            of_panel_[as_size(seam.second.panel)][as_size(seam.second.edge)]);
    }
}

int OpenBoundary::after_in_panel(int atom) const {
    const std::vector<int>& all = of_panel_[as_size(this->atom(atom).span.panel)];
    const auto at = std::ranges::find(all, atom);
    return at + 1 == all.end() ? all.front() : *(at + 1);
}

Vec2d OpenBoundary::point(int atom, double t) const {
    const EdgeSpan& span = this->atom(atom).span;
    return point_of_edge(span, span.from + t * (span.to - span.from));
}

const OutlineEdge& OpenBoundary::edge_of(const EdgeSpan& span) const {
    return pattern_->panels[as_size(span.panel)].edges[as_size(span.edge)];
}

Vec2d OpenBoundary::point_of_edge(const EdgeSpan& span, double t) const {
    EdgePoints& points = (*points_)[as_size(span.panel)][as_size(span.edge)];
    const auto [known, is_new] = points.known.try_emplace(std::bit_cast<std::uint64_t>(t));
    if (is_new) known->second = outline_point(pattern_->panels[as_size(span.panel)], edge_of(span), points.lengths, t);
    return known->second;
}

Vec2d OpenBoundary::direction(int atom, double t) const {
    const EdgeSpan& span = this->atom(atom).span;
    const double at = span.from + t * (span.to - span.from);
    const Panel& panel = pattern_->panels[as_size(span.panel)];
    const OutlineEdge& edge = edge_of(span);
    if (at <= 0) return curve_direction(panel, edge, EdgeEnd::Start);
    if (at >= 1) return curve_direction(panel, edge, EdgeEnd::End);
    constexpr double kStep = 1e-4;
    const Vec2d before = point_of_edge(span, std::max(0.0, at - kStep));
    return (point_of_edge(span, std::min(1.0, at + kStep)) - before).normalized();
}

double OpenBoundary::corner_angle(int atom) const {
    const Vec2d arriving = direction(atom, 1), leaving = direction(after_in_panel(atom), 0);
    return std::numbers::pi - std::atan2(cross2(arriving, leaving), arriving.dot(leaving));
}

OpenBoundary::Step OpenBoundary::next(int atom) const {
    Step step{after_in_panel(atom), corner_angle(atom), 0};
    // At most once over each seam that meets here.
    while (this->atom(step.atom).mate >= 0 && step.seams < atom_count()) {
        const int mate = this->atom(step.atom).mate;
        step.angle += corner_angle(mate);
        step.atom = after_in_panel(mate);
        ++step.seams;
    }
    return step;
}

std::vector<Chain> OpenBoundary::chains(double corner_angle) const {
    std::vector<Step> steps(atoms_.size());
    std::vector<bool> begins(atoms_.size(), false), is_used(atoms_.size(), false);
    for (int a = 0; a < atom_count(); ++a) {
        if (atom(a).mate >= 0) continue;
        steps[as_size(a)] = next(a);
        if (std::abs(steps[as_size(a)].angle - std::numbers::pi) > corner_angle)
            begins[as_size(steps[as_size(a)].atom)] = true;
    }
    std::vector<double> angle_before(atoms_.size(), std::numbers::pi);
    for (int a = 0; a < atom_count(); ++a) {
        if (atom(a).mate < 0) angle_before[as_size(steps[as_size(a)].atom)] = steps[as_size(a)].angle;
    }
    std::vector<Chain> all;
    const auto follow = [&](int first) {
        Chain chain;
        chain.angle_before = angle_before[as_size(first)];
        int a = first;
        do {
            is_used[as_size(a)] = true;
            chain.atoms.push_back(a);
            chain.length += atom(a).length;
            chain.angle_after = steps[as_size(a)].angle;
            a = steps[as_size(a)].atom;
        } while (a != first && !begins[as_size(a)] && !is_used[as_size(a)]);
        chain.is_loop = a == first;
        all.push_back(std::move(chain));
    };
    for (int a = 0; a < atom_count(); ++a) {
        if (atom(a).mate < 0 && begins[as_size(a)] && !is_used[as_size(a)]) follow(a);
    }
    for (int a = 0; a < atom_count(); ++a) {
        if (atom(a).mate < 0 && !is_used[as_size(a)]) follow(a);
    }
    return all;
}

std::vector<int> OpenBoundary::joined_panels(int panel) const {
    std::set<int> joined;
    for (const int a : of_panel_[as_size(panel)]) {
        if (atom(a).mate >= 0) joined.insert(atom(atom(a).mate).span.panel);
    }
    joined.erase(panel);
    return {joined.begin(), joined.end()};
}

std::vector<int> OpenBoundary::atoms_between(int first, int second) const {
    std::vector<int> found;
    for (const int a : of_panel_[as_size(first)]) {
        if (atom(a).mate >= 0 && atom(atom(a).mate).span.panel == second) found.push_back(a);
    }
    return found;
}

std::vector<double> OpenBoundary::starts(const Chain& chain) const {
    std::vector<double> starts;
    double reached = 0;
    for (const int a : chain.atoms) {
        starts.push_back(reached / chain.length);
        reached += atom(a).length;
    }
    return starts;
}

int OpenBoundary::split(int atom, double t) {
    const int second = atom_count();
    Atom rest = this->atom(atom);
    SELVEDGE_ASSERT(rest.mate < 0 && t > 0 && t < 1);
    Atom& own = atoms_[as_size(atom)];
    const double middle = own.span.from + t * (own.span.to - own.span.from);
    own.span.to = middle;
    own.length = t * rest.length;
    rest.span.from = middle;
    rest.length *= 1 - t;
    std::vector<int>& all = of_panel_[as_size(rest.span.panel)];
    all.insert(std::ranges::find(all, atom) + 1, second);
    atoms_.push_back(rest);
    return second;
}

void OpenBoundary::sew(int first, int second) {
    SELVEDGE_ASSERT(first != second && atom(first).mate < 0 && atom(second).mate < 0);
    atoms_[as_size(first)].mate = second;
    atoms_[as_size(second)].mate = first;
}

}  // namespace selvedge::sim
