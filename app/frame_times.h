#pragma once
// Where the editor's frames take their time, as a table that `--frame-times` writes.
#include <fstream>
#include <string>

namespace selvedge {

// ms of one frame by wall clock, without waiting for the person.
struct FrameTimes {
    double events_and_ui = 0;
    double scenes = 0;
    double ui_draw = 0;
    double swap = 0;

    double total() const { return events_and_ui + scenes + ui_draw + swap; }
};

class FrameTimesFile {
 public:
    // Throws InputError when it cannot be written.
    explicit FrameTimesFile(const std::string& path);

    void add(const FrameTimes& times);

 private:
    std::ofstream file_;
    long frame_ = 0;
};

}  // namespace selvedge
