#pragma once
// Places the panels of a pattern round a body when no file says where they belong, as after the import of a paper
// pattern: what a panel is for (sim/proposals/panel_role.h) and what it is sewn to decide. Fronts and backs stand flat
// before and behind the body, sleeves and strips are wrapped round their limb, everything else continues the panel that
// it is sewn to.
#include <string>
#include <string_view>
#include <vector>

#include "sim/body/body.h"
#include "sim/pattern/pattern.h"
#include "sim/proposals/panel_role.h"

namespace selvedge::sim {

struct Arrangement {
    std::vector<PanelRole> roles;    // per panel, with the side of the body that its seams tell
    std::vector<std::string> notes;  // panels that were placed by guess, one line each
};

// Changes translation, rotation, wrap radius and label of each worn panel. hints: texts about the whole garment. Sets
// Pattern::body_height to the body's. Pre: the body has triangles.
Arrangement arrange_pattern(Pattern& pattern, const Body& body, std::string_view hints = {});

}  // namespace selvedge::sim
