#pragma once
// Setts that meet at seams: how far the sett must be moved under each panel so that stripes go on across the seams.
// Purely geometric, from material coordinates along the seams; warp and weft are matched apart.
//
// Stripes that cross a seam leave one side at a place of the sett, p_first(s) + o_first, and should arrive at the same
// place on the other, modulo the repeat. Where both sides run through the sett in opposite directions (a chevron) a
// sett that mirrors can be met by its mirror image. Stripes that run along a seam cannot meet there; they are matched
// last, as far as nothing else decides, so that the sett also runs on round the body.
//
// Seams that are named first win, each strictly before the next, and all of them before the rest. Of the rest those
// that can meet within 6 mm all along win over those whose shape or ease forbids it, and the longest that are crossed
// most squarely are joined first. Same input, same bits; the order of the panels does not matter.
#include <optional>
#include <string>
#include <vector>

#include "sim/core/math.h"
#include "sim/pattern/pattern.h"
#include "sim/tartan/sett.h"

namespace selvedge::sim {

struct MatchOptions {
    std::vector<int> first_seams{};  // indices into Pattern::seams, the most important first
    // Where seams leave a choice the first panel of the pattern that they join keeps its offset, or this one; the
    // nearest mirror of the warp's stripes is put in its middle, as far as they have one.
    std::optional<int> centred_panel{};
};

// The mismatch at a point of a seam is the distance, across the stripes, from where a stripe arrives to the nearest
// place of the sett that goes on with it, at most half a repeat. Points lie a millimetre apart, or 1,024 to the
// seam; those count where
// stripes cross the seam at 15 degrees or more, the worse family counts.
struct SeamMatch {
    int seam = 0;  // index into Pattern::seams
    std::string name;
    double length = 0;      // m, mean of both sides
    double before = 0;      // m, the largest mismatch along the seam
    double after = 0;       // m
    double rms_before = 0;  // m, root mean square along the seam
    double rms_after = 0;   // m
    double met = 0;         // share of the seam, 0..1, along which stripes meet within 2 mm, after
    std::string why;        // what keeps it from meeting within 0.5 mm; empty: it does
};

struct SettMatch {
    std::vector<Vec2d> offsets;  // m, one per panel, to replace Panel::sett_offset; multiples of 1e-6 m if they changed
    std::vector<SeamMatch> seams;  // one per seam of the pattern, in its order
};

// Pre: the pattern's indices are in range, and so are those of the options. Offsets of the pattern that are not finite
// count as 0.
SettMatch match_sett(const Pattern& pattern, const Sett& sett, const MatchOptions& options = {});

// Whether offsets that were found for `matched` serve a cloth in this sett: the same colours in the same places.
bool is_sett_of(const MatchedSett& matched, const Sett& sett);

// Where a seam runs in the fabric, on both of its sides at once: material coordinates only, no cloth and no pixels.
// Points lie at equal fractions of each side's length, in the direction in which the sides are sewn.

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

}  // namespace selvedge::sim
