#pragma once
// The line along which cloth is cut: the outline of a panel moved outward by its seam allowance, with corners as
// tailors cut them; and the other way, the sewing line of a drawing that has the cut line only.
#include <array>
#include <utility>
#include <vector>

#include "sim/pattern/dart.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// How a notch comes out to the cut line.
struct NotchLine {
    Vec2d on_outline = Vec2d::Zero();  // m, panel frame
    Vec2d on_cut = Vec2d::Zero();      // m, square to the outline; equal to on_outline where there is no allowance.
                                       // At a dart's mouth: along the leg
    Vec2d outward = Vec2d::UnitY();    // unit
    NotchKind kind = NotchKind::Slit;
    int count = 1;
};

// How a dart is marked on cloth. All in the panel frame, m.
struct DartLines {
    NotchLine begin, end;                                     // of its legs, from the sewing line to the cut line
    std::array<Vec2d, 2> fold{Vec2d::Zero(), Vec2d::Zero()};  // from the tip to the cut line
    bool is_as_wanted = true;  // cut for the side that the dart is pressed to, and not for the other
};

struct CutLine {
    std::vector<Vec2d> outline;  // m, closed, counter-clockwise, without its first point at the end
    std::vector<NotchLine> notches;
    std::vector<DartLines> darts = {};  // those that have a cap
};

// The allowance of an edge: its own, else the panel's, else the pattern's, m.
double allowance_of(const Panel& panel, const OutlineEdge& edge, double pattern_allowance);

struct CutLineOptions {
    double pattern_allowance = 0;  // m
    double longest_mitre = 2.5;    // of the wider allowance: sharper corners are cut off square to their middle
    double chord_error = 2e-5;     // m
    std::vector<Dart> darts = {};  // of the panel; one whose legs have an allowance of their own is cut open
};

// Within twice the chord error of the exact parallels. Over the mouth of a dart lies its cap (dart_cap.h).
CutLine cut_line(const Panel& panel, const CutLineOptions& options = {});

// The panel whose outline is moved inward by a constant width, m. Edges keep their order, and their number unless a
// curve needs more than one cubic to stay within 0.05 mm. Throws InputError (place: the panel's name) if an edge
// vanishes.
Panel inset_panel(const Panel& cut, double width);

}  // namespace selvedge::sim
