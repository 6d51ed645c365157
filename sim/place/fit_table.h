#pragma once
// The fit table of a dressed garment: the girths that a tailor measures, of the body and of the garment at the same
// place, and the ease between them. A girth of the body is a tape's length; one of the garment is measured in the cloth
// as it was cut out, so that stretch does not count.
#include <optional>
#include <string_view>
#include <vector>

#include "sim/body/section.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/place/measured_body.h"

namespace selvedge::sim {

// Where a girth is measured, and how.
struct FitRow {
    std::string_view measure;               // "bust", "waist", "hip", "neck", "left_sleeve", ..., "right_thigh"
    std::optional<double> body_girth{};     // m; none: the body has no such part
    std::optional<double> garment_girth{};  // m, of the innermost loop there; none: the garment does not go round it
    std::optional<Plane> plane{};           // of the body's girth

    // Garment less body, m; negative where the cloth must stretch. None if either is missing.
    std::optional<double> ease() const {
        if (!body_girth || !garment_girth) return std::nullopt;
        return *garment_girth - *body_girth;
    }
};

// Rows, always these in this order: bust, waist, hip, neck, left_sleeve, right_sleeve, left_thigh, right_thigh, of the
// body where body_girths.h measures them. None of the trunk goes round the arms too, so that a cape has no bust; a
// skirt, which goes round both legs, has no thigh. A garment that does not go round the bust alone is measured where it
// does so next below, as tailors measure a chest under the armholes, but not below the middle between waist and bust:
// trousers have no bust. One that begins below the waist, as a skirt, is measured at its upper edge, if that is above
// the hips. Pre: as for tight_levels().
std::vector<FitRow> measure_fit(const DrawMesh& garment, const MeasuredBody& body);

}  // namespace selvedge::sim
