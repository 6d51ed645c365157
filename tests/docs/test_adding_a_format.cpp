// The example of docs/adding-a-format.md works.
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "tests/docs/off_file.h"
#include "tests/sim/exchange/two_panels.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

// [test]
TEST(OffFile, holds_the_vertices_and_triangles_of_a_garment) {
    const TemporaryFolder folder;
    write_garment(two_panels(), folder / "garment.off", kOff);
    const std::string text = read_file(folder / "garment.off", 10000);
    EXPECT_TRUE(text.starts_with("OFF\n# Selvedge: metres, y up\n6 4 0\n0 1 0\n0.1 1 0\n")) << text;
    EXPECT_TRUE(text.ends_with("\n3 1 4 5\n3 1 5 2\n")) << text;
}
// [/test]

TEST(OffFile, is_not_written_if_a_number_is_not_finite) {
    const TemporaryFolder folder;
    DrawMesh sick = two_panels();
    sick.x[3].y() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(write_garment(sick, folder / "garment.off", kOff), InputError);
    EXPECT_FALSE(std::filesystem::exists(folder / "garment.off"));
}

TEST(OffFile, has_an_extension_that_no_format_has) {
    for (const MeshFormat& format : mesh_formats()) EXPECT_NE(format.extension, kOff.extension);
    try {
        mesh_format_of("garment.off");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "garment.off: '.off' is not a mesh format: use .obj, .glb, .ply or .stl");
    }
}

TEST(OffFile, holds_a_body_too) {
    Body body;
    body.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    body.triangles = {{0, 1, 2}};
    EXPECT_EQ(body_off(body), "OFF\n# Selvedge: metres, y up\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
}

}  // namespace
}  // namespace selvedge::sim
