#pragma once
// The shadow that a draped disc throws straight down, and what is read from it in Cusick's test.
#include <array>
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {

// Triangles seen from above, drawn on a fine grid: y is left out.
class Shadow {
 public:
    explicit Shadow(double half_width = 0.17, double pixel = 4e-4);  // m, about the origin

    void draw(const std::array<Vec3d, 3>& triangle);
    double area() const;  // m^2
    // The farthest lit point in each of so many equal sectors about the origin, m.
    std::vector<double> outline(int sectors = 360) const;

 private:
    bool is_lit(int column, int row) const { return lit_[static_cast<std::size_t>(row * size_ + column)]; }
    double centre_of(int index) const { return (index + 0.5) * pixel_ - half_width_; }

    double half_width_;
    double pixel_;
    int size_;
    std::vector<bool> lit_;
};

// 100 (shadow - support) / (specimen - support).
double drape_coefficient(double shadow_area, double support_area, double specimen_area);

// How many times the outline of a shadow rises and falls by more than `prominence` (m) round the circle.
int count_folds(const std::vector<double>& outline, double prominence = 0.004);

}  // namespace selvedge
