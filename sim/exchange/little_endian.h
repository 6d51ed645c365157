#pragma once
// Plain values as the bytes of little-endian binary files: PLY, STL.
#include <bit>
#include <cstddef>
#include <string>
#include <type_traits>

namespace selvedge::sim {

static_assert(std::endian::native == std::endian::little, "values are copied as they are in memory");

template <class T>
void append_values(std::string& bytes, const T* values, std::size_t count) {
    static_assert(std::is_arithmetic_v<T>);
    bytes.append(static_cast<const char*>(static_cast<const void*>(values)), count * sizeof(T));
}

template <class T>
void append_value(std::string& bytes, T value) {
    append_values(bytes, &value, 1);
}

}  // namespace selvedge::sim
