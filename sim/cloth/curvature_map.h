#pragma once
// The curvature of a triangle from the angles of its three hinges: k = C theta, a fixed linear map made at rest.
//
// As in the basic shell triangle (Onate and Zarate 2000) the curvature is the integral of the slopes over the
// triangle's edges: an angle theta about an edge of length l and normal n gives l / area p theta n n', where p is the
// share of the angle that lies on this side. Both sides' integrals of one hinge add up to l n n', so that bending
// about the mean is met on every mesh (weak patch test); how the sum is divided is chosen so that quadratic surfaces
// are met as well as possible.
//
// Curvatures are (k_warp, k_weft, 2 k_twist), 1/m, in the triangle's own frame of warp and weft. Angles are positive
// where the cloth is hollow towards the fabric's right side.
#include <array>
#include <optional>

#include "sim/core/math.h"

namespace selvedge::sim {

using Mat3d = Eigen::Matrix3d;

// A triangle beside an edge, as seen from that edge, at rest.
struct HingeSide {
    double length = 0;  // of the edge, m
    double height = 0;  // of the opposite corner over it, m
    double foot = 0;    // of that height along the edge: 0 at its beginning, 1 at its end
};

// Edge i lies opposite corner i and runs from corner i + 1 to corner i + 2.
struct RestTriangle {
    std::array<Vec2d, 3> x{Vec2d::Zero(), Vec2d::Zero(), Vec2d::Zero()};  // m, anticlockwise; x runs along the warp
    std::array<std::optional<HingeSide>, 3> beyond{};                     // by edge; none at a boundary

    double area() const { return 0.5 * cross2(x[1] - x[0], x[2] - x[0]); }
    HingeSide own_side(std::size_t i) const;
    // The same side for the triangle on the other side of the edge, where the edge runs the other way.
    HingeSide side_for_neighbour(std::size_t i) const;
};

// What is known of a triangle's map without its neighbours' maps.
struct CurvatureFit {
    Mat3d map = Mat3d::Zero();      // C with the shares that fit each hinge alone best
    Mat3d angles = Mat3d::Zero();   // M: row i, the angle of hinge i on the three unit quadratics
    Mat3d visible = Mat3d::Zero();  // the projection that takes out what only missing hinges could show
    std::array<Vec3d, 3> miss{Vec3d::Zero(), Vec3d::Zero(), Vec3d::Zero()};   // what C M - 1 misses of it, by hinge
    std::array<double, 3> size{};                                             // of row i of M, squared, over the area
    bool is_whole = true;                                                     // no hinge is missing
    std::array<Vec2d, 3> along{Vec2d::Zero(), Vec2d::Zero(), Vec2d::Zero()};  // unit, of edge i
    double area = 0;                                                          // m^2
};
CurvatureFit fit_curvature(const RestTriangle& triangle);

struct FitBeside {
    const CurvatureFit* fit = nullptr;  // none at a boundary
    std::size_t edge = 0;               // the shared edge's number there
};

// C: the triangle's fit, with one exchange with each neighbour in the least squares of what both miss. The columns of
// missing hinges are 0.
Mat3d curvature_map(const CurvatureFit& own, const std::array<FitBeside, 3>& beside);

// Rigidities (N m) along warp, weft and of twist, where the cloth may bend freely across missing edges, so that no
// moment is left there: what is least over the curvatures that they could add.
Mat3d free_edge_rigidity(const Vec3d& rigidity, const RestTriangle& triangle);

// Derivatives of the hinges' angles by the heights of the six points, 1/m: the corners, then the apex beyond each edge.
using HingeRows = Eigen::Matrix<double, 3, 6>;
HingeRows hinge_rows(const RestTriangle& triangle);

// How a triangle's edges make up its warp and weft.  (Baraff and Witkin 1998)

// With e1 = x1 - x0, e2 = x2 - x0 the deformed warp direction is a[0] e1 + a[1] e2, the deformed weft direction
// b[0] e1 + b[1] e2. Both have length 1 at rest.
struct MaterialFrame {
    std::array<float, 2> a{};
    std::array<float, 2> b{};
    float area = 0;  // m^2, at rest
};

// u: the corners' material coordinates, m, counter-clockwise; grain_angle: from the panel's +y to the warp, rad.
MaterialFrame material_frame(const std::array<Vec2f, 3>& u, float grain_angle);

// Unit, in the panel's plane.
Vec2f warp_direction(float grain_angle);
Vec2f weft_direction(float grain_angle);

}  // namespace selvedge::sim
