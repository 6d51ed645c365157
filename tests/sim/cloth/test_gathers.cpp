// Seams whose sides are of unequal length: cloth in puckers finer than the mesh, and folds below them.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/stretch.h"
#include "sim/mesh/assemble.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::test {
namespace {

constexpr double kBand = 0.2;  // m, the shorter side

Panel rectangle(const std::string& name, double width, double top, double bottom) {
    Panel panel;
    panel.name = name;
    panel.vertices = {{-width / 2, bottom}, {width / 2, bottom}, {width / 2, top}, {-width / 2, top}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    return panel;
}

// A band held at its upper edge, and a ruffle gathered onto its lower one; hanging, with each vertex a little before or
// behind the others.
Cloth make_ruffle(const Fabric& fabric, double fullness) {
    Pattern pattern;
    pattern.panels = {rectangle("band", kBand, 0, -0.05), rectangle("ruffle", fullness * kBand, -0.05, -0.2)};
    pattern.seams.push_back({.first = {0, 0}, .second = {1, 2}});
    const GarmentMesh sewn = merge_seams(assemble(pattern, {.target_edge = 0.025})).mesh;
    Cloth cloth = make_cloth(sewn, {fabric, fabric}, {.max_level = 2});
    std::mt19937 random(3);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        cloth.is_pinned[v.value] = cloth.x[v.value].y() > -1e-4F;
        if (!cloth.is_pinned[v.value]) cloth.x[v.value].z() += draw(random, -1e-3F, 1e-3F);
    }
    cloth.x_prev = cloth.x;
    refresh_solver(cloth);
    refresh_contacts(cloth);
    return cloth;
}

void hang(Cloth& cloth, double seconds) {
    const StepOptions stepping{.extra_damping = 4, .contact = {.floor = kNoFloor}};
    for (double t = 0; t < seconds; t += 1.0 / 30) {
        adapt_cloth(cloth, nothing_near());
        run(cloth, nothing_near(), stepping, 1.0 / 30);
    }
}

// m, how far the cloth stands before and behind itself at the hem.
float depth_of_hem(const Cloth& cloth) {
    float least = 1, most = -1;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec4f& x = cloth.x[v.value];
        if (x.y() > -0.15F) continue;
        least = std::min(least, x.z());
        most = std::max(most, x.z());
    }
    return most - least;
}

class Gathers : public testing::TestWithParam<const char*> {};

TEST_P(Gathers, hang_in_folds_and_come_to_rest_without_a_stretched_triangle) {
    const Fabric fabric = find_fabric(GetParam());
    Cloth gathered = make_ruffle(fabric, 1.4), plain = make_ruffle(fabric, 1);
    for (Cloth* cloth : {&gathered, &plain}) {
        hang(*cloth, 8);
        ASSERT_FALSE(find_bad_vertex(*cloth).has_value());
        EXPECT_LT(speed_now(*cloth), 0.05F) << "m/s: it trembles";
        for (const TriangleStrain& strain : measure_strain(*cloth)) {
            EXPECT_LT(std::max(strain.warp, strain.weft), fabric.strain_limit + 0.05) << "beyond the limit";
        }
    }
    EXPECT_GT(depth_of_hem(gathered), 0.02F) << "no folds";
    EXPECT_GT(depth_of_hem(gathered), 3 * depth_of_hem(plain));
}

INSTANTIATE_TEST_SUITE_P(Of, Gathers, testing::Values("silk", "cotton_shirting", "denim"),
                         [](const auto& instance) { return std::string(instance.param); });

}  // namespace
}  // namespace selvedge::test
