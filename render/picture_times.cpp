#include "render/picture_times.h"

#include "render/gl/gl.h"

namespace selvedge {

PartClock::PartClock(const GladGLContext& gl, PictureTimes* times)
    : gl_(gl), times_(times), last_(std::chrono::steady_clock::now()) {
    if (times_ != nullptr) *times_ = {};
}

void PartClock::lap(double PictureTimes::*part) {
    if (times_ == nullptr) return;
    gl_.Finish();
    const auto now = std::chrono::steady_clock::now();
    times_->*part += std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
}

}  // namespace selvedge
