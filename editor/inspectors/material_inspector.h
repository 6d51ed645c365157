#pragma once
// The material inspector: the list of tartans with woven previews, editing of a threadcount, and a fabric's values as
// text.
#include <optional>
#include <string>
#include <vector>

#include "editor/inspectors/inspectors.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern.h"
#include "sim/tartan/sett.h"

namespace selvedge::editor {

// The search box and the list of matching tartans; a click selects one.
void draw_tartan_list(InspectorContext& context);

// What the selected panels show, or the garment: tartan, colour, picture or test pattern.
void draw_surface(InspectorContext& context);

// The threadcount field, with a preview of the weave while typing, and the error if the text is invalid.
void draw_threadcount(InspectorContext& context);

// A fabric's values in the units of the textile trade.

struct FabricRow {
    const char* label = "";
    std::string value;
    const char* tip = "";
};

// Rows: weight, stretch, shear, bending, thickness, friction, damping, strain limit.
std::vector<FabricRow> fabric_rows(const sim::Fabric& fabric);

// "wool_twill" as "Wool twill"; of a file, its name without folders.
std::string readable_name(const std::string& name);

// The threadcount notation of a sett, so that a built-in one can be edited.

// For example "K/8 R24 W/4 weft: ... weave: denim". Definitions of non-standard colours come first. parse_threadcount()
// of the result gives the same threads.
std::string threadcount_of(const sim::Sett& sett);

// The reason why the name or threadcount cannot be woven; empty: it can.
std::string tartan_error(const std::string& name_or_threadcount);

// The garment's sett at its repeat size. None: the name or threadcount is invalid.
std::optional<sim::Sett> valid_sett(const sim::Pattern& pattern);

// The fabric of the panel: its own, the garment's, or the default.
std::string fabric_of(const sim::Pattern& pattern, const sim::Panel& panel);

// Whether the text contains all the words, ignoring case.
bool has_all_words(const std::string& text, const std::string& words);

}  // namespace selvedge::editor
