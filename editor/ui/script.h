#pragma once
// Scripts: user input as text, one step per line, for automated tests and images.
//
//   open FILE | new | save FILE | do COMMAND-AS-JSON | action file.undo | key ctrl+z | type TEXT
//   move PLACE | press PLACE | release PLACE | click PLACE | double PLACE | drag PLACE to PLACE | wheel PLACE NOTCHES
//   where PLACE (prints its px) | wear BODY | frames COUNT | settle SECONDS | expect WORDS | screenshot FILE
//   export FILE [thickness MM|fabric] | import FILE (a drawing of another program) | print FILE (.pdf, .svg, .dxf)
//
// A PLACE is `sheet X Y` (cm on the sheet), `panel NAME X Y` (cm in the panel's frame), `vertex NAME INDEX` (of a
// panel), `widget NAME`, `point NAME` (an arrangement point), `room X Y Z` (m, a 3D point) or `px X Y`, followed by any
// of shift, ctrl, alt, right, middle. `expect` fails unless the 3D view shows this stage of the drape, for example
// Placed or Settled. # starts a comment.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/ui/editor.h"

namespace selvedge::editor {

struct ScriptStep {
    int line = 0;  // line number in the file, from 1
    std::string verb;
    std::vector<std::string> arguments;
    std::string rest;  // the arguments as written
};

// Throws InputError(file, "line 3", ...) for an unknown verb.
std::vector<ScriptStep> parse_script(std::string_view text, const std::string& file);

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
