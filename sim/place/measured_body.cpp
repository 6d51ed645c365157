#include "sim/place/measured_body.h"

#include "sim/place/shoulder_top.h"

namespace selvedge::sim {

const LandmarkHeights& MeasuredBody::landmarks() const {
    std::call_once(has_landmarks_, [&] { landmarks_ = find_landmarks(body_); });
    return landmarks_;
}

const Stature& MeasuredBody::stature() const {
    std::call_once(has_stature_, [&] { stature_ = find_stature(body_, landmarks()); });
    return stature_;
}

const Proportions& MeasuredBody::proportions() const {
    std::call_once(has_proportions_, [&] { proportions_ = find_proportions(body_, stature()); });
    return proportions_;
}

const BodyLimbs& MeasuredBody::limbs() const {
    std::call_once(has_limbs_, [&] { limbs_ = find_limbs(body_, stature()); });
    return limbs_;
}

const std::optional<double>& MeasuredBody::shoulder_top() const {
    std::call_once(has_shoulder_top_, [&] { shoulder_top_ = find_shoulder_top(*this); });
    return shoulder_top_;
}

const LevelSections& MeasuredBody::sections() const {
    std::call_once(has_sections_, [&] { sections_ = std::make_unique<const LevelSections>(body_); });
    return *sections_;
}

}  // namespace selvedge::sim
