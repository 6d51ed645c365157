#pragma once
// Measurements on a cloth that any solver may have simulated. A MeasuredMesh holds plain edges and triangles; functions
// compute stretch, area change and distance between shapes from given positions. Also: the current position of a
// material point, and the theoretical stiffness of a strip cut on the bias.
#include <array>
#include <vector>

#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"

namespace selvedge::sim {
struct Cloth;
}

namespace selvedge::bench {

// An edge along a yarn direction (warp or weft).
struct YarnEdge {
    int a = 0;
    int b = 0;
    double rest_length = 0;  // m
};

struct MeasuredMesh {
    std::vector<int> vertices;         // those in use, as indices into the positions
    std::vector<YarnEdge> yarn_edges;  // edges along yarns only: the length of other edges also changes with shear
    std::vector<std::array<int, 3>> triangles;
    double rest_area = 0;  // m^2
};

// A triangle corner: vertex index and material coordinates, m.
struct MeasuredCorner {
    int vertex = 0;
    Vec2d u = Vec2d::Zero();
};

// Collects triangles, and each edge once. grain_angle: as Panel::grain_angle, rad.
class MeasuredMeshBuilder {
 public:
    void add(const std::array<MeasuredCorner, 3>& corners, double grain_angle);
    MeasuredMesh finish();

 private:
    struct Edge {
        int a, b;
        double rest_length;
        bool is_yarn;
    };
    MeasuredMesh mesh_;
    std::vector<Edge> edges_;
};

MeasuredMesh measured(const sim::GarmentMesh& mesh);

struct YarnStretch {
    double p1 = 0;  // 1st percentile of the strain, negative if yarns are compressed
    double p99 = 0;
    double max = 0;
};
YarnStretch yarn_stretch(const MeasuredMesh& mesh, const std::vector<Vec3d>& x);

// Total triangle area divided by the area at rest.
double area_ratio(const MeasuredMesh& mesh, const std::vector<Vec3d>& x);

bool all_finite(const MeasuredMesh& mesh, const std::vector<Vec3d>& x);

// Distance between corresponding vertices of two runs, m.
struct ShapeDistance {
    double mean = 0;
    double rms = 0;
};
ShapeDistance shape_distance(const MeasuredMesh& mesh, const std::vector<Vec3d>& a, const std::vector<Vec3d>& b);

// Points given by material coordinates, so that a gauge length means the same on any mesh.

// Current position of the panel's material point u (m), interpolated in its leaf triangle. If rounding puts u outside
// all triangles, the triangle whose smallest barycentric weight is largest is used.
Vec3d material_point(const sim::Cloth& cloth, int panel, const Vec2d& u);

// The mean position of `count` points spaced evenly from u to v, both ends included. Pre: count >= 2.
Vec3d mean_material_point(const sim::Cloth& cloth, int panel, const Vec2d& u, const Vec2d& v, int count = 9);

// Theory of a strip cut at 45 degrees to the yarns and pulled along its length.

// Stiffness E45, N/m, for small strains: 4/E45 = 1/E_warp + 1/E_weft + 1/G. The fabric model has no lateral
// contraction (Poisson's ratio 0).
double bias_stiffness(const sim::Fabric& fabric);

// Strain under `force` (N/m of width): the sum of yarn stretch and yarn rotation. Yarns at an angle of pi/2 - s make
// the strip cos(s/2) + sin(s/2) times as long; s follows from the shear energy G s^2/2 and the work of the force. At
// 1 % strain the result is 1.5 % below the small-strain formula. Pre: 0 <= force < 2 G.
double bias_strain(const sim::Fabric& fabric, double force);

}  // namespace selvedge::bench
