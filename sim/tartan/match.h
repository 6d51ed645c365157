#pragma once
// Matches a sett at seams: computes the sett offset of each panel so that stripes continue across the seams. Uses only
// material coordinates along the seams; the stripes of warp and weft are matched independently.
//
// At a point s of a seam, a stripe that crosses it has the sett position p_first(s) + o_first on the first side, and
// should have the same position on the second side, modulo the repeat. If the two sides run through the sett in
// opposite directions (a chevron), a symmetric sett can be matched with its mirror image. Stripes parallel to a seam
// cannot meet there. They are matched last, with the remaining freedom, so that the sett also continues around the
// body.
//
// Priority of seams: first MatchOptions::first_seams, each strictly before the next; then seams that can meet within
// 6 mm along their whole length; then seams whose shape or ease prevents that. Within these groups, long seams that
// stripes cross nearly perpendicularly are joined first. Output is bit-identical for the same input. The order of the
// panels matters only for the choice of the panel that keeps its offset.
#include <optional>
#include <string>
#include <vector>

#include "sim/core/math.h"
#include "sim/pattern/pattern.h"
#include "sim/tartan/sett.h"

namespace selvedge::sim {

struct MatchOptions {
    std::vector<int> first_seams{};  // indices into Pattern::seams, most important first
    // Of panels that are joined by seams and can move together, the first in the pattern keeps its offset, or this one
    // if it is among them. This panel is also centred: the nearest mirror line of the warp's stripes, if there is one,
    // is moved to its middle.
    std::optional<int> centred_panel{};
};

// The result for one seam. The mismatch at a point of a seam is the distance, perpendicular to the stripes, between a
// stripe's position and the nearest position that continues it, at most half a repeat. Points are about 1 mm apart,
// with 64 to 1,024 segments per seam. A point counts if stripes cross the seam there at 15 degrees or more; of warp and
// weft the larger mismatch counts.
struct SeamMatch {
    int seam = 0;  // index into Pattern::seams
    std::string name;
    double length = 0;      // m, mean of both sides
    double before = 0;      // m, largest mismatch before matching
    double after = 0;       // m, largest mismatch after matching
    double rms_before = 0;  // m, root mean square mismatch
    double rms_after = 0;   // m
    double met = 0;         // share of the counted points, 0..1, with a mismatch of at most 2 mm after matching
    std::string why;        // why `after` exceeds 0.5 mm; empty: it does not
};

struct SettMatch {
    std::vector<Vec2d> offsets;    // m, new Panel::sett_offset per panel; rounded to 1e-6 m if changed
    std::vector<SeamMatch> seams;  // one per seam of the pattern, in its order
};

// Pre: the indices in the pattern and in the options are in range. Offsets that are not finite are treated as 0.
SettMatch match_sett(const Pattern& pattern, const Sett& sett, const MatchOptions& options = {});

// Whether offsets that were computed for `matched` are valid for this sett: same repeats (within 0.1 mm) and colours.
bool is_sett_of(const MatchedSett& matched, const Sett& sett);

// A point of a seam, in the fabric coordinates of both sides: panel coordinates rotated into the yarn directions.
struct CoursePoint {
    Vec2d first = Vec2d::Zero();   // m, (weft, warp) on the first side, without sett offset
    Vec2d second = Vec2d::Zero();  // the same on the second side
    // The sine of the angle between the seam and the warp's stripes (x) and the weft's stripes (y), mean of both sides.
    // 0: parallel.
    Vec2d crossing = Vec2d::Zero();
};

// The course of a seam through the fabric on both sides. Points are at equal fractions of each side's length, in the
// direction of the first side.
struct SeamCourse {
    double first_length = 0;  // m
    double second_length = 0;
    std::vector<CoursePoint> points;  // evenly spaced, both ends included
    // The mean product of the two sides' directions, for the warp's stripes (x) and the weft's (y). Negative if the
    // sides run through the sett in opposite directions (a chevron).
    Vec2d agreement = Vec2d::Zero();
    bool is_eased = false;    // the sides' lengths differ by more than 1 mm
    std::size_t anchor = 0;   // index of the point where an eased seam is matched, see find_course()
    bool is_upright = false;  // the ends' heights differ by at least half of its length
};

// An eased or gathered seam is matched at one point, as a tailor does: at its lower end in the 3D placement (the hem,
// the bottom of the armhole) if it is upright, otherwise at its middle. Pre: the seam's panel and edge indices are in
// range.
SeamCourse find_course(const Pattern& pattern, const Seam& seam);

}  // namespace selvedge::sim
