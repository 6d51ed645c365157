// The timeline under the 3D view, by mouse and keys, in an editor without a window.
#include <gtest/gtest.h>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "editor/ui/editor.h"
#include "editor/ui/files.h"
#include "sim/pattern/pattern_file.h"
#include "tests/editor/ui/services_without_files.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
namespace {

class Timeline : public testing::Test {
 protected:
    Timeline() {
        const auto file = std::filesystem::path(source_folder()) / "patterns" / "two_squares.json";
        open_loaded(editor_.state(), sim::load_pattern(file), file.string());
        drape().options().max_level = 0;
        rest(3);
    }
    void step(const std::vector<InputEvent>& events) {
        editor_.frame(events, {.width_px = 1280, .height_px = 800}, 1.0 / 30);
    }
    void rest(int frames) {
        for (int i = 0; i < frames; ++i) step({});
    }
    void key(Key key, Modifiers modifiers = {}) {
        step({{.kind = InputEvent::Kind::Key, .key = key, .is_down = true, .modifiers = modifiers}});
        step({{.kind = InputEvent::Kind::Key, .key = key, .is_down = false, .modifiers = {}}});
        rest(1);
    }
    void move(const Vec2f& px) {
        at_ = px;
        step({{.kind = InputEvent::Kind::MouseMove, .x = px.x(), .y = px.y()}});
        rest(1);
    }
    void button(bool is_down) {
        step({{.kind = InputEvent::Kind::MouseButton, .x = at_.x(), .y = at_.y(), .is_down = is_down}});
        rest(1);
    }
    void click(const std::string& widget) {
        move(editor_.state().widgets.at(widget).centre());
        button(true);
        button(false);
    }
    bool is_shown() const { return editor_.state().widgets.contains("timeline.track"); }
    void settle() {
        drape().session().start();
        drape().session().advance(600);
        ASSERT_EQ(drape().frame()->stage, sim::SessionStage::Settled);
    }
    Drape& drape() { return editor_.state().workspace.drape; }
    sim::SessionMotion motion() { return drape().frame()->motion; }

    Editor editor_{services_without_files(), {.drive = sim::SessionDrive::Caller, .is_steady = true}};
    Vec2f at_{0, 0};  // px
};

TEST_F(Timeline, is_shown_and_hidden_by_its_key) {
    EXPECT_FALSE(is_shown());
    key(Key::F8);
    EXPECT_TRUE(is_shown());
    key(Key::F8);
    EXPECT_FALSE(is_shown());
}

TEST_F(Timeline, plays_and_pauses_a_motion_that_was_chosen_and_goes_back) {
    settle();
    key(Key::F8);
    click("motion.play");
    EXPECT_FALSE(motion().is_playing) << "there is no motion";
    click("timeline.motion");
    rest(2);
    click("timeline.motion.walk");
    rest(2);
    EXPECT_GT(motion().length, 0.5);
    click("motion.play");
    EXPECT_TRUE(motion().is_playing);
    rest(60);
    EXPECT_GT(motion().seconds, 0.1);
    key(Key::Space, {.shift = true});
    EXPECT_FALSE(motion().is_playing);
    EXPECT_TRUE(drape().frame()->is_running) << "the simulation goes on";
    EXPECT_FALSE(motion().is_at_rest);
    click("motion.start");
    rest(1);
    EXPECT_TRUE(motion().is_at_rest);
    EXPECT_EQ(motion().seconds, 0);
}

TEST_F(Timeline, seeks_where_it_is_dragged_and_plays_on_where_it_is_let_go) {
    settle();
    key(Key::F8);
    drape().choose_motion("walk");
    drape().play();
    rest(70);
    ASSERT_TRUE(motion().is_playing);
    const WidgetMap::mapped_type track = editor_.state().widgets.at("timeline.track");
    const Vec2f middle = track.centre();
    move(middle);
    button(true);
    EXPECT_FALSE(motion().is_playing);
    EXPECT_NEAR(motion().seconds, motion().length / 2, 0.02);
    move(middle + Vec2f(4000, 0));
    EXPECT_GT(motion().seconds, 0.98 * motion().length);
    move(middle - Vec2f(4000, 0));
    EXPECT_EQ(motion().seconds, 0);
    button(false);
    EXPECT_TRUE(motion().is_playing);
    rest(60);
    EXPECT_NE(drape().frame()->stage, sim::SessionStage::Failed);
}

TEST_F(Timeline, plays_at_another_speed_and_once) {
    settle();
    key(Key::F8);
    drape().choose_motion("walk");
    rest(2);
    click("timeline.speed");
    rest(2);
    click("timeline.speed.0.50");
    click("motion.loop");
    EXPECT_EQ(drape().activity().playback.speed, 0.5);
    EXPECT_FALSE(drape().activity().playback.is_loop);
}

}  // namespace
}  // namespace selvedge::editor
