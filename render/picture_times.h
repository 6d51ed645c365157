#pragma once
// Where a picture's time goes, for benchmarks: wall clock, in milliseconds.
#include <chrono>

struct GladGLContext;

namespace selvedge {

struct PictureTimes {
    double compare = 0;     // what has changed since the last picture
    double room_light = 0;  // baking
    double upload = 0;
    double shadow = 0;  // the key light's depth map
    double mask = 0;    // which pixels see the key light
    double draw = 0;
    double finish = 0;  // resolving samples, encoding
    double read_back = 0;
};

// Charges the time since the last lap to a part, after waiting for GL. Does nothing, and waits for nothing, without
// times to charge.
class PartClock {
 public:
    PartClock(const GladGLContext& gl, PictureTimes* times);
    void lap(double PictureTimes::*part);

 private:
    const GladGLContext& gl_;
    PictureTimes* times_;
    std::chrono::steady_clock::time_point last_;
};

}  // namespace selvedge
