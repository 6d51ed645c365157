#include "sim/dress/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>

#include "sim/core/assert.h"
#include "sim/core/error.h"
#include "sim/core/math.h"
#include "sim/dress/carry_over.h"
#include "sim/dress/report.h"
#include "sim/dress/session_frame.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kTimedFrames = 30;
constexpr std::size_t kMaxMessages = 50;
constexpr std::size_t kFramesKept = 32;  // about 1 s of frames that a click may still refer to
constexpr int kDeepestSessionLevel = 8;  // a base edge of 5 cm is 0.2 mm long at this level

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

// Timings of the last frames.
class FrameTimes {
 public:
    void note(const SessionTimes& frame);
    SessionTimes medians() const;

 private:
    std::vector<SessionTimes> last_;  // ring buffer
    std::size_t next_ = 0;
};

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
    return {median(&SessionTimes::adaptation), median(&SessionTimes::steps), median(&SessionTimes::frame)};
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

// What the session is asked for; each is carried out on its thread.
namespace request {
struct SetBody {
    std::shared_ptr<const Body> body;
};
struct SetPattern {
    Pattern pattern;
};
struct SetOptions {
    SessionOptions options;
};
struct Start {};
struct Pause {};
struct Reset {};
struct Pull {
    MaterialPoint at;
    Vec3f to;
};
struct PullTo {
    Vec3f to;
};
struct LetGo {};
struct Pin {
    MaterialPoint at;
};
struct UnpinAll {};
struct SaveDrape {
    std::string name;
};
struct RestoreDrape {
    std::string name;
};
struct Message {
    std::string message;
};
}  // namespace request

using Request = std::variant<request::SetBody, request::SetPattern, request::SetOptions, request::Start, request::Pause,
                             request::Reset, request::Pull, request::PullTo, request::LetGo, request::Pin,
                             request::UnpinAll, request::SaveDrape, request::RestoreDrape, request::Message>;

// Whether the newer request makes the older one, posted just before it, obsolete.
bool supersedes(const Request& newer, const Request& older) {
    if (newer.index() != older.index()) return false;
    return std::holds_alternative<request::SetPattern>(newer) || std::holds_alternative<request::SetOptions>(newer) ||
           std::holds_alternative<request::SetBody>(newer) || std::holds_alternative<request::PullTo>(newer);
}

// What a session does with requests and between frames, without its thread.
class SessionState {
 public:
    explicit SessionState(std::function<void()> interrupt) : dressing_(std::move(interrupt)) {
        dressing_.set_options(options_);
    }

    // Each carries out one request.
    void operator()(request::SetBody& request);
    void operator()(request::SetPattern& request);
    void operator()(const request::SetOptions& request);
    void operator()(request::Start);
    void operator()(request::Pause);
    void operator()(request::Reset);
    void operator()(const request::Pull& request);
    void operator()(const request::PullTo& request);
    void operator()(request::LetGo);
    void operator()(const request::Pin& request);
    void operator()(request::UnpinAll);
    void operator()(const request::SaveDrape& request);
    void operator()(const request::RestoreDrape& request);
    void operator()(request::Message& request) { say(std::move(request.message)); }

    // Stops with the stage Failed and this error message, until something changes.
    void fail(const std::string& problem);

    // Whether a frame can be simulated: running, and sewing or draping.
    bool moves() const;
    // Simulates one frame. Pre: moves().
    void advance();
    double frame_seconds() const;  // simulated time per frame, s

    // The slow preparation that sewing needs (the collider), to do while idle.
    bool may_prepare() const;
    void prepare() { dressing_.collider(); }

    // Whether anything visible has changed since the last call.
    bool take_change() { return std::exchange(has_changed_, false); }
    std::shared_ptr<SessionFrame> make_frame();

    bool keeps_real_time() const { return options_.keeps_real_time; }

 private:
    SessionStage stage() const;
    void sew();
    void sew_if_running();
    void say(std::string message);
    void report_sewing();
    void advance_dressing();

    Dressing dressing_;
    SessionOptions options_;
    bool is_running_ = false;
    bool has_failed_ = false;
    bool has_changed_ = true;
    std::string problem_;
    std::vector<std::string> messages_;
    std::map<std::string, Dressing::Drape> saved_;
    FrameTimes times_;
    int splits_ = 0, rejoins_ = 0;                // in the last frame
    std::shared_ptr<const Cloth> cloth_at_rest_;  // a copy, made for the first frame at rest
};

SessionStage SessionState::stage() const {
    if (has_failed_) return SessionStage::Failed;
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
    return SessionStage::Settled;
}

bool SessionState::moves() const {
    const SessionStage now = stage();
    return is_running_ && (now == SessionStage::Sewing || now == SessionStage::Draping);
}

double SessionState::frame_seconds() const {
    return kSewingSteps * StepOptions{}.substeps * static_cast<double>(ClothOptions{}.substep);
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

void SessionState::advance() {
    const auto start = Clock::now();
    cloth_at_rest_.reset();
    has_changed_ = true;
    SessionTimes times;
    if (dressing_.is_hanging()) {
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
    if (after.bad_vertex) {
        fail("a value is not finite " +
             describe_place(*dressing_.cloth(), dressing_.drape().pattern, *after.bad_vertex));
    }
}

void SessionState::report_sewing() {
    for (std::string& note : dressing_.take_notes()) say(std::move(note));
    const Pattern& pattern = dressing_.pattern();
    for (const OpenSeam& open : dressing_.open_seams()) {
        say("seam '" + seam_name(pattern, pattern.seams[static_cast<std::size_t>(open.seam)]) +
            "' did not close: it gapes by " + std::to_string(std::lround(1000 * open.gap)) + " mm");
    }
}

// Changes between frames.

void SessionState::operator()(request::SetBody& request) {
    if (request.body.get() == dressing_.body()) return;
    has_changed_ = true;
    try {
        dressing_.set_body(std::move(request.body));
    } catch (const InputError& error) {  // the body that the pattern names is none
        return fail(error.what());
    }
    cloth_at_rest_.reset();
    sew_if_running();
}

void SessionState::operator()(request::SetPattern& request) {
    if (request.pattern == dressing_.pattern() && problem_.empty()) return;
    has_changed_ = true;
    const bool is_seen = compare(dressing_.pattern(), request.pattern) != PatternChange::None;
    try {
        dressing_.set_pattern(std::move(request.pattern));
    } catch (const InputError& error) {
        problem_ = error.what();
        return;
    }
    if (is_seen) cloth_at_rest_.reset();
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
    if (is != was) cloth_at_rest_.reset();
    sew_if_running();
}

void SessionState::operator()(const request::Pull& request) {
    if (!has_failed_ && dressing_.pull(request.at, request.to)) has_changed_ = true;
}

void SessionState::operator()(const request::PullTo& request) {
    if (!has_failed_ && dressing_.pull_to(request.to)) has_changed_ = true;
}

void SessionState::operator()(request::LetGo) {
    if (dressing_.let_go()) has_changed_ = true;
}

void SessionState::operator()(const request::Pin& request) {
    if (!has_failed_ && dressing_.pin(request.at)) has_changed_ = true;
}

void SessionState::operator()(request::UnpinAll) {
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
    cloth_at_rest_.reset();
    has_failed_ = false;
    has_changed_ = true;
    problem_.clear();
}

// Frames.

std::shared_ptr<SessionFrame> SessionState::make_frame() {
    auto frame = std::make_shared<SessionFrame>();
    frame->stage = stage();
    frame->is_running = is_running_;
    frame->problem = problem_;
    frame->messages = messages_;
    SessionStatistics& statistics = frame->statistics;
    statistics.simulated_seconds = dressing_.simulated_seconds();
    if (const Cloth* cloth = dressing_.cloth()) {
        show_cloth(*frame, *cloth, names_of(dressing_.pattern()));
        add_seam_lines(*frame, dressing_.seam_links(), cloth->x);
        frame->pins = dressing_.pins();
    } else {
        show_placed(*frame, dressing_.placed());
    }
    if (dressing_.is_hanging()) {
        statistics.rms_speed = static_cast<double>(dressing_.result().rms_speed);
        statistics.splits = splits_;
        statistics.rejoins = rejoins_;
    }
    if (frame->stage == SessionStage::Settled) {
        if (!cloth_at_rest_) cloth_at_rest_ = std::make_shared<const Cloth>(*dressing_.cloth());
        frame->cloth = cloth_at_rest_;
        frame->collider = dressing_.shared_collider();
    }
    statistics.times = times_.medians();
    return frame;
}

}  // namespace

SessionOptions::SessionOptions() {
    deepest_level = kDeepestSessionLevel;
    max_seconds = std::numeric_limits<double>::infinity();
    may_rest = true;
}

class Session::Worker {
 public:
    explicit Worker(SessionDrive drive);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    void put(Request request);
    std::shared_ptr<const SessionFrame> frame() const;

    // The material point of a point on a recent frame; nullopt when that frame or triangle is not available.
    std::optional<MaterialPoint> find(const ClothPoint& point) const;

    // SessionDrive::Caller only.
    void advance(int frames);

 private:
    struct Ended : std::exception {};  // thrown by the interrupt of long operations when the session ends
    using Clock = std::chrono::steady_clock;

    void work();
    void work_until_ended();
    bool has_ended() const;
    std::vector<Request> take_requests();
    void apply(std::vector<Request> all);
    void publish();
    void wait(std::optional<Clock::time_point> until);

    mutable std::mutex mutex_;  // guards requests_, frames_ and has_ended_
    std::condition_variable wake_up_;
    std::vector<Request> requests_;
    std::deque<std::shared_ptr<const SessionFrame>> frames_;  // the most recent ones, newest last
    bool has_ended_ = false;

    std::uint64_t last_number_ = 0;
    SessionState state_;
    std::thread thread_;
};

Session::Worker::Worker(SessionDrive drive)
    : state_([this] {
          if (has_ended()) throw Ended();
      }) {
    publish();
    if (drive == SessionDrive::Thread) thread_ = std::thread([this] { work(); });
}

Session::Worker::~Worker() {
    {
        const std::scoped_lock lock(mutex_);
        has_ended_ = true;
    }
    wake_up_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void Session::Worker::put(Request request) {
    {
        const std::scoped_lock lock(mutex_);
        if (!requests_.empty() && supersedes(request, requests_.back())) {
            requests_.back() = std::move(request);
        } else {
            requests_.push_back(std::move(request));
        }
    }
    wake_up_.notify_all();
}

std::shared_ptr<const SessionFrame> Session::Worker::frame() const {
    const std::scoped_lock lock(mutex_);
    return frames_.back();
}

std::optional<MaterialPoint> Session::Worker::find(const ClothPoint& point) const {
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find(frames_, point.frame, [](const auto& frame) { return frame->number; });
    if (found == frames_.end()) return std::nullopt;
    const DrawMesh& mesh = (*found)->mesh;
    if (point.triangle >= mesh.triangles.size() || !point.weights.allFinite()) return std::nullopt;
    const std::array<Vec2f, 3>& u = mesh.u[point.triangle];
    return MaterialPoint{mesh.panel[point.triangle],
                         point.weights[0] * u[0] + point.weights[1] * u[1] + point.weights[2] * u[2]};
}

bool Session::Worker::has_ended() const {
    const std::scoped_lock lock(mutex_);
    return has_ended_;
}

std::vector<Request> Session::Worker::take_requests() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(requests_, {});
}

void Session::Worker::apply(std::vector<Request> all) {
    for (Request& one : all) std::visit(state_, one);
}

void Session::Worker::publish() {
    if (!state_.take_change()) return;
    std::shared_ptr<SessionFrame> frame = state_.make_frame();
    frame->number = ++last_number_;
    std::shared_ptr<const SessionFrame> oldest;  // freed after the lock is released
    const std::scoped_lock lock(mutex_);
    frames_.push_back(std::move(frame));
    if (frames_.size() <= kFramesKept) return;
    oldest = std::move(frames_.front());
    frames_.pop_front();
}

void Session::Worker::advance(int frames) {
    SELVEDGE_ASSERT(!thread_.joinable());
    apply(take_requests());
    publish();
    for (int i = 0; i < frames && state_.moves(); ++i) {
        state_.advance();
        publish();
    }
}

// Waits until a request arrives, the session ends, or the given time.
void Session::Worker::wait(std::optional<Clock::time_point> until) {
    std::unique_lock lock(mutex_);
    const auto has_news = [&] { return has_ended_ || !requests_.empty(); };
    if (until) {
        wake_up_.wait_until(lock, *until, has_news);
    } else {
        wake_up_.wait(lock, has_news);
    }
}

void Session::Worker::work() {
    while (!has_ended()) {
        try {
            work_until_ended();
        } catch (const Ended&) {
            return;
        } catch (const std::exception& error) {  // for example out of memory
            state_.fail(error.what());
        }
    }
}

void Session::Worker::work_until_ended() {
    Clock::time_point next = Clock::now();  // when the next frame is due
    while (!has_ended()) {
        apply(take_requests());
        publish();
        if (!state_.moves()) {
            if (state_.may_prepare()) state_.prepare();
            wait(std::nullopt);
            next = Clock::now();
            continue;
        }
        if (state_.keeps_real_time() && Clock::now() < next) {
            wait(next);
            if (Clock::now() < next) continue;  // a request arrived
        }
        state_.advance();
        publish();
        const auto frame =
            std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(state_.frame_seconds()));
        next = std::max(next + frame, Clock::now() - frame);  // lags by at most one frame: lost time is not caught up
    }
}

Session::Session(SessionDrive drive) : worker_(std::make_unique<Worker>(drive)) {}
Session::~Session() = default;

void Session::set_body(std::shared_ptr<const Body> body) {
    worker_->put(request::SetBody{std::move(body)});
}

void Session::set_pattern(const Pattern& pattern) {
    worker_->put(request::SetPattern{pattern});
}

void Session::set_options(const SessionOptions& options) {
    worker_->put(request::SetOptions{options});
}

void Session::start() {
    worker_->put(request::Start{});
}

void Session::pause() {
    worker_->put(request::Pause{});
}

void Session::reset() {
    worker_->put(request::Reset{});
}

void Session::pull(const ClothPoint& point, const Vec3f& to) {
    if (const auto at = worker_->find(point)) {
        worker_->put(request::Pull{*at, to});
    } else {
        worker_->put(request::Message{"what was taken hold of is no longer there"});
    }
}

void Session::pull_to(const Vec3f& to) {
    worker_->put(request::PullTo{to});
}

void Session::let_go() {
    worker_->put(request::LetGo{});
}

void Session::pin(const ClothPoint& point) {
    if (const auto at = worker_->find(point)) {
        worker_->put(request::Pin{*at});
    } else {
        worker_->put(request::Message{"what was to be pinned is no longer there"});
    }
}

void Session::unpin_all() {
    worker_->put(request::UnpinAll{});
}

std::shared_ptr<const SessionFrame> Session::frame() const {
    return worker_->frame();
}

void Session::save_drape(const std::string& name) {
    worker_->put(request::SaveDrape{name});
}

void Session::restore_drape(const std::string& name) {
    worker_->put(request::RestoreDrape{name});
}

void Session::advance(int frames) {
    SELVEDGE_ASSERT(frames >= 0);
    worker_->advance(frames);
}

}  // namespace selvedge::sim
