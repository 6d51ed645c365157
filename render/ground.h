#pragma once
// The ground that catches shadows: a square sheet under the scene, whose room light is held by its vertices.
#include "render/casters.h"
#include "render/cloth_vertices.h"

namespace selvedge {

struct Ground {
    Vec3f centre = Vec3f::Zero();
    float radius = 1;  // m, half its side; nothing is seen of it from there on
    BodyItem sheet;    // empty where the scene has none
};

Ground make_ground(const Scene& scene, const Bounds& bounds);

// Each of the finitely many directions throws a faint shadow of its own on the ground: melts them into one.
// Pre: one value for each of the sheet's vertices.
std::vector<Openness> softened_ground(std::vector<Openness> openness);

}  // namespace selvedge
