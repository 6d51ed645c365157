#pragma once
// Two or three numbers that belong together, side by side: X, Y and Z; below their label where there is little room.
#include <array>
#include <optional>
#include <string>

#include "editor/inspectors/number_box.h"
#include "sim/core/vec.h"

namespace selvedge {

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

}  // namespace selvedge
