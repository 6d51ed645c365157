#pragma once
// What an experiment measures on cloth, whoever simulated it: a mesh as plain edges and triangles, and how far given
// positions strain it.
#include <array>
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"

namespace selvedge::bench {

// An edge along warp or weft.
struct ThreadEdge {
    int a = 0;
    int b = 0;
    double rest_length = 0;  // m
};

struct MeasuredMesh {
    std::vector<int> vertices;        // those in use: indices into the positions
    std::vector<ThreadEdge> threads;  // never the others: those carry shear
    std::vector<std::array<int, 3>> triangles;
    double rest_area = 0;  // m^2
};

// A corner of a triangle of a mesh: vertex and material coordinates, m.
struct MeasuredCorner {
    int vertex = 0;
    Vec2d u = Vec2d::Zero();
};

// Collects triangles, each edge once. grain_angle: as Panel::grain_angle, rad.
class MeasuredMeshBuilder {
 public:
    void add(const std::array<MeasuredCorner, 3>& corners, double grain_angle);
    MeasuredMesh finish();

 private:
    struct Edge {
        int a, b;
        double rest_length;
        bool is_thread;
    };
    MeasuredMesh mesh_;
    std::vector<Edge> edges_;
};

MeasuredMesh measured(const sim::GarmentMesh& mesh);

struct ThreadStretch {
    double p1 = 0;  // 1st percentile, negative where threads are compressed
    double p99 = 0;
    double max = 0;
};
ThreadStretch thread_stretch(const MeasuredMesh& mesh, const std::vector<Vec3d>& x);

// Area of all triangles over their area at rest.
double area_ratio(const MeasuredMesh& mesh, const std::vector<Vec3d>& x);

bool all_finite(const MeasuredMesh& mesh, const std::vector<Vec3d>& x);

// How far the vertices lie from where they are in another run, m.
struct ShapeDistance {
    double mean = 0;
    double rms = 0;
};
ShapeDistance shape_distance(const MeasuredMesh& mesh, const std::vector<Vec3d>& a, const std::vector<Vec3d>& b);

// Points of a cloth named by their material coordinates, so that a gauge length means the same on any mesh.

// Where the panel's point u (m) is now: interpolated in its leaf triangle, or in the nearest one when u lies a rounding
// error outside all of them.
Vec3d material_point(const sim::Cloth& cloth, int panel, const Vec2d& u);

// The mean place of `count` points spread evenly from u to v, both ends included.
Vec3d mean_material_point(const sim::Cloth& cloth, int panel, const Vec2d& u, const Vec2d& v, int count = 9);

// A strip cut at 45 degrees to the threads, pulled along its length: how far it gives.

// 4/E45 = 1/E_warp + 1/E_weft + 1/G, N/m; the model of a fabric has no lateral contraction. Of small strains.
double bias_stiffness(const sim::Fabric& fabric);

// Strain under `force` (N/m of width). By what the threads give, and by their turning against each other: threads at an
// angle of pi/2 - s make the strip cos(s/2) + sin(s/2) times as long, and G s^2/2 of shear energy is what the force
// did. At 1 % that is 1.5 % less than the small-strain formula. Pre: 0 <= force < 2 G.
double bias_strain(const sim::Fabric& fabric, double force);

}  // namespace selvedge::bench
