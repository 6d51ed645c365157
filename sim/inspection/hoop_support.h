#pragma once
// How much weight the hoop tension of a garment's upper part can carry on the trunk, as that of a waistband. A hoop
// under the force F (N) that slides down by dy must widen with the body's girth C, which takes F dC; it presses on a
// convex body with 2 pi F in all, so friction mu takes mu 2 pi F dy. It carries at most 2 pi F (s + mu) / (1 - mu s),
// where 2 pi s = dC/dy: a belt on a cone with Coulomb friction. The body below turns the cloth from the slope s into
// the vertical, which carries a part exp(mu atan s) of what hangs there (Euler and Eytelwein).
#include <functional>
#include <span>
#include <vector>

#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"
#include "sim/place/openings.h"

namespace selvedge::sim {

// Closed lines around the garment at one distance from its upper edge, laid flat.
struct HoopRow {
    double distance = 0;    // m, along the cloth from the upper edge
    double length = 0;      // m, unstretched
    double compliance = 0;  // m^2/N: its extension per force along it and per m of height
    double limit = 0;       // m, its extension at its fabrics' strain limits
};

inline constexpr double kWaistbandWidth = 0.04;                // m
inline constexpr double kHoopRowHeight = kWaistbandWidth / 8;  // m: 5 mm

// The rows below an edge, by distance. Distances are lengths along mesh edges, so bands count as slightly higher than
// they are. Pre: the mesh is sewn; one fabric per panel.
std::vector<HoopRow> hoop_rows(const GarmentMesh& sewn, const Opening& edge, std::span<const Fabric> fabrics);

// The weight of all cloth that is connected with the edge, N.
double weight_below(const GarmentMesh& sewn, const Opening& edge, std::span<const Fabric> fabrics);

using GirthAtHeight = std::function<double(double)>;  // m; 0 where the body has none

// The largest weight, N, that the rows carry while no cloth is stretched beyond its fabric's limit, with the upper edge
// at any height (m) from `low` to `high`.
double largest_hoop_support(std::span<const HoopRow> rows, const GirthAtHeight& girth, double friction, double low,
                            double high);

}  // namespace selvedge::sim
