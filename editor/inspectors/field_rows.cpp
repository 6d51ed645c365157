#include "editor/inspectors/field_rows.h"

#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "editor/document/field_json.h"
#include "editor/inspectors/controls.h"
#include "editor/inspectors/number_box.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::editor {
namespace {

Unit unit_of(sim::Measure measure) {
    if (measure == sim::Measure::SmallLength) return Unit::Millimetres;
    if (sim::is_angle(measure)) return Unit::Degrees;
    return measure == sim::Measure::Plain ? Unit::Plain : Unit::Centimetres;
}

std::optional<double> limit(double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string capitalised(std::string_view word) {
    std::string text(word);
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

std::string wrong_colour(const std::string& text) {
    return sim::is_colour_text(text) ? "" : "#RRGGBB is a colour";
}

// Types that a row can show: numbers, words, texts, flags and parts of these.
template <class T>
constexpr bool has_row = std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::string> ||
                         std::is_same_v<T, Vec2d> || sim::Described<T>;
template <class T>
constexpr bool has_row<std::optional<T>> = std::is_same_v<T, double> || sim::Described<T>;

// Draws the row of a value and changes the value as it is edited.
class FieldRows {
 public:
    FieldRows(InspectorContext& context, std::string prefix) : context_(context), prefix_(std::move(prefix)) {}

    EditPhase draw(const auto& field, double& value) const {
        const NumberEdit edit = number(field, {.value = value, .unit = unit_of(field.measure)});
        if (edit) value = edit.value.value_or(value);
        return edit.phase;
    }
    EditPhase draw(const auto& field, int& value) const {
        const NumberEdit edit = number(field, {.value = value, .unit = Unit::Whole});
        if (edit) value = static_cast<int>(edit.value.value_or(value));
        return edit.phase;
    }
    // `standing`: what it stands for where it is not set.
    EditPhase draw(const auto& field, std::optional<double>& value, const std::optional<double>& standing) const {
        const NumberEdit edit = number(
            field, {.value = value, .unit = unit_of(field.measure), .may_be_empty = true, .standing_for = standing});
        if (edit) value = edit.value;
        return edit.phase;
    }
    EditPhase draw(const auto& field, bool& value) const {
        const std::string name = name_of(field), label(field.row.label);
        if (!check_box(context_, name.c_str(), label.c_str(), value, std::string(field.row.tip)))
            return EditPhase::None;
        value = !value;
        return EditPhase::Commit;
    }
    template <class T>
    requires std::is_enum_v<T> EditPhase draw(const auto& field, T& value)
    const {
        const std::string name = name_of(field), label(field.row.label), tip(field.row.tip);
        std::vector<std::string> items;
        for (const std::string_view word : names_of(T{}).texts) items.push_back(capitalised(word));
        const auto chosen = static_cast<std::size_t>(value);
        row_label(context_, label.c_str(), tip);
        const int now = choice_box(context_, {.name = name.c_str(),
                                              .shown = items[chosen],
                                              .items = items,
                                              .chosen = static_cast<int>(chosen),
                                              .width_px = field_width()});
        if (now < 0) return EditPhase::None;
        value = static_cast<T>(now);
        return EditPhase::Commit;
    }
    EditPhase draw(const auto& field, Vec2d& value) const {
        const std::string name = name_of(field), label(field.row.label);
        const VectorEdit edit = vector_row(context_,
                                           {.name = name.c_str(),
                                            .label = label.c_str(),
                                            .unit = unit_of(field.measure),
                                            .tip = std::string(field.row.tip)},
                                           value);
        if (edit) value = edited(value, edit);
        return edit.phase;
    }
    EditPhase draw(const auto& field, std::string& value) const {
        const std::string name = name_of(field), label(field.row.label), tip(field.row.tip);
        row_label(context_, label.c_str(), tip);
        const auto text = text_box(context_, {.name = name.c_str(),
                                              .text = value,
                                              .hint = std::string(field.row.hint),
                                              .tip = tip,
                                              .width_px = field_width(),
                                              .wrong = field.measure == sim::Measure::Colour ? wrong_colour : nullptr});
        if (text) value = *text;
        return text ? EditPhase::Commit : EditPhase::None;
    }
    template <sim::Described Part>
    EditPhase draw(const auto& field, Part& part) const {
        const FieldRows inner(context_, name_of(field) + ".");
        EditPhase phase = EditPhase::None;
        const Part usual{};
        sim::visit_fields(part, [&](const auto& one, auto& value) {
            const EditPhase now = inner.draw_if_shown(one, value, usual.*one.member);
            if (now != EditPhase::None) phase = now;
        });
        return phase;
    }
    template <sim::Described Part>
    EditPhase draw(const auto& field, std::optional<Part>& value) const {
        const std::string name = name_of(field), label(field.row.label);
        if (check_box(context_, name.c_str(), label.c_str(), value.has_value(), std::string(field.row.tip))) {
            value = value ? std::nullopt : std::optional(Part());
            return EditPhase::Commit;
        }
        return value ? draw(field, *value) : EditPhase::None;
    }

    // The row of a field that has one. `standing`: what a number stands for where it is not set.
    template <class T>
    EditPhase draw_if_shown(const auto& field, T& value, const T& standing) const {
        if constexpr (!has_row<T>) {
            return EditPhase::None;
        } else if (field.row.label.empty()) {
            return EditPhase::None;
        } else if constexpr (std::is_same_v<T, std::optional<double>>) {
            return draw(field, value, standing);
        } else {
            return draw(field, value);
        }
    }

 private:
    std::string name_of(const auto& field) const { return prefix_ + std::string(field.name); }

    NumberEdit number(const auto& field, NumberBox box) const {
        const std::string name = name_of(field), label(field.row.label);
        box.name = name.c_str();
        box.tip = field.row.tip;
        box.least = limit(field.range.least);
        box.most = limit(field.range.most);
        return number_row(context_, std::move(box), label.c_str());
    }

    InspectorContext& context_;
    std::string prefix_;
};

template <sim::Described Part>
void draw_rows(InspectorContext& context, const SetFields& of, const std::string& prefix, const Part& part,
               const Part& standing = {}) {
    const FieldRows rows(context, prefix);
    sim::visit_fields(part, [&]<class T>(const auto& field, const T& held) {
        if constexpr (has_row<T>) {
            T value = held;
            const EditPhase phase = rows.draw_if_shown(field, value, standing.*field.member);
            if (phase == EditPhase::None) return;
            SetFields command = of;
            command.values = sim::Json::object();
            command.values[field.journal] = encode(value);
            apply_edit(context, {.phase = phase}, command);
        }
    });
}

}  // namespace

void field_rows(InspectorContext& context, const SetFields& of, const sim::OutlineEdge& edge,
                const sim::OutlineEdge& standing) {
    draw_rows(context, of, "edge.", edge, standing);
}

void field_rows(InspectorContext& context, const SetFields& of, const sim::InternalLine& line) {
    draw_rows(context, of, "line.", line);
}

void field_rows(InspectorContext& context, const SetFields& of, const sim::Notch& notch) {
    draw_rows(context, of, "notch.", notch);
}

void field_rows(InspectorContext& context, const SetFields& of, const sim::Panel& panel, const sim::Panel& standing) {
    draw_rows(context, of, "panel.", panel, standing);
}

void field_rows(InspectorContext& context, const SetFields& of, const sim::Seam& seam) {
    draw_rows(context, of, "seam.", seam);
}

void field_rows(InspectorContext& context, const sim::Pattern& pattern, const sim::Pattern& standing) {
    draw_rows(context, {.part = FieldOwner::Pattern}, "pattern.", pattern, standing);
}

}  // namespace selvedge::editor
