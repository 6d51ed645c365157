#pragma once
// The same loops, compiled for each kind of vector instructions.
namespace selvedge {

struct Kernels;
const Kernels& kernels_plain();
const Kernels& kernels_avx2();
const Kernels& kernels_avx512();

}  // namespace selvedge
