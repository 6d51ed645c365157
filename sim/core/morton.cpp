#include "sim/core/morton.h"

#include <array>
#include <cstddef>

#include "sim/core/assert.h"

namespace selvedge::sim {

// By the digits of the code from the lowest to the highest, without those that all have in common.
void sort_by_code(std::vector<CodedPoint>& points) {
    constexpr unsigned kBits = 11, kSteps = 5;
    constexpr std::size_t kValues = std::size_t{1} << kBits, kFew = 256;  // for so many, counting values takes longer
    if (points.size() < kFew) {
        std::ranges::stable_sort(points, {}, &CodedPoint::code);
        return;
    }
    std::uint64_t varying = 0;
    for (const CodedPoint& point : points) varying |= point.code ^ points[0].code;
    SELVEDGE_ASSERT(varying >> (kBits * kSteps) == 0);
    std::vector<CodedPoint> sorted(points.size());
    for (unsigned digit = 0; digit < kSteps; ++digit) {
        const auto value_of = [&](std::uint64_t code) { return (code >> (digit * kBits)) & (kValues - 1); };
        if (value_of(varying) == 0) continue;
        std::array<std::uint32_t, kValues> next{};  // first the number of points by value, then where the next one goes
        for (const CodedPoint& point : points) ++next[value_of(point.code)];
        std::uint32_t before = 0;
        for (std::uint32_t& at : next) {
            const std::uint32_t count = at;
            at = before;
            before += count;
        }
        for (const CodedPoint& point : points) sorted[next[value_of(point.code)]++] = point;
        points.swap(sorted);
    }
}

}  // namespace selvedge::sim
