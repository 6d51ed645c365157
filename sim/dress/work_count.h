#pragma once
// The work of steps of cloth: leaf triangles, and pairs of them that contact of the cloth with itself looked at. It is
// alike for any number of threads on one type of CPU, where a time is not.
#include "sim/cloth/cloth.h"

namespace selvedge::sim {

class WorkCount {
 public:
    explicit WorkCount(const Cloth& cloth);

    // Of that many steps, which are all since it was made or asked last. Pre: the mesh was the same in all of them.
    double of_steps(const Cloth& cloth, int steps);

 private:
    long pairs_;
};

}  // namespace selvedge::sim
