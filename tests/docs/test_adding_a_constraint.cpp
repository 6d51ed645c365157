// The example of docs/adding-a-constraint.md works.
#include <gtest/gtest.h>
#include <memory>
#include <utility>

#include "sim/cloth/contact.h"
#include "sim/collide/collider.h"
#include "sim/mesh/square.h"
#include "sim/simulation/simulation.h"
#include "tests/docs/foundation.h"

namespace selvedge::sim {
namespace {

constexpr float kNoFloor = -1000;  // m

Simulation horizontal_square() {
    Simulation simulation(make_cloth(sim::make_square(), {find_fabric("cotton_shirting")}),
                          {.contact = {.floor = kNoFloor}});
    refresh_contacts(simulation.cloth());
    return simulation;
}

// [test]
TEST(Foundation, bears_the_weight_of_the_cloth_where_theory_says_on_any_mesh) {
    constexpr float kStiffness = 1000;  // N/m^3
    for (const int level : {0, 2}) {
        const MinimumLevelDisc everywhere{.panel = 0, .centre = Vec2f::Zero(), .radius = 10, .level = level};
        Simulation simulation = horizontal_square();
        SimulationOptions options = simulation.options();
        options.adapt = {.criteria = {false, false, false}, .minimum_levels = {&everywhere, 1}, .shortest_edge = 0};
        simulation.set_options(options);
        ClothConstraints constraints;
        constraints.add(std::make_unique<Foundation>(kStiffness, 0.0F));
        simulation.set_constraints(std::move(constraints));
        for (int i = 0; i < 120; ++i) {
            if (i < level) simulation.adapt(NoBody{}, {});
            simulation.step(NoBody{}, {.damping = 20});
        }
        const Cloth& cloth = simulation.cloth();
        const auto depth = static_cast<float>(find_fabric("cotton_shirting").area_density * 9.81) / kStiffness;
        for (const VertexId v : cloth.mesh.leaf_vertices()) EXPECT_NEAR(cloth.x[v.value].y(), -depth, 0.05F * depth);
    }
}
// [/test]

}  // namespace
}  // namespace selvedge::sim
