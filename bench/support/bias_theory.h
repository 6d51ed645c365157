#pragma once
// A strip cut at 45 degrees to the threads, pulled along its length: how far it gives.
#include "sim/pattern/fabric.h"

namespace selvedge {

// 4/E45 = 1/E_warp + 1/E_weft + 1/G, N/m; the model of a fabric has no lateral contraction. Of small strains.
double bias_stiffness(const Fabric& fabric);

// Strain under `force` (N/m of width). By what the threads give, and by their turning against each other: threads at an
// angle of pi/2 - s make the strip cos(s/2) + sin(s/2) times as long, and G s^2/2 of shear energy is what the force
// did. At 1 % that is 1.5 % less than the small-strain formula. Pre: 0 <= force < 2 G.
double bias_strain(const Fabric& fabric, double force);

}  // namespace selvedge
