#include "sim/cloth/curvature_map.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace selvedge::sim {
namespace {

// Frame-invariant norms of curvatures (k_11, k_22, 2 k_12) and of the corresponding unit quadratics.
const Vec3d kCurvatureNorm(1, 1, 0.5);
const Vec3d kQuadraticNorm(1, 1, 2);

// Minimum share of a hinge's angle for either side, chosen by experiment.
constexpr double kMinShare = 0.1;

std::size_t next(std::size_t i) {
    return (i + 1) % 3;
}

// n n' for the normal n of an edge, as (n_x^2, n_y^2, 2 n_x n_y).
Vec3d across(const Vec2d& along) {
    return {along.y() * along.y(), along.x() * along.x(), -2 * along.x() * along.y()};
}

// The transformation of curvatures to a frame rotated by the angle with this cosine and sine.
Mat3d turned(double c, double s) {
    Mat3d turn;
    turn << c * c, s * s, c * s, s * s, c * c, -c * s, -2 * c * s, 2 * c * s, c * c - s * s;
    return turn;
}

// The part of a hinge's angle on one side, per curvature (tangential, normal to the edge, 2 mixed): the difference of
// the slope at the middle of the edge and the slope of the triangle. sign: 1 on the left of the edge, else -1.
Vec3d share_of_side(const HingeSide& side, double sign) {
    const double from_middle = (side.foot - 0.5) * side.length;
    const double tangent = side.length * side.length / 4 - from_middle * from_middle;
    return {-0.5 * tangent / side.height, 0.5 * side.height, sign * from_middle};
}

double fitted_share(const HingeSide& own, const HingeSide& beyond) {
    const Vec3d weights(1, 1, 0.5);
    const Vec3d here = share_of_side(own, 1);
    const Vec3d both = here + share_of_side(beyond, -1);
    const Vec3d weighed = weights.cwiseProduct(both);
    return std::clamp(here.dot(weighed) / both.dot(weighed), kMinShare, 1 - kMinShare);
}

// Derivatives of a hinge's angle with respect to the heights of a, b, the corner c on this side and the apex d beyond.
std::array<double, 4> hinge_row(const HingeSide& own, const HingeSide& beyond) {
    const double qc = 1 / own.height, qd = 1 / beyond.height;
    return {-(1 - own.foot) * qc - (1 - beyond.foot) * qd, -own.foot * qc - beyond.foot * qd, qc, qd};
}

// The angle of hinge i on the unit quadratics 1/2 x^2, 1/2 y^2, 1/2 x y with their origin at the start of the edge.
Eigen::RowVector3d angle_of_quadratics(const RestTriangle& triangle, std::size_t i, const Vec2d& along) {
    const HingeSide own = triangle.own_side(i), beyond = *triangle.beyond[i];
    const std::array<double, 4> q = hinge_row(own, beyond);
    const Vec2d edge = own.length * along, left(-along.y(), along.x());
    const auto at = [](const Vec2d& p) {
        return Eigen::RowVector3d(0.5 * p.x() * p.x(), 0.5 * p.y() * p.y(), 0.5 * p.x() * p.y());
    };
    return q[1] * at(edge) + q[2] * at(own.foot * edge + own.height * left) +
           q[3] * at(beyond.foot * edge - beyond.height * left);
}

// Least squares for an exchange z between the maps of two triangles at their common edge: column `edge` of each changes
// by z / area. kKeep weights a regularisation term, which determines z where the quadratics do not; its
// value is chosen by experiment.
constexpr double kKeep = 0.02;

struct Exchange {  // one side's normal equations
    Mat3d matrix = Mat3d::Zero();
    Vec3d slope = Vec3d::Zero();
};
Exchange exchange_of(const CurvatureFit& fit, std::size_t edge) {
    const Mat3d norm = kCurvatureNorm.asDiagonal();
    const Mat3d seen = fit.visible.transpose() * norm;
    return {fit.size[edge] * (seen * fit.visible + kKeep * norm), seen * fit.miss[edge]};
}

// turn: from own frame to the other's. If no hinge is missing, the norm is the same in both and cancels.
Vec3d exchanged(const CurvatureFit& own, std::size_t i, const CurvatureFit& other, std::size_t edge, const Mat3d& turn,
                const Mat3d& back) {
    if (own.is_whole && other.is_whole) {
        return (back * other.miss[edge] - own.miss[i]) / ((1 + kKeep) * (own.size[i] + other.size[edge]));
    }
    const Exchange near = exchange_of(own, i), far = exchange_of(other, edge);
    const Mat3d matrix = near.matrix + turn.transpose() * far.matrix * turn;
    return matrix.inverse() * (turn.transpose() * far.slope - near.slope);
}

}  // namespace

HingeSide RestTriangle::own_side(std::size_t i) const {
    const Vec2d &a = x[next(i)], &b = x[next(next(i))];
    const Vec2d edge = b - a, arm = x[i] - a;
    const double length = edge.norm();
    return {length, cross2(edge, arm) / length, arm.dot(edge) / (length * length)};
}

HingeSide RestTriangle::side_for_neighbour(std::size_t i) const {
    HingeSide side = own_side(i);
    side.foot = 1 - side.foot;
    return side;
}

CurvatureFit fit_curvature(const RestTriangle& triangle) {
    CurvatureFit fit;
    fit.area = triangle.area();
    fit.visible = Mat3d::Identity();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        const HingeSide own = triangle.own_side(i);
        fit.along[i] = (triangle.x[next(next(i))] - triangle.x[next(i)]) / own.length;
        const Vec3d normal = across(fit.along[i]);
        if (!triangle.beyond[i]) {
            fit.is_whole = false;
            const Vec3d hidden = fit.visible * normal;
            const double size = normal.dot(hidden);
            if (size > 1e-9) fit.visible -= hidden * hidden.transpose() / size;
            continue;
        }
        fit.angles.row(at) = angle_of_quadratics(triangle, i, fit.along[i]);
        fit.map.col(at) = own.length / fit.area * fitted_share(own, *triangle.beyond[i]) * normal;
    }
    const Mat3d missed = fit.visible * (fit.map * fit.angles - Mat3d::Identity());
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d angles = fit.angles.row(static_cast<Eigen::Index>(i)).transpose();
        const Vec3d weighed = kQuadraticNorm.cwiseProduct(angles);
        fit.miss[i] = missed * weighed;
        fit.size[i] = angles.dot(weighed) / fit.area;
    }
    return fit;
}

// All hinges exchange at once, from the same initial maps, so the result does not depend on their order. The three full
// exchanges of a triangle would overshoot, hence kShare.
Mat3d curvature_map(const CurvatureFit& own, const std::array<FitBeside, 3>& beside) {
    constexpr double kShare = 0.8;
    Mat3d map = own.map;
    for (std::size_t i = 0; i < 3; ++i) {
        if (beside[i].fit == nullptr) continue;
        const CurvatureFit& other = *beside[i].fit;
        const bool is_mirrored = beside[i].is_mirrored;
        const Vec2d there = (is_mirrored ? 1 : -1) * other.along[beside[i].edge];
        const Vec2d here(own.along[i].x(), (is_mirrored ? -1 : 1) * own.along[i].y());
        const double c = here.dot(there), s = cross2(there, here);
        Mat3d turn = turned(c, s), back = turned(c, -s);
        if (is_mirrored) turn.col(2) *= -1, back.row(2) *= -1;  // mirrored in y, 2 k_12 changes its sign
        const Vec3d z = exchanged(own, i, other, beside[i].edge, turn, back);
        map.col(static_cast<Eigen::Index>(i)) += kShare / own.area * z;
    }
    return map;
}

Mat3d free_edge_rigidity(const Vec3d& rigidity, const RestTriangle& triangle) {
    const Mat3d full = rigidity.asDiagonal();
    Eigen::Matrix<double, 3, 2> free;
    Eigen::Index count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (triangle.beyond[i]) continue;
        if (count == 2) return Mat3d::Zero();
        free.col(count++) = across((triangle.x[next(next(i))] - triangle.x[next(i)]).normalized());
    }
    if (count == 0) return full;
    if (count == 1) {
        const Vec3d moment = full * free.col(0);
        return full - moment * moment.transpose() / free.col(0).dot(moment);
    }
    const Eigen::Matrix<double, 3, 2> moments = full * free;
    return full - moments * (free.transpose() * moments).inverse() * moments.transpose();
}

}  // namespace selvedge::sim
