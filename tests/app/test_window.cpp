// The stand-in in a real window on its own X server, with synthetic mouse and keyboard input from X11.
#include <gtest/gtest.h>

#include <fstream>

#include "render/image/image.h"
#include "tests/app/edit_stand_in.h"
#include "tests/app/run_program.h"
#include "tests/golden/frozen_scene.h"

namespace selvedge::app {
namespace {

bool has_program(const std::string& name) {
    return run_command("command -v " + name).exit_code == 0;
}

// Presses last 80 ms, because shorter ones are missed. The window may need some time to get the keyboard focus.
constexpr const char* kHands = R"(
program=$1; shift
press() { xdotool mousemove "$1" "$2"; sleep 0.1; xdotool mousedown 1; sleep 0.08; xdotool mouseup 1; sleep 0.1; }
key() { xdotool keydown "$1"; sleep 0.08; xdotool keyup "$1"; sleep 0.05; }
"$program" "$@" & pid=$!
if [ $# = 0 ]; then
    for i in $(seq 100); do xdotool search --name Stand-in >/dev/null 2>&1 && break; sleep 0.1; done
    sleep 1
    press 60 700
    press 300 695
    for letter in w a r p; do key $letter; done
    import -window root shot.png
    key Escape
fi
wait $pid
)";

class WindowTest : public testing::Test {
 protected:
    void SetUp() override {
        for (const char* program : {"xvfb-run", "xdotool", "import"}) {
            if (!has_program(program)) GTEST_SKIP() << program << " is absent";
        }
        std::ofstream(scratch_ / "hands.sh") << kHands;
    }

    ProgramResult run(const std::string& arguments) {
        return run_command("cd '" + scratch_.path().string() +
                           "' && timeout 60 xvfb-run -a -s '-screen 0 1280x800x24'" +
                           " bash hands.sh " SELVEDGE_STAND_IN " " + arguments);
    }

    ScratchFolder scratch_;
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
    press(60, 700);
    press(300, 695);
    loop.step(surface, {{.kind = editor::InputEvent::Kind::Text, .text = "warp"}});
    loop.step(surface);
    return loop.screenshot();
}

TEST_F(WindowTest, brings_clicks_keys_text_and_the_clipboard) {
    const ProgramResult result = run("");
    EXPECT_EQ(result.out, "pressed 1 typed 'warp' clipboard 'woven' scale 1\n");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(render::read_png(scratch_ / "shot.png") == same_without_window());
}

TEST_F(WindowTest, writes_the_times_of_its_frames) {
    const ProgramResult result = run("times.csv");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(count_lines(content_of(scratch_ / "times.csv")), 241);
}

TEST(WindowWithoutDisplay, is_an_input_error_in_words) {
    const ProgramResult result = run_command("env -u DISPLAY -u WAYLAND_DISPLAY " SELVEDGE_STAND_IN);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err.rfind("window: cannot be opened: ", 0), 0U) << result.err;
}

}  // namespace
}  // namespace selvedge::app
