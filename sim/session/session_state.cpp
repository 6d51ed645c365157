#include "sim/session/session_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/math.h"
#include "sim/core/stopwatch.h"
#include "sim/dress/carry_over.h"
#include "sim/inspection/inspection.h"
#include "sim/inspection/wearing.h"
#include "sim/place/fit_table.h"
#include "sim/session/animation.h"
#include "sim/session/dressed_faults.h"
#include "sim/session/session_frame.h"

namespace selvedge::sim {
namespace {

// s, by which a garment that fits has come to rest, as in dress(). One that was too small when it was sewn stays so.
constexpr double kOverdue = 12, kOverdueIfTooSmall = 3;
constexpr double kHangs = 3;  // s after its seams were closed: a garment that never rests may move with its body
constexpr std::size_t kTimedFrames = 30;
constexpr std::size_t kMaxMessages = 50;

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

template <class Number>
Number clamped(Number value, Number low, Number high, Number otherwise) {
    return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
}

// Clamps options to their valid ranges.
SessionOptions within_limits(SessionOptions options) {
    static const SessionOptions usual;  // GCC 12 warns of uninitialised values in a local one
    if (options.edge_length) options.edge_length = clamped(*options.edge_length, 0.005, 0.5, MeshOptions{}.target_edge);
    options.max_level = std::clamp(options.max_level, 0, kDeepestSessionLevel);
    options.shortest_edge = clamped(options.shortest_edge, 0.002, 1.0, usual.shortest_edge);
    CurvatureOptions& curvature = options.curvature;
    curvature.split_angle = clamped(curvature.split_angle, 0.01F, 3.0F, usual.curvature.split_angle);
    curvature.rejoin_angle =
        clamped(curvature.rejoin_angle, 0.0F, 0.95F * curvature.split_angle, 0.3F * curvature.split_angle);
    if (options.triangle_budget) options.triangle_budget = std::max(1, *options.triangle_budget);
    return options;
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
        for (const SessionTimes& one : last_) {
            if (one.*part > 0) values.push_back(one.*part);  // calm cloth is not adapted in every frame
        }
        return quantile(values, 0.5);
    };
    return {median(&SessionTimes::adaptation), median(&SessionTimes::steps), median(&SessionTimes::frame)};
}

SessionStage SessionState::stage() const {
    if (has_failed_) return SessionStage::Failed;
    if (motion_) return motion_->is_at_rest() && !wants_motion() ? SessionStage::Settled : SessionStage::Moving;
    switch (dressing_.stage()) {
        case DressingStage::Place:
            return dressing_.placed().triangles.empty() ? SessionStage::Empty : SessionStage::Placed;
        case DressingStage::Sew:
            return SessionStage::Sewing;
        case DressingStage::Relax:
        case DressingStage::Fall:
            return SessionStage::Draping;
        case DressingStage::Done:
            break;
    }
    return wants_motion() ? SessionStage::Moving : SessionStage::Settled;
}

bool SessionState::moves() const {
    const SessionStage now = stage();
    return is_running_ && (now == SessionStage::Sewing || now == SessionStage::Draping || now == SessionStage::Moving);
}

double SessionState::frame_seconds() const {
    return kSewingSteps * Schedule{}.substeps * static_cast<double>(ClothOptions{}.substep);
}

bool SessionState::may_prepare() const {
    return dressing_.body() != nullptr && !dressing_.shared_collider() && stage() == SessionStage::Placed;
}

void SessionState::say(std::string message) {
    if (messages_.size() == kMaxMessages) messages_.erase(messages_.begin());
    messages_.push_back(std::move(message));
    has_changed_ = true;
}

void SessionState::fail(const std::string& problem) {
    has_failed_ = has_changed_ = true;
    is_running_ = false;
    problem_ = problem;
}

// Simulation.

void SessionState::operator()(request::Start) {
    is_running_ = has_changed_ = true;
    if (has_failed_ && motion_) return (*this)(request::BackToStart{});
    if (has_failed_ || stage() == SessionStage::Placed) sew();
}

void SessionState::operator()(request::Pause) {
    is_running_ = false;
    has_changed_ = true;
}

void SessionState::operator()(request::Reset) {
    is_running_ = has_failed_ = false;
    has_changed_ = true;
    problem_.clear();
    motion_.reset();
    if (mover_) mover_->back_to_start();
    if (start_pose_) mover_->go_to(*body_->own_pose());
    forget_rest();
    dressing_.reset();
}

void SessionState::sew() {
    has_failed_ = false;
    problem_.clear();
    try {
        dressing_.sew();
        for (std::string& note : dressing_.take_notes()) say(std::move(note));
    } catch (const InputError& error) {
        fail(error.what());
    }
}

void SessionState::sew_if_running() {
    for (std::string& note : dressing_.take_notes()) say(std::move(note));
    if (is_running_ && stage() == SessionStage::Placed) sew();
}

// The dressing will hang otherwise.
void SessionState::forget_rest() {
    cloth_at_rest_.reset();
    report_.reset();
}

// Whether a garment that still moves is looked at all the same.
bool SessionState::is_overdue() const {
    const double most = too_small_when_sewn_ ? kOverdueIfTooSmall : kOverdue;
    return dressing_.is_hanging() && dressing_.result().simulated_seconds >= most;
}

bool SessionState::may_inspect() const {
    if (!options_.reports_faults || has_failed_ || motion_ || dressing_.is_pulled() || dressing_.body() == nullptr)
        return false;
    const bool is_done = dressing_.stage() == DressingStage::Done;
    return report_ ? is_done && !report_->settled : is_done || is_overdue();
}

// As dress() does it. What was too small when it was sewn may have crumpled since, so that the cloth does not show it.
void SessionState::inspect() {
    const Cloth& cloth = *dressing_.cloth();
    DressReport report;
    report.options = options_;
    DrapeResult result = dressing_.result();
    result.settled = report.settled = dressing_.stage() == DressingStage::Done;
    if (!result.settled) result.fall_speed = result.rms_speed;
    std::optional<TightLevel> too_small;
    if (too_small_when_sewn_ && (is_too_small(cloth, *dressing_.body()) || is_overstretched(cloth)))
        too_small = too_small_when_sewn_;
    try {
        report_faults(cloth, dressing_, dressing_.collider(), result, too_small, report);
        const WearingCheck wearing(
            dressing_.sewn_mesh(),
            {.unsewn = dressing_.designed(), .pattern = &dressing_.pattern(), .body = &dressing_.designed_for()},
            dressing_.measured());
        wearing.validate(cloth, report);
        report.fit = measure_fit(draw_mesh(cloth, names_of(dressing_.pattern())), dressing_.measured());
    } catch (const InputError& error) {  // the body that the pattern names cannot be made
        report.notes.push_back(std::string("how it is worn was not checked: ") + error.what());
    }
    report_ = std::make_shared<const DressReport>(std::move(report));
    has_changed_ = true;
}

void SessionState::advance() {
    const auto start = Clock::now();
    cloth_at_rest_.reset();
    has_changed_ = true;
    adapted_to_ = viewer_;
    SessionTimes times;
    if (!motion_ && wants_motion() && hangs()) begin_motion();
    if (motion_) {
        advance_motion();
        times.steps = ms_since(start);
    } else if (dressing_.is_hanging()) {
        advance_dressing();
        times.adaptation = sum_of(dressing_.result().adaptation_ms);
        times.steps = sum_of(dressing_.result().step_ms);
        dressing_.clear_times();
    } else {
        advance_dressing();
        times.steps = ms_since(start);
    }
    times.frame = ms_since(start);
    times_.note(times);
}

void SessionState::advance_dressing() {
    cloth_at_rest_.reset();
    if (report_ && (report_->settled || !is_overdue())) report_.reset();
    const bool was_sewing = !dressing_.is_hanging();
    const DrapeResult before = was_sewing ? DrapeResult() : dressing_.result();
    try {
        dressing_.advance();
    } catch (const InputError& error) {  // invalid seams
        return fail(error.what());
    }
    if (!dressing_.is_hanging()) return;
    const DrapeResult& after = dressing_.result();
    splits_ = static_cast<int>(after.splits - before.splits);
    rejoins_ = static_cast<int>(after.rejoins - before.rejoins);
    if (was_sewing && after.bad_vertex) {
        dressing_.reset();
        return fail("a value is not finite while it was sewn: do its panels stand where they can be sewn?");
    }
    if (was_sewing) report_sewing();
    if (was_sewing && options_.reports_faults && !after.bad_vertex)
        too_small_when_sewn_ = fits_nowhere(*dressing_.cloth(), *dressing_.body());
    if (after.bad_vertex) {
        fail("a value is not finite " +
             describe_place(*dressing_.cloth(), dressing_.drape().pattern, *after.bad_vertex));
    }
}

void SessionState::report_sewing() {
    for (std::string& note : dressing_.take_notes()) say(std::move(note));
    if (start_pose_) say("dressed with lowered arms, which then move into the pose of the body");
    const Pattern& pattern = dressing_.pattern();
    for (const OpenSeam& open : dressing_.open_seams()) {
        say("seam '" + seam_name(pattern, pattern.seams[static_cast<std::size_t>(open.seam)]) +
            "' did not close: it gapes by " + std::to_string(std::lround(1000 * open.gap)) + " mm");
    }
}

// Motion of the body.

// Whether the garment can be carried along: it is at rest on the body, or has hung for a while.
bool SessionState::hangs() const {
    if (!dressing_.is_hanging() || dressing_.is_pulled()) return false;
    return dressing_.stage() == DressingStage::Done || dressing_.result().simulated_seconds >= kHangs;
}

void SessionState::begin_motion() {
    std::vector<VertexId> pinned = dressing_.pinned_vertices();
    motion_ = std::make_unique<LiveMotion>(dressing_.drape().simulation, std::move(pinned), *mover_, options_);
    if (visibility_) motion_->set_visibility(&*visibility_);
}

void SessionState::advance_motion() {
    const MotionFrame frame = motion_->advance(*mover_);
    splits_ = frame.adapted.splits;
    rejoins_ = frame.adapted.rejoins;
    if (frame.has_bad_number) fail("a value is not finite while the body moved: go back to the start");
}

// The garment is again as it was dressed, on the body at rest.
void SessionState::leave_motion() {
    if (mover_) mover_->stand_at_start();
    if (!motion_) return;
    motion_.reset();
    cloth_at_rest_.reset();
    has_changed_ = true;
}

// Pins and drags hold the garment that was dressed, not the one that moves.
bool SessionState::may_touch() {
    if (motion_) say("the cloth can be pulled and pinned where it was dressed: put the body back to the start");
    return !motion_ && !has_failed_;
}

void SessionState::operator()(const request::GoTo& request) {
    if (!mover_ || mover_->shared_body() != request.body) return;
    mover_->go_to(request.pose);
    has_changed_ = true;
}

void SessionState::operator()(const request::Follow& request) {
    if (!mover_ || mover_->shared_body() != request.body) return;
    mover_->follow(request.pose);
    has_changed_ = true;
}

void SessionState::operator()(request::SetClip& request) {
    if (!mover_ || mover_->shared_body() != request.body) return;
    mover_->set_clip(std::move(request.clip));
    has_changed_ = true;
}

void SessionState::operator()(const request::SetPlayback& request) {
    if (mover_) mover_->set_playback(request.playback);
}

void SessionState::operator()(request::Play) {
    if (!mover_ || has_failed_) return;
    mover_->play();
    has_changed_ = true;
}

void SessionState::operator()(request::PauseMotion) {
    if (!mover_) return;
    mover_->pause();
    has_changed_ = true;
}

void SessionState::operator()(const request::Seek& request) {
    if (!mover_ || has_failed_) return;
    mover_->seek(request.seconds);
    has_changed_ = true;
}

void SessionState::operator()(request::BackToStart) {
    if (!mover_) return;
    if (has_failed_ && motion_) {
        has_failed_ = false;
        problem_.clear();
    }
    leave_motion();
    mover_->back_to_start();
    has_changed_ = true;
}

// Changes between frames.

// A body that is dressed in another pose goes from there into its own.
void SessionState::begin_body() {
    const Playback playback = mover_ ? mover_->playback() : Playback();
    mover_.reset();
    start_pose_.reset();
    start_x_.reset();
    if (!body_ || !body_->dressing_pose()) return;
    mover_.emplace(body_->made().body, *body_->dressing_pose());
    mover_->set_playback(playback);
    if (!body_->stands_otherwise()) return;
    mover_->go_to(*body_->own_pose());
    auto x = std::make_shared<std::vector<Vec3f>>();
    for (const Vec3d& p : body_->stands()->x) x->push_back(p.cast<float>());
    start_x_ = std::move(x);
    start_pose_ = body_->dressing_pose();
}

void SessionState::operator()(request::SetBody& request) {
    const bool is_same = body_ && request.body && request.body->made().body == body_->made().body;
    if (is_same || request.body == body_) return;
    has_changed_ = true;
    motion_.reset();
    body_ = std::move(request.body);
    try {
        begin_body();
        dressing_.set_body(body_);
    } catch (const InputError& error) {  // the body that the pattern names is none
        return fail(error.what());
    }
    forget_rest();
    sew_if_running();
}

void SessionState::operator()(request::SetPattern& request) {
    if (request.pattern == dressing_.pattern() && problem_.empty()) return;
    const bool is_seen = compare(dressing_.pattern(), request.pattern) != PatternChange::None;
    if (take_pattern(std::move(request.pattern))) show_changed_cloth(is_seen);
}

void SessionState::operator()(request::RereadFabrics) {
    if (!problem_.empty()) return;
    const auto fabrics = [&] {
        return dressing_.cloth() ? dressing_.cloth()->material.fabrics : std::vector<Fabric>();
    };
    const std::vector<Fabric> before = fabrics();
    if (take_pattern(dressing_.pattern())) show_changed_cloth(fabrics() != before);
}

// False: it is refused, and problem_ says why.
bool SessionState::take_pattern(Pattern pattern) {
    has_changed_ = true;
    try {
        dressing_.set_pattern(std::move(pattern));
        return true;
    } catch (const InputError& error) {
        problem_ = error.what();
        return false;
    }
}

void SessionState::show_changed_cloth(bool is_seen) {
    if (is_seen) forget_rest();
    if (is_seen) leave_motion();
    has_failed_ = false;
    problem_.clear();
    sew_if_running();
}

void SessionState::operator()(const request::SetOptions& request) {
    const SessionOptions options = within_limits(request.options);
    if (options == options_) return;
    const SessionOptions last = std::exchange(options_, options);
    has_changed_ = true;
    try {
        dressing_.set_options(options_);
    } catch (const InputError& error) {  // it cannot be meshed like that: the other options still hold
        problem_ = error.what();
        options_.edge_length = last.edge_length;
        options_.mesh = last.mesh;
        dressing_.set_options(options_);
        return;
    }
    const DressOptions &was = last, &is = options_;
    if (is != was) forget_rest();
    if (is.edge_length != was.edge_length || is.mesh != was.mesh) leave_motion();
    if (motion_ && is != was) motion_->set_options(is);
    update_visibility();
    sew_if_running();
}

// Back faces.

void SessionState::update_visibility() {
    if (options_.coarsens_back_faces == visibility_.has_value()) return;
    Visibility* given = nullptr;
    if (options_.coarsens_back_faces) given = &visibility_.emplace(viewer_);
    dressing_.set_visibility(given);
    if (motion_) motion_->set_visibility(given);
    if (!given) visibility_.reset();
    cloth_at_rest_.reset();
}

// Whether the viewer has gone round the cloth so far that parts which are coarse may be seen.
bool SessionState::shows_another_side() const {
    const Cloth* cloth = motion_ ? &motion_->cloth() : dressing_.cloth();
    if (!cloth || cloth->mesh.leaf_vertices().empty()) return false;
    const Vec3f at = cloth->x[cloth->mesh.leaf_vertices().front().value].head<3>();
    const auto direction = [&](const ViewPoint& viewer) -> Vec3f {
        return viewer.is_orthographic ? viewer.eye : Vec3f(viewer.eye - at);
    };
    const float cosine = direction(viewer_).normalized().dot(direction(adapted_to_).normalized());
    return cosine < std::cos(BackFaceOptions{}.split_margin);
}

void SessionState::operator()(const request::LookFrom& request) {
    if (!request.viewer.eye.allFinite()) return;
    viewer_ = request.viewer;
    if (!visibility_) return;
    visibility_->move_to(viewer_);
    if (stage() != SessionStage::Settled || !shows_another_side()) return;
    adapted_to_ = viewer_;
    motion_ ? motion_->wake() : dressing_.wake();
    cloth_at_rest_.reset();
    has_changed_ = true;
}

void SessionState::operator()(const request::Pull& request) {
    if (may_touch() && dressing_.pull(request.at, request.to)) has_changed_ = true;
}

void SessionState::operator()(const request::PullTo& request) {
    if (!has_failed_ && !motion_ && dressing_.pull_to(request.to)) has_changed_ = true;
}

void SessionState::operator()(request::LetGo) {
    if (dressing_.let_go()) has_changed_ = true;
}

void SessionState::operator()(const request::Pin& request) {
    if (may_touch() && dressing_.pin(request.at)) has_changed_ = true;
}

void SessionState::operator()(request::UnpinAll) {
    leave_motion();
    if (dressing_.unpin_all()) has_changed_ = true;
}

void SessionState::operator()(const request::SaveDrape& request) {
    if (!dressing_.is_hanging() || has_failed_)
        return say("nothing hangs yet that could be kept as '" + request.name + "'");
    saved_.insert_or_assign(request.name, dressing_.drape());
    say("kept as '" + request.name + "'");
}

void SessionState::operator()(const request::RestoreDrape& request) {
    const auto found = saved_.find(request.name);
    if (found == saved_.end()) return say("no drape was kept as '" + request.name + "'");
    if (dressing_.body() == nullptr) return say("there is no body to put '" + request.name + "' on");
    if (!dressing_.restore(found->second))
        return say("'" + request.name + "' was kept of another cut: the pattern's pieces have changed since");
    leave_motion();
    forget_rest();
    has_failed_ = false;
    has_changed_ = true;
    problem_.clear();
}

// Frames.

void SessionState::show_drape(SessionFrame& frame) const {
    SessionStatistics& statistics = frame.statistics;
    const Cloth* cloth = motion_ ? &motion_->cloth() : dressing_.cloth();
    if (!cloth) return show_placed(frame, dressing_.placed());
    show_cloth(frame, *cloth, names_of(dressing_.pattern()));
    if (!motion_) add_seam_lines(frame, dressing_.seam_links(), cloth->x);
    frame.pins = motion_ ? motion_->pins() : dressing_.pins();
    if (!dressing_.is_hanging()) return;
    statistics.rms_speed = static_cast<double>(motion_ ? motion_->rms_speed() : dressing_.result().rms_speed);
    statistics.splits = splits_;
    statistics.rejoins = rejoins_;
}

void SessionState::show_motion(SessionFrame& frame) const {
    if (!mover_) return;
    SessionMotion& motion = frame.motion;
    motion.can_move = true;
    motion.is_waiting = !motion_ && wants_motion();
    motion.is_playing = mover_->is_playing();
    motion.is_blending = mover_->is_blending();
    motion.is_at_rest = mover_->is_at_start_pose();
    motion.is_in_motion = mover_->is_in_motion();
    motion.seconds = mover_->time();
    motion.length = mover_->clip() ? mover_->clip()->seconds : 0;
    motion.x = start_x_;
    motion.pose = start_pose_;
    if (!motion_) return;
    const std::span<const Vec3f> x = motion_->body_positions();
    motion.x = std::make_shared<const std::vector<Vec3f>>(x.begin(), x.end());
    motion.way = mover_->way().cast<float>();
    motion.faults = motion_->faults(names_of(dressing_.pattern()));
    motion.pose = std::make_shared<const Pose>(mover_->pose());
}

std::shared_ptr<SessionFrame> SessionState::make_frame() {
    auto frame = std::make_shared<SessionFrame>();
    frame->stage = stage();
    frame->is_running = is_running_;
    frame->problem = problem_;
    frame->messages = messages_;
    frame->statistics.simulated_seconds = dressing_.simulated_seconds() + (motion_ ? motion_->simulated_seconds() : 0);
    show_drape(*frame);
    show_motion(*frame);
    if (frame->stage == SessionStage::Settled) {
        if (!cloth_at_rest_) {
            cloth_at_rest_ = std::make_shared<const Cloth>(motion_ ? motion_->cloth() : *dressing_.cloth());
            collider_at_rest_.reset();
            if (motion_) collider_at_rest_ = std::make_shared<const MovingBodyCollider>(motion_->standing_body());
        }
        frame->cloth = cloth_at_rest_;
        frame->collider = motion_ ? collider_at_rest_ : dressing_.shared_collider();
    }
    frame->report = report_;
    frame->statistics.times = times_.medians();
    return frame;
}

}  // namespace selvedge::sim
