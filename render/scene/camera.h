#pragma once
// The camera of a picture, and how it frames a scene or a detail of a garment. The lens is long (24 degrees), as for
// catalogue pictures, so that a body keeps its proportions.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::render {

// Where the camera stands: +z is the front of a body, +x its left. Close and Hem are details of a garment (see below).
enum class View { Front, Back, Left, Right, ThreeQuarter, ThreeQuarterBack, Top, Close, Hem };

inline constexpr const char* kViewNames =
    "front, back, left, right, three-quarter, three-quarter-back, top, close, hem";
std::optional<View> parse_view(std::string_view name);

// Direction from the camera's target to the camera.
struct Direction {
    float azimuth = 0;    // rad, from the body's front towards its left
    float elevation = 0;  // rad, above the horizon; below pi/2
};

Direction direction_of(View view);

// The direction as a unit vector.
Vec3f unit_vector(const Direction& direction);

inline constexpr float kUsualFovY = 0.42F;  // rad, full vertical angle of the usual lens

struct Camera {
    Vec3f eye{0, 1, 5};     // m
    Vec3f target{0, 1, 0};  // m
    Vec3f up{0, 1, 0};
    float fov_y = kUsualFovY;  // rad, full vertical angle
    float near_plane = 0.1F;   // m
    float far_plane = 100;     // m
};

struct FrameOptions {
    float aspect = 1;      // width over height
    float margin = 0.07F;  // fraction of the picture's half extent, left free on each side
    // Fractions of the width and height that are also left free, for a legend.
    float free_left = 0;
    float free_below = 0;
};

inline constexpr float kGarmentMargin = 0.12F;  // for a garment that is framed without its body

// The camera at `view` that sees all points from as near as possible. Pre: aspect > 0; points not empty; margin and
// free parts leave a part of the picture.
Camera frame_points(const std::vector<Vec3f>& points, View view, const FrameOptions& options);
Camera frame_points(const std::vector<Vec3f>& points, const Direction& direction, const FrameOptions& options);

// A camera with these eye and target points; near and far plane enclose all points.
Camera camera_at(const Vec3f& eye, const Vec3f& target, const std::vector<Vec3f>& points);

// Size of one pixel in m, at the depth of the camera's target, in a picture of this height.
float pixel_size(const Camera& camera, int height_px);

// The same camera with another field of view: everything appears `times` as large about the centre. Pre: times > 0.
Camera zoomed(Camera camera, float times);

// The camera for the same view after the scene turned by `angle` (rad, anticlockwise from above) about the vertical
// line through `axis`: the camera moves the opposite way.
Camera turned(Camera camera, float angle, const Vec3f& axis);

// A point on the vertical line through the centre of the points' bounding box. Pre: points not empty.
Vec3f upright_through(const std::vector<Vec3f>& points);

// The points after each of these turns (rad) about that line, one turn after the other: to frame a scene that turns.
std::vector<Vec3f> at_all_turns(const std::vector<Vec3f>& points, const Vec3f& axis, const std::vector<float>& turns);

Eigen::Matrix4f view_matrix(const Camera& camera);
Eigen::Matrix4f projection_matrix(const Camera& camera, float aspect);

// Detail views show a patch of fixed size, so that fabrics can be compared side by side.

inline constexpr float kDetailSize = 0.30F;  // m, side of the square patch that Close and Hem show

bool is_detail(View view);

// The corners of the patch at the front of the garment: at its upper edge for Close, at its lower edge for Hem.
// Pre: is_detail(view), points not empty.
std::vector<Vec3f> detail_patch(const std::vector<Vec3f>& garment, View view);

}  // namespace selvedge::render
