// Bodies of files in the store: found as they were made; what lies in two files is not kept by the content of one.
#include "sim/repair/stored_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "sim/core/content_store.h"
#include "sim/repair/body_bytes.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

void write_buffer(const std::filesystem::path& file, float height) {
    const std::array<float, 12> x{0, 0, 0, 1, 0, 0, 0, height, 0, 0, 0, 0.3F};
    const std::array<std::uint16_t, 12> corners{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    std::ofstream buffer(file, std::ios::binary);
    buffer.write(reinterpret_cast<const char*>(x.data()), sizeof x);
    buffer.write(reinterpret_cast<const char*>(corners.data()), sizeof corners);
}

void write_tetrahedron(const std::filesystem::path& file) {
    std::ofstream(file) << R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0],
                       "max": [1, 2, 0.3]},
                      {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
        "buffers": [{"byteLength": 72, "uri": "tetrahedron.bin"}]})";
}

// A tetrahedron on two bones, of which the upper one turns, as one binary file.
void write_turning_tetrahedron(const std::filesystem::path& file) {
    std::string json = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0, "skin": 0}, {"name": "Hips", "children": [2]},
                  {"name": "Chest", "translation": [0, 0.8, 0]}],
        "skins": [{"joints": [1, 2], "inverseBindMatrices": 6}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 2, "WEIGHTS_0": 3}, "indices": 1}]}],
        "animations": [{"name": "sway", "samplers": [{"input": 4, "output": 5}],
                        "channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0],
                       "max": [1, 2, 0.3]},
                      {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"},
                      {"bufferView": 2, "componentType": 5123, "count": 4, "type": "VEC4"},
                      {"bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC4"},
                      {"bufferView": 4, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
                      {"bufferView": 5, "componentType": 5126, "count": 2, "type": "VEC4"},
                      {"bufferView": 6, "componentType": 5126, "count": 2, "type": "MAT4"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24},
                        {"buffer": 0, "byteOffset": 72, "byteLength": 32},
                        {"buffer": 0, "byteOffset": 104, "byteLength": 64},
                        {"buffer": 0, "byteOffset": 168, "byteLength": 8},
                        {"buffer": 0, "byteOffset": 176, "byteLength": 32},
                        {"buffer": 0, "byteOffset": 208, "byteLength": 128}],
        "buffers": [{"byteLength": 336}]})";
    json.resize((json.size() + 3) / 4 * 4, ' ');
    write_buffer(file, 1.7F);
    std::ifstream surface(file, std::ios::binary);
    std::string data(std::istreambuf_iterator<char>(surface), {});
    std::swap_ranges(data.begin() + 50, data.begin() + 52, data.begin() + 52);  // one triangle faces inward: a note
    const auto add = [](std::string& bytes, const auto& items) {
        bytes.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof items[0]);
    };
    add(data, std::array<std::uint16_t, 16>{0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0});
    add(data, std::array<float, 16>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    add(data, std::array<float, 10>{0, 1, 0, 0, 0, 1, 0, 0, 0.6F, 0.8F});
    for (const float height : {0.0F, 0.8F})
        add(data, std::array<float, 16>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -height, 0, 1});
    std::string glb = "glTF";
    add(glb,
        std::array<std::uint32_t, 3>{2, std::uint32_t(28 + json.size() + data.size()), std::uint32_t(json.size())});
    glb += "JSON" + json;
    add(glb, std::array<std::uint32_t, 1>{std::uint32_t(data.size())});
    glb += std::string("BIN\0", 4) + data;
    std::ofstream(file, std::ios::binary | std::ios::trunc) << glb;
}

double height_of(const Body& body) {
    double height = 0;
    for (const Vec3d& p : body.x) height = std::max(height, p.y());
    return height;
}

TEST(StoredBody, of_a_gltf_follows_from_its_buffers_whatever_the_case_of_its_ending) {
    const TemporaryFolder folder;
    const ContentStore store(folder / "store", "test", 1 << 28);
    for (const char* name : {"small.gltf", "LARGE.GLTF"}) {
        write_tetrahedron(folder / name);
        write_buffer(folder / "tetrahedron.bin", 1.7F);
        std::vector<std::string> notes;
        const double before = height_of(load_stored_body(folder / name, {}, &store, notes).body);
        write_buffer(folder / "tetrahedron.bin", 1.9F);
        EXPECT_GT(height_of(load_stored_body(folder / name, {}, &store, notes).body), before + 0.1) << name;
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder / "store"));
}

TEST(StoredBody, has_the_same_bits_clips_and_notes_when_it_is_found_again) {
    const TemporaryFolder folder;
    const ContentStore store(folder / "store", "test", 1 << 28);
    const std::filesystem::path file = folder / "turning.glb";
    write_turning_tetrahedron(file);
    std::vector<std::string> made_notes, found_notes{"an earlier one"};
    const BodyClips made = load_stored_body(file, {}, nullptr, made_notes);
    load_stored_body(file, {}, &store, made_notes);
    ASSERT_FALSE(std::filesystem::is_empty(folder / "store"));
    const BodyClips found = load_stored_body(file, {}, &store, found_notes);
    EXPECT_EQ(to_bytes(found.body), to_bytes(made.body));
    ASSERT_EQ(made.clips.size(), 1U);
    ASSERT_EQ(made.clips[0].tracks.size(), 1U);
    ASSERT_EQ(found.clips.size(), 1U);
    FlatWriter made_clip, found_clip;
    write(made_clip, made.clips[0]);
    write(found_clip, found.clips[0]);
    EXPECT_EQ(found_clip.bytes(), made_clip.bytes());
    ASSERT_FALSE(made_notes.empty());
    made_notes.resize(made_notes.size() / 2);
    made_notes.insert(made_notes.begin(), "an earlier one");
    EXPECT_EQ(found_notes, made_notes);
}

}  // namespace
}  // namespace selvedge::sim
