#pragma once
// Drawing the cloth curved: the options that dress and render share.
#include <CLI/CLI.hpp>
#include <optional>

#include "render/surface/curved_mesh.h"
#include "sim/body/body.h"

namespace selvedge {

struct SurfaceChoice {
    std::optional<SurfaceKind> kind;  // none: the cloth's own triangles, as they were simulated
    std::optional<int> level;         // none: adaptive
    bool coarsens_back_faces = false;
    LightNormals light_normals = LightNormals::Recomputed;
};

// Adds --surface, --surface-level, --surface-normals and --back-face-coarsening, checked while the command line is
// read. `choice` must outlive the command line.
void add_surface_options(CLI::App& command, SurfaceChoice& choice);

// The garment as it is drawn. view: of whoever looks at it, if there is one. body: not to dip into, may be null.
// Throws InputError as curved_mesh() does.
PlainMesh drawn_mesh(const PlainMesh& garment, const Body* body, const SurfaceChoice& choice,
                     const std::optional<ViewPoint>& view = {});

}  // namespace selvedge
