#include "sim/mesh/sew.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/disjoint_sets.h"
#include "sim/core/edge_table.h"
#include "sim/core/error.h"
#include "sim/mesh/sample_outline.h"
#include "sim/mesh/triangulate.h"
#include "sim/pattern/field_moves.h"

namespace selvedge::sim {

// A panel's mesh and what it was made from.
struct CachedPanelMesh {
    std::vector<Vec2d> vertices;
    std::vector<OutlineEdge> edges;
    std::vector<int> segments;
    MeshOptions options;
    PanelMesh mesh;
};

struct CachedPanelMeshes {
    std::vector<CachedPanelMesh> panels;
};

namespace {

// The mesh of each panel and the index of its first vertex in the garment mesh.
struct PlacedPanels {
    std::vector<PanelMesh> meshes;
    std::vector<int> first_vertex;
};

PanelMesh triangulate_or_reuse(const Panel& panel, const std::vector<int>& segments, const MeshOptions& options,
                               const PanelMeshCache& cache) {
    const auto is_same = [&](const CachedPanelMesh& one) {
        return one.segments == segments && one.options == options && one.vertices == panel.vertices &&
               have_same_shapes(one.edges, panel.edges);
    };
    if (cache.meshes) {
        const auto found = std::ranges::find_if(cache.meshes->panels, is_same);
        if (found != cache.meshes->panels.end()) return found->mesh;
    }
    return triangulate(panel, segments,
                       {.target_edge = options.target_edge,
                        .relaxations = options.relaxations,
                        .max_triangles = options.max_triangles});
}

PlacedPanels triangulate_panels(const Pattern& pattern, const MeshOptions& options, PanelMeshCache& cache) {
    const std::vector<std::vector<int>> segments = count_segments(pattern, options);
    const auto fresh = std::make_shared<CachedPanelMeshes>();
    PlacedPanels placed;
    int vertices = 0;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const Panel& panel = pattern.panels[p];
        placed.meshes.emplace_back();
        placed.first_vertex.push_back(vertices);
        if (!panel.is_worn) continue;
        placed.meshes.back() = triangulate_or_reuse(panel, segments[p], options, cache);
        fresh->panels.push_back({panel.vertices, panel.edges, segments[p], options, placed.meshes.back()});
        vertices += static_cast<int>(placed.meshes.back().u.size());
    }
    cache.meshes = fresh;
    return placed;
}

// The lines of the samples of a panel's outline: of the segment from each vertex of the mesh to the next one of the
// outline; none for those inside.
struct OutlineLines {
    std::vector<int> next;        // vertex, by vertex; -1: inside
    std::vector<SideLine> lines;  // by vertex

    OutlineLines(const Panel& panel, const PanelMesh& mesh) : next(mesh.u.size(), -1), lines(mesh.u.size()) {
        const std::size_t count = mesh.outline.size();
        for (std::size_t e = 0; e < mesh.runs.size(); ++e) {
            const std::optional<Elastic>& elastic = panel.edges[e].elastic;
            const float drawn_to = elastic ? static_cast<float>(elastic->share) : 1.0F;
            for (int i = 0; i < mesh.runs[e].segments; ++i) {
                const auto at = static_cast<std::size_t>(mesh.runs[e].first + i) % count;
                const auto vertex = static_cast<std::size_t>(mesh.outline[at]);
                next[vertex] = mesh.outline[(at + 1) % count];
                lines[vertex] = {.edge = static_cast<int>(e), .drawn_to = drawn_to};
            }
        }
    }
    SideLine from(int a, int b) const {
        const auto start = static_cast<std::size_t>(a);
        return next[start] == b ? lines[start] : SideLine();
    }
};

void add_panel(GarmentMesh& garment, const Panel& panel, const PanelMesh& mesh) {
    const auto first = static_cast<int>(garment.x.size());
    const auto index = static_cast<int>(garment.panel_names.size());
    const OutlineLines outline(panel, mesh);
    for (const Vec2d& u : mesh.u) garment.x.push_back(panel.place(u));
    for (const auto& corners : mesh.triangles) {
        GarmentTriangle triangle;
        triangle.panel = index;
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.vertices[k] = first + corners[k];
            triangle.u[k] = mesh.u[static_cast<std::size_t>(corners[k])];
            triangle.lines[k] = outline.from(corners[k], corners[(k + 1) % 3]);
        }
        garment.triangles.push_back(triangle);
    }
    for (std::size_t e = 0; panel.is_worn && e < panel.edges.size(); ++e) {
        if (std::ranges::find(panel.pins, panel.edges[e].start) == panel.pins.end()) continue;
        garment.pins.push_back(first + mesh.outline[static_cast<std::size_t>(mesh.runs[e].first)]);
    }
    garment.panel_names.push_back(panel.name);
    garment.panel_grain_angles.push_back(panel.grain_angle);
    garment.panel_sett_offsets.push_back(panel.sett_offset);
    garment.panel_layers.push_back(panel.layer);
}

// The garment mesh vertex at sample i of an outline edge, 0 <= i <= number of segments of the edge.
int sample_vertex(const PlacedPanels& placed, const SeamSide& side, int i) {
    const auto panel = static_cast<std::size_t>(side.panel);
    const PanelMesh& mesh = placed.meshes[panel];
    const auto at = static_cast<std::size_t>(mesh.runs[static_cast<std::size_t>(side.edge)].first + i);
    return placed.first_vertex[panel] + mesh.outline[at % mesh.outline.size()];
}

int segments_of(const PlacedPanels& placed, const SeamSide& side) {
    return placed.meshes[static_cast<std::size_t>(side.panel)].runs[static_cast<std::size_t>(side.edge)].segments;
}

// Links the samples of a seam's two sides. A dart's tip is the same vertex on both sides and needs no link.
void link_seam(GarmentMesh& garment, const PlacedPanels& placed, const Seam& seam, int index) {
    const int segments = segments_of(placed, seam.first);
    SELVEDGE_ASSERT(segments == segments_of(placed, seam.second));
    for (int i = 0; i <= segments; ++i) {
        const int a = sample_vertex(placed, seam.first, i);
        const int b = sample_vertex(placed, seam.second, seam.is_reversed ? segments - i : i);
        if (a != b) garment.links.push_back({a, b, index});
    }
}

}  // namespace

GarmentMesh assemble(const Pattern& pattern, const MeshOptions& options) {
    PanelMeshCache none;
    return assemble(pattern, options, none);
}

GarmentMesh assemble(const Pattern& pattern, const MeshOptions& options, PanelMeshCache& cache) {
    const PlacedPanels placed = triangulate_panels(pattern, options, cache);
    GarmentMesh garment;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) add_panel(garment, pattern.panels[p], placed.meshes[p]);
    if (garment.triangles.empty() && !pattern.panels.empty()) throw InputError("", "panels", "none of them is worn");
    for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
        const Seam& seam = pattern.seams[s];
        if (!panel_of(pattern, seam.first).is_worn || !panel_of(pattern, seam.second).is_worn) continue;
        link_seam(garment, placed, seam, static_cast<int>(s));
    }
    separate_coinciding_edges(garment);
    return garment;
}

std::vector<int> representatives_of_links(std::size_t vertices, std::span<const SeamLink> links) {
    DisjointSets sets(vertices);
    for (const SeamLink& link : links) sets.join(link.a, link.b);
    std::vector<int> leads(vertices);
    for (std::size_t i = 0; i < leads.size(); ++i) leads[i] = sets.find(static_cast<int>(i));
    return leads;
}

std::vector<int> merge_seams(GarmentMesh& mesh) {
    const std::vector<int> representatives = representatives_of_links(mesh.x.size(), mesh.links);
    std::vector<int> sewn_vertex(mesh.x.size());
    std::vector<int> members;  // per vertex of the sewn mesh; its index is never larger than theirs
    for (std::size_t i = 0; i < mesh.x.size(); ++i) {
        const auto first =
            static_cast<std::size_t>(representatives[i]);  // <= i: the representative is the lowest of its group
        const Vec3d x = mesh.x[i];
        if (first == i) {
            sewn_vertex[i] = static_cast<int>(members.size());
            mesh.x[members.size()].setZero();
            members.push_back(0);
        }
        sewn_vertex[i] = sewn_vertex[first];
        const auto merged = static_cast<std::size_t>(sewn_vertex[i]);
        mesh.x[merged] += x;
        ++members[merged];
    }
    mesh.x.resize(members.size());
    for (std::size_t i = 0; i < members.size(); ++i) mesh.x[i] /= members[i];

    const auto rename = [&](int& vertex) { vertex = sewn_vertex[static_cast<std::size_t>(vertex)]; };
    for (GarmentTriangle& triangle : mesh.triangles) std::ranges::for_each(triangle.vertices, rename);
    std::vector<int> pins;
    for (int pin : mesh.pins) {
        rename(pin);
        if (std::ranges::find(pins, pin) == pins.end()) pins.push_back(pin);
    }
    mesh.pins = std::move(pins);
    mesh.links.clear();
    return sewn_vertex;
}

namespace {

constexpr int kMaxIterations = 8;  // 2 are enough for any mesh whose outline edges do not coincide

using EdgeEnds = std::pair<int, int>;  // lower vertex first

EdgeEnds ends(int a, int b) {
    return std::minmax({a, b});
}

EdgeEnds edge_of(const GarmentTriangle& triangle, std::size_t k) {
    return ends(triangle.vertices[k], triangle.vertices[(k + 1) % 3]);
}

// The interior edges that would coincide with another edge after sewing, or whose ends would be merged.
std::vector<EdgeEnds> find_coinciding(const GarmentMesh& unsewn) {
    const std::vector<int> representatives = representatives_of_links(unsewn.x.size(), unsewn.links);
    const auto representative_of = [&](int vertex) { return representatives[static_cast<std::size_t>(vertex)]; };
    const EdgeTable<int> table(unsewn.triangles, &GarmentTriangle::vertices);
    const auto sewn_edge = [&](EdgeTable<int>::Edge edge) {
        return ends(representative_of(edge[0].low), representative_of(edge[0].high));
    };
    std::map<EdgeEnds, int> sewn;  // number of unsewn edges that become this edge
    for (const auto edge : table.edges()) ++sewn[sewn_edge(edge)];
    std::vector<EdgeEnds> coinciding;
    for (const auto edge : table.edges()) {
        if (edge.size() < 2) continue;
        const EdgeEnds merged = sewn_edge(edge);
        if (merged.first == merged.second || sewn[merged] > 1) coinciding.emplace_back(edge[0].low, edge[0].high);
    }
    return coinciding;
}

struct CornerPoint {
    int vertex = 0;
    Vec2d u = Vec2d::Zero();
    int corner = -1;  // of the triangle that is split; -1: in the middle of a side
};

using Middles = std::map<EdgeEnds, int>;

// A triangle's corners, and the midpoints of its split edges.
struct SplitTriangle {
    std::array<CornerPoint, 3> corner;
    std::array<CornerPoint, 3> middle;  // middle[k]: of the edge from corner k to the next; vertex -1: not split
    int panel = 0;
    std::array<SideLine, 3> lines;  // of its sides, which are split only where they have none
};

SplitTriangle with_middles(const GarmentTriangle& triangle, const Middles& middles) {
    SplitTriangle split;
    split.panel = triangle.panel;
    split.lines = triangle.lines;
    for (std::size_t k = 0; k < 3; ++k) {
        split.corner[k] = {triangle.vertices[k], triangle.u[k], static_cast<int>(k)};
        const auto found = middles.find(edge_of(triangle, k));
        const int vertex = found == middles.end() ? -1 : found->second;
        split.middle[k] = {vertex, 0.5 * (triangle.u[k] + triangle.u[(k + 1) % 3])};
    }
    return split;
}

void add_triangle(std::vector<GarmentTriangle>& out, const SplitTriangle& of, const CornerPoint& a,
                  const CornerPoint& b, const CornerPoint& c) {
    const auto line = [&](const CornerPoint& from, const CornerPoint& to) {
        const bool is_whole_side = from.corner >= 0 && to.corner == (from.corner + 1) % 3;
        return is_whole_side ? of.lines[static_cast<std::size_t>(from.corner)] : SideLine();
    };
    out.push_back({{a.vertex, b.vertex, c.vertex}, {a.u, b.u, c.u}, of.panel, {line(a, b), line(b, c), line(c, a)}});
}

// Triangulates a triangle so that it conforms to its split edges. The cases are the configurations of thesis 3.3.5: one
// split edge C1..C3, two C4..C9 (the shorter diagonal), three C10.
void add_parts(std::vector<GarmentTriangle>& out, SplitTriangle t) {
    const auto is_split = [](const CornerPoint& middle) { return middle.vertex >= 0; };
    const auto count = std::ranges::count_if(t.middle, is_split);
    const auto turn = [&] {
        std::rotate(t.corner.begin(), t.corner.begin() + 1, t.corner.end());
        std::rotate(t.middle.begin(), t.middle.begin() + 1, t.middle.end());
    };
    if (count == 1) {
        while (!is_split(t.middle[0])) turn();
        add_triangle(out, t, t.corner[0], t.middle[0], t.corner[2]);
        add_triangle(out, t, t.middle[0], t.corner[1], t.corner[2]);
    } else if (count == 2) {
        while (is_split(t.middle[2])) turn();
        add_triangle(out, t, t.middle[0], t.corner[1], t.middle[1]);
        if ((t.middle[0].u - t.corner[2].u).norm() <= (t.corner[0].u - t.middle[1].u).norm()) {
            add_triangle(out, t, t.corner[0], t.middle[0], t.corner[2]);
            add_triangle(out, t, t.middle[0], t.middle[1], t.corner[2]);
        } else {
            add_triangle(out, t, t.corner[0], t.middle[0], t.middle[1]);
            add_triangle(out, t, t.corner[0], t.middle[1], t.corner[2]);
        }
    } else if (count == 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            add_triangle(out, t, t.corner[k], t.middle[k], t.middle[(k + 2) % 3]);
        }
        add_triangle(out, t, t.middle[0], t.middle[1], t.middle[2]);
    } else {
        add_triangle(out, t, t.corner[0], t.corner[1], t.corner[2]);
    }
}

void split_edges(GarmentMesh& mesh, const std::vector<EdgeEnds>& edges) {
    Middles middles;
    for (const EdgeEnds& edge : edges) {
        middles[edge] = static_cast<int>(mesh.x.size());
        const Vec3d middle =
            0.5 * (mesh.x[static_cast<std::size_t>(edge.first)] + mesh.x[static_cast<std::size_t>(edge.second)]);
        mesh.x.push_back(middle);
    }
    std::vector<GarmentTriangle> triangles;
    for (const GarmentTriangle& triangle : mesh.triangles) add_parts(triangles, with_middles(triangle, middles));
    mesh.triangles = std::move(triangles);
}

}  // namespace

int separate_coinciding_edges(GarmentMesh& unsewn) {
    int split = 0;
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
        const std::vector<EdgeEnds> edges = find_coinciding(unsewn);
        if (edges.empty()) break;
        split_edges(unsewn, edges);
        split += static_cast<int>(edges.size());
    }
    return split;
}

double seam_rest_length(double left_length, double right_length, const SeamLengthOptions& options) {
    const double shorter = std::min(left_length, right_length);
    const double longer = std::max(left_length, right_length);
    return longer - shorter <= options.ease * shorter ? 0.5 * (shorter + longer) : shorter;
}

}  // namespace selvedge::sim
