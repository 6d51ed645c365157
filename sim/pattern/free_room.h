#pragma once
// Where along a line something can be put without touching what is there, as panels beside each other.
#include <vector>

namespace selvedge::sim {

// Moves along the line, m, that are taken: those between `from` and `to`, without both ends. Empty unless from < to.
struct TakenMoves {
    double from = 0;
    double to = 0;
};

// An interval of the line, m.
struct Extent {
    double low = 0;
    double high = 0;
};

// The moves after which `moved` would come closer to `other` than `gap`, m.
TakenMoves moves_onto(const Extent& moved, const Extent& other, double gap);

enum class MoveWay { Either, Forward };

// The free move nearest to 0, m; Forward: none below 0. Of two that are equally near the positive one.
double nearest_free_move(std::vector<TakenMoves> taken, MoveWay way);

}  // namespace selvedge::sim
