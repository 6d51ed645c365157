#include "sim/cloth/contact.h"

#include <algorithm>
#include <cmath>

#include "sim/body/collider.h"
#include "sim/cloth/cloth.h"

namespace selvedge {
namespace {

constexpr float kSlackMargin = 0.0005F;  // m, more than the field over-estimates

Vec3f xyz(const Vec4f& v) {
    return v.head<3>();
}

Vec4f at(const std::vector<Vec4f>& x, const ContactPoint& point) {
    if (point.vertex_count == 1) return x[point.vertices[0]];
    Vec4f sum = x[point.vertices[0]] * point.shares[0] + x[point.vertices[1]] * point.shares[1];
    if (point.vertex_count == 3) sum += x[point.vertices[2]] * point.shares[2];
    return sum;
}

// Moves the point's vertices so that the point moves by `shift`, each in proportion to its share of it.
void move_point(Cloth& cloth, const ContactPoint& point, const Vec4f& shift) {
    std::array<float, 3> shares{};
    float sum = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(point.vertex_count); ++i) {
        shares[i] = cloth.inverse_mass[point.vertices[i]] > 0 ? point.shares[i] : 0.0F;
        sum += shares[i] * shares[i];
    }
    if (sum <= 0) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(point.vertex_count); ++i) {
        cloth.x[point.vertices[i]] += shift * (shares[i] / sum);
    }
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

void push_out_point(Cloth& cloth, ContactPoint& point, const Collider& body, const ContactOptions& options) {
    const float friction = point.friction * options.friction_scale;
    const float above_floor = at(cloth.x, point).y() - options.floor;
    if (above_floor < options.offset) {
        apply_contact(cloth, point, Vec3f::UnitY(), options.offset - above_floor, friction);
    }
    const Vec4f x = at(cloth.x, point);
    if (point.slack > 0 && (x - point.asked_at).squaredNorm() < point.slack * point.slack) return;
    const Contact contact = body.contact(xyz(x));
    point.asked_at = x;
    point.slack = contact.distance - options.offset - kSlackMargin;
    if (contact.distance >= options.offset) return;
    apply_contact(cloth, point, contact.normal, options.offset - contact.distance, friction);
}

std::vector<float> vertex_friction(const Cloth& cloth) {
    std::vector<float> friction(cloth.x.size(), 0.0F);
    for (const LeafTriangle& triangle : cloth.mesh.leaf_triangles()) {
        const float mu = static_cast<float>(cloth.fabrics[triangle.panel].friction);
        for (const VertexId v : triangle.v) friction[v.value] = std::max(friction[v.value], mu);
    }
    return friction;
}

// What is known of a vertex that was a point before is kept.
void add_vertices(const Cloth& cloth, const std::vector<float>& friction, std::vector<ContactPoint>& points) {
    std::vector<const ContactPoint*> known(cloth.x.size(), nullptr);
    for (const ContactPoint& point : cloth.contacts.points) {
        if (point.vertex_count == 1) known[point.vertices[0]] = &point;
    }
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        ContactPoint point{.vertices = {v.value, 0, 0}, .friction = friction[v.value]};
        if (known[v.value]) {
            point.asked_at = known[v.value]->asked_at;
            point.slack = known[v.value]->slack;
        }
        points.push_back(point);
    }
}

void add_edges(const Cloth& cloth, const std::vector<float>& friction, float spacing,
               std::vector<ContactPoint>& points) {
    for (const LeafEdge& edge : cloth.mesh.leaf_edges()) {
        const int samples = static_cast<int>(std::ceil(edge.rest_length / spacing)) - 1;
        for (int i = 1; i <= samples; ++i) {
            const float t = static_cast<float>(i) / static_cast<float>(samples + 1);
            points.push_back({.vertices = {edge.a.value, edge.b.value, 0},
                              .shares = {1 - t, t, 0},
                              .vertex_count = 2,
                              .friction = std::max(friction[edge.a.value], friction[edge.b.value])});
        }
    }
}

void add_triangles(const Cloth& cloth, std::vector<ContactPoint>& points) {
    constexpr float kThird = 1.0F / 3.0F;
    for (const LeafTriangle& triangle : cloth.mesh.leaf_triangles()) {
        points.push_back({.vertices = {triangle.v[0].value, triangle.v[1].value, triangle.v[2].value},
                          .shares = {kThird, kThird, kThird},
                          .vertex_count = 3,
                          .friction = static_cast<float>(cloth.fabrics[triangle.panel].friction)});
    }
}

}  // namespace

void refresh_contacts(Cloth& cloth, const ContactOptions& options) {
    std::vector<ContactPoint> fresh;
    fresh.reserve(cloth.contacts.points.size());
    const std::vector<float> friction = vertex_friction(cloth);
    add_vertices(cloth, friction, fresh);
    add_edges(cloth, friction, options.sample_spacing, fresh);
    add_triangles(cloth, fresh);
    cloth.contacts.points = std::move(fresh);
}

void push_out_between(Cloth& cloth, const Collider& body, const ContactOptions& options) {
    std::vector<ContactPoint>& points = cloth.contacts.points;
    for (std::size_t i = cloth.elements.vertices.size(); i < points.size(); ++i) {
        push_out_point(cloth, points[i], body, options);
    }
}

void push_out_vertices(Cloth& cloth, const Collider& body, const ContactOptions& options) {
    const std::size_t count = cloth.elements.vertices.size();  // they come first in the list
    for (std::size_t i = 0; i < count; ++i) push_out_point(cloth, cloth.contacts.points[i], body, options);
}

Vec3f outside(const Vec3f& x, const Vec3f& outward, const Collider& body, float offset) {
    constexpr float kReach = 0.05F;  // m
    const Contact contact = body.contact(x);
    if (contact.distance >= offset) return x;
    const Vec3f nearest = x + contact.normal * (offset - contact.distance);
    if (contact.normal.dot(outward) >= 0 || outward.squaredNorm() <= 0) return nearest;
    const Vec3f direction = outward.normalized();
    const auto ahead = body.first_hit(x, x + direction * kReach);
    if (ahead) return ahead->point + direction * offset;
    const auto behind = body.first_hit(x, x - direction * kReach);
    return behind && contact.distance > 0 ? Vec3f(behind->point + direction * offset) : nearest;
}

}  // namespace selvedge
