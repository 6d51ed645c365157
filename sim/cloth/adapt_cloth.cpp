#include "sim/cloth/adapt_cloth.h"

#include "sim/adaptive/criteria.h"
#include "sim/body/collider.h"

namespace selvedge {
namespace {

// What a split and a rejoin do to the state of the cloth.
struct ClothObserver {
    Cloth& cloth;
    const BodyCollider& body;
    float offset;

    void on_capacity(std::size_t capacity) {
        cloth.x.resize(capacity, Vec4f::Zero());
        cloth.x_prev.resize(capacity, Vec4f::Zero());
        cloth.inverse_mass.resize(capacity, 0.0F);
        cloth.normals.resize(capacity, Vec3f::Zero());
        cloth.is_pinned.resize(capacity, false);
    }

    // The mean of the ends, and of their previous positions, so that velocity is averaged; out of the body if it fell
    // inside, without gaining speed from that.
    void on_split(VertexId c, VertexId a, VertexId b) {
        const Vec4f middle = (cloth.x[a.value] + cloth.x[b.value]) * 0.5F;
        const Vec4f velocity = middle - (cloth.x_prev[a.value] + cloth.x_prev[b.value]) * 0.5F;
        const Vec3f normal = cloth.normals[a.value] + cloth.normals[b.value];
        cloth.x[c.value] = padded(outside(middle.head<3>(), normal, body, offset));
        cloth.x_prev[c.value] = cloth.x[c.value] - velocity;
        cloth.normals[c.value] = normal.squaredNorm() > 0 ? Vec3f(normal.normalized()) : Vec3f::Zero();
        cloth.is_pinned[c.value] = false;
    }

    void on_rejoin(VertexId) {}
};

// Adds the criteria that are switched on one by one, so that each combination is a function of its own and no edge asks
// what is switched off.
template <class... Chosen>
AdaptReport adapt_with(Cloth& cloth, ClothObserver& observer, const CriteriaOptions& left, const Chosen&... chosen) {
    CriteriaOptions rest = left;
    if (left.collision) {
        rest.collision = false;
        if constexpr (sizeof...(Chosen) == 0) {
            const CollisionCriterion collision{.x = cloth.x, .body = observer.body, .offset = observer.offset};
            return adapt_with(cloth, observer, rest, collision);
        }
    }
    if (left.curvature) {
        rest.curvature = false;
        if constexpr (sizeof...(Chosen) <= 1) {
            return adapt_with(cloth, observer, rest, chosen..., CurvatureCriterion(cloth.normals));
        }
    }
    if (left.length) {
        rest.length = false;
        if constexpr (sizeof...(Chosen) <= 2) {
            return adapt_with(cloth, observer, rest, chosen..., LengthCriterion<Vec4f>(cloth.x));
        }
    }
    return adapt(cloth.mesh, observer, AdaptOptions{}, chosen...);
}

}  // namespace

float CollisionCriterion::depth(const AdaptiveMesh& mesh, EdgeId edge) const {
    const Vec4f middle = (x[mesh.end(edge, 0).value] + x[mesh.end(edge, 1).value]) * 0.5F;
    return offset - body.contact(middle.head<3>()).distance;
}

AdaptReport adapt_cloth(Cloth& cloth, const BodyCollider& body, const AdaptClothOptions& options,
                        const ContactOptions& contact) {
    update_normals(cloth);
    ClothObserver observer{cloth, body, options.contact_offset};
    const AdaptReport report = adapt_with(cloth, observer, options.criteria);
    if (report.changed()) {
        refresh_elements(cloth);
        refresh_contacts(cloth, contact);
    }
    return report;
}

}  // namespace selvedge
