#pragma once
// How the drafting sheet (m, y up) lies on the screen (px from the upper left, y down).
#include "sim/core/vec.h"

namespace selvedge {

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

}  // namespace selvedge
