#pragma once
// Measures the solver's stiffness on the bias: a strip cut at 45 degrees to the yarns hangs from its upper end, with a
// weight sewn to its lower end.
#include "sim/pattern/fabric.h"

namespace selvedge::bench {

struct BiasStripOptions {
    double element = 0.1;  // m, edge of the coarse quads; the strip is one quad wide and four quads long
    int level = 3;
    int substeps = 8;  // per frame
    double frame_seconds = 1.0 / 60;
    double strain = 0.01;  // approximate strain that the weight causes
};

struct BiasStrip {
    double stiffness_ratio = 0;  // expected strain / measured strain
    bool is_at_rest = false;
};

// The elongation is measured between the lines 1.25 and 2.75 widths below the clamp. Within about one width of either
// end, yarns that hardly stretch prevent the cloth from shearing freely.
BiasStrip measure_bias(const sim::Fabric& fabric, const BiasStripOptions& options);

}  // namespace selvedge::bench
