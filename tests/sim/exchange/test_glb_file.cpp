#include "sim/exchange/glb_file.h"

#include <gtest/gtest.h>

#include <cstring>

#include "sim/core/json.h"
#include "tests/sim/exchange/two_panels.h"

namespace selvedge::sim {
namespace {

std::uint32_t word_at(const std::string& bytes, std::size_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}

struct Container {
    Json root;
    std::string buffer;
};

// Splits the container into its chunks and checks it against chapter 4.4 of the glTF 2.0 specification.
Container open(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word_at(bytes, 4), 2U);
    EXPECT_EQ(word_at(bytes, 8), bytes.size());
    const std::size_t json_length = word_at(bytes, 12);
    EXPECT_EQ(json_length % 4, 0U);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    const std::size_t binary = 20 + json_length;
    EXPECT_EQ(word_at(bytes, binary) % 4, 0U);
    EXPECT_EQ(bytes.substr(binary + 4, 4), std::string("BIN\0", 4));
    EXPECT_EQ(binary + 8 + word_at(bytes, binary), bytes.size());
    return {parse_json(bytes.substr(20, json_length), "test.glb"), bytes.substr(binary + 8)};
}

std::size_t index_of(const Json& json, const char* key) {
    return std::size_t(json.find(key)->number());
}

std::size_t element_bytes(const Json& accessor) {
    const int component = int(accessor.find("componentType")->number());
    const std::string type = accessor.find("type")->string();
    const std::size_t count = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
    return count * (component == 5123 ? 2 : 4);
}

// Each accessor fills its buffer view; each view is inside the buffer at an offset that is a multiple of 4.
void expect_sound_accessors(const Container& file) {
    const auto& views = file.root.find("bufferViews")->elements();
    EXPECT_EQ(index_of(file.root.find("buffers")->elements()[0], "byteLength"), file.buffer.size());
    for (const Json& accessor : file.root.find("accessors")->elements()) {
        const Json& view = views.at(index_of(accessor, "bufferView"));
        EXPECT_EQ(index_of(view, "byteOffset") % 4, 0U);
        EXPECT_LE(index_of(view, "byteOffset") + index_of(view, "byteLength"), file.buffer.size());
        EXPECT_EQ(index_of(accessor, "count") * element_bytes(accessor), index_of(view, "byteLength"));
    }
}

float float_at(const Container& file, const Json& accessor, std::size_t index) {
    const Json& view = file.root.find("bufferViews")->elements().at(index_of(accessor, "bufferView"));
    float value = 0;
    std::memcpy(&value, file.buffer.data() + index_of(view, "byteOffset") + index * sizeof value, sizeof value);
    return value;
}

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

TEST(GlbFile, gives_texture_coordinates_in_metres_with_v_downward) {
    const Container file = open(garment_glb(two_panels()));
    const auto& primitive = file.root.find("meshes")->elements()[0].find("primitives")->elements()[1];
    const Json& u = file.root.find("accessors")->elements()[index_of(*primitive.find("attributes"), "TEXCOORD_0")];
    EXPECT_EQ(float_at(file, u, 0), -0.7F);
    EXPECT_EQ(float_at(file, u, 1), 1 - 0.013F);
}

TEST(GlbFile, states_the_bounds_of_positions_to_the_bit) {
    PlainMesh mesh = two_panels();
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
