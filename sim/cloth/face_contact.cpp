#include "sim/cloth/face_contact.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>

#include "sim/cloth/cloth.h"
#include "sim/cloth/cloth_penetration.h"
#include "sim/cloth/contact.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/standoff.h"
#include "sim/collide/surface_bvh.h"
#include "sim/collide/thin_parts.h"

namespace selvedge::sim {
namespace {

using Corners = std::array<Vec3f, 3>;
using Shares = std::array<float, 3>;

constexpr float kFaceReach = 0.0005F;  // m, how far the tangent plane is used: its error is 25 um at R = 5 mm

constexpr float kUnseen = 0.002F;  // m, after which a face is queried again: the descent may miss a second finger

constexpr float kRounding = 1e-6F;  // m, more than the rounding errors of positions within 8 m of the origin

struct FacePoint {
    Vec3f x = Vec3f::Zero();
    Contact contact{.distance = std::numeric_limits<float>::max()};
};

struct NearestPoint {
    FacePoint nearest;  // that the descent found
    float least = 0;    // m: no point of the face is nearer to the body
};

// Answers exactly where there is a surface; nullopt if it is farther than `reach`.
using ContactWithin = std::function<std::optional<Contact>(const Vec3f& x, float reach)>;

ContactWithin contacts_with(const SurfaceBvh& surface) {
    return [&](const Vec3f& x, float reach) -> std::optional<Contact> {
        const auto closest = surface.closest(x, reach);
        if (!closest) return std::nullopt;
        return Contact{closest->distance, closest->normal};
    };
}

ContactWithin contacts_with(const Collider& body) {
    if (const SurfaceBvh* const surface = body.exact_surface()) return contacts_with(*surface);
    return [&](const Vec3f& x, float) { return std::optional(body.contact(x)); };
}

// Takes x if it is nearer to the body, or deeper in it, than the nearest so far. It cannot be deeper than the way from
// there, less the distance there.
bool take_nearer(const ContactWithin& contact_within, const Vec3f& x, FacePoint& nearest) {
    const float known = nearest.contact.distance;
    const float deepest = (x - nearest.x).norm() - known;
    const auto contact = contact_within(x, std::max(known, deepest) + kRounding);
    if (!contact || contact->distance >= known) return false;
    nearest = {x, *contact};
    return true;
}

Vec3f mixed(const Corners& x, const Shares& shares) {
    return shares[0] * x[0] + shares[1] * x[1] + shares[2] * x[2];
}

float largest_move(const Corners& from, const Corners& to) {
    float squared = 0;
    for (std::size_t k = 0; k < 3; ++k) squared = std::max(squared, (to[k] - from[k]).squaredNorm());
    return std::sqrt(squared);
}

// Starts from the best of a few points. Aims at a point inside the body, so that the descent goes on in a face that is
// pierced: for a limb of the radius kAim one step suffices.
NearestPoint nearest_point(const ContactWithin& body, const Corners& x, const Shares& last) {
    constexpr float kAim = 0.005F;         // m, less than the radius of a finger
    constexpr float kProgress = 0.00002F;  // m: a step that comes nearer by less is the last one
    constexpr int kSteps = 12;             // at most
    FacePoint nearest;
    const Vec3f middle = (x[0] + x[1] + x[2]) / 3;
    take_nearer(body, middle, nearest);
    const float least = nearest.contact.distance - largest_move({middle, middle, middle}, x);
    for (const Vec3f& start :
         {mixed(x, last), Vec3f((x[0] + x[1]) / 2), Vec3f((x[1] + x[2]) / 2), Vec3f((x[2] + x[0]) / 2)})
        take_nearer(body, start, nearest);
    for (int step = 0; step < kSteps; ++step) {
        const float before = nearest.contact.distance;
        const Vec3f aim = nearest.x - nearest.contact.normal * (before + kAim);
        if (!take_nearer(body, closest_on_triangle(aim, x[0], x[1], x[2]).point, nearest)) break;
        if (nearest.contact.distance > before - kProgress) break;
    }
    return {nearest, least};
}

Corners corners_of(const FaceContact& face, const std::vector<Vec4f>& points) {
    const auto at = [&](std::size_t k) -> Vec3f { return points[face.carrier.vertices[k]].head<3>(); };
    return {at(0), at(1), at(2)};
}

void query(FaceContact& face, const Corners& x, const Collider& body, float offset) {
    const auto [nearest, least] = nearest_point(contacts_with(body), x, face.carrier.shares);
    face.query_points = x;
    face.carrier.shares = barycentric(nearest.x, x[0], x[1], x[2]);
    face.plane.normal = nearest.contact.normal;
    face.plane.point = nearest.x - nearest.contact.normal * nearest.contact.distance;
    face.slack = std::clamp(nearest.contact.distance - offset, 0.0F, std::max(least - offset, kUnseen));
}

// Depth that the face had before the sub-step gives no velocity.
void push_out(FaceContact& face, SolverState& solver, const Collider& body, const ContactOptions& options) {
    const Corners x = corners_of(face, solver.points);
    const bool is_known = face.slack >= 0;
    const float moved = is_known ? largest_move(face.query_points, x) : 0;
    if (!is_known || moved > std::max(face.slack, kFaceReach)) {
        query(face, x, body, options.offset);
        if (face.slack > 0) return;
    } else if (face.slack > kFaceReach) {
        return;
    }
    const auto met_by = [&](const std::vector<Vec4f>& points) {
        return met({face.plane, {.start = options.offset}}, point_of(face.carrier, points), {});
    };
    MetPlane plane = met_by(solver.points);
    plane.gained = std::min(plane.depth, met_by(solver.before).depth);
    push_out(face.carrier, plane, options.friction_scale, solver.points, solver.before);
}

FaceContact& watch(Cloth& cloth, const LeafTriangle& leaf) {
    FaceContact& face = cloth.solver->contacts.faces.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) face.carrier.vertices[k] = leaf.v[k].value;
    face.carrier.friction = static_cast<float>(cloth.material.fabrics[leaf.panel].friction);
    return face;
}

}  // namespace

NearestOfFace nearest_of_face(const SurfaceBvh& surface, const std::array<Vec3f, 3>& corners) {
    constexpr float kThird = 1.0F / 3.0F;
    const FacePoint found = nearest_point(contacts_with(surface), corners, {kThird, kThird, kThird}).nearest;
    return {.shares = barycentric(found.x, corners[0], corners[1], corners[2]),
            .x = found.x,
            .distance = found.contact.distance};
}

void watch_faces_near_thin_parts(Cloth& cloth, const Collider& body, float seconds) {
    constexpr float kUnexpected = 0.01F;  // m, in a frame: twice what a free fall from rest adds
    ContactState& contacts = cloth.solver->contacts;
    contacts.faces.clear();
    const std::span<const ThinPart> parts = body.thin_parts();
    if (parts.empty() || !contacts.is_trunk_only.empty()) return;
    const float substeps = seconds / cloth.substep;
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        Eigen::AlignedBox3f box;
        for (const VertexId v : leaf.v) {
            const Vec3f x = cloth.x[v.value].head<3>();
            box.extend(x);
            box.extend(Vec3f(x + substeps * (cloth.x[v.value] - cloth.x_prev[v.value]).head<3>()));
        }
        box.min() -= Vec3f::Constant(kUnexpected);
        box.max() += Vec3f::Constant(kUnexpected);
        if (is_near(parts, box)) watch(cloth, leaf);
    }
}

int watch_faces_inside(Cloth& cloth, const Collider& body, float depth) {
    const SurfaceBvh* const surface = body.exact_surface();
    if (surface == nullptr) return 0;
    const Penetration found = find_penetration(cloth, *surface, {.depth = depth});
    std::vector<FaceContact>& faces = cloth.solver->contacts.faces;
    std::map<std::array<std::uint32_t, 3>, std::size_t> watched;
    for (std::size_t i = 0; i < faces.size(); ++i) watched.emplace(faces[i].carrier.vertices, i);
    for (const DeepFace& deep : found.deep_faces) {
        const LeafTriangle& leaf = cloth.mesh.leaf_triangles()[deep.triangle];
        const auto at = [&](std::size_t k) -> Vec3f { return cloth.x[leaf.v[k].value].head<3>(); };
        const auto known = watched.find({leaf.v[0].value, leaf.v[1].value, leaf.v[2].value});
        FaceContact& face = known != watched.end() ? faces[known->second] : watch(cloth, leaf);
        face.carrier.shares = barycentric(deep.at, at(0), at(1), at(2));
        face.slack = FaceContact::kUnknown;
    }
    return found.faces;
}

void push_out_faces(Cloth& cloth, const Collider& body, const ContactOptions& options) {
    for (FaceContact& face : cloth.solver->contacts.faces) push_out(face, *cloth.solver, body, options);
}

float deepest_watched_face(const Cloth& cloth, const Collider& body) {
    float least = 0;
    for (const FaceContact& face : cloth.solver->contacts.faces) {
        const Corners x = corners_of(face, cloth.solver->points);
        least = std::min(least, nearest_point(contacts_with(body), x, face.carrier.shares).nearest.contact.distance);
    }
    return -least;
}

}  // namespace selvedge::sim
