#pragma once
// sRGB bytes to linear light, in which all shading is done.
#include <cmath>

#include "sim/core/vec.h"
#include "sim/tartan/sett.h"

namespace selvedge {

inline float to_linear(std::uint8_t byte) {
    const double s = byte / 255.0;
    return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

inline Vec3f to_linear(const Rgb8& colour) {
    return {to_linear(colour[0]), to_linear(colour[1]), to_linear(colour[2])};
}

}  // namespace selvedge
