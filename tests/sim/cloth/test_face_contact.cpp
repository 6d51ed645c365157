// Contact of whole faces: what is thin does not pass through them between their vertices.
#include "sim/cloth/face_contact.h"
#include "sim/cloth/solver_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "sim/cloth/cloth_penetration.h"
#include "sim/cloth/contact_surface.h"
#include "sim/cloth/standoff.h"
#include "sim/cloth/strain_projection.h"
#include "sim/selfcontact/crossings.h"
#include "tests/sim/cloth/fixtures.h"
#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

constexpr float kFrame = 1.0F / 30.0F;  // s, four steps
constexpr float kFaceOffset = 0.0003F;  // m, of the contact

// A finger of 14 x 14 x 80 mm that points upward to 1 m, and lies neither below a vertex of the patch nor below an
// edge.
const BodyCollider& finger() {
    static const Obstacle post(shapes::box(Vec3d(0.010, 0.92, 0.026), Vec3d(0.024, 1, 0.040), 16));
    return post.collider;
}

// Without samples, as where the next adaptation will split the edges.
StepOptions without_samples() {
    StepOptions stepping;
    stepping.contact.offset = kFaceOffset;
    stepping.contact.floor = kNoFloor;
    stepping.contact.sample_spacing = stepping.contact.sampled_edge = 1;
    return stepping;
}

// A patch of edges of 5 cm that falls at 1.4 m/s.
Cloth falling_patch() {
    Cloth cloth = make_patch(find_fabric("jersey"), {.side = 0.2, .quads = 4, .height = 1.015, .max_level = 2});
    for (const VertexId v : cloth.mesh.leaf_vertices()) cloth.x_prev[v.value].y() += 1.4F * cloth.substep;
    refresh_contacts(cloth, without_samples().contact);
    free_standoffs(cloth, {.free = kMaxStandoff - kFaceOffset});
    return cloth;
}

Penetration penetration(const Cloth& cloth, const BodyCollider& body) {
    return find_penetration(cloth, body.surface(), {.depth = 0.0004F});
}

// The largest depth of a face in the finger until the next adaptation would split it.
float fall_on_finger(Cloth& cloth, bool is_watched) {
    float deepest = 0;
    for (int i = 0; i < 4; ++i) {
        if (is_watched && i == 0) watch_faces_near_thin_parts(cloth, finger(), kFrame);
        step(cloth, finger(), without_samples());
        deepest = std::max(deepest, penetration(cloth, finger()).deepest);
    }
    return deepest;
}

TEST(FaceContact, a_finger_does_not_pass_through_a_coarse_face) {
    Cloth watched = falling_patch(), unwatched = falling_patch();
    EXPECT_GT(fall_on_finger(unwatched, false), 0.005F);
    EXPECT_LT(fall_on_finger(watched, true), 0.0005F);
    EXPECT_FALSE(watched.solver->contacts.faces.empty());
}

TEST(FaceContact, watches_only_faces_that_can_meet_a_thin_part_in_time) {
    Cloth cloth = falling_patch();
    watch_faces_near_thin_parts(cloth, finger(), kFrame);
    const std::size_t count = cloth.solver->contacts.faces.size();
    EXPECT_GT(count, 0U);
    EXPECT_LT(count, cloth.mesh.leaf_triangles().size() / 2);
    watch_faces_near_thin_parts(cloth, finger(), 0.1F * kFrame);
    EXPECT_TRUE(cloth.solver->contacts.faces.empty());
    watch_faces_near_thin_parts(cloth, ball(), kFrame);
    EXPECT_TRUE(cloth.solver->contacts.faces.empty());
}

TEST(FaceContact, an_adaptation_that_changes_the_mesh_ends_the_watch) {
    Cloth cloth = falling_patch();
    watch_faces_near_thin_parts(cloth, finger(), kFrame);
    ASSERT_FALSE(cloth.solver->contacts.faces.empty());
    refine(cloth, 1);
    EXPECT_TRUE(cloth.solver->contacts.faces.empty());
}

// A patch of edges of 2.5 cm that lies still, with the tip of the finger 1.2 mm through one of its faces.
Cloth pierced_patch() {
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.2, .quads = 8, .height = 0.9988});
    refresh_contacts(cloth, without_samples().contact);
    free_standoffs(cloth, {});
    StepOptions stepping = without_samples();
    stepping.gravity.setZero();
    step(cloth, nothing_near(), stepping);
    forget_contacts(cloth);
    return cloth;
}

TEST(FaceContact, what_an_exact_test_finds_is_projected_out_without_a_crossing) {
    Cloth cloth = pierced_patch();
    const Penetration before = penetration(cloth, finger());
    ASSERT_GT(before.deepest, 0.001F);
    const int found = watch_faces_inside(cloth, finger(), 0.0004F);
    EXPECT_EQ(found, before.faces);
    EXPECT_EQ(cloth.solver->contacts.faces.size(), std::size_t(found));
    EXPECT_EQ(watch_faces_inside(cloth, finger(), 0.0004F), found) << "nothing has moved";
    EXPECT_EQ(cloth.solver->contacts.faces.size(), std::size_t(found)) << "each is watched once";
    StepOptions stepping = without_samples();
    stepping.self_contact.emplace();
    StrainProjectionReport report;
    for (int test = 0; test < 4 && watch_faces_inside(cloth, finger(), 0.0004F) > 0; ++test)
        report = project_strain(cloth, finger(), stepping);
    EXPECT_GT(report.iterations, 0);
    EXPECT_LE(report.deepest_face, StrainProjectionOptions{}.depth);
    EXPECT_LE(report.worst_over, StrainProjectionOptions{}.tolerance);
    EXPECT_EQ(penetration(cloth, finger()).faces, 0);
    EXPECT_TRUE(find_crossing_triangles(contact_surface(cloth), cloth.x.front().data()).empty());
    for (const VertexId v : cloth.mesh.leaf_vertices())
        EXPECT_LT((cloth.x[v.value] - cloth.x_prev[v.value]).norm(), 1e-6F) << "it gained velocity";
}

TEST(FaceContact, without_an_exact_surface_nothing_is_found_inside) {
    Cloth cloth = pierced_patch();
    EXPECT_EQ(watch_faces_inside(cloth, SphereCollider(Vec3f(0, 0.9F, 0), 0.1F), 0.0004F), 0);
}

}  // namespace
}  // namespace selvedge::sim::test
