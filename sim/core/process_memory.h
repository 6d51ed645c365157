#pragma once
// Limits on the memory of a child process.
#include <cstddef>

namespace selvedge::sim {

// Limits the address space of this process to what is in use and that many bytes more: the limit is relative, because
// threads and drivers reserve much that they never use. Does nothing under AddressSanitizer, whose shadow memory
// reserves terabytes.
void limit_more_memory(std::size_t bytes);

}  // namespace selvedge::sim
