#pragma once
// The pattern as it lies on the drafting sheet: polylines and boxes of every panel, kept until the panel changes, so
// that picking, snapping and drawing need not walk curves.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "editor/document/selection.h"
#include "sim/core/math.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// How the drafting sheet (m, y up) lies on the screen (px from the upper left, y down).

using SheetBox = Eigen::AlignedBox2d;

inline constexpr double kMinSheetScale = 15;     // px/m: 80 m on a screen
inline constexpr double kMaxSheetScale = 60000;  // px/m: a millimetre is 60 px

struct SheetCamera {
    Vec2d centre = Vec2d::Zero();        // m, in the middle of the view
    double scale = 600;                  // px/m
    Vec2d view_low = Vec2d::Zero();      // px, upper left corner
    Vec2d view_size = Vec2d(1000, 800);  // px

    bool operator==(const SheetCamera&) const = default;
};

Vec2d to_px(const SheetCamera& camera, const Vec2d& sheet);
Vec2d to_sheet(const SheetCamera& camera, const Vec2d& px);
SheetBox visible_box(const SheetCamera& camera);  // m

// The sheet follows the cursor.
void pan(SheetCamera& camera, const Vec2d& by_px);

// What lies under the cursor stays there; a notch makes it 1.18 times as large. Kept within the limits.
void zoom_at(SheetCamera& camera, const Vec2d& px, double notches);

// Shows the whole box with a margin about it. An empty box, or one that is not finite: nothing happens; one without
// extent is shown in its middle.
void frame(SheetCamera& camera, const SheetBox& box, double margin_px);

// The finest of 1 mm, 5 mm, 1 cm, 5 cm, 10 cm, 50 cm and 1 m whose lines stand at least so far apart, m.
double grid_step(const SheetCamera& camera, double at_least_px);

// Points in the panel's held frame, m.
struct EdgeShape {
    std::vector<Vec2d> points;    // at least two, within kShapeError of the curve
    std::vector<double> reached;  // m of length, up to each point
    double length = 0;            // m
    SheetBox box;

    Vec2d at(double t) const;       // at a fraction of the length
    Vec2d tangent(double t) const;  // of length 1; zero where the edge has no length
};

inline constexpr double kShapeError = 5e-5;  // m

struct EdgeHit {
    double t = 0;  // fraction of the length
    Vec2d point = Vec2d::Zero();
    double distance = 0;  // m
};
EdgeHit nearest(const EdgeShape& shape, const Vec2d& u);

struct PanelShape {
    sim::Panel panel;                   // what it was made from
    Vec2d origin = Vec2d::Zero();       // m, of the panel's frame on the sheet
    std::vector<EdgeShape> edges;       // one per edge of the panel
    std::vector<Vec2d> outline;         // all of them as one closed polyline, each point once
    SheetBox box;                       // of the outline
    std::uint64_t outline_version = 0;  // another number: another outline

    Vec2d on_sheet(const Vec2d& u) const { return u + origin; }
    Vec2d in_panel(const Vec2d& sheet) const { return sheet - origin; }
    SheetBox sheet_box() const { return box.isEmpty() ? box : SheetBox(box.min() + origin, box.max() + origin); }
    bool contains(const Vec2d& u) const;  // of the held frame
};

class SheetGeometry {
 public:
    // Cheap where nothing changed. `revision`: of the document, to see that at once.
    void update(const sim::Pattern& pattern, std::uint64_t revision);

    const std::vector<PanelShape>& panels() const { return panels_; }  // in the pattern's order
    const PanelShape* find(const std::string& panel) const;            // nullptr: there is none

    // nullptr where there is no such edge.
    const EdgeShape* edge(const PartRef& ref) const;
    std::optional<Vec2d> vertex(const PartRef& ref) const;  // on the sheet, m
    std::optional<int> seam_of(const PartRef& edge) const;  // the first seam that joins the edge

    SheetBox box() const;  // of all panels, on the sheet
    SheetBox box_of(const Selection& selection) const;

 private:
    std::vector<PanelShape> panels_;
    std::vector<sim::Seam> seams_;
    std::optional<std::uint64_t> revision_;
    std::uint64_t next_outline_version_ = 1;
};

// m of a point on the sheet where a notch, or the fraction t of an edge, lies. Pre: the indices are in range.
Vec2d sheet_point(const PanelShape& shape, int edge, double t);

}  // namespace selvedge::editor
