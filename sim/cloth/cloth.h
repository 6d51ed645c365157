#pragma once
// A garment as it moves: the adaptive mesh, what it is made of, the state of every vertex, and the solver's own part.
//
// Topology (the mesh) and state (flat arrays indexed by VertexId, sized to the mesh's capacity) are kept apart. The
// solver reads neither the hierarchy nor the fabrics but blocks of constraints, made after an adaptation.
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/cloth/solver_state.h"
#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"

namespace selvedge::sim {

// What the mesh is made of.
struct ClothMaterial {
    std::vector<Fabric> fabrics;      // one per panel
    std::vector<float> grain_angles;  // one per panel, rad: from the panel's +y to the warp
    std::vector<Vec2f> sett_offsets;  // one per panel or none, m: see Panel::sett_offset
};

struct Cloth {
    AdaptiveMesh mesh;
    ClothMaterial material{};

    // State, by VertexId.
    std::vector<Vec4f> x{};             // position, m
    std::vector<Vec4f> x_prev{};        // position one sub-step ago, m: velocity is their difference over the sub-step
    std::vector<float> inverse_mass{};  // 1/kg; 0 for a vertex that cannot move or is not in use
    std::vector<Vec3f> normals{};       // unit, of the fabric's right side; see update_normals
    std::vector<bool> is_pinned{};

    float substep = 0;              // s, the length that x_prev and the solver's constraints were made for
    std::uint32_t adaptations = 0;  // so far

    SolverState solver{};
};

struct ClothOptions {
    int max_level = 3;
    float substep = 1.0F / 1440.0F;  // s
};

// Pre: garment has no links left (strip or merge them) and one fabric per panel. Starts at rest, at level 0.
Cloth make_cloth(const GarmentMesh& garment, std::vector<Fabric> fabrics, const ClothOptions& options = {});

// Grows the state arrays to `capacity` vertices.
void size_state(Cloth& cloth, std::size_t capacity);

// A third of the mass of a triangle of that panel, kg: what it gives to each of its corners.
float third_of_mass(const Cloth& cloth, const std::array<Vec2f, 3>& u, std::uint16_t panel);

// Masses (a third of the adjacent leaf triangles' area times density) and the solver's constraints, all anew from the
// present leaves: after pins, fabrics or the mesh were changed from outside.
void refresh_solver(Cloth& cloth);

// The same after one adaptation, in place: see mesh.changes(). What stays only gets its gains anew.
void update_solver(Cloth& cloth);

// Another length of sub-steps, s. Speeds are kept; what has been learnt is fitted, and fits shorter ones better: for
// longer ones its errors grow too.
void set_substep(Cloth& cloth, float substep);

// Area-weighted normals of the leaf triangles.
void update_normals(Cloth& cloth);

// Root mean square, over mass, of the mean speed with which the cloth came from `before` to where it is, m/s: its
// kinetic energy, but for what trembles to and fro within `seconds`. Pre: nothing was split or rejoined in between.
float rms_speed(const Cloth& cloth, const std::vector<Vec4f>& before, double seconds);

// The first leaf vertex whose position is not finite or left the room (100 m), if any.
std::optional<VertexId> find_bad_vertex(const Cloth& cloth);

// How far a cloth is strained, from the deformation gradients of its leaf triangles.

struct TriangleStrain {
    float warp = 0;  // length of the deformed warp direction less 1
    float weft = 0;
    float shear = 0;  // rad, angle between the deformed warp and weft directions less a right angle, unsigned
};

// One per leaf triangle, in their order.
std::vector<TriangleStrain> measure_strain(const Cloth& cloth);

}  // namespace selvedge::sim
