#pragma once
// The camera of the 3D view: it goes round a point, slides and nears by the mouse, and moves smoothly to named views.
// Time is passed in.
#include <vector>

#include "render/scene/camera.h"

namespace selvedge {

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

Camera camera_at(const Standpoint& standpoint);

class OrbitCamera {
 public:
    const Standpoint& standpoint() const { return now_; }
    Camera camera() const { return camera_at(now_); }

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

}  // namespace selvedge
