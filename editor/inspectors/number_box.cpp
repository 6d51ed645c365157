#include "editor/inspectors/number_box.h"

#include <imgui.h>
#include <imgui_stdlib.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>

#include "editor/frame/keyboard.h"
#include "editor/geometry/expression.h"
#include "editor/inspectors/controls.h"

namespace selvedge::editor {
namespace {

constexpr float kPxPerStep = 2;  // px of dragging per step, at a font size of 13 px
constexpr double kFastStep = 10;
constexpr int kLostAfter = 2;  // frames without being drawn

double limited(const NumberBox& box, double value) {
    if (box.least) value = std::max(value, *box.least);
    if (box.most) value = std::min(value, *box.most);
    return value;
}

std::string text_of(const NumberBox& box, std::optional<double> value) {
    if (!value) return "";
    return box.has_unit ? quantity_text(*value, box.unit) : quantity_number(*value, box.unit);
}

bool is_escape_pressed() {
    return is_key_repeated(Key::Escape);
}

bool is_enter_pressed() {
    return is_key_repeated(Key::Enter) || is_key_repeated(Key::KeypadEnter);
}

struct ArrowKeys {
    const NumberBox& box;
    bool is_used = false;
};

// The value after `steps` steps, a multiple of the box's step.
double stepped(const NumberBox& box, double value, double steps) {
    if (!box.step) return stepped(value, box.unit, steps);
    return std::round((value + steps * *box.step) / *box.step) * *box.step;
}

// Callback of the up and down arrow keys: steps the number in the field.
int step_by_arrow(ImGuiInputTextCallbackData* data) {
    auto& keys = *static_cast<ArrowKeys*>(data->UserData);
    const std::optional<double> now = read_number(keys.box, std::string(data->Buf, size_t(data->BufTextLen))).value;
    const double from = now ? *now : keys.box.standing_for.value_or(0);
    const double steps = (data->EventKey == ImGuiKey_UpArrow ? 1 : -1) * (ImGui::GetIO().KeyShift ? kFastStep : 1);
    const std::string text = text_of(keys.box, limited(keys.box, stepped(keys.box, from, steps)));
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, text.c_str());
    data->SelectAll();
    keys.is_used = true;
    return 0;
}

// The pending text of this box, or null.
TypedText* typed_in(BoxState& boxes, unsigned id) {
    if (boxes.typed.box == id) return &boxes.typed;
    return boxes.left.box == id ? &boxes.left : nullptr;
}

void begin_typing(BoxState& boxes, unsigned id, const std::string& text, std::optional<double> before) {
    if (boxes.typed.box != 0 && boxes.typed.box != id) boxes.left = boxes.typed;
    boxes.typed = {
        .box = id, .text = text, .text_before = text, .before = before, .last_frame = ImGui::GetFrameCount()};
}

enum class Ending { None, Escaped, Unchanged, Wrong, Applied };

// How editing of the last drawn field has ended. Holds the text if it is to be applied.
struct FieldEnd {
    Ending ending = Ending::None;
    TypedText typed{};
};

FieldEnd end_of_field(BoxState& boxes, unsigned id) {
    TypedText* typed = typed_in(boxes, id);
    if (typed != nullptr) typed->last_frame = ImGui::GetFrameCount();
    if (typed == nullptr || !ImGui::IsItemDeactivated()) return {};
    FieldEnd end{.ending = Ending::Applied, .typed = std::move(*typed)};
    *typed = {};
    if (is_escape_pressed() || is_enter_pressed()) boxes.gives_keys_back = true;
    if (is_escape_pressed()) {
        end.ending = Ending::Escaped;
    } else if (!end.typed.wrong.empty()) {
        end.ending = Ending::Wrong;
    } else if (end.typed.text == end.typed.text_before && !end.typed.has_preview) {
        end.ending = Ending::Unchanged;
    }
    return end;
}

// Rejected text disappears from the field, so report why.
void report_invalid(InspectorContext& context, const FieldEnd& end) {
    if (end.ending == Ending::Wrong) {
        context.workspace.messages.warn("'" + end.typed.text + "' is not valid. " + end.typed.wrong);
    }
}

// ImGui shows the text before ## beside the field.
std::string hidden(const char* name) {
    return std::string("##") + name;
}

struct FieldLook {
    const char* name;
    const char* hint;
    const std::string& tip;
    float width_px;
};

// A one-line text field, red if the text is wrong. Returns whether the text has changed in this frame.
bool field(InspectorContext& context, const FieldLook& look, std::string& text, ArrowKeys* keys) {
    const TypedText* typed = typed_in(context.state.boxes, ImGui::GetID(hidden(look.name).c_str()));
    const std::string wrong = typed != nullptr ? typed->wrong : "";
    if (!wrong.empty()) {
        ImGui::PushStyleColor(ImGuiCol_FrameBg, tinted(context.theme.field, context.theme.error));
        ImGui::PushStyleColor(ImGuiCol_Border, to_colour(context.theme.error));
    }
    ImGui::SetNextItemWidth(look.width_px);
    const ImGuiInputTextFlags flags =
        ImGuiInputTextFlags_AutoSelectAll | (keys != nullptr ? ImGuiInputTextFlags_CallbackHistory : 0);
    const bool is_changed = ImGui::InputTextWithHint(hidden(look.name).c_str(), look.hint, &text, flags,
                                                     keys != nullptr ? step_by_arrow : nullptr, keys);
    if (!wrong.empty()) ImGui::PopStyleColor(2);
    if (!wrong.empty()) {
        show_tip(wrong);
    } else if (!ImGui::IsItemActive()) {
        show_tip(look.tip);  // no tooltip while typing: it would cover the fields below
    }
    return is_changed;
}

NumberEdit type_number(InspectorContext& context, const NumberBox& box, float width_px) {
    BoxState& boxes = context.state.boxes;
    const unsigned id = ImGui::GetID(hidden(box.name).c_str());
    const bool is_scrubbed =
        boxes.scrub.box != 0 && boxes.scrub.box == ImGui::GetID((std::string("drag ") + box.name).c_str());
    const TypedText* typed = typed_in(boxes, id);
    std::string text = typed != nullptr ? typed->text : text_of(box, is_scrubbed ? boxes.scrub.value : box.value);
    const std::string hint = box.standing_for ? text_of(box, box.standing_for) : "";
    ArrowKeys keys{.box = box};
    const std::string before = text;
    const bool is_changed = field(context, {box.name, hint.c_str(), box.tip, width_px}, text, &keys);
    note_widget(context, box.name);
    if (ImGui::IsItemActivated()) begin_typing(boxes, id, before, box.value);
    NumberEdit edit;
    if (is_changed && boxes.typed.box == id) {
        const ReadNumber read = read_number(box, text);
        boxes.typed.text = text;
        boxes.typed.wrong = read.wrong;
        if (keys.is_used) {
            boxes.typed.has_preview = true;
            edit = {.phase = EditPhase::Preview, .value = read.value, .before = boxes.typed.before};
        }
    }
    const FieldEnd end = end_of_field(boxes, id);
    report_invalid(context, end);
    if (end.ending == Ending::Applied) {
        edit = {
            .phase = EditPhase::Commit, .value = read_number(box, end.typed.text).value, .before = end.typed.before};
    } else if (end.typed.has_preview) {
        edit = {.phase = EditPhase::Rollback, .value = end.typed.before, .before = end.typed.before};
    }
    return edit;
}

void draw_handle(const InspectorContext& context, const NumberBox& box, const ImVec2& low, float width_px) {
    const bool is_lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
    const std::string label = elided(box.label, width_px);
    ImGui::GetWindowDrawList()->AddText(
        {low.x, low.y + ImGui::GetStyle().FramePadding.y},
        ImGui::GetColorU32(to_colour(is_lit ? context.theme.accent : context.theme.faint)), label.c_str());
}

NumberEdit drag_number(InspectorContext& context, const NumberBox& box, float width_px) {
    Scrub& scrub = context.state.boxes.scrub;
    const std::string name = std::string("drag ") + box.name;
    const unsigned id = ImGui::GetID(name.c_str());
    const ImVec2 low = ImGui::GetCursorScreenPos();
    drag_area(name.c_str(), {width_px, ImGui::GetFrameHeight()});
    note_widget(context, name);
    draw_handle(context, box, low, width_px);
    show_tip(box.tip.empty() ? "Drag to change" : box.tip + "\nDrag to change.");
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) context.output.cursor = MouseCursor::ResizeHorizontal;
    if (ImGui::IsItemActivated()) {
        const double before = box.value.value_or(box.standing_for.value_or(0));
        scrub = {.box = id, .before = before, .value = before};
    }
    if (scrub.box != id) return {};
    scrub.last_frame = ImGui::GetFrameCount();
    NumberEdit edit{.phase = EditPhase::None, .value = scrub.value, .before = scrub.before};
    if (ImGui::IsItemDeactivated()) {
        if (scrub.has_preview) edit.phase = EditPhase::Commit;
        scrub = {};
        return edit;
    }
    if (is_escape_pressed() && !scrub.is_given_up) {
        if (scrub.has_preview) edit = {.phase = EditPhase::Rollback, .value = scrub.before, .before = scrub.before};
        scrub.is_given_up = true;
        scrub.has_preview = false;
        scrub.value = scrub.before;
        return edit;
    }
    if (scrub.is_given_up || !ImGui::IsMouseDragging(ImGuiMouseButton_Left)) return edit;
    const float px_per_step = kPxPerStep * ImGui::GetFontSize() / 13;
    const double steps =
        std::trunc(ImGui::GetMouseDragDelta().x / px_per_step) * (ImGui::GetIO().KeyShift ? kFastStep : 1);
    const double value = steps == 0 ? scrub.before : limited(box, stepped(box, scrub.before, steps));
    if (value == scrub.value) return edit;
    scrub.value = value;
    scrub.has_preview = true;
    return {.phase = EditPhase::Preview, .value = value, .before = scrub.before};
}

}  // namespace

ReadNumber read_number(const NumberBox& box, const std::string& text) {
    if (text.find_first_not_of(' ') == std::string::npos) {
        return box.may_be_empty ? ReadNumber{} : ReadNumber{.wrong = "Enter a number"};
    }
    const std::optional<double> value = parse_quantity(text, box.unit);
    if (!value) {
        const bool is_whole = box.unit == Unit::Whole;
        return {.wrong =
                    is_whole ? "This is no whole number" : "This is no number. 12.5, 92/4+1 and (3 - 0.5) * 2 are"};
    }
    constexpr double kRounding = 1e-9;
    if (box.least && *value < *box.least - kRounding) {
        return {.wrong = "It is " + quantity_text(*box.least, box.unit) + " at least"};
    }
    if (box.most && *value > *box.most + kRounding) {
        return {.wrong = "It is " + quantity_text(*box.most, box.unit) + " at most"};
    }
    return {.value = value};
}

NumberEdit number_box(InspectorContext& context, const NumberBox& box) {
    float width = box.width_px;
    NumberEdit dragged;
    if (box.label[0] != '\0') {
        const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
        const float label = box.label_px > 0 ? box.label_px : ImGui::CalcTextSize(box.label).x;
        dragged = drag_number(context, box, label);
        ImGui::SameLine(0, gap);
        width -= label + gap;
    }
    const NumberEdit typed = type_number(context, box, std::max(width, ImGui::GetFontSize()));
    return typed ? typed : dragged;
}

std::optional<std::string> text_box(InspectorContext& context, const TextBox& box) {
    BoxState& boxes = context.state.boxes;
    const unsigned id = ImGui::GetID(hidden(box.name).c_str());
    const TypedText* typed = typed_in(boxes, id);
    std::string text = typed != nullptr ? typed->text : box.text;
    const std::string before = text;
    const bool is_changed = field(context, {box.name, box.hint.c_str(), box.tip, box.width_px}, text, nullptr);
    note_widget(context, box.name);
    if (ImGui::IsItemActivated()) begin_typing(boxes, id, before, {});
    if (is_changed && boxes.typed.box == id) {
        boxes.typed.text = text;
        boxes.typed.wrong = box.wrong != nullptr ? box.wrong(text) : "";
    }
    FieldEnd end = end_of_field(boxes, id);
    report_invalid(context, end);
    if (end.ending != Ending::Applied) return std::nullopt;
    return std::move(end.typed.text);
}

void apply_edit(InspectorContext& context, const NumberEdit& edit, const Command& command) {
    switch (edit.phase) {
        case EditPhase::None:
            break;
        case EditPhase::Preview:
            context.workspace.preview(command);
            break;
        case EditPhase::Commit:
            context.workspace.run(command);
            break;
        case EditPhase::Rollback:
            context.workspace.document->rollback();
            break;
    }
}

void forget_lost_boxes(InspectorContext& context) {
    BoxState& boxes = context.state.boxes;
    const int now = ImGui::GetFrameCount();
    const auto forget = [&](auto& entry) {
        if (entry.box == 0 || now - entry.last_frame < kLostAfter) return;
        if (entry.has_preview) context.workspace.document->commit();
        entry = {};
    };
    forget(boxes.typed);
    forget(boxes.left);
    forget(boxes.scrub);
}

namespace {

constexpr double kInch = 0.0254;  // m

struct UnitRow {
    double size = 1;  // SI value of one unit
    int decimals = 0;
    const char* word = "";
    double step = 1;  // in units
};

UnitRow row_of(Unit unit) {
    switch (unit) {
        case Unit::Centimetres:
            return {.size = 0.01, .decimals = 2, .word = " cm", .step = 0.1};
        case Unit::Millimetres:
            return {.size = 0.001, .decimals = 1, .word = " mm", .step = 0.1};
        case Unit::Degrees:
            return {.size = sim::kDegree, .decimals = 2, .word = "\u00B0", .step = 1};
        case Unit::Factor:
            return {.size = 1, .decimals = 4, .word = "", .step = 0.01};
        case Unit::Plain:
            return {.size = 1, .decimals = 3, .word = "", .step = 0.1};
        case Unit::GramsPerArea:
            return {.size = 1e-3, .decimals = 2, .word = " g/m\u00B2", .step = 1};
        case Unit::NewtonsPerMetre:
            return {.size = 1, .decimals = 3, .word = " N/m", .step = 1};
        case Unit::MicronewtonMetres:
            return {.size = 1e-6, .decimals = 3, .word = " \u00B5N\u00B7m", .step = 0.1};
        case Unit::Millinewtons:
            return {.size = 1e-3, .decimals = 4, .word = " mN", .step = 0.01};
        case Unit::Thickness:
            return {.size = 1e-3, .decimals = 4, .word = " mm", .step = 0.01};
        case Unit::PerSecond:
            return {.size = 1, .decimals = 3, .word = " /s", .step = 0.1};
        case Unit::Percent:
            return {.size = 0.01, .decimals = 3, .word = " %", .step = 0.1};
        case Unit::Whole:
            break;
    }
    return {};
}

bool is_length(Unit unit) {
    return unit == Unit::Centimetres || unit == Unit::Millimetres || unit == Unit::Thickness;
}

struct Suffix {
    std::string_view word;
    double size = 1;  // SI
    bool (*fits)(Unit) = nullptr;
};

template <Unit wanted>
bool is_unit(Unit unit) {
    return unit == wanted;
}

// Suffixes are tested in order: a suffix that ends in another one ("cm", "mm") comes before it ("m").
constexpr std::array<Suffix, 17> kSuffixes{{
    {"kg/m\u00B2", 1, is_unit<Unit::GramsPerArea>},
    {"g/m\u00B2", 1e-3, is_unit<Unit::GramsPerArea>},
    {"g/m2", 1e-3, is_unit<Unit::GramsPerArea>},
    {"N/m", 1, is_unit<Unit::NewtonsPerMetre>},
    {"\u00B5N\u00B7m", 1e-6, is_unit<Unit::MicronewtonMetres>},
    {"uNm", 1e-6, is_unit<Unit::MicronewtonMetres>},
    {"mN", 1e-3, is_unit<Unit::Millinewtons>},
    {"N", 1, is_unit<Unit::Millinewtons>},
    {"/s", 1, is_unit<Unit::PerSecond>},
    {"cm", 0.01, is_length},
    {"mm", 0.001, is_length},
    {"m", 1, is_length},
    {"in", kInch, is_length},
    {"\"", kInch, is_length},
    {"\u00B0", sim::kDegree, [](Unit unit) { return unit == Unit::Degrees; }},
    {"deg", sim::kDegree, [](Unit unit) { return unit == Unit::Degrees; }},
    {"%", 0.01, [](Unit unit) { return unit == Unit::Factor || unit == Unit::Percent; }},
}};

std::string_view without_blanks_behind(std::string_view text) {
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

}  // namespace

std::string quantity_number(double value, Unit unit) {
    const UnitRow row = row_of(unit);
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.*f", row.decimals, value / row.size);
    std::string text = buffer;
    if (text.find('.') != std::string::npos) {
        while (text.back() == '0') text.pop_back();
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string quantity_text(double value, Unit unit) {
    return quantity_number(value, unit) + row_of(unit).word;
}

std::optional<double> parse_quantity(std::string_view text, Unit unit) {
    text = without_blanks_behind(text);
    double size = row_of(unit).size;
    for (const Suffix& suffix : kSuffixes) {
        if (!suffix.fits(unit) || !text.ends_with(suffix.word)) continue;
        text = without_blanks_behind(text.substr(0, text.size() - suffix.word.size()));
        size = suffix.size;
        break;
    }
    const std::optional<double> figure = evaluate(text);
    if (!figure || !std::isfinite(*figure * size)) return std::nullopt;
    if (unit == Unit::Whole && (*figure != std::round(*figure) || std::abs(*figure) > 1e9)) return std::nullopt;
    return *figure * size;
}

double step_of(Unit unit) {
    const UnitRow row = row_of(unit);
    return row.step * row.size;
}

double stepped(double value, Unit unit, double steps) {
    const double step = step_of(unit);
    return std::round((value + steps * step) / step) * step;
}

namespace {

constexpr float kRoomBeside = 23;  // font heights; in a narrower window the fields are drawn below their label

// For example "Place, cm": fields side by side are too narrow for their own units.
std::string with_unit(const char* label, Unit unit) {
    switch (unit) {
        case Unit::Centimetres:
            return std::string(label) + ", cm";
        case Unit::Millimetres:
            return std::string(label) + ", mm";
        case Unit::Degrees:
            return std::string(label) + ", \u00B0";
        default:
            return label;
    }
}

float begin_row(InspectorContext& context, const VectorRow& row) {
    const float all = ImGui::GetContentRegionAvail().x;
    const std::string label = with_unit(row.label, row.unit);
    if (all >= kRoomBeside * ImGui::GetFontSize()) {
        row_label(context, label.c_str(), row.tip);
        return ImGui::GetContentRegionAvail().x;
    }
    elided_text(label, all, to_colour(context.theme.faint));
    show_tip(row.tip);
    return all;
}

VectorEdit draw_row(InspectorContext& context, const VectorRow& row, std::span<const double> values) {
    constexpr std::array<const char*, 3> kEndings{".x", ".y", ".z"};
    const float all = begin_row(context, row), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const auto count = static_cast<float>(values.size());
    const float width = std::floor((all - gap * (count - 1)) / count);
    float axis_width = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        axis_width = std::max(axis_width, ImGui::CalcTextSize(row.axes[i]).x);
    VectorEdit edit;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string name = std::string(row.name) + kEndings[i];
        if (i > 0) ImGui::SameLine(0, gap);
        const NumberEdit number = number_box(context, {.name = name.c_str(),
                                                       .label = row.axes[i],
                                                       .value = values[i],
                                                       .unit = row.unit,
                                                       .tip = row.tip,
                                                       .width_px = width,
                                                       .label_px = axis_width,
                                                       .least = row.least,
                                                       .has_unit = false});
        if (number) edit = {.phase = number.phase, .axis = static_cast<int>(i), .number = number};
    }
    return edit;
}

}  // namespace

VectorEdit vector_row(InspectorContext& context, const VectorRow& row, const Vec3d& value) {
    return draw_row(context, row, std::span(value.data(), 3));
}

VectorEdit vector_row(InspectorContext& context, const VectorRow& row, const Vec2d& value) {
    return draw_row(context, row, std::span(value.data(), 2));
}

Vec3d edited(Vec3d value, const VectorEdit& edit) {
    if (edit.number.value) value[edit.axis] = *edit.number.value;
    return value;
}

Vec2d edited(Vec2d value, const VectorEdit& edit) {
    if (edit.number.value) value[edit.axis] = *edit.number.value;
    return value;
}

NumberEdit number_row(InspectorContext& context, NumberBox box, const char* label) {
    box.label = label;
    box.label_px = label_width();
    box.width_px = label_width() + ImGui::GetStyle().ItemInnerSpacing.x + field_width();
    return number_box(context, box);
}

}  // namespace selvedge::editor
