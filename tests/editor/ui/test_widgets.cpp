#include <gtest/gtest.h>
#include <algorithm>

#include "editor/frame/item.h"
#include "editor/ui/widgets.h"

namespace selvedge::editor {
namespace {

// Width function for the tests: every byte has width 1.
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

constexpr double kFrame = 0.25;  // s

void let_pass(MessageClock& clock, Messages& messages, double seconds) {
    for (double left = seconds; left > 0; left -= kFrame) clock.update(messages, kFrame);
}

TEST(MessageClock, a_note_makes_room_for_the_hint_after_a_while) {
    MessageClock clock;
    Messages messages;
    messages.note("Saved");
    let_pass(clock, messages, 5);
    EXPECT_NE(messages.shown(), nullptr);
    let_pass(clock, messages, 2);
    EXPECT_EQ(messages.shown(), nullptr);
}

TEST(MessageClock, a_new_note_has_its_own_time) {
    MessageClock clock;
    Messages messages;
    messages.note("Saved");
    let_pass(clock, messages, 5);
    messages.note("Copied");
    let_pass(clock, messages, 5);
    ASSERT_NE(messages.shown(), nullptr);
    EXPECT_EQ(messages.shown()->text, "Copied");
}

TEST(MessageClock, an_error_stays) {
    MessageClock clock;
    Messages messages;
    messages.say({.kind = MessageKind::Error, .text = "That cannot be", .places = {}});
    let_pass(clock, messages, 600);
    EXPECT_NE(messages.shown(), nullptr);
}

}  // namespace

}  // namespace selvedge::editor
