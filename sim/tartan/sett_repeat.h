#pragma once
// Where the stripes of a sett come again, and where they mirror: what matching needs to know of the colours. Both are
// read off the colours themselves, for a sett may be written longer than it is, and be its own mirror image without a
// pivot in its threadcount (K8 W8).
#include <optional>

#include "sim/tartan/sett.h"

namespace selvedge {

struct StripeRepeat {
    double size = 0;               // m, the shortest; 0: one colour only, nothing to match
    std::optional<double> mirror;  // m from the first thread; it mirrors half a repeat further too. None: never
};

StripeRepeat warp_repeat(const Sett& sett);  // of the colours along the weft
StripeRepeat weft_repeat(const Sett& sett);  // of the colours along the warp

}  // namespace selvedge
