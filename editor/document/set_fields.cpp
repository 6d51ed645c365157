#include "editor/document/set_fields.h"

#include <string>
#include <string_view>
#include <vector>

#include "editor/document/field_json.h"
#include "editor/geometry/draft.h"
#include "editor/geometry/outline_edit.h"
#include "editor/geometry/sewing.h"
#include "sim/core/error.h"
#include "sim/pattern/limits.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::editor {
namespace {

template <class T>
constexpr bool is_list_v = false;
template <class T>
constexpr bool is_list_v<std::vector<T>> = true;

// Whether the part has a property with this name: neither a name of its own, nor its shape or place, nor its parts.
template <sim::Described Part>
bool has_property(std::string_view name) {
    bool is_found = false;
    const Part usual{};
    sim::visit_fields(usual, [&]<class SomeField, class T>(const SomeField& field, const T&) {
        const bool may_be_set = SomeField::is_key && field.descent == sim::Descent::Kept && !is_list_v<T>;
        is_found = is_found || (may_be_set && field.journal == name);
    });
    return is_found;
}

template <sim::Described Part>
void set_values(Part& part, const sim::Json& values) {
    if (!values.is_object()) throw GeometryError("The values of a part's fields are an object");
    for (const sim::Json::Member& value : values.members()) {
        if (!has_property<Part>(value.key)) throw GeometryError("'" + value.key + "' is no property that can be set");
    }
    try {
        decode(sim::JsonView(values, "", "values"), part);
    } catch (const sim::InputError& error) {
        throw GeometryError(error.place() + ": " + error.problem());
    }
}

template <class Part>
void require_within_limits(const Part& part) {
    for (const sim::LimitFault& fault : limit_faults(part)) throw GeometryError(fault.place + ": " + fault.problem);
}

template <class T>
T& part_at(std::vector<T>& parts, int index, const std::string& panel, const std::string& what) {
    if (index >= 0 && as_size(index) < parts.size()) return parts[as_size(index)];
    throw GeometryError("'" + panel + "' has no " + what + " " + std::to_string(index), {{.panel = panel}});
}

void set_in_panel(sim::Panel& panel, const SetFields& command) {
    switch (command.part) {
        case FieldOwner::Edge:
            return set_values(part_at(panel.edges, command.index, panel.name, "edge"), command.values);
        case FieldOwner::InternalLine:
            return set_values(part_at(panel.internal_lines, command.index, panel.name, "internal line"),
                              command.values);
        case FieldOwner::Notch:
            return set_values(part_at(panel.notches, command.index, panel.name, "notch"), command.values);
        default:
            break;
    }
    set_values(panel, command.values);
    if (panel.wrap_radius > 0 && panel.wrap_cone)
        throw GeometryError("A panel has wrap_radius or wrap_cone, not both", {{.panel = panel.name}});
}

}  // namespace

void set_fields(sim::Pattern& pattern, const SetFields& command) {
    if (command.part == FieldOwner::Pattern) {
        set_values(pattern, command.values);
        return require_within_limits(pattern);
    }
    if (command.part == FieldOwner::Seam) {
        for (const int seam : sewing_of(pattern, command.index)) {
            set_values(pattern.seams[as_size(seam)], command.values);
            require_within_limits(pattern.seams[as_size(seam)]);
        }
        return;
    }
    sim::Panel& panel = pattern.panels[as_size(find_panel(pattern, command.panel))];
    set_in_panel(panel, command);
    require_within_limits(panel);
}

}  // namespace selvedge::editor
