#pragma once
// Lays shapes on a strip of cloth or paper so that it is short: each goes to the lowest free place, then to the one
// farthest left, in several orders, of which the best is kept.  (bottom-left placement: Baker, Coffman and Rivest 1980;
// the free places are found on a raster)
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

struct NestItem {
    std::string name;                    // for messages
    std::vector<Vec2d> outline;          // closed, m
    std::vector<double> turns = {0};     // rad, that are allowed; the first wins a tie
    std::optional<Vec2d> repeat = {};    // m: the shift may only be phase + whole repeats, for a sett; with one turn
    Vec2d phase = Vec2d::Zero();         // m
    std::optional<double> axis_at = {};  // m: x of the shape's axis, which lies on the strip's left edge, x = 0
};

struct NestOptions {
    double width = 1.5;   // m, of the strip
    double gap = 0.005;   // m, between shapes
    double cell = 0.004;  // m, of the raster
    int orders = 12;      // that are tried

    // Rows of shapes that are compared before the search ends: about three seconds. A garment needs a tenth.
    std::uint64_t most_work = 150'000'000;
};

// A point p of the outline lies at R(turn) p + shift, with 0 <= x <= width and y >= 0.
struct NestPlace {
    double turn = 0;
    Vec2d shift = Vec2d::Zero();

    Vec2d at(const Vec2d& p) const { return Eigen::Rotation2Dd(turn) * p + shift; }
};

struct Nest {
    std::vector<NestPlace> places;  // as the items
    double length = 0;              // m, of strip that is used
    std::uint64_t work = 0;         // rows that were compared, in all orders
};

// The same for the same input. Throws InputError (place: the item's name) if an item is wider than the strip, and if
// there are too many to be laid out within `most_work`: some hundreds of different ones.
Nest nest(const std::vector<NestItem>& items, const NestOptions& options);

}  // namespace selvedge::sim
