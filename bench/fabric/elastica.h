#pragma once
// A strip clamped level at one end that droops under its own weight, exactly: the heavy elastica B theta'' =
// -w (L - s) cos theta. (Peirce's closed formula for his cantilever test overestimates B by 5.7 % at the usual angle.)
namespace selvedge {

struct Droop {
    double reach = 0;  // horizontal distance of the free end from the clamp, of the strip's length
    double drop = 0;   // how far the free end hangs below the clamp, of the length
};

// q = w L^3 / B: weight per area (N/m^2), length cubed (m^3), bending rigidity (N m). Pre: 0 <= q <= 1e5.
Droop droop(double q);

// The angle by which the chord from clamp to free end dips, rad, and the q that makes it.
double chord_angle(const Droop& droop);
double q_of_chord_angle(double angle);  // pre: 0 < angle < 1.55

// The chord dips 41.5 degrees at this q: there half the overhang is the bending length (B/w)^(1/3).
inline constexpr double kPeirceQ = 8.004;

// The same strip cut as a narrow sector of a disc that is held within a radius: it widens outward, and so do weight and
// rigidity. q as above, with the sector's own length; inner: radius of the support over that length.
Droop sector_droop(double q, double inner);

// The drape coefficient, %, of a disc that hangs as such sectors do, each free of its neighbours: the floor for real
// cloth, whose folds hold it up. bending_length: (B/w)^(1/3), m.
double drape_floor(double bending_length, double support_radius = 0.09, double radius = 0.15);

}  // namespace selvedge
