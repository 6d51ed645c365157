#pragma once
// A free place for panels that are new in a pattern: beside the body and the panels that stand there.
#include <vector>

#include "sim/body/body.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// m, between what is placed freely and all else, give or take 1 mm for what is bent.
inline constexpr double kFreeGap = 0.03;

// The shortest move to the side (along x, m) after which the placed panels, moved together, are kFreeGap clear of the
// pattern's panels and of the body: their bounding box does not come closer to those of its panels and of the body's
// triangles. 0 if they are clear where they are. `body` null: there is none.
Vec3d free_move(const Pattern& pattern, const std::vector<Panel>& panels, const Body* body);

// Places a new panel upright, flat and facing the front: its centre at chest height before the body, or beside it if
// that place is taken.
void place_freely(Panel& panel, const Pattern& pattern, const Body* body);

}  // namespace selvedge::sim
