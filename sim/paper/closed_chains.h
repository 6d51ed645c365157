#pragma once
// Outlines that are drawn in pieces: open lines that meet end to end, each in either direction, and the closed chains
// that they make. Readers of every format ask it.
#include <optional>
#include <string>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

struct ChainLink {
    std::size_t line = 0;
    bool is_reversed = false;  // it is run through from its last point to its first

    bool operator==(const ChainLink&) const = default;
};

// What the ends of lines that are meant to meet may lie apart, m: as wide as a pen draws.
inline constexpr double kJoinGap = 1e-3;

// The same in the unit of a file; where it names none, a fraction of the drawing's size, as small on any paper.
double join_gap(const std::optional<double>& metres_per_unit, double size);

// Links in order, each from where the one before ends; counter-clockwise.
using ClosedChain = std::vector<ChainLink>;

// What lines that branch mean. Outer: one piece, whose outline is the outer boundary of what hangs together; the
// others are lines in it. Faces: pieces side by side, which share a line where they touch.
enum class Branches { Outer, Faces };

struct ChainOptions {
    double gap = 0;  // what ends that meet may lie apart, in the unit of the points
    Branches branches = Branches::Outer;
    // Of the largest face's area: a smaller one is no piece, as that of a dart whose mouth is drawn. It goes to the
    // neighbour with the longest shared border.
    double least_share = 0.1;
};

struct ClosedChains {
    std::vector<ClosedChain> chains;    // the largest first; of several passes, those of the first pass first
    std::vector<std::size_t> repeated;  // lines that lie on an earlier one from end to end: taken once
    double widest_gap = 0;              // between ends that were taken for one
    int shared = 0;                     // lines that two chains have
};

// Of lines with two or more points. A line whose own ends meet is a chain of one. Faces are traced by the angles at
// which lines leave a point, as in a doubly connected edge list. (de Berg et al., "Computational Geometry", chapter 2)
// Lines that branch so much that they have more than 300 faces are a hatching: they make none.
ClosedChains find_closed_chains(const std::vector<std::vector<Vec2d>>& lines, const ChainOptions& options);

// Lines with what they have in common: keys[0] of the closest relatives, as lines of one group that are drawn alike.
struct KeyedLine {
    std::vector<Vec2d> points;
    std::vector<std::string> keys = {};
};

// First the chains of lines whose first keys are equal, then of those left over whose second keys are, and so on; at
// last of all that are left over. `branches` has what branching lines mean: per key, and for the last pass.
ClosedChains join_in_passes(const std::vector<KeyedLine>& lines, double gap, const std::vector<Branches>& branches);

// What is told of outlines that were joined, with the widest gap in the unit of the file.
std::string joined_note(std::size_t outlines, double widest_gap, const std::optional<double>& metres_per_unit);

// Lines cut where the end of another lies on them and where another crosses them, farther than the gap from their own
// ends. `origin` has, per line that it returns, the index of the line that it is a part of.
struct CutLines {
    std::vector<std::vector<Vec2d>> lines;
    std::vector<std::size_t> origin;
};
CutLines cut_where_they_meet(const std::vector<std::vector<Vec2d>>& lines, double gap);

}  // namespace selvedge::sim
