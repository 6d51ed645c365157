#pragma once
// The pattern's geometry on the 2D sheet: polylines and bounding boxes of every panel, cached until the panel changes,
// for picking, snapping and drawing. Also the sheet's camera and grid.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "editor/document/selection.h"
#include "sim/core/math.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// The map from the sheet (m, y up) to the screen (px from the upper left, y down).

using SheetBox = Eigen::AlignedBox2d;

inline constexpr double kMinSheetScale = 15;     // px/m: 1200 px show 80 m
inline constexpr double kMaxSheetScale = 60000;  // px/m: 60 px per millimetre

struct SheetCamera {
    Vec2d centre = Vec2d::Zero();        // m, sheet point at the centre of the view
    double scale = 600;                  // px/m
    Vec2d view_low = Vec2d::Zero();      // px, upper left corner
    Vec2d view_size = Vec2d(1000, 800);  // px

    bool operator==(const SheetCamera&) const = default;
};

Vec2d to_px(const SheetCamera& camera, const Vec2d& sheet);
Vec2d to_sheet(const SheetCamera& camera, const Vec2d& px);
SheetBox visible_box(const SheetCamera& camera);  // m

// Moves the sheet by `by_px` on the screen.
void pan(SheetCamera& camera, const Vec2d& by_px);

// Zooms about the cursor, by a factor of 1.18 per wheel notch. The scale is clamped to its limits.
void zoom_at(SheetCamera& camera, const Vec2d& px, double notches);

// Centres the view on the box and scales it to fit, with a margin. No effect if the box is empty or not finite. Each
// side of the box counts as at least 1 cm.
void frame(SheetCamera& camera, const SheetBox& box, double margin_px);

// The grid step, m: the finest of 1 mm, 5 mm, 1 cm, 5 cm, 10 cm, 50 cm and 1 m whose lines are at least this far apart;
// else 1 m.
double grid_step(const SheetCamera& camera, double at_least_px);

// An edge as a polyline; points in the panel's held frame, m.
struct EdgeShape {
    std::vector<Vec2d> points;    // at least two, within kShapeError of the curve
    std::vector<double> reached;  // m, arc length up to each point
    double length = 0;            // m
    SheetBox box;

    Vec2d at(double t) const;       // point at a fraction of the length
    Vec2d tangent(double t) const;  // unit vector; zero if the edge has no length
};

inline constexpr double kShapeError = 5e-5;  // m

struct EdgeHit {
    double t = 0;  // fraction of the length
    Vec2d point = Vec2d::Zero();
    double distance = 0;  // m
};
EdgeHit nearest(const EdgeShape& shape, const Vec2d& u);

struct PanelShape {
    sim::Panel panel;                   // the source panel
    Vec2d origin = Vec2d::Zero();       // m, origin of the panel's frame on the sheet
    std::vector<EdgeShape> edges;       // one per edge of the panel
    std::vector<Vec2d> outline;         // all edges as one closed polyline, each point once
    SheetBox box;                       // bounding box of the outline
    std::uint64_t outline_version = 0;  // changes whenever the outline changes
    bool is_hidden = false;
    bool may_be_picked = true;  // it is neither hidden nor locked

    Vec2d on_sheet(const Vec2d& u) const { return u + origin; }
    Vec2d in_panel(const Vec2d& sheet) const { return sheet - origin; }
    SheetBox sheet_box() const { return box.isEmpty() ? box : SheetBox(box.min() + origin, box.max() + origin); }
    bool contains(const Vec2d& u) const;  // u in the held frame
};

class SheetGeometry {
 public:
    // Updates the cache; panels with the same outline are kept. `revision`: the document's; while it is unchanged, only
    // the states are taken.
    void update(const sim::Pattern& pattern, std::uint64_t revision, const PanelStates& states = {});

    const std::vector<PanelShape>& panels() const { return panels_; }  // in the pattern's order
    const PanelShape* find(const std::string& panel) const;            // nullptr: no such panel

    // nullptr: no such edge.
    const EdgeShape* edge(const PartRef& ref) const;
    std::optional<Vec2d> vertex(const PartRef& ref) const;  // on the sheet, m
    std::optional<int> seam_of(const PartRef& edge) const;  // index of the edge's first seam

    SheetBox box() const;        // bounding box of all panels, on the sheet
    SheetBox drawn_box() const;  // without hidden panels
    SheetBox box_of(const Selection& selection) const;

 private:
    void take(const PanelStates& states);

    std::vector<PanelShape> panels_;
    PanelStates states_;
    std::vector<sim::Seam> seams_;
    std::optional<std::uint64_t> revision_;
    std::uint64_t next_outline_version_ = 1;
};

// The point on the sheet, m, at the fraction t of an edge. Pre: the edge index is in range.
Vec2d sheet_point(const PanelShape& shape, int edge, double t);

}  // namespace selvedge::editor
