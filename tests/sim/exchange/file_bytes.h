#pragma once
// Reads numbers back from the bytes of files.
#include <cstddef>
#include <cstring>
#include <string>

namespace selvedge::sim {

inline constexpr std::size_t kLimit = 1 << 24;  // bytes of a file

template <class T>
T value_at(const std::string& bytes, std::size_t offset) {
    T value{};
    std::memcpy(&value, bytes.substr(offset, sizeof value).data(), sizeof value);
    return value;
}

}  // namespace selvedge::sim
