#pragma once
// Monotone piecewise cubic interpolation: never overshoots its points. (Fritsch and Carlson 1980, Fritsch and Butland
// 1984: weighted harmonic mean of slopes)
#include <vector>

namespace selvedge {

class Pchip {
 public:
    // Pre: at least 3 points, x strictly increasing.
    Pchip(std::vector<double> x, std::vector<double> y);

    // Beyond the ends the first or last cubic goes on.
    double operator()(double x) const;

 private:
    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<double> slope_;
};

}  // namespace selvedge
