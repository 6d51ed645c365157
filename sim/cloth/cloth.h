#pragma once
// A simulated garment: the adaptive mesh, its fabrics, the state of every vertex, and the state of the solver.
//
// Topology (the mesh) and state (flat arrays indexed by VertexId, sized to the mesh's capacity) are kept apart. During
// a step the solver reads only blocks of constraints, which are updated after each adaptation.  (thesis 3.6)
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/math.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"

namespace selvedge::sim {

// The fabrics of the panels and how they are laid.
struct ClothMaterial {
    std::vector<Fabric> fabrics;      // one per panel
    std::vector<float> grain_angles;  // one per panel, rad: from the panel's +y to the warp
    std::vector<Vec2f> sett_offsets;  // one per panel or none, m: see Panel::sett_offset
    std::vector<int> layers{};        // one per panel or none: a higher layer lies farther out
};

struct SolverState;  // sim/cloth/solver_state.h

// Owns the state of a cloth's solver, into which only sim/cloth looks: what uses cloth does not depend on its parts. A
// copy of the cloth has a state of its own; a cloth that was moved from has none.
class SolverHandle {
 public:
    SolverHandle();
    ~SolverHandle();
    SolverHandle(const SolverHandle& other);
    SolverHandle(SolverHandle&& other) noexcept;
    SolverHandle& operator=(const SolverHandle& other);
    SolverHandle& operator=(SolverHandle&& other) noexcept;

    SolverState& operator*() { return *state_; }
    const SolverState& operator*() const { return *state_; }
    SolverState* operator->() { return state_.get(); }
    const SolverState* operator->() const { return state_.get(); }

 private:
    std::unique_ptr<SolverState> state_;
};

struct Cloth {
    AdaptiveMesh mesh;
    ClothMaterial material{};

    // State, by VertexId.
    std::vector<Vec4f> x{};             // position, m
    std::vector<Vec4f> x_prev{};        // position one sub-step ago, m; velocity = (x - x_prev) / substep
    std::vector<float> inverse_mass{};  // 1/kg; 0 for a vertex that cannot move or is not in use
    std::vector<Vec3f> normals{};       // unit, of the surface; see update_normals
    std::vector<bool> is_pinned{};

    float substep = 0;              // s, the length that x_prev and the solver's constraints refer to
    std::uint32_t adaptations = 0;  // number of adaptations and complete rebuilds so far

    SolverHandle solver{};
};

struct ClothOptions {
    int max_level = 3;
    float substep = 1.0F / 1440.0F;  // s
};

// Pre: garment has no links left (strip or merge them) and one fabric per panel. Starts at rest, at level 0.
Cloth make_cloth(const GarmentMesh& garment, std::vector<Fabric> fabrics, const ClothOptions& options = {});

// Grows the state arrays to `capacity` vertices.
void size_state(Cloth& cloth, std::size_t capacity);

// A third of the mass of a triangle of that panel, kg: its contribution to the mass of each of its corners.
float third_of_mass(const Cloth& cloth, const std::array<Vec2f, 3>& u, std::uint16_t panel);

// Recomputes all masses (a third of the area of the adjacent leaf triangles times the area density) and all constraints
// of the solver from the present leaves. Call it after pins, fabrics or the mesh were changed from outside.
void refresh_solver(Cloth& cloth);

// The same after one adaptation, incrementally, from mesh.changes(). Constraints that stay only get new gains.
void update_solver(Cloth& cloth);

// Changes the length of sub-steps, s. Velocities are kept. The biases of the solver are rescaled (rescale_biases); the
// result is more accurate for shorter sub-steps than for longer ones, which also amplify the errors of the biases.
void set_substep(Cloth& cloth, float substep);

// Area-weighted normals of the leaf triangles. They look to the fabric's right side, except on panels that are turned
// (sim/adaptive/surface_normals.h).
void update_normals(Cloth& cloth);

// Mass-weighted root mean square of the vertices' mean velocities from the positions `before` to the present ones,
// `seconds` later, m/s. It measures kinetic energy without vibrations that average out within `seconds`. Pre: no edge
// was split or rejoined in between.
float rms_speed(const Cloth& cloth, const std::vector<Vec4f>& before, double seconds);

// The height of the lowest leaf vertex, m; infinity if there is none.
float lowest_height(const Cloth& cloth);

// The first leaf vertex with a coordinate that is not finite or at least 100 m from the origin, if any.
std::optional<VertexId> find_bad_vertex(const Cloth& cloth);

// The leaf triangles in their current position, with material coordinates and level of each.
DrawMesh draw_mesh(const Cloth& cloth, const std::vector<std::string>& panel_names);

// The refinement hierarchy: all triangles, depth first. Each base triangle in order is followed by its internal
// triangles.
TriangleHierarchy triangle_hierarchy(const Cloth& cloth);

// The strain of a cloth, from the deformation gradients of its leaf triangles.

struct TriangleStrain {
    float warp = 0;  // length of the deformed warp direction minus 1
    float weft = 0;
    float shear = 0;  // rad, difference of the angle between deformed warp and weft from a right angle, unsigned
};

// One per leaf triangle, in the order of leaf_triangles().
std::vector<TriangleStrain> measure_strain(const Cloth& cloth);

}  // namespace selvedge::sim
