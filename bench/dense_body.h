#pragma once
// The mannequin with as many triangles as an experiment wants.
#include <cstddef>

#include "sim/body/body.h"

namespace selvedge {

// The standing mannequin, its longest edges split until it has about so many triangles (two fewer at most): closed, and
// as smooth as it was. Pre: triangles >= 17 184, what its coarsest form has.
Body dense_body(std::size_t triangles);

}  // namespace selvedge
