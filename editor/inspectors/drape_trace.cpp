#include "editor/inspectors/drape_trace.h"

namespace selvedge {

void DrapeTrace::take(const SessionFrame& frame) {
    if (frame.number < last_number_) *this = {};
    if (frame.number == last_number_) return;
    last_number_ = frame.number;
    if (!frame.is_running) return;
    if (size_ == kLength) {
        first_ = (first_ + 1) % kLength;
    } else {
        ++size_;
    }
    rows_[place(size_ - 1)] = {.frame_ms = static_cast<float>(frame.statistics.times.frame),
                               .triangles = static_cast<float>(frame.statistics.leaf_triangles)};
}

}  // namespace selvedge
