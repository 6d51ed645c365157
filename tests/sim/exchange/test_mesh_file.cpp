#include <gtest/gtest.h>
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>

#include "sim/body/load_body.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/exchange/mesh_file.h"
#include "tests/sim/exchange/two_panels.h"
#include "tests/support/bodies.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kLimit = 1 << 24;

// Compares corners and not vertices, because reading may renumber the vertices.
void expect_same_garment(const PlainMesh& read, const PlainMesh& written, float tolerance) {
    ASSERT_EQ(read.triangles.size(), written.triangles.size());
    ASSERT_EQ(read.u.size(), written.u.size());
    EXPECT_EQ(read.x.size(), written.x.size());
    EXPECT_EQ(read.panel, written.panel);
    EXPECT_EQ(read.panel_grain_angles, written.panel_grain_angles);
    EXPECT_EQ(read.panel_sett_offsets, written.panel_sett_offsets);
    for (std::size_t t = 0; t < read.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(read.x[read.triangles[t][k]], written.x[written.triangles[t][k]]);
            EXPECT_LE((read.u[t][k] - written.u[t][k]).norm(), tolerance);
        }
}

TEST(MeshFile, a_garment_comes_back_from_obj_as_it_went) {
    const TemporaryFolder folder;
    write_garment(two_panels(), folder / "garment.obj");
    const PlainMesh read = read_garment(folder / "garment.obj");
    expect_same_garment(read, two_panels(), 0);
    EXPECT_EQ(read.panel_names, (std::vector<std::string>{"front", "left_sleeve"}));
}

TEST(MeshFile, a_garment_comes_back_from_glb_as_it_went) {
    const TemporaryFolder folder;
    write_garment(two_panels(), folder / "garment.glb");
    const PlainMesh read = read_garment(folder / "garment.glb");
    expect_same_garment(read, two_panels(), 2e-7F);  // v is converted to 1 - v twice
    EXPECT_EQ(read.panel_names, two_panels().panel_names);
}

TEST(MeshFile, a_garment_without_material_coordinates_or_panels_comes_back) {
    const TemporaryFolder folder;
    PlainMesh mesh = two_panels();
    mesh.u.clear();
    mesh.panel.clear();
    mesh.normals.clear();
    for (const char* name : {"bare.obj", "bare.glb"}) {
        write_garment(mesh, folder / name);
        const PlainMesh read = read_garment(folder / name);
        EXPECT_EQ(read.x.size(), mesh.x.size()) << name;
        EXPECT_EQ(read.triangles.size(), mesh.triangles.size()) << name;
        EXPECT_TRUE(read.u.empty()) << name;
        EXPECT_EQ(read.normals.size(), read.x.size()) << name;
        EXPECT_EQ(read.panel_names.size(), 1U) << name;
    }
}

Body figure() {
    Body body = shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 4);
    body.name = "figure";
    body.bones = {{"hips", -1, {0, 0.9, 0}}, {"spine", 0, {0, 1.2, 0.02}}, {"head", 1, {0, 1.5, 0}}};
    for (const Vec3d& p : body.x) {
        const float up = float(p.y() / 1.7);
        body.skin.push_back({{0, 2, 0, 0}, {1 - up, up, 0, 0}});
    }
    return body;
}

TEST(MeshFile, a_body_comes_back_with_its_skeleton_from_glb) {
    const TemporaryFolder folder;
    write_body(figure(), folder / "body.glb");
    const Body body = load_body(folder / "body.glb");
    ASSERT_EQ(body.x.size(), figure().x.size());
    EXPECT_EQ(body.triangles, figure().triangles);
    ASSERT_EQ(body.bones.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(body.bones[i].name, figure().bones[i].name);
        EXPECT_EQ(body.bones[i].parent, figure().bones[i].parent);
        EXPECT_LT((body.bones[i].joint - figure().bones[i].joint).norm(), 1e-6);
    }
    for (std::size_t v = 0; v < body.x.size(); ++v) {
        EXPECT_LT((body.x[v] - figure().x[v]).norm(), 1e-6);
        float head = 0;
        for (std::size_t k = 0; k < 4; ++k)
            if (body.skin[v].bones[k] == 2) head += body.skin[v].weights[k];
        EXPECT_NEAR(head, figure().x[v].y() / 1.7, 1e-6);
    }
}

TEST(MeshFile, a_body_comes_back_from_obj) {
    const TemporaryFolder folder;
    write_body(figure(), folder / "body.obj");
    const Body body = load_body(folder / "body.obj");
    EXPECT_EQ(body.x.size(), figure().x.size());
    EXPECT_TRUE(shapes::is_closed(body));
    EXPECT_NEAR(shapes::volume(body), shapes::volume(figure()), 1e-6);
}

TEST(MeshFile, the_same_mesh_gives_the_same_bytes) {
    const TemporaryFolder folder;
    for (const char* name : {"garment.obj", "garment.glb"}) {
        write_garment(two_panels(), folder / name);
        const std::string first = read_file(folder / name, kLimit);
        write_garment(two_panels(), folder / name);
        EXPECT_EQ(read_file(folder / name, kLimit), first);
    }
}

TEST(MeshFile, what_cannot_be_written_is_refused_and_leaves_the_old_file) {
    const TemporaryFolder folder;
    write_garment(two_panels(), folder / "garment.obj");
    const std::string old = read_file(folder / "garment.obj", kLimit);
    PlainMesh sick = two_panels();
    sick.x[3].y() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(write_garment(sick, folder / "garment.obj"), InputError);
    EXPECT_THROW(write_garment(PlainMesh{}, folder / "garment.obj"), InputError);
    EXPECT_EQ(read_file(folder / "garment.obj", kLimit), old);
    EXPECT_THROW(write_garment(two_panels(), folder / "garment.fbx"), InputError);
    EXPECT_THROW(write_body(Body{}, folder / "body.glb"), InputError);
    EXPECT_THROW(write_garment(two_panels(), folder / "no_such_folder/garment.obj"), InputError);
}

TEST(MeshFile, readers_survive_bytes_changed_anywhere) {
    const TemporaryFolder folder;
    write_garment(two_panels(), folder / "garment.glb");
    write_body(figure(), folder / "body.glb");
    std::mt19937 random(29);
    for (int round = 0; round < 80; ++round) {
        const bool is_body = round % 2 == 0;
        std::string content = read_file(folder / (is_body ? "body.glb" : "garment.glb"), kLimit);
        // Half of the changes are in the first 2,500 bytes (the JSON), where they have most effect.
        const std::size_t range = round % 4 < 2 ? content.size() : std::min<std::size_t>(content.size(), 2500);
        for (unsigned i = 0; i <= random() % 3; ++i) content[random() % range] = char(random());
        std::ofstream(folder / "mutant.glb", std::ios::binary) << content;
        try {
            if (is_body) {
                EXPECT_TRUE(shapes::is_closed(load_body(folder / "mutant.glb"))) << round;
            } else {
                for (const Vec3f& p : read_garment(folder / "mutant.glb").x) EXPECT_TRUE(p.allFinite()) << round;
            }
        } catch (const InputError&) {
        }
    }
}

TEST(PanelParts, part_a_garment_by_panel_and_double_the_vertices_of_its_seams) {
    const std::vector<PanelPart> parts = split_by_panel(two_panels());
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].name, "front");
    EXPECT_EQ(parts[1].name, "left sleeve");
    EXPECT_EQ(parts[1].grain_angle, 0.7853982F);
    for (const PanelPart& part : parts) {
        EXPECT_EQ(part.vertices.size(), 4U);
        EXPECT_EQ(part.triangles.size(), 2U);
    }
    EXPECT_EQ(parts[1].vertices, (std::vector<std::uint32_t>{1, 4, 5, 2}));
}

TEST(PanelParts, double_a_vertex_whose_corners_disagree_within_one_panel) {
    // A dart: both sides belong to the same panel.
    PlainMesh mesh = two_panels();
    mesh.panel.clear();
    const std::vector<PanelPart> parts = split_by_panel(mesh);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].vertices.size(), 8U);
    for (std::size_t t = 0; t < 4; ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t corner = parts[0].triangles[t][k];
            EXPECT_EQ(parts[0].vertices[corner], mesh.triangles[t][k]);
            EXPECT_EQ(parts[0].u[corner], mesh.u[t][k]);
        }
}

TEST(PanelParts, leave_out_panels_without_triangles) {
    PlainMesh mesh = two_panels();
    for (std::uint16_t& panel : mesh.panel) panel = 1;
    const std::vector<PanelPart> parts = split_by_panel(mesh);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].name, "left sleeve");
}

}  // namespace

}  // namespace selvedge::sim
