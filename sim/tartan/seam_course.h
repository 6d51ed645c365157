#pragma once
// Where a seam runs in the fabric, on both of its sides at once: material coordinates only, no cloth and no pixels.
// Points lie at equal fractions of each side's length, in the direction in which the sides are sewn.
#include <optional>
#include <vector>

#include "sim/core/vec.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

struct CoursePoint {
    Vec2d first =
        Vec2d::Zero();  // m, (weft, warp) in the fabric of the first side, turned to the grain, without offset
    Vec2d second = Vec2d::Zero();  // the same of the other side
    // How squarely the seam crosses the warp's stripes (x) and the weft's (y): the sine of its angle to them, as the
    // mean of both sides. 0: it runs along them.
    Vec2d crossing = Vec2d::Zero();
};

struct SeamCourse {
    double first_length = 0;  // m
    double second_length = 0;
    std::vector<CoursePoint> points;  // evenly spaced, both ends included
    // Over the seam, the mean product of both sides' directions, per family: negative where they run through the sett
    // in opposite directions, as at a chevron.
    Vec2d agreement = Vec2d::Zero();
    bool is_eased = false;    // its sides differ by more than 1 mm
    std::size_t anchor = 0;   // of an eased seam, the point where a tailor begins to match: see find_course
    bool is_upright = false;  // its ends differ in height by half its length or more
};

// An eased or gathered seam is matched from its lower end, as the panels stand in the room: from the hem, or from the
// armhole's bottom; one that lies level is matched in its middle. Pre: the seam's panels and edges are there.
SeamCourse find_course(const Pattern& pattern, const Seam& seam);

}  // namespace selvedge
