#pragma once
// How often this program asked for memory: its operator new counts.
#include <cstddef>

namespace selvedge {

std::size_t allocations_of_this_thread();

}  // namespace selvedge
