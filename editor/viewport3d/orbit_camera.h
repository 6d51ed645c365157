#pragma once
// The camera of the 3D view: it goes round a point, slides and nears by the mouse, and moves smoothly to named views.
// Time is passed in.
#include <optional>
#include <vector>

#include "render/scene/camera.h"

namespace selvedge::editor {

enum class StandardView { Front, Back, Left, Right, Top, Bottom };

// Long: from so far that what is parallel stays so.
enum class Lens { Usual, Long };

// Where the camera stands, by what it looks at.
struct Standpoint {
    Vec3f target{0, 0.87F, 0};  // m
    float distance = 5.2F;      // m, with the usual lens; the long one stands further off and shows the same
    float azimuth = 0.42F;      // rad, see Direction
    float elevation = 0.12F;
    Lens lens = Lens::Usual;

    bool operator==(const Standpoint&) const = default;
};

render::Camera camera_at(const Standpoint& standpoint);

class OrbitCamera {
 public:
    const Standpoint& standpoint() const { return now_; }
    render::Camera camera() const { return camera_at(now_); }

    // By the mouse's way, px. What the camera was moving to is given up.
    void orbit(const Vec2f& by_px);
    void pan(const Vec2f& by_px, const Vec2f& size_px);  // the target follows the cursor

    // Nears by wheel notches; `about` stays where it is on the screen.
    void zoom(float notches, const Vec3f& about);

    // These take a moment.
    void look_from(StandardView view);
    void turn_opposite();
    void frame(const std::vector<Vec3f>& points, float aspect);  // all of them in view; nothing for no points

    void change_lens();

    void advance(float seconds);
    bool is_moving() const { return left_ > 0; }

 private:
    void move_to(const Standpoint& there);
    const Standpoint& goal() const { return is_moving() ? to_ : now_; }

    Standpoint now_;
    Standpoint from_;
    Standpoint to_;
    float left_ = 0;  // s until it is there
};

// From the screen into the room and back. Positions on the screen are px from the view's upper left.

struct Ray {
    Vec3f origin = Vec3f::Zero();      // m
    Vec3f direction = Vec3f::UnitZ();  // unit

    Vec3f at(float distance) const { return origin + distance * direction; }
};

// A camera and the picture that it fills.
struct Viewing {
    render::Camera camera;
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

}  // namespace selvedge::editor
