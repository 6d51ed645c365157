#include "app/edit_loop.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <fstream>

#include "editor/frame/theme.h"
#include "tests/app/run_program.h"

namespace selvedge::app {
namespace {

void lay_down(const std::filesystem::path& file) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << "font";
}

TEST(FindFont, the_first_family_that_is_there_is_taken) {
    const ScratchFolder scratch;
    const std::filesystem::path root = scratch.path();
    EXPECT_TRUE(find_fonts({root / "absent", root}).regular.empty());
    lay_down(root / "truetype/dejavu/DejaVuSans.ttf");
    EXPECT_EQ(find_fonts({root}).regular, root / "truetype/dejavu/DejaVuSans.ttf");
    EXPECT_EQ(find_fonts({root}).medium, root / "truetype/dejavu/DejaVuSans.ttf");
    lay_down(root / "opentype/inter/Inter-Regular.otf");
    EXPECT_EQ(find_fonts({root}).regular, root / "opentype/inter/Inter-Regular.otf");
    EXPECT_EQ(find_fonts({root}).medium, root / "opentype/inter/Inter-Regular.otf") << "it has no medium here";
    lay_down(root / "opentype/inter/Inter-Medium.otf");
    EXPECT_EQ(find_fonts({root}).medium, root / "opentype/inter/Inter-Medium.otf");
}

TEST(TabularDigits, have_one_width_that_is_the_widest_ones) {
    const FontFiles files = find_fonts();
    if (files.regular.empty()) GTEST_SKIP() << "no font is installed";
    ImFontAtlas atlas;
    ImFont* font = atlas.AddFontFromFileTTF(files.regular.c_str(), 32);
    atlas.Build();
    const auto width = [&](const char* text) { return font->CalcTextSizeA(32, 1e6F, 0, text).x; };
    const float letters = width("seam");
    float widest = 0;
    for (const char* digit : {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"})
        widest = std::max(widest, width(digit));
    editor::make_digits_tabular(*font);
    for (const char* digit : {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"})
        EXPECT_EQ(width(digit), widest) << digit;
    EXPECT_EQ(width("seam"), letters);
}

}  // namespace
}  // namespace selvedge::app
