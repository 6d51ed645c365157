#include "sim/cloth/contact.h"

#include <algorithm>
#include <cmath>

#include "sim/body/collider.h"
#include "sim/cloth/cloth.h"

namespace selvedge {
namespace {

constexpr float kSlackMargin = 0.0005F;  // m, more than the field over-estimates

Vec3f xyz(const Vec4f& v) { return v.head<3>(); }

// Moves the point's vertices so that the point moves by `shift`, in proportion to their share of it.
void move_point(Cloth& cloth, const ContactPoint& point, const Vec4f& shift) {
    if (point.a == point.b) {
        if (cloth.inverse_mass[point.a] > 0) cloth.x[point.a] += shift;
        return;
    }
    const float share_a = cloth.inverse_mass[point.a] > 0 ? 1 - point.t : 0.0F;
    const float share_b = cloth.inverse_mass[point.b] > 0 ? point.t : 0.0F;
    const float sum = share_a * share_a + share_b * share_b;
    if (sum <= 0) return;
    cloth.x[point.a] += shift * (share_a / sum);
    cloth.x[point.b] += shift * (share_b / sum);
}

Vec4f at(const std::vector<Vec4f>& x, const ContactPoint& point) {
    if (point.a == point.b) return x[point.a];
    return x[point.a] + (x[point.b] - x[point.a]) * point.t;
}

// Coulomb: the tangential move since the last sub-step shrinks by up to friction times the depth.
void apply_contact(Cloth& cloth, const ContactPoint& point, const Vec3f& normal, float depth, float friction) {
    const Vec4f n = padded(normal);
    move_point(cloth, point, n * depth);
    if (friction <= 0) return;
    const Vec4f moved = at(cloth.x, point) - at(cloth.x_prev, point);
    const Vec4f tangential = moved - n * moved.dot(n);
    const float length = tangential.norm();
    if (length <= 1e-12F) return;
    move_point(cloth, point, tangential * -std::min(1.0F, friction * depth / length));
}

void limit_move(Cloth& cloth, std::uint32_t vertex, float max_move) {
    const Vec4f moved = cloth.x[vertex] - cloth.x_prev[vertex];
    const float length = moved.norm();
    if (length > max_move) cloth.x[vertex] = cloth.x_prev[vertex] + moved * (max_move / length);
}

void push_out_point(Cloth& cloth, ContactPoint& point, const BodyCollider& body, const ContactOptions& options) {
    const Vec4f x = at(cloth.x, point);
    const float friction = point.friction * options.friction_scale;
    if (x.y() < options.floor + options.offset) {
        apply_contact(cloth, point, Vec3f::UnitY(), options.floor + options.offset - x.y(), friction);
    }
    if (point.slack > 0 && (x - point.asked_at).squaredNorm() < point.slack * point.slack) return;
    const Contact contact = body.contact(xyz(x));
    point.asked_at = x;
    point.slack = contact.distance - options.offset - kSlackMargin;
    if (contact.distance >= options.offset) return;
    apply_contact(cloth, point, contact.normal, options.offset - contact.distance, friction);
}

}  // namespace

void refresh_contacts(Cloth& cloth, const ContactOptions& options) {
    std::vector<ContactPoint>& points = cloth.contacts.points;
    std::vector<std::uint32_t> known(cloth.x.size(), UINT32_MAX);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (points[i].a == points[i].b) known[points[i].a] = i;
    }
    std::vector<ContactPoint> fresh;
    fresh.reserve(points.size());
    std::vector<float> friction(cloth.x.size(), 0.0F);
    for (const LeafTriangle& triangle : cloth.mesh.leaf_triangles()) {
        const float mu = static_cast<float>(cloth.fabrics[triangle.panel].friction);
        for (const VertexId v : triangle.v) friction[v.value] = std::max(friction[v.value], mu);
    }
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        ContactPoint point{.a = v.value, .b = v.value, .t = 0, .friction = friction[v.value]};
        if (known[v.value] != UINT32_MAX) {
            point.asked_at = points[known[v.value]].asked_at;
            point.slack = points[known[v.value]].slack;
        }
        fresh.push_back(point);
    }
    for (const LeafEdge& edge : cloth.mesh.leaf_edges()) {
        const int samples = static_cast<int>(std::ceil(edge.rest_length / options.sample_spacing)) - 1;
        for (int i = 1; i <= samples; ++i) {
            fresh.push_back({.a = edge.a.value,
                             .b = edge.b.value,
                             .t = static_cast<float>(i) / static_cast<float>(samples + 1),
                             .friction = std::max(friction[edge.a.value], friction[edge.b.value])});
        }
    }
    points = std::move(fresh);
}

void push_out_edges(Cloth& cloth, const BodyCollider& body, const ContactOptions& options, float max_move) {
    for (const std::uint32_t v : cloth.elements.vertices) limit_move(cloth, v, max_move);
    std::vector<ContactPoint>& points = cloth.contacts.points;
    for (std::size_t i = cloth.elements.vertices.size(); i < points.size(); ++i) {
        push_out_point(cloth, points[i], body, options);
    }
}

void push_out_vertices(Cloth& cloth, const BodyCollider& body, const ContactOptions& options) {
    const std::size_t count = cloth.elements.vertices.size();  // they come first in the list
    for (std::size_t i = 0; i < count; ++i) push_out_point(cloth, cloth.contacts.points[i], body, options);
}

Vec3f outside(const Vec3f& x, const Vec3f& outward, const BodyCollider& body, float offset) {
    const Contact contact = body.contact(x);
    if (contact.distance >= offset) return x;
    if (contact.normal.dot(outward) >= 0) return x + contact.normal * (offset - contact.distance);
    constexpr float kReach = 0.05F;
    const Vec3f direction = outward.normalized();
    const auto hit = body.surface().first_hit(x, x + direction * kReach);
    return hit ? Vec3f(hit->point + direction * offset) : Vec3f(x + contact.normal * (offset - contact.distance));
}

}  // namespace selvedge
