#include "sim/mannequin/cage.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "sim/body/pose.h"
#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

using Count = CageCounts;
using Ring = std::vector<int>;

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

constexpr int kNoVertex = -1;

class CageBuilder {
 public:
    int add_vertex(CagePart part, int row, int column, bool is_on_midplane = false) {
        cage_.left.push_back({part, row, column, is_on_midplane});
        return static_cast<int>(cage_.left.size()) - 1;
    }

    void add_quad(int a, int b, int c, int d) { cage_.quads.push_back({a, b, c, d}); }

    Cage finish_with_mirror_image() {
        cage_.vertex_count = static_cast<int>(cage_.left.size());
        for (const CageVertex& vertex : cage_.left) {
            const auto self = static_cast<int>(cage_.mirror.size());
            cage_.mirror.push_back(vertex.is_on_midplane ? self : cage_.vertex_count++);
        }
        const std::size_t left_quads = cage_.quads.size();
        for (std::size_t i = 0; i < left_quads; ++i) {
            const Quad q = cage_.quads[i];
            add_quad(twin(q[3]), twin(q[2]), twin(q[1]), twin(q[0]));
        }
        return std::move(cage_);
    }

 private:
    int twin(int vertex) const { return cage_.mirror[index(vertex)]; }

    Cage cage_;
};

Ring add_ring(CageBuilder& builder, CagePart part, int row, int size) {
    Ring ring;
    for (int i = 0; i < size; ++i) ring.push_back(builder.add_vertex(part, row, i));
    return ring;
}

// Joins two rings by a band of quads.
void join_rings(CageBuilder& builder, const Ring& from, const Ring& to) {
    SELVEDGE_ASSERT(from.size() == to.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
        const std::size_t next = (i + 1) % from.size();
        builder.add_quad(from[i], from[next], to[next], to[i]);
    }
}

enum class Winding { AsListed, TurnedOver };

// Closes a ring of 4 n points with a grid of n x n quads.
void add_cap(CageBuilder& builder, const Ring& ring, CagePart part, Winding winding) {
    const std::size_t n = ring.size() / 4;
    std::vector<Ring> grid(n + 1, Ring(n + 1, kNoVertex));
    for (std::size_t i = 0; i < n; ++i) {
        grid[0][i] = ring[i];
        grid[i][n] = ring[n + i];
        grid[n][n - i] = ring[2 * n + i];
        grid[n - i][0] = ring[3 * n + i];
    }
    for (std::size_t a = 1; a < n; ++a) {
        for (std::size_t b = 1; b < n; ++b) {
            grid[a][b] = builder.add_vertex(part, static_cast<int>(a), static_cast<int>(b));
        }
    }
    for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = 0; b < n; ++b) {
            const std::size_t from = winding == Winding::AsListed ? a : a + 1;
            const std::size_t to = winding == Winding::AsListed ? a + 1 : a;
            builder.add_quad(grid[from][b], grid[from][b + 1], grid[to][b + 1], grid[to][b]);
        }
    }
}

bool is_inside_armhole(int row, int column) {
    return Count::kArmholeRow < row && row < Count::kShoulderTop && Count::kArmholeFirst < column &&
           column < Count::kArmholeLast;
}

bool is_armhole_quad(int row, int column) {
    return Count::kArmholeRow <= row && row < Count::kShoulderTop && Count::kArmholeFirst <= column &&
           column < Count::kArmholeLast;
}

std::vector<Ring> add_torso(CageBuilder& builder) {
    constexpr int kLast = Count::kTorsoColumns - 1;
    std::vector<Ring> rows;
    for (int r = 0; r < Count::kTorsoRows; ++r) {
        Ring row;
        for (int c = 0; c <= kLast; ++c) {
            row.push_back(is_inside_armhole(r, c) ? kNoVertex
                                                  : builder.add_vertex(CagePart::Torso, r, c, c == 0 || c == kLast));
        }
        rows.push_back(row);
    }
    for (int r = 0; r + 1 < Count::kTorsoRows; ++r) {
        for (int c = 0; c < kLast; ++c) {
            if (is_armhole_quad(r, c)) continue;
            const Ring& low = rows[index(r)];
            const Ring& high = rows[index(r + 1)];
            builder.add_quad(low[index(c)], low[index(c + 1)], high[index(c + 1)], high[index(c)]);
        }
    }
    return rows;
}

// Half of the cap on the top torso row: 6 x 3 quads; side b = 0 is in the midplane.
void add_crown(CageBuilder& builder, const Ring& top) {
    constexpr std::size_t kRows = 6;
    constexpr std::size_t kColumns = 3;
    std::array<std::array<int, kColumns + 1>, kRows + 1> grid{};
    for (std::size_t a = 0; a <= kRows; ++a) {
        for (std::size_t b = 0; b <= kColumns; ++b) {
            if (a == 0) {
                grid[a][b] = top[b];
            } else if (a == kRows) {
                grid[a][b] = top[top.size() - 1 - b];
            } else if (b == kColumns) {
                grid[a][b] = top[kColumns + a];
            } else {
                grid[a][b] = builder.add_vertex(CagePart::Crown, static_cast<int>(a), static_cast<int>(b), b == 0);
            }
        }
    }
    for (std::size_t a = 0; a < kRows; ++a) {
        for (std::size_t b = 0; b < kColumns; ++b) {
            builder.add_quad(grid[a][b], grid[a][b + 1], grid[a + 1][b + 1], grid[a + 1][b]);
        }
    }
}

// The leg's first ring is the torso's bottom row, closed by the bridge from back to front. Leg rings have the opposite
// direction to arm rings, so the leg's bands and cap are flipped.
void add_leg(CageBuilder& builder, const Ring& torso_bottom) {
    Ring ring = torso_bottom;
    std::array<int, Count::kBridge> bridge{};
    for (int k = 0; k < Count::kBridge; ++k) bridge[index(k)] = builder.add_vertex(CagePart::Bridge, 0, k, true);
    ring.insert(ring.end(), bridge.rbegin(), bridge.rend());
    for (int row = 1; row <= Count::kLegRows; ++row) {
        const Ring next = add_ring(builder, CagePart::Leg, row, Count::kLegRing);
        join_rings(builder, next, ring);
        ring = next;
    }
    add_cap(builder, ring, CagePart::ToeCap, Winding::TurnedOver);
}

// The 12 points of the armhole: along its bottom, up the back, along the top, down the front.
Ring armhole_ring(const std::vector<Ring>& torso) {
    constexpr int kBottom = Count::kArmholeRow;
    constexpr int kTop = Count::kShoulderTop;
    Ring ring;
    for (int c = Count::kArmholeFirst; c < Count::kArmholeLast; ++c) ring.push_back(torso[kBottom][index(c)]);
    for (int r = kBottom; r < kTop; ++r) ring.push_back(torso[index(r)][Count::kArmholeLast]);
    for (int c = Count::kArmholeLast; c > Count::kArmholeFirst; --c) ring.push_back(torso[kTop][index(c)]);
    for (int r = kTop; r > kBottom; --r) ring.push_back(torso[index(r)][Count::kArmholeFirst]);
    return ring;
}

bool is_thumb_quad(int row, int column) {
    return (row == Count::kThumbRow || row == Count::kThumbRow + 1) &&
           (column == Count::kThumbColumn - 1 || column == Count::kThumbColumn);
}

std::vector<Ring> add_arm(CageBuilder& builder, const Ring& armhole) {
    std::vector<Ring> rows{armhole};
    for (int row = 1; row <= Count::kArmRows; ++row) {
        Ring ring;
        for (int i = 0; i < Count::kArmRing; ++i) {
            const bool is_under_thumb = row == Count::kThumbRow + 1 && i == Count::kThumbColumn;
            ring.push_back(is_under_thumb ? kNoVertex : builder.add_vertex(CagePart::Arm, row, i));
        }
        rows.push_back(ring);
    }
    for (int row = 0; row < Count::kArmRows; ++row) {
        const Ring& near = rows[index(row)];
        const Ring& far = rows[index(row + 1)];
        for (int i = 0; i < Count::kArmRing; ++i) {
            if (is_thumb_quad(row, i)) continue;
            const std::size_t next = index((i + 1) % Count::kArmRing);
            builder.add_quad(near[index(i)], near[next], far[next], far[index(i)]);
        }
    }
    add_cap(builder, rows.back(), CagePart::HandCap, Winding::AsListed);
    return rows;
}

void add_thumb(CageBuilder& builder, const std::vector<Ring>& arm) {
    constexpr std::size_t kBefore = Count::kThumbColumn - 1;
    constexpr std::size_t kAt = Count::kThumbColumn;
    constexpr std::size_t kAfter = (Count::kThumbColumn + 1) % Count::kArmRing;
    const Ring& near = arm[Count::kThumbRow];
    const Ring& middle = arm[Count::kThumbRow + 1];
    const Ring& far = arm[Count::kThumbRow + 2];
    Ring ring{near[kBefore], near[kAt], near[kAfter], middle[kAfter],
              far[kAfter],   far[kAt],  far[kBefore], middle[kBefore]};
    for (int row = 1; row <= Count::kThumbRows; ++row) {
        const Ring next = add_ring(builder, CagePart::Thumb, row, Count::kThumbRing);
        join_rings(builder, ring, next);
        ring = next;
    }
    add_cap(builder, ring, CagePart::ThumbCap, Winding::AsListed);
}

}  // namespace

Cage make_cage() {
    CageBuilder builder;
    const std::vector<Ring> torso = add_torso(builder);
    add_crown(builder, torso.back());
    add_leg(builder, torso.front());
    const std::vector<Ring> arm = add_arm(builder, armhole_ring(torso));
    add_thumb(builder, arm);
    return builder.finish_with_mirror_image();
}

Vec3d mirrored(const Vec3d& x) {
    return {-x.x(), x.y(), x.z()};
}

void mirror_left_side(Joints& joints) {
    for (std::size_t i = kMiddleJoints; i < kMiddleJoints + kSideJoints; ++i) {
        const auto left = static_cast<Joint>(i);
        joints[mirrored(left)] = mirrored(joints[left]);
    }
}

std::vector<Bone> make_bones(const Joints& joints) {
    std::vector<Bone> bones;
    for (std::size_t i = 0; i < kJointCount; ++i) {
        const auto joint = static_cast<Joint>(i);
        const std::optional<Joint> parent = joint_parent(joint);
        bones.push_back({.name = std::string(joint_name(joint)),
                         .parent = parent ? static_cast<int>(*parent) : -1,
                         .joint = joints.x[i]});
    }
    set_rest_from_joints(bones);
    return bones;
}

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
