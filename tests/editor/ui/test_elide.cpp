#include "editor/ui/elide.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace selvedge {
namespace {

// Each byte is as wide as the next.
float bytes(std::string_view text) {
    return static_cast<float>(text.size());
}

TEST(Elide, what_fits_stays_as_it_is) {
    EXPECT_EQ(elided("front", 5, Elide::End, bytes), "front");
    EXPECT_EQ(elided("", 0, Elide::Middle, bytes), "");
}

TEST(Elide, a_sentence_loses_its_end) {
    EXPECT_EQ(elided("one and two", 8, Elide::End, bytes), "one a...");
}

TEST(Elide, a_path_loses_its_middle) {
    EXPECT_EQ(elided("/patterns/summer/skirt.json", 15, Elide::Middle, bytes), "/patte...t.json");
}

TEST(Elide, letters_of_several_bytes_stay_whole) {
    for (float width = 3; width < 12; ++width) {
        const std::string shown = elided("\u00e9\u00e9\u00e9\u00e9\u00e9\u00e9", width, Elide::Middle, bytes);
        EXPECT_LE(bytes(shown), std::max(3.0F, width));
        EXPECT_EQ((shown.size() - (shown.size() < 12 ? 3 : 0)) % 2, 0U) << shown;
    }
}

TEST(Elide, where_there_is_no_room_the_dots_are_left) {
    EXPECT_EQ(elided("front", 0, Elide::Middle, bytes), "...");
    EXPECT_EQ(elided("front", 0, Elide::End, bytes), "...");
}

}  // namespace
}  // namespace selvedge
