// Adaptations do not move cloth through other cloth.
#include "sim/cloth/contact.h"
#include "sim/cloth/contact_guard.h"

#include <gtest/gtest.h>

#include <vector>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/contact_surface.h"
#include "sim/cloth/step.h"
#include "sim/collide/collider.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::sim::test {
namespace {

// A split edge whose centre can be removed, in a patch that is flat but for that centre.
struct Bump {
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.4, .quads = 2});
    EdgeId edge{};

    explicit Bump(float height) {
        refine(cloth, 1);
        for (const EdgeId e : cloth.mesh.split_edges(0)) {
            const std::array<TriangleId, 2>& sides = cloth.mesh.edge(e).sides;
            if (cloth.mesh.has_leaf_children(e) && sides[0] && sides[1]) edge = e;
        }
        cloth.x[cloth.mesh.centre(edge).value].y() += height;
    }
    ContactGuard guard(float clearance) const {
        return {cloth.mesh, cloth.x, std::vector<float>(cloth.x.size(), clearance)};
    }
};

TEST(ContactGuard, permits_a_rejoin_that_moves_the_cloth_by_less_than_the_clearance) {
    const Bump bump(0.003F);
    EXPECT_TRUE(bump.guard(0.0031F).permits_rejoin(bump.edge));
    EXPECT_FALSE(bump.guard(0.0029F).permits_rejoin(bump.edge));
    EXPECT_TRUE(ContactGuard(bump.cloth.mesh, bump.cloth.x, {}).permits_rejoin(bump.edge));
}

TEST(ContactGuard, a_rejoin_uses_up_the_clearance) {
    const Bump bump(0.003F);
    ContactGuard guard = bump.guard(0.005F);
    guard.note_rejoin(bump.edge);
    EXPECT_FALSE(guard.is_doubtful());
    EXPECT_FALSE(guard.permits_rejoin(bump.edge));
    guard.note_rejoin(bump.edge);
    EXPECT_TRUE(guard.is_doubtful());
}

TEST(ContactGuard, a_split_of_flat_cloth_moves_nothing) {
    Bump bump(0);
    ContactGuard guard = bump.guard(1e-6F);
    for (const EdgeId e : bump.cloth.mesh.split_edges(0)) guard.note_split(e);
    EXPECT_FALSE(guard.is_doubtful());
}

TEST(ContactGuard, a_split_that_exchanges_a_diagonal_of_bent_cloth_is_doubtful_near_other_cloth) {
    const Bump bump(0.01F);
    for (const auto& [clearance, is_doubtful] : {std::pair(0.001F, true), std::pair(0.02F, false)}) {
        ContactGuard guard = bump.guard(clearance);
        const AdaptiveTriangle& beside = bump.cloth.mesh.triangle(bump.cloth.mesh.edge(bump.edge).sides[0]);
        for (const EdgeId e : beside.edges) {
            if (e != bump.edge) guard.note_split(e);
        }
        EXPECT_EQ(guard.is_doubtful(), is_doubtful);
    }
}

// A crumpled sheet that falls on the floor in a heap, and adapts.
TEST(SelfContactOfCloth, a_pile_of_adaptive_cloth_does_not_cross_itself) {
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.5, .quads = 8, .height = 0});
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        Vec4f& x = cloth.x[v.value];
        x = Vec4f(x.x(), 0.27F - x.z(), 0.01F * std::sin(20 * x.x() + 9 * x.z()), 0);
        cloth.x_prev[v.value] = x;
    }
    const NoBody nothing;
    refresh_contacts(cloth);
    int most_leaves = 0;
    for (int frame = 0; frame < 45; ++frame) {
        adapt_cloth(cloth, nothing);
        for (int i = 0; i < 4; ++i) {
            StepOptions stepping{.self_contact = SelfContactOptions{}};
            step(cloth, nothing, stepping);
        }
        most_leaves = std::max(most_leaves, static_cast<int>(cloth.mesh.leaf_triangles().size()));
        if (frame % 5 != 4) continue;
        const ContactSurface surface = contact_surface(cloth);
        EXPECT_TRUE(find_crossing_triangles(surface, cloth.x.front().data()).empty()) << "frame " << frame;
    }
    EXPECT_GT(most_leaves, 2 * static_cast<int>(cloth.mesh.base_triangle_count()));
}

TEST(ContactSurface, holds_every_leaf_and_edge_once) {
    Cloth cloth = make_patch(find_fabric("cotton_shirting"), {.side = 0.4, .quads = 4});
    refine(cloth, 2);
    const ContactSurface surface = contact_surface(cloth);
    EXPECT_EQ(surface.triangles.size(), cloth.mesh.leaf_triangles().size());
    EXPECT_EQ(surface.edges.size(), cloth.mesh.leaf_edges().size());
    for (const ContactTriangle& triangle : surface.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::array<std::uint32_t, 2>& ends = surface.edges[triangle.edges[k]].ends;
            EXPECT_EQ(std::minmax(ends[0], ends[1]), std::minmax(triangle.vertices[k], triangle.vertices[(k + 1) % 3]));
        }
    }
}

}  // namespace
}  // namespace selvedge::sim::test
