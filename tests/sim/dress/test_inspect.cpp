// Faults that are planted are found, named with their place, and nothing else is.
#include "sim/dress/inspect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "sim/body/body_collider.h"
#include "sim/mesh/assemble.h"
#include "tests/sim/body/shapes.h"
#include "tests/sim/dress/shapes.h"

namespace selvedge::test {
namespace {

// A sewn tube of cotton, 0.4 m wide and flat: front and back stand 0.3 m apart, with a ball between them.
class Inspect : public testing::Test {
 protected:
    Inspect() {
        draped_.settled = true;
        draped_.stopped_because = "settled";
    }

    DressReport look() const {
        DressReport report;
        inspect(cloth_, collider_, pattern_, sewing_, draped_, report);
        return report;
    }
    const DressFault* find(const DressReport& report, const std::string& kind) const {
        const auto at = std::find_if(report.faults.begin(), report.faults.end(),
                                     [&](const DressFault& fault) { return fault.kind == kind; });
        return at == report.faults.end() ? nullptr : &*at;
    }
    // All positions by this map of what they were.
    template <class Map>
    void deform(const Map& map) {
        for (Vec4f& x : cloth_.x) x = padded(map(Vec3f(x.head<3>())));
        cloth_.x_prev = cloth_.x;
    }

    static Pattern apart() {
        Pattern pattern = tube(0.4, 0.3, 0.8, 0.15);
        pattern.seams.clear();
        return pattern;
    }

    const Body ball_ = shapes::sphere(Vec3d(0, 0.95, 0), 0.1, 12);
    const BodyCollider collider_{ball_, {.cell = 0.006F, .band = 0.024F}};
    const Pattern pattern_ = apart();
    Cloth cloth_ = make_cloth(assemble(pattern_), {Fabric{}, Fabric{}});
    SewingResult sewing_;
    DrapeResult draped_;
};

TEST_F(Inspect, finds_no_fault_where_there_is_none) {
    const DressReport report = look();
    EXPECT_TRUE(report.faults.empty()) << report.faults[0].kind << " " << report.faults[0].place;
    EXPECT_EQ(report.contact.inside, 0);
    EXPECT_EQ(report.contact.deepest_m, 0);
    EXPECT_NEAR(report.stretch.warp_weft_max, 0, 1e-4);
    EXPECT_EQ(report.mesh.leaf_triangles, int(cloth_.mesh.leaf_triangles().size()));
    EXPECT_EQ(report.mesh.leaf_vertices, int(cloth_.mesh.leaf_vertices().size()));
    ASSERT_EQ(report.mesh.by_level.size(), std::size_t(cloth_.mesh.max_level()) + 1);
    EXPECT_EQ(report.mesh.by_level[0], report.mesh.leaf_triangles);
}

TEST_F(Inspect, finds_cloth_that_is_stretched_throughout) {
    deform([](const Vec3f& x) { return Vec3f(x.x(), 1.08F * x.y(), x.z()); });
    const DressReport report = look();
    EXPECT_NEAR(report.stretch.warp_weft_p99, 0.08, 1e-3);
    const DressFault* fault = find(report, "overstretched");
    ASSERT_NE(fault, nullptr);
    EXPECT_NEAR(fault->value, 0.08, 1e-3);
    EXPECT_EQ(report.faults.size(), 1U) << "8 % is no fault of the maximum";
}

TEST_F(Inspect, lets_a_fabric_stretch_that_is_made_to) {
    for (Fabric& fabric : cloth_.material.fabrics) fabric.strain_limit = 0.1;  // a knit's
    deform([](const Vec3f& x) { return Vec3f(x.x(), 1.08F * x.y(), x.z()); });
    EXPECT_EQ(find(look(), "overstretched"), nullptr);
    deform([](const Vec3f& x) { return Vec3f(x.x(), 1.08F * x.y(), x.z()); });
    EXPECT_NE(find(look(), "overstretched"), nullptr);
}

TEST_F(Inspect, finds_one_triangle_that_is_torn_apart_and_says_where) {
    const LeafTriangle& torn = cloth_.mesh.leaf_triangles()[3];
    cloth_.x[torn.v[0].value].z() += 0.1F;
    const DressReport report = look();
    EXPECT_GT(report.stretch.warp_weft_max, 0.15);
    const DressFault* fault = find(report, "overstretched");
    ASSERT_NE(fault, nullptr);
    EXPECT_NE(fault->place.find("'front'"), std::string::npos) << fault->place;
}

TEST_F(Inspect, does_not_take_shear_for_stretch) {
    deform([](const Vec3f& x) { return Vec3f(x.x() + 0.2F * (x.y() - 1), x.y(), x.z()); });
    const DressReport report = look();
    EXPECT_NEAR(report.stretch.shear_deg_p99, 11.3, 0.2);
    EXPECT_EQ(find(report, "overstretched"), nullptr);
}

TEST_F(Inspect, finds_cloth_in_the_body_and_how_deep) {
    deform([](const Vec3f& x) { return Vec3f(x.x(), x.y(), x.z() > 0 ? x.z() - 0.07F : x.z()); });
    const DressReport report = look();
    const DressFault* fault = find(report, "inside_body");
    ASSERT_NE(fault, nullptr);
    EXPECT_NE(fault->place.find("'front'"), std::string::npos) << fault->place;
    EXPECT_EQ(fault->place.find("'back'"), std::string::npos) << fault->place;
    EXPECT_GT(fault->value, 0.01);
    EXPECT_LT(fault->value, 0.0205) << "the plane at 0.08 m cuts a ball of 0.1 m by 0.02 m";
    EXPECT_EQ(report.contact.deepest_m, fault->value);
    EXPECT_GT(report.contact.inside, 0);
    EXPECT_EQ(report.faults.size(), 1U);
}

TEST_F(Inspect, counts_but_forgives_what_is_inside_by_less_than_half_a_millimetre) {
    const std::uint32_t vertex = cloth_.mesh.leaf_vertices()[0].value;
    cloth_.x[vertex] = Vec4f(0, 0.95F, 0.0997F, 0);
    const DressReport report = look();
    EXPECT_EQ(report.contact.inside, 1);
    EXPECT_EQ(find(report, "inside_body"), nullptr);
}

TEST_F(Inspect, says_that_a_garment_did_not_settle) {
    draped_.settled = false;
    draped_.rms_speed = 0.3F;
    const DressReport report = look();
    const DressFault* fault = find(report, "not_settled");
    ASSERT_NE(fault, nullptr);
    EXPECT_NEAR(fault->value, 0.3, 1e-6);
    EXPECT_EQ(report.faults.size(), 1U);
}

TEST_F(Inspect, says_which_seam_is_open_between_which_panels) {
    Pattern sewn = tube(0.4, 0.3, 0.8, 0.15);
    sewing_.open = {{.seam = 1, .gap = 0.04F}};
    DressReport report;
    inspect(cloth_, collider_, sewn, sewing_, draped_, report);
    ASSERT_EQ(report.faults.size(), 1U);
    EXPECT_EQ(report.seams.open, 1);
    EXPECT_EQ(report.faults[0].kind, "open_seam");
    EXPECT_NEAR(report.faults[0].value, 0.04, 1e-6);
    EXPECT_NE(report.faults[0].place.find("front"), std::string::npos) << report.faults[0].place;
    EXPECT_NE(report.faults[0].place.find("back"), std::string::npos) << report.faults[0].place;
}

TEST_F(Inspect, says_that_a_number_went_bad_and_trusts_no_other_figure) {
    const VertexId bad = cloth_.mesh.leaf_vertices()[5];
    cloth_.x[bad.value].setConstant(std::numeric_limits<float>::quiet_NaN());
    draped_.bad_vertex = bad;
    draped_.settled = false;
    const DressReport report = look();
    EXPECT_NE(find(report, "not_finite"), nullptr);
    EXPECT_NE(find(report, "not_settled"), nullptr);
    EXPECT_EQ(find(report, "inside_body"), nullptr);
}

TEST_F(Inspect, describes_a_place_by_its_panel_and_its_coordinates) {
    const std::string place = describe_place(cloth_, pattern_, cloth_.mesh.leaf_vertices()[0]);
    EXPECT_NE(place.find("'front'"), std::string::npos) << place;
    EXPECT_NE(place.find("0.8"), std::string::npos) << place;
}

TEST_F(Inspect, hands_over_the_leaves_as_a_plain_mesh) {
    const PlainMesh mesh = plain_mesh(cloth_, {"front", "back"});
    EXPECT_EQ(mesh.x.size(), cloth_.mesh.leaf_vertices().size());
    EXPECT_EQ(mesh.normals.size(), mesh.x.size());
    ASSERT_EQ(mesh.triangles.size(), cloth_.mesh.leaf_triangles().size());
    EXPECT_EQ(mesh.u.size(), mesh.triangles.size());
    EXPECT_EQ(mesh.level.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = mesh.triangles[t][k];
            ASSERT_LT(v, mesh.x.size());
            EXPECT_NEAR(mesh.normals[v].z(), mesh.panel[t] == 0 ? 1.0F : -1.0F, 1e-5F) << "outward, both of them";
        }
    }
}

}  // namespace
}  // namespace selvedge::test
