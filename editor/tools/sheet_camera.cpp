#include "editor/tools/sheet_camera.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace selvedge {
namespace {

constexpr double kNotch = 1.18;

Vec2d middle_px(const SheetCamera& camera) {
    return camera.view_low + camera.view_size / 2;
}

}  // namespace

Vec2d to_px(const SheetCamera& camera, const Vec2d& sheet) {
    const Vec2d away = (sheet - camera.centre) * camera.scale;
    return middle_px(camera) + Vec2d(away.x(), -away.y());
}

Vec2d to_sheet(const SheetCamera& camera, const Vec2d& px) {
    const Vec2d away = (px - middle_px(camera)) / camera.scale;
    return camera.centre + Vec2d(away.x(), -away.y());
}

SheetBox visible_box(const SheetCamera& camera) {
    const Vec2d half = camera.view_size / (2 * camera.scale);
    return {camera.centre - half, camera.centre + half};
}

void pan(SheetCamera& camera, const Vec2d& by_px) {
    camera.centre -= Vec2d(by_px.x(), -by_px.y()) / camera.scale;
}

void zoom_at(SheetCamera& camera, const Vec2d& px, double notches) {
    if (!std::isfinite(notches)) return;
    const Vec2d held = to_sheet(camera, px);
    const double factor = std::pow(kNotch, std::clamp(notches, -100.0, 100.0));
    camera.scale = std::clamp(camera.scale * factor, kMinSheetScale, kMaxSheetScale);
    camera.centre += held - to_sheet(camera, px);
}

void frame(SheetCamera& camera, const SheetBox& box, double margin_px) {
    if (box.isEmpty() || !box.min().allFinite() || !box.max().allFinite()) return;
    const Vec2d room = (camera.view_size - Vec2d::Constant(2 * margin_px)).cwiseMax(Vec2d(20, 20));
    const Vec2d size = box.sizes().cwiseMax(Vec2d(0.01, 0.01));
    camera.scale = std::clamp((room.array() / size.array()).minCoeff(), kMinSheetScale, kMaxSheetScale);
    camera.centre = box.center();
}

double grid_step(const SheetCamera& camera, double at_least_px) {
    constexpr std::array<double, 7> steps{0.001, 0.005, 0.01, 0.05, 0.1, 0.5, 1.0};
    for (const double step : steps) {
        if (step * camera.scale >= at_least_px) return step;
    }
    return steps.back();
}

}  // namespace selvedge
