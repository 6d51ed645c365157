#pragma once
// Where two polylines that follow each other round a corner cross.
#include <optional>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

struct PolylineCrossing {
    std::size_t before = 0;  // segment of the first line
    std::size_t after = 0;   // segment of the second line
    Vec2d place = Vec2d::Zero();
};

// Where the end of one line meets the beginning of the next: the meeting nearest to the corner between them.
std::optional<PolylineCrossing> find_crossing(const std::vector<Vec2d>& a, const std::vector<Vec2d>& b);

// The parts up to a crossing and from it on, with it.
std::vector<Vec2d> part_before(const std::vector<Vec2d>& a, const PolylineCrossing& at);
std::vector<Vec2d> part_after(const std::vector<Vec2d>& b, const PolylineCrossing& at);

}  // namespace selvedge::sim
