#pragma once
// Counts calls of this program's operator new, per CPU thread.
#include <cstddef>

namespace selvedge::bench {

std::size_t allocations_of_this_thread();

}  // namespace selvedge::bench
