#include "bench/thesis/captions.h"

#include <algorithm>
#include <array>

namespace selvedge::bench {
namespace {

constexpr auto kTable = CaptionKind::Table;
constexpr auto kFigure = CaptionKind::Figure;
constexpr auto kListing = CaptionKind::Listing;

template <std::size_t kCount>
constexpr std::array<WantedColumn, kCount + 1> transitions_between(const std::array<std::string_view, kCount>& names) {
    std::array<WantedColumn, kCount + 1> columns;
    columns[0] = {"from"};
    for (std::size_t i = 0; i < kCount; ++i) columns[i + 1] = {.quantity = names[i], .is_whole_name = true};
    return columns;
}

constexpr auto kByState = transitions_between<8>({"S0", "S1", "S2", "S3", "S4", "S5", "S6", "S7"});
constexpr auto kByConfiguration =
    transitions_between<11>({"C0", "C1", "C2", "C3", "C4", "C5", "C6", "C7", "C8", "C9", "C10"});
constexpr WantedColumn kClearing[]{{"configuration"}, {"clear", "us"}, {"configure", "us"}};
constexpr WantedColumn kTraversal[]{{"level"}, {"recursion", "ms"}, {"lists", "ms"}, {"creating", "ms"}};
constexpr WantedColumn kRefinement[]{{"level"},         {"triangles"},   {"refine", "ms"},
                                     {"coarsen", "ms"}, {"pools", "ms"}, {"new/delete", "ms"}};
constexpr WantedColumn kMemory[]{{"level"}, {"vertices"}, {"edges"}, {"triangles"}};
constexpr WantedColumn kUniformDrop[]{{"level"},           {"triangles"}, {"adaptation", "ms"}, {"simulation", "ms"},
                                      {"collision", "ms"}, {"step", "ms"}};
constexpr WantedColumn kAdaptiveDrop[]{{"object"},           {"criteria"},        {"triangles"},
                                       {"adaptation", "ms"}, {"collision", "ms"}, {"simulation", "ms"}};
constexpr WantedColumn kPointSearch[]{{"share of the volume"}, {"points"}, {"grid", "ms"}, {"octree", "ms"}};
constexpr WantedColumn kParameters[]{{"parameter"}, {"value"}};
constexpr WantedColumn kCharacterUpdate[]{{"total", "ms"},
                                          {"bounding structures", "ms"},
                                          {"face normals and plane distances", "ms"},
                                          {"skinning", "ms"},
                                          {"rendering", "ms"}};
constexpr WantedColumn kCharacterCloth[]{{"triangles"},        {"simulation", "ms"}, {"collision", "ms"},
                                         {"adaptation", "ms"}, {"rendering", "ms"},  {"total", "ms"}};
constexpr WantedColumn kCharacterCollision[]{{"PCT, cylinders"}, {"collecting by cylinders", "ms"},
                                             {"PCT, spheres"},   {"collecting by spheres", "ms"},
                                             {"cloth vertices"}, {"vertices in collision"}};
constexpr WantedColumn kWeights[]{{"index"}, {"t", {}, true}, {"P0"}, {"L1"}, {"L2"}, {"P3"}};
constexpr WantedColumn kDressSurface[]{{"surface"},         {"drawn triangles"}, {"coarse simulation", "ms"},
                                       {"collision", "ms"}, {"range", "ms"},     {"surface", "ms"},
                                       {"drawing", "ms"}};
constexpr WantedColumn kSurface[]{
    {"surface"}, {"drawn triangles"}, {"simulation", "ms"}, {"surface", "ms"}, {"drawing", "ms"}};

constexpr Caption kCaptions[]{
    {kTable, "3.1", "How often each state gave way to each other, % of all recorded transitions of the drops.",
     kByState, "30,471 transitions, of which S0 to S7 9.1 % and S7 to S0 2.7 %."},
    {kTable, "3.2", "The cost of clearing each configuration to the cleared state SC, and of configuring it back.",
     kClearing},
    {kTable, "3.3", "The cost of each transition by way of the cleared triangle.", kByConfiguration,
     "C1 to C2: 0.246 us."},
    {kTable, "3.4", "The cost of each direct transition.", kByConfiguration, "C1 to C2: 0.145 us."},
    {kTable, "3.5", "The cost of direct transitions as a share of indirect ones.", kByConfiguration,
     "C1 to C2: 58.8 %."},
    {kTable, "3.6",
     "A simulation step by recursion through the hierarchy and by temporary lists, and the cost of creating the "
     "lists; 128 base triangles.",
     kTraversal},
    {kTable, "3.7", "Uniform refinement and coarsening of 32 triangles, memory pools against new and delete.",
     kRefinement},
    {kTable, "3.8", "Uniform refinement and coarsening of 128 triangles, memory pools against new and delete.",
     kRefinement},
    {kTable, "3.9", "Uniform refinement and coarsening of 512 triangles, memory pools against new and delete.",
     kRefinement},
    {kTable, "3.10", "Uniform refinement and coarsening of 2,048 triangles, memory pools against new and delete.",
     kRefinement},
    {kTable, "3.11", "Memory of the whole hierarchy under uniform refinement.", kMemory,
     "144 bytes per vertex (80 of them a list of up to 20 adjacent triangles), 52 per edge, 120 per triangle; "
     "32-bit pointers."},
    {kTable, "3.12", "Mean cost of each step of a cloth of 32 base triangles dropped on a cylinder, uniform levels.",
     kUniformDrop},
    {kTable, "3.13", "Mean cost of each step of a cloth of 32 base triangles dropped on a sphere, uniform levels.",
     kUniformDrop},
    {kTable, "3.14",
     "Mean costs of adaptive drops on a cylinder and a sphere by criteria: A collision, B curvature, C edge "
     "length.",
     kAdaptiveDrop},
    {kFigure,
     "3.1",
     "Drawing: each vertex knows its adjacent triangles.",
     {},
     {},
     "sim/adaptive/adaptive_mesh.h: AdaptiveMesh::triangles_at walks round a vertex; no list is stored"},
    {kFigure,
     "3.2",
     "Drawing: central vertices and child edges of a split edge.",
     {},
     {},
     "sim/adaptive/adaptive_mesh.h: AdaptiveEdge, with the drawing"},
    {kFigure,
     "3.3",
     "Drawing: the connectivity of an edge, Edge-Pair and Edge-Trio.",
     {},
     {},
     "bench/thesis/edge_pair_mesh.h and pointer_mesh.h; their cost is under listing 3.1"},
    {kFigure,
     "3.4",
     "Drawing: the connectivity of a triangle.",
     {},
     {},
     "sim/adaptive/adaptive_mesh.h: AdaptiveTriangle"},
    {kFigure, "3.5", "The eight states of a triangle, S0 to S7, by which of its edges are split."},
    {kFigure,
     "3.6",
     "Refinement patterns drawn inside their parents, and the steps between them.",
     {},
     {},
     "sim/adaptive/configuration.h; the internal triangles are those of figure 3.7"},
    {kFigure, "3.7", "The configurations of each state; three states have two."},
    {kFigure, "3.8", "The configurations with their internal triangles t0 to t3 and internal edges e0 to e2."},
    {kFigure,
     "3.9",
     "The refinements that come of four ways to choose a diagonal: default, edge length, rest length, curvature.",
     {},
     "The four are very similar, so that the default is valid."},
    {kFigure,
     "3.10",
     "Drawing: the hierarchy of an edge flattened, with permitted splits and rejoins.",
     {},
     {},
     "sim/adaptive/adaptive_mesh.h: may_split, may_rejoin"},
    {kFigure,
     "3.11",
     "Drawing: splits and rejoins that the adjacent triangles permit.",
     {},
     {},
     "sim/adaptive/adaptive_mesh.h: may_split, may_rejoin; tests/sim/adaptive/test_adaptive_mesh.cpp"},
    {kFigure,
     "3.12",
     "Drawing: curvature as the angle between the normals at the ends of an edge.",
     {},
     {},
     "sim/adaptive/criteria.h: CurvatureCriterion"},
    {kFigure,
     "3.13",
     "Drawing: a collision splits an edge, and the new vertex moves out to the surface.",
     {},
     {},
     "sim/cloth/collision_criterion.h"},
    {kFigure,
     "3.14",
     "Drawing: a triangle split in four keeps its edge directions at half the length.",
     {},
     {},
     "docs/solver.md"},
    {kFigure,
     "3.15",
     "Drawing: a bending element of two triangles about an edge.",
     {},
     {},
     "sim/cloth/triangle_bending.h, docs/solver.md"},
    {kFigure, "3.16",
     "An adaptive cloth on a sphere: triangles coloured by level; with edges; vertices as spheres that halve with "
     "each level."},
    {kFigure, "3.17", "An adaptive cloth on a sphere from above, beside its hierarchy in 3D."},
    {kFigure, "3.18", "A cloth on a sphere in several material colours, per-pixel Phong lighting."},
    {kFigure, "3.19", "A test pattern on a cloth of 40 x 40 cm by position p and size s; green axes mark p."},
    {kFigure, "3.20", "A hanging cloth in three tartans."},
    {kFigure,
     "3.21",
     "The cost of refinement per existing triangle, standard allocation against memory pools.",
     {},
     "Refinement makes four triangles of each."},
    {kFigure,
     "3.22",
     "The cost of coarsening per existing triangle, standard allocation against memory pools.",
     {},
     "Coarsening leaves a quarter of the triangles."},
    {kFigure,
     "3.23",
     "Sphere [A]: with the collision criterion, cloth coarsens at once where it loses contact.",
     {},
     "Parts no longer in contact coarsen immediately."},
    {kFigure,
     "3.24",
     "The drops of table 3.14 on the sphere (top) and the cylinder (bottom), by criteria.",
     {},
     "C by itself is ineffective; with other criteria it makes more wrinkles."},
    {kFigure, "3.25", "Cylinder [A]: time of each step, and the triangle count."},
    {kFigure, "3.26", "Sphere [A]: time of each step, and the triangle count."},
    {kFigure, "3.27", "Cylinder [B]: time of each step, and the triangle count."},
    {kFigure, "3.28", "Sphere [B]: time of each step, and the triangle count."},
    {kFigure, "3.29", "Sphere [A+B]: time of each step, and the triangle count."},
    {kFigure, "3.30", "Sphere [C]: time of each step, and the triangle count."},
    {kListing, "3.1", "Edge-Pair: an edge as two adaptive half-edges; beside the Edge-Trio, with its cost."},
    {kListing,
     "3.2",
     "Edge-Trio: one edge with two side records.",
     {},
     {},
     "sim/adaptive/adaptive_mesh.h: AdaptiveEdge"},
    {kListing,
     "3.3",
     "The start vertex of an edge side.",
     {},
     {},
     "sim/adaptive/adaptive_mesh.h: AdaptiveMesh::side_of, end"},
    {kListing, "3.4", "The structure of a triangle.", {}, {}, "sim/adaptive/adaptive_mesh.h: AdaptiveTriangle"},
    {kListing, "3.5", "ClothProperty: the global settings of the cloth in one place."},
    {kListing,
     "3.6",
     "Recursive refinement of an edge.",
     {},
     {},
     "sim/adaptive/adapt.h, level by level over lists instead of recursion"},
    {kListing, "3.7", "Recursive coarsening of an edge.", {}, {}, "sim/adaptive/adapt.h"},
    {kListing, "3.8", "The curvature criterion.", {}, {}, "sim/adaptive/criteria.h: CurvatureCriterion"},
    {kListing, "3.9", "The length criterion.", {}, {}, "sim/adaptive/criteria.h: LengthCriterion"},
    {kListing,
     "3.10",
     "Criteria combined by a template.",
     {},
     {},
     "sim/adaptive/criteria.h: combined criteria, without a virtual call per edge"},
    {kListing,
     "3.11",
     "The memory pool.",
     {},
     {},
     "sim/core/pool.h; the thesis' pools of pointers are bench/thesis/pointer_mesh.h"},
    {kListing, "3.12", "Edge length constraints after Provot for unequal masses: the thesis' own cloth as a baseline."},
    {kListing, "3.13", "Vertex data streamed to the GPU.", {}, {}, "render/draw/scene_buffers.h, cloth_vertices.h"},
    {kTable, "4.1", "Searching for 3D points in a grid of 32 x 32 x 32 cells and in an octree of the same depth.",
     kPointSearch, "32,768 random points in a cube."},
    {kFigure, "4.1", "Drawing: the data flow from panels to the simulated mesh.", {}, {}, "docs/architecture.md"},
    {kFigure, "4.2",
     "The pattern editor: two panels on the grid of material coordinates, a triangle of vertices selected, the 3D "
     "view, the transformations as numbers."},
    {kFigure, "4.3", "Panels in 2D, placed round the body with seam links, and merged."},
    {kFigure,
     "4.4",
     "Drawing: vertices merge at a seam, material coordinates do not.",
     {},
     {},
     "sim/mesh/sew.h; tests/sim/mesh"},
    {kFigure, "4.5", "Drawing: a seam of unequal sides takes their mean length.", {}, {}, "sim/mesh/sew.h: kSeamEase"},
    {kFigure,
     "4.6",
     "Drawing: material coordinates made continuous across a seam.",
     {},
     {},
     "sim/adaptive/leaf_tracker.h: Hinge"},
    {kFigure, "4.7", "A cylinder in the collision grid: one highlighted cell and its triangles."},
    {kFigure, "4.8",
     "A character in the collision grid: one cell on the left shoulder and the triangles that overlap it."},
    {kFigure,
     "4.9",
     "Drawing: a new vertex inside an object moves out along a ray.",
     {},
     {},
     "sim/cloth/contact.h: outside; tests/sim/cloth"},
    {kFigure,
     "4.10",
     "Drawing: the ray followed in both directions, for open and closed surfaces.",
     {},
     {},
     "sim/cloth/contact.h: outside; tests/sim/cloth"},
    {kFigure,
     "4.11",
     "A T-shirt on a static body: the base mesh cuts the body; the refined mesh does not.",
     {},
     "The base mesh is too coarse; refinement resolves all intersections."},
    {kFigure,
     "4.12",
     "The draped T-shirt of 316 base triangles.",
     {},
     "316 base triangles refined to 6,199 of a possible 20,224 (level 3) on a character of 67,000 triangles; about "
     "22 ms for one adaptation and four steps."},
    {kFigure, "4.13", "The draped T-shirt with the adaptive hierarchy of its front."},
    {kTable, "5.1", "The simulation parameters of all experiments of chapter 5.", kParameters},
    {kTable, "5.2", "Mean time to update the character each time it is animated.", kCharacterUpdate},
    {kTable, "5.3", "Mean triangle counts and times of simulation, collision, adaptation and rendering.",
     kCharacterCloth},
    {kTable, "5.4",
     "Potentially colliding triangles and the time to collect them, by cylinders and by spheres; cloth vertices, "
     "and those in collision.",
     kCharacterCollision},
    {kFigure,
     "5.1",
     "Drawing: a bone in two poses and its local frame.",
     {},
     {},
     "bench/thesis/limb_cylinders.h: LimbBounds::Cylinder"},
    {kFigure,
     "5.2",
     "Drawing: a bounding cylinder in stacks and slices.",
     {},
     {},
     "bench/thesis/limb_cylinders.h, with the drawing; on a character in figure 5.5"},
    {kFigure,
     "5.3",
     "Drawing: the smallest enclosing offset cylinder from pairs of vertices.",
     {},
     {},
     "bench/thesis/limb_cylinders.h: smallest_circle; tests/bench/test_limb_cylinders.cpp compares it with pairs"},
    {kFigure, "5.4", "Cloth projected to the closest points of the offset surface."},
    {kFigure, "5.5", "The bounding cylinders of a character: stacks of 2 cm and 32 slices."},
    {kFigure, "5.6", "The timeline of animation frames, blended frames and cloth updates."},
    {kFigure, "5.7", "Back-face coarsening from the front and the back."},
    {kFigure, "5.8", "Back-face coarsening from front, side and back; unseen edges in green."},
    {kFigure,
     "5.9",
     "Each experiment at the same frames: levels 0 to 3, adaptive, adaptive with back-face coarsening.",
     {},
     "Level 0 shows interpenetration."},
    {kFigure, "5.10", "The triangle count against a target that changes."},
    {kFigure, "5.11", "The triangle count against a target that changes, a second run."},
    {kListing, "5.1", "The update of the skin's vertex positions.", {}, {}, "sim/body/skin.h: skin, SkinnedSurface"},
    {kTable, "6.1", "The lookup table of Lagrange weights for level 3: t, its index and its four coefficients.",
     kWeights},
    {kTable, "6.2", "Simulation A: a square pinned at two corners, 250 coarse triangles.", kSurface},
    {kTable, "6.3", "Simulation B: a flag in the wind, 250 coarse triangles.", kSurface},
    {kTable, "6.4", "Simulation C: a dress of 488 coarse triangles on an animated character.", kDressSurface,
     "The cost of the coarse simulation includes collision."},
    {kFigure,
     "6.1",
     "Drawing: the cubic Bezier of an edge from the normals at its ends.",
     {},
     {},
     "render/surface/edge_curve.h"},
    {kFigure,
     "6.2",
     "Drawing: the order in which edges of a triangle are processed.",
     {},
     {},
     "render/surface/curved_surface.h: SurfacePlan"},
    {kFigure,
     "6.3",
     "Drawing: the Lagrange curve through the points of the Bezier at 1/3 and 2/3.",
     {},
     {},
     "render/surface/edge_curve.h: EdgeCurve"},
    {kFigure, "6.4", "Three curve shapes at several percentages of the rest length, M = (rest length / length)^2."},
    {kFigure,
     "6.5",
     "SoftCap(M, SC) = SC + (M - SC) / M above SC, for SC = 1.",
     {},
     "Values below SC are not changed."},
    {kFigure,
     "6.6",
     "Interpolated normals beside normals recomputed from the curved surface.",
     {},
     "Interpolated normals do not suffice: recomputed ones reveal many details."},
    {kFigure, "6.7",
     "A character in a dress at level 2 with {K0 K1 K2 K3} flat, constant, linear, quadratic and cubic."},
    {kFigure, "6.8", "Simulation A at levels 0 to 3 and adaptive, as in table 6.2."},
    {kFigure, "6.9", "Simulation B at levels 0 to 3 and adaptive, as in table 6.3."},
    {kFigure, "6.10",
     "A character in a dress at levels 0 to 3 and adaptive with and without back-face coarsening, as in table "
     "6.4."},
};

}  // namespace

std::span<const Caption> thesis_captions() {
    return kCaptions;
}

std::string short_name(const Caption& caption) {
    const char letter = caption.kind == kTable ? 'T' : (caption.kind == kFigure ? 'F' : 'L');
    return letter + std::string(caption.number);
}

std::vector<std::string> missing_columns(const Caption& caption, const Table& table) {
    std::vector<std::string> missing;
    for (const WantedColumn& wanted : caption.columns) {
        const std::string suffix = wanted.unit.empty() ? "" : ", " + std::string(wanted.unit);
        const auto serves = [&](const std::string& column) {
            if (wanted.is_whole_name) return column == wanted.quantity;
            return column.find(wanted.quantity) != std::string::npos && column.ends_with(suffix);
        };
        if (std::none_of(table.columns.begin(), table.columns.end(), serves))
            missing.push_back(std::string(wanted.quantity) + suffix);
    }
    return missing;
}

bool is_of(const Caption& caption, std::string_view name) {
    if (caption.kind == kListing) {
        constexpr std::string_view kPrefix = "listing-";
        if (!name.starts_with(kPrefix)) return false;
        name.remove_prefix(kPrefix.size());
    }
    return name == caption.number || (name.starts_with(caption.number) && name[caption.number.size()] == '-');
}

}  // namespace selvedge::bench
