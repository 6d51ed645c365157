#pragma once
// A session's worker thread, with a queue of requests as input and a queue of published frames as output. Locks are
// short: no caller waits for the simulation.
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <variant>
#include <vector>

#include "sim/dress/session.h"
#include "sim/dress/session_run.h"

namespace selvedge::sim {

// Requests.
namespace ask {
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
struct Keep {
    std::string name;
};
struct Restore {
    std::string name;
};
struct Say {
    std::string message;
};
}  // namespace ask

using Ask = std::variant<ask::SetBody, ask::SetPattern, ask::SetOptions, ask::Start, ask::Pause, ask::Reset, ask::Pull,
                         ask::PullTo, ask::LetGo, ask::Pin, ask::UnpinAll, ask::Keep, ask::Restore, ask::Say>;

class Session::Worker {
 public:
    explicit Worker(SessionDrive drive);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    void put(Ask asked);
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
    std::vector<Ask> take_requests();
    void apply(std::vector<Ask> all);
    void publish();
    void wait(std::optional<Clock::time_point> until);

    mutable std::mutex mutex_;  // guards requests_, frames_ and has_ended_
    std::condition_variable wake_up_;
    std::vector<Ask> requests_;
    std::deque<std::shared_ptr<const SessionFrame>> frames_;  // the most recent ones, newest last
    bool has_ended_ = false;

    std::uint64_t last_number_ = 0;
    SessionRun run_;
    std::thread thread_;
};

}  // namespace selvedge::sim
