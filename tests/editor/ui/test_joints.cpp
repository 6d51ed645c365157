// A pose turned by hand is saved and found again, by mouse and script, in an editor without a window.
#include <gtest/gtest.h>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "editor/inspectors/motion_names.h"
#include "editor/ui/editor.h"
#include "editor/ui/files.h"
#include "editor/ui/script.h"
#include "sim/core/atomic_file.h"
#include "sim/motion/motion_file.h"
#include "sim/pattern/pattern_file.h"
#include "tests/editor/ui/services_without_files.h"
#include "tests/support/checkout.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::editor {
namespace {

class JointsInEditor : public testing::Test {
 protected:
    JointsInEditor() {
        const auto file = std::filesystem::path(source_folder()) / "patterns" / "two_squares.json";
        open_loaded(editor_.state(), sim::load_pattern(file), file.string());
        drape().options().max_level = 0;
        play("frames 3\nclick widget tab.Body\nframes 2\n");
    }
    Services services() {
        Services services = services_without_files();
        services.exists = [](const std::string& name) { return std::filesystem::exists(name); };
        services.save = [](const std::string& name, const std::string& text) {
            sim::write_file_atomically(name, text);
        };
        return services;
    }
    void play(const std::string& script) {
        const auto step = [&](const std::vector<InputEvent>& events) {
            editor_.frame(events, {.width_px = 1280, .height_px = 800}, 1.0 / 30);
        };
        ScriptPlayer player(editor_, {.step = step, .screenshot = {}, .say = {}}, "joints.txt");
        player.play(parse_script(script, "joints.txt"));
    }
    Drape& drape() { return editor_.state().workspace.drape; }

    sim::TemporaryFolder folder_;
    Editor editor_{services(), {.drive = sim::SessionDrive::Caller, .is_steady = true}};
};

TEST_F(JointsInEditor, are_turned_by_a_script_and_saved_as_a_pose_of_the_list) {
    const std::string file = (folder_ / "wave.json").string();
    play(
        "key space\nsettle 12\nexpect Settled\n"
        "click widget joint.show\n"
        "click widget joint.list\nframes 2\nclick widget joint.list.7\nframes 2\n"
        "click widget joint.bend\ntype 80\nkey enter\nframes 60\n");
    ASSERT_TRUE(drape().activity().turned.has_value());
    EXPECT_FALSE(drape().frame()->motion.is_at_rest) << "the body went there";
    const sim::PoseAngles turned = *drape().angles();
    EXPECT_GT(turned.joints[7][0], 1.3);
    save_pose(editor_.state(), file);
    play("frames 3\n");
    EXPECT_EQ(drape().activity().pose, file);
    const MotionChoices choices = pose_choices(drape());
    EXPECT_EQ(choices.shown, "wave.json");
    const sim::Body& body = *drape().current_body().body();
    const sim::PoseAngles read = pose_angles(body, find_pose(file, body));
    for (std::size_t i = 0; i < sim::kJointCount; ++i) EXPECT_LT((read.joints[i] - turned.joints[i]).norm(), 1e-4);
    save_pose(editor_.state(), file);
    EXPECT_FALSE(editor_.state().questions.empty()) << "it asks before it replaces a file";
}

}  // namespace
}  // namespace selvedge::editor
