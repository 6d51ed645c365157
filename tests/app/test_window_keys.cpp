#include "app/window.h"

#include <gtest/gtest.h>

namespace selvedge::app {
namespace {

TEST(WindowKeys, letters_are_those_that_the_layout_writes) {
    EXPECT_EQ(key_of_code('Q', "a"), editor::Key('A')) << "a French keyboard";
    EXPECT_EQ(key_of_code('Q', ""), editor::Key('Q'));
    EXPECT_EQ(key_of_code('1', "&"), editor::Key('1'));
    EXPECT_EQ(key_of_code(';', "\xC3\xB6"), editor::Key(';')) << "a letter that has no key of its own";
}

TEST(WindowKeys, others_are_known_by_their_place) {
    EXPECT_EQ(key_of_code(256, ""), editor::Key::Escape);
    EXPECT_EQ(key_of_code(269, ""), editor::Key::End);
    EXPECT_EQ(key_of_code(335, ""), editor::Key::KeypadEnter);
    EXPECT_EQ(key_of_code(341, ""), editor::Key::None) << "a modifier";
    EXPECT_EQ(key_of_code(-1, ""), editor::Key::None);
    EXPECT_EQ(key_of_code(280, ""), editor::Key::None) << "caps lock";
}

TEST(WindowKeys, text_is_utf8) {
    EXPECT_EQ(utf8_of('a'), "a");
    EXPECT_EQ(utf8_of(0xE9), "\xC3\xA9");
    EXPECT_EQ(utf8_of(0x20AC), "\xE2\x82\xAC");
    EXPECT_EQ(utf8_of(0x1F9F5), "\xF0\x9F\xA7\xB5");
}

}  // namespace
}  // namespace selvedge::app
