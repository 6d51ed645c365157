#include "sim/core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include "sim/core/assert.h"

#if defined(SELVEDGE_THREAD_SANITIZER)
#include <sanitizer/tsan_interface.h>
#endif

namespace selvedge::sim {
namespace {

// Annotates the ordering of a parallel loop for the thread sanitizer, which cannot see into oneTBB: writes before the
// loop happen before every range, and writes in a range happen before the end of the loop. Ranges are unordered among
// each other.
struct LoopOrder {
    char begun = 0, ended = 0;

#if defined(SELVEDGE_THREAD_SANITIZER)
    void begin() {
        __tsan_release(&begun);
    }
    void begin_range() {
        __tsan_acquire(&begun);
    }
    void end_range() {
        __tsan_release(&ended);
    }
    void end() {
        __tsan_acquire(&ended);
    }
#else
    void begin() {}
    void begin_range() {}
    void end_range() {}
    void end() {}
#endif
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

void parallel_for(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
    SELVEDGE_ASSERT(grain > 0);
    LoopOrder order;
    order.begin();
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, grain),
        [&](const tbb::blocked_range<std::size_t>& range) {
            order.begin_range();
            body(range.begin(), range.end());
            order.end_range();
        },
        tbb::simple_partitioner());
    order.end();
}

}  // namespace selvedge::sim
