// Bodies of files in the store: what lies in two files is not kept by the content of one.
#include "sim/repair/stored_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "sim/core/content_store.h"
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
        const double before = height_of(load_stored_body(folder / name, {}, &store).body);
        write_buffer(folder / "tetrahedron.bin", 1.9F);
        EXPECT_GT(height_of(load_stored_body(folder / name, {}, &store).body), before + 0.1) << name;
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder / "store"));
}

}  // namespace
}  // namespace selvedge::sim
