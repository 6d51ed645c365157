#pragma once
// A garment's mesh as the cloth shader reads it: three vertices to a triangle, for material coordinates, edges and
// levels belong to triangles and their corners.
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "render/gl/handle.h"
#include "render/scene/scene.h"
#include "sim/core/math.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge::render {

// How open a point is to the room's light, 0..1, on the surface's two sides.
struct Openness {
    float front = 1;
    float back = 1;
};

struct ClothVertex {
    std::array<float, 3> position;  // m
    std::array<float, 3> normal;
    std::array<float, 2> place;    // (weft, warp), m: material coordinates turned by the panel's grain, and its offset
    std::array<float, 3> heights;  // m; at this corner: its height over the opposite edge, else 0
    std::array<float, 2> ambient_visibility;
    std::array<float, 2> touch;  // m to a seam and a hem that the triangle touches with one corner only
    std::uint32_t marks;         // level | seam edges << 8 | hem edges << 11; edge i is opposite corner i
};

// normals: one per vertex of the mesh, also when the mesh has its own. Seam edges are those where material
// coordinates jump, hem edges those with one triangle. Pre: openness has one entry per vertex of the mesh.
std::vector<ClothVertex> make_cloth_vertices(const sim::PlainMesh& mesh, const std::vector<Vec3f>& normals,
                                             const std::vector<Openness>& ambient_visibility);

// A cloth's paint on its way to GL: a place along a map for each corner, and the map as a row of texels.

struct PaintBuffer {
    Buffer places;
    Texture map{};
    int colours = 0;  // 0: not painted
    float ink = 0;    // of edges
};

// Adds the corners' places to the bound vertex array. Pre: the item's paint, where it has any, fits its mesh.
PaintBuffer make_paint_buffer(const GladGLContext& gl, const ClothItem& item);

// How the cloth shader is to draw the mode: a painted one without paint is plain.
int cloth_look(ShowMode show, const PaintBuffer& paint);

// Pre: the program is in use. `unit`: for the map.
void bind_paint(const GladGLContext& gl, const Program& program, const PaintBuffer& paint, int unit);

// Which edges of a garment's triangles are sewn or hemmed, and how far from them the cloth beside them is, so that both
// can be drawn.

// Bit i is the edge opposite corner i.
struct TriangleMarks {
    std::uint32_t seam = 0;  // material coordinates jump
    std::uint32_t hem = 0;   // no triangle on the other side
};

std::vector<TriangleMarks> mark_edges(const sim::PlainMesh& mesh);

// m, at one corner of a triangle that touches a seam or hem with a single vertex: to be interpolated, so that the
// distance goes on without a jump from the triangles that lie along it.
struct TouchDistance {
    static constexpr float kFar = 1e3F;
    float seam = kFar;
    float hem = kFar;
};

std::vector<std::array<TouchDistance, 3>> touch_distances(const sim::PlainMesh& mesh,
                                                          const std::vector<TriangleMarks>& marks);

// Of each corner over the opposite edge, m.
std::array<float, 3> corner_heights(const std::array<Vec3f, 3>& x);

}  // namespace selvedge::render
