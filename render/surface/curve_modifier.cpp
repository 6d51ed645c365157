#include "render/surface/curve_modifier.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/assert.h"

namespace selvedge {
namespace {

constexpr std::array<std::pair<const char*, CurveModifier>, kSurfaceKinds> kPresets{
    {{"flat", {.k = {0, 0, 0, 0}}},
     {"constant", {.k = {1, 0, 0, 0}}},
     {"linear", {.k = {0, 1, 0, 0}}},
     {"quadratic", {.k = {0, 0, 1, 0}}},
     {"cubic", {.k = {0, 0, 0, 1}}},
     {"restore", {.k = {0, 0, 0, 0}, .restores_length = true}}}};

const auto& preset(SurfaceKind kind) {
    return kPresets[static_cast<std::size_t>(kind)];
}

}  // namespace

std::optional<SurfaceKind> parse_surface_kind(std::string_view name) {
    for (std::size_t i = 0; i < kPresets.size(); ++i) {
        if (kPresets[i].first == name) return static_cast<SurfaceKind>(i);
    }
    return std::nullopt;
}

const char* name(SurfaceKind kind) {
    return preset(kind).first;
}

CurveModifier curve_modifier(SurfaceKind kind) {
    return preset(kind).second;
}

float soft_cap(float value, float cap) {
    return value <= cap ? value : cap + (value - cap) / value;
}

float modified(const CurveModifier& modifier, float r) {
    SELVEDGE_ASSERT(!modifier.restores_length);
    const auto& [k0, k1, k2, k3] = modifier.k;
    return soft_cap(k0 + r * (k1 + r * (k2 + r * k3)), modifier.soft_cap);
}

float restoring(float r, float s0) {
    const float lacking = r - 1, given = s0 - 1;
    if (lacking <= 0) return 0;
    if (lacking >= kMostRestored * kMostRestored * given) return kMostRestored;
    return std::sqrt(lacking / given);
}

}  // namespace selvedge
