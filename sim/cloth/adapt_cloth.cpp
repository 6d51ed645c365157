#include "sim/cloth/adapt_cloth.h"

#include <algorithm>

#include "sim/adaptive/criteria.h"
#include "sim/adaptive/foresight.h"
#include "sim/body/collider.h"

namespace selvedge {
namespace {

// What a split and a rejoin do to the state of the cloth.
struct ClothObserver {
    Cloth& cloth;
    const Collider& body;
    float offset;

    void on_capacity(std::size_t capacity) { size_state(cloth, capacity); }

    // The mean of the ends, and of their previous positions, so that velocity is averaged; out of the body if it fell
    // inside, without gaining speed from that.
    void on_split(VertexId c, VertexId a, VertexId b) {
        const Vec4f middle = (cloth.x[a.value] + cloth.x[b.value]) * 0.5F;
        const Vec4f velocity = middle - (cloth.x_prev[a.value] + cloth.x_prev[b.value]) * 0.5F;
        const Vec3f normal = cloth.normals[a.value] + cloth.normals[b.value];
        cloth.x[c.value] = padded(outside(middle.head<3>(), normal, body, offset));
        cloth.x_prev[c.value] = cloth.x[c.value] - velocity;
        cloth.normals[c.value] = normal.squaredNorm() > 0 ? Vec3f(normal.normalized()) : Vec3f::Zero();
        cloth.is_pinned[c.value] = cloth.is_pinned[a.value] && cloth.is_pinned[b.value];  // a pinned waistband stays up
    }

    void on_rejoin(VertexId) {}
};

// The criteria that are switched on, each combination a function of its own: no edge asks what is switched off.
template <class... Chosen>
AdaptReport with_length(Cloth& cloth, ClothObserver& observer, const AdaptClothOptions& options,
                        const Chosen&... chosen) {
    const ShortestEdgeCriterion shortest{options.shortest_edge};
    const HoldCriterion hold{options.may_rejoin};
    if (!options.criteria.length) return adapt(cloth.mesh, observer, AdaptOptions{}, shortest, hold, chosen...);
    const LengthCriterion<Vec4f> length(cloth.x);
    return adapt(cloth.mesh, observer, AdaptOptions{}, shortest, hold, chosen..., length);
}

template <class... Chosen>
AdaptReport with_curvature(Cloth& cloth, ClothObserver& observer, const AdaptClothOptions& options,
                           const Chosen&... chosen) {
    if (!options.criteria.curvature) return with_length(cloth, observer, options, chosen...);
    const CurvatureCriterion curvature(cloth.normals);
    return with_length(cloth, observer, options, chosen..., Foresight(curvature));
}

AdaptReport with_collision(Cloth& cloth, ClothObserver& observer, const AdaptClothOptions& options) {
    if (!options.criteria.collision) return with_curvature(cloth, observer, options);
    const CollisionCriterion collision{.x = cloth.x, .body = observer.body, .offset = observer.offset};
    return with_curvature(cloth, observer, options, collision);
}

}  // namespace

float CollisionCriterion::depth(const AdaptiveMesh& mesh, EdgeId id) const {
    const AdaptiveEdge& edge = mesh.edge(id);
    const auto depth_at = [&](const Vec4f& p) { return offset - body.contact(p.head<3>()).distance; };
    float deepest = depth_at((x[edge.ends[0].value] + x[edge.ends[1].value]) * 0.5F);
    for (const TriangleId side : edge.sides) {
        if (!side) continue;
        const std::array<VertexId, 3>& v = mesh.triangle(side).vertices;
        deepest = std::max(deepest, depth_at((x[v[0].value] + x[v[1].value] + x[v[2].value]) * (1.0F / 3.0F)));
    }
    return deepest;
}

AdaptReport adapt_cloth(Cloth& cloth, const Collider& body, const AdaptClothOptions& options,
                        const ContactOptions& contact) {
    update_normals(cloth);
    ClothObserver observer{cloth, body, contact.offset};
    const AdaptReport report = with_collision(cloth, observer, options);
    if (report.changed()) {
        refresh_elements(cloth);
        refresh_contacts(cloth, contact);
    }
    return report;
}

}  // namespace selvedge
