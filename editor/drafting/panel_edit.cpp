#include "editor/drafting/panel_edit.h"

#include <algorithm>
#include <cmath>

#include "editor/drafting/draft.h"
#include "editor/drafting/edge_shape.h"
#include "editor/drafting/follow.h"
#include "editor/drafting/sheet_layout.h"

namespace selvedge {
namespace {

bool is_taken(const Pattern& pattern, const std::string& name) {
    return std::any_of(pattern.panels.begin(), pattern.panels.end(),
                       [&](const Panel& panel) { return panel.name == name; });
}

// The name without the number that made it free: front_2 is a front.
std::string stem_of(const std::string& name) {
    const std::size_t line = name.rfind('_');
    if (line == std::string::npos || line == 0 || line + 1 == name.size()) return name;
    const bool is_number = name.find_first_not_of("0123456789", line + 1) == std::string::npos;
    return is_number ? name.substr(0, line) : name;
}

}  // namespace

std::string free_panel_name(const Pattern& pattern, const std::string& wanted) {
    const std::string name = wanted.empty() ? "panel" : wanted;
    if (!is_taken(pattern, name)) return name;
    for (int number = 2;; ++number) {
        const std::string numbered = stem_of(name) + "_" + std::to_string(number);
        if (!is_taken(pattern, numbered)) return numbered;
    }
}

void rename_panel(Pattern& pattern, int panel, const std::string& name) {
    Panel& own = panel_of(pattern, panel);
    if (name == own.name) return;
    if (name.empty()) throw DraftError("A panel needs a name.", {{own.name, -1, -1}});
    if (is_taken(pattern, name)) throw DraftError("There is a panel " + name + " already.", {{name, -1, -1}});
    for (Panel& other : pattern.panels) {
        if (other.mirror_of == own.name) other.mirror_of = name;
    }
    own.name = name;
}

Panel make_polygon(std::vector<Vec2d> points) {
    double twice = 0;
    for (std::size_t i = 0; i < points.size(); ++i) twice += cross2(points[i], points[(i + 1) % points.size()]);
    if (twice < 0) std::reverse(points.begin(), points.end());
    Panel panel;
    panel.name = "panel";
    const int count = static_cast<int>(points.size());
    for (int i = 0; i < count; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % count});
    panel.vertices = std::move(points);
    check_panel(panel);
    return panel;
}

Panel make_rectangle(const Vec2d& low, const Vec2d& high) {
    return make_polygon({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
}

// A quarter of a circle by a cubic is off by 0.03% of its radius.
Panel make_ellipse(const Vec2d& centre, const Vec2d& radii) {
    const Vec2d size = radii.cwiseAbs();
    const std::array<Vec2d, 4> spokes{Vec2d(0, -1), Vec2d(1, 0), Vec2d(0, 1), Vec2d(-1, 0)};
    const double handle = 4.0 / 3.0 * (std::sqrt(2.0) - 1);
    Panel panel;
    panel.name = "panel";
    for (int i = 0; i < 4; ++i) {
        const Vec2d from = spokes[as_size(i)];
        const Vec2d to = spokes[as_size((i + 1) % 4)];
        panel.vertices.push_back(centre + size.cwiseProduct(from));
        OutlineEdge edge{.start = i, .end = (i + 1) % 4, .kind = CurveKind::Cubic};
        edge.control = {centre + size.cwiseProduct(from + handle * to), centre + size.cwiseProduct(to + handle * from)};
        panel.edges.push_back(edge);
    }
    check_panel(panel);
    return panel;
}

int add_panel(Pattern& pattern, Panel panel) {
    panel.name = free_panel_name(pattern, panel.name);
    return edit_draft(pattern, [&](Pattern& draft) {
        draft.panels.push_back(std::move(panel));
        return static_cast<int>(draft.panels.size()) - 1;
    });
}

void remove_panels(Pattern& pattern, const std::vector<int>& panels) {
    for (const int panel : panels) panel_of(pattern, panel);
    edit_draft(pattern, [&](Pattern& draft) { drop_panels(draft, panels); });
}

int duplicate_panel(Pattern& pattern, int panel, const Vec2d& shift) {
    Panel copy = panel_of(pattern, panel);
    copy.mirror_of.clear();
    copy.sheet_position = sheet_positions(pattern)[as_size(panel)] + shift;
    return add_panel(pattern, std::move(copy));
}

}  // namespace selvedge
