#pragma once
// What the tests of a session share: a body, shipped patterns, and measures of frames.
#include <memory>
#include <string>

#include "sim/dress/session.h"

namespace selvedge::sim::test {

std::shared_ptr<const Body> session_body();  // the mannequin, coarse
Pattern session_pattern(const std::string& name);
SessionOptions coarse_options();  // one level, as fast as it can

// Starts, and goes on until it has settled or for 20 s.
void settle(Session& session);

// Cuts an outline edge in the middle; seams follow. Pre: no seam joins it.
void split_edge(Pattern& pattern, int panel, int edge);

double stretch_p99(const PlainMesh& mesh);     // of warp and weft
float least_clearance(const PlainMesh& mesh);  // m, to session_body()

// How far the places of the first frame's material are from where the second has them, in the mean, m.
double mean_move(const SessionFrame& from, const SessionFrame& to);

// The triangle with the corner that is furthest along a direction, in a panel, and that corner's weight.
ClothPoint furthest_point(const SessionFrame& frame, int panel, const Vec3f& direction);
Vec3f position_of(const SessionFrame& frame, const ClothPoint& point);

}  // namespace selvedge::sim::test
