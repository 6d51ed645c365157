#include "sim/mesh/triangulate.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "sim/core/assert.h"
#include "sim/core/error.h"
#include "sim/mesh/delaunay.h"
#include "sim/mesh/interior_points.h"
#include "sim/mesh/planar.h"
#include "sim/mesh/relax.h"
#include "sim/mesh/sample_outline.h"

namespace selvedge {
namespace {

constexpr std::array<GridPose, 6> kPoses{
    {{0, 0, false}, {0.5, 0.5, false}, {0.25, 0.75, false}, {0, 0, true}, {0.5, 0.5, true}, {0.25, 0.75, true}}};

[[noreturn]] void refuse(const Panel& panel, const std::string& problem) {
    throw InputError("", "panel '" + panel.name + "'", problem);
}

// The outline edge that a sample's segment belongs to.
int edge_of(const SampledOutline& outline, int sample) {
    int edge = 0;
    for (std::size_t i = 0; i < outline.runs.size(); ++i) {
        if (outline.runs[i].first <= sample) edge = static_cast<int>(i);
    }
    return edge;
}

void require_chain(const Panel& panel) {
    const auto vertex_count = static_cast<int>(panel.vertices.size());
    if (panel.edges.empty()) refuse(panel, "the outline has no edges");
    for (std::size_t i = 0; i < panel.edges.size(); ++i) {
        const OutlineEdge& edge = panel.edges[i];
        if (edge.start < 0 || edge.start >= vertex_count || edge.end < 0 || edge.end >= vertex_count) {
            refuse(panel, "edge " + std::to_string(i) + " has no such end vertex");
        }
        if (edge.end != panel.edges[(i + 1) % panel.edges.size()].start) {
            refuse(panel, "the outline is open after edge " + std::to_string(i));
        }
    }
}

void require_simple(const Panel& panel, const SampledOutline& outline) {
    for (const Vec2d& p : outline.points) {
        if (!p.allFinite()) refuse(panel, "the outline has a coordinate that is no finite number");
    }
    if (outline.points.size() < 3) refuse(panel, "the outline has fewer than three corners");
    if (const auto crossing = find_crossing(outline.points)) {
        const std::string first = std::to_string(edge_of(outline, crossing->first));
        if (crossing->first == crossing->second) refuse(panel, "edge " + first + " has no length");
        refuse(panel, "the outline crosses itself: edges " + first + " and " +
                          std::to_string(edge_of(outline, crossing->second)));
    }
}

double signed_area(const std::vector<Vec2d>& outline) {
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) twice += cross2(outline[i], outline[(i + 1) % outline.size()]);
    return twice / 2;
}

void require_affordable(const Panel& panel, const std::vector<Vec2d>& outline, const TriangulateOptions& options) {
    const double triangle = std::numbers::sqrt3 / 4 * options.target_edge * options.target_edge;
    const double needed = std::abs(signed_area(outline)) / triangle + static_cast<double>(outline.size());
    if (needed > options.max_triangles) {
        refuse(panel, "about " + std::to_string(std::llround(needed)) + " triangles would be needed, more than " +
                          std::to_string(options.max_triangles) + ": are the units right?");
    }
}

std::optional<PlanarMesh> start_mesh(const std::vector<Vec2d>& outline, const std::vector<Vec2d>& interior) {
    auto triangles = delaunay_inside(outline, interior);
    if (!triangles) return std::nullopt;
    PlanarMesh mesh{outline, outline.size(), std::move(*triangles)};
    mesh.points.insert(mesh.points.end(), interior.begin(), interior.end());
    return mesh;
}

// The best of several grids.
PlanarMesh best_mesh(const Panel& panel, const std::vector<Vec2d>& outline, const TriangulateOptions& options) {
    const SizeField size(outline, options.target_edge);
    std::optional<PlanarMesh> best;
    for (const GridPose& pose : kPoses) {
        auto mesh = start_mesh(outline, place_interior_points(outline, size, options.target_edge, pose));
        if (!mesh) continue;
        relax(*mesh, size, options.relaxations);
        if (!best || angle_penalty(*mesh) < angle_penalty(*best)) best = std::move(mesh);
    }
    if (!best) refuse(panel, "the outline runs clockwise, or it crosses or pinches itself in a point");
    if (options.relaxations > 0) heal(*best, size);
    return std::move(*best);
}

// Every piece of the outline must be the edge of exactly one triangle, or a seam's samples would no longer pair up.
void check_outline_kept(const PlanarMesh& mesh) {
    std::vector<int> uses(mesh.outline_count, 0);
    const auto count = static_cast<int>(mesh.outline_count);
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = triangle[k];
            if (from < count && triangle[(k + 1) % 3] == (from + 1) % count) ++uses[static_cast<std::size_t>(from)];
        }
    }
    for (int use : uses) SELVEDGE_ASSERT(use == 1);
}

}  // namespace

PanelMesh triangulate(const Panel& panel, const std::vector<int>& segments, const TriangulateOptions& options) {
    require_chain(panel);
    SampledOutline outline = sample_outline(panel, segments);
    weld(outline.points);
    require_simple(panel, outline);
    require_affordable(panel, outline.points, options);
    PlanarMesh mesh = best_mesh(panel, outline.points, options);
    check_outline_kept(mesh);

    PanelMesh result{std::move(mesh.points), std::move(mesh.triangles), {}, std::move(outline.runs)};
    for (std::size_t i = 0; i < mesh.outline_count; ++i) result.outline.push_back(static_cast<int>(i));
    return result;
}

}  // namespace selvedge
