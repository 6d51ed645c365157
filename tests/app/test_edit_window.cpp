// The editor in a real window: opened, used, closed and killed from outside. A second editor without a window receives
// the same events; it provides widget positions, expected pictures and the expected file.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/editor_services.h"
#include "editor/ui/files.h"
#include "render/image/image.h"
#include "tests/app/real_display.h"
#include "tests/support/checkout.h"
#include "tests/support/wait_until.h"

namespace selvedge::app {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 1280, kHeight = 800;
const Vec2d kAside(1200, 700);  // px: no widget there reacts to the mouse

// The reference editor without a window: receives the same events, and waits for its body.
class Rehearsal {
 public:
    explicit Rehearsal(const fs::path& state, const std::string& file = {})
        : editor_(make_editor_services({.state = state, .render_full_quality = {}}),
                  {.drive = sim::SessionDrive::Caller, .fonts = read_fonts(), .is_steady = true}),
          surface_(editor_) {
        if (!file.empty()) open_loaded(editor_.state(), sim::load_pattern(file), file);
        move(kAside);
    }

    void move(const Vec2d& px) {
        at_ = px;
        send(editor::InputEvent::Kind::MouseMove, false);
    }
    void press() { send(editor::InputEvent::Kind::MouseButton, true); }
    void release() { send(editor::InputEvent::Kind::MouseButton, false); }
    // Until the 3D view's picture is smooth: it rests for 5 frames, then 16 add their samples.
    void rest() {
        for (int i = 0; i < 30; ++i) loop_.step(surface_);
    }
    editor::AppState& state() { return editor_.state(); }
    void undo() { editor_.state().workspace.document->undo(); }

    Vec2d vertex_px(const std::string& panel, std::size_t vertex) const {
        const editor::PanelShape& shape = *editor_.state().tools.geometry().find(panel);
        return editor_.sheet_to_px(shape.on_sheet(shape.panel.vertices[vertex]));
    }
    Vec2d widget_px(const std::string& name) const {
        const auto found = editor_.state().widgets.find(name);
        return found == editor_.state().widgets.end() ? Vec2d(0, 0) : Vec2d(found->second.centre().cast<double>());
    }
    render::Image picture() const { return loop_.screenshot(); }
    std::string text() const { return editor_.state().workspace.document->text(); }

 private:
    void send(editor::InputEvent::Kind kind, bool is_down) {
        const auto x = static_cast<float>(std::lround(at_.x())), y = static_cast<float>(std::lround(at_.y()));
        loop_.step(surface_, {{.kind = kind, .x = x, .y = y, .is_down = is_down}});
        rest();
    }

    OffscreenEditLoop loop_{{.width_px = kWidth, .height_px = kHeight}};
    editor::Editor editor_;
    EditorSurface surface_;
    Vec2d at_{0, 0};
};

struct Columns {
    int low = 0;
    int high = kWidth;
};

// Allows some different pixels at the ends of lines, which depend on rounding.
bool is_same(const render::Image& a, const render::Image& b, const Columns& columns = {}) {
    constexpr int kMaxOther = 200;
    if (a.width_px != b.width_px || a.height_px != b.height_px) return false;
    int other = 0;
    for (int y = 0; y < a.height_px; ++y) {
        for (int x = columns.low; x < columns.high; ++x) other += a.at(x, y) != b.at(x, y) ? 1 : 0;
    }
    return other <= kMaxOther;
}

class EditWindowTest : public testing::Test {
 protected:
    void SetUp() override {
        const std::string missing = RealDisplay::missing_program();
        if (!missing.empty()) GTEST_SKIP() << missing << " is absent";
        display_ = std::make_unique<RealDisplay>(kWidth, kHeight);
        ASSERT_TRUE(display_->is_ready());
        fs::copy_file(source_folder() + "/patterns/skirt.json", file_);
    }

    void start(const std::string& title = "skirt.json - Selvedge") {
        program_.reset();
        program_ = std::make_unique<RunningProgram>(
            std::vector<std::string>{program_folder() + "/selvedge", "edit", file_, "--state", state_, "--scale", "1"},
            std::vector<std::string>{display_->environment(), "LIBGL_ALWAYS_SOFTWARE=1"}, scratch_ / "said");
        ASSERT_TRUE(waits_for_title(title)) << content_of(scratch_ / "said");
        display_->move(kAside);
    }

    bool waits_for_title(const std::string& title) {
        return wait_until([&] { return display_->title() == title || program_->has_ended(); }) &&
               display_->title() == title;
    }

    bool waits_to_show(const render::Image& wanted, const Columns& columns = {}) {
        const bool is_shown = wait_until([&] { return is_same(display_->screenshot(), wanted, columns); });
        if (!is_shown) keep_pictures(wanted);
        return is_shown;
    }

    // Waits until something moves in the 3D view.
    bool waits_to_run() {
        const render::Image before = display_->screenshot();
        display_->key("space");
        return wait_until([&] { return !is_same(display_->screenshot(), before, kViewport); });
    }

    // Drags the front's lower corner to a new position. Leaves the button pressed.
    void drag_corner(Rehearsal& rehearsal) const {
        const Vec2d from = rehearsal.vertex_px("front", 0);
        for (const Vec2d& way : {Vec2d(0, 0), Vec2d(-9, 4), Vec2d(-21, 13), Vec2d(-33, 30)}) {
            rehearsal.move(from + way);
            display_->move(from + way);
            if (!way.isZero()) continue;
            rehearsal.press();
            display_->press();
        }
    }

    // Restarts the editor, accepts the offered recovery and saves; returns the file's content.
    std::string recovered() {
        const std::string copy = scratch_ / "state_of_rehearsal";
        fs::copy(state_, copy, fs::copy_options::recursive);
        Rehearsal rehearsal(copy, file_);
        start();
        EXPECT_TRUE(waits_to_show(rehearsal.picture())) << "the offer";
        display_->move(rehearsal.widget_px("answer.Recover"));
        display_->press();
        display_->release();
        EXPECT_TRUE(waits_for_title("skirt.json* - Selvedge"));
        display_->key_with("ctrl", "s");
        EXPECT_TRUE(waits_for_title("skirt.json - Selvedge"));
        return content_of(file_);
    }

    // Writes pictures for inspection.
    void keep_pictures(const render::Image& wanted) const {
        const std::string folder = testing::TempDir() + "/";
        write_png(folder + "edit_window.out.png", display_->screenshot());
        write_png(folder + "edit_window.wanted.png", wanted);
    }

    // px: the two views at this window size, without their borders.
    static constexpr Columns kSheet{60, 480}, kViewport{520, 930};

    ScratchFolder scratch_;
    std::string file_ = scratch_ / "skirt.json";
    std::string state_ = scratch_ / "state";
    std::unique_ptr<RealDisplay> display_;
    std::unique_ptr<RunningProgram> program_;
};

TEST_F(EditWindowTest, opens_a_file_moves_a_vertex_undoes_simulates_saves_and_quits) {
    Rehearsal rehearsal(scratch_ / "other_state", file_);
    const std::string first = content_of(file_), as_written = rehearsal.text();
    start();
    ASSERT_TRUE(waits_to_show(rehearsal.picture()));

    drag_corner(rehearsal);
    rehearsal.release();
    display_->release();
    ASSERT_TRUE(waits_for_title("skirt.json* - Selvedge"));
    ASSERT_TRUE(waits_to_show(rehearsal.picture()));
    const std::string moved = rehearsal.text();
    EXPECT_NE(moved, as_written);

    display_->key_with("ctrl", "z");
    ASSERT_TRUE(waits_for_title("skirt.json - Selvedge")) << "as it was";
    display_->key_with("ctrl", "y");
    ASSERT_TRUE(waits_for_title("skirt.json* - Selvedge"));
    EXPECT_EQ(content_of(file_), first) << "nothing is saved yet";

    ASSERT_TRUE(waits_to_run());
    display_->key_with("ctrl", "s");
    ASSERT_TRUE(waits_for_title("skirt.json - Selvedge"));
    EXPECT_EQ(content_of(file_), moved);
    ASSERT_TRUE(waits_to_show(rehearsal.picture(), kSheet)) << "the sheet stands still while the cloth moves";

    display_->key_with("ctrl", "q");
    ASSERT_TRUE(wait_until([&] { return program_->has_ended(); }));
    EXPECT_EQ(program_->exit_code(), 0) << content_of(scratch_ / "said");
    EXPECT_TRUE(fs::is_empty(fs::path(state_) / "journals")) << "nothing is left to recover";
}

TEST_F(EditWindowTest, what_was_seen_of_a_drag_is_recovered_when_the_program_is_killed_during_it) {
    Rehearsal rehearsal(scratch_ / "other_state", file_);
    const std::string as_written = rehearsal.text();
    start();
    drag_corner(rehearsal);
    ASSERT_TRUE(waits_to_show(rehearsal.picture(), kSheet));
    program_->kill_hard();
    display_->release();
    const std::string dragged = rehearsal.text();
    EXPECT_NE(dragged, as_written);
    EXPECT_EQ(recovered(), dragged);
}

TEST_F(EditWindowTest, edits_are_recovered_when_the_program_is_killed_while_it_simulates) {
    Rehearsal rehearsal(scratch_ / "other_state", file_);
    start();
    drag_corner(rehearsal);
    rehearsal.release();
    display_->release();
    ASSERT_TRUE(waits_to_show(rehearsal.picture()));
    ASSERT_TRUE(waits_to_run());
    program_->kill_hard();
    EXPECT_EQ(recovered(), rehearsal.text());
}

TEST_F(EditWindowTest, a_file_that_is_no_garment_opens_the_window_which_says_so) {
    std::ofstream(file_) << "{ \"pattern\": 3 }";
    start("untitled - Selvedge");
    Rehearsal rehearsal(scratch_ / "other_state");
    take_dropped_file(rehearsal.state(), file_);
    rehearsal.rest();
    EXPECT_TRUE(waits_to_show(rehearsal.picture())) << "the message";
    display_->key_with("ctrl", "q");
    ASSERT_TRUE(wait_until([&] { return program_->has_ended(); }));
    EXPECT_EQ(program_->exit_code(), 0) << content_of(scratch_ / "said");
}

}  // namespace
}  // namespace selvedge::app
