#pragma once
// What the inspectors are put together from: rows of a label and a field, buttons that wrap, words that fit. All sizes
// follow the font.
#include <imgui.h>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "editor/inspectors/inspectors.h"

namespace selvedge::editor {

ImVec4 to_colour(const sim::Rgb8& rgb, float alpha = 1);
ImVec4 tinted(const sim::Rgb8& ground, const sim::Rgb8& with);  // a little of it

ImTextureID texture_id(UiTexture texture);

// Words about the item before it, while the cursor rests on it, also where it is disabled.
void show_tip(const std::string& words);

// "Starts or pauses (Space)": with the key of an action, if it has one.
std::string with_key(const InspectorContext& context, const std::string& words, std::string_view action);

// Where the item before it stands, for whoever asks by name.
void note_widget(InspectorContext& context, const std::string& name);

// On the line of the item before it, at a place of the window. ImGui::SameLine takes 0 for "behind it".
void back_to(float left);

// As much of the text as fits, "left_sle..." where it does not.
std::string elided(const std::string& text, float width_px);

// Text on one line, elided and then with all of it as a tip.
void elided_text(const std::string& text, float width_px, const ImVec4& colour);

void heading(const InspectorContext& context, const char* title);
void paragraph(const InspectorContext& context, const std::string& words);  // wraps, faint
void complaint(const sim::Rgb8& colour, const std::string& words);          // wraps, coloured

// A section that folds. Returns whether it is open.
enum class Fold { Open, Closed };
bool folding(const char* title, Fold at_first);

// A row: a label, and then what is left for the field.
float label_width();
float field_width();
void row_label(const InspectorContext& context, const char* label, const std::string& tip);

// A row with a value that cannot be changed.
void fact(const InspectorContext& context, const char* label, const std::string& value, const std::string& tip);

// Buttons side by side, on as many lines as they need.
class ButtonRow {
 public:
    explicit ButtonRow(InspectorContext& context) : context_(context) {}

    struct Button {
        const char* name = "";
        const char* title = "";
        std::string tip{};
        bool is_enabled = true;
        bool is_on = false;  // drawn as chosen
    };
    bool button(const Button& button);

 private:
    InspectorContext& context_;
    bool is_first_ = true;
};

bool check_box(InspectorContext& context, const char* name, const char* title, bool value, const std::string& tip);

// A choice from a list, as wide as the field. Returns the index chosen now, or -1.
struct Choice {
    const char* name = "";
    std::string shown{};  // at rest
    std::span<const std::string> items{};
    int chosen = -1;
    std::string tip{};
    float width_px = 0;
};
int choice_box(InspectorContext& context, const Choice& choice);

// Small charts: bars and lines that show a shape, with the figure in words beside it.

// One bar for each figure, from the left, its number below; the tip tells each figure.
struct BarChart {
    std::vector<int> figures;
    std::function<std::string(std::size_t bar)> tip;
    std::function<sim::Rgb8(std::size_t bar)> colour;
};
void bar_chart(const InspectorContext& context, const BarChart& chart);

// The last figures, the newest at the right, from 0 up. `count` of at most `full`: so many fill the width.
struct SparkLine {
    std::size_t count = 0;
    std::size_t full = 1;
    std::function<float(std::size_t index)> figure;
    std::string tip;
};
void spark_line(const InspectorContext& context, const SparkLine& line);

}  // namespace selvedge::editor
