#pragma once
// The shapes of an SVG document, flattened: every path in the units of the root, y up, with what its elements say of
// it.
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/paper/drawing.h"
#include "sim/paper/svg_style.h"
#include "sim/paper/svg_unit.h"

namespace selvedge::sim {

// A group on the way from the root to a shape.
struct SvgGroup {
    int number = 0;  // in the document, for comparing
    std::string id = {};
    std::string label = {};  // of Inkscape, or Illustrator's data-name
    bool is_layer = false;
    std::map<std::string, std::string> data = {};  // attributes that begin with data-selvedge-

    bool operator==(const SvgGroup&) const = default;
};

struct SvgShape {
    DrawnPath path;
    std::vector<SvgGroup> groups;  // from the outermost to the innermost
    std::string classes = {};
    std::string text_along = {};  // FreeSewing's data-text
    std::string markers = {};     // marker-start and marker-end
    std::map<std::string, std::string> data = {};
    SvgLook look = {};
};

struct SvgUse {
    std::string of;  // the id that is used
    Vec2d at = Vec2d::Zero();
    std::vector<SvgGroup> groups;
};

struct SvgText {
    DrawnText text;
    std::string along = {};  // the id of the path that it runs along
    std::vector<SvgGroup> groups;
};

struct SvgDocument {
    std::vector<SvgShape> shapes;
    std::vector<SvgUse> uses;
    std::vector<SvgText> texts;
    std::vector<std::map<std::string, std::string>> seams;  // attributes of selvedge:seam
    std::string body;                                       // of selvedge:seams; empty: the file states none
    SvgUnit unit;
    bool is_freesewing = false;
    std::size_t hidden = 0;  // elements that were left out
    std::vector<std::string> notes;
};

// Without what is hidden: by a style sheet, display, visibility or opacity. Throws InputError, see read_svg().
SvgDocument read_svg_document(std::string_view text, const std::string& file);

}  // namespace selvedge::sim
