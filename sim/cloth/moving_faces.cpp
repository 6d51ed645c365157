#include "sim/cloth/moving_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/cloth/contact.h"
#include "sim/cloth/face_contact.h"
#include "sim/cloth/solver_state.h"

namespace selvedge::sim {
namespace {

// A leaf triangle at the start of a step, m.
struct Face {
    std::array<std::uint32_t, 3> vertices{};
    std::array<Vec3f, 3> x{};
    std::array<Vec3f, 3> way{};  // until the step's end

    Eigen::AlignedBox3f box() const {
        Eigen::AlignedBox3f box;
        for (std::size_t k = 0; k < 3; ++k) box.extend(x[k]).extend(x[k] + way[k]);
        return box;
    }
    float longest_way() const { return std::max({way[0].norm(), way[1].norm(), way[2].norm()}); }
};

Face face_of(const Cloth& cloth, const LeafTriangle& leaf, float substeps) {
    Face face;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = leaf.v[k].value;
        face.vertices[k] = v;
        face.x[k] = cloth.x[v].head<3>();
        face.way[k] = substeps * (cloth.x[v] - cloth.x_prev[v]).head<3>();
    }
    return face;
}

Eigen::AlignedBox3f widened(const Eigen::AlignedBox3f& box, float by) {
    return {box.min() - Vec3f::Constant(by), box.max() + Vec3f::Constant(by)};
}

// Those that come near to any of the cloth in the step.
std::vector<ThinPart> parts_near(const Cloth& cloth, const MovingBodyCollider& body, float margin, float substeps) {
    std::vector<ThinPart> parts = body.thin_parts_in_step();
    Eigen::AlignedBox3f all;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const Vec4f &x = cloth.x[v.value], &before = cloth.x_prev[v.value];
        all.extend(Vec3f(x.head<3>())).extend(Vec3f((x + substeps * (x - before)).head<3>()));
    }
    all = widened(all, margin);
    std::erase_if(parts, [&](const ThinPart& part) { return !part.box.intersects(all); });
    return parts;
}

std::optional<MovingFace> contact_of(const Face& face, const MovingBodyCollider& body, float offset, float seconds) {
    const Vec3f middle = (face.x[0] + face.x[1] + face.x[2]) / 3;
    float radius = 0;
    for (const Vec3f& x : face.x) radius = std::max(radius, (x - middle).norm());
    const float reach = offset + face.longest_way() + body.longest_motion() + kUnforeseen;
    if (!body.surface().closest(middle, radius + reach)) return std::nullopt;
    const NearestOfFace nearest = nearest_of_face(body.surface(), face.x);
    if (nearest.distance > reach) return std::nullopt;
    const auto closest = body.surface().closest(nearest.x, std::abs(nearest.distance) + kUnforeseen);
    if (!closest) return std::nullopt;
    const float lack = std::max(0.0F, offset - closest->distance);
    return MovingFace{{.vertices = face.vertices, .shares = nearest.shares},
                      {.plane = body.plane_at(closest->triangle, nearest.x),
                       .offset = {.start = offset - lack, .change = std::min(lack, kRecovery * seconds)}}};
}

}  // namespace

void find_moving_faces(Cloth& cloth, const MovingBodyCollider& body, const ContactOptions& options, int substeps) {
    MovingContacts& moving = cloth.solver->contacts.moving;
    moving.faces.clear();
    const auto count = static_cast<float>(substeps);
    const float margin = options.offset + kUnforeseen;
    const std::vector<ThinPart> parts = parts_near(cloth, body, margin, count);
    if (parts.empty()) return;
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        const Face face = face_of(cloth, leaf, count);
        if (!is_near(parts, widened(face.box(), margin))) continue;
        std::optional<MovingFace> contact = contact_of(face, body, options.offset, cloth.substep * count);
        if (!contact) continue;
        contact->carrier.friction = static_cast<float>(cloth.material.fabrics[leaf.panel].friction);
        moving.faces.push_back(*contact);
    }
}

void push_out_faces_on_planes(Cloth& cloth, const StepShare& share, const ContactOptions& options) {
    SolverState& solver = *cloth.solver;
    for (const MovingFace& face : solver.contacts.moving.faces) {
        const MetPlane plane = met(face.side, point_of(face.carrier, solver.points), share);
        push_out(face.carrier, plane, options.friction_scale, solver.points, solver.before);
    }
}

}  // namespace selvedge::sim
