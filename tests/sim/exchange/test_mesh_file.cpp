#include <gtest/gtest.h>
#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <locale>
#include <random>
#include <sstream>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/json.h"
#include "sim/exchange/glb_file.h"
#include "sim/exchange/mesh_file.h"
#include "sim/exchange/obj_text.h"
#include "sim/repair/guarded_import.h"
#include "sim/repair/load_body.h"
#include "tests/sim/exchange/file_bytes.h"
#include "tests/sim/exchange/glb_container.h"
#include "tests/sim/exchange/two_panels.h"
#include "tests/support/bodies.h"
#include "tests/support/processor_time.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

// Compares corners and not vertices, because reading may renumber the vertices.
void expect_same_garment(const DrawMesh& read, const DrawMesh& written, float tolerance) {
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
    const DrawMesh read = read_garment(folder / "garment.obj");
    expect_same_garment(read, two_panels(), 0);
    EXPECT_EQ(read.panel_names, (std::vector<std::string>{"front", "left_sleeve"}));
}

TEST(MeshFile, a_garment_comes_back_from_glb_as_it_went) {
    const TemporaryFolder folder;
    write_garment(two_panels(), folder / "garment.glb");
    const DrawMesh read = read_garment(folder / "garment.glb");
    expect_same_garment(read, two_panels(), 2e-7F);  // v is converted to 1 - v twice
    EXPECT_EQ(read.panel_names, two_panels().panel_names);
}

TEST(MeshFile, a_file_of_many_groups_and_comments_is_read_in_time_that_grows_with_its_size) {
    constexpr int kGroups = 20'000, kComments = 20;  // 4e5 comments; comparing each with each name takes a minute
    std::string text;
    for (int g = 0; g < kGroups; ++g) {
        const std::string x = std::to_string(0.01 * g);
        text += "g panel_of_many_" + std::to_string(g) + '\n';
        for (int k = 0; k < kComments; ++k)
            text += "# grain_angle " + std::to_string(k == kComments - 1 ? g % 3 : 7) + '\n';
        text += "v " + x + " 0 0\nv " + x + " 1 0\nv " + x + " 0 1\nf -3 -2 -1\n";
    }
    const TemporaryFolder folder;
    std::ofstream(folder / "many.obj") << text;
    const double before = processor_seconds();
    const DrawMesh read = read_garment(folder / "many.obj");
    EXPECT_LT(processor_seconds() - before, 10);
    ASSERT_EQ(read.panel_names.size(), std::size_t(kGroups));
    EXPECT_EQ(read.panel_grain_angles[4], 1) << "of several angles, the last";
}

// Corner by corner, the normal on the triangle's right side.
std::vector<Vec3f> right_side_normals(const DrawMesh& mesh) {
    std::vector<Vec3f> normals;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3f& normal = mesh.normals[mesh.triangles[t][k]];
            normals.push_back(is_turned(mesh, t, k) ? Vec3f(-normal) : normal);
        }
    }
    return normals;
}

TEST(MeshFile, each_panel_keeps_its_right_side_where_a_seam_joins_right_to_wrong) {
    const TemporaryFolder folder;
    const DrawMesh mesh = sewn_right_to_wrong();
    ASSERT_FALSE(mesh.turned_corners.empty());
    for (const char* name : {"garment.obj", "garment.glb"}) {
        write_garment(mesh, folder / name);
        const DrawMesh read = read_garment(folder / name);
        expect_same_garment(read, mesh, 2e-7F);
        const std::vector<Vec3f> found = right_side_normals(read), expected = right_side_normals(mesh);
        for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_LT((found[i] - expected[i]).norm(), 1e-5F) << name;
    }
    // Every corner names a normal on its triangle's right side: the front's look forward, the sleeve's back.
    std::istringstream lines(garment_obj(mesh));
    std::vector<float> z;
    std::size_t faces = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("vn ")) z.push_back(std::stof(line.substr(line.rfind(' '))));
        if (!line.starts_with("f ")) continue;
        const std::size_t normal = std::stoul(line.substr(line.rfind('/') + 1));
        EXPECT_GT((faces++ < 2 ? 1 : -1) * z.at(normal - 1), 0.5F) << line;
    }
    EXPECT_EQ(faces, 4U);
}

TEST(MeshFile, a_garment_without_material_coordinates_or_panels_comes_back) {
    const TemporaryFolder folder;
    DrawMesh mesh = two_panels();
    mesh.u.clear();
    mesh.panel.clear();
    mesh.normals.clear();
    for (const char* name : {"bare.obj", "bare.glb"}) {
        write_garment(mesh, folder / name);
        const DrawMesh read = read_garment(folder / name);
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
    const Body original = figure();
    write_body(original, folder / "body.glb");
    const Body body = load_body(folder / "body.glb");
    ASSERT_EQ(body.x.size(), original.x.size());
    ASSERT_EQ(body.triangles.size(), original.triangles.size());
    ASSERT_EQ(body.bones.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(body.bones[i].name, original.bones[i].name);
        EXPECT_EQ(body.bones[i].parent, original.bones[i].parent);
        EXPECT_LT((body.bones[i].joint - original.bones[i].joint).norm(), 1e-6);
    }
    // By corner: assimp 5.4 numbers the vertices in the order in which triangles name them.
    for (std::size_t t = 0; t < body.triangles.size(); ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::size_t v = body.triangles[t][corner];
            const Vec3d should = original.x[original.triangles[t][corner]];
            EXPECT_LT((body.x[v] - should).norm(), 1e-6);
            float head = 0;
            for (std::size_t k = 0; k < 4; ++k)
                if (body.skin[v].bones[k] == 2) head += body.skin[v].weights[k];
            EXPECT_NEAR(head, should.y() / 1.7, 1e-6);
        }
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
    DrawMesh sick = two_panels();
    sick.x[3].y() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(write_garment(sick, folder / "garment.obj"), InputError);
    EXPECT_THROW(write_garment(DrawMesh{}, folder / "garment.obj"), InputError);
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
    DrawMesh mesh = two_panels();
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
    DrawMesh mesh = two_panels();
    for (std::uint16_t& panel : mesh.panel) panel = 1;
    const std::vector<PanelPart> parts = split_by_panel(mesh);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].name, "left sleeve");
}

}  // namespace

namespace {

std::vector<std::string> lines_with(const std::string& text, const std::string& start) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(start)) lines.push_back(line);
    return lines;
}

TEST(ObjText, writes_positions_and_material_coordinates_in_metres_and_a_group_per_panel) {
    const std::string text = garment_obj(two_panels());
    EXPECT_EQ(lines_with(text, "v "), (std::vector<std::string>{"v 0 1 0", "v 0.1 1 0", "v 0.1 1.3 0", "v 0 1.3 0",
                                                                "v 0.2 1 -0.05", "v 0.2 1.3 -0.05"}));
    EXPECT_EQ(lines_with(text, "g "), (std::vector<std::string>{"g front", "g left_sleeve"}));
    EXPECT_EQ(lines_with(text, "vt ").size(), 8U);
    EXPECT_EQ(lines_with(text, "vt ")[4], "vt -0.7 0.013");
    EXPECT_EQ(lines_with(text, "f "), (std::vector<std::string>{"f 1/1/1 2/2/2 3/3/3", "f 1/1/1 3/3/3 4/4/4",
                                                                "f 2/5/2 5/6/5 6/7/6", "f 2/5/2 6/7/6 3/8/3"}));
}

TEST(ObjText, keeps_every_bit_of_a_float) {
    DrawMesh mesh = two_panels();
    mesh.x[0] = {0.1F + 0.2F, 1.0F / 3, 1e-7F};
    std::istringstream line(lines_with(garment_obj(mesh), "v ")[0].substr(2));
    for (const float expected : mesh.x[0]) {
        std::string word;
        line >> word;
        EXPECT_EQ(std::stof(word), expected);
    }
}

struct CommaLocale : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(ObjText, is_the_same_in_any_locale) {
    const std::string expected = garment_obj(two_panels());
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaLocale));
    const std::string text = garment_obj(two_panels());
    std::locale::global(before);
    EXPECT_EQ(text, expected);
}

TEST(ObjText, gives_back_the_grain_angles_that_it_wrote) {
    const auto angles = grain_angles_in_obj(garment_obj(two_panels()));
    ASSERT_EQ(angles.size(), 2U);
    EXPECT_EQ(angles[0], (std::pair<std::string, float>("front", 0.0F)));
    EXPECT_EQ(angles[1], (std::pair<std::string, float>("left_sleeve", 0.7853982F)));
    EXPECT_TRUE(grain_angles_in_obj("g a\nf 1 2 3\n# grain_angle many\n# grain_angle").empty());
}

TEST(ObjText, gives_back_the_sett_offsets_that_it_wrote_where_there_are_any) {
    const auto offsets = sett_offsets_in_obj(garment_obj(two_panels()));
    ASSERT_EQ(offsets.size(), 1U);
    EXPECT_EQ(offsets[0], (std::pair<std::string, Vec2f>("left_sleeve", Vec2f(0.0123F, -0.05F))));
    EXPECT_TRUE(
        sett_offsets_in_obj("g a\n# sett_offset 1\n# sett_offset 1 x\n# sett_offset nan 1\n# sett_offset").empty());
}

TEST(ObjText, writes_a_body_as_one_group) {
    Body body;
    body.name = "mannequin female";
    body.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    body.triangles = {{0, 1, 2}};
    const std::string text = body_obj(body);
    EXPECT_EQ(lines_with(text, "g "), (std::vector<std::string>{"g mannequin_female"}));
    EXPECT_EQ(lines_with(text, "vn ")[0], "vn 0 0 1");
    EXPECT_EQ(lines_with(text, "f ")[0], "f 1//1 2//2 3//3");
}

}  // namespace

namespace {

Body small_skinned_body() {
    Body body;
    body.name = "figure";
    body.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    body.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    body.bones = {{"hips", -1, {0, 0.2, 0}}, {"spine", 0, {0, 0.5, 0.1}}, {"other_root", -1, {1, 0, 0}}};
    body.skin.resize(4);
    for (SkinWeights& skin : body.skin) {
        skin.bones = {1, 2, 7, 9};
        skin.weights = {0.75F, 0.25F, 0, 0};
    }
    return body;
}

TEST(GlbFile, of_a_garment_is_sound_and_has_a_primitive_per_panel) {
    const Container file = open(garment_glb(two_panels()));
    expect_sound_accessors(file);
    const auto& primitives = file.root.find("meshes")->elements()[0].find("primitives")->elements();
    ASSERT_EQ(primitives.size(), 2U);
    EXPECT_EQ(primitives[1].find("extras")->find("panel")->string(), "left sleeve");
    const auto& materials = file.root.find("materials")->elements();
    EXPECT_EQ(materials[index_of(primitives[1], "material")].find("name")->string(), "left sleeve");
    EXPECT_TRUE(materials[0].find("doubleSided")->boolean());
}

TEST(GlbFile, has_the_panels_in_the_unit_square_as_its_first_texture_coordinates) {
    const AtlasOptions atlas{.size_px = 256, .margin_px = 16};
    const Container file = open(garment_glb(two_panels(), {.atlas = atlas}));
    std::vector<PanelPart> parts = split_by_panel(two_panels());
    pack_panels(parts, atlas);
    for (std::size_t panel = 0; panel < 2; ++panel) {
        const auto& primitive = file.root.find("meshes")->elements()[0].find("primitives")->elements()[panel];
        const Json& uv = file.root.find("accessors")->elements()[index_of(*primitive.find("attributes"), "TEXCOORD_0")];
        const std::vector<Vec2f> expected = packed_uv(parts[panel]);
        ASSERT_EQ(index_of(uv, "count"), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const Vec2f found(float_at(file, uv, 2 * i), float_at(file, uv, 2 * i + 1));
            EXPECT_GE(found.minCoeff(), 16 / 256.0F - 1e-6F);
            EXPECT_LE(found.maxCoeff(), 1 - 16 / 256.0F + 1e-6F);
            EXPECT_EQ(found, Vec2f(expected[i].x(), 1 - expected[i].y()));
        }
    }
}

TEST(GlbFile, without_material_coordinates_has_no_texture_coordinates) {
    DrawMesh bare = two_panels();
    bare.u.clear();
    EXPECT_EQ(garment_glb(bare).find("TEXCOORD"), std::string::npos);
}

TEST(GlbFile, gives_back_the_charts_that_it_wrote_and_no_bad_ones) {
    std::vector<PanelPart> parts = split_by_panel(two_panels());
    pack_panels(parts, {});
    std::string bytes = garment_glb(two_panels());
    const auto charts = charts_in_glb(bytes, "test.glb");
    ASSERT_EQ(charts.size(), 2U);
    EXPECT_EQ(charts[1], (std::pair<std::string, UvChart>("left sleeve", *parts[1].chart)));
    const std::size_t scale = bytes.find("\"scale\":") + 8;
    bytes.replace(scale, 3, "0e1");  // now zero: the rest of its digits follow the exponent
    EXPECT_EQ(charts_in_glb(bytes, "test.glb").size(), 1U);
}

TEST(GlbFile, gives_material_coordinates_in_metres_with_v_downward) {
    const Container file = open(garment_glb(two_panels()));
    const auto& primitive = file.root.find("meshes")->elements()[0].find("primitives")->elements()[1];
    const Json& u = file.root.find("accessors")->elements()[index_of(*primitive.find("attributes"), "TEXCOORD_1")];
    EXPECT_EQ(float_at(file, u, 0), -0.7F);
    EXPECT_EQ(float_at(file, u, 1), 1 - 0.013F);
}

GarmentExport with_textures() {
    return {.textures = {.base_colour = std::string("\x89PNG\r\n\x1A\n12345", 13),
                         .normal = std::string("\x89PNG\r\n\x1A\n67", 10)}};
}

TEST(ObjFile, with_textures_has_packed_coordinates_that_read_back_as_metres) {
    const TemporaryFolder folder;
    write_garment(two_panels(), folder / "my garment.obj", with_textures());
    expect_same_garment(read_garment(folder / "my garment.obj"), two_panels(), 1e-6F);
    const std::string text = read_file(folder / "my garment.obj", kLimit);
    EXPECT_NE(text.find("mtllib my_garment.mtl\n"), std::string::npos);
    const std::string materials = read_file(folder / "my_garment.mtl", kLimit);
    EXPECT_NE(materials.find("map_Kd my_garment_colour.png\nnorm my_garment_normal.png\n"), std::string::npos);
    EXPECT_EQ(read_file(folder / "my_garment_colour.png", kLimit), with_textures().textures.base_colour);
    EXPECT_EQ(read_file(folder / "my_garment_normal.png", kLimit), with_textures().textures.normal);
    EXPECT_EQ(paths_beside(folder / "my garment.obj").size(), 3U);
    EXPECT_TRUE(paths_beside(folder / "my garment.glb").empty());
}

TEST(ObjFile, has_the_body_beside_the_garment_and_gives_the_garment_back) {
    const TemporaryFolder folder;
    const Body body = small_skinned_body();
    GarmentExport content = with_textures();
    content.body = &body;
    for (const char* name : {"garment.obj", "garment.glb"}) {
        write_garment(two_panels(), folder / name, content);
        std::size_t triangles = 0;
        for (const ImportedMesh& mesh : guarded_import(folder / name).meshes) triangles += mesh.triangles.size();
        EXPECT_EQ(triangles, two_panels().triangles.size() + body.triangles.size()) << name;
        expect_same_garment(read_garment(folder / name), two_panels(), 1e-6F);
    }
}

TEST(GlbFile, holds_its_textures_and_every_material_shows_them) {
    GarmentExport content = with_textures();
    const Container file = open(garment_glb(two_panels(), content));
    expect_sound_accessors(file);
    const Json& images = *file.root.find("images");
    ASSERT_EQ(images.elements().size(), 2U);
    const Json& view = file.root.find("bufferViews")->elements()[index_of(images.elements()[0], "bufferView")];
    EXPECT_EQ(file.buffer.substr(index_of(view, "byteOffset"), index_of(view, "byteLength")),
              content.textures.base_colour);
    for (const Json& material : file.root.find("materials")->elements()) {
        EXPECT_EQ(index_of(*material.find("pbrMetallicRoughness")->find("baseColorTexture"), "index"), 0U);
        EXPECT_EQ(index_of(*material.find("normalTexture"), "index"), 1U);
    }
    EXPECT_EQ(file.root.find("textures")->elements().size(), 2U);
}

TEST(GlbFile, states_the_bounds_of_positions_to_the_bit) {
    DrawMesh mesh = two_panels();
    mesh.x[4].x() = 0.1F + 0.2F;
    const Container file = open(garment_glb(mesh));
    const auto& primitive = file.root.find("meshes")->elements()[0].find("primitives")->elements()[1];
    const Json& x = file.root.find("accessors")->elements()[index_of(*primitive.find("attributes"), "POSITION")];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        float low = float_at(file, x, axis), high = low;
        for (std::size_t v = 1; v < index_of(x, "count"); ++v) {
            low = std::min(low, float_at(file, x, 3 * v + axis));
            high = std::max(high, float_at(file, x, 3 * v + axis));
        }
        EXPECT_EQ(float(x.find("min")->elements()[axis].number()), low);
        EXPECT_EQ(float(x.find("max")->elements()[axis].number()), high);
    }
}

TEST(GlbFile, of_a_body_has_joints_under_one_root_and_binds_that_undo_them) {
    const Body body = small_skinned_body();
    const Container file = open(body_glb(body));
    expect_sound_accessors(file);
    const auto& nodes = file.root.find("nodes")->elements();
    ASSERT_EQ(nodes.size(), 5U);
    EXPECT_EQ(nodes[1].find("name")->string(), "armature");
    EXPECT_EQ(nodes[1].find("children")->elements().size(), 2U);
    EXPECT_EQ(float(nodes[3].find("translation")->elements()[1].number()), float(0.5 - 0.2));
    const Json& skin = file.root.find("skins")->elements()[0];
    EXPECT_EQ(index_of(skin, "skeleton"), 1U);
    const Json& binds = file.root.find("accessors")->elements()[index_of(skin, "inverseBindMatrices")];
    EXPECT_EQ(float_at(file, binds, 16 + 13), -0.5F);  // column-major: y translation of the second bone
    EXPECT_EQ(float_at(file, binds, 16 + 15), 1.0F);
}

TEST(GlbFile, names_no_bone_where_none_pulls) {
    const Container file = open(body_glb(small_skinned_body()));
    const auto& primitive = file.root.find("meshes")->elements()[0].find("primitives")->elements()[0];
    const Json& joints = file.root.find("accessors")->elements()[index_of(*primitive.find("attributes"), "JOINTS_0")];
    const Json& view = file.root.find("bufferViews")->elements()[index_of(joints, "bufferView")];
    std::array<std::uint16_t, 4> bones{};
    std::memcpy(bones.data(), file.buffer.data() + index_of(view, "byteOffset"), sizeof bones);
    EXPECT_EQ(bones, (std::array<std::uint16_t, 4>{1, 2, 0, 0}));
}

TEST(GlbFile, of_a_body_without_bones_has_no_skin) {
    Body body = small_skinned_body();
    body.bones.clear();
    body.skin.clear();
    const Container file = open(body_glb(body));
    expect_sound_accessors(file);
    EXPECT_FALSE(file.root.find("skins"));
    EXPECT_EQ(file.root.find("nodes")->elements().size(), 1U);
}

TEST(GlbFile, gives_back_the_sett_offsets_that_it_wrote_where_there_are_any) {
    const auto offsets = sett_offsets_in_glb(garment_glb(two_panels()), "test.glb");
    ASSERT_EQ(offsets.size(), 1U);
    EXPECT_EQ(offsets[0], (std::pair<std::string, Vec2f>("left sleeve", Vec2f(0.0123F, -0.05F))));
}

TEST(GlbFile, gives_back_the_grain_angles_that_it_wrote) {
    const auto angles = grain_angles_in_glb(garment_glb(two_panels()), "test.glb");
    ASSERT_EQ(angles.size(), 2U);
    EXPECT_EQ(angles[1], (std::pair<std::string, float>("left sleeve", 0.7853982F)));
}

}  // namespace

}  // namespace selvedge::sim
