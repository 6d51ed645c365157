#pragma once
// A strip clamped level at one end that droops under its own weight, exactly: the heavy elastica B theta'' =
// -w (L - s) cos theta. (Peirce's closed formula for his cantilever test overestimates B by 5.7 % at the usual angle.)
#include <array>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::bench {

struct Deflection {
    double reach = 0;  // horizontal distance of the free end from the clamp, of the strip's length
    double drop = 0;   // how far the free end hangs below the clamp, of the length
};

// q = w L^3 / B: weight per area (N/m^2), length cubed (m^3), bending rigidity (N m). Pre: 0 <= q <= 1e5.
Deflection droop(double q);

// The angle by which the chord from clamp to free end dips, rad, and the q that makes it.
double chord_angle(const Deflection& droop);
double q_of_chord_angle(double angle);  // pre: 0 < angle < 1.55

// The chord dips 41.5 degrees at this q: there half the overhang is the bending length (B/w)^(1/3).
inline constexpr double kPeirceQ = 8.004;

// The same strip cut as a narrow sector of a disc that is held within a radius: it widens outward, and so do weight and
// rigidity. q as above, with the sector's own length; inner: radius of the support over that length.
Deflection sector_droop(double q, double inner);

// The drape coefficient, %, of a disc that hangs as such sectors do, each free of its neighbours: the floor for real
// cloth, whose folds hold it up. bending_length: (B/w)^(1/3), m.
double drape_floor(double bending_length, double support_radius = 0.09, double radius = 0.15);

// The shadow that a draped disc throws straight down, and what is read from it in Cusick's test.

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

}  // namespace selvedge::bench
