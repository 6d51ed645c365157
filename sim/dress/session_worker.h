#pragma once
// The session's thread and its two doors: what was asked for goes in, frames come out. Nobody waits at either.
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

// What can be asked for.
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

    // The place in the material of a point of one of the last frames; none if it is of none of them.
    std::optional<MaterialPoint> find(const ClothPoint& point) const;

    // Drive Caller only.
    void advance(int frames);

 private:
    struct Ended : std::exception {};  // thrown out of what takes long, when the session is to end
    using Clock = std::chrono::steady_clock;

    void work();
    void work_until_ended();
    bool has_ended() const;
    std::vector<Ask> take_asked();
    void apply(std::vector<Ask> all);
    void publish();
    void wait(std::optional<Clock::time_point> until);

    mutable std::mutex mutex_;  // of the doors: the next five
    std::condition_variable news_;
    std::vector<Ask> asked_;
    std::deque<std::shared_ptr<const SessionFrame>> frames_;  // the last ones, newest last
    bool has_ended_ = false;

    std::uint64_t last_number_ = 0;
    SessionRun run_;
    std::thread thread_;
};

}  // namespace selvedge::sim
