#pragma once
// Colour maps for values and colours for kinds, made in Oklab (B. Ottosson 2020), where equal steps look equal. They
// stay readable with red-green colour blindness: the sequential map grows lighter from end to end, the diverging map
// runs from blue to orange. Also the conversion between sRGB and linear light.
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sim/core/math.h"
#include "sim/tartan/sett.h"

namespace selvedge::render {

// L (lightness, 0..1), a (green to red), b (blue to yellow).
Vec3f to_oklab(const sim::Rgb8& colour);
sim::Rgb8 from_oklab(const Vec3f& lab);  // clamped to the sRGB gamut

inline constexpr std::size_t kMapColours = 257;  // odd, so that one colour is the middle

// From blue through light neutral grey to orange, for strain: compressed, at rest, stretched.
std::vector<sim::Rgb8> diverging_map();

// From dark violet through blue and green to pale yellow, for distances: near to far.
std::vector<sim::Rgb8> sequential_map();

// A muted colour for the kind with this index. Neighbouring indices differ in hue and lightness.
sim::Rgb8 kind_colour(std::size_t index);

// The same, but dark enough for lines on pale cloth.
sim::Rgb8 line_colour(std::size_t index);

// Conversion between sRGB and linear light (IEC 61966-2-1). All shading is done in linear light.
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

// to_srgb() by a table, for millions of values: rounds to one of `Entries` evenly spaced values from 0 to 1.
template <class Real, std::size_t Entries>
class SrgbTable {
 public:
    SrgbTable() {
        for (std::size_t i = 0; i < Entries; ++i) bytes_[i] = to_srgb(double(i) / double(Entries - 1));
    }

    std::uint8_t at(Real linear) const {
        return bytes_[static_cast<std::size_t>(std::clamp(linear, Real(0), Real(1)) * Real(Entries - 1) + Real(0.5))];
    }

 private:
    std::array<std::uint8_t, Entries> bytes_{};
};

}  // namespace selvedge::render
