#pragma once
// Where a picture is taken from. A long lens, as for catalogue pictures, so that a figure keeps its proportions.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {

// Seen from: +z is the front of a body, +x its left.
enum class View { Front, Back, Left, Right, ThreeQuarter };

inline constexpr const char* kViewNames = "front, back, left, right, three-quarter";
std::optional<View> parse_view(std::string_view name);

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
};

// The camera at `view` that holds all points, as near as it can be. Pre: aspect > 0, points not empty.
Camera frame_points(const std::vector<Vec3f>& points, View view, const FrameOptions& options);

Eigen::Matrix4f view_matrix(const Camera& camera);
Eigen::Matrix4f projection_matrix(const Camera& camera, float aspect);

}  // namespace selvedge
