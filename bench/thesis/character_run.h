#pragma once
// A dress on a walking character: the scene of the thesis' chapters 5 and 6. Dresses a body, fixes the dress at the
// shoulders, and runs the cloth while the body walks; each part is timed.  (thesis 5.2.1, 5.3.5, 5.6, 6.3)
//
// The body is posed at animation frames, 25 per second. A cloth step of 1/120 s sees the body at a blended frame: the
// two animation frames round its time, in proportion.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/thesis/limb_collider.h"
#include "bench/thesis/surface_tables.h"
#include "bench/thesis/thesis.h"
#include "sim/adaptive/back_face.h"
#include "sim/adaptive/triangle_budget.h"
#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/body/skin.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/step.h"
#include "sim/collide/moving_body.h"
#include "sim/dress/motion_run.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::bench {

inline constexpr double kAnimationFrame = 1.0 / 25;  // s
inline constexpr double kClothStep = 1.0 / 120;      // s
inline constexpr int kStepsPerAdaptation = 4;
inline constexpr double kStandSeconds = 0.5;                         // at rest, at the start
inline constexpr double kStartSeconds = 1.5;                         // from rest into the walk
inline constexpr double kWalkStart = kStandSeconds + kStartSeconds;  // s

// A body at rest that begins to walk, posed at animation frames.
class BlendedMotion {
 public:
    // The motion's frames up to `seconds`. The clip should be a loop.
    BlendedMotion(const sim::Body& body, const sim::Clip& walk, double seconds);

    struct Moment {
        std::size_t frame = 0;  // of the earlier of the two animation frames
        double share = 0;       // of the later one, 0..1
    };
    // Times after the last frame give that one.
    Moment at(double seconds) const;
    sim::Pose pose(double seconds) const;

 private:
    std::vector<sim::Pose> frames_;
};

// A character in its dress, settled in the rest pose at level 0, and fixed at the shoulders.
struct DressedCharacter {
    std::shared_ptr<const sim::Body> body;
    sim::Clip walk;
    sim::GarmentMesh base;  // sewn; its pins are those of the cloth
    sim::Cloth cloth;
    std::vector<std::string> panel_names;
    double edge_length = 0;  // m, of the base mesh
};

// The body of the options, or the mannequin; the base mesh has the number of triangles that is nearest to `triangles`.
// Throws InputError if the dress cannot be read.
DressedCharacter make_dressed_character(const ThesisOptions& options, int triangles = 488);

// The body that walks, without a dress.
struct Character {
    std::shared_ptr<const sim::Body> body;
    sim::Clip walk;
};
Character make_character(const ThesisOptions& options);

// ms per frame of 1/30 s: one adaptation and four steps. CPU times of one thread.
struct CharacterTimes {
    double skinning = 0;
    double structures = 0;  // our hierarchy or the cylinders and spheres, moved to each blended frame
    double simulation = 0;  // the steps without collision
    double collision = 0;
    double adaptation = 0;
};

struct CharacterRunOptions {
    std::optional<int> level{};        // uniform; none: adaptive by all criteria
    bool coarsens_back_faces = false;  // seen by a viewer in front, who goes along
    bool touches_at_vertices = false;  // as the thesis' cloth: no contact points between them, and no standoffs
    bool collides_with_limbs = false;  // with the thesis' cylinders and spheres instead of our hierarchy
    std::optional<std::size_t> budget{};
    double seconds = kWalkStart + 4;  // longest run
};

class CharacterRun {
 public:
    // Starts at rest. The character must outlive the run.
    CharacterRun(const DressedCharacter& character, const CharacterRunOptions& options);
    CharacterRun(const CharacterRun&) = delete;
    CharacterRun& operator=(const CharacterRun&) = delete;

    // Runs one frame of 1/30 s, and adds its times.
    void frame(CharacterTimes& times);

    double seconds() const { return static_cast<double>(steps_) * kClothStep; }
    const sim::Cloth& cloth() const { return cloth_; }
    const BlendedMotion& motion() const { return motion_; }
    // Our hierarchy, also where the cloth collides with the limbs.
    const sim::MovingBodyCollider& collider() const { return collider_; }
    sim::TriangleBudget* budget() { return budget_ ? &*budget_ : nullptr; }
    sim::Pose pose() const { return motion_.pose(seconds()); }  // of the body, now
    std::span<const Vec3f> body_x() const { return collider_.surface().points(); }
    int vertices_in_contact() const;
    const std::vector<double>& updates() const { return updates_; }  // s, times of the cloth steps so far

    // What the cloth is simulated with.
    static sim::StepOptions step_options();
    static sim::AdaptClothOptions adapt_options();

 private:
    void step_once(CharacterTimes& times);
    // Sends the body to that pose.
    void move_to(const sim::Pose& pose, CharacterTimes& times);
    // Puts the cylinders and spheres there.
    void move_limbs(const sim::Pose& pose, CharacterTimes& times);
    // Ends the motion.
    void arrive(CharacterTimes& times);
    int parts_of_step() const;
    const sim::Collider& cloth_collider() const;
    sim::ContactOptions contact() const;
    void adapt();

    const DressedCharacter& character_;
    CharacterRunOptions options_;
    BlendedMotion motion_;
    sim::SkinnedSurface skin_;
    sim::MovingBodyCollider collider_;
    std::unique_ptr<LimbCollider> limbs_;
    sim::Cloth cloth_;
    sim::Visibility visibility_;
    std::optional<sim::TriangleBudget> budget_;
    long steps_ = 0;
    std::vector<double> updates_;
    std::vector<Vec3f> end_;
    sim::PinnedFollowers pins_;
};

// The middle of a surface over the floor, m.
Vec3f place_of(std::span<const Vec3f> x);

// Where the viewer of back-face coarsening stands: in front of the body, at the height of its waist.
Vec3f viewer_of(std::span<const Vec3f> body_x);

}  // namespace selvedge::bench
