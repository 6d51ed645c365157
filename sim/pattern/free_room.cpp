#include "sim/pattern/free_room.h"

#include <algorithm>

namespace selvedge::sim {

TakenMoves moves_onto(const Extent& moved, const Extent& other, double gap) {
    return {.from = other.low - gap - moved.high, .to = other.high + gap - moved.low};
}

double nearest_free_move(std::vector<TakenMoves> taken, MoveWay way) {
    std::erase_if(taken, [](const TakenMoves& moves) { return !(moves.from < moves.to); });
    std::ranges::sort(taken, {}, &TakenMoves::from);
    for (std::size_t i = 0; i < taken.size();) {
        TakenMoves joined = taken[i];
        for (++i; i < taken.size() && taken[i].from < joined.to; ++i) joined.to = std::max(joined.to, taken[i].to);
        if (joined.from >= 0) break;
        if (joined.to > 0) return way == MoveWay::Forward || joined.to <= -joined.from ? joined.to : joined.from;
    }
    return 0;
}

}  // namespace selvedge::sim
