#pragma once
// Shared by the session tests: a body, shipped patterns, and measurements of frames.
#include <memory>
#include <string>

#include "sim/session/session.h"

namespace selvedge::sim::test {

std::shared_ptr<const Body> session_body();  // the mannequin, coarse
Pattern session_pattern(const std::string& name);
SessionOptions coarse_options();  // one level of refinement, not in real time

// Starts the session and advances until it has settled, at most 20 s.
void settle(Session& session);

// Splits an outline edge in the middle and updates the edge indices of seams. Pre: no seam joins this edge.
void split_edge(Pattern& pattern, int panel, int edge);

double stretch_p99(const DrawMesh& mesh);   // of warp and weft
float min_clearance(const DrawMesh& mesh);  // m, to session_body()

// Mean distance between the positions of the same material points in two frames, m.
double mean_move(const SessionFrame& from, const SessionFrame& to);

// The corner that is farthest along a direction in a panel, as a point of its triangle.
ClothPoint furthest_point(const SessionFrame& frame, int panel, const Vec3f& direction);
Vec3f position_of(const SessionFrame& frame, const ClothPoint& point);

}  // namespace selvedge::sim::test
