#include "app/frame_times.h"

#include <iomanip>

#include "sim/core/error.h"

namespace selvedge {

FrameTimesFile::FrameTimesFile(const std::string& path) : file_(path) {
    if (!file_) throw InputError(path, "", "cannot be written");
    file_ << "frame,total_ms,events_and_ui_ms,scenes_ms,ui_draw_ms,swap_ms\n" << std::fixed << std::setprecision(3);
}

void FrameTimesFile::add(const FrameTimes& times) {
    file_ << frame_++ << ',' << times.total() << ',' << times.events_and_ui << ',' << times.scenes << ','
          << times.ui_draw << ',' << times.swap << std::endl;  // can be read meanwhile
}

}  // namespace selvedge
