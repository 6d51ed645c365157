#include "bench/thesis/character_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/support/cloth_run.h"
#include "bench/thesis/base_mesh.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/standoff.h"
#include "sim/dress/dressing.h"
#include "sim/mannequin/mannequin.h"
#include "sim/motion/motion_file.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::bench {
namespace {

constexpr float kFixedRegion = 0.06F;    // m from the shoulder seams
constexpr double kLongestMotion = 0.02;  // m: a step in which the body moves farther is divided
constexpr int kMostParts = 4;
constexpr float kFreeStandoff = 0.0027F;  // m, as for garments on bodies that move (sim/dress/motion_run.cpp)

// The vertices near seams between two panels in the upper fifth of the garment: its shoulders.
std::vector<int> shoulder_vertices(const sim::GarmentMesh& mesh, const sim::Cloth& cloth) {
    const auto height = [&](std::size_t v) { return cloth.x[v].y(); };
    float low = height(0), high = low;
    for (std::size_t v = 0; v < mesh.x.size(); ++v) {
        low = std::min(low, height(v));
        high = std::max(high, height(v));
    }
    std::vector<int> panel(mesh.x.size(), -1);
    std::vector<std::size_t> seam;
    for (const sim::GarmentTriangle& t : mesh.triangles) {
        for (const int corner : t.vertices) {
            const auto v = static_cast<std::size_t>(corner);
            if (panel[v] >= 0 && panel[v] != t.panel && height(v) > high - (high - low) / 5) seam.push_back(v);
            panel[v] = t.panel;
        }
    }
    std::vector<int> fixed;
    for (std::size_t v = 0; v < mesh.x.size(); ++v) {
        const auto is_near = [&](std::size_t other) { return (cloth.x[v] - cloth.x[other]).norm() < kFixedRegion; };
        if (std::ranges::any_of(seam, is_near)) fixed.push_back(static_cast<int>(v));
    }
    return fixed;
}

}  // namespace

BlendedMotion::BlendedMotion(const sim::Body& body, const sim::Clip& walk, double seconds) {
    const sim::Pose rest = rest_pose(body);
    const sim::Clip start = sim::transition(rest, sample(body, walk, 0), kStartSeconds, "start");
    const auto count = static_cast<std::size_t>(std::ceil(seconds / kAnimationFrame)) + 2;
    for (std::size_t i = 0; i < count; ++i) {
        const double time = static_cast<double>(i) * kAnimationFrame - kStandSeconds;
        frames_.push_back(time < kStartSeconds ? sample(body, start, std::max(0.0, time))
                                               : sample(body, walk, time - kStartSeconds));
    }
}

BlendedMotion::Moment BlendedMotion::at(double seconds) const {
    const double frame = std::clamp(seconds / kAnimationFrame, 0.0, static_cast<double>(frames_.size() - 1));
    const double whole = std::min(std::floor(frame), static_cast<double>(frames_.size() - 2));
    return {.frame = static_cast<std::size_t>(whole), .share = frame - whole};
}

sim::Pose BlendedMotion::pose(double seconds) const {
    const Moment moment = at(seconds);
    return blend(frames_[moment.frame], frames_[moment.frame + 1], moment.share);
}

Character make_character(const ThesisOptions& options) {
    if (options.body) return {.body = options.body, .walk = options.motion};
    const auto body =
        std::make_shared<const sim::Body>(sim::make_mannequin({.subdivisions = options.is_quick ? 1 : 2}).body);
    return {.body = body, .walk = sim::find_motion("walk", *body)};
}

DressedCharacter make_dressed_character(const ThesisOptions& options, int triangles) {
    Character character = make_character(options);
    const sim::Pattern pattern = sim::load_pattern(options.dress).pattern;
    const double edge_length = edge_length_for(pattern, triangles);
    sim::Dressing dressing;
    dressing.set_options({.edge_length = edge_length,
                          .max_level = 0,
                          .deepest_level = 3,
                          .max_seconds = options.is_quick ? 0.5 : 6.0,
                          .finish_time = 0,
                          .self_collision = false});
    dressing.set_body(character.body);
    dressing.set_pattern(pattern);
    while (dressing.advance()) {
    }
    DressedCharacter dressed{.body = std::move(character.body),
                             .walk = std::move(character.walk),
                             .base = dressing.sewn_mesh(),
                             .cloth = *dressing.cloth(),
                             .panel_names = {},
                             .edge_length = edge_length};
    for (const sim::Panel& panel : pattern.panels) dressed.panel_names.push_back(panel.name);
    dressed.base.pins = shoulder_vertices(dressed.base, dressed.cloth);
    for (const int v : dressed.base.pins) dressed.cloth.is_pinned[static_cast<std::size_t>(v)] = true;
    refresh_solver(dressed.cloth);
    return dressed;
}

sim::StepOptions CharacterRun::step_options() {
    return {.extra_damping = 2};
}

sim::AdaptClothOptions CharacterRun::adapt_options() {
    return {.shortest_edge = 0};
}

CharacterRun::CharacterRun(const DressedCharacter& character, const CharacterRunOptions& options)
    : character_(character),
      options_(options),
      motion_(*character.body, character.walk, options.seconds),
      skin_(*character.body),
      collider_(*character.body),
      cloth_(character.cloth),
      visibility_({}) {
    if (options.budget) budget_.emplace(sim::BudgetOptions{.target = *options.budget});
    skin_.positions(*character.body, motion_.pose(0), end_);
    collider_.place(end_);
    if (options.collides_with_limbs) {
        limbs_ = std::make_unique<LimbCollider>(*character.body);
        limbs_->move_to(*character.body, motion_.pose(0), end_);
    }
    forget_contacts(cloth_);
    if (options.touches_at_vertices) {
        free_standoffs(cloth_, {.free = 0});
        refresh_contacts(cloth_, contact());
    }
    set_substep(cloth_, static_cast<float>(kClothStep / step_options().substeps));
    if (!options.level) return;
    sim::AdaptClothOptions uniform{.criteria = {.collision = false, .curvature = false, .length = false},
                                   .shortest_edge = 0};
    std::vector<sim::MinimumLevelDisc> everywhere;
    for (std::size_t panel = 0; panel < character.panel_names.size(); ++panel) {
        everywhere.push_back({.panel = static_cast<std::uint16_t>(panel),
                              .centre = Vec2f::Zero(),
                              .radius = 10,
                              .level = *options.level});
    }
    uniform.minimum_levels = everywhere;
    adapt_cloth(cloth_, cloth_collider(), uniform, contact());
}

sim::ContactOptions CharacterRun::contact() const {
    constexpr float kNone = 10;  // m, longer than any edge
    if (options_.touches_at_vertices) return {.sample_spacing = kNone, .sampled_edge = kNone};
    return {};
}

void CharacterRun::frame(CharacterTimes& times) {
    if (!options_.level) times.adaptation += 1e3 * time_once([&] { adapt(); });
    if (!options_.touches_at_vertices)
        times.collision +=
            1e3 * time_once([&] { update_standoffs(cloth_, cloth_collider(), {.free = kFreeStandoff}); });
    for (int i = 0; i < kStepsPerAdaptation; ++i) step_once(times);
}

void CharacterRun::adapt() {
    sim::AdaptClothOptions adapting = adapt_options();
    if (options_.coarsens_back_faces) {
        visibility_.move_to({.eye = viewer_of(body_x())});
        adapting.visibility = &visibility_;
    }
    if (budget_) adapting.budget = &*budget_;
    adapt_cloth(cloth_, cloth_collider(), adapting, contact());
}

const sim::Collider& CharacterRun::cloth_collider() const {
    if (limbs_) return *limbs_;
    return collider_;
}

void CharacterRun::move_to(const sim::Pose& pose, CharacterTimes& times) {
    times.skinning += 1e3 * time_once([&] { skin_.positions(*character_.body, pose, end_); });
    const double moving = time_once([&] { collider_.move_to(end_); });
    if (!limbs_) times.structures += 1e3 * moving;
}

void CharacterRun::move_limbs(const sim::Pose& pose, CharacterTimes& times) {
    times.structures += 1e3 * time_once([&] { limbs_->move_to(*character_.body, pose, end_); });
    keep_far_contacts(cloth_, collider_.longest_motion());
}

void CharacterRun::arrive(CharacterTimes& times) {
    const double arriving = time_once([&] { collider_.arrive(); });
    if (!limbs_) times.structures += 1e3 * arriving;
}

// The thesis' structures stand still in each part: the skin then passes at most half of what they see, unless that
// takes more parts than there are sub-steps.
int CharacterRun::parts_of_step() const {
    const double longest = limbs_ ? LimbCollider::kReach / 2 : kLongestMotion;
    const int most = limbs_ ? step_options().substeps : kMostParts;
    return std::clamp(static_cast<int>(std::ceil(static_cast<double>(collider_.longest_motion()) / longest)), 1, most);
}

void CharacterRun::step_once(CharacterTimes& times) {
    sim::StepOptions stepping = step_options();
    stepping.contact = contact();
    const auto pose_at = [&](double share) { return motion_.pose(seconds() + share * kClothStep); };
    move_to(pose_at(1), times);
    const int parts = parts_of_step();
    const int substeps = stepping.substeps;
    int done = 0;
    for (int part = 1; part <= parts; ++part) {
        const sim::Pose pose = pose_at(static_cast<double>(part) / parts);
        if (parts > 1) move_to(pose, times);
        if (limbs_) move_limbs(pose, times);
        const int until = substeps * part / parts;
        sim::StepTimes within;
        stepping.substeps = until - done;
        stepping.times = &within;
        const Duration spent = time_both([&] {
            stepping.kinematic = pins_.follow(cloth_, collider_.surface(), end_);
            step(cloth_, cloth_collider(), stepping);
        });
        const double colliding = spent.wall > 0 ? within.collision / spent.wall : 0;
        times.collision += 1e3 * spent.cpu * colliding;
        times.simulation += 1e3 * spent.cpu * (1 - colliding);
        done = until;
        arrive(times);
    }
    ++steps_;
    updates_.push_back(seconds());
}

int CharacterRun::vertices_in_contact() const {
    constexpr float kTouches = 0.0001F;  // m above the offset surface
    int count = 0;
    for (const sim::VertexId v : cloth_.mesh.leaf_vertices())
        count += cloth_.solver->contacts.plane[v.value].w() < kTouches ? 1 : 0;
    return count;
}

Vec3f place_of(std::span<const Vec3f> x) {
    Eigen::AlignedBox3f box;
    for (const Vec3f& p : x) box.extend(p);
    return {box.center().x(), 0, box.center().z()};
}

Vec3f viewer_of(std::span<const Vec3f> body_x) {
    constexpr float kDistance = 3;  // m
    return place_of(body_x) + Vec3f(0, 1, kDistance);
}

}  // namespace selvedge::bench
