#include "sim/cloth/elements.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/cloth/cloth.h"

namespace selvedge {
namespace {

// How much longer than at rest a line at 45 degrees to the threads may grow: shear of some 33 degrees, where woven
// cloth locks.
constexpr float kBiasExtension = 0.25F;

Vec2f warp_direction(float grain_angle) {
    return {-std::sin(grain_angle), std::cos(grain_angle)};
}
Vec2f weft_direction(float grain_angle) {
    return {std::cos(grain_angle), std::sin(grain_angle)};
}

// Moves per unit of strain along one thread direction with gradients g on the three vertices.
std::array<float, 3> thread_moves(const std::array<float, 2>& g, const std::array<float, 3>& w, float compliance) {
    const std::array<float, 3> gradient{-(g[0] + g[1]), g[0], g[1]};
    float sum = compliance;
    for (std::size_t i = 0; i < 3; ++i) sum += w[i] * gradient[i] * gradient[i];
    std::array<float, 3> moves{};
    for (std::size_t i = 0; i < 3; ++i) moves[i] = w[i] * gradient[i] / sum;
    return moves;
}

float shear_gain(const MaterialFrame& frame, const std::array<float, 3>& w, float compliance) {
    const auto squared = [](float p, float q) { return p * p + q * q; };
    return 1 / (compliance + w[0] * squared(frame.a[0] + frame.a[1], frame.b[0] + frame.b[1]) +
                w[1] * squared(frame.a[0], frame.b[0]) + w[2] * squared(frame.a[1], frame.b[1]));
}

// Over a sub-step, of a triangle of that stiffness.  (XPBD)
float compliance_of(const Cloth& cloth, const MaterialFrame& frame, double stiffness) {
    return 1 / (frame.area * cloth.substep * cloth.substep) / static_cast<float>(stiffness);
}

// One pass of Gauss-Seidel leaves threads longer than their stiffness would. What they may be stretched before that is
// taken back is the strain under the load which garments seldom carry more of; never nil, or rounding errors would
// gather into a drift.
float slack_length(double stiffness, const Fabric& fabric) {
    constexpr double kUsualLoad = 2.5;  // N/m: a shirt hangs from its shoulders with some 1.6
    return 1 + static_cast<float>(std::min(fabric.strain_limit, std::max(1e-5, kUsualLoad / stiffness)));
}

// Warp and weft of a triangle, a leaf or a parent, whose vertices have the inverse masses w. Without shear.
StretchElement thread_element(const Cloth& cloth, std::uint16_t panel, const std::array<VertexId, 3>& vertices,
                              const MaterialFrame& frame, const std::array<float, 3>& w) {
    const Fabric& fabric = cloth.fabrics[panel];
    StretchElement element{.a = frame.a, .b = frame.b};
    for (std::size_t i = 0; i < 3; ++i) element.vertices[i] = vertices[i].value;
    element.warp = thread_moves(frame.a, w, compliance_of(cloth, frame, fabric.stretch_warp));
    element.weft = thread_moves(frame.b, w, compliance_of(cloth, frame, fabric.stretch_weft));
    element.slack_warp = slack_length(fabric.stretch_warp, fabric);
    element.slack_weft = slack_length(fabric.stretch_weft, fabric);
    element.longest = 1 + static_cast<float>(fabric.strain_limit);
    return element;
}

// Whether a seam edge of the triangle has to be shorter than the triangle's own copy of it: there the cloth is
// gathered, in puckers finer than the mesh.  (SPEC 3.2)
bool is_gathered(const AdaptiveMesh& mesh, const LeafTriangle& leaf) {
    constexpr float kEase = 0.95F;
    const AdaptiveTriangle& triangle = mesh.triangle(leaf.triangle);
    for (std::size_t k = 0; k < 3; ++k) {
        const float own = (triangle.u[(k + 1) % 3] - triangle.u[k]).norm();
        if (mesh.rest_length(triangle.edges[k]) < kEase * own) return true;
    }
    return false;
}

StretchElement stretch_element(const Cloth& cloth, const LeafTriangle& triangle) {
    const MaterialFrame frame = material_frame(triangle.u, cloth.grain_angles[triangle.panel]);
    std::array<float, 3> w{};
    for (std::size_t i = 0; i < 3; ++i) w[i] = cloth.inverse_mass[triangle.v[i].value];
    StretchElement element = thread_element(cloth, triangle.panel, triangle.v, frame, w);
    element.push = is_gathered(cloth.mesh, triangle) ? 0.0F : 1.0F;
    element.shear = shear_gain(frame, w, compliance_of(cloth, frame, cloth.fabrics[triangle.panel].shear));
    return element;
}

// Rigidity against folding about an edge: the cloth bends across it.
float hinge_rigidity(const Fabric& fabric, const Vec2f& edge, float grain_angle) {
    const Vec2f along = edge.normalized();
    const float across_warp = weft_direction(grain_angle).dot(along);  // edge along the weft: the warp bends
    const float share = across_warp * across_warp;
    return static_cast<float>(fabric.bending_warp) * share + static_cast<float>(fabric.bending_weft) * (1 - share);
}

// How much longer than at rest a material line may grow: the fabric's strain limit along the threads, up to the locking
// shear on the bias.
float allowed_extension(const Cloth& cloth, const Vec2f& direction, std::uint16_t panel) {
    const float c = warp_direction(cloth.grain_angles[panel]).dot(direction.normalized());
    const float c_squared = std::min(1.0F, c * c);
    return static_cast<float>(cloth.fabrics[panel].strain_limit) + kBiasExtension * 4 * c_squared * (1 - c_squared);
}

// The limit of an edge on the side that allows less.
float length_limit(const Cloth& cloth, const AdaptiveEdge& edge, EdgeId id) {
    float extension = std::numeric_limits<float>::max();
    for (const TriangleId side : edge.sides) {
        if (!side) continue;
        const AdaptiveTriangle& t = cloth.mesh.triangle(side);
        const std::size_t k = place_of(t, id);
        extension = std::min(extension, allowed_extension(cloth, t.u[(k + 1) % 3] - t.u[k], t.panel));
    }
    return edge.rest_length * (1 + extension);
}

LengthLimit leaf_limit(const Cloth& cloth, const LeafEdge& leaf) {
    const float wa = cloth.inverse_mass[leaf.a.value];
    const float wb = cloth.inverse_mass[leaf.b.value];
    const float sum = std::max(wa + wb, std::numeric_limits<float>::min());
    return {.a = leaf.a.value,
            .b = leaf.b.value,
            .limit = length_limit(cloth, cloth.mesh.edge(leaf.edge), leaf.edge),
            .share_a = wa / sum,
            .share_b = wb / sum};
}

StretchElement parent_element(const Cloth& cloth, const AdaptiveTriangle& triangle, const std::vector<float>& mass) {
    const MaterialFrame frame = material_frame(triangle.u, cloth.grain_angles[triangle.panel]);
    std::array<float, 3> w{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = triangle.vertices[i].value;
        w[i] = cloth.inverse_mass[v] > 0 ? 1 / mass[v] : 0.0F;
    }
    return thread_element(cloth, triangle.panel, triangle.vertices, frame, w);
}

// A refined triangle moves the cloth about its vertices with it. So a vertex weighs as much there as all that follows
// it: its own mass, and half of that of each centre between it and another. Then no correction changes the momentum.
std::vector<ParentLevel> parent_levels(const Cloth& cloth) {
    std::vector<float> mass(cloth.inverse_mass.size(), 0.0F);
    for (std::size_t v = 0; v < mass.size(); ++v) {
        if (cloth.inverse_mass[v] > 0) mass[v] = 1 / cloth.inverse_mass[v];
    }
    std::vector<ParentLevel> levels(static_cast<std::size_t>(cloth.mesh.max_level()));
    for (int level = cloth.mesh.max_level() - 1; level >= 0; --level) {
        ParentLevel& parents = levels[static_cast<std::size_t>(level)];
        for (const EdgeId e : cloth.mesh.split_edges(level)) {
            const std::uint32_t a = cloth.mesh.end(e, 0).value;
            const std::uint32_t b = cloth.mesh.end(e, 1).value;
            const std::uint32_t c = cloth.mesh.centre(e).value;
            mass[a] += 0.5F * mass[c];
            mass[b] += 0.5F * mass[c];
            parents.centres.push_back({a, b, c, cloth.inverse_mass[c] > 0 ? 1.0F : 0.0F});
        }
        for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
            parents.triangles.push_back(parent_element(cloth, cloth.mesh.triangle(t), mass));
        }
    }
    return levels;
}

// Isometric bending: sum of q_i x_i is the mean curvature vector about the hinge, with cotangent weights of the
// unfolded rest state. Energy 1/2 (3 B / (A_left + A_right)) |sum q x|^2.  (Bergou et al. 2006)
BendElement bend_element(const Cloth& cloth, const Hinge& hinge) {
    const Vec2f a(-0.5F * hinge.rest_length, 0);
    const Vec2f b(0.5F * hinge.rest_length, 0);
    const auto cotangent = [](const Vec2f& p, const Vec2f& q) {
        return p.dot(q) / std::abs(p.x() * q.y() - p.y() * q.x());
    };
    const float left_a = cotangent(b - a, hinge.left_at - a);
    const float right_a = cotangent(b - a, hinge.right_at - a);
    const float left_b = cotangent(a - b, hinge.left_at - b);
    const float right_b = cotangent(a - b, hinge.right_at - b);
    BendElement element{.vertices = {hinge.a.value, hinge.b.value, hinge.left.value, hinge.right.value},
                        .q = {left_b + right_b, left_a + right_a, -left_a - left_b, -right_a - right_b}};
    const float area = 0.5F * hinge.rest_length * (hinge.left_at.y() - hinge.right_at.y());
    float rigidity = 0;
    const AdaptiveEdge& edge = cloth.mesh.edge(hinge.edge);
    for (std::size_t side = 0; side < 2; ++side) {
        const std::uint16_t panel = cloth.mesh.triangle(edge.sides[side]).panel;
        rigidity += 0.5F * hinge_rigidity(cloth.fabrics[panel], hinge.along[side], cloth.grain_angles[panel]);
    }
    float sum = area / (3 * rigidity * cloth.substep * cloth.substep);
    for (std::size_t i = 0; i < 4; ++i) sum += cloth.inverse_mass[element.vertices[i]] * element.q[i] * element.q[i];
    for (std::size_t i = 0; i < 4; ++i) {
        element.move[i] = cloth.inverse_mass[element.vertices[i]] * element.q[i] / sum;
    }
    return element;
}

}  // namespace

MaterialFrame material_frame(const std::array<Vec2f, 3>& u, float grain_angle) {
    const Vec2f e1 = u[1] - u[0];
    const Vec2f e2 = u[2] - u[0];
    const Vec2f warp = warp_direction(grain_angle);
    const Vec2f weft = weft_direction(grain_angle);
    const float s1 = warp.dot(e1);
    const float s2 = warp.dot(e2);
    const float t1 = weft.dot(e1);
    const float t2 = weft.dot(e2);
    const float det = s1 * t2 - s2 * t1;
    return {.a = {t2 / det, -t1 / det}, .b = {-s2 / det, s1 / det}, .area = 0.5F * std::abs(det)};
}

ClothElements make_elements(const Cloth& cloth) {
    ClothElements elements;
    elements.vertices.reserve(cloth.mesh.leaf_vertices().size());
    for (const VertexId v : cloth.mesh.leaf_vertices()) elements.vertices.push_back(v.value);
    elements.stretch.reserve(cloth.mesh.leaf_triangles().size());
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) elements.stretch.push_back(stretch_element(cloth, t));
    elements.bend.reserve(cloth.mesh.hinges().size());
    for (const Hinge& hinge : cloth.mesh.hinges()) elements.bend.push_back(bend_element(cloth, hinge));
    elements.limits.reserve(cloth.mesh.leaf_edges().size());
    for (const LeafEdge& edge : cloth.mesh.leaf_edges()) elements.limits.push_back(leaf_limit(cloth, edge));
    elements.parents = parent_levels(cloth);
    return elements;
}

}  // namespace selvedge
