#pragma once
// Plays a script at an editor, frame by frame, as if a person sat there.
#include <functional>
#include <string>
#include <vector>

#include "editor/ui/editor.h"
#include "editor/ui/script.h"

namespace selvedge {

class ScriptPlayer {
 public:
    // Shows one frame of the editor with these events; and writes what it shows to a file.
    struct Stage {
        std::function<void(const std::vector<InputEvent>&)> step;
        std::function<void(const std::string& file)> screenshot;
        std::function<void(const std::string& words)> say;
    };

    ScriptPlayer(Editor& editor, Stage stage, std::string file)
        : editor_(editor), stage_(std::move(stage)), file_(std::move(file)) {}

    // Throws InputError naming the line of what cannot be done.
    void play(const std::vector<ScriptStep>& steps);

 private:
    void play(const ScriptStep& step);
    void play_mouse(const ScriptStep& step);
    void play_document(const ScriptStep& step);
    void expect(const ScriptStep& step) const;

    // The place that begins with the word at `at`, which goes on behind it.
    Vec2d place(const ScriptStep& step, std::size_t& at) const;
    double number(const ScriptStep& step, std::size_t at) const;
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

}  // namespace selvedge
