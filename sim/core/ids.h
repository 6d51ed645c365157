#pragma once
// Typed 32-bit indices: a VertexId cannot be taken for an EdgeId. Ids index flat arrays; they are never pointers.
#include <compare>
#include <cstdint>
#include <functional>
#include <limits>

namespace selvedge {

template <class Tag>
struct Id {
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t value = kNone;

    constexpr Id() = default;
    constexpr explicit Id(std::uint32_t index) : value(index) {}
    constexpr explicit operator bool() const { return value != kNone; }
    constexpr auto operator<=>(const Id&) const = default;
};

using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using TriangleId = Id<struct TriangleTag>;

}  // namespace selvedge

template <class Tag>
struct std::hash<selvedge::Id<Tag>> {
    std::size_t operator()(selvedge::Id<Tag> id) const noexcept { return id.value; }
};
