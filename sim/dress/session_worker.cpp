#include "sim/dress/session_worker.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kFramesKept = 32;  // about 1 s of frames that a click may still refer to

// Whether the newer request makes the older one, posted just before it, obsolete.
bool supersedes(const Ask& newer, const Ask& older) {
    if (newer.index() != older.index()) return false;
    return std::holds_alternative<ask::SetPattern>(newer) || std::holds_alternative<ask::SetOptions>(newer) ||
           std::holds_alternative<ask::SetBody>(newer) || std::holds_alternative<ask::PullTo>(newer);
}

struct CarryOut {
    SessionRun& run;

    void operator()(ask::SetBody& asked) const { run.set_body(std::move(asked.body)); }
    void operator()(ask::SetPattern& asked) const { run.set_pattern(std::move(asked.pattern)); }
    void operator()(const ask::SetOptions& asked) const { run.set_options(asked.options); }
    void operator()(ask::Start) const { run.start(); }
    void operator()(ask::Pause) const { run.pause(); }
    void operator()(ask::Reset) const { run.reset(); }
    void operator()(const ask::Pull& asked) const { run.pull(asked.at, asked.to); }
    void operator()(const ask::PullTo& asked) const { run.pull_to(asked.to); }
    void operator()(ask::LetGo) const { run.let_go(); }
    void operator()(const ask::Pin& asked) const { run.pin(asked.at); }
    void operator()(ask::UnpinAll) const { run.unpin_all(); }
    void operator()(const ask::Keep& asked) const { run.keep(asked.name); }
    void operator()(const ask::Restore& asked) const { run.restore(asked.name); }
    void operator()(const ask::Say& asked) const { run.say(asked.message); }
};

}  // namespace

Session::Worker::Worker(SessionDrive drive)
    : run_([this] {
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

void Session::Worker::put(Ask asked) {
    {
        const std::scoped_lock lock(mutex_);
        if (!requests_.empty() && supersedes(asked, requests_.back())) {
            requests_.back() = std::move(asked);
        } else {
            requests_.push_back(std::move(asked));
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
    const PlainMesh& mesh = (*found)->mesh;
    if (point.triangle >= mesh.triangles.size() || !point.weights.allFinite()) return std::nullopt;
    const std::array<Vec2f, 3>& u = mesh.u[point.triangle];
    return MaterialPoint{mesh.panel[point.triangle],
                         point.weights[0] * u[0] + point.weights[1] * u[1] + point.weights[2] * u[2]};
}

bool Session::Worker::has_ended() const {
    const std::scoped_lock lock(mutex_);
    return has_ended_;
}

std::vector<Ask> Session::Worker::take_requests() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(requests_, {});
}

void Session::Worker::apply(std::vector<Ask> all) {
    for (Ask& one : all) std::visit(CarryOut{run_}, one);
}

void Session::Worker::publish() {
    if (!run_.take_change()) return;
    std::shared_ptr<SessionFrame> frame = run_.make_frame();
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
    for (int i = 0; i < frames && run_.moves(); ++i) {
        run_.advance();
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
            run_.fail(error.what());
        }
    }
}

void Session::Worker::work_until_ended() {
    Clock::time_point next = Clock::now();  // when the next frame is due
    while (!has_ended()) {
        apply(take_requests());
        publish();
        if (!run_.moves()) {
            if (run_.may_prepare()) run_.prepare();
            wait(std::nullopt);
            next = Clock::now();
            continue;
        }
        if (run_.options().keeps_real_time && Clock::now() < next) {
            wait(next);
            if (Clock::now() < next) continue;  // a request arrived
        }
        run_.advance();
        publish();
        const auto frame =
            std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(run_.frame_seconds()));
        next = std::max(next + frame, Clock::now() - frame);  // lags by at most one frame: lost time is not caught up
    }
}

}  // namespace selvedge::sim
