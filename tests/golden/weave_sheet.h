#pragma once
// A flat sheet of woven cloth in even light, and what a camera must see of it: the colour of every thread, worked out
// point by point.
#include <vector>

#include "render/draw/renderer.h"
#include "render/image/image.h"
#include "sim/tartan/sett.h"

namespace selvedge::test {

struct SheetView {
    sim::Sett sett;
    double field = 0.1;      // m that the picture's height spans at the sheet's middle
    double turn = 0;         // rad, of the sheet in its plane
    double tilt = 0;         // rad, from facing the camera
    bool is_behind = false;  // the wrong side is seen
    float key = 0;           // irradiance of a light from the camera; the room gives the rest of kSheetLight
};

inline constexpr float kSheetLight = 0.8F;

// The sheet fills the picture wherever it is looked at.
render::Scene sheet_scene(const SheetView& view);

// Linear light, the picture's rows from the top.
struct LinearPicture {
    int side_px = 0;
    std::vector<Vec3d> pixels;

    Vec3d mean() const;
    std::vector<double> channel(int index) const;
};

LinearPicture to_linear(const render::Image& image);

// What each pixel sees of the dyes: the mean over samples x samples places in it, each moved about at random, of the
// one thread that is there.
LinearPicture dyes_seen(const SheetView& view, int side_px, int samples);

// What the light makes of dyes as a camera sees them.
Vec3d lit_dye(const Vec3d& dye, const SheetView& view, const Vec3d& light);

}  // namespace selvedge::test
