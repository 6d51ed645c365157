#pragma once
// The biases of the stretch conditions while triangles come and go.  (solver_blocks.h)
namespace selvedge {

struct Cloth;

// From the solver's blocks to Cloth::bias, leaf by leaf; a refined triangle gets the mean of what is inside it, so that
// it has one when it becomes a leaf. Before an adaption.
void keep_bias(Cloth& cloth);

// Triangles that are new get the bias of the triangle that they are inside of. After an adaption.
void hand_on_bias(Cloth& cloth);

}  // namespace selvedge
