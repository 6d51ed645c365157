#pragma once
// How far the curve of an edge leaves its chord.  (thesis ch. 6, figs. 6.4, 6.5, 6.7; SPEC 5)
//
// r = rest length / length of the chord: an edge that is shorter than its material must curve.
#include <array>
#include <optional>
#include <string_view>

namespace selvedge {

// M = SoftCap(K0 + K1 r + K2 r^2 + K3 r^3) times the offset of the curve that the end normals alone would give.
struct CurveModifier {
    std::array<float, 4> k{1, 0, 0, 0};
    float soft_cap = 1;            // above 0; beyond it M grows towards soft_cap + 1 only
    bool restores_length = false;  // instead: the M with which the curve is as long as the material
};

// The thesis' presets, and ours.
enum class SurfaceKind { Flat, Constant, Linear, Quadratic, Cubic, Restore };

inline constexpr const char* kSurfaceKindNames = "flat, constant, linear, quadratic, cubic, restore";
inline constexpr int kSurfaceKinds = 6;
std::optional<SurfaceKind> parse_surface_kind(std::string_view name);
const char* name(SurfaceKind kind);

CurveModifier curve_modifier(SurfaceKind kind);

// value up to cap, then cap + (value - cap) / value.
float soft_cap(float value, float cap);

// Pre: it does not restore length.
float modified(const CurveModifier& modifier, float r);

// M for a curve whose arc is s0 times its chord at M = 1: for small offsets the excess of arc over chord grows with
// their square, so sqrt((r - 1) / (s0 - 1)); none where the edge is not short of its material, at most kMostRestored.
float restoring(float r, float s0);
inline constexpr float kMostRestored = 5;  // nearly straight, s0 tends to 1

}  // namespace selvedge
