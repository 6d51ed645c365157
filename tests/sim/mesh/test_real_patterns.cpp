// Published GarmentCode patterns, meshed at several sizes.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "sim/mesh/assemble.h"
#include "sim/mesh/check_mesh.h"
#include "sim/mesh/report_mesh.h"
#include "sim/pattern/pattern_file.h"
#include "tests/sim/mesh/shapes.h"

namespace selvedge {
namespace {

struct RealPattern {
    const char* file;
    double worst_ratio;  // of seam sides
    int boundary_loops;
};

std::ostream& operator<<(std::ostream& out, const RealPattern& pattern) {
    return out << pattern.file;
}

class RealPatterns : public testing::TestWithParam<RealPattern> {
 protected:
    void SetUp() override {
        const char* data = std::getenv("SELVEDGE_TEST_DATA");
        if (data == nullptr) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
        pattern_ = load_pattern(std::filesystem::path(data) / "garmentcode" / GetParam().file).pattern;
    }

    Pattern pattern_;
};

TEST_P(RealPatterns, are_sewn_into_one_sound_surface_at_every_size) {
    for (double target_edge : {0.03, 0.04, 0.05, 0.06}) {
        const GarmentMesh unsewn = assemble(pattern_, {.target_edge = target_edge});
        const GarmentMesh sewn = merge_seams(unsewn).mesh;
        const auto faults = check_mesh(sewn);
        EXPECT_EQ(faults.size(), 0U) << faults[0];
        const Topology topology = topology_of(sewn);
        EXPECT_EQ(topology.boundary_loops, GetParam().boundary_loops);
        EXPECT_EQ(topology.euler, 2 - GetParam().boundary_loops);
        const MeshReport report = report_mesh(pattern_, unsewn, sewn);
        EXPECT_GT(report.min_angle_deg, 21) << target_edge << " " << report.min_angle_panel;
        ASSERT_TRUE(report.worst_mismatch);
        EXPECT_NEAR(report.worst_mismatch->ratio, GetParam().worst_ratio, 0.01);
    }
}

TEST_P(RealPatterns, have_hundreds_of_triangles_by_default_and_the_same_bits_each_time) {
    const GarmentMesh first = assemble(pattern_);
    const GarmentMesh second = assemble(pattern_);
    EXPECT_GT(first.triangles.size(), 300U);
    EXPECT_LT(first.triangles.size(), 1200U);
    ASSERT_EQ(first.triangles.size(), second.triangles.size());
    EXPECT_EQ(first.x, second.x);
    for (std::size_t i = 0; i < first.triangles.size(); ++i) {
        EXPECT_EQ(first.triangles[i].vertices, second.triangles[i].vertices);
        EXPECT_EQ(first.triangles[i].u, second.triangles[i].u);
    }
}

INSTANTIATE_TEST_SUITE_P(GarmentCode, RealPatterns,
                         testing::Values(RealPattern{"shirt_mean_specification.json", 1.003, 4},
                                         RealPattern{"dress_pencil_specification.json", 1.302, 4}),
                         [](const auto& tested) {
                             const std::string file = tested.param.file;
                             return file.substr(0, file.find("_specification"));
                         });

}  // namespace
}  // namespace selvedge
