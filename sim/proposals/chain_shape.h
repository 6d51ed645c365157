#pragma once
// The shape and the direction of a chain of unsewn edges, as the evidence for seams compares them.
#include <vector>

#include "sim/proposals/chain_view.h"
#include "sim/proposals/open_boundary.h"

namespace selvedge::sim {

inline constexpr int kChainSamples = 24;  // steps along a chain
inline constexpr double kUpright = 0.75;  // least rise of an upright stretch

// kChainSamples + 1 points along the view, each in the frame of its panel, m. Across a dart, the outline goes on as
// when the dart is closed.
std::vector<Vec2d> sampled(const OpenBoundary& boundary, const ChainView& view);

// Root mean square distance of two curves over their length, after the best rotation. (Kabsch 1976)
double shape_difference(std::vector<Vec2d> a, std::vector<Vec2d> b, bool is_mirrored);

// Distance of the ends over the length: 1 for a straight line.
double straightness(const std::vector<Vec2d>& points);

// The rise of a stretch over its length, -1..1: of an upright one about 1 or -1.
double rise(const std::vector<Vec2d>& points);

// The same of a view that may run over several panels, each as it is drawn.
double rise_along(const OpenBoundary& boundary, const ChainView& view);

// The heights of kChainSamples + 1 points along the view, m. Panels that it runs over are as high as makes it go on.
std::vector<double> heights_along(const OpenBoundary& boundary, const ChainView& view);

// Pearson's correlation of equally many values, -1..1; 0 where one side is constant.
double correlation(const std::vector<double>& a, const std::vector<double>& b);

// How far the cloth's edge looks up, -1..1: -1 at a hem, 0 at a side, 1 at the top.
double facing_up(const OpenBoundary& boundary, const ChainView& view);

// How far the stretch bulges out of its panel, as an area over the square of its length: negative for an armhole.
double bulge(const std::vector<Vec2d>& points);

}  // namespace selvedge::sim
