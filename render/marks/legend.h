#pragma once
// The legend that explains a picture's colours, drawn in a corner of it: data in, pixels out.
// Also the choice of that corner.
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/image/outline_font.h"
#include "render/image/text.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"
#include "sim/tartan/sett.h"

namespace selvedge::render {

// One colour with its name, and a value to the right of it.
struct LegendRow {
    sim::Rgb8 colour{};
    std::string label;
    std::string figure{};
};

// A colour map, drawn with its low end at the left.
struct LegendScale {
    struct Tick {
        float place = 0;  // 0..1 along the map
        std::string label;
    };
    std::vector<sim::Rgb8> map;
    std::vector<Tick> ticks;  // in rising order
};

struct Legend {
    std::string title;
    std::vector<LegendRow> rows{};
    std::optional<LegendScale> scale{};
    std::vector<std::array<std::string, 2>> notes{};  // a name and its value each, below everything else
    std::shared_ptr<const OutlineFont> font{};        // null: the built-in bitmap font
};

enum class Corner { LowerLeft, LowerRight, UpperLeft, UpperRight };

struct LegendLayout {
    PixelBox box;
    float scale = 1;       // picture pixels per font pixel
    std::size_t rows = 0;  // rows that fit; if not all do, the last of them reads "and N more"
};

// The legend's box in a corner of a picture. Scale: the picture's shorter side / 512 px, at least 1, rounded down to a
// whole number, or to a quarter with an outline font; a smaller one if the legend would be wider than half of the
// picture. Rows beyond three quarters of the picture's height are left out. nullopt if it does not fit even so.
std::optional<LegendLayout> place_legend(const Legend& legend, int width_px, int height_px, Corner corner);

// Draws nothing if place_legend() returns nullopt.
void draw_legend(Image& image, const Legend& legend, Corner corner);

// Where the legend of a picture goes: the corner in which it covers nothing of the subject; if there is none, a camera
// that leaves room for it.

struct PictureSize {
    int width_px = 1;
    int height_px = 1;

    float aspect() const { return float(width_px) / float(height_px); }
};

// The points to frame, and how.
struct SubjectFrame {
    std::vector<Vec3f> points;  // at all turns
    Direction direction;
    FrameOptions options;
    float zoom = 1;
    bool holds_bodies = false;  // the bodies belong to the framed subject
    bool may_move = true;       // false: the user placed the camera, or the subject is cut off anyway

    Camera camera() const { return zoomed(frame_points(points, direction, options), zoom); }
};

struct LegendSubject {
    const Scene& scene;  // its camera is the one to try first
    const SubjectFrame& frame;
    Vec3f axis = Vec3f::Zero();       // a point on the vertical axis that the subject turns about
    const std::vector<float>& turns;  // rad
};

struct LegendPlace {
    Camera camera;
    Corner corner = Corner::LowerLeft;
};

// Chooses a corner in which the legend overlaps no triangle of the framed subject, at any turn. If there is none and
// the camera may move, makes room for the legend while keeping the subject as large as possible. Otherwise chooses the
// corner that hides least.
LegendPlace find_legend_place(const Legend& legend, const LegendSubject& subject, const PictureSize& size);

}  // namespace selvedge::render
