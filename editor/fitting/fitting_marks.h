#pragma once
// Marks on the garment and round the body: what is selected, under the cursor or wrong, threads of open seams, pins,
// arrangement points. Balls and tubes of one surface.
#include <optional>
#include <vector>

#include "editor/document/hover.h"
#include "editor/document/selection.h"
#include "editor/drafting/draft_error.h"
#include "editor/fitting/fitting_colours.h"
#include "editor/fitting/seen_garment.h"
#include "sim/dress/arrangement.h"

namespace selvedge {

struct FittingMarks {
    Selection selection{};
    Hover hover{};
    std::vector<DraftPlace> wrong{};  // places that a message names
    bool has_threads = true;          // of seams that are not closed
    bool has_points = false;          // arrangement points
    std::optional<std::size_t> hovered_point{};
    std::optional<Vec3f> pulled_to{};  // m
    float size = 0.0028F;              // m, of a pixel of the view, about: marks keep their size on the screen

    bool operator==(const FittingMarks&) const = default;
};

// A size in coarse steps, so that a zooming camera seldom asks for other marks.
float coarse_size(float metres_per_px);

SolidItem make_marks(const Pattern& pattern, const SeenGarment& garment, const std::vector<ArrangementPoint>& points,
                     const FittingMarks& marks, const FittingColours& colours);

}  // namespace selvedge
