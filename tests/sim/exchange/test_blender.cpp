// Animation caches as Blender reads them. Skipped where Blender is not installed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "sim/core/file.h"
#include "sim/core/json.h"
#include "sim/exchange/mesh_cache.h"
#include "sim/exchange/mesh_file.h"
#include "tests/sim/exchange/two_panels.h"
#include "tests/support/checkout.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kFrames = 5;

std::vector<Vec3f> frame_of(const DrawMesh& mesh, std::size_t frame) {
    std::vector<Vec3f> x = mesh.x;
    for (std::size_t v = 0; v < x.size(); ++v) x[v].z() += 0.01F * static_cast<float>(frame * (v + 1));
    return x;
}

Json positions_json(const std::vector<Vec3f>& x) {
    Json all = Json::array();
    for (const Vec3f& p : x) all.push_back(Json::array({double(p.x()), double(p.y()), double(p.z())}));
    return all;
}

// What tests/sim/exchange/check_in_blender.py compares with.
Json expected_json(const DrawMesh& mesh, int first_frame) {
    Json pc2 = Json::array(), glb = Json::array();
    for (std::size_t frame = 0; frame < kFrames; ++frame) {
        const std::vector<Vec3f> x = frame_of(mesh, frame);
        std::vector<Vec3f> by_part;
        for (const PanelPart& part : split_by_panel(mesh))
            for (const std::uint32_t v : part.vertices) by_part.push_back(x[v]);
        pc2.push_back(positions_json(x));
        glb.push_back(positions_json(by_part));
    }
    Json expected = Json::object();
    expected["first_frame"] = first_frame;
    expected["pc2"] = std::move(pc2);
    expected["glb"] = std::move(glb);
    return expected;
}

TEST(Blender, reads_the_caches_as_they_were_written) {
    if (std::system("command -v blender >/dev/null 2>&1") != 0) GTEST_SKIP() << "blender is not installed";
    const TemporaryFolder folder;
    const DrawMesh mesh = two_panels();
    const CacheOptions options{.frames = kFrames, .first_frame = 11};
    for (const char* name : {"cache.pc2", "cache.glb"}) {
        const auto cache = open_mesh_cache(folder / name, mesh, options);
        for (std::size_t frame = 0; frame < kFrames; ++frame) cache->add(frame_of(mesh, frame));
        cache->finish();
    }
    write_file_atomically(folder / "expected.json", write_json(expected_json(mesh, options.first_frame)));
    const std::string command = "blender --background --factory-startup --python-exit-code 1 --python '" +
                                source_folder() + "/tests/sim/exchange/check_in_blender.py' -- '" +
                                (folder / "").string() + "' 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace selvedge::sim
