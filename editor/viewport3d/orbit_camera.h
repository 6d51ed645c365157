#pragma once
// The camera of the 3D view. The mouse orbits, pans and zooms it; named views and framing move it smoothly. The caller
// passes the elapsed time. Also converts between positions on the screen and points in the 3D scene.
#include <optional>
#include <vector>

#include "render/scene/camera.h"

namespace selvedge::editor {

enum class StandardView { Front, Back, Left, Right, Top, Bottom };

// Usual: perspective. Long: a telephoto lens, almost an orthographic projection.
enum class Lens { Usual, Long };

// The camera's pose, relative to the point that it looks at.
struct CameraPose {
    Vec3f target{0, 0.87F, 0};  // m
    float distance = 5.2F;      // m, with the usual lens; the long one moves the eye back for the same framing
    float azimuth = 0.42F;      // rad, as in render::Direction
    float elevation = 0.12F;
    Lens lens = Lens::Usual;

    bool operator==(const CameraPose&) const = default;
};

render::Camera camera_at(const CameraPose& standpoint);

class OrbitCamera {
 public:
    const CameraPose& standpoint() const { return now_; }
    render::Camera camera() const { return camera_at(now_); }

    // Input: the mouse motion in px. orbit(), pan() and zoom() cancel a running camera move.
    void orbit(const Vec2f& by_px);
    void pan(const Vec2f& by_px, const Vec2f& size_px);  // the target moves with the cursor

    // Zooms by wheel notches; the point `about` keeps its position on the screen.
    void zoom(float notches, const Vec3f& about);

    // These start a smooth camera move (0.24 s); advance() runs it.
    void look_from(StandardView view);
    void turn_opposite();
    void frame(const std::vector<Vec3f>& points, float aspect);  // frames all points; does nothing if there are none

    void change_lens();

    void shift(const Vec3f& by);  // m: follows what it looks at

    void advance(float seconds);
    bool is_moving() const { return left_ > 0; }

 private:
    void move_to(const CameraPose& there);
    const CameraPose& goal() const { return is_moving() ? to_ : now_; }

    CameraPose now_;
    CameraPose from_;
    CameraPose to_;
    float left_ = 0;  // s, remaining time of the camera move
};

// Conversions between the screen and the 3D scene. Screen positions are px from the upper left corner of the view.

struct Ray {
    Vec3f origin = Vec3f::Zero();      // m
    Vec3f direction = Vec3f::UnitZ();  // unit length

    Vec3f at(float distance) const { return origin + distance * direction; }
};

// A camera and the size of the image that it fills.
struct Viewing {
    render::Camera camera;
    Vec2f size_px{1, 1};
};

Ray ray_through(const Viewing& viewing, const Vec2f& px);

// Returns none if the point lies behind the eye.
std::optional<Vec2f> px_of(const Viewing& viewing, const Vec3f& x);

// Distance in front of the eye along the view direction, m.
float depth_of(const Viewing& viewing, const Vec3f& x);

// Size of one pixel at the depth of x, m.
float metres_per_px(const Viewing& viewing, const Vec3f& x);

// The point under the pixel in the plane through x that is parallel to the image plane. Pre: x is in front of the eye.
Vec3f in_picture_plane(const Viewing& viewing, const Vec2f& px, const Vec3f& x);

}  // namespace selvedge::editor
