// The example of docs/adding-a-format.md works.
#include <gtest/gtest.h>
#include <cstring>
#include <limits>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "tests/docs/stl_file.h"
#include "tests/sim/exchange/two_panels.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

// [test]
TEST(StlFile, holds_fifty_bytes_for_each_triangle) {
    const TemporaryFolder folder;
    write_garment(two_panels(), folder / "garment.stl", kStl);
    const std::string bytes = read_file(folder / "garment.stl", 10000);
    ASSERT_EQ(bytes.size(), 84 + 50 * two_panels().triangles.size());
    float x[3];
    std::memcpy(x, &bytes[84 + 12], sizeof x);  // after the normal
    EXPECT_EQ(Vec3f(x[0], x[1], x[2]), two_panels().x[two_panels().triangles[0][0]]);
}
// [/test]

TEST(StlFile, is_not_written_if_a_number_is_not_finite) {
    const TemporaryFolder folder;
    DrawMesh sick = two_panels();
    sick.x[3].y() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(write_garment(sick, folder / "garment.stl", kStl), InputError);
    EXPECT_FALSE(std::filesystem::exists(folder / "garment.stl"));
}

TEST(StlFile, has_an_extension_that_no_format_has) {
    for (const MeshFormat& format : mesh_formats()) EXPECT_NE(format.extension, kStl.extension);
    try {
        mesh_format_of("garment.stl");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "garment.stl: '.stl' is not a mesh format: use .obj or .glb");
    }
}

TEST(StlFile, holds_a_body_too) {
    Body body;
    body.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    body.triangles = {{0, 1, 2}};
    EXPECT_EQ(body_stl(body).size(), 84U + 50U);
}

}  // namespace
}  // namespace selvedge::sim
