#include "tests/golden/fourier.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "sim/core/assert.h"

namespace selvedge::test {
namespace {

using Complex = std::complex<double>;

// Radix-2 FFT: transforms elements with even and odd index separately, then combines them.
void transform(std::vector<Complex>& line) {
    const std::size_t n = line.size();
    if (n == 1) return;
    std::vector<Complex> even(n / 2), odd(n / 2);
    for (std::size_t i = 0; i < n / 2; ++i) {
        even[i] = line[2 * i];
        odd[i] = line[2 * i + 1];
    }
    transform(even);
    transform(odd);
    for (std::size_t k = 0; k < n / 2; ++k) {
        const Complex turned = std::polar(1.0, -2 * std::numbers::pi * double(k) / double(n)) * odd[k];
        line[k] = even[k] + turned;
        line[k + n / 2] = even[k] - turned;
    }
}

// One row or column of the square: every `step`-th element from `first`.
void transform_line(std::vector<Complex>& square, std::size_t side, std::size_t first, std::size_t step) {
    std::vector<Complex> line(side);
    for (std::size_t i = 0; i < side; ++i) line[i] = square[first + i * step];
    transform(line);
    for (std::size_t i = 0; i < side; ++i) square[first + i * step] = line[i];
}

}  // namespace

std::vector<Complex> fourier(const std::vector<double>& values, int side) {
    const auto n = static_cast<std::size_t>(side);
    SELVEDGE_ASSERT(values.size() == n * n && (n & (n - 1)) == 0);
    std::vector<Complex> square(values.begin(), values.end());
    for (std::size_t i = 0; i < n; ++i) transform_line(square, n, i * n, 1);
    for (std::size_t i = 0; i < n; ++i) transform_line(square, n, i, n);
    for (Complex& value : square) value /= double(n * n);
    return square;
}

double greatest_slow_wave(const std::vector<double>& values, int side, int most) {
    std::vector<double> faded = values;
    double mean = 0;
    for (const double value : values) mean += value / double(values.size());
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const auto hann = [&](int at) { return 1 - std::cos(2 * std::numbers::pi * (at + 0.5) / side); };
            double& value = faded[static_cast<std::size_t>(y * side + x)];
            value = (value - mean) * hann(x) * hann(y);
        }
    }
    const std::vector<Complex> waves = fourier(faded, side);
    double greatest = 0;
    for (int y = -most; y <= most; ++y) {
        for (int x = -most; x <= most; ++x) {
            if (std::max(std::abs(x), std::abs(y)) < 2) continue;  // slow gradients leak into these through the window
            const int row = (y + side) % side, column = (x + side) % side;
            greatest = std::max(greatest, 2 * std::abs(waves[static_cast<std::size_t>(row * side + column)]));
        }
    }
    return greatest;
}

}  // namespace selvedge::test
