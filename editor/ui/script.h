#pragma once
// Plays scripts (editor/document/script_steps.h): simulated user input for automated tests and images.
#include <functional>
#include <string>
#include <vector>

#include "editor/document/script_steps.h"
#include "editor/ui/editor.h"

namespace selvedge::editor {

// Plays a script on an editor, frame by frame, as simulated user input.
class ScriptPlayer {
 public:
    // step: shows one frame of the editor with these events. screenshot: writes what is shown to a file. say: prints a
    // line.
    struct Stage {
        std::function<void(const std::vector<InputEvent>&)> step;
        std::function<void(const std::string& file)> screenshot;
        std::function<void(const std::string& text)> say;
    };

    ScriptPlayer(Editor& editor, Stage stage, std::string file)
        : editor_(editor), stage_(std::move(stage)), file_(std::move(file)) {}

    // Throws InputError that names the line of a step that cannot be executed.
    void play(const std::vector<ScriptStep>& steps);

 private:
    void play(const ScriptStep& step);
    void play_mouse(const ScriptStep& step);
    void play_document(const ScriptStep& step);
    void expect(const ScriptStep& step) const;

    // Parses the PLACE that starts at word `at`; moves `at` past it. Returns px of the window.
    Vec2d place(const ScriptStep& step, std::size_t& at) const;
    double number(const ScriptStep& step, std::size_t at) const;
    int whole_number(const ScriptStep& step, std::size_t at) const;  // from 0 to 1e9
    const std::string& word(const ScriptStep& step, std::size_t at) const;
    [[noreturn]] void fail(const ScriptStep& step, const std::string& problem) const;

    void send(const InputEvent& event);
    void move_to(const Vec2d& px, const Modifiers& modifiers);
    void set_button(MouseButton button, bool is_down, const Modifiers& modifiers);
    void press_key(const Chord& chord);
    void wait_frames(int frames);
    void settle(double seconds);

    Editor& editor_;
    Stage stage_;
    std::string file_;
    Vec2d mouse_ = Vec2d::Zero();  // px
};

}  // namespace selvedge::editor
