#include "bench/thesis/provot_cloth.h"

#include <algorithm>
#include <cmath>

#include "bench/support/cloth_run.h"
#include "sim/collide/collider.h"
#include "sim/core/stopwatch.h"

namespace selvedge::bench {
namespace {

using sim::Cloth;
using sim::Hinge;
using sim::LeafEdge;
using sim::VertexId;

void add_springs(const Cloth& cloth, float spring, std::vector<Vec3f>& forces) {
    for (const LeafEdge& e : cloth.mesh.leaf_edges()) {
        const Vec3f d = position_of(cloth, e.b) - position_of(cloth, e.a);
        const float length = d.norm();
        if (length <= 0) continue;
        const Vec3f pull = d * (spring * (length - e.rest_length) / length);
        forces[e.a.value] += pull;
        forces[e.b.value] -= pull;
    }
}

void add_bending(const Cloth& cloth, float bending, std::vector<Vec3f>& forces) {
    for (const Hinge& hinge : cloth.mesh.hinges()) {
        const std::array<VertexId, 4> v{hinge.a, hinge.b, hinge.left, hinge.right};
        const std::array<Vec3f, 4> f = bending_forces(
            {position_of(cloth, v[0]), position_of(cloth, v[1]), position_of(cloth, v[2]), position_of(cloth, v[3])},
            bending);
        for (std::size_t i = 0; i < 4; ++i) forces[v[i].value] += f[i];
    }
}

// x' = x + (1 - d) (x - x_prev) + F/m dt^2
void integrate(Cloth& cloth, const ProvotOptions& options, const std::vector<Vec3f>& forces) {
    const float keep = std::max(0.0F, 1 - options.damping * cloth.substep), dt2 = cloth.substep * cloth.substep;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        if (cloth.inverse_mass[v.value] == 0) continue;
        Vec4f &x = cloth.x[v.value], &before = cloth.x_prev[v.value];
        const Vec4f motion = (x - before) * keep;
        before = x;
        x += motion;
        x.head<3>() += (options.gravity + forces[v.value] * cloth.inverse_mass[v.value]) * dt2;
    }
}

// All edges, in the order of the list.
void correct_lengths(Cloth& cloth, float max_elongation) {
    for (const LeafEdge& e : cloth.mesh.leaf_edges()) {
        WeightedEnd a{position_of(cloth, e.a), cloth.inverse_mass[e.a.value]},
            b{position_of(cloth, e.b), cloth.inverse_mass[e.b.value]};
        correct_length(a, b, (1 + max_elongation) * e.rest_length);
        cloth.x[e.a.value].head<3>() = a.x;
        cloth.x[e.b.value].head<3>() = b.x;
    }
}

// Vertices below the offset surface are moved onto it; friction takes up to its coefficient times that way from the
// tangential motion.
void collide(Cloth& cloth, const sim::Collider& body, const ProvotOptions& options) {
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        if (cloth.inverse_mass[v.value] == 0) continue;
        const sim::Contact contact = body.contact(position_of(cloth, v));
        const float depth = options.offset - contact.distance;
        if (depth <= 0) continue;
        Vec4f& x = cloth.x[v.value];
        x.head<3>() += contact.normal * depth;
        const Vec3f motion = (x - cloth.x_prev[v.value]).head<3>();
        const Vec3f slip = motion - contact.normal * motion.dot(contact.normal);
        const float length = slip.norm();
        if (length > 0) x.head<3>() -= slip * std::min(1.0F, options.friction * depth / length);
    }
}

}  // namespace

void correct_length(WeightedEnd& a, WeightedEnd& b, float longest) {
    const Vec3f d = b.x - a.x;
    const float length = d.norm(), w = a.inverse_mass + b.inverse_mass;
    if (length <= longest || w <= 0) return;
    const Vec3f c = d * ((length - longest) / (length * w));
    a.x += a.inverse_mass * c;
    b.x -= b.inverse_mass * c;
}

float stable_spring(float area_density, float spacing, float substep) {
    constexpr float kSafety = 0.8F, kEdges = 3;
    const float mass = area_density * spacing * spacing / 2 / 3;
    return kSafety * 2 * mass / (kEdges * substep * substep);
}

//        left          x1 = left, x2 = right, x3 = a, x4 = b; N1 and N2 are the normals of the two triangles times
//        twice
//       /    \         their areas, E = b - a. Thesis fig. 3.15; Bridson et al. 2003, section 4.
//      a------b        For bending rigidity B the coefficient is 4 B.
//       \    /
//        right
std::array<Vec3f, 4> bending_forces(const std::array<Vec3f, 4>& x, float bending) {
    const Vec3f &a = x[0], &b = x[1], &left = x[2], &right = x[3];
    const Vec3f e = b - a;
    const Vec3f n1 = (left - a).cross(left - b), n2 = (right - b).cross(right - a);
    const float e2 = e.squaredNorm(), s1 = n1.squaredNorm(), s2 = n2.squaredNorm();
    if (e2 <= 0 || s1 <= 0 || s2 <= 0) return {Vec3f::Zero(), Vec3f::Zero(), Vec3f::Zero(), Vec3f::Zero()};
    const float length = std::sqrt(e2);
    const Vec3f along = e / length, m1 = n1 / s1, m2 = n2 / s2;
    const float cosine = std::clamp(n1.dot(n2) / std::sqrt(s1 * s2), -1.0F, 1.0F);
    const float half_sine = std::copysign(std::sqrt((1 - cosine) / 2), n1.cross(n2).dot(along));  // sin(angle / 2)
    const float size = 4 * bending * e2 / (std::sqrt(s1) + std::sqrt(s2)) * half_sine;
    return {size * ((left - b).dot(along) * m1 + (right - b).dot(along) * m2),
            -size * ((left - a).dot(along) * m1 + (right - a).dot(along) * m2), size * length * m1, size * length * m2};
}

void provot_step(Cloth& cloth, const sim::Collider& body, const ProvotOptions& options, sim::StepTimes* times) {
    std::vector<Vec3f> forces(cloth.x.size());
    for (int i = 0; i < options.substeps; ++i) {
        std::fill(forces.begin(), forces.end(), Vec3f::Zero());
        add_springs(cloth, options.spring, forces);
        add_bending(cloth, options.bending, forces);
        integrate(cloth, options, forces);
        for (int k = 0; k < options.corrections; ++k) correct_lengths(cloth, options.max_elongation);
        const auto start = sim::Clock::now();
        collide(cloth, body, options);
        if (times != nullptr) times->collision += sim::seconds_since(start);
    }
}

}  // namespace selvedge::bench
