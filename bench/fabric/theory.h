#pragma once
// Theory for the textile tests. A strip clamped horizontally at one end that bends under its own weight, solved
// exactly: the heavy elastica B theta'' = -w (L - s) cos theta. (Peirce's closed formula for his cantilever test
// overestimates B by 5.7 % at the usual angle.) Also the shadow, the drape coefficient and the folds of Cusick's drape
// test.
#include <array>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::bench {

struct Deflection {
    double reach = 0;  // horizontal distance of the free end from the clamp / length of the strip
    double drop = 0;   // height of the clamp above the free end / length of the strip
};

// q = w L^3 / B, dimensionless: w weight per area (N/m^2), L length (m), B bending rigidity per width (N m).
// Pre: 0 <= q <= 1e5.
Deflection deflection(double q);

// The angle of the chord from clamp to free end below the horizontal, rad, and its inverse function.
double chord_angle(const Deflection& deflection);
double q_of_chord_angle(double angle);  // pre: 0 < angle < 1.55

// At this q the chord angle is 41.5 degrees, and the bending length (B/w)^(1/3) is half the overhang.
inline constexpr double kPeirceQ = 8.004;

// The same for a narrow sector of a disc on a round support: the width, and with it weight and rigidity, grows outward.
// q as above, with the length of the sector beyond the support; inner: radius of the support / that length.
Deflection sector_deflection(double q, double inner);

// The drape coefficient, %, of a disc made of such sectors that hang independently of each other. It is a lower bound
// for real cloth, which its folds stiffen. bending_length: (B/w)^(1/3), m.
double drape_floor(double bending_length, double support_radius = 0.09, double radius = 0.15);

// The vertical projection (shadow) of a draped disc, and the values that Cusick's test derives from it.

// Triangles projected along y and rasterised on a fine grid.
class Shadow {
 public:
    explicit Shadow(double half_width = 0.17, double pixel = 4e-4);  // m; a square centred on the origin

    void draw(const std::array<Vec3d, 3>& triangle);
    double area() const;  // m^2
    // Distance of the farthest covered pixel in each of `sectors` equal sectors about the origin, m.
    std::vector<double> outline(int sectors = 360) const;

 private:
    bool is_lit(int column, int row) const { return lit_[static_cast<std::size_t>(row * size_ + column)]; }
    double centre_of(int index) const { return (index + 0.5) * pixel_ - half_width_; }

    double half_width_;
    double pixel_;
    int size_;
    std::vector<bool> lit_;
};

// 100 (shadow - support) / (specimen - support), %.
double drape_coefficient(double shadow_area, double support_area, double specimen_area);

// The number of maxima of a shadow's outline round the circle that rise and fall by more than `prominence` (m).
int count_folds(const std::vector<double>& outline, double prominence = 0.004);

}  // namespace selvedge::bench
