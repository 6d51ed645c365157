#pragma once
// A garment's mesh in the layout of the cloth shader: three vertices per triangle, because material coordinates, marks
// and levels belong to triangles and their corners. Also the cloth's paint in GL buffers, and the prefix sums of a
// sett's colours.
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "render/gl/target.h"
#include "render/scene/scene.h"
#include "sim/core/math.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/tartan/sett.h"

namespace selvedge::render {

// Ambient visibility of a point on the two sides of the surface: 0 (occluded) to 1 (open).
struct AmbientVisibility {
    float front = 1;
    float back = 1;
};

// (weft, warp), m, of material coordinates (m). grain: the warp's angle, rad, anticlockwise from +y; the weft is a
// quarter turn clockwise from the warp. The sett's offset is added after the rotation.
Vec2f place_on_fabric(const Vec2f& material, float grain, const Vec2f& sett_offset);

struct ClothVertex {
    std::array<float, 3> position;  // m
    std::array<float, 3> normal;
    std::array<float, 2> place;    // place_on_fabric()
    std::array<float, 3> heights;  // m: height over the opposite edge in the own slot, else 0
    std::array<float, 2> ambient_visibility;
    std::array<float, 2> touch;  // m, distance to a seam and to a hem that the triangle touches with one corner only
    std::uint32_t marks;         // level | seam edges << 8 | hem edges << 11; edge i is opposite corner i
};

// normals: one per vertex of the mesh; used even if the mesh has its own. Seam edges lie between two panels or where
// material coordinates jump; hem edges have one triangle. Pre: ambient_visibility has one entry per vertex of the mesh.
std::vector<ClothVertex> make_cloth_vertices(const sim::DrawMesh& mesh, const std::vector<Vec3f>& normals,
                                             const std::vector<AmbientVisibility>& ambient_visibility);

// A cloth's paint in GL buffers: for each corner a position along a colour map, and the map as one row of texels.

struct PaintBuffer {
    Buffer places;
    Texture map{};
    int colours = 0;  // number of map colours; 0: not painted
    float ink = 0;    // 0..1, darkness of the triangles' edges
};

// Adds the corners' map positions to the bound vertex array. Pre: the item's paint, if it has one, fits its mesh.
PaintBuffer make_paint_buffer(const GladGLContext& gl, const ClothItem& item);

// The cloth shader's value of `show` for a mode; a painted mode without paint is drawn plain.
int cloth_look(ShowMode show, const PaintBuffer& paint);

// Pre: the program is in use. `unit`: texture unit of the map.
void bind_paint(const GladGLContext& gl, const Program& program, const PaintBuffer& paint, int unit);

// Prefix sums of a sett's colours. With them the shader gets the mean colour of any stretch of a sett in two lookups.

// Linear light. sums[k] = sum over threads i < k of (colour(i) - mean), k = 0..threads. Because the mean is subtracted,
// the sums begin and end at 0, so they repeat with the sett and stay small enough for float precision.
struct SettSums {
    Vec3f mean = Vec3f::Zero();
    std::vector<Vec3f> sums;

    int threads() const { return static_cast<int>(sums.size()) - 1; }
};

// Pre: the sett has threads.
SettSums sum_warp(const sim::Sett& sett);
SettSums sum_weft(const sim::Sett& sett);  // equals the warp's if the weft repeats it

}  // namespace selvedge::render
