#pragma once
// The material inspector: a fabric's values and their editing, what the cloth shows, the list of tartans with woven
// previews, and editing of a threadcount.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "editor/inspectors/inspectors.h"
#include "editor/inspectors/number_box.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern.h"
#include "sim/pattern/surface_design.h"
#include "sim/tartan/sett.h"

namespace selvedge::editor {

// The search box and the list of matching tartans; a click selects one.
void draw_tartan_list(InspectorContext& context);

// Rows to edit a surface design: tartan, colour, picture or test pattern.
struct DesignRows {
    std::optional<sim::SurfaceDesign> now{};
    std::string names{};                   // what the names of the widgets begin with: "surface."
    std::string none{};                    // what stands for no design in the list of kinds
    std::string tip{};                     // of that list
    std::function<void()> open_picture{};  // opens a file dialog for a picture; may be unset
};
struct DesignEdit {
    EditPhase phase = EditPhase::None;
    std::optional<sim::SurfaceDesign> surface{};  // of Rollback: as it was before

    explicit operator bool() const { return phase != EditPhase::None; }
};
DesignEdit design_rows(InspectorContext& context, const DesignRows& rows);

// What the selected panels show, or the garment.
void draw_surface(InspectorContext& context);

// The threadcount field, with a preview of the weave while typing, and the error if the text is invalid.
void draw_threadcount(InspectorContext& context);

// The fabric's values, which can be edited and saved as a file, and what is made of it.
void draw_fabric(InspectorContext& context);

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

// The garment's sett at its repeat size. None: it names none, or one that is invalid.
std::optional<sim::Sett> valid_sett(const sim::Pattern& pattern);

// The fabric of the panel: its own, the garment's, or the default.
std::string fabric_of(const sim::Pattern& pattern, const sim::Panel& panel);

// Whether the text contains all the words, ignoring case.
bool has_all_words(const std::string& text, const std::string& words);

}  // namespace selvedge::editor
