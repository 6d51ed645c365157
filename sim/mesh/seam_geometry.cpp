#include "sim/mesh/seam_geometry.h"

#include <algorithm>

#include "sim/core/assert.h"

namespace selvedge {

double seam_rest_length(double left_length, double right_length, const SeamLengthOptions& options) {
    const double shorter = std::min(left_length, right_length);
    const double longer = std::max(left_length, right_length);
    return longer - shorter <= options.ease * shorter ? 0.5 * (shorter + longer) : shorter;
}

Vec2d unfold_across(const EdgeCopy& into, const EdgeCopy& from, const Vec2d& opposite) {
    const Vec2d along_into = into.b - into.a;
    const Vec2d along_from = from.b - from.a;
    const double lengths = along_into.norm() * along_from.norm();
    SELVEDGE_ASSERT(lengths > 0);
    const double cosine = along_from.dot(along_into) / lengths;
    const double sine = cross2(along_from, along_into) / lengths;
    const Vec2d arm = opposite - 0.5 * (from.a + from.b);
    const Vec2d turned(cosine * arm.x() - sine * arm.y(), sine * arm.x() + cosine * arm.y());
    return 0.5 * (into.a + into.b) + turned;
}

}  // namespace selvedge
