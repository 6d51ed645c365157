#pragma once
// A square of cotton dropped on a sphere, pinned in its centre: the scene by which cloth solvers are compared.
#include "sim/cloth/cloth.h"
#include "sim/core/vec.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"

namespace selvedge {

struct DropScene {
    double side = 1;        // m, of the square
    double height = 0.256;  // m, at which it starts, horizontal
    double radius = 0.25;   // m, of the sphere about the origin
    int frames = 90;
    double frame_seconds = 1.0 / 60;
    int level = 3;  // to which the coarse grid is refined
};

// 0.2 kg/m^2, a cotton. Its strain limit lies far beyond what the drop strains it.
Fabric drop_fabric();

// Quads of the coarse grid along a side, of 3, 6, 11 and 22 the one that comes nearest to so many triangles once
// refined.
int base_quads_for(int triangles, const DropScene& scene = {});
int triangle_count(int base_quads, int level);

// The coarse grid at its height, moved sideways by `shift` m.
GarmentMesh drop_square(int base_quads, double shift = 0, const DropScene& scene = {});

// The same square as one grid without levels, for solvers that know none: quads along a side.
GarmentMesh flat_grid(int quads, const DropScene& scene = {});

// Whether frame 1.. is one at which the shape is looked at: 30, 40 .. 90.
bool is_sampled(int frame);

}  // namespace selvedge
