// Elastics pull as theory says, on coarse and on fine meshes.
#include "sim/simulation/elastic_bands.h"

#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "sim/adaptive/panel_lines.h"
#include "sim/cloth/contact.h"
#include "sim/cloth/resting.h"
#include "sim/dress/drape.h"
#include "sim/inspection/contact_pressure.h"
#include "sim/mesh/sew.h"
#include "sim/simulation/simulation.h"
#include "tests/sim/cloth/fixtures.h"
#include "tests/sim/dress/shapes.h"

namespace selvedge::sim::test {
namespace {

double mean(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// All leaves get this level within the first adaptations.
struct Refined {
    std::array<MinimumLevelDisc, 2> everywhere{};  // of each panel
    SimulationOptions options{};

    explicit Refined(int level) {
        for (std::uint16_t panel = 0; panel < 2; ++panel)
            everywhere[panel] = {.panel = panel, .centre = Vec2f::Zero(), .radius = 10, .level = level};
        options.contact.floor = kNoFloor;
        options.adapt = {
            .criteria = {false, false, false}, .minimum_levels = everywhere, .shortest_edge = 0, .max_level = level};
    }
    Refined(const Refined&) = delete;
    Refined& operator=(const Refined&) = delete;
};

// Elastics along both sides of a strip of cloth that resists nothing along its length, pinned at its upper end, with a
// load of 20 g at the lower one.
Pattern loaded_strip(const Elastic& elastic) {
    Pattern pattern;
    pattern.panels = {rectangle("strip", {.width = 0.05, .height = 0.4, .y = 1, .z = 0}),
                      rectangle("load", {.width = 0.05, .height = 0.2, .y = 0.8, .z = 0})};
    pattern.panels[0].pins = {2, 3};
    for (const std::size_t side : {1U, 3U}) pattern.panels[0].edges[side].elastic = elastic;
    pattern.seams = {{.first = {0, 0}, .second = {1, 2}}};
    return pattern;
}

std::vector<Fabric> limp_and_heavy() {
    Fabric limp;
    limp.stretch_warp = 0.05;
    limp.shear = 0.05;
    limp.bending_warp = limp.bending_weft = 1e-8;
    limp.strain_limit = 1;
    Fabric heavy;
    heavy.area_density = 2;
    return {limp, heavy};
}

TEST(ElasticBands, bear_a_known_weight_with_the_strain_of_theory_on_any_mesh) {
    const Elastic elastic{.share = 0.4, .stiffness = 0.4};
    const Pattern pattern = loaded_strip(elastic);
    GarmentMesh mesh = assemble(pattern);
    merge_seams(mesh);
    const std::vector<Fabric> fabrics = limp_and_heavy();
    // Each side bears half of the load, and in the mean half of the strip's half.
    const double weight = 9.81 * 0.05 * (0.2 * fabrics[1].area_density + 0.5 * 0.4 * fabrics[0].area_density) / 2;
    for (const int level : {0, 1, 2, 3}) {
        const Refined refined(level);
        Simulation simulation(make_cloth(mesh, fabrics), refined.options);
        refresh_contacts(simulation.cloth(), simulation.contact({}));
        ClothConstraints constraints;
        constraints.add(std::make_unique<ElasticBands>(pattern));
        simulation.set_constraints(std::move(constraints));
        for (int i = 0; i < 600; ++i) {
            if (i < level) simulation.adapt(NoBody{}, {});
            simulation.step(NoBody{}, {.damping = 8});
        }
        ElasticBands bands(pattern);
        bands.make(simulation.cloth());
        for (const int side : {1, 3}) {
            const std::vector<float> tensions = bands.tensions(simulation.cloth(), 0, side);
            EXPECT_EQ(tensions.size(), 8U << static_cast<unsigned>(level));
            EXPECT_NEAR(mean(tensions), weight, 0.05 * weight) << "level " << level;
        }
    }
}

constexpr float kRadius = 0.12F;  // m

const CylinderCollider& column() {
    static const CylinderCollider cylinder({.centre = Vec3f(0, 1, 0), .axis = Vec3f::UnitY(), .radius = kRadius});
    return cylinder;
}

// A tube of 1 m round and 0.2 m high with an elastic at its upper edge, in two panels. It stands round the y axis.
Pattern belt(const Elastic& elastic) {
    Pattern pattern = tube(0.5, 0.2, 1, 0);
    for (Panel& panel : pattern.panels) panel.edges[2].elastic = elastic;
    return pattern;
}

Simulation worn(const Pattern& pattern, const SimulationOptions& options) {
    GarmentMesh mesh = assemble(pattern);
    for (const GarmentTriangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double angle = 2 * std::numbers::pi * (t.u[k].x() + (t.panel == 0 ? 0.25 : 0.75));
            const double radius = 0.5 / std::numbers::pi;
            mesh.x[static_cast<std::size_t>(t.vertices[k])] =
                Vec3d(-radius * std::cos(angle), 1 + t.u[k].y(), radius * std::sin(angle));
        }
    }
    merge_seams(mesh);
    Simulation simulation(make_cloth(mesh, {2, find_fabric("cotton_shirting")}), options);
    refresh_contacts(simulation.cloth(), simulation.contact({}));
    ClothConstraints constraints;
    constraints.add(std::make_unique<ElasticBands>(pattern));
    simulation.set_constraints(std::move(constraints));
    return simulation;
}

double round_the_top(const Cloth& cloth) {
    double sum = 0;
    for (const LeafEdge& leaf : cloth.mesh.leaf_edges()) {
        for (const auto& line : lines_of(cloth.mesh, leaf.edge))
            if (line && line->edge == 2)
                sum += static_cast<double>((cloth.x[leaf.a.value] - cloth.x[leaf.b.value]).norm());
    }
    return sum;
}

TEST(ElasticBands, draw_a_free_edge_to_their_own_length) {
    const Pattern pattern = belt({.share = 0.6, .stiffness = 20});
    SimulationOptions options;
    options.gravity.setZero();
    Simulation simulation = worn(pattern, options);
    for (int i = 0; i < 240; ++i) {
        if (i % 4 == 0) simulation.adapt(NoBody{}, {});
        simulation.step(NoBody{}, {.damping = 8});
    }
    EXPECT_NEAR(round_the_top(simulation.cloth()), 0.6, 0.03);
}

// The girth that it would have is less than the body's: it is as long as the body lets it be, and presses with 2 pi
// times its tension. Its friction carries the cloth.
TEST(ElasticBands, press_on_a_body_with_their_tension_and_hold_the_cloth_up) {
    const Elastic elastic{.share = 0.5, .stiffness = 10};
    const Pattern pattern = belt(elastic);
    const double strain = 2 * std::numbers::pi * double(kRadius) / elastic.share - 1;
    for (const int level : {0, 2}) {
        const Refined refined(level);
        Simulation simulation = worn(pattern, refined.options);
        DrapeRun run(simulation, {.max_seconds = 5, .finish_time = 0});
        while (run.advance(simulation, column())) continue;
        ElasticBands bands(pattern);
        bands.make(simulation.cloth());
        const double tension = mean(bands.tensions(simulation.cloth(), 0, 2));
        EXPECT_NEAR(tension, elastic.stiffness * strain, 0.05 * elastic.stiffness * strain) << "level " << level;
        const ContactPressure pressure = measure_contact_pressure(simulation, column());
        double sum = 0;
        std::size_t i = 0;
        for (const VertexId v : simulation.cloth().mesh.leaf_vertices()) {
            const Vec3f x = simulation.cloth().x[v.value].head<3>();
            sum += static_cast<double>(pressure.force[i++].dot(Vec3f(x.x(), 0, x.z()).normalized()));
        }
        EXPECT_NEAR(sum, 2 * std::numbers::pi * tension, 0.1 * 2 * std::numbers::pi * tension) << "level " << level;
        EXPECT_GT(lowest_height(simulation.cloth()), 0.97F) << "it has slipped";
    }
}

// As one of an outer garment, which is sewn last.
TEST(ElasticBands, start_without_tension_when_their_panel_comes_into_the_cloth) {
    Pattern pattern = loaded_strip({.share = 0.4, .stiffness = 0.4});
    ElasticBands bands(pattern);
    const auto solve = [&](const Pattern& worn) {
        GarmentMesh mesh = assemble(worn);
        merge_seams(mesh);
        const Cloth cloth = make_cloth(mesh, limp_and_heavy());
        bands.make(cloth);
        std::vector<float> points;
        for (std::size_t v = 0; v < cloth.x.size(); ++v) {
            points.insert(points.end(), {cloth.x[v].x(), cloth.x[v].y(), cloth.x[v].z(), cloth.inverse_mass[v]});
        }
        const std::vector<float> before = points;
        bands.solve(points.data(), before.data());
    };
    Pattern without_strip = pattern;
    without_strip.panels[0].is_worn = false;
    without_strip.seams.clear();
    solve(without_strip);
    EXPECT_TRUE(bands.is_at_rest());
    solve(pattern);
    EXPECT_FALSE(bands.is_at_rest()) << "the strip lies flat, and is drawn in from then on";
}

TEST(ElasticBands, rest_when_they_have_drawn_the_cloth_in) {
    const Pattern pattern = belt({.share = 0.5, .stiffness = 10});
    Simulation simulation = worn(pattern, {});
    DrapeRun run(simulation, {.max_seconds = 20, .rest_time = 100, .finish_time = 0, .may_rest = true});
    for (int frame = 0; frame < 500 && !is_at_rest(simulation.cloth()); ++frame) run.advance(simulation, column());
    EXPECT_TRUE(is_at_rest(simulation.cloth()));
}

}  // namespace
}  // namespace selvedge::sim::test
