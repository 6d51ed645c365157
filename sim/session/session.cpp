#include "sim/session/session.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>

#include "sim/core/assert.h"
#include "sim/core/stopwatch.h"
#include "sim/session/session_state.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kFramesKept = 32;  // about 1 s of frames that a click may still refer to

// Whether the newer request makes the older one, posted just before it, obsolete.
bool supersedes(const Request& newer, const Request& older) {
    if (newer.index() != older.index()) return false;
    return std::holds_alternative<request::SetPattern>(newer) || std::holds_alternative<request::SetOptions>(newer) ||
           std::holds_alternative<request::SetBody>(newer) || std::holds_alternative<request::PullTo>(newer) ||
           std::holds_alternative<request::LookFrom>(newer) || std::holds_alternative<request::GoTo>(newer) ||
           std::holds_alternative<request::Follow>(newer) || std::holds_alternative<request::SetPlayback>(newer) ||
           std::holds_alternative<request::Seek>(newer);
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
    if (state_.may_inspect()) state_.inspect();
    publish();
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
            if (state_.may_inspect()) {
                state_.inspect();
                continue;
            }
            wait(std::nullopt);
            next = Clock::now();
            continue;
        }
        if (state_.keeps_real_time() && Clock::now() < next) {
            wait(next);
            if (Clock::now() < next) continue;  // a request arrived
        }
        state_.advance();
        if (state_.may_inspect()) state_.inspect();
        publish();
        const auto frame =
            std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(state_.frame_seconds()));
        next = std::max(next + frame, Clock::now() - frame);  // lags by at most one frame: lost time is not caught up
    }
}

Session::Session(SessionDrive drive) : worker_(std::make_unique<Worker>(drive)) {}
Session::~Session() = default;

void Session::set_body(std::shared_ptr<const PreparedBody> body) {
    worker_->put(request::SetBody{std::move(body)});
}

void Session::set_body(std::shared_ptr<const Body> body) {
    set_body(body ? std::make_shared<const PreparedBody>(MadeBody{.body = std::move(body)}) : nullptr);
}

void Session::set_pattern(const Pattern& pattern) {
    worker_->put(request::SetPattern{pattern});
}

void Session::reread_fabrics() {
    worker_->put(request::RereadFabrics{});
}

void Session::set_options(const SessionOptions& options) {
    worker_->put(request::SetOptions{options});
}

void Session::look_from(const ViewPoint& viewer) {
    worker_->put(request::LookFrom{viewer});
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

void Session::go_to(std::shared_ptr<const Body> body, const Pose& pose) {
    worker_->put(request::GoTo{std::move(body), pose});
}

void Session::follow(std::shared_ptr<const Body> body, const Pose& pose) {
    worker_->put(request::Follow{std::move(body), pose});
}

void Session::set_clip(std::shared_ptr<const Body> body, std::shared_ptr<const Clip> clip) {
    worker_->put(request::SetClip{std::move(body), std::move(clip)});
}

void Session::set_playback(const Playback& playback) {
    worker_->put(request::SetPlayback{playback});
}

void Session::play() {
    worker_->put(request::Play{});
}

void Session::pause_motion() {
    worker_->put(request::PauseMotion{});
}

void Session::seek(double seconds) {
    worker_->put(request::Seek{seconds});
}

void Session::back_to_start() {
    worker_->put(request::BackToStart{});
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
