// Arms apart from the body, and the panels that must not close round them.
#include "sim/place/limb_pieces.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "sim/collide/surface_bvh.h"
#include "sim/mesh/sew.h"
#include "tests/sim/dress/shapes.h"
#include "tests/sim/place/support.h"
#include "tests/support/mannequin.h"
#include "tests/support/posed_body.h"

namespace selvedge::sim::test {
namespace {

bool is_closed(const Body& body) {
    std::map<std::pair<int, int>, int> uses;
    for (const auto& t : body.triangles) {
        for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
    }
    for (const auto& [edge, count] : uses) {
        const auto other = uses.find({edge.second, edge.first});
        if (count != 1 || other == uses.end()) return false;
    }
    return !body.triangles.empty();
}

// The limb's end joint: its wrist or ankle.
const Vec3d& end_of(const BodyLimbs& found, LimbKind kind) {
    return found[kind].joints[2].centre;
}

TEST(CutOff, gives_closed_parts_of_bodies_in_any_pose) {
    for (const Body& body : {mannequin(), shapes::in_t_pose(mannequin())}) {
        const BodyLimbs found = find_limbs(body);
        for (const auto& kinds : {kArms, kLegs}) {
            const BodyInPieces parts = cut_off(body, found, kinds);
            ASSERT_EQ(parts.limbs.size(), 2U);
            EXPECT_TRUE(is_closed(parts.trunk));
            for (const LimbPiece& limb : parts.limbs) {
                EXPECT_TRUE(is_closed(limb.piece.surface));
                const std::vector<LimbJoint>& joints = found[limb.kind].joints;
                EXPECT_LT((limb.piece.joint - joints[0].centre).norm(),
                          0.7 * (joints[1].centre - joints[0].centre).norm());
                EXPECT_GT(limb.along.dot(end_of(found, limb.kind) - limb.piece.joint), 0);
                for (const Vec3d& x : parts.trunk.x) EXPECT_GT((x - end_of(found, limb.kind)).norm(), 0.2);
            }
        }
    }
}

// Each cut is closed by itself: no surface runs from one shoulder to the other.
TEST(CutOff, leaves_the_trunk_solid) {
    const BodyInPieces parts = cut_off(mannequin(), mannequin_limbs(), kArms);
    const SurfaceBvh trunk(parts.trunk);
    const auto chest = trunk.closest(mannequin_limbs().torso[2].centre.cast<float>(), 1.0F);
    ASSERT_TRUE(chest.has_value());
    EXPECT_LT(chest->distance, -0.06F);
}

TEST(CutOff, leaves_limbs_that_were_not_found_with_the_trunk) {
    const BodyInPieces parts = cut_off(mannequin(), BodyLimbs{}, kArms);
    EXPECT_TRUE(parts.limbs.empty());
    EXPECT_EQ(parts.trunk.triangles.size(), mannequin().triangles.size());
}

LimbPiece left_leg() {
    return cut_off(mannequin(), mannequin_limbs(), kLegs).limbs[0];
}

TEST(BendLimb, lays_a_thin_limb_along_a_way_but_leaves_its_root) {
    const LimbPiece leg = left_leg();
    const Vec3d out = Vec3d(0.3, -1, 0).normalized();
    const Body bent = bend_limb(leg, mannequin_limbs(), {leg.piece.joint, leg.piece.joint + 0.1 * out}, 0.1);
    const Body& full = leg.piece.surface;
    ASSERT_EQ(bent.x.size(), full.x.size());
    for (std::size_t v = 0; v < full.x.size(); ++v) {
        const double beyond = (full.x[v] - leg.piece.joint).dot(leg.along);
        const Vec3d from_root = bent.x[v] - leg.piece.joint;
        if (beyond < 1e-6) {
            EXPECT_LT((bent.x[v] - full.x[v]).norm(), 1e-6);
        } else if (beyond > leg.radius) {
            EXPECT_LT((from_root - from_root.dot(out) * out).norm(), 0.03);
        }
    }
}

// The hem of trousers that are too long takes the foot along.
TEST(BendLimb, stretches_a_limb_to_the_end_of_a_longer_way) {
    const LimbPiece leg = left_leg();
    const Vec3d ankle = end_of(mannequin_limbs(), LimbKind::LeftLeg);
    const Vec3d end = leg.piece.joint + 1.2 * (ankle - leg.piece.joint);
    const Body bent = bend_limb(leg, mannequin_limbs(), {leg.piece.joint, end}, 0.1);
    const auto nearest_to = [](const Body& body, const Vec3d& x) {
        double nearest = 1;
        for (const Vec3d& v : body.x) nearest = std::min(nearest, (v - x).norm());
        return nearest;
    };
    EXPECT_LT(nearest_to(bent, end), 0.03);
    double longest = 0;
    for (const Vec3d& v : bent.x) longest = std::max(longest, (v - end).dot(leg.along));
    EXPECT_GT(longest, 0.05) << "the foot lies beyond it";
}

// Panels before and behind a leg, as far to its side as for a body with its feet apart.
TEST(WayOut, runs_through_the_middle_of_a_trouser_leg_to_its_hem) {
    Pattern pattern = tube(0.3, 0.65, 0.02, 0.2);
    for (Panel& panel : pattern.panels) panel.translation.x() = 0.18;
    GarmentMesh closed = assemble(pattern);
    merge_seams(closed);
    const std::vector<Vec3d> way = way_out(closed, left_leg(), mannequin_limbs());
    EXPECT_LT((way.front() - left_leg().piece.joint).norm(), 1e-6);
    EXPECT_LT((way.back() - Vec3d(0.18, 0.02, 0)).norm(), 0.02);
    for (std::size_t i = way.size() / 2; i < way.size(); ++i) EXPECT_NEAR(way[i].x(), 0.18, 0.02);
}

// Where the cloth goes round both legs, the way stays at the leg.
TEST(WayOut, does_not_run_to_the_middle_of_a_skirt) {
    GarmentMesh closed = assemble(tube(0.6, 0.65, 0.02, 0.2));
    merge_seams(closed);
    const std::vector<Vec3d> way = way_out(closed, left_leg(), mannequin_limbs());
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(way.size() - 1);
        EXPECT_NEAR(way[i].x(), (1 - share) * way.front().x() + share * way.back().x(), 1e-6);
    }
}

TEST(WayOut, is_along_the_limb_where_no_cloth_is_round_it) {
    GarmentMesh closed = assemble(tube(0.5, 0.3, 1.1, 0.2));
    merge_seams(closed);
    const LimbPiece leg = left_leg();
    const std::vector<Vec3d> way = way_out(closed, leg, mannequin_limbs());
    ASSERT_EQ(way.size(), 2U);
    EXPECT_LT(((way[1] - way[0]).normalized() - leg.along).norm(), 1e-6);
}

TEST(LinksAlongLimbs, are_those_of_a_trouser_leg_and_not_of_a_skirt) {
    Pattern pattern = tube(0.3, 0.65, 0.02, 0.2);
    for (Panel& panel : pattern.panels) panel.translation.x() = 0.1;
    const GarmentMesh leg = assemble(pattern);
    EXPECT_EQ(links_along_limbs(leg, mannequin_limbs(), kLegs), std::vector<bool>(leg.links.size(), true));
    EXPECT_EQ(links_along_limbs(leg, mannequin_limbs(), kArms), std::vector<bool>(leg.links.size(), false));
    const GarmentMesh skirt = assemble(tube(0.6, 0.65, 0.02, 0.2));
    EXPECT_EQ(links_along_limbs(skirt, mannequin_limbs(), kLegs), std::vector<bool>(skirt.links.size(), false));
}

// A skirt of this width at its hem, front and back, from the waist down.
Pattern skirt(double hem) {
    Pattern pattern = tube(0.4, 0.5, 0.6, 0.16);
    for (Panel& panel : pattern.panels) {
        panel.vertices[0].x() = -hem / 2;
        panel.vertices[1].x() = hem / 2;
    }
    return pattern;
}

std::vector<bool> without_arms(const Pattern& pattern) {
    return panels_without_arms(assemble(pattern), pattern, mannequin_limbs());
}

bool is_in_way_of_arms(const Pattern& pattern) {
    return are_in_way_of_arms(without_arms(pattern), assemble(pattern), mannequin_limbs());
}

TEST(PanelsWithoutArms, are_those_of_a_skirt) {
    for (const double hem : {0.5, 2.5}) EXPECT_EQ(without_arms(skirt(hem)), (std::vector<bool>{true, true})) << hem;
}

TEST(PanelsWithoutArms, are_in_the_way_of_arms_when_they_would_close_round_the_hands) {
    EXPECT_FALSE(is_in_way_of_arms(skirt(0.5)));
    EXPECT_TRUE(is_in_way_of_arms(skirt(2.5)));
}

TEST(PanelsWithoutArms, are_not_in_the_way_of_arms_when_they_would_close_round_them_and_cover_the_chest) {
    Pattern poncho = skirt(2.5);
    for (Panel& panel : poncho.panels) panel.translation.y() = 1.0;
    EXPECT_FALSE(is_in_way_of_arms(poncho));
}

// A poncho covers the arms and closes round them, but no arm passes through it.
TEST(PanelsWithoutArms, are_not_those_that_cover_the_chest) {
    Pattern pattern = skirt(2.5);
    for (Panel& panel : pattern.panels) panel.translation.y() = 1.0;
    EXPECT_EQ(without_arms(pattern), (std::vector<bool>{false, false}));
}

// A bodice without straps lies below the arms, though it covers the chest: its upper edge must not close over them.
TEST(PanelsWithoutArms, are_those_of_a_bodice_without_straps) {
    const double shoulder = mannequin_limbs()[LimbKind::LeftArm].joints[0].centre.y();
    Pattern pattern = tube(0.8, 0.3, shoulder - 0.36, 0.2);
    EXPECT_EQ(without_arms(pattern), (std::vector<bool>{true, true}));
    pattern = tube(0.8, 0.4, shoulder - 0.36, 0.2);
    EXPECT_EQ(without_arms(pattern), (std::vector<bool>{false, false})) << "it reaches the shoulders";
}

TEST(PanelsWithoutArms, are_told_by_their_labels) {
    Pattern pattern = skirt(2.5);
    pattern.panels.push_back(rectangle("high", {.width = 0.3, .height = 0.2, .y = 1.2, .z = 0.2}));
    EXPECT_EQ(without_arms(pattern), (std::vector<bool>{true, true, false}));
    pattern.panels.back().label = "leg";
    EXPECT_EQ(without_arms(pattern), (std::vector<bool>{true, true, true}));
    pattern.panels[0].label = pattern.panels[1].label = "arm";
    EXPECT_EQ(without_arms(pattern), (std::vector<bool>{false, false, true}));
}

// As while a garment is sewn over others: the mesh has the panels of the outer one only.
TEST(PanelsWithoutArms, are_none_of_those_that_the_mesh_does_not_have) {
    Pattern pattern = skirt(2.5);
    pattern.panels.push_back(rectangle("sleeve", {.width = 0.3, .height = 0.2, .y = 1.2, .z = 0.2}));
    GarmentMesh mesh = assemble(pattern);
    std::erase_if(mesh.triangles, [](const GarmentTriangle& t) { return t.panel == 2; });
    EXPECT_EQ(panels_without_arms(mesh, pattern, mannequin_limbs()), (std::vector<bool>{true, true, false}));
    pattern.panels.back().label = "leg";
    EXPECT_EQ(panels_without_arms(mesh, pattern, mannequin_limbs()), (std::vector<bool>{true, true, false}));
}

}  // namespace
}  // namespace selvedge::sim::test
