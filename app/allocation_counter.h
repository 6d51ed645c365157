#pragma once
// How often this program asked for memory: its operator new counts.
#include <cstddef>

namespace selvedge::app {

std::size_t allocations_of_this_thread();

}  // namespace selvedge::app
