// The stand-in in a real window on its own X server, with synthetic mouse and keyboard input from X11.
#include <gtest/gtest.h>

#include "render/image/image.h"
#include "tests/app/edit_stand_in.h"
#include "tests/app/real_display.h"
#include "tests/app/run_program.h"
#include "tests/golden/frozen_scene.h"
#include "tests/support/checkout.h"
#include "tests/support/wait_until.h"

namespace selvedge::app {
namespace {

class WindowTest : public testing::Test {
 protected:
    void SetUp() override {
        const std::string missing = RealDisplay::missing_program();
        if (!missing.empty()) GTEST_SKIP() << missing << " is absent";
        display_ = std::make_unique<RealDisplay>(1280, 800);
        ASSERT_TRUE(display_->is_ready());
    }

    void start(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), program_folder() + "/stand_in_window");
        program_ = std::make_unique<RunningProgram>(
            arguments, std::vector<std::string>{display_->environment(), "LIBGL_ALWAYS_SOFTWARE=1"}, said_);
    }
    void click(const Vec2d& px) {
        display_->move(px);
        display_->press();
        display_->release();
    }
    bool has_title(const std::string& title) const { return program_->has_ended() || display_->title() == title; }

    ScratchFolder scratch_;
    std::string said_ = scratch_ / "said";
    std::unique_ptr<RealDisplay> display_;
    std::unique_ptr<RunningProgram> program_;
};

// The picture that the window must show at the end.
render::Image same_without_window() {
    OffscreenEditLoop loop;
    FakeEditor surface(test::make_frozen_scene());
    const auto press = [&](float x, float y) {
        editor::InputEvent event{.kind = editor::InputEvent::Kind::MouseMove, .x = x, .y = y};
        loop.step(surface, {event});
        event.kind = editor::InputEvent::Kind::MouseButton;
        for (const bool is_down : {true, false}) {
            event.is_down = is_down;
            loop.step(surface, {event});
        }
    };
    loop.step(surface);
    press(FakeEditor::kButtonX, FakeEditor::kButtonY);
    press(FakeEditor::kBoxX, FakeEditor::kButtonY);
    loop.step(surface, {{.kind = editor::InputEvent::Kind::Text, .text = "warp"}});
    loop.step(surface);
    return loop.screenshot();
}

TEST_F(WindowTest, brings_clicks_keys_text_and_the_clipboard) {
    start({});
    ASSERT_TRUE(wait_until([&] { return has_title("Stand-in, pressed 0"); }));
    click({FakeEditor::kButtonX, FakeEditor::kButtonY});
    ASSERT_TRUE(wait_until([&] { return has_title("Stand-in, pressed 1"); }));
    click({FakeEditor::kBoxX, FakeEditor::kButtonY});
    for (const char* letter : {"w", "a", "r", "p"}) display_->key(letter);
    const render::Image wanted = same_without_window();
    ASSERT_TRUE(wait_until([&] { return program_->has_ended() || display_->screenshot() == wanted; }));
    display_->key("Escape");
    ASSERT_TRUE(wait_until([&] { return program_->has_ended(); }));
    EXPECT_EQ(program_->exit_code(), 0);
    EXPECT_EQ(content_of(said_), "pressed 1 typed 'warp' clipboard 'woven' scale 1\n");
}

TEST_F(WindowTest, writes_the_times_of_its_frames) {
    start({scratch_ / "times.csv"});
    ASSERT_TRUE(wait_until([&] { return program_->has_ended(); }));
    EXPECT_EQ(program_->exit_code(), 0) << content_of(said_);
    EXPECT_EQ(count_lines(content_of(scratch_ / "times.csv")), 241);
}

TEST(WindowWithoutDisplay, is_an_input_error_in_words) {
    const ProgramResult result =
        run_command("env -u DISPLAY -u WAYLAND_DISPLAY '" + program_folder() + "/stand_in_window'");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err.rfind("window: cannot be opened: ", 0), 0U) << result.err;
}

}  // namespace
}  // namespace selvedge::app
