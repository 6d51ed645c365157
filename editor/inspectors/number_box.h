#pragma once
// Boxes to type into. Enter, Tab or a click elsewhere applies what was typed, Esc takes it back; what cannot be read is
// marked and not applied. Numbers also go by arrow keys (Shift: ten times as far) and by dragging their label.
#include <optional>
#include <string>

#include "editor/inspectors/inspector_context.h"
#include "editor/inspectors/quantity.h"

namespace selvedge {

enum class EditPhase {
    None,
    Trying,   // shown while it lasts
    Kept,     // applied
    Dropped,  // what was tried is taken back
};

struct NumberEdit {
    EditPhase phase = EditPhase::None;
    std::optional<double> value{};   // none: the box was emptied
    std::optional<double> before{};  // when it was entered: what is tried is seen in the document meanwhile

    explicit operator bool() const { return phase != EditPhase::None; }
    double by() const { return value.value_or(0) - before.value_or(0); }
};

struct NumberBox {
    const char* name = "";   // among the inspectors: "panel.translation.x"
    const char* label = "";  // before it, to drag; empty: none
    std::optional<double> value{};
    Unit unit = Unit::Centimetres;
    std::string tip{};
    float width_px = 0;  // with the label
    float label_px = 0;  // 0: as wide as it is
    std::optional<double> least{};
    std::optional<double> most{};
    bool may_be_empty = false;
    std::optional<double> standing_for{};  // what an empty box means, shown grey
    bool has_unit = true;                  // shows it behind the figures
};

NumberEdit number_box(InspectorContext& context, const NumberBox& box);

struct TextBox {
    const char* name = "";
    std::string text{};
    std::string hint{};  // shown grey while it is empty
    std::string tip{};
    float width_px = 0;
    std::string (*wrong)(const std::string& text) = nullptr;  // why it cannot be applied; empty: it can
};

// The text that is to be applied; none: not now.
std::optional<std::string> text_box(InspectorContext& context, const TextBox& box);

// What a box makes of its text, apart from drawing. `wrong` tells why there is nothing to apply.
struct ReadNumber {
    std::optional<double> value{};
    std::string wrong{};
};
ReadNumber read_number(const NumberBox& box, const std::string& text);

// Shows, applies or takes back what a box was changed to.
void carry(InspectorContext& context, const NumberEdit& edit, const Command& command);

// Gives up boxes that are no longer there: what they showed is kept. Once per frame.
void forget_lost_boxes(InspectorContext& context);

}  // namespace selvedge
