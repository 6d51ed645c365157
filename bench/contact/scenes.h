#pragma once
// Scenes in which cloth meets itself or other cloth: thrown, piled, folded, layered, twisted, or crossing from the
// start. Each sheet is a panel of one mesh.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/cloth/step.h"
#include "sim/collide/collider.h"
#include "sim/core/gravity.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::bench {

struct ContactScene {
    std::string name;
    sim::GarmentMesh mesh;
    std::shared_ptr<const sim::Collider> body;
    float floor = -1000;                      // m
    bool is_adaptive = false;                 // else level 0 only
    int steps = 241;                          // of 1/120 s
    int sheets = 1;                           // panel i + 1 lies above (outside of) panel i
    Vec3f last_velocity = Vec3f::Zero();      // m/s, of the last sheet at the start
    Vec3f gravity = sim::standard_gravity();  // m/s^2
    float damping = 0;                        // 1/s, in addition to what all scenes have
    // Optional: moves the pinned vertices; their targets at the end of a step, given the time then (s).
    std::function<std::vector<sim::KinematicVertex>(const sim::Cloth&, float)> kinematic{};
};

// A square of 0.5 m is thrown down at that speed (m/s) on a larger one that is pinned at its border.
ContactScene thrown_sheet(float speed);
// A square of 1 m, hung edge-on above the floor, falls.
ContactScene pile();
// A square of 1 m, folded in half round a radius of 12 mm, falls on the floor. Edges of 6 to 50 mm.
ContactScene fold();
// Squares of 1 m fall on a sphere, one above the other.
ContactScene layers_on_sphere(int count);
// Two squares that cross each other at an angle of 6 degrees from the start fall on a sphere.
ContactScene tilt();
// A folded square of which a corner of the upper half has been pushed through the lower one.
ContactScene pull();
// A tube of 0.24 m diameter whose ends turn by half a turn each, against each other.
ContactScene twist();

std::vector<ContactScene> all_contact_scenes();

}  // namespace selvedge::bench
