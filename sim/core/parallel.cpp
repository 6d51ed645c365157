#include "sim/core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include "sim/core/assert.h"

namespace selvedge {

// Built in its place and never moved: a control that is copied from takes its limit with it when it goes.
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

void parallel_for(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
    SELVEDGE_ASSERT(grain > 0);
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, grain),
        [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); },
        tbb::simple_partitioner());
}

}  // namespace selvedge
