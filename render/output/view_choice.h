#pragma once
// How the camera of a picture is chosen, and whether its cloth is drawn as a curved surface; also by texts, as options
// of the program and of the library have them.
#include <array>
#include <optional>
#include <string>

#include "render/scene/camera.h"
#include "render/surface/curve.h"
#include "sim/body/body.h"
#include "sim/core/math.h"
#include "sim/core/view_point.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::render {

// Either a view direction, for which the scene is framed and then zoomed, or an eye and a target point.
struct CameraChoice {
    Direction direction;
    float zoom = 1;
    std::optional<std::array<Vec3f, 2>> eye_and_target;  // m
};

// Parses "azimuth,elevation[,zoom]" in degrees, or "x,y,z,x,y,z" in metres. Throws InputError, as the others do, whose
// place is the option of the command line.
CameraChoice parse_camera(const std::string& text);

// Options to draw the cloth as a curved surface (thesis ch. 6).

struct SurfaceChoice {
    std::optional<CurveModifier> modifier;  // none: draw the simulated triangles
    std::optional<int> level;               // none: adaptive
    std::optional<float> soft_cap{};        // replaces the modifier's
    bool coarsens_back_faces = false;
    LightNormals light_normals = LightNormals::Recomputed;
};

inline constexpr double kMaxCoefficient = 100;  // of the curve modifier's K0 to K3 and of its soft cap

// A preset by name, or "K0,K1,K2,K3". Throws InputError.
CurveModifier parse_modifier(const std::string& text);

// The mesh to draw. view: the viewer, for back-face coarsening; may be empty. body: the surface is kept outside it; may
// be null.
// Throws InputError as curved_mesh() does.
sim::DrawMesh drawn_mesh(const sim::DrawMesh& garment, const sim::Body* body, const SurfaceChoice& choice,
                         const std::optional<sim::ViewPoint>& view = {});

}  // namespace selvedge::render
