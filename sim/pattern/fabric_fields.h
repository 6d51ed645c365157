#pragma once
// The fields of a fabric (see sim/pattern/pattern_fields.h), in the order in which its files get new keys. Values are
// in the units of Fabric in files too, lengths in metres.
#include "sim/pattern/fabric.h"
#include "sim/pattern/field.h"

namespace selvedge::sim {

inline constexpr std::tuple kFabricFields{
    Field<&Fabric::name, FileForm::ByHand>{.name = "name"},
    Field<&Fabric::area_density, FileForm::Required>{.name = "area_density", .range = {0.005, 5}},
    Field<&Fabric::stretch_warp, FileForm::Required>{.name = "stretch_warp", .range = {10, 1e6}},
    Field<&Fabric::stretch_weft, FileForm::Required>{.name = "stretch_weft", .range = {10, 1e6}},
    Field<&Fabric::shear, FileForm::Required>{.name = "shear", .range = {0.1, 1e5}},
    Field<&Fabric::bending_warp, FileForm::Required>{.name = "bending_warp", .range = {0, 0.1}},
    Field<&Fabric::bending_weft, FileForm::Required>{.name = "bending_weft", .range = {0, 0.1}},
    Field<&Fabric::bending_hysteresis>{.name = "bending_hysteresis", .range = {0, 1}},
    Field<&Fabric::shear_hysteresis>{.name = "shear_hysteresis", .range = {0, 1e3}},
    Field<&Fabric::thickness, FileForm::Required>{.name = "thickness", .range = {1e-5, 0.02}},
    Field<&Fabric::friction>{.name = "friction", .range = {0, 2}},
    Field<&Fabric::damping>{.name = "damping", .range = {0, 100}},
    Field<&Fabric::air_drag>{.name = "air_drag", .range = {0, 100}},
    Field<&Fabric::strain_limit>{.name = "strain_limit", .range = {1e-4, 2}},
    Field<&Fabric::gloss>{.name = "gloss", .range = {0, 1}},
    Field<&Fabric::roughness>{.name = "roughness", .range = {0.05, 1}},
    Field<&Fabric::sheen>{.name = "sheen", .range = {0, 1}},
    Field<&Fabric::surface, FileForm::ByHand>{.name = "surface"},
};

constexpr const auto& fields(const Fabric*) {
    return kFabricFields;
}

// Names as many members as the struct has, or it does not compile.
inline auto members(const Fabric& part) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r] = part;
    return counted(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r);
}
static_assert(decltype(members(std::declval<const Fabric&>()))::size() ==
              std::tuple_size_v<std::remove_cvref_t<decltype(kFabricFields)>>);

}  // namespace selvedge::sim
