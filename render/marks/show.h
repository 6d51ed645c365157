#pragma once
// From a mesh and a mode to what is drawn: paint, marks and the legend that explains them.  (SPEC 6, thesis 3.7)
#include <optional>
#include <vector>

#include "render/marks/legend.h"
#include "render/scene/scene.h"
#include "render/scene/solids.h"

namespace selvedge::render {

struct ShowFacts {
    std::vector<float> clearance{};  // m, one per vertex of the garment; Clearance asks for them
    float line_radius = 0.003F;      // m, of the lines of Seams and of outlines in Hierarchy
};

// Whether the mode reads the garment's material coordinates.
bool wants_material(ShowMode mode);

// Whether colours stand for figures or kinds, so that they want even light.
bool is_painted(ShowMode mode);

// Fills in what the mode of the scene's first cloth shows, and returns the legend, where it has one.
// Pre: the mode is not Hierarchy; material coordinates and facts that it asks for are there, and finite.
std::optional<Legend> fill_show(Scene& scene, const ShowFacts& facts = {});

// The same for Hierarchy: the model becomes the scene's only cloth.
Legend fill_hierarchy(Scene& scene, const sim::TriangleHierarchy& hierarchy, StackSide side,
                      const ShowFacts& facts = {});

// How many triangles each level has, up to the highest.
Legend level_legend(const sim::PlainMesh& mesh);

// Figures on a map: the range that a map spans, in round numbers, and the legend that says so.

// The least of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten that is no less. Pre: value > 0, finite.
double round_up(double value);

// The map's ends in percent, its middle 0; the 99th percentile, the greatest and the least of `strains`, 0.01 being one
// percent. Pre: limit > 0, strains are not empty.
Legend strain_legend(const std::string& title, double limit, const std::vector<double>& strains);

// From 0 to `limit`, in mm; the figures are in m. Pre: as above.
Legend clearance_legend(double limit, const std::vector<double>& clearances);

}  // namespace selvedge::render
