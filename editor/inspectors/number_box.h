#pragma once
// Input fields for numbers and text. Enter, Tab or a click elsewhere applies the text; Esc cancels. After Enter and Esc
// the keys are the sheet's again (BoxState::gives_keys_back). Text that cannot be read is marked and not applied. The
// arrow keys (Shift: ten times the step) and dragging the label also change a number. Also: conversion between SI
// values and text with units, and rows of two or three numbers.
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "editor/inspectors/inspectors.h"
#include "sim/core/math.h"

namespace selvedge::editor {

// Values in fields: SI units internally, cm, mm or degrees as text, with as few digits as necessary.

enum class Unit {
    Centimetres,  // value in m
    Millimetres,  // value in m
    Degrees,      // value in rad
    Factor,       // 1.05, or typed as 105%
    Plain,
    Whole,  // integer
    // Of fabrics:
    GramsPerArea,       // value in kg/m^2, as g/m^2
    NewtonsPerMetre,    // value in N/m
    MicronewtonMetres,  // value in N m
    Millinewtons,       // value in N
    Thickness,          // value in m, as mm with four decimals
    PerSecond,          // value in 1/s
    Percent,            // 0.03 as 3 %
};

// For example "92.5": without the unit, never "-0".
std::string quantity_number(double value, Unit unit);

// For example "92.5 cm".
std::string quantity_text(double value, Unit unit);

// Parses an expression with an optional unit: 92/4+1, 120 mm, 4 in, 105%. Returns none if it is not a value of this
// kind.
std::optional<double> parse_quantity(std::string_view text, Unit unit);

// The step of one arrow key press or of two px of dragging, SI: 1 mm, 0.1 mm, 1 degree, 0.01, 0.1, 1; of fabrics 1
// g/m^2, 1 N/m, 0.1 uN m, 0.01 mN, 0.01 mm, 0.1 /s, 0.1 %.
double step_of(Unit unit);

// The value after `steps` steps, rounded to a multiple of the step: 92.53 + 0.1 gives 92.6.
double stepped(double value, Unit unit, double steps);

// What the document does with the edit.
enum class EditPhase { None, Preview, Commit, Rollback };

struct NumberEdit {
    EditPhase phase = EditPhase::None;
    std::optional<double> value{};   // none: the field was cleared
    std::optional<double> before{};  // the value when editing began; meanwhile the document holds the preview

    explicit operator bool() const { return phase != EditPhase::None; }
    double by() const { return value.value_or(0) - before.value_or(0); }
};

struct NumberBox {
    const char* name = "";   // unique among the inspectors: "panel.translation.x"
    const char* label = "";  // in front of the field, can be dragged; empty: none
    std::optional<double> value{};
    Unit unit = Unit::Centimetres;
    std::string tip{};
    float width_px = 0;  // includes the label
    float label_px = 0;  // 0: the label's own width
    std::optional<double> least{};
    std::optional<double> most{};
    std::optional<double> step{};  // SI; none: step_of(unit)
    bool may_be_empty = false;
    std::optional<double> standing_for{};  // value that an empty field stands for, shown in grey
    bool has_unit = true;                  // shows the unit after the number
};

NumberEdit number_box(InspectorContext& context, const NumberBox& box);

struct TextBox {
    const char* name = "";
    std::string text{};
    std::string hint{};  // shown in grey while the field is empty
    std::string tip{};
    float width_px = 0;
    std::string (*wrong)(const std::string& text) = nullptr;  // returns why the text cannot be applied; empty: it can
};

// Returns the text when it is to be applied; otherwise none.
std::optional<std::string> text_box(InspectorContext& context, const TextBox& box);

// Parses a field's text. `wrong` holds the reason if the text cannot be applied.
struct ReadNumber {
    std::optional<double> value{};
    std::string wrong{};
};
ReadNumber read_number(const NumberBox& box, const std::string& text);

// Previews, commits or rolls back the command, according to the edit's phase.
void apply_edit(InspectorContext& context, const NumberEdit& edit, const Command& command);

// Ends the editing of fields that are no longer drawn and commits their previews. Call once per frame.
void forget_lost_boxes(InspectorContext& context);

// Two or three numbers side by side: X, Y and Z. In a narrow window they are drawn below their label.

struct VectorRow {
    const char* name = "";   // "panel.translation"; the fields append ".x", ".y", ".z"
    const char* label = "";  // for example "Place"
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

// The vector with the edited component replaced.
Vec3d edited(Vec3d value, const VectorEdit& edit);
Vec2d edited(Vec2d value, const VectorEdit& edit);

// A row of a label and a number field. The label can be dragged.
NumberEdit number_row(InspectorContext& context, NumberBox box, const char* label);

}  // namespace selvedge::editor
