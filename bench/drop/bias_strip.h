#pragma once
// How stiff the cloth is on the bias as the solver makes it: a strip cut at 45 degrees, held at its upper end, with a
// weight sewn to its lower one.
#include "sim/pattern/fabric.h"

namespace selvedge::bench {

struct BiasStripOptions {
    double element = 0.1;  // m, edge of the coarse quads; as wide is the strip, and four times as long
    int level = 3;
    int substeps = 8;  // per frame
    double frame_seconds = 1.0 / 60;
    double strain = 0.01;  // about, by the weight
};

struct BiasStrip {
    double stiffness_ratio = 0;  // strain expected over strain measured
    bool is_at_rest = false;
};

// Elongation is read between the lines 1 1/4 and 2 3/4 widths from the clamp: nearer than a width to either end, cloth
// whose threads hardly stretch cannot shear freely.
BiasStrip measure_bias(const sim::Fabric& fabric, const BiasStripOptions& options);

}  // namespace selvedge::bench
