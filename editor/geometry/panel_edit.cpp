#include "editor/geometry/panel_edit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "editor/geometry/draft.h"
#include "editor/geometry/edge_remap.h"
#include "editor/geometry/outline_edit.h"
#include "editor/geometry/sewing.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/free_room.h"
#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

bool is_taken(const sim::Pattern& pattern, const std::string& name) {
    return std::any_of(pattern.panels.begin(), pattern.panels.end(),
                       [&](const sim::Panel& panel) { return panel.name == name; });
}

// The name without its number: front for front_2.
std::string stem_of(const std::string& name) {
    const std::size_t line = name.rfind('_');
    if (line == std::string::npos || line == 0 || line + 1 == name.size()) return name;
    const bool is_number = name.find_first_not_of("0123456789", line + 1) == std::string::npos;
    return is_number ? name.substr(0, line) : name;
}

}  // namespace

std::string free_panel_name(const sim::Pattern& pattern, const std::string& wanted) {
    const std::string name = wanted.empty() ? "panel" : wanted;
    if (!is_taken(pattern, name)) return name;
    for (int number = 2;; ++number) {
        const std::string numbered = stem_of(name) + "_" + std::to_string(number);
        if (!is_taken(pattern, numbered)) return numbered;
    }
}

void rename_panel(sim::Pattern& pattern, int panel, const std::string& name) {
    sim::Panel& own = panel_of(pattern, panel);
    if (name == own.name) return;
    if (name.empty()) throw GeometryError("A panel needs a name.", {{own.name, -1, -1}});
    if (is_taken(pattern, name)) throw GeometryError("There is a panel " + name + " already.", {{name, -1, -1}});
    for (sim::Panel& other : pattern.panels) {
        for (std::string* source : {&other.mirror_of, &other.copy_of}) {
            if (*source == own.name) *source = name;
        }
    }
    own.name = name;
}

sim::Panel make_polygon(std::vector<Vec2d> points) {
    double twice = 0;
    for (std::size_t i = 0; i < points.size(); ++i) twice += sim::cross2(points[i], points[(i + 1) % points.size()]);
    if (twice < 0) std::reverse(points.begin(), points.end());
    sim::Panel panel;
    panel.name = "panel";
    const int count = static_cast<int>(points.size());
    for (int i = 0; i < count; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % count});
    panel.vertices = std::move(points);
    check_panel(panel);
    return panel;
}

sim::Panel make_rectangle(const Vec2d& low, const Vec2d& high) {
    return make_polygon({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
}

// One cubic per quarter: for a circle the error is 0.03 % of the radius.
sim::Panel make_ellipse(const Vec2d& centre, const Vec2d& radii) {
    const Vec2d size = radii.cwiseAbs();
    const std::array<Vec2d, 4> spokes{Vec2d(0, -1), Vec2d(1, 0), Vec2d(0, 1), Vec2d(-1, 0)};
    const double handle = 4.0 / 3.0 * (std::sqrt(2.0) - 1);
    sim::Panel panel;
    panel.name = "panel";
    for (int i = 0; i < 4; ++i) {
        const Vec2d& from = spokes[as_size(i)];
        const Vec2d& to = spokes[as_size((i + 1) % 4)];
        panel.vertices.push_back(centre + size.cwiseProduct(from));
        sim::OutlineEdge edge{.start = i, .end = (i + 1) % 4, .kind = sim::CurveKind::Cubic};
        edge.control = {centre + size.cwiseProduct(from + handle * to), centre + size.cwiseProduct(to + handle * from)};
        panel.edges.push_back(edge);
    }
    check_panel(panel);
    return panel;
}

int add_panel(sim::Pattern& pattern, sim::Panel panel) {
    return add_panels(pattern, {std::move(panel)}, {}).front();
}

std::vector<sim::Seam> seams_among(const sim::Pattern& pattern, const std::vector<int>& panels) {
    std::map<int, int> position;
    for (std::size_t i = 0; i < panels.size(); ++i) position.emplace(panels[i], static_cast<int>(i));
    std::vector<sim::Seam> seams;
    for (sim::Seam seam : pattern.seams) {
        const auto first = position.find(seam.first.panel);
        const auto second = position.find(seam.second.panel);
        if (first == position.end() || second == position.end()) continue;
        seam.first.panel = first->second;
        seam.second.panel = second->second;
        seam.name.clear();
        seams.push_back(std::move(seam));
    }
    return seams;
}

std::vector<int> add_panels(sim::Pattern& pattern, std::vector<sim::Panel> panels,
                            const std::vector<sim::Seam>& seams) {
    const auto has_panel = [&](const sim::SeamSide& side) {
        return side.panel >= 0 && as_size(side.panel) < panels.size();
    };
    for (const sim::Seam& seam : seams) {
        if (!has_panel(seam.first) || !has_panel(seam.second))
            throw GeometryError("A seam has a panel that is missing");
    }
    return edit_pattern(pattern, [&](sim::Pattern& draft) {
        const int before = static_cast<int>(draft.panels.size());
        std::vector<int> added;
        for (sim::Panel& panel : panels) {
            panel.name = free_panel_name(draft, panel.name);
            added.push_back(static_cast<int>(draft.panels.size()));
            draft.panels.push_back(std::move(panel));
        }
        const std::size_t seams_before = draft.seams.size();
        for (sim::Seam seam : seams) {
            seam.first.panel += before;
            seam.second.panel += before;
            draft.seams.push_back(std::move(seam));
        }
        separate_sewings(draft, seams_before);
        return added;
    });
}

void remove_panels(sim::Pattern& pattern, const std::vector<int>& panels) {
    for (const int panel : panels) panel_of(pattern, panel);
    edit_pattern(pattern, [&](sim::Pattern& draft) { drop_panels(draft, panels); });
}

std::vector<int> duplicate_panels(sim::Pattern& pattern, const std::vector<int>& panels, const CopyShift& shift,
                                  CopyLink link) {
    const std::vector<Vec2d> positions = sheet_positions(pattern);
    std::vector<sim::Panel> copies;
    for (const int panel : panels) {
        const sim::Panel& own = panel_of(std::as_const(pattern), panel);
        sim::Panel& copy = copies.emplace_back(own);
        if (link == CopyLink::Linked) give_keys(copy);
        copy.mirror_of.clear();
        copy.copy_of = link == CopyLink::Linked ? own.name : "";
        copy.sheet_position = positions[as_size(panel)] + shift.on_sheet;
        copy.translation += shift.in_world;
    }
    return add_panels(pattern, std::move(copies), seams_among(pattern, panels));
}

// Cutting a panel in two.

namespace {

constexpr double kCutSnap = 1e-4;  // m, an end of the cut closer to a vertex than this is moved to it
constexpr double kApart = 0.02;    // m, gap between the two parts on the sheet

// The parameters (0..1, ascending) at which a segment intersects the path.
std::vector<double> meetings(const Vec2d& from, const Vec2d& to, const std::vector<Vec2d>& path) {
    std::vector<double> found;
    const Vec2d along = to - from;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const Vec2d step = path[i + 1] - path[i];
        const double sine = sim::cross2(along, step);
        if (sine == 0) continue;
        const double t = sim::cross2(path[i] - from, step) / sine;
        const double s = sim::cross2(path[i] - from, along) / sine;
        if (t > 1e-9 && t < 1 - 1e-9 && s >= 0 && s <= 1) found.push_back(t);
    }
    std::sort(found.begin(), found.end());
    const auto is_same = [](double a, double b) { return b - a < 1e-9; };  // found twice, at a corner of the path
    found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
    return found;
}

// Splits an internal line at its intersections with the path.
std::vector<sim::InternalLine> cut_line(const sim::InternalLine& line, const std::vector<Vec2d>& path) {
    sim::InternalLine piece = line;
    piece.points.clear();
    std::vector<sim::InternalLine> pieces{piece};
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        if (i > 0) {
            for (const double t : meetings(line.points[i - 1], line.points[i], path)) {
                const Vec2d point = line.points[i - 1] + t * (line.points[i] - line.points[i - 1]);
                pieces.back().points.push_back(point);
                pieces.push_back(piece);
                pieces.back().points.push_back(point);
            }
        }
        pieces.back().points.push_back(line.points[i]);
    }
    return pieces;
}

// The new panel is on the right of the path: it gets the outline from vertex `from_` counter-clockwise to `to_`. The
// rest of the outline stays:
//
//        to_ ------<------ .                 kept: the path, then the outline from to_ on
//         |  kept  ^  new  |                 new: the outline from from_ to to_, then the path reversed
//         . --->- from_ -> .
class PanelCutter {
 public:
    PanelCutter(sim::Pattern& draft, int panel, const std::vector<Vec2d>& path)
        : draft_(draft), panel_(panel), other_(static_cast<int>(draft.panels.size())), path_(path) {}

    int cut(bool is_sewn, const Vec2d& sheet_position) {
        from_ = vertex_at(path_.front());
        to_ = vertex_at(path_.back());
        if (from_ == to_) {
            throw GeometryError("The cut ends where it begins: end it at another point of the outline",
                                {{own().name, -1, from_}});
        }
        path_.front() = own().vertices[as_size(from_)];
        path_.back() = own().vertices[as_size(to_)];
        check_inside();
        unlink(draft_, panel_);
        divide();
        if (is_sewn) sew();
        const Vec2d along = (path_.back() - path_.front()).normalized();
        own().sheet_position = sheet_position;
        draft_.panels.back().sheet_position = sheet_position + kApart * Vec2d(along.y(), -along.x());
        return other_;
    }

 private:
    sim::Panel& own() { return draft_.panels[as_size(panel_)]; }
    int cut_edges() const { return static_cast<int>(path_.size()) - 1; }

    int vertex_at(const Vec2d& point) {
        sim::SeamSide best{panel_, 0};
        sim::NearestOnEdge nearest = nearest_on_edge(own(), own().edges[0], point);
        for (int e = 1; e < edge_count(own()); ++e) {
            const sim::NearestOnEdge found = nearest_on_edge(own(), own().edges[as_size(e)], point);
            if (found.distance >= nearest.distance) continue;
            nearest = found;
            best.edge = e;
        }
        const sim::OutlineEdge& edge = own().edges[as_size(best.edge)];
        const double length = outline_length(own(), edge);
        if (nearest.t * length < kCutSnap) return edge.start;
        if ((1 - nearest.t) * length < kCutSnap) return edge.end;
        return split_sewn(draft_, best, nearest.t);
    }

    // Throws GeometryError if the path leaves the panel between its ends.
    void check_inside() {
        std::vector<Vec2d> loop;
        for (const sim::OutlineEdge& edge : own().edges) {
            const std::vector<Vec2d> points = outline_polyline(own(), edge, 1e-4);
            loop.insert(loop.end(), points.begin(), points.end() - 1);
        }
        constexpr int kSamples = 64;  // per segment
        for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
            for (int k = 1; k < kSamples; ++k) {
                const Vec2d point = path_[i] + double(k) / kSamples * (path_[i + 1] - path_[i]);
                if (sim::is_inside(point, loop) || distance_to_outline(point) < kCutSnap) continue;
                throw GeometryError("The cut leaves '" + own().name +
                                        "' between its points: click points inside the panel, or end it at the first "
                                        "edge that it meets",
                                    {{.panel = own().name}});
            }
        }
    }

    double distance_to_outline(const Vec2d& point) {
        double distance = std::numeric_limits<double>::infinity();
        for (const sim::OutlineEdge& edge : own().edges)
            distance = std::min(distance, nearest_on_edge(own(), edge, point).distance);
        return distance;
    }

    void divide() {
        sim::Panel kept = own();
        const int count = edge_count(kept);
        const int first = edge_from(kept, from_);
        taken_ = (edge_from(kept, to_) - first + count) % count;
        const int wrapped = std::max(0, first + taken_ - count);
        base_ = first - wrapped;
        add_path(kept);
        sim::Panel taken = kept;
        taken.name = free_panel_name(draft_, kept.name);
        taken.edges.clear();
        for (int i = 0; i < taken_; ++i) taken.edges.push_back(kept.edges[as_size((first + i) % count)]);
        for (int k = cut_edges() - 1; k >= 0; --k) taken.edges.push_back(reversed_edge(cut_[as_size(k)]));
        kept.edges.erase(kept.edges.begin() + first, kept.edges.begin() + std::min(first + taken_, count));
        kept.edges.erase(kept.edges.begin(), kept.edges.begin() + wrapped);
        kept.edges.insert(kept.edges.begin() + base_, cut_.begin(), cut_.end());
        const auto image_of = [&, first, count, wrapped](int edge) -> sim::SeamSide {
            const int along = (edge - first + count) % count;
            if (along < taken_) return {other_, along};
            return {panel_, edge < first ? edge - wrapped : edge - taken_ + cut_edges()};
        };
        remap_edges(draft_, panel_, [&](int edge) { return EdgeImage{image_of(edge)}; });
        divide_notches(kept, taken, image_of);
        divide_lines(kept, taken);
        drop_foreign_vertices(kept, taken);
        own() = std::move(kept);
        draft_.panels.push_back(std::move(taken));
    }

    void add_path(sim::Panel& kept) {
        int start = from_;
        for (int k = 0; k < cut_edges(); ++k) {
            const bool is_last = k + 1 == cut_edges();
            const int end = is_last ? to_ : static_cast<int>(kept.vertices.size());
            if (!is_last) kept.vertices.push_back(path_[as_size(k + 1)]);
            cut_.push_back({.start = start, .end = end, .key = sim::new_key(kept)});
            start = end;
        }
    }

    template <class ImageOf>
    void divide_notches(sim::Panel& kept, sim::Panel& taken, ImageOf image_of) const {
        kept.notches.clear();
        const std::vector<sim::Notch> notches = std::exchange(taken.notches, {});
        for (const sim::Notch& notch : notches) {
            const sim::SeamSide image = image_of(notch.edge);
            std::vector<sim::Notch>& notches_there = (image.panel == panel_ ? kept : taken).notches;
            notches_there.push_back(notch);
            notches_there.back().edge = image.edge;
        }
    }

    void divide_lines(sim::Panel& kept, sim::Panel& taken) const {
        std::vector<Vec2d> loop;
        for (const sim::OutlineEdge& edge : kept.edges) {
            const std::vector<Vec2d> points = outline_polyline(kept, edge, 1e-4);
            loop.insert(loop.end(), points.begin(), points.end() - 1);
        }
        const auto part_of = [&](const Vec2d& point) -> sim::Panel& {
            return sim::is_inside(point, loop) ? kept : taken;
        };
        kept.internal_lines.clear();
        const std::vector<sim::InternalLine> lines = std::exchange(taken.internal_lines, {});
        for (const sim::InternalLine& line : lines) {
            for (sim::InternalLine& piece : cut_line(line, path_)) {
                if (piece.points.empty()) continue;
                const Vec2d probe =
                    (piece.points[0] + piece.points[std::min<std::size_t>(1, piece.points.size() - 1)]) / 2;
                part_of(probe).internal_lines.push_back(std::move(piece));
            }
        }
        kept.drill_points.clear();
        const std::vector<Vec2d> drill_points = std::exchange(taken.drill_points, {});
        for (const Vec2d& point : drill_points) part_of(point).drill_points.push_back(point);
    }

    static void drop_foreign_vertices(sim::Panel& kept, sim::Panel& taken) {
        std::vector<int> not_kept;
        std::vector<int> not_taken;
        for (int v = 0; v < static_cast<int>(kept.vertices.size()); ++v) {
            const bool is_of_taken = edge_from(taken, v) < edge_count(taken);
            if (!is_of_taken) not_taken.push_back(v);
            if (is_of_taken && edge_from(kept, v) == edge_count(kept)) not_kept.push_back(v);
        }
        drop_vertices(kept, not_kept);
        drop_vertices(taken, not_taken);
    }

    void sew() {
        for (int k = 0; k < cut_edges(); ++k) {
            draft_.seams.push_back(
                {.first = {panel_, base_ + k}, .second = {other_, taken_ + cut_edges() - 1 - k}, .is_reversed = true});
        }
    }

    sim::Pattern& draft_;
    int panel_;
    int other_;
    std::vector<Vec2d> path_;
    int from_ = 0;
    int to_ = 0;
    int taken_ = 0;                      // number of outline edges moved to the new panel
    int base_ = 0;                       // index of the path's first edge in the kept panel
    std::vector<sim::OutlineEdge> cut_;  // edges of the path; vertex indices before the cut
};

}  // namespace

int cut_panel(sim::Pattern& pattern, int panel, const std::vector<Vec2d>& path, bool is_sewn) {
    const sim::Panel& own = panel_of(pattern, panel);
    const bool is_sound = std::all_of(path.begin(), path.end(), [](const Vec2d& p) { return p.allFinite(); });
    if (path.size() < 2 || !is_sound) {
        throw GeometryError("A cut needs two points or more.", {{own.name, -1, -1}});
    }
    const Vec2d position = sheet_positions(pattern)[as_size(panel)];
    return edit_pattern(pattern,
                        [&](sim::Pattern& draft) { return PanelCutter(draft, panel, path).cut(is_sewn, position); });
}

namespace {

constexpr double kGap = 0.05;       // m, between panels
constexpr double kRowLength = 1.4;  // m, a panel that would end beyond this starts a new row

}  // namespace

// Panels with a sheet_position also take a slot in the layout, so that moving one panel does not move the others.
std::vector<Vec2d> sheet_positions(const sim::Pattern& pattern) {
    std::vector<Vec2d> positions;
    Vec2d corner(0, 0);  // m, upper left of the next panel
    double depth = 0;    // m, height of the row
    for (const sim::Panel& panel : pattern.panels) {
        const Eigen::AlignedBox2d box = outline_box(panel);
        const Vec2d size = box.sizes();
        if (corner.x() > 0 && corner.x() + size.x() > kRowLength) {
            corner = {0, corner.y() - depth - kGap};
            depth = 0;
        }
        const Vec2d laid_out = corner - Vec2d(box.min().x(), box.max().y());
        positions.push_back(panel.sheet_position.value_or(laid_out));
        corner.x() += size.x() + kGap;
        depth = std::max(depth, size.y());
    }
    return positions;
}

Vec2d free_shift(const sim::Pattern& pattern, const std::vector<sim::Panel>& panels) {
    const auto box_at = [](const sim::Panel& panel, const Vec2d& position) {
        const Eigen::AlignedBox2d box = outline_box(panel);
        return Eigen::AlignedBox2d(box.min() + position, box.max() + position);
    };
    Eigen::AlignedBox2d moved;
    for (const sim::Panel& panel : panels) moved.extend(box_at(panel, panel.sheet_position.value()));
    const std::vector<Vec2d> positions = sheet_positions(pattern);
    std::vector<sim::TakenMoves> taken;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Eigen::AlignedBox2d box = box_at(pattern.panels[i], positions[i]);
        if (box.min().y() >= moved.max().y() + kGap || box.max().y() <= moved.min().y() - kGap) continue;
        taken.push_back(sim::moves_onto({moved.min().x(), moved.max().x()}, {box.min().x(), box.max().x()}, kGap));
    }
    return {nearest_free_move(std::move(taken), sim::MoveWay::Forward), 0};
}

}  // namespace selvedge::editor
