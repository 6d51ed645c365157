#pragma once
// Scripts: what a person would do at the editor, line by line, for tests and pictures without a person.
//
//   open FILE | new | save FILE | do COMMAND-AS-JSON | action file.undo | key ctrl+z | type TEXT
//   move PLACE | press PLACE | release PLACE | click PLACE | double PLACE | drag PLACE to PLACE | wheel PLACE NOTCHES
//   where PLACE (says its px) | frames COUNT | settle SECONDS | expect WORDS | screenshot FILE | export FILE
//
// A PLACE is `sheet X Y` (cm on the drafting sheet), `panel NAME X Y` (cm in the panel's frame),
// `vertex NAME INDEX` (of a panel), `widget NAME`,
// `point NAME` (an arrangement point), `room X Y Z` (m) or `px X Y`; with shift, ctrl, alt, right or middle after it.
// `expect` fails unless the 3D view says these words of the drape: Placed, Settled. # begins a comment.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/ui/editor.h"

namespace selvedge::editor {

struct ScriptStep {
    int line = 0;  // of the file, from 1
    std::string verb;
    std::vector<std::string> words;  // after the verb
    std::string rest;                // the same as it stands in the line
};

// Throws InputError(file, "line 3", ...) for a verb that there is not.
std::vector<ScriptStep> parse_script(std::string_view text, const std::string& file);

// Plays a script at an editor, frame by frame, as if a person sat there.

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

}  // namespace selvedge::editor
