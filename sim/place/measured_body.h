#pragma once
// A body with its landmarks, stature, proportions, limbs, level sections and shoulders. Each is found once, when it is
// first asked for.
#include <memory>
#include <mutex>
#include <optional>

#include "sim/body/body.h"
#include "sim/body/landmarks.h"
#include "sim/body/section.h"
#include "sim/place/limbs.h"
#include "sim/place/proportions.h"

namespace selvedge::sim {

// Several threads may ask at the same time.
class MeasuredBody {
 public:
    explicit MeasuredBody(const Body& body) : body_(body) {}  // must outlive it
    explicit MeasuredBody(const Body&& body) = delete;
    MeasuredBody(const MeasuredBody&) = delete;
    MeasuredBody& operator=(const MeasuredBody&) = delete;

    const Body& body() const { return body_; }
    const LandmarkHeights& landmarks() const;
    const Stature& stature() const;
    const Proportions& proportions() const;
    const BodyLimbs& limbs() const;
    const std::optional<double>& shoulder_top() const;  // m: find_shoulder_top()
    const LevelSections& sections() const;

 private:
    const Body& body_;
    mutable std::once_flag has_landmarks_, has_stature_, has_proportions_, has_limbs_, has_sections_, has_shoulder_top_;
    mutable LandmarkHeights landmarks_;
    mutable Stature stature_;
    mutable Proportions proportions_;
    mutable BodyLimbs limbs_;
    mutable std::unique_ptr<const LevelSections> sections_;
    mutable std::optional<double> shoulder_top_;
};

}  // namespace selvedge::sim
