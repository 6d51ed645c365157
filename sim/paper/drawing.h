#pragma once
// A pattern as another program drew it, before it becomes panels: parts with lines whose meaning the file states or
// leaves open, marks and texts. Every reader of a 2D format makes one (drawing_file.h), and make_panels.h makes a
// pattern of it.
//
// Coordinates are those of the file, turned so that y points up; metres_per_unit converts them.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/math.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// Unknown: the file does not say. Cut, Sew: a part's outline with and without its seam allowance. FoldEdge: along it
// the part is cut on folded fabric, or mirrored; a bracket beside it means the nearest stretch of the outline.
// FoldLine: the part is folded here when it is sewn. Help: a line for the drafter, which is not imported.
enum class LineKind { Unknown, Cut, Sew, FoldEdge, FoldLine, Grain, Internal, Cutout, Help };

// Edges in order, each from where the last one ends. A closed path has as many vertices as edges; an open one has one
// vertex more. OutlineEdge::control, arc_radius and allowance are in file units here, too.
struct DrawnPath {
    LineKind kind = LineKind::Unknown;
    std::vector<Vec2d> vertices;
    std::vector<OutlineEdge> edges;
    bool is_closed = false;
    std::string name = {};        // id or class in the file
    std::vector<int> turns = {};  // vertices that the file calls corners; empty: it does not say
    std::string place = {};       // in the file, for messages: "line 120", "parts.front.paths.seam"
    InternalLine line = {};       // of a line in a panel: what the file says of it that is not drawn

    bool operator==(const DrawnPath&) const = default;
};

enum class MarkKind { Notch, Drill, Button, Buttonhole };

struct DrawnMark {
    MarkKind kind = MarkKind::Notch;
    Vec2d at = Vec2d::Zero();
    NotchKind notch = NotchKind::Slit;  // of a notch
    int count = 1;                      // notches side by side: 2 for FreeSewing's back notch
    std::optional<int> edge = {};       // that it belongs to, as DrawnSeam counts edges; none: the file does not say

    bool operator==(const DrawnMark&) const = default;
};

struct DrawnText {
    Vec2d at = Vec2d::Zero();
    std::string text;

    bool operator==(const DrawnText&) const = default;
};

// What a file says of how a part is cut; unset where it says nothing.
struct CutInstructions {
    std::optional<int> pieces = {};
    std::optional<bool> are_mirrored = {};  // every second piece is the mirror image of the first
    std::optional<bool> is_on_fold = {};
    std::string material = {};  // "fabric", "lining", "interfacing"; empty: not named

    bool operator==(const CutInstructions&) const = default;
};

// How a panel starts round the body, as files of Selvedge say it. Places of the outline tell where the panel frame lies
// on the paper, wherever another program moved or turned the piece.
struct DrawnPlacement {
    std::vector<std::pair<int, Vec2d>> starts = {};  // edges, as DrawnSeam counts them, and where they begin in the
                                                     // panel frame, m
    std::vector<int> pinned_edges = {};              // edges at whose start the panel is pinned
    Panel stated = {};                               // has what is stated; else defaults

    bool operator==(const DrawnPlacement&) const = default;
};

struct DrawnPart {
    std::string name;
    std::vector<DrawnPath> paths = {};
    std::vector<DrawnMark> marks = {};
    std::vector<DrawnText> texts = {};
    CutInstructions cut = {};
    std::string size = {};
    std::string category = {};                     // what the piece is, where the file says it beside the name: "FRONT"
    std::optional<DrawnPlacement> placement = {};  // none: the file does not say

    bool operator==(const DrawnPart&) const = default;
};

// A seam that the file states, as files of Selvedge do. Its sides are indices of a part and of an edge: those of the
// part's first closed Sew path, or Cut path if it has no Sew path.
using DrawnSeam = Seam;

// The mannequin round which the parts are placed.
struct DrawnBody {
    std::string text;   // as Pattern::body; never a file
    double height = 0;  // m

    bool operator==(const DrawnBody&) const = default;
};

struct Measurement {
    std::string name;  // as the file has it: "chest", "waist_circ"
    double value = 0;  // m

    bool operator==(const Measurement&) const = default;
};

struct DrawingUnit {
    const char* option = "";  // as --unit names it
    const char* name = "";    // for people
    double metres = 0;

    bool operator==(const DrawingUnit& other) const { return metres == other.metres; }
};

// A page that holds a picture and nothing to read: it is laid under the sheet (Underlay) and traced by hand.
struct DrawnPicture {
    std::size_t number = 0;      // of the page, from 1
    Vec2d size = Vec2d::Zero();  // m, of the page
    double pixel_size = 0;       // m
    int width_px = 0, height_px = 0;
    std::vector<std::uint8_t> rgb = {};  // row by row from the top left

    bool operator==(const DrawnPicture&) const = default;
};

struct Drawing {
    std::string title;
    std::string format = {};  // "FreeSewing SVG", "DXF-AAMA R10", for reports
    std::vector<DrawnPart> parts = {};
    std::vector<DrawnPicture> pictures = {};  // pages without parts; where there are some, there may be no parts
    std::vector<DrawnSeam> seams = {};
    std::optional<DrawnBody> body = {};          // of the parts' placements; none: the file states none
    std::optional<double> metres_per_unit = {};  // none: the file does not say
    std::vector<DrawingUnit> likely_units = {};  // if it does not: those that it may mean, the likeliest first
    std::string sample_size = {};                // that the file names; empty: none
    std::optional<double> allowance = {};        // m, that the file states for the whole pattern
    std::vector<Measurement> measurements = {};  // of the body that it was drafted for
    std::string measurement_set = {};            // what the file calls them: "cisFemaleAdult34"
    bool is_upright = true;                      // parts are drawn as they are worn; otherwise as they lie on cloth
    bool is_y_down = false;                      // in the file; messages name places as the file does
    std::vector<std::string> notes = {};         // what was repaired or left out, one line each

    bool operator==(const Drawing&) const = default;
};

}  // namespace selvedge::sim
