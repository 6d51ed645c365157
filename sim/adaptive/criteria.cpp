#include "sim/adaptive/criteria.h"

#include <cmath>

namespace selvedge {

CurvatureCriterion::CurvatureCriterion(const std::vector<Vec3f>& normals, const CurvatureOptions& options)
    : normals_(normals), split_cosine_(std::cos(options.split_angle)), rejoin_cosine_(std::cos(options.rejoin_angle)) {
    SELVEDGE_ASSERT(options.rejoin_angle < options.split_angle);
}

}  // namespace selvedge
