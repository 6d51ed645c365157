#include "editor/ui/message_clock.h"

#include <gtest/gtest.h>

namespace selvedge {
namespace {

constexpr double kFrame = 0.25;  // s

void let_pass(MessageClock& clock, Messages& messages, double seconds) {
    for (double left = seconds; left > 0; left -= kFrame) clock.follow(messages, kFrame);
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
    EXPECT_EQ(messages.shown()->words, "Copied");
}

TEST(MessageClock, an_error_stays) {
    MessageClock clock;
    Messages messages;
    messages.say({.kind = MessageKind::Error, .words = "That cannot be", .places = {}});
    let_pass(clock, messages, 600);
    EXPECT_NE(messages.shown(), nullptr);
}

}  // namespace
}  // namespace selvedge
