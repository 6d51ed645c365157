// selvedge diff: exit code 0 for equal pictures; 1 and a difference picture for different ones.
#include <gtest/gtest.h>

#include <filesystem>

#include "render/image/image.h"
#include "tests/app/selvedge_program.h"

namespace selvedge::app {
namespace {

const render::Rgba8 kGrey{128, 128, 128, 255};

class DiffCommand : public testing::Test {
 protected:
    ProgramResult diff(const render::Image& first, const render::Image& second) {
        write_png(folder_ / "a.png", first);
        write_png(folder_ / "b.png", second);
        return run_selvedge("diff '" + folder_ / "a.png" + "' '" + folder_ / "b.png" + "' -o '" + picture() + "'");
    }
    std::string picture() const { return folder_ / "difference.png"; }

 private:
    ScratchFolder folder_;
};

TEST_F(DiffCommand, equal_pictures_exit_0_and_leave_no_difference_picture) {
    EXPECT_EQ(diff(render::Image(8, 4, kGrey), render::Image(8, 4, kGrey)).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(picture()));
}

TEST_F(DiffCommand, one_pixel_exits_1_and_writes_a_difference_picture) {
    render::Image other(8, 4, kGrey);
    other.at(3, 2) = {0, 128, 128, 255};
    const ProgramResult result = diff(render::Image(8, 4, kGrey), other);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out, "");
    EXPECT_EQ(render::read_png(picture()).width_px, 8);
}

TEST_F(DiffCommand, pictures_of_two_sizes_differ) {
    EXPECT_EQ(diff(render::Image(8, 4, kGrey), render::Image(4, 8, kGrey)).exit_code, 1);
}

}  // namespace
}  // namespace selvedge::app
