#pragma once
// The command that sets any property of any part of a pattern (see command.h).
#include <array>
#include <string>
#include <string_view>

#include "sim/core/json.h"
#include "sim/pattern/enum_names.h"

namespace selvedge::editor {

enum class FieldOwner { Pattern, Panel, Edge, InternalLine, Notch, Seam };

constexpr sim::EnumNames<FieldOwner, 6> names_of(FieldOwner) {
    return {{"pattern", "panel", "edge", "internal_line", "notch", "seam"}};
}

// Sets fields that are keys of the part in garment files (sim/pattern/pattern_fields.h), by the names that commands
// have for them: {"part": "seam", "index": 3, "values": {"rows": 2}}. Neither names nor what makes the part's shape. Of
// a seam: of all seams of its sewing.
struct SetFields {
    static constexpr const char* name = "set_fields";
    FieldOwner part = FieldOwner::Seam;
    std::string panel{};  // itself, or of an edge, line or notch
    int index = 0;        // of an edge, line or notch in its panel; of a seam in the pattern
    sim::Json values{};   // an object

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("part", part);
        visit("panel", panel);
        visit("index", index);
        visit("values", values);
    }
};

}  // namespace selvedge::editor
