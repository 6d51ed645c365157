#pragma once
// What several commands are made of.
#include <string>

#include "sim/core/vec.h"

namespace selvedge {

// A map of the drafting sheet: p -> x_axis p.x + y_axis p.y + shift.
struct PlaneMap {
    Vec2d x_axis{1, 0};
    Vec2d y_axis{0, 1};
    Vec2d shift{0, 0};  // m

    bool operator==(const PlaneMap&) const = default;
};

// The part of an edge between two fractions of its length.
struct SpanRef {
    std::string panel;
    int edge = 0;
    double from = 0;
    double to = 1;

    bool operator==(const SpanRef&) const = default;
};

// Where a panel stands in the room: see Panel.
struct PanelPlace {
    std::string panel{};
    Vec3d translation = Vec3d::Zero();
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    double wrap_radius = 0;

    bool operator==(const PanelPlace&) const = default;
};

}  // namespace selvedge
