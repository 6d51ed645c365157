// How hard a cloth at rest presses on what it lies on.
#include "sim/inspection/contact_pressure.h"

#include <gtest/gtest.h>
#include <cstddef>

#include "sim/cloth/contact.h"
#include "sim/dress/drape.h"
#include "sim/dress/dressing.h"
#include "sim/mesh/square.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::sim::test {
namespace {

const SphereCollider& head() {
    static const SphereCollider sphere(Vec3f(0, 1, 0), 0.15F);
    return sphere;
}

Simulation at_rest_on_the_head() {
    Simulation simulation(
        make_cloth(sim::make_square({.columns = 6, .rows = 6, .width = 0.4, .depth = 0.4, .height = 1.17}),
                   {find_fabric("cotton_shirting")}, {.max_level = 2}),
        simulation_options({.max_level = 2}));
    DrapeRun run(simulation, drape_options({.max_level = 2}));
    while (run.advance(simulation, head())) continue;
    EXPECT_TRUE(run.result().settled);
    return simulation;
}

TEST(ContactPressure, the_forces_of_what_it_lies_on_are_the_weight_of_a_cloth_at_rest) {
    const Simulation simulation = at_rest_on_the_head();
    const Cloth& cloth = simulation.cloth();
    const ContactPressure measured = measure_contact_pressure(simulation, head());
    ASSERT_EQ(measured.force.size(), cloth.mesh.leaf_vertices().size());
    Vec3f sum = Vec3f::Zero();
    for (const Vec3f& force : measured.force) sum += force;
    const double weight = 9.81 * total_mass(cloth);
    EXPECT_NEAR(sum.y(), weight, 0.05 * weight);
    EXPECT_NEAR(sum.x(), 0, 0.05 * weight);
    EXPECT_NEAR(sum.z(), 0, 0.05 * weight);
}

TEST(ContactPressure, only_what_touches_is_pressed) {
    const Simulation simulation = at_rest_on_the_head();
    const Cloth& cloth = simulation.cloth();
    const ContactPressure measured = measure_contact_pressure(simulation, head());
    bool is_pressed = false;
    std::size_t i = 0;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const float pressure = measured.pressure[i++];
        EXPECT_GE(pressure, 0);
        if (head().contact(cloth.x[v.value].head<3>()).distance > 0.02F) {
            EXPECT_EQ(pressure, 0);
        }
        is_pressed = is_pressed || pressure > 0;
    }
    EXPECT_TRUE(is_pressed);
}

TEST(ContactPressure, nothing_presses_on_nothing) {
    Cloth cloth = make_cloth(sim::make_square({.columns = 2, .rows = 2, .width = 0.4, .depth = 0.4, .height = 5}),
                             {find_fabric("cotton_shirting")});
    refresh_contacts(cloth);
    for (const Vec3f& force : measure_contact_pressure(Simulation(cloth), NoBody()).force)
        EXPECT_EQ(force, Vec3f::Zero());
}

}  // namespace
}  // namespace selvedge::sim::test
