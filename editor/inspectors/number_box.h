#pragma once
// Boxes to type into. Enter, Tab or a click elsewhere applies what was typed, Esc takes it back; what cannot be read is
// marked and not applied. Numbers also go by arrow keys (Shift: ten times as far) and by dragging their label.
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "editor/inspectors/inspectors.h"
#include "sim/core/math.h"

namespace selvedge::editor {

// Values in boxes: SI inside, cm, mm or degrees to read and type, with as few figures as say it.

enum class Unit {
    Centimetres,  // of m
    Millimetres,  // of m
    Degrees,      // of rad
    Factor,       // 1.05, or typed 105%
    Plain,
    Whole,  // a whole number
};

// "92.5": without the unit, never "-0".
std::string quantity_figure(double value, Unit unit);

// "92.5 cm".
std::string quantity_text(double value, Unit unit);

// An expression, and another unit behind it if one likes: 92/4+1, 120 mm, 4 in, 105%. None: it is no such value.
std::optional<double> parse_quantity(std::string_view text, Unit unit);

// One press of an arrow key, or two px of dragging: 1 mm, 0.1 mm, 1 degree, 0.01, 0.1, 1.
double step_of(Unit unit);

// What a step leads to: on the raster of steps, where 92.53 + 0.1 is 92.6.
double stepped(double value, Unit unit, double steps);

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

// Two or three numbers that belong together, side by side: X, Y and Z; below their label where there is little room.

struct VectorRow {
    const char* name = "";   // "panel.translation"; boxes add ".x", ".y", ".z"
    const char* label = "";  // "Place"
    Unit unit = Unit::Centimetres;
    std::string tip{};
    std::array<const char*, 3> axes{"X", "Y", "Z"};
    std::optional<double> least{};
};

struct VectorEdit {
    EditPhase phase = EditPhase::None;
    int axis = 0;
    NumberEdit number{};

    explicit operator bool() const { return phase != EditPhase::None; }
};

VectorEdit vector_row(InspectorContext& context, const VectorRow& row, const Vec3d& value);
VectorEdit vector_row(InspectorContext& context, const VectorRow& row, const Vec2d& value);

// The same with what was edited in its place.
Vec3d edited(Vec3d value, const VectorEdit& edit);
Vec2d edited(Vec2d value, const VectorEdit& edit);

// One number with its label, as a row. The label can be dragged.
NumberEdit number_row(InspectorContext& context, NumberBox box, const char* label);

}  // namespace selvedge::editor
