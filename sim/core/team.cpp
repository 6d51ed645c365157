#include "sim/core/team.h"

#include <immintrin.h>

#include <algorithm>
#include <limits>
#include <map>
#include <thread>
#include <vector>

#include "sim/core/assert.h"
#include "sim/core/parallel.h"

namespace selvedge {
namespace {

// Looks for a while, lets others run for a while, then sleeps until `value` is no longer `old`.
void wait_while(const std::atomic<std::uint32_t>& value, std::uint32_t old, int looks, int yields) {
    for (int i = 0; i < looks; ++i) {
        if (value.load(std::memory_order_acquire) != old) return;
        _mm_pause();
    }
    for (int i = 0; i < yields; ++i) {
        if (value.load(std::memory_order_acquire) != old) return;
        std::this_thread::yield();
    }
    while (value.load(std::memory_order_acquire) == old) value.wait(old, std::memory_order_acquire);
}

}  // namespace

void TeamMember::wait_for_others() {
    constexpr int kLooks = 4000, kYields = 1 << 20;  // others come within microseconds, or the machine is busy
    const std::uint32_t round = barrier_->round.load(std::memory_order_relaxed);
    if (barrier_->arrived.fetch_add(1, std::memory_order_acq_rel) + 1 == count_) {
        barrier_->arrived.store(0, std::memory_order_relaxed);
        barrier_->round.store(round + 1, std::memory_order_release);
        barrier_->round.notify_all();
    } else {
        wait_while(barrier_->round, round, kLooks, kYields);
    }
}

struct Team::Impl {
    std::vector<std::thread> threads;
    TeamMember::Barrier barrier;
    std::atomic<std::uint32_t> job{0};  // counted up for each; an odd step beyond the last: to end
    const std::function<void(TeamMember&)>* work = nullptr;
    bool is_over = false;

    void serve(TeamMember member) {
        constexpr int kLooks = 2000, kYields = 20;  // the next step comes soon, or not for long
        for (std::uint32_t seen = 0;; ++seen) {
            wait_while(job, seen, kLooks, kYields);
            if (is_over) return;
            (*work)(member);
            member.wait();
        }
    }

    void start_job() {
        job.fetch_add(1, std::memory_order_release);
        job.notify_all();
    }
};

Team::Team(int threads) : impl_(std::make_unique<Impl>()) {
    SELVEDGE_ASSERT(threads >= 1);
    for (int i = 1; i < threads; ++i) {
        TeamMember member;
        member.index_ = static_cast<std::size_t>(i);
        member.count_ = static_cast<std::size_t>(threads);
        member.barrier_ = &impl_->barrier;
        impl_->threads.emplace_back([this, member] { impl_->serve(member); });
    }
}

Team::~Team() {
    impl_->is_over = true;
    impl_->start_job();
    for (std::thread& thread : impl_->threads) thread.join();
}

void Team::run(const std::function<void(TeamMember&)>& work) {
    TeamMember caller;
    caller.count_ = impl_->threads.size() + 1;
    caller.barrier_ = &impl_->barrier;
    impl_->work = &work;
    if (caller.count_ > 1) impl_->start_job();
    work(caller);
    caller.wait();
}

void run_on_team(int most, const std::function<void(TeamMember&)>& work) {
    static std::atomic<bool> is_busy = false;
    static std::map<int, std::unique_ptr<Team>> teams;  // by size; they sleep while they have nothing to do
    const int size = std::min({most, allowed_threads(), available_threads()});
    TeamMember alone;
    if (size <= 1 || is_busy.exchange(true, std::memory_order_acquire)) return work(alone);
    std::unique_ptr<Team>& team = teams[size];
    if (!team) team = std::make_unique<Team>(size);
    team->run(work);
    is_busy.store(false, std::memory_order_release);
}

bool TeamTrial::is_better() const {
    const int at = count_ % kPeriod;
    return at < kTried || (at >= 2 * kTried && together_ < alone_);
}

// The least of some counts: what disturbs a step only makes it longer.
void TeamTrial::note(double seconds) {
    const int at = count_++ % kPeriod;
    if (at == 0) together_ = alone_ = std::numeric_limits<double>::max();
    if (at < kTried) together_ = std::min(together_, seconds);
    if (at >= kTried && at < 2 * kTried) alone_ = std::min(alone_, seconds);
}

}  // namespace selvedge
