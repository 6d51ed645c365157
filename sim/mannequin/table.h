#pragma once
// The data of the mannequin (mannequin_table.json): control points of cross-sections, joints and levels, measured on
// the two CC0 bodies of MakeHuman. Also the skin weights of the cage, and interpolation in
// tables.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sim/mannequin/cage.h"
#include "sim/mannequin/mannequin.h"

namespace selvedge::sim {

// Heights of the trunk's girths and of the crotch, m.
struct TrunkLevels {
    double bust = 0;
    double underbust = 0;
    double waist = 0;
    double high_hip = 0;
    double hip = 0;
    double crotch = 0;
};

struct MannequinTable {
    std::vector<Vec3d> left_points;  // of the cage's left half, in the cage's order, m
    Joints joints;                   // m
    TrunkLevels levels;
    double armpit = 0;  // height, m
};

MannequinTable read_mannequin_table(Sex sex, const Cage& cage);

// Skin weights of the mannequin's cage: smooth steps across the joints along each part, fixed ramps where limbs meet
// the trunk, then two smoothing iterations over the quads. Subdivision interpolates them on the surface.

// One row per cage vertex (both halves), one column per joint; each row sums to 1.
VertexRows cage_weights(const Cage& cage, const MannequinTable& table);

// Scalar functions for the mannequin: monotone piecewise cubic interpolation without overshoot (Fritsch and Carlson
// 1980; Fritsch and Butland 1984: weighted harmonic mean of slopes), tables with uniform steps, and smoothstep.

class Pchip {
 public:
    // Pre: at least 3 points, x strictly increasing.
    Pchip(std::vector<double> x, std::vector<double> y);

    // Outside the interval the first or last cubic is extrapolated.
    double operator()(double x) const;

 private:
    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<double> slope_;
};

// A function given by its values at uniform steps: linear in between, constant outside. Cheap enough to evaluate per
// vertex.

struct EvenTable {
    double low = 0;              // argument of the first value
    double high = 0;             // argument of the last value
    std::vector<double> values;  // at least two

    double step() const { return (high - low) / static_cast<double>(values.size() - 1); }

    double at(double x) const {
        const double t = std::clamp((x - low) / step(), 0.0, static_cast<double>(values.size() - 1));
        const auto i = std::min(static_cast<std::size_t>(t), values.size() - 2);
        return std::lerp(values[i], values[i + 1], t - static_cast<double>(i));
    }
};

}  // namespace selvedge::sim
