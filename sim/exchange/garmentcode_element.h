#pragma once
// A draped garment as the files of an element of GarmentCodeData (Korosteleva et al. 2024, "GarmentCodeData: A Dataset
// of 3D Made-to-Measure Garments With Sewing Patterns"), for programs that learn from such data:
//   NAME_sim.obj               the cloth, sewn into one mesh: centimetres, y up, the panels packed in the unit square
//                              as vt; one side, without groups;
//   NAME_sim.ply               the same vertices and triangles in the same order, binary, with normals;
//   NAME_sim_segmentation.txt  a line per vertex: its panel, or "stitch_N" where it is sewn, several joined by commas;
//                              N counts the stitches of the specification from 0. Sewn vertices come first, in the
//                              order of their first stitch, then those of each panel;
//   NAME_vertex_labels.yaml    the vertices on edges with a label, by label, ascending: of a sewn edge all, of others
//                              those between its ends;
//   NAME_specification.json    the pattern.
// The dataset's pictures, box mesh and measurements are not written.
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/mesh/draw_mesh.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::sim {

// What each vertex of a sewn garment is of the pattern: panels, stitches and labels.
struct GarmentSegmentation {
    std::vector<std::uint32_t> order;        // vertices of the mesh: stitches first, then panel by panel
    std::vector<std::vector<int>> stitches;  // parallel to `order`: indices into Pattern::seams, ascending
    std::vector<std::string> panels;         // parallel to `order`
    struct Label {
        std::string name;
        std::vector<std::uint32_t> vertices;  // indices into `order`, ascending
    };
    std::vector<Label> labels;  // in the order of the edges that have them; none without vertices
};

// mesh: the leaf triangles of the pattern's cloth, not a curved surface over them. meshing: how the pattern was meshed.
// Stitches that did not close where the vertex is are left out. Throws InputError as count_segments() does.
GarmentSegmentation segment_garment(const DrawMesh& mesh, const Pattern& pattern, const MeshOptions& meshing);

// Of each vertex of the mesh, the seams on which it is: indices into Pattern::seams, ascending. Throws as
// segment_garment().
std::vector<std::vector<int>> seams_of_vertices(const DrawMesh& mesh, const Pattern& pattern,
                                                const MeshOptions& meshing);

inline constexpr int kGarmentCodeFiles = 5;

// The paths of the five files, in the order above.
std::array<std::filesystem::path, kGarmentCodeFiles> garmentcode_paths(const std::filesystem::path& folder,
                                                                       const std::string& name);

// Writes them, each atomically, and makes the folder if it does not exist. Throws InputError if a position is not
// finite, there are no triangles or no material coordinates, or a file cannot be written.
void write_garmentcode_element(const DrawMesh& mesh, const PatternDocument& document, const MeshOptions& meshing,
                               const std::filesystem::path& folder, const std::string& name);

}  // namespace selvedge::sim
