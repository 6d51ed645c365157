#pragma once
// Colours for figures and for kinds, made in Oklab (B. Ottosson 2020), where equal steps look equal: maps whose
// lightness alone tells the order, and that people who confuse red and green read like everyone else.
#include <array>
#include <cstddef>
#include <vector>

#include "sim/core/vec.h"
#include "sim/tartan/sett.h"

namespace selvedge {

// Lightness 0..1, green to red, blue to yellow.
Vec3f to_oklab(const Rgb8& colour);
Rgb8 from_oklab(const Vec3f& lab);  // clamped to what a screen can show

inline constexpr std::size_t kMapColours = 257;  // odd: the middle is one of them

// From blue by a light neutral grey to orange: compressed, at rest, extended.
std::vector<Rgb8> diverging_map();

// From dark violet by blue and green to pale yellow: near to far.
std::vector<Rgb8> sequential_map();

// A calm colour for one of many kinds; any that are next to each other in number are told apart by hue and lightness.
Rgb8 kind_colour(std::size_t index);

// The same, deep enough to be read as a line on pale cloth.
Rgb8 line_colour(std::size_t index);

}  // namespace selvedge
