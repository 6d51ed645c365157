#pragma once
// Facade for the batch program and tests: dresses a body in a pattern, drapes the garment until it is at rest, and
// reports every fault.
#include <memory>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/core/parallel.h"
#include "sim/dress/dress_options.h"
#include "sim/dress/prepared_body.h"
#include "sim/inspection/report.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

class ContentStore;
class Simulation;
struct Cloth;

// The draped garment: its leaf triangles, their refinement hierarchy, the simulation of its cloth, how its panels were
// meshed, and the report.
struct DressedGarment {
    DrawMesh mesh;
    TriangleHierarchy hierarchy;
    std::unique_ptr<Simulation> simulation;  // never null: of the cloth, which goes on on a body that moves
    MeshOptions meshing{};
    DressReport report;

    DressedGarment();
    DressedGarment(DressedGarment&&) noexcept;
    DressedGarment& operator=(DressedGarment&&) noexcept;
    ~DressedGarment();

    const Cloth& cloth() const;
};

// Throws InputError for a pattern that cannot be meshed, or an unknown fabric or body. Later problems are faults in the
// report. store: where the bodies' fields, and the body that the pattern names, may be found and are kept; null for
// none.
DressedGarment dress(const Pattern& pattern, const std::shared_ptr<const PreparedBody>& prepared,
                     const DressOptions& options = {}, const Progress& progress = {},
                     const ContentStore* store = nullptr);
// The same, with a body that is prepared first.
DressedGarment dress(const Pattern& pattern, const Body& body, const DressOptions& options = {},
                     const Progress& progress = {}, const ContentStore* store = nullptr);

// Bust, waist and hip that the fit table measures otherwise than the mannequin was asked for, one sentence each: the
// table goes to where the trunk is widest or narrowest, and the mannequin has its measures at levels of its own.
std::vector<std::string> girths_unlike_asked(const std::vector<FitRow>& fit, const MannequinReadings& mannequin);

}  // namespace selvedge::sim
