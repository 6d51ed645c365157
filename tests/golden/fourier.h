#pragma once
// Fourier transform of a square picture, and the strongest slow wave in it.
#include <complex>
#include <vector>

namespace selvedge::test {

// values: in rows, side x side; side is a power of two. Returns the coefficients; the indices are the numbers of waves
// along x and y, with negative numbers counted from the end. (0, 0) is the mean.
std::vector<std::complex<double>> fourier(const std::vector<double>& values, int side);

// The largest amplitude among waves with at most `most` and at least 2 periods per picture. A Hann window fades the
// picture towards its borders, so that it need not be periodic.
double greatest_slow_wave(const std::vector<double>& values, int side, int most);

}  // namespace selvedge::test
