#pragma once
// From the screen into the room and back. Positions on the screen are px from the view's upper left.
#include <optional>

#include "render/scene/camera.h"

namespace selvedge {

struct Ray {
    Vec3f origin = Vec3f::Zero();      // m
    Vec3f direction = Vec3f::UnitZ();  // unit

    Vec3f at(float distance) const { return origin + distance * direction; }
};

// A camera and the picture that it fills.
struct Viewing {
    Camera camera;
    Vec2f size_px{1, 1};
};

Ray ray_through(const Viewing& viewing, const Vec2f& px);

// None: it lies behind the eye.
std::optional<Vec2f> px_of(const Viewing& viewing, const Vec3f& x);

// m in front of the eye, along its axis.
float depth_of(const Viewing& viewing, const Vec3f& x);

// The size of a pixel at the depth of x, m.
float metres_per_px(const Viewing& viewing, const Vec3f& x);

// What is under the pixel in the plane through x that is parallel to the picture. Pre: x is before the eye.
Vec3f in_picture_plane(const Viewing& viewing, const Vec2f& px, const Vec3f& x);

}  // namespace selvedge
