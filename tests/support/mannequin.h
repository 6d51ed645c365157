#pragma once
// The mannequin of the usual measures, coarse, which most tests dress.
#include "sim/body/body.h"
#include "sim/mannequin/mannequin.h"

namespace selvedge::sim::test {

inline const Body& mannequin() {
    static const Body body = make_mannequin({.subdivisions = 1}).body;
    return body;
}

}  // namespace selvedge::sim::test
