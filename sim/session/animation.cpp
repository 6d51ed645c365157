#include "sim/session/animation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "sim/body/tented.h"
#include "sim/core/assert.h"
#include "sim/dress/drape.h"
#include "sim/dress/motion_run.h"
#include "sim/motion/grounding.h"
#include "sim/session/dress.h"

namespace selvedge::sim {

BodyTimeline::BodyTimeline(std::shared_ptr<const Body> body, Pose start, Clip clip, const AnimationOptions& options)
    : body_(std::move(body)), start_(std::move(start)), clip_(std::move(clip)), options_(options), flesh_(*body_) {
    const double rest = std::max(0.0, options_.to.value_or(clip_.seconds) - options_.from) / options_.speed;
    motion_seconds_ = options_.seconds.value_or(rest);
    SELVEDGE_ASSERT(start_.bones.size() == body_->bones.size());
    way_ = way_over_floor(*body_, sample(*body_, clip_, options_.from), start_);
}

Pose BodyTimeline::pose(double seconds) const {
    const double in_motion = std::max(0.0, seconds - options_.blend_seconds);
    Pose moving = sample(*body_, clip_, options_.from + options_.speed * in_motion);
    shift(*body_, moving, way_);
    if (seconds >= options_.blend_seconds) return moving;
    return blend_on_floor(*body_, start_, moving, smoothstep(seconds, 0, options_.blend_seconds));
}

void BodyTimeline::positions(double seconds, const Region& region, std::vector<Vec3f>& x) {
    flesh_.positions(
        *body_, [this](double at) { return pose(at); }, seconds, region, x);
}

Animation::Animation(const Pattern& pattern, std::shared_ptr<const Body> body, Pose start, Clip clip,
                     const AnimationOptions& options, const Progress& progress)
    : timeline_(std::make_shared<const Body>(tented(*body)), std::move(start), std::move(clip), options),
      options_(options),
      surface_(*body) {
    shown_ = posed(*body, timeline_.pose(0), surface_);
    for (const Vec3d& x : shown_.x) body_points_.emplace_back(x.cast<float>());
    const Body met = posed(timeline_.body(), timeline_.pose(0), timeline_.surface());
    DressedGarment dressed = dress(pattern, met, options_.dress, progress);
    report_ = std::move(dressed.report);
    simulation_ = std::move(dressed.simulation);
    panel_names_ = dressed.mesh.panel_names;
    frame_count_ = 1 + static_cast<int>(std::lround(timeline_.seconds() * options_.frames_per_second));
    MotionOptions moving;
    const double frame_seconds = 1 / options_.frames_per_second;
    moving.step_seconds = frame_seconds / std::ceil(frame_seconds / moving.step_seconds - 1e-6);
    run_ = std::make_unique<MotionRun>(
        *simulation_, met,
        [this](double seconds, const Region& region, std::vector<Vec3f>& x) {
            timeline_.positions(seconds, region, x);
        },
        moving);
    quality_.note(cloth(), run_->collider(), 0);
    if (!quality_.has_bad_number)
        kept_place_ = std::make_unique<KeptPlace>(cloth(), timeline_.body(), run_->collider().surface());
}

Animation::~Animation() = default;

const Cloth& Animation::cloth() const {
    return simulation_->cloth();
}

double Animation::seconds() const {
    return frame_ / options_.frames_per_second;
}

std::vector<std::string> Animation::motion_faults() const {
    std::vector<std::string> faults = kept_place_ ? kept_place_->faults(panel_names_) : std::vector<std::string>{};
    const std::vector<std::string> seen = quality_.faults(panel_names_);
    faults.insert(faults.end(), seen.begin(), seen.end());
    return faults;
}

bool Animation::advance() {
    if (frame_ + 1 >= frame_count_ || quality_.has_bad_number) return false;
    ++frame_;
    constexpr double kMostApart = 1.0 / 60;  // s, between two looks at the stretch
    const double frame_seconds = 1 / options_.frames_per_second;
    const int looks = static_cast<int>(std::ceil(frame_seconds / kMostApart - 1e-6));
    std::chrono::steady_clock::duration spent{};
    for (int look = 1; look <= looks; ++look) {
        const double before = run_->seconds();
        const auto start = std::chrono::steady_clock::now();
        run_->advance_to(*simulation_, seconds() - frame_seconds * (looks - look) / looks);
        spent += std::chrono::steady_clock::now() - start;
        if (look < looks) quality_.note_stretch(cloth(), run_->seconds() - before);
        if (look == looks) quality_.note(cloth(), run_->collider(), run_->seconds() - before);
    }
    if (kept_place_ && !quality_.has_bad_number) kept_place_->note(cloth(), run_->collider().surface(), seconds());
    frame_ms_.push_back(1e3 * std::chrono::duration<double>(spent).count());
    surface_.positions(shown_, timeline_.pose(seconds()), body_points_);
    std::ranges::transform(body_points_, shown_.x.begin(), [](const Vec3f& p) { return Vec3d(p.cast<double>()); });
    return true;
}

}  // namespace selvedge::sim
