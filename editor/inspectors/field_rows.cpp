#include "editor/inspectors/field_rows.h"

#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "editor/document/field_json.h"
#include "editor/inspectors/controls.h"
#include "editor/inspectors/number_box.h"
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

std::string wrong_colour(const std::string& text) {
    return sim::is_colour_text(text) ? "" : "#RRGGBB is a colour";
}

// Draws the row of a value and changes the value as it is edited.
class FieldRows {
 public:
    FieldRows(InspectorContext& context, std::string prefix) : context_(context), prefix_(std::move(prefix)) {}

    EditPhase draw(const auto& field, double& value) const { return number(field, value, unit_of(field.measure)); }
    EditPhase draw(const auto& field, int& value) const {
        double number_value = value;
        const EditPhase phase = number(field, number_value, Unit::Whole);
        value = static_cast<int>(number_value);
        return phase;
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
        sim::visit_fields(part, [&](const auto& one, auto& value) {
            if constexpr (requires { inner.draw(one, value); }) {
                if (one.row.label.empty()) return;
                const EditPhase now = inner.draw(one, value);
                if (now != EditPhase::None) phase = now;
            }
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

 private:
    std::string name_of(const auto& field) const { return prefix_ + std::string(field.name); }

    EditPhase number(const auto& field, double& value, Unit unit) const {
        const std::string name = name_of(field), label(field.row.label);
        const NumberEdit edit = number_row(context_,
                                           {.name = name.c_str(),
                                            .value = value,
                                            .unit = unit,
                                            .tip = std::string(field.row.tip),
                                            .least = limit(field.range.least),
                                            .most = limit(field.range.most)},
                                           label.c_str());
        if (edit) value = edit.value.value_or(value);
        return edit.phase;
    }

    InspectorContext& context_;
    std::string prefix_;
};

template <sim::Described Part>
void draw_rows(InspectorContext& context, const SetFields& of, const std::string& prefix, Part part) {
    const FieldRows rows(context, prefix);
    sim::visit_fields(part, [&](const auto& field, auto& value) {
        if constexpr (requires { rows.draw(field, value); }) {
            if (field.row.label.empty()) return;
            const EditPhase phase = rows.draw(field, value);
            if (phase == EditPhase::None) return;
            SetFields command = of;
            command.values = sim::Json::object();
            command.values[field.journal] = encode(value);
            apply_edit(context, {.phase = phase}, command);
        }
    });
}

}  // namespace

void field_rows(InspectorContext& context, const SetFields& of, const sim::OutlineEdge& edge) {
    draw_rows(context, of, "edge.", edge);
}

void field_rows(InspectorContext& context, const SetFields& of, const sim::InternalLine& line) {
    draw_rows(context, of, "line.", line);
}

void field_rows(InspectorContext& context, const SetFields& of, const sim::Seam& seam) {
    draw_rows(context, of, "seam.", seam);
}

}  // namespace selvedge::editor
