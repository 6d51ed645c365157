#pragma once
// Shared by the tests of sim/place: the limbs of the mannequin, and a panel that nobody placed.
#include "sim/pattern/pattern.h"
#include "sim/place/limbs.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {

inline const BodyLimbs& mannequin_limbs() {
    static const BodyLimbs found = find_limbs(mannequin());
    return found;
}

// Edges: 0 bottom, 1 right, 2 top, 3 left.
inline Panel unplaced_rectangle(const char* name, double width, double height) {
    Panel panel;
    panel.name = name;
    panel.vertices = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    return panel;
}

}  // namespace selvedge::sim::test
