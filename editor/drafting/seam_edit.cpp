#include "editor/drafting/seam_edit.h"

#include <algorithm>
#include <cmath>

#include "editor/drafting/draft.h"
#include "editor/drafting/edge_shape.h"
#include "editor/drafting/sheet_layout.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/seam_name.h"

namespace selvedge {
namespace {

std::array<Vec2d, 2> ends_on_sheet(const Pattern& pattern, const SeamSide& side, const Vec2d& origin) {
    const Panel& panel = panel_of(pattern, side.panel);
    const OutlineEdge& edge = edge_of(pattern, side);
    return {origin + panel.vertices[as_size(edge.start)], origin + panel.vertices[as_size(edge.end)]};
}

std::array<Vec3d, 2> ends_in_room(const Pattern& pattern, const SeamSide& side) {
    const Panel& panel = panel_of(pattern, side.panel);
    const OutlineEdge& edge = edge_of(pattern, side);
    return {panel.place(panel.vertices[as_size(edge.start)]), panel.place(panel.vertices[as_size(edge.end)])};
}

bool is_placed(const Panel& panel) {
    return !panel.translation.isZero(0) || !panel.rotation.isIdentity(0);
}

bool do_cross(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
    const auto side = [](const Vec2d& from, const Vec2d& to, const Vec2d& p) { return cross2(to - from, p - from); };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

// Of four points, two lines that cross are the longest way to pair them.
template <class Point>
bool is_longer_than_swapped(const std::array<Point, 2>& first, const std::array<Point, 2>& second) {
    const double paired = (first[0] - second[0]).norm() + (first[1] - second[1]).norm();
    const double swapped = (first[0] - second[1]).norm() + (first[1] - second[0]).norm();
    return paired > swapped * (1 + 1e-6) + 1e-9;
}

// Ends of an edge that may move: those where the next edge is sewn, or that the other side of the seam ends at, hold.
class SideScaler {
 public:
    SideScaler(Pattern& draft, const SeamSide& side, const SeamSide& other)
        : draft_(draft), side_(side), other_(other) {}

    void scale(double factor) {
        Panel& panel = draft_.panels[as_size(side_.panel)];
        const OutlineEdge edge = edge_of(draft_, side_);
        const int count = edge_count(panel);
        const int before = (side_.edge + count - 1) % count;
        const int after = (side_.edge + 1) % count;
        const bool start_holds = holds_other(edge.start);
        const bool end_holds = holds_other(edge.end);
        if (start_holds && end_holds) {
            throw DraftError("Both ends of the edge are ends of the other side too.", {place_of(draft_, side_)});
        }
        const bool is_start_free = !start_holds && !seam_at(draft_, {side_.panel, before});
        const bool is_end_free = !end_holds && !seam_at(draft_, {side_.panel, after});
        const Vec2d start = panel.vertices[as_size(edge.start)];
        const Vec2d end = panel.vertices[as_size(edge.end)];
        Vec2d centre = (start + end) / 2;
        if (start_holds || (is_end_free && !is_start_free)) centre = start;
        if (end_holds || (is_start_free && !is_end_free)) centre = end;
        VertexMove move{std::vector<bool>(panel.vertices.size(), false), Eigen::Affine2d::Identity()};
        move.is_moved[as_size(edge.start)] = move.is_moved[as_size(edge.end)] = true;
        move.map.linear() *= factor;
        move.map.translation() = centre - factor * centre;
        move_outline(panel, move);
    }

 private:
    bool holds_other(int vertex) const {
        const OutlineEdge& edge = edge_of(draft_, other_);
        return other_.panel == side_.panel && (edge.start == vertex || edge.end == vertex);
    }

    Pattern& draft_;
    SeamSide side_;
    SeamSide other_;
};

}  // namespace

int sew_edges(Pattern& pattern, const Seam& seam) {
    if (seam.first == seam.second) {
        throw DraftError("An edge is not sewn to itself.", {place_of(pattern, seam.first)});
    }
    for (const SeamSide& side : {seam.first, seam.second}) {
        edge_of(pattern, side);
        const auto found = seam_at(pattern, side);
        if (!found) continue;
        throw DraftError("This edge of panel " + panel_of(pattern, side.panel).name + " is sewn already, by seam " +
                             seam_name(pattern, pattern.seams[as_size(*found)]) + ".",
                         {place_of(pattern, side)});
    }
    return edit_draft(pattern, [&](Pattern& draft) {
        draft.seams.push_back(seam);
        return static_cast<int>(draft.seams.size()) - 1;
    });
}

void remove_seams(Pattern& pattern, std::vector<int> seams) {
    for (const int seam : seams) seam_of(pattern, seam);
    std::sort(seams.begin(), seams.end());
    seams.erase(std::unique(seams.begin(), seams.end()), seams.end());
    for (auto seam = seams.rbegin(); seam != seams.rend(); ++seam) pattern.seams.erase(pattern.seams.begin() + *seam);
}

std::array<double, 2> seam_lengths(const Pattern& pattern, const Seam& seam) {
    return {outline_length(panel_of(pattern, seam.first.panel), edge_of(pattern, seam.first)),
            outline_length(panel_of(pattern, seam.second.panel), edge_of(pattern, seam.second))};
}

void even_seam(Pattern& pattern, int seam) {
    const Seam uneven = seam_of(pattern, seam);
    edit_draft(pattern, [&](Pattern& draft) {
        const auto [first, second] = seam_lengths(draft, uneven);
        SideScaler(draft, uneven.second, uneven.first).scale(first / second);
        draft.seams[as_size(seam)].is_eased = false;
    });
}

bool is_crossed(const Pattern& pattern, const Seam& seam) {
    const Panel& first = panel_of(pattern, seam.first.panel);
    const Panel& second = panel_of(pattern, seam.second.panel);
    if (is_placed(first) && is_placed(second)) {
        std::array<Vec3d, 2> ends = ends_in_room(pattern, seam.second);
        if (seam.is_reversed) std::swap(ends[0], ends[1]);
        return is_longer_than_swapped(ends_in_room(pattern, seam.first), ends);
    }
    const std::vector<Vec2d> origins = sheet_positions(pattern);
    const std::array<Vec2d, 2> own = ends_on_sheet(pattern, seam.first, origins[as_size(seam.first.panel)]);
    std::array<Vec2d, 2> ends = ends_on_sheet(pattern, seam.second, origins[as_size(seam.second.panel)]);
    if (seam.is_reversed) std::swap(ends[0], ends[1]);
    if (seam.first.panel == seam.second.panel) return is_longer_than_swapped(own, ends);
    return do_cross(own[0], ends[0], own[1], ends[1]);
}

}  // namespace selvedge
