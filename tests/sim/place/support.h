#pragma once
// Shared by the tests of sim/place: the limbs of the mannequin, and a panel that nobody placed.
#include <utility>

#include "sim/body/body.h"
#include "sim/pattern/pattern.h"
#include "sim/place/limbs.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {

inline const BodyLimbs& mannequin_limbs() {
    static const BodyLimbs found = find_limbs(mannequin());
    return found;
}

// The body with a head that is so many times as tall. Pre: it has the mannequin's bones.
inline Body with_head_scaled(Body body, double times) {
    const double height = height_range(body).high, neck = 0.86 * height;
    const auto grow = [&](Vec3d& x) {
        if (x.y() > neck) x.y() = neck + times * (x.y() - neck);
    };
    for (Vec3d& x : body.x) grow(x);
    for (Bone& bone : body.bones) grow(bone.joint);
    return body;
}

// As of a figure in a cartoon.
inline Body with_large_head(Body body) {
    return with_head_scaled(std::move(body), 3);
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
