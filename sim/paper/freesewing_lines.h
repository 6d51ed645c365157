#pragma once
// What FreeSewing means by a line's class and name, in its SVG as in its data: "fabric" is a sewing line, "fabric sa"
// its cut line, and so on.
#include <string>
#include <string_view>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

struct FreesewingLine {
    std::string_view classes;  // separated by blanks
    std::string_view name;     // of the path, or the text along it; may be empty
    bool is_closed = false;
};
LineKind kind_of(const FreesewingLine& line);

// notch, bnotch, button, buttonhole...; returns false for logos and others.
bool read_snippet(std::string_view name, DrawnMark& mark);

}  // namespace selvedge::sim
