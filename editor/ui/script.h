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
#include <string>
#include <string_view>
#include <vector>

namespace selvedge {

struct ScriptStep {
    int line = 0;  // of the file, from 1
    std::string verb;
    std::vector<std::string> words;  // after the verb
    std::string rest;                // the same as it stands in the line
};

// Throws InputError(file, "line 3", ...) for a verb that there is not.
std::vector<ScriptStep> parse_script(std::string_view text, const std::string& file);

}  // namespace selvedge
