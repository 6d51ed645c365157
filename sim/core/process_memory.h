#pragma once
// Limits on the memory of this process.
#include <cstddef>
#include <optional>

namespace selvedge::sim {

// Limits the address space of this process to what is in use and that many bytes more: the limit is relative, because
// threads and drivers reserve much that they never use. Does nothing under AddressSanitizer, whose shadow memory
// reserves terabytes.
void limit_more_memory(std::size_t bytes);

// How much more address space this process may map. None: it has no limit.
std::optional<std::size_t> address_space_left();

}  // namespace selvedge::sim
