#pragma once
// Scripts: user input as text, one step per line, for automated tests and images.
//
//   open FILE | new | save FILE | do COMMAND-AS-JSON | action edit.undo | key ctrl+z | type TEXT
//   move PLACE | press PLACE | release PLACE | click PLACE | double PLACE | drag PLACE to PLACE | wheel PLACE NOTCHES
//   where PLACE (prints its px) | wear BODY | frames COUNT | settle SECONDS | expect WORDS | screenshot FILE
//   export FILE [thickness MM|fabric] | import FILE [unit cm] [size M] [allowance MM] [measurements FILE]
//   print FILE (.pdf, .svg, .dxf) [paper a3] [layers cut,sew] [width CM] [one-page] [all] [on-fold] [layout] [folded]
//   [one-way] [astm]
//
// A PLACE is `sheet X Y` (cm on the sheet), `panel NAME X Y` (cm in the panel's frame), `vertex NAME INDEX` (of a
// panel), `widget NAME`, `point NAME` (an arrangement point), `room X Y Z` (m, a 3D point) or `px X Y`, followed by any
// of shift, ctrl, alt, right, middle. `expect` fails unless the 3D view shows this stage of the drape, for example
// Placed or Settled. # starts a comment.
#include <string>
#include <string_view>
#include <vector>

namespace selvedge::editor {

struct ScriptStep {
    int line = 0;  // line number in the file, from 1
    std::string verb;
    std::vector<std::string> arguments;
    std::string rest;  // the arguments as written
};

// Throws InputError(file, "line 3", ...) for an unknown verb.
std::vector<ScriptStep> parse_script(std::string_view text, const std::string& file);

}  // namespace selvedge::editor
