#include "sim/mannequin/subdivide.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

constexpr int kNoEdge = -1;

struct EdgeTable {
    std::vector<std::array<int, 2>> ends;  // lower vertex first
    std::vector<Quad> of_quad;             // edge k joins the quad's vertices k and k + 1
};

// Numbers the edges in the order of the quads. Edges with the same lower vertex form a linked list, which is short.
EdgeTable number_edges(const std::vector<Quad>& quads, int vertex_count) {
    EdgeTable table;
    std::vector<int> first(static_cast<std::size_t>(vertex_count), kNoEdge);
    std::vector<int> next;
    for (const Quad& quad : quads) {
        Quad edges{};
        for (std::size_t k = 0; k < 4; ++k) {
            const auto [low, high] = std::minmax(quad[k], quad[(k + 1) % 4]);
            int& head = first[static_cast<std::size_t>(low)];
            int edge = head;
            while (edge != kNoEdge && table.ends[static_cast<std::size_t>(edge)][1] != high) {
                edge = next[static_cast<std::size_t>(edge)];
            }
            if (edge == kNoEdge) {
                edge = static_cast<int>(table.ends.size());
                table.ends.push_back({low, high});
                next.push_back(std::exchange(head, edge));
            }
            edges[k] = edge;
        }
        table.of_quad.push_back(edges);
    }
    return table;
}

std::vector<int> valences(const EdgeTable& edges, Eigen::Index vertex_count) {
    std::vector<int> valence(static_cast<std::size_t>(vertex_count), 0);
    for (const auto& ends : edges.ends) {
        for (const int v : ends) ++valence[static_cast<std::size_t>(v)];
    }
    return valence;
}

VertexRows quad_centres(const QuadMesh& mesh) {
    VertexRows centres(static_cast<Eigen::Index>(mesh.quads.size()), mesh.values.cols());
    Eigen::Index row = 0;
    for (const Quad& q : mesh.quads) {
        centres.row(row++) =
            0.25 * (mesh.values.row(q[0]) + mesh.values.row(q[1]) + mesh.values.row(q[2]) + mesh.values.row(q[3]));
    }
    return centres;
}

VertexRows edge_midpoints(const QuadMesh& mesh, const EdgeTable& edges) {
    VertexRows midpoints(static_cast<Eigen::Index>(edges.ends.size()), mesh.values.cols());
    Eigen::Index row = 0;
    for (const auto& [a, b] : edges.ends) midpoints.row(row++) = 0.5 * (mesh.values.row(a) + mesh.values.row(b));
    return midpoints;
}

// The mean of the edge's midpoint and of the mean of its two quads' centres.
VertexRows edge_vertices(const VertexRows& midpoints, const VertexRows& centres, const EdgeTable& edges) {
    VertexRows rows = 0.5 * midpoints;
    for (std::size_t q = 0; q < edges.of_quad.size(); ++q) {
        for (const int edge : edges.of_quad[q]) rows.row(edge) += 0.25 * centres.row(static_cast<Eigen::Index>(q));
    }
    return rows;
}

// (mean of centres + 2 mean of midpoints + (n - 3) v) / n, for a vertex with n edges.
VertexRows moved_vertices(const QuadMesh& mesh, const VertexRows& midpoints, const VertexRows& centres,
                          const EdgeTable& edges) {
    VertexRows around = VertexRows::Zero(mesh.values.rows(), mesh.values.cols());
    for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
        for (const int v : mesh.quads[q]) around.row(v) += centres.row(static_cast<Eigen::Index>(q));
    }
    for (std::size_t e = 0; e < edges.ends.size(); ++e) {
        for (const int v : edges.ends[e]) around.row(v) += 2 * midpoints.row(static_cast<Eigen::Index>(e));
    }
    const std::vector<int> valence = valences(edges, mesh.values.rows());
    for (Eigen::Index v = 0; v < around.rows(); ++v) {
        const double n = valence[static_cast<std::size_t>(v)];
        around.row(v) = (around.row(v) / n + (n - 3) * mesh.values.row(v)) / n;
    }
    return around;
}

std::vector<Quad> quarter(const std::vector<Quad>& quads, const EdgeTable& edges, int first_edge, int first_quad) {
    std::vector<Quad> quarters;
    quarters.reserve(4 * quads.size());
    for (std::size_t q = 0; q < quads.size(); ++q) {
        for (std::size_t k = 0; k < 4; ++k) {
            quarters.push_back({quads[q][k], first_edge + edges.of_quad[q][k], first_quad + static_cast<int>(q),
                                first_edge + edges.of_quad[q][(k + 3) % 4]});
        }
    }
    return quarters;
}

double diagonal(const QuadMesh& mesh, int a, int b) {
    return (mesh.values.row(a) - mesh.values.row(b)).head<3>().squaredNorm();
}

}  // namespace

QuadMesh subdivide(const QuadMesh& mesh) {
    const EdgeTable edges = number_edges(mesh.quads, static_cast<int>(mesh.values.rows()));
    SELVEDGE_ASSERT(edges.ends.size() == 2 * mesh.quads.size());  // closed: 4 edges per quad, each shared by two quads
    const VertexRows centres = quad_centres(mesh);
    const VertexRows midpoints = edge_midpoints(mesh, edges);
    const Eigen::Index first_quad = mesh.values.rows() + midpoints.rows();

    QuadMesh fine;
    fine.values.resize(first_quad + centres.rows(), mesh.values.cols());
    fine.values << moved_vertices(mesh, midpoints, centres, edges), edge_vertices(midpoints, centres, edges), centres;
    fine.quads = quarter(mesh.quads, edges, static_cast<int>(mesh.values.rows()), static_cast<int>(first_quad));
    return fine;
}

// (n^2 v + 4 sum of neighbours + sum of the quads' opposite corners) / (n (n + 5)), for a vertex with n edges.
void move_to_limit(QuadMesh& mesh) {
    const EdgeTable edges = number_edges(mesh.quads, static_cast<int>(mesh.values.rows()));
    VertexRows around = VertexRows::Zero(mesh.values.rows(), mesh.values.cols());
    for (const auto& [a, b] : edges.ends) {
        around.row(a) += 4 * mesh.values.row(b);
        around.row(b) += 4 * mesh.values.row(a);
    }
    for (const Quad& quad : mesh.quads) {
        for (std::size_t k = 0; k < 4; ++k) around.row(quad[k]) += mesh.values.row(quad[(k + 2) % 4]);
    }
    const std::vector<int> valence = valences(edges, mesh.values.rows());
    for (Eigen::Index v = 0; v < around.rows(); ++v) {
        const double n = valence[static_cast<std::size_t>(v)];
        mesh.values.row(v) = (n * n * mesh.values.row(v) + around.row(v)) / (n * (n + 5));
    }
}

std::vector<std::array<int, 3>> split_quads(const QuadMesh& mesh) {
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(2 * mesh.quads.size());
    for (const auto& [a, b, c, d] : mesh.quads) {
        if (diagonal(mesh, a, c) <= diagonal(mesh, b, d)) {
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        } else {
            triangles.push_back({a, b, d});
            triangles.push_back({b, c, d});
        }
    }
    return triangles;
}

std::vector<std::array<int, 2>> quad_edges(const std::vector<Quad>& quads, int vertex_count) {
    return number_edges(quads, vertex_count).ends;
}

}  // namespace selvedge::sim
