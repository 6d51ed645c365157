#include "sim/core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <new>

#include "sim/core/assert.h"

#if defined(SELVEDGE_THREAD_SANITIZER)
#include <sanitizer/tsan_interface.h>
#endif

namespace selvedge::sim {
namespace {

#if defined(SELVEDGE_THREAD_SANITIZER)
void acquire(char& at) {
    __tsan_acquire(&at);
}
void release(char& at) {
    __tsan_release(&at);
}
#else
void acquire(char&) {}
void release(char&) {}
#endif

// Annotates the ordering of a parallel loop for the thread sanitizer, which cannot see into oneTBB: writes before the
// loop happen before every range, and writes in a range happen before the end of the loop. Ranges are unordered among
// each other. The same holds if a range throws: oneTBB waits for those that have begun before it rethrows.
class LoopOrder {
 public:
    LoopOrder() { release(begun_); }
    ~LoopOrder() { acquire(ended_); }
    LoopOrder(const LoopOrder&) = delete;
    LoopOrder& operator=(const LoopOrder&) = delete;

    class Range {
     public:
        explicit Range(LoopOrder& loop) : loop_(loop) { acquire(loop_.begun_); }
        ~Range() { release(loop_.ended_); }
        Range(const Range&) = delete;
        Range& operator=(const Range&) = delete;

     private:
        LoopOrder& loop_;
    };

 private:
    char begun_ = 0, ended_ = 0;
};

}  // namespace

// The control is constructed in place and never copied: destroying a copied-from tbb::global_control removes its limit.
struct ThreadLimit::Impl {
    explicit Impl(int threads)
        : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {}

    tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads) {
    SELVEDGE_ASSERT(threads >= 1);
    impl_ = std::make_unique<Impl>(threads);
}

ThreadLimit::~ThreadLimit() = default;

int available_threads() {
    return tbb::info::default_concurrency();
}

int allowed_threads() {
    return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

void end_worker_threads() {
    tbb::task_scheduler_handle scheduler{tbb::attach{}};
    static_cast<void>(tbb::finalize(scheduler, std::nothrow));
}

void parallel_for(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
    SELVEDGE_ASSERT(grain > 0);
    LoopOrder order;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, grain),
        [&](const tbb::blocked_range<std::size_t>& range) {
            const LoopOrder::Range in_order(order);
            body(range.begin(), range.end());
        },
        tbb::simple_partitioner());
}

}  // namespace selvedge::sim
