#include "render/scene/colour.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace selvedge::render {
namespace {

Vec3f from_polar(float lightness, float chroma, float hue_deg) {
    const float hue = hue_deg * 0.017453293F;
    return {lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
}

// Colours at equal steps of length along a polyline in Oklab, so that equal differences of values look equal.
std::vector<sim::Rgb8> even_map(std::span<const Vec3f> corners) {
    std::vector<float> reached{0};
    for (std::size_t i = 1; i < corners.size(); ++i)
        reached.push_back(reached.back() + (corners[i] - corners[i - 1]).norm());
    std::vector<sim::Rgb8> map;
    std::size_t leg = 1;
    for (std::size_t i = 0; i < kMapColours; ++i) {
        const float at = reached.back() * float(i) / float(kMapColours - 1);
        while (leg + 1 < corners.size() && reached[leg] < at) ++leg;
        const float share = (at - reached[leg - 1]) / (reached[leg] - reached[leg - 1]);
        map.push_back(from_oklab(corners[leg - 1] + std::min(share, 1.0F) * (corners[leg] - corners[leg - 1])));
    }
    return map;
}

// Hues a golden angle apart never come close to each other; three lightnesses in turn help where hues look alike.
Vec3f kind(std::size_t index, float first_hue_deg, std::array<float, 3> lightness, float chroma) {
    const float hue = std::fmod(first_hue_deg + 137.50776F * float(index), 360.0F);
    return from_polar(lightness[index % 3], chroma, hue);
}

}  // namespace

Vec3f to_oklab(const sim::Rgb8& colour) {
    const double r = to_linear(colour[0]), g = to_linear(colour[1]), b = to_linear(colour[2]);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return Vec3d(0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
                 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
                 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s)
        .cast<float>();
}

sim::Rgb8 from_oklab(const Vec3f& lab) {
    const auto cube = [&](double a, double b) {
        const double root = double(lab[0]) + a * double(lab[1]) + b * double(lab[2]);
        return root * root * root;
    };
    const double l = cube(0.3963377774, 0.2158037573), m = cube(-0.1055613458, -0.0638541728),
                 s = cube(-0.0894841775, -1.2914855480);
    return {to_srgb(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            to_srgb(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            to_srgb(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

std::vector<sim::Rgb8> diverging_map() {
    const std::array<Vec3f, 5> corners{from_polar(0.42F, 0.135F, 258), from_polar(0.68F, 0.11F, 245),
                                       from_polar(0.94F, 0.004F, 100), from_polar(0.72F, 0.13F, 60),
                                       from_polar(0.46F, 0.135F, 42)};
    return even_map(corners);
}

std::vector<sim::Rgb8> sequential_map() {
    const std::array<Vec3f, 6> corners{from_polar(0.30F, 0.12F, 295),  from_polar(0.42F, 0.115F, 265),
                                       from_polar(0.55F, 0.09F, 225),  from_polar(0.68F, 0.10F, 175),
                                       from_polar(0.81F, 0.125F, 130), from_polar(0.94F, 0.10F, 103)};
    return even_map(corners);
}

sim::Rgb8 kind_colour(std::size_t index) {
    return from_oklab(kind(index, 100, {0.84F, 0.71F, 0.77F}, 0.075F));
}

sim::Rgb8 line_colour(std::size_t index) {
    return from_oklab(kind(index, 250, {0.52F, 0.66F, 0.42F}, 0.145F));
}

}  // namespace selvedge::render
