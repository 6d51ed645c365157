#pragma once
// Where a picture is taken from. A long lens, as for catalogue pictures, so that a figure keeps its proportions.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::render {

// Seen from: +z is the front of a body, +x its left. Close and Hem are details of a garment (render/scene/camera.h).
enum class View { Front, Back, Left, Right, ThreeQuarter, ThreeQuarterBack, Top, Close, Hem };

inline constexpr const char* kViewNames =
    "front, back, left, right, three-quarter, three-quarter-back, top, close, hem";
std::optional<View> parse_view(std::string_view name);

// Where the eye stands, seen from what it looks at.
struct Direction {
    float azimuth = 0;    // rad, from the front towards the body's left
    float elevation = 0;  // rad, above the horizon; less than a quarter turn
};

Direction direction_of(View view);

struct Camera {
    Vec3f eye{0, 1, 5};     // m
    Vec3f target{0, 1, 0};  // m
    Vec3f up{0, 1, 0};
    float fov_y = 0.42F;      // rad, full vertical angle
    float near_plane = 0.1F;  // m
    float far_plane = 100;    // m
};

struct FrameOptions {
    float aspect = 1;      // width over height
    float margin = 0.07F;  // of the picture's half extent, left free all round
    // Shares of the width and height that are kept free beside the margin, for a legend.
    float free_left = 0;
    float free_below = 0;
};

// The camera at `view` that holds all points, as near as it can be. Pre: aspect > 0, points not empty, something is
// left of the picture.
Camera frame_points(const std::vector<Vec3f>& points, View view, const FrameOptions& options);
Camera frame_points(const std::vector<Vec3f>& points, const Direction& direction, const FrameOptions& options);

// The same camera with a lens that shows everything `times` as large, about the middle. Pre: times > 0.
Camera zoomed(Camera camera, float times);

// The same camera after the scene turned by `angle` (rad, anticlockwise from above) about the upright through `axis`.
Camera turned(Camera camera, float angle, const Vec3f& axis);

Eigen::Matrix4f view_matrix(const Camera& camera);
Eigen::Matrix4f projection_matrix(const Camera& camera, float aspect);

// What of a garment a detail shows: patches of one size, so that fabrics are judged side by side.

inline constexpr float kDetailSize = 0.30F;  // m, of the patch that Close and Hem show

bool is_detail(View view);

// The corners of the patch: at the front, by the garment's upper edge for Close, by its lower one for Hem.
// Pre: is_detail(view), points not empty.
std::vector<Vec3f> detail_patch(const std::vector<Vec3f>& garment, View view);

}  // namespace selvedge::render
