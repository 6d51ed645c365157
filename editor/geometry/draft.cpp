#include "editor/geometry/draft.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <type_traits>

#include "sim/pattern/fault.h"
#include "sim/pattern/field_visit.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::editor {
namespace {

constexpr double kClearance = 1e-7;   // m, minimum distance between edges of an outline
constexpr double kMargin = 1 + 1e-6;  // saving rounds numbers

bool is_near(double value) {
    return std::abs(value) <= sim::kMaxCoordinate;  // false for NaN
}

template <class Vector>
bool is_near(const Eigen::MatrixBase<Vector>& point) {
    return point.allFinite() && point.cwiseAbs().maxCoeff() <= sim::kMaxCoordinate;
}

bool is_value_sound(sim::Measure measure, double value) {
    return sim::is_length(measure) ? is_near(value) : std::isfinite(value);
}
template <int rows>
bool is_value_sound(sim::Measure, const Eigen::Matrix<double, rows, 1>& value) {
    return is_near(value);
}
bool is_value_sound(sim::Measure, const Eigen::Matrix3d& value) {
    return value.allFinite();
}
template <class T>
bool is_value_sound(sim::Measure, const T&) {  // no numbers
    return true;
}

// Whether the field is of an edge's curve: PanelChecker::check_edge() says which edge is wrong.
template <class Part, class T, T Part::*kMember, sim::FileForm kForm>
bool is_curve(const sim::Field<kMember, kForm>& field) {
    return std::is_same_v<Part, sim::OutlineEdge> && field.descent == sim::Descent::Shape;
}

class PanelChecker {
 public:
    explicit PanelChecker(const sim::Panel& panel) : panel_(panel) {}

    void check() const {
        check_numbers();
        check_chain();
        try {
            check_shape();
        } catch (GeometryError& error) {
            error.add_refused_panel(panel_);
            throw;
        }
        for (const sim::Notch& notch : panel_.notches) {
            if (notch.edge < 0 || notch.edge >= edge_count(panel_) || !(notch.t >= 0 && notch.t <= 1)) {
                fail("would have a notch outside its outline");
            }
        }
        expect_vertices(panel_, panel_.pins);
    }

 private:
    void check_shape() const {
        for (int e = 0; e < edge_count(panel_); ++e) check_edge(e);
        check_crossings();
        const double area = outline_area(panel_);
        if (!(area >= sim::kSmallestArea * kMargin)) {
            fail(area < -sim::kSmallestArea ? "would be turned inside out" : "would have no area");
        }
    }

    [[noreturn]] void fail(const std::string& what, int edge = -1) const {
        throw GeometryError("Panel " + panel_.name + " " + what + ".", {{panel_.name, edge, -1}});
    }

    void check_numbers() const {
        bool is_sound = panel_.wrap_radius >= 0;
        visit_values(panel_, [&](const auto& field, const auto& value) {
            if (!is_curve(field)) is_sound = is_sound && is_value_sound(field.measure, value);
        });
        if (!is_sound) fail("would reach further than 100 m");
    }

    void check_chain() const {
        const int count = edge_count(panel_);
        if (count < 2) fail("would have no area");
        if (panel_.edges.size() > sim::kMaxEdges)
            fail("would have more than " + std::to_string(sim::kMaxEdges) + " edges");
        std::set<int> passed;
        for (int e = 0; e < count; ++e) {
            const sim::OutlineEdge& edge = panel_.edges[as_size(e)];
            expect_vertices(panel_, {edge.start, edge.end});
            if (edge.end != panel_.edges[as_size((e + 1) % count)].start) fail("would have an open outline", e);
            if (!passed.insert(edge.start).second) fail("would pass a point twice", e);
        }
    }

    void check_edge(int e) const {
        const sim::OutlineEdge& edge = panel_.edges[as_size(e)];
        const double chord = (panel_.vertices[as_size(edge.start)] - panel_.vertices[as_size(edge.end)]).norm();
        if (!is_near(edge.control[0]) || !is_near(edge.control[1])) fail("would reach further than 100 m", e);
        if (edge.kind == sim::CurveKind::Arc &&
            !(is_near(edge.arc_radius) && edge.arc_radius > 0 && 2 * edge.arc_radius >= chord * (1 - 5e-7))) {
            fail("would have an arc whose radius is too small for its ends", e);
        }
        // Files store the control points relative to the chord, so the chord must not be zero.
        if (!(chord >= sim::kShortestEdge / 10) || !(outline_length(panel_, edge) >= sim::kShortestEdge * kMargin)) {
            fail("would have an edge shorter than 0.01 mm", e);
        }
    }

    void check_crossings() const {
        const std::vector<sim::OutlineCrossing> crossings =
            find_outline_crossings(panel_, {.most = 4, .clearance = kClearance});
        if (crossings.empty()) return;
        std::vector<PartLocation> places;
        for (const sim::OutlineCrossing& crossing : crossings) {
            places.push_back({panel_.name, static_cast<int>(crossing.first), -1});
            if (crossing.second != crossing.first) {
                places.push_back({panel_.name, static_cast<int>(crossing.second), -1});
            }
        }
        throw GeometryError("The outline of panel " + panel_.name + " would cross or touch itself.", std::move(places));
    }

    const sim::Panel& panel_;
};

void check_seam(const sim::Pattern& draft, const sim::Seam& seam, const std::vector<bool>& is_changed) {
    const double first = outline_length(draft.panels[as_size(seam.first.panel)], edge_of(draft, seam.first));
    const double second = outline_length(draft.panels[as_size(seam.second.panel)], edge_of(draft, seam.second));
    if (std::max(first, second) * kMargin <= sim::kMaxGatherRatio * std::min(first, second)) return;
    GeometryError error(
        "One side of seam " + seam_name(draft, seam) + " would be over four times as long as the other.",
        {place_of(draft, seam.first), place_of(draft, seam.second)});
    for (const int panel : std::set<int>{seam.first.panel, seam.second.panel}) {
        if (is_changed[as_size(panel)]) error.add_refused_panel(draft.panels[as_size(panel)]);
    }
    throw error;
}

}  // namespace

sim::Panel& panel_of(sim::Pattern& pattern, int panel) {
    if (panel >= 0 && panel < static_cast<int>(pattern.panels.size())) return pattern.panels[as_size(panel)];
    throw GeometryError("There is no panel " + std::to_string(panel) + ".");
}

const sim::Panel& panel_of(const sim::Pattern& pattern, int panel) {
    return panel_of(const_cast<sim::Pattern&>(pattern), panel);
}

sim::OutlineEdge& edge_of(sim::Pattern& pattern, const sim::SeamSide& side) {
    sim::Panel& panel = panel_of(pattern, side.panel);
    if (side.edge >= 0 && side.edge < edge_count(panel)) return panel.edges[as_size(side.edge)];
    throw GeometryError("Panel " + panel.name + " has no edge " + std::to_string(side.edge) + ".",
                        {{panel.name, -1, -1}});
}

const sim::OutlineEdge& edge_of(const sim::Pattern& pattern, const sim::SeamSide& side) {
    return edge_of(const_cast<sim::Pattern&>(pattern), side);
}

const sim::Seam& seam_of(const sim::Pattern& pattern, int seam) {
    if (seam >= 0 && seam < static_cast<int>(pattern.seams.size())) return pattern.seams[as_size(seam)];
    throw GeometryError("There is no seam " + std::to_string(seam) + ".");
}

void expect_vertices(const sim::Panel& panel, const std::vector<int>& vertices) {
    for (const int vertex : vertices) {
        if (vertex >= 0 && vertex < static_cast<int>(panel.vertices.size())) continue;
        throw GeometryError("Panel " + panel.name + " has no point " + std::to_string(vertex) + ".",
                            {{panel.name, -1, -1}});
    }
}

PartLocation place_of(const sim::Pattern& pattern, const sim::SeamSide& side) {
    return {panel_of(pattern, side.panel).name, side.edge, -1};
}

std::optional<int> seam_at(const sim::Pattern& pattern, const sim::SeamSide& side) {
    for (std::size_t i = 0; i < pattern.seams.size(); ++i) {
        if (pattern.seams[i].first == side || pattern.seams[i].second == side) return static_cast<int>(i);
    }
    return {};
}

void check_panel(const sim::Panel& panel) {
    PanelChecker(panel).check();
}

void check_edit(const sim::Pattern& draft, const sim::Pattern& before) {
    std::vector<bool> is_changed(draft.panels.size(), true);
    for (std::size_t i = 0; i < draft.panels.size(); ++i) {
        is_changed[i] = i >= before.panels.size() || !(draft.panels[i] == before.panels[i]);
        if (is_changed[i]) check_panel(draft.panels[i]);
    }
    std::set<sim::SeamSide> sewn;
    for (std::size_t i = 0; i < draft.seams.size(); ++i) {
        const sim::Seam& seam = draft.seams[i];
        for (const sim::SeamSide& side : {seam.first, seam.second}) {
            edge_of(draft, side);
            if (sewn.insert(side).second) continue;
            throw GeometryError("An edge of panel " + panel_of(draft, side.panel).name + " would be sewn twice.",
                                {place_of(draft, side)});
        }
        const bool is_old = i < before.seams.size() && before.seams[i] == seam;
        if (!is_old || is_changed[as_size(seam.first.panel)] || is_changed[as_size(seam.second.panel)]) {
            check_seam(draft, seam, is_changed);
        }
    }
}

}  // namespace selvedge::editor
