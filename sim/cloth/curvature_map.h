#pragma once
// The curvature of a triangle from the angles of its three hinges: k = C theta, a fixed linear map made at rest.
//
// As in the basic shell triangle (Onate and Zarate 2000) the curvature is the integral of the slopes over the
// triangle's edges: an angle theta about an edge of length l and normal n contributes l / area p theta n n', where p is
// the share of the angle that belongs to this side. The contributions of both sides of a hinge sum to l n n', so that
// the average curvature is exact on every mesh (weak patch test). The shares p are chosen to reproduce quadratic
// surfaces as well as possible.
//
// Curvatures are (k_warp, k_weft, 2 k_twist), 1/m, in the triangle's own frame of warp and weft. Angles are positive
// where the fabric's right side is concave. Across a right_wrong edge the neighbour's curvatures and angles both have
// the opposite sign, and its frame is mirrored; so its map is that of an ordinary neighbour in a mirrored frame.
#include <array>
#include <optional>

#include "sim/core/math.h"

namespace selvedge::sim {

using Mat3d = Eigen::Matrix3d;

// The shape at rest of a triangle beside an edge, relative to that edge.
struct HingeSide {
    double length = 0;  // of the edge, m
    double height = 0;  // of the opposite corner above the edge, m
    double foot = 0;    // position of the foot of that height along the edge: 0 at its start, 1 at its end
};

// Edge i lies opposite corner i and runs from corner i + 1 to corner i + 2.
struct RestTriangle {
    std::array<Vec2d, 3> x{Vec2d::Zero(), Vec2d::Zero(), Vec2d::Zero()};  // m, anticlockwise; x runs along the warp
    std::array<std::optional<HingeSide>, 3> beyond{};                     // by edge; none at a boundary

    double area() const { return 0.5 * cross2(x[1] - x[0], x[2] - x[0]); }
    HingeSide own_side(std::size_t i) const;
    // The same side for use by the neighbour across the edge, which has the edge in the opposite direction. (A
    // neighbour across a right_wrong edge has it in the same direction and uses own_side().)
    HingeSide side_for_neighbour(std::size_t i) const;
};

// The first approximation of a triangle's map, computed without the maps of its neighbours.
struct CurvatureFit {
    Mat3d map = Mat3d::Zero();      // C with the share of each hinge fitted independently of the others
    Mat3d angles = Mat3d::Zero();   // M: row i has the angles of hinge i on the three unit quadratics
    Mat3d visible = Mat3d::Zero();  // projection that removes the curvatures that only missing hinges could measure
    std::array<Vec3d, 3> miss{Vec3d::Zero(), Vec3d::Zero(), Vec3d::Zero()};   // projected error C M - 1, by hinge
    std::array<double, 3> size{};                                             // squared norm of row i of M over area
    bool is_whole = true;                                                     // true if no hinge is missing
    std::array<Vec2d, 3> along{Vec2d::Zero(), Vec2d::Zero(), Vec2d::Zero()};  // unit, of edge i
    double area = 0;                                                          // m^2
};
CurvatureFit fit_curvature(const RestTriangle& triangle);

struct FitBeside {
    const CurvatureFit* fit = nullptr;  // none at a boundary
    std::size_t edge = 0;               // the index of the shared edge in the neighbour
    bool is_mirrored = false;           // the neighbour's right side is on this triangle's wrong side (AdaptiveEdge)
};

// C: the triangle's own fit, corrected by one exchange with each neighbour that minimises the squared errors of both.
// The columns of missing hinges are 0.
Mat3d curvature_map(const CurvatureFit& own, const std::array<FitBeside, 3>& beside);

// The rigidity matrix (N m) of warp, weft and twist for a triangle with free edges, across which the moment is zero:
// the energy minimised over the curvatures normal to those edges (static condensation).
Mat3d free_edge_rigidity(const Vec3d& rigidity, const RestTriangle& triangle);

}  // namespace selvedge::sim
