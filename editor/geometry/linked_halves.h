#pragma once
// Panels with linked halves (sim/pattern/halves.h) as two panels each: the drawn half, in the panel's place, and the
// other half, which is a mirror image of it (Panel::mirror_of), has its name too, and stands after all panels. So
// halves are kept alike as linked panels are. For update_links (linked_panels.h); for the sources of this module.
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "sim/pattern/edge_keys.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// A seam within a half.
struct HalfDart {
    sim::EdgeKeyPair keys;      // of its edges, as EdgeRole::Drawn
    std::array<Vec2d, 4> ends;  // m, of both edges, in the frame of the panel
};

// What an edit made of one half. In the frame of its panel.
struct HalfEdit {
    sim::Panel before;
    sim::Panel now;
    std::vector<HalfDart> darts_before;
    std::vector<HalfDart> darts_now;
    bool is_changed = false;  // more than that its ends on the fold were moved, which belong to both halves
};

struct DividedPanel {
    int panel = 0;                       // of the drawn half
    std::optional<HalfEdit> drawn = {};  // none: the panel had no such halves before
    std::optional<HalfEdit> other = {};
};

struct DividedPattern {
    sim::Pattern pattern;
    std::vector<DividedPanel> divided;  // panels whose other halves are the last panels of `pattern`, in this order
};

// Internal lines and drill points that `before` has are of the half that they were of; others of that on whose side of
// the fold their middle lies. Throws GeometryError if halves that `before` has do not meet in two points any more;
// halves that were never there are left alone. Pre: all panels have keys.
DividedPattern divide_halves(const sim::Pattern& pattern, const sim::Pattern& before);

// Unfolds the drawn halves again. Seams to other halves are then seams to the images of their edges.
sim::Pattern joined_halves(const DividedPattern& parts);

// Throws GeometryError if an edit changed both halves of a panel, and `made`, the whole panels that follow from it,
// does not have what it made of each.
void expect_both_kept(const DividedPattern& parts, const sim::Pattern& made);

}  // namespace selvedge::editor
