#pragma once
// Tartans to choose from, each with a woven picture, and a threadcount of one's own.
#include <optional>
#include <string>
#include <vector>

#include "editor/inspectors/inspectors.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern.h"
#include "sim/tartan/sett.h"

namespace selvedge::editor {

// The search box, the list that fits it; a click on one takes it.
void draw_tartan_list(InspectorContext& context);

// The threadcount, with what it weaves, also while it is typed, and what is wrong with it in words.
void draw_threadcount(InspectorContext& context);

// A fabric's figures as people who buy cloth read them.

struct FabricRow {
    const char* label = "";
    std::string value;
    const char* tip = "";
};

// Weight, stretch, shear, bending, thickness, friction, damping, strain limit.
std::vector<FabricRow> fabric_rows(const sim::Fabric& fabric);

// "wool_twill" as "Wool twill"; a file by its name without folders.
std::string readable_name(const std::string& name);

// A sett as it is written, so that one that ships can be changed by hand.

// "K/8 R24 W/4 weft: ... weave: denim", its colours that the usual letters do not have first. parse_threadcount makes
// the same threads of it.
std::string threadcount_of(const sim::Sett& sett);

// Why it cannot be woven, in words; empty: it can. Also for names.
std::string wrong_with_tartan(const std::string& name_or_threadcount);

// What the garment is woven in, in its size. None: its name or threadcount is wrong.
std::optional<sim::Sett> valid_sett(const sim::Pattern& pattern);

// Whether all words are in the text, in small or capital letters.
bool has_words(const std::string& text, const std::string& words);

}  // namespace selvedge::editor
