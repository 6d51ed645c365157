#include "sim/core/printable.h"

#include <gtest/gtest.h>
#include <string>

#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

TEST(Printable, letters_of_any_script_stay_as_they_are) {
    for (const char* text : {"front_left", "Ärmel links", "袖口", "рукав", "كُمّ", "👚", ""})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, control_characters_are_escaped) {
    EXPECT_EQ(printable("a\x1b[2Jb"), "a\\x1b[2Jb");
    EXPECT_EQ(printable("one\ntwo\tthree\r"), "one\\ntwo\\tthree\\x0d");
    EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\x00b");
    EXPECT_EQ(printable("\x7f"), "\\x7f");
    EXPECT_EQ(printable("\xc2\x9b[2J"), "\\u{9b}[2J");  // a control sequence in one character
}

TEST(Printable, characters_that_reorder_text_or_end_a_line_are_escaped) {
    EXPECT_EQ(printable("a\u202eb"), "a\\u{202e}b");
    EXPECT_EQ(printable("a\u2028b"), "a\\u{2028}b");
    EXPECT_EQ(printable("a\u2066b"), "a\\u{2066}b");
}

TEST(Printable, bytes_that_are_not_utf8_are_escaped_one_by_one) {
    EXPECT_EQ(printable("a\xff"
                        "b"),
              "a\\xffb");
    EXPECT_EQ(printable("\xc3"), "\\xc3");                    // cut off
    EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");           // an overlong slash
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
    EXPECT_EQ(printable("\xf5\x80\x80\x80"), "\\xf5\\x80\\x80\\x80");
    EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");
}

TEST(Printable, a_long_text_loses_its_middle) {
    const std::string shortened = printable("begin" + std::string(2000, 'x') + "end");
    EXPECT_EQ(shortened.size(), kMostPrinted);
    EXPECT_TRUE(shortened.starts_with("begin"));
    EXPECT_TRUE(shortened.ends_with("end"));
    EXPECT_EQ(printable("abcdefgh", 7), "ab...gh");
    EXPECT_EQ(printable("abcdefg", 7), "abcdefg");
    EXPECT_EQ(printable("袖袖袖袖袖袖袖口", 5), "袖...口");
}

TEST(Printable, what_was_printable_is_not_changed_again) {
    for (const std::string& text : {std::string("a\x1b\n\xff"), std::string(5000, '\n')})
        EXPECT_EQ(printable(printable(text)), printable(text));
}

TEST(CountText, has_an_s_unless_there_is_one) {
    EXPECT_EQ(count_text(0, "edge"), "0 edges");
    EXPECT_EQ(count_text(1, "edge"), "1 edge");
    EXPECT_EQ(count_text(2, "different key"), "2 different keys");
}

TEST(InputError, its_message_is_one_short_line_and_its_parts_are_exact) {
    const std::string name = "\x1b[31mfront\n" + std::string(3000, 'y');
    const InputError error("a\nb.json", "panels." + name, "no panel '" + name + "'");
    const std::string what = error.what();
    EXPECT_TRUE(what.starts_with("a\\nb.json: panels.\\x1b[31mfront\\n")) << what;
    EXPECT_LE(what.size(), 3 * kMostPrinted + 4);
    EXPECT_EQ(what.find('\n'), std::string::npos);
    EXPECT_EQ(what.find('\x1b'), std::string::npos);
    EXPECT_EQ(error.problem(), "no panel '" + name + "'");
}

}  // namespace
}  // namespace selvedge::sim
