#include "sim/dress/session_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "sim/core/error.h"
#include "sim/core/quantile.h"
#include "sim/dress/dress.h"
#include "sim/dress/inspect.h"
#include "sim/dress/placement.h"
#include "sim/dress/session_frame.h"
#include "sim/dress/session_limits.h"
#include "sim/pattern/seam_name.h"

namespace selvedge {
namespace {

constexpr std::size_t kTimedFrames = 30;
constexpr std::size_t kMostMessages = 50;
constexpr int kSewingSteps = 4;  // per frame, as of an adaption

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double sum_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum;
}

std::vector<std::string> names_of(const Pattern& pattern) {
    std::vector<std::string> names;
    for (const Panel& panel : pattern.panels) names.push_back(panel.name);
    return names;
}

}  // namespace

void FrameTimes::note(const SessionTimes& frame) {
    if (last_.size() < kTimedFrames) {
        last_.push_back(frame);
    } else {
        last_[next_] = frame;
    }
    next_ = (next_ + 1) % kTimedFrames;
}

SessionTimes FrameTimes::medians() const {
    const auto median = [&](double SessionTimes::*part) {
        std::vector<double> values;
        for (const SessionTimes& one : last_) values.push_back(one.*part);
        return quantile(values, 0.5);
    };
    return {median(&SessionTimes::adaption), median(&SessionTimes::steps), median(&SessionTimes::frame)};
}

SessionRun::SessionRun(std::function<void()> interrupt) : interrupt_(std::move(interrupt)) {}

bool SessionRun::moves() const {
    return is_running_ && (stage_ == SessionStage::Sewing || stage_ == SessionStage::Draping);
}

double SessionRun::frame_seconds() const {
    return kSewingSteps * StepOptions{}.substeps * static_cast<double>(ClothOptions{}.substep);
}

void SessionRun::start() {
    is_running_ = has_changed_ = true;
    if (stage_ == SessionStage::Placed || stage_ == SessionStage::Failed) begin_sewing();
}

void SessionRun::pause() {
    is_running_ = false;
    has_changed_ = true;
}

void SessionRun::say(std::string message) {
    if (messages_.size() == kMostMessages) messages_.erase(messages_.begin());
    messages_.push_back(std::move(message));
    has_changed_ = true;
}

void SessionRun::fail(const std::string& problem) {
    stage_ = SessionStage::Failed;
    is_running_ = false;
    has_changed_ = true;
    problem_ = problem;
}

void SessionRun::advance() {
    const auto start = Clock::now();
    has_changed_ = true;
    SessionTimes times;
    if (stage_ == SessionStage::Sewing) {
        try {
            sew_frame();
        } catch (const InputError& error) {  // seams that no cloth can have
            sewing_.reset();
            fail(error.what());
        }
        times.steps = ms_since(start);
    } else {
        drape_frame();
        if (drape_) {
            times.adaption = sum_of(drape_->run->result().adaption_ms);
            times.steps = sum_of(drape_->run->result().step_ms);
            drape_->run->forget_times();
        }
    }
    times.frame = ms_since(start);
    times_.note(times);
}

bool SessionRun::may_prepare() const {
    return body_ && !met_ && stage_ == SessionStage::Placed;
}

// --- sewing

void SessionRun::begin_sewing() {
    forget_drape();
    problem_.clear();
    if (!body_) return fail("there is no body to put it on");
    meet_body();
    try {
        GarmentMesh unsewn = unsewn_mesh();
        for (std::string& note : make_sewable(unsewn, met_->collider)) say(std::move(note));
        sewing_.emplace(std::move(unsewn), fabrics_of(pattern_), SewingOptions{});
    } catch (const InputError& error) {
        return fail(error.what());
    }
    past_seconds_ = 0;
    stage_ = SessionStage::Sewing;
}

void SessionRun::sew_frame() {
    for (int i = 0; i < kSewingSteps; ++i) {
        if (!sewing_->advance(met_->collider)) return end_sewing();
    }
}

void SessionRun::end_sewing() {
    SewingResult sewing = sewing_->result();
    past_seconds_ = sewing.simulated_seconds;
    if (sewing.bad_vertex) {
        sewing_.reset();
        return fail("a number went bad while it was sewn: do its panels stand where they can be sewn?");
    }
    std::vector<int> open;
    for (const OpenSeam& seam : sewing.open) {
        const long gap = std::lround(1000 * seam.gap);
        say("seam '" + seam_name(pattern_, pattern_.seams[static_cast<std::size_t>(seam.seam)]) +
            "' did not close: it gapes by " + std::to_string(gap) + " mm");
        open.push_back(seam.seam);
    }
    Drape drape{.cloth = make_cloth(sewing.sewn, fabrics_of(pattern_), {.max_level = kDeepestSessionLevel}),
                .pattern = anchored(),
                .unsewn = sewing_->unsewn(),
                .open_seams = std::move(open),
                .pins = sewing.sewn.pins,
                .run = {}};
    sewing_.reset();
    hang(std::move(drape), DrapeOptions{}.relax_time);
}

// --- draping

DrapeOptions SessionRun::draping() const {
    DrapeOptions draping{.max_seconds = std::numeric_limits<double>::infinity(), .may_rest = true};
    if (!options_.has_gravity) draping.gravity.setZero();
    draping.adapt.criteria = options_.criteria;
    draping.adapt.curvature = options_.curvature;
    draping.adapt.shortest_edge = static_cast<float>(options_.shortest_edge);
    draping.adapt.max_level = options_.max_level;
    return draping;
}

void SessionRun::hang(Drape drape, double relax_time) {
    drape_ = std::move(drape);
    hands_.forget_vertices();
    DrapeOptions options = draping();
    options.relax_time = relax_time;
    options.coarse_time = std::min(options.coarse_time, relax_time - DrapeOptions{}.coarse_time);
    drape_->run.emplace(drape_->cloth, options);
    apply_options();
    stage_ = SessionStage::Draping;
    has_changed_ = true;
}

// What the options point to lives here.
void SessionRun::apply_options() {
    if (options_.triangle_budget) {
        const auto target = static_cast<std::size_t>(*options_.triangle_budget);
        if (!budget_) budget_.emplace(BudgetOptions{.target = target});
        budget_->set_target(target);
    } else {
        budget_.reset();
    }
    if (!drape_) return;
    DrapeOptions& options = drape_->run->options();
    const double relax_time = options.relax_time, coarse_time = options.coarse_time;
    options = draping();
    options.relax_time = relax_time;
    options.coarse_time = coarse_time;
    options.adapt.budget = budget_ ? &*budget_ : nullptr;
    options.adapt.kept_vertices = hands_.held();
    options.lead = [this](const Cloth& cloth, float seconds) { return hands_.lead(cloth, met_->collider, seconds); };
}

void SessionRun::follow_hands() {
    const bool is_other = hands_.take_hold(drape_->cloth, drape_->pins);
    const bool goes_elsewhere = hands_.take_news();
    drape_->run->options().adapt.kept_vertices = hands_.held();
    if (is_other || goes_elsewhere) drape_->run->wake(drape_->cloth);
}

void SessionRun::drape_frame() {
    meet_body();
    follow_hands();
    const DrapeResult before = drape_->run->result();
    const bool goes_on = drape_->run->advance(drape_->cloth, met_->collider);
    const DrapeResult& after = drape_->run->result();
    splits_ = static_cast<int>(after.splits - before.splits);
    rejoins_ = static_cast<int>(after.rejoins - before.rejoins);
    if (after.bad_vertex)
        return fail("a number went bad " + describe_place(drape_->cloth, drape_->pattern, *after.bad_vertex));
    if (!goes_on) stage_ = SessionStage::Settled;
}

void SessionRun::wake() {
    has_changed_ = true;
    if (!drape_ || stage_ == SessionStage::Failed) return;
    drape_->run->wake(drape_->cloth);
    stage_ = SessionStage::Draping;
}

// --- what is seen

bool SessionRun::take_change() {
    const bool had_changed = has_changed_;
    has_changed_ = false;
    return had_changed;
}

std::shared_ptr<SessionFrame> SessionRun::make_frame() {
    auto frame = std::make_shared<SessionFrame>();
    frame->stage = stage_;
    frame->is_running = is_running_;
    frame->problem = problem_;
    frame->messages = messages_;
    frame->statistics.simulated_seconds = past_seconds_;
    if (drape_) {
        show_cloth(*frame, drape_->cloth, names_of(pattern_));
        frame->pins = hands_.pin_positions(drape_->cloth);
        frame->statistics.simulated_seconds += drape_->run->result().simulated_seconds;
        frame->statistics.rms_speed = static_cast<double>(drape_->run->result().rms_speed);
        frame->statistics.splits = splits_;
        frame->statistics.rejoins = rejoins_;
    } else if (sewing_) {
        show_cloth(*frame, sewing_->cloth(), names_of(pattern_));
        show_threads(*frame, sewing_->unsewn().links, sewing_->cloth().x);
    } else {
        show_placed(*frame, placed_);
    }
    frame->statistics.times = times_.medians();
    return frame;
}

}  // namespace selvedge
