#pragma once
// The waves in a square picture.
#include <complex>
#include <vector>

namespace selvedge::test {

// Values in rows, side x side, side a power of two: to coefficients, whose index is the number of waves each way,
// negative ones counted from the end. The mean of all is at (0, 0).
std::vector<std::complex<double>> fourier(const std::vector<double>& values, int side);

// The greatest amplitude among waves of `most` or fewer to the picture, the mean left out. The picture fades towards
// its edges (Hann), so that it need not repeat.
double greatest_slow_wave(const std::vector<double>& values, int side, int most);

}  // namespace selvedge::test
