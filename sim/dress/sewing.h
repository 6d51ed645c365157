#pragma once
// Closing the seams: the panels, still apart and at level 0, are drawn together along their seams without gravity, each
// colliding with the body from its own side; what has met is merged.  (SPEC 3.1, way b)
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/cloth/step.h"
#include "sim/core/parallel.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::sim {

class BodyCollider;

struct SewingOptions {
    float closing_speed = 0.6F;  // m/s at which the allowed gap shrinks
    float closed_gap = 0.006F;   // m, a link shorter than this is closed: two contact offsets may lie between its ends
    float patience = 1.5F;       // s of further pulling once the gap should be nil
    ContactOptions contact;
};

struct OpenSeam {
    int seam = 0;   // index into Pattern::seams
    float gap = 0;  // m, the widest of its links
};

struct SewingResult {
    GarmentMesh sewn;  // links that did not close are left out of the merge
    std::vector<OpenSeam> open;
    double simulated_seconds = 0;
    std::optional<VertexId> bad_vertex;  // of the unsewn mesh, where a number went bad; `sewn` is then not to be used
};

// Sewing under way: one step with each advance().
class SewingRun {
 public:
    SewingRun(GarmentMesh unsewn, const std::vector<Fabric>& fabrics, const SewingOptions& options);

    // False once it is over: all is closed, patience is at its end, or a number went bad. Pre: it was true before.
    bool advance(const BodyCollider& body);

    double fraction() const { return std::min(1.0F, seconds_ / limit_); }
    const GarmentMesh& unsewn() const { return unsewn_; }
    const Cloth& cloth() const { return cloth_; }  // of the panels, apart: vertices as in unsewn()
    SewingResult result() const;

 private:
    GarmentMesh unsewn_;
    SewingOptions options_;
    Cloth cloth_;
    std::vector<SeamPull> pulls_;
    float start_gap_ = 0;  // m
    float limit_ = 0;      // s
    float seconds_ = 0;
    std::optional<VertexId> bad_vertex_;
};

SewingResult sew_on_body(const GarmentMesh& unsewn, const std::vector<Fabric>& fabrics, const BodyCollider& body,
                         const SewingOptions& options, const Progress& progress);

}  // namespace selvedge::sim
