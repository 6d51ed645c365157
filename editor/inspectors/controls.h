#pragma once
// The building blocks of the inspectors: rows of a label and a field, wrapping button rows, elided text, small
// charts. All sizes scale with the font.
#include <imgui.h>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "editor/frame/item.h"
#include "editor/inspectors/inspectors.h"

namespace selvedge::editor {

ImVec4 to_colour(const sim::Rgb8& rgb, float alpha = 1);
ImVec4 tinted(const sim::Rgb8& ground, const sim::Rgb8& with);  // a small share of `with` mixed in

ImTextureID texture_id(UiTexture texture);

// Adds the action's key to the text, for example "Starts or pauses (Space)"; unchanged if the action has no key.
std::string with_key(const InspectorContext& context, const std::string& text, std::string_view action);

// Records the position of the previous item under this name, for scripts and tests.
void note_widget(InspectorContext& context, const std::string& name);

// Continues on the line of the previous item, at window coordinate `left`. ImGui::SameLine cannot do this for 0, which
// means "after the item".
void back_to(float left);

// Text on one line; if it is elided, a tooltip shows the whole text.
void elided_text(const std::string& text, float width_px, const ImVec4& colour);

void heading(const InspectorContext& context, const char* title);
void paragraph(const InspectorContext& context, const std::string& text);  // wraps; in the faint colour
void message_text(const sim::Rgb8& colour, const std::string& text);       // wraps; in `colour`

// A collapsible section. Returns whether it is open.
enum class Fold { Open, Closed };
bool folding(const char* title, Fold at_first);

// A row: a label, then a field that takes the remaining width.
float label_width();
float field_width();
void row_label(const InspectorContext& context, const char* label, const std::string& tip);

// A row with a read-only value.
void fact(const InspectorContext& context, const char* label, const std::string& value, const std::string& tip);

// Buttons side by side, wrapped to as many lines as necessary.
class ButtonRow {
 public:
    explicit ButtonRow(InspectorContext& context) : context_(context) {}

    struct Button {
        const char* name = "";
        const char* title = "";
        std::string tip{};
        bool is_enabled = true;
        bool is_on = false;  // drawn as selected
    };
    bool button(const Button& button);

 private:
    InspectorContext& context_;
    bool is_first_ = true;
};

bool check_box(InspectorContext& context, const char* name, const char* title, bool value, const std::string& tip);

// A drop-down list, as wide as the field. Returns the newly chosen index, or -1.
struct Choice {
    const char* name = "";
    std::string shown{};  // shown while the list is closed
    std::span<const std::string> items{};
    int chosen = -1;
    std::string tip{};
    float width_px = 0;
};
int choice_box(InspectorContext& context, const Choice& choice);

// Small charts: bars and lines that show the shape of a series, with the values as text.

// One bar per value, from the left, with the value below it; a tooltip describes each bar.
struct BarChart {
    std::vector<int> values;
    std::function<std::string(std::size_t bar)> tip;
    std::function<sim::Rgb8(std::size_t bar)> colour;
};
void bar_chart(const InspectorContext& context, const BarChart& chart);

// The latest values, newest at the right; the axis starts at 0. `count` <= `full`; `full` values fill the width.
struct SparkLine {
    std::size_t count = 0;
    std::size_t full = 1;
    std::function<float(std::size_t index)> value;
    std::string tip;
};
void spark_line(const InspectorContext& context, const SparkLine& line);

}  // namespace selvedge::editor
