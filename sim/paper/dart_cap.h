#pragma once
// The cap of a cut line over the mouth of a dart: the dart is folded and pressed to one side, cut along the seam
// allowance of that side, and opened again. So its folded cloth ends with the allowance and is caught in the seam.
// (Aldrich 2015, "Metric Pattern Cutting for Women's Wear"; Armstrong 2014, "Patternmaking for Fashion Design")
//
//      tip          A, B: ends of the legs, at the sewing line
//      / \.         P, Q: where the legs, carried on, meet the cut line
//     /   \.        X: on the dart's fold, the line between both legs
//  --A     B--
//   _P_   _Q_       cut line, to the left the edge before the mouth
//      \X/          pressed to the left, P to X is that edge's cut line, reflected in the leg; X to Q, in the fold
#include <optional>
#include <vector>

#include "sim/pattern/dart.h"

namespace selvedge::sim {

struct DartMouth {
    Vec2d begin = Vec2d::Zero();           // m, the end of the first leg at the outline
    Vec2d end = Vec2d::Zero();             // m, that of the second
    Vec2d begin_outward = Vec2d::UnitY();  // unit, along the first leg, away from the tip
    Vec2d end_outward = Vec2d::UnitY();    // along the second
    DartSide pressed_to = DartSide::Before;
    double mitre = 0.025;  // m, how far the cut lines of both sides may be carried on to where they meet
};

// The cut lines of the edges beside the mouth, `before` up to the mouth and `after` from there on.
struct DartCap {
    std::vector<Vec2d> before;
    std::vector<Vec2d> cap;  // from the last point of `before` to the first of `after`, without both
    std::vector<Vec2d> after;
    Vec2d fold = Vec2d::Zero();  // m, where the dart's fold meets the cap
    DartSide pressed_to = DartSide::Before;
};

// Pre: `before` and `after`, m, have two points or more. The folded cloth is pressed to the other side if the cap of
// the wanted one would reach far out. None: so would both.
std::optional<DartCap> cap_dart(const DartMouth& mouth, const std::vector<Vec2d>& before,
                                const std::vector<Vec2d>& after);

}  // namespace selvedge::sim
