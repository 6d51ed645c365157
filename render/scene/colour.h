#pragma once
// Colours for figures and for kinds, made in Oklab (B. Ottosson 2020), where equal steps look equal: maps whose
// lightness alone tells the order, and that people who confuse red and green read like everyone else.
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sim/core/math.h"
#include "sim/tartan/sett.h"

namespace selvedge::render {

// Lightness 0..1, green to red, blue to yellow.
Vec3f to_oklab(const sim::Rgb8& colour);
sim::Rgb8 from_oklab(const Vec3f& lab);  // clamped to what a screen can show

inline constexpr std::size_t kMapColours = 257;  // odd: the middle is one of them

// From blue by a light neutral grey to orange: compressed, at rest, extended.
std::vector<sim::Rgb8> diverging_map();

// From dark violet by blue and green to pale yellow: near to far.
std::vector<sim::Rgb8> sequential_map();

// A calm colour for one of many kinds; any that are next to each other in number are told apart by hue and lightness.
sim::Rgb8 kind_colour(std::size_t index);

// The same, deep enough to be read as a line on pale cloth.
sim::Rgb8 line_colour(std::size_t index);

// sRGB and linear light, in which all shading is done.  (IEC 61966-2-1)
inline double to_linear(std::uint8_t byte) {
    const double s = byte / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

inline Vec3f to_linear(const sim::Rgb8& colour) {
    return Vec3d(to_linear(colour[0]), to_linear(colour[1]), to_linear(colour[2])).cast<float>();
}

// Clamps to 0..1.
inline std::uint8_t to_srgb(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double s = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * s));
}

}  // namespace selvedge::render
