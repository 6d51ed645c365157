#pragma once
// The surface of a body as cloth meets it. Cloth does not follow what is smaller than its folds, such as a nipple or
// the bottom of a narrow crease: it hangs from the tip to the ground round it like a tent.
//
//        _                      .^.            The surface is raised until it is nowhere steeper than kTentSlope
//   ____| |____     ->     ___-'   '-___       against what is left of it when it is smoothed over kTentScale.
//
// Bodies that an animation moves are tented (dress/animation.h). In dress and in the editor, cloth meets the surface as
// it is.
#include "sim/body/body.h"

namespace selvedge::sim {

inline constexpr double kTentScale = 0.02;  // m, the radius of the smallest folds of a shirt
inline constexpr double kTentSlope = 0.3;   // cloth that hangs so steeply is 4 % longer than the way below it

// Raises vertices only. Parts that are more slender than kTentScale, as fingers, stay as they are.
Body tented(const Body& body);

}  // namespace selvedge::sim
