#pragma once
// A flat sheet of woven cloth in even light, and the expected picture, computed point by point from the colour of every
// thread.
#include <vector>

#include "render/draw/renderer.h"
#include "render/image/image.h"
#include "sim/tartan/sett.h"

namespace selvedge::test {

struct SheetView {
    sim::Sett sett;
    double field = 0.1;      // m, covered by the picture's height at the sheet's centre
    double turn = 0;         // rad, rotation of the sheet in its plane
    double tilt = 0;         // rad, 0 faces the camera
    bool is_behind = false;  // the camera sees the wrong side
    float key = 0;           // irradiance of a light at the camera; ambient light gives the rest of kSheetLight
};

inline constexpr float kSheetLight = 0.8F;

// The sheet fills the picture from every angle.
render::Scene sheet_scene(const SheetView& view);

// Linear light; rows from the top.
struct LinearPicture {
    int side_px = 0;
    std::vector<Vec3d> pixels;

    Vec3d mean() const;
    std::vector<double> channel(int index) const;
};

LinearPicture to_linear(const render::Image& image);

// Dyes that each pixel sees: the mean over samples x samples jittered positions in it, each with the colour of the one
// thread that is visible there.
LinearPicture dyes_seen(const SheetView& view, int side_px, int samples);

// The colour that the camera sees of a dye in this light.
Vec3d lit_dye(const Vec3d& dye, const SheetView& view, const Vec3d& light);

}  // namespace selvedge::test
