#pragma once
// A body with its landmarks, stature and limbs. Each is found once, when it is first asked for.
#include <mutex>

#include "sim/body/body.h"
#include "sim/body/landmarks.h"
#include "sim/place/limbs.h"

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
    const BodyLimbs& limbs() const;

 private:
    const Body& body_;
    mutable std::once_flag has_landmarks_, has_stature_, has_limbs_;
    mutable LandmarkHeights landmarks_;
    mutable Stature stature_;
    mutable BodyLimbs limbs_;
};

}  // namespace selvedge::sim
