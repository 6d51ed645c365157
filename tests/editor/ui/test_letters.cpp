// The letters that text needs beyond the basic ones.
#include "editor/frame/letters.h"

#include <gtest/gtest.h>

namespace selvedge::editor {
namespace {

Letters letters_of(std::string_view text) {
    Letters letters;
    add_letters(text, letters);
    return letters;
}

TEST(Letters, those_of_other_scripts_are_collected_once_and_latin_ones_never) {
    EXPECT_EQ(letters_of("front \u00e9\u2026\u2192"), Letters{});
    EXPECT_EQ(letters_of("\u524d\u8eab\u524d, \u043f\u0435"), (Letters{0x524D, 0x8EAB, 0x43F, 0x435}));
}

TEST(Letters, what_is_no_utf8_and_what_imgui_cannot_hold_is_left_out) {
    EXPECT_EQ(letters_of("\xFF\x80\xC3"), Letters{});
    EXPECT_EQ(letters_of("\xE5\x89"), Letters{}) << "cut off";
    EXPECT_EQ(letters_of("\xE5\x89\u03c0"), Letters{0x3C0}) << "the letter after a broken one";
    EXPECT_EQ(letters_of("\U0001F455"), Letters{}) << "above U+FFFF";
}

}  // namespace
}  // namespace selvedge::editor
