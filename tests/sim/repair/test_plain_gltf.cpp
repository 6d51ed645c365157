// glTF as tools make it small: whole numbers for floats, and buffers compressed by meshoptimizer.
#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/glb_container.h"
#include "sim/repair/guarded_import.h"
#include "sim/repair/plain_gltf.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

// A corner of a tetrahedron whose edges along the axes are 1 m long, in shorts of which 32767 are 2 m.
struct Corner {
    std::array<std::int16_t, 4> x{};
};
constexpr std::int16_t kHalf = 16384;
constexpr std::array<Corner, 4> kCorners{{{{0, 0, 0, 0}}, {{kHalf, 0, 0, 0}}, {{0, kHalf, 0, 0}}, {{0, 0, kHalf, 0}}}};
constexpr std::array<std::uint16_t, 12> kTriangles{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

template <class Array>
std::string bytes_of(const Array& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0])};
}

std::string range(std::size_t offset, std::size_t length) {
    return R"("buffer": 0, "byteOffset": )" + std::to_string(offset) + R"(, "byteLength": )" + std::to_string(length);
}

struct Views {
    std::string positions, triangles;  // JSON
    std::string buffer;
};

Views stored_views() {
    const std::string corners = bytes_of(kCorners), triangles = bytes_of(kTriangles);
    return {"{" + range(0, corners.size()) + R"(, "byteStride": 8})",
            "{" + range(corners.size(), triangles.size()) + "}", corners + triangles};
}

std::string packing(std::size_t offset, const std::string& bytes, std::size_t stride, std::size_t count,
                    const std::string& mode) {
    return R"({"buffer": 1, "byteLength": )" + std::to_string(stride * count) +
           R"(, "extensions": {"EXT_meshopt_compression": {)" + range(offset, bytes.size()) + R"(, "byteStride": )" +
           std::to_string(stride) + R"(, "count": )" + std::to_string(count) + R"(, "mode": ")" + mode + R"("}}})";
}

Views compressed_views() {
    std::vector<unsigned char> corners(meshopt_encodeVertexBufferBound(kCorners.size(), sizeof(Corner)));
    corners.resize(
        meshopt_encodeVertexBuffer(corners.data(), corners.size(), kCorners.data(), kCorners.size(), sizeof(Corner)));
    std::vector<unsigned char> triangles(meshopt_encodeIndexBufferBound(kTriangles.size(), kCorners.size()));
    triangles.resize(
        meshopt_encodeIndexBuffer(triangles.data(), triangles.size(), kTriangles.data(), kTriangles.size()));
    const std::string first = bytes_of(corners), second = bytes_of(triangles);
    return {packing(0, first, sizeof(Corner), kCorners.size(), "ATTRIBUTES"),
            packing(first.size(), second, 2, kTriangles.size(), "TRIANGLES"), first + second};
}

// A tetrahedron whose node enlarges it to 2 m, which its normalized shorts are fractions of.
std::string tetrahedron(const Views& views, const std::string& more = "") {
    return glb::container(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "scale": [2, 2, 2]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5122, "normalized": true, "count": 4, "type": "VEC3",
                       "min": [0, 0, 0], "max": [16384, 16384, 16384]},
                      {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
        "bufferViews": [)" + views.positions +
                              ", " + views.triangles + R"(], "buffers": [{"byteLength": )" +
                              std::to_string(views.buffer.size()) + R"(}, {"byteLength": 56}])" + more + "}",
                          views.buffer);
}

ImportedScene imported(const std::string& content, ImportKind kind = ImportKind::Surface) {
    const TemporaryFolder folder;
    std::ofstream(folder / "body.glb", std::ios::binary) << content;
    return guarded_import(folder / "body.glb", kind);
}

std::string problem_of(const std::string& content) {
    try {
        imported(content);
    } catch (const InputError& error) {
        return error.problem();
    }
    return "";
}

void expect_tetrahedron(const ImportedScene& scene) {
    ASSERT_EQ(scene.meshes.size(), 1U);
    const ImportedMesh& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.triangles.size(), 4U);
    float volume = 0;
    for (const auto& t : mesh.triangles) volume += mesh.x[t[0]].dot(mesh.x[t[1]].cross(mesh.x[t[2]])) / 6;
    EXPECT_NEAR(volume, 1.0 / 6, 1e-4);
    for (const Vec3f& x : mesh.x) EXPECT_LT(x.maxCoeff(), 1.0001F);
}

TEST(PlainGltf, reads_a_body_at_its_true_size_when_its_positions_are_whole_numbers) {
    expect_tetrahedron(imported(tetrahedron(stored_views())));
}

// A triangle from the origin to two numbers of this type, the second of which is negative where the type has signs.
template <class Number>
std::string triangle_of(int type, bool is_normalized, Number first, Number second, const std::string& more = "") {
    const std::array<Number, 12> corners{0, 0, 0, 0, first, 0, 0, 0, 0, second, 0, 0};
    const std::string bytes = bytes_of(corners);
    return glb::container(
        R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": )" +
            std::to_string(type) + R"(, "normalized": )" + (is_normalized ? "true" : "false") +
            R"(, "count": 3, "type": "VEC3"}],
            "bufferViews": [{"buffer": 0, "byteStride": )" +
            std::to_string(4 * sizeof(Number)) + R"(, "byteLength": )" + std::to_string(bytes.size()) +
            R"(}], "buffers": [{"byteLength": )" + std::to_string(bytes.size()) + "}]" + more + "}",
        bytes);
}

TEST(PlainGltf, reads_the_numbers_that_are_meant_when_positions_are_whole_numbers_of_any_type) {
    const auto expect = [](const std::string& file, float first, float second) {
        const ImportedScene scene = imported(file);
        ASSERT_EQ(scene.meshes.size(), 1U);
        EXPECT_NEAR(scene.meshes[0].x[1].x(), first, 1e-6F);
        EXPECT_NEAR(scene.meshes[0].x[2].y(), second, 1e-6F);
    };
    expect(triangle_of<std::int8_t>(5120, true, 127, -128), 1, -1);
    expect(triangle_of<std::uint8_t>(5121, true, 255, 51), 1, 0.2F);
    expect(triangle_of<std::int16_t>(5122, true, 32767, -32768), 1, -1);
    expect(triangle_of<std::uint16_t>(5123, true, 65535, 13107), 1, 0.2F);
    expect(triangle_of<std::int8_t>(5120, false, 100, -3), 100, -3);
    expect(triangle_of<std::uint8_t>(5121, false, 200, 3), 200, 3);
    expect(triangle_of<std::int16_t>(5122, false, 300, -3), 300, -3);
    expect(triangle_of<std::uint16_t>(5123, false, 60000, 3), 60000, 3);
}

TEST(PlainGltf, names_the_accessor_when_positions_do_not_lie_in_their_view) {
    std::string file = triangle_of<std::int16_t>(5122, true, 3, 4);
    const std::size_t at = file.find("24", file.find("byteLength"));  // of the view, which stands before the buffer
    ASSERT_NE(at, std::string::npos);
    file.replace(at, 2, "16");
    EXPECT_EQ(problem_of(file), "cannot be read: accessors[0]: it is broken, sparse, or does not lie in its view");
}

TEST(PlainGltf, reads_a_body_when_the_required_extensions_change_no_shape_or_are_unknown) {
    for (const std::string name : {"KHR_texture_transform", "KHR_materials_unlit", "VRM", "MOZ_hubs_components"}) {
        const std::string required = R"(, "extensionsRequired": [")" + name + "\"]";
        EXPECT_EQ(imported(triangle_of<std::uint8_t>(5121, true, 255, 255, required)).meshes.size(), 1U) << name;
    }
}

TEST(PlainGltf, reads_the_body_that_was_compressed_when_its_buffers_are_packed) {
    expect_tetrahedron(imported(tetrahedron(compressed_views())));
}

TEST(PlainGltf, writes_no_other_file_when_all_numbers_are_floats) {
    std::array<std::array<float, 3>, 3> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    const std::string file = glb::container(
        R"({"asset": {"version": "2.0"}, "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36}],
            "extensionsRequired": ["KHR_texture_transform", "KHR_draco_mesh_compression"]})",
        bytes_of(corners));
    EXPECT_FALSE(plain_gltf("body.glb", file));
}

TEST(PlainGltf, reads_the_turns_of_an_animation_when_they_are_whole_numbers) {
    const std::array<float, 2> times{0, 1};
    const std::array<std::int16_t, 8> turns{0, 0, 0, 32767, 0, 23170, 0, 23170};  // none, a quarter round y
    const ImportedScene scene =
        imported(glb::container(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"name": "hips"}],
            "animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}],
                            "samplers": [{"input": 0, "output": 1}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR"},
                          {"bufferView": 1, "componentType": 5122, "normalized": true, "count": 2, "type": "VEC4"}],
            "bufferViews": [{"buffer": 0, "byteLength": 8}, {"buffer": 0, "byteOffset": 8, "byteLength": 16}],
            "buffers": [{"byteLength": 24}]})",
                                bytes_of(times) + bytes_of(turns)),
                 ImportKind::Motion);
    ASSERT_EQ(scene.clips.size(), 1U);
    ASSERT_EQ(scene.clips[0].tracks.size(), 1U);
    const Eigen::Quaterniond last = scene.clips[0].tracks[0].rotation.values.back();
    EXPECT_NEAR(last.angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Vec3d::UnitY()))), 0, 1e-3);
}

TEST(PlainGltf, reads_the_weights_of_a_skin_when_they_are_bytes) {
    const std::array<std::array<float, 3>, 3> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    const std::array<std::uint8_t, 12> joints{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
    const std::array<std::uint8_t, 12> weights{255, 0, 0, 0, 204, 51, 0, 0, 51, 204, 0, 0};
    const std::array<Eigen::Matrix4f, 2> inverse_binds{Eigen::Matrix4f::Identity(), Eigen::Matrix4f::Identity()};
    const ImportedScene scene =
        imported(glb::container(R"({"asset": {"version": "2.0"}, "scene": 0,
            "scenes": [{"nodes": [0, 1]}], "nodes": [{"mesh": 0, "skin": 0}, {"name": "hips", "children": [2]},
            {"name": "spine"}], "skins": [{"joints": [1, 2], "inverseBindMatrices": 3}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                          {"bufferView": 1, "componentType": 5121, "count": 3, "type": "VEC4"},
                          {"bufferView": 2, "componentType": 5121, "normalized": true, "count": 3, "type": "VEC4"},
                          {"bufferView": 3, "componentType": 5126, "count": 2, "type": "MAT4"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 12},
                            {"buffer": 0, "byteOffset": 48, "byteLength": 12},
                            {"buffer": 0, "byteOffset": 60, "byteLength": 128}],
            "buffers": [{"byteLength": 188}]})",
                                bytes_of(corners) + bytes_of(joints) + bytes_of(weights) + bytes_of(inverse_binds)));
    ASSERT_EQ(scene.meshes.size(), 1U);
    ASSERT_EQ(scene.meshes[0].skin.size(), 3U);
    const auto weight_of_spine = [&](std::size_t vertex) {
        const SkinWeights& skin = scene.meshes[0].skin[vertex];
        float sum = 0;
        for (std::size_t k = 0; k < 4; ++k)
            if (skin.weights[k] > 0 && scene.bones[skin.bones[k]].name == "spine") sum += skin.weights[k];
        return sum;
    };
    EXPECT_NEAR(weight_of_spine(0), 0, 1e-6F);
    EXPECT_NEAR(weight_of_spine(1), 0.2F, 1e-6F);
    EXPECT_NEAR(weight_of_spine(2), 0.8F, 1e-6F);
}

// A triangle whose corners hang on a hips that stands at x = 1 and on its spine, 1 m above it.
std::string skinned_triangle(const std::string& skins) {
    const std::array<std::array<float, 3>, 3> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    const std::array<std::uint8_t, 12> joints{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
    const std::array<std::array<float, 4>, 3> weights{{{1, 0, 0, 0}, {0.5F, 0.5F, 0, 0}, {0, 1, 0, 0}}};
    return glb::container(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
            "nodes": [{"mesh": 0, "skin": 0}, {"name": "hips", "translation": [1, 0, 0], "children": [2]},
                      {"name": "spine", "translation": [0, 1, 0]}], "skins": )" +
                              skins + R"(,
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                          {"bufferView": 1, "componentType": 5121, "count": 3, "type": "VEC4"},
                          {"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC4"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 12},
                            {"buffer": 0, "byteOffset": 48, "byteLength": 48}],
            "buffers": [{"byteLength": 96}]})",
                          bytes_of(corners) + bytes_of(joints) + bytes_of(weights));
}

TEST(PlainGltf, reads_skins_when_their_inverse_bind_matrices_are_left_out) {
    const ImportedScene scene = imported(skinned_triangle(R"([{"joints": [1, 2]}, {"joints": [1]}])"));
    ASSERT_EQ(scene.meshes.size(), 1U);
    ASSERT_EQ(scene.meshes[0].skin.size(), 3U);
    ASSERT_EQ(scene.meshes[0].x.size(), 3U);
    for (const char* name : {"hips", "spine"}) {
        const auto bone = std::ranges::find(scene.bones, name, &Bone::name);
        ASSERT_NE(bone, scene.bones.end()) << name;
        EXPECT_TRUE(bone->inverse_bind.isApprox(Eigen::Affine3d::Identity())) << name;
    }
}

TEST(PlainGltf, names_the_skin_when_it_has_no_joints) {
    EXPECT_EQ(problem_of(skinned_triangle("[{}]")), "cannot be read: skins[0]: it has no joints");
    EXPECT_EQ(problem_of(skinned_triangle(R"([{"joints": [1, 2]}, {"joints": 5}])")),
              "cannot be read: skins[1]: it has no joints");
}

TEST(PlainGltf, reads_a_buffer_when_the_name_of_its_file_is_escaped) {
    const std::array<std::array<float, 3>, 3> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    const TemporaryFolder folder;
    std::ofstream(folder / "body.gltf") << R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "a%20body.bin"}]})";
    EXPECT_THROW(guarded_import(folder / "body.gltf"), InputError);
    std::ofstream(folder / "a body.bin", std::ios::binary) << bytes_of(corners);
    EXPECT_EQ(guarded_import(folder / "body.gltf").meshes.at(0).x.size(), 3U);
}

TEST(PlainGltf, names_a_required_extension_when_it_changes_the_shape_and_is_not_read) {
    EXPECT_EQ(
        problem_of(tetrahedron(stored_views(), R"(, "extensionsRequired": ["EXT_mesh_gpu_instancing"])")),
        "cannot be read: extensionsRequired[0]: the extension 'EXT_mesh_gpu_instancing' is not read: save the file "
        "without it");
}

TEST(PlainGltf, names_the_view_when_its_compressed_bytes_are_broken) {
    Views views = compressed_views();
    views.buffer[0] = 'x';  // the codec's mark
    EXPECT_EQ(problem_of(tetrahedron(views)), "cannot be read: bufferViews[0]: its compressed bytes are broken");
    Views far = compressed_views();
    far.buffer.resize(8);
    EXPECT_EQ(problem_of(tetrahedron(far)), "cannot be read: bufferViews[0]: it does not lie in its buffer");
}

TEST(PlainGltf, refuses_a_view_when_meshoptimizer_must_not_be_asked_for_its_elements) {
    for (const std::string mode : {"ATTRIBUTES", "TRIANGLES", "INDICES", "OTHER"}) {
        for (const std::size_t stride : {std::size_t{0}, std::size_t{3}, std::size_t{260}}) {
            Views views = compressed_views();
            views.positions = packing(0, views.buffer, stride, 4, mode);
            EXPECT_EQ(problem_of(tetrahedron(views)),
                      "cannot be read: bufferViews[0]: such compressed elements are not read")
                << mode << stride;
        }
    }
    Views views = compressed_views();
    views.positions = packing(0, views.buffer, 8, 4'000'000'000, "ATTRIBUTES");
    EXPECT_EQ(problem_of(tetrahedron(views)), "cannot be read: bufferViews[0]: its buffers are larger than 256 MB");
}

}  // namespace
}  // namespace selvedge::sim
