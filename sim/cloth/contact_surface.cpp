#include "sim/cloth/contact_surface.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "sim/cloth/cloth.h"
#include "sim/cloth/self_contact_state.h"
#include "sim/cloth/solver_state.h"

namespace selvedge::sim {
namespace {

// Bits of a number, with a zero bit after each.
std::uint32_t spread_bits(std::uint32_t x) {
    x = (x | (x << 8U)) & 0x00FF00FFU;
    x = (x | (x << 4U)) & 0x0F0F0F0FU;
    x = (x | (x << 2U)) & 0x33333333U;
    return (x | (x << 1U)) & 0x55555555U;
}

// Place on the Z-order curve of millimetres, for points within 32 m of the panel's origin.
std::uint32_t place_on_curve(const Vec2f& u) {
    const auto place = [](float metres) {
        return static_cast<std::uint32_t>(std::clamp(1000 * metres + 32768, 0.0F, 65535.0F));
    };
    return spread_bits(place(u.x())) | (spread_bits(place(u.y())) << 1U);
}

Vec2f middle_of(const std::array<Vec2f, 3>& u) {
    return (u[0] + u[1] + u[2]) / 3.0F;
}

// Collects leaves and edges in depth-first order.
class SurfaceMaker {
 public:
    explicit SurfaceMaker(const AdaptiveMesh& mesh) : mesh_(mesh) {
        edge_index_.assign(mesh.edges().capacity(), kNoElement);
        surface_.triangles.reserve(mesh.leaf_triangles().size());
        surface_.edges.reserve(mesh.leaf_edges().size());
    }

    void add(TriangleId id) {
        const AdaptiveTriangle& triangle = mesh_.triangle(id);
        if (is_leaf(triangle)) return add_leaf(triangle);
        for (std::size_t i = 0; i < layout(triangle.configuration).triangle_count; ++i) {
            add(triangle.internal_triangles[i]);
        }
    }

    ContactSurface take() { return std::move(surface_); }

 private:
    void add_leaf(const AdaptiveTriangle& triangle) {
        const auto index = static_cast<std::uint32_t>(surface_.triangles.size());
        ContactTriangle& added = surface_.triangles.emplace_back();
        added.sheet = triangle.panel;
        added.middle = middle_of(triangle.u);
        for (std::size_t k = 0; k < 3; ++k) {
            // In the orientation of the surface: backwards where that is not the panel's.
            const std::size_t corner = triangle.turned ? 2 - k : k;
            const EdgeId side = triangle.edges[triangle.turned ? (4 - k) % 3 : k];
            added.vertices[k] = triangle.vertices[corner].value;
            std::uint32_t& edge = edge_index_[side.value];
            if (edge == kNoElement) {
                edge = static_cast<std::uint32_t>(surface_.edges.size());
                const AdaptiveEdge& from = mesh_.edge(side);
                surface_.edges.push_back({.ends = {from.ends[0].value, from.ends[1].value},
                                          .triangles = {index, kNoElement},
                                          .rest_length = from.rest_length});
            } else {
                surface_.edges[edge].triangles[1] = index;
            }
            added.edges[k] = edge;
        }
    }

    const AdaptiveMesh& mesh_;
    ContactSurface surface_;
    std::vector<std::uint32_t> edge_index_;  // by EdgeId
};

}  // namespace

std::vector<std::uint32_t> order_of_base_triangles(const Cloth& cloth) {
    std::vector<std::uint32_t> order(cloth.mesh.base_triangle_count());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t t) {
        const AdaptiveTriangle& triangle = cloth.mesh.triangle(TriangleId{t});
        return std::pair(triangle.panel, place_on_curve(middle_of(triangle.u)));
    });
    return order;
}

ContactSurface contact_surface(const Cloth& cloth, const std::vector<std::uint32_t>& base_order) {
    SurfaceMaker maker(cloth.mesh);
    for (const std::uint32_t t : base_order) maker.add(TriangleId{t});
    ContactSurface surface = maker.take();
    for (std::size_t panel = 0; panel < cloth.material.fabrics.size(); ++panel) {
        const Fabric& fabric = cloth.material.fabrics[panel];
        surface.sheets.push_back({.thickness = static_cast<float>(fabric.thickness),
                                  .friction = static_cast<float>(fabric.friction),
                                  .layer = cloth.material.layers.empty() ? 0 : cloth.material.layers[panel]});
    }
    return surface;
}

ContactSurface contact_surface(const Cloth& cloth) {
    return contact_surface(cloth, order_of_base_triangles(cloth));
}

void update_contact_surface(Cloth& cloth) {
    SelfContactState& state = *cloth.solver->self_contact;
    if (state.has_surface) return;
    if (state.base_order.size() != cloth.mesh.base_triangle_count()) state.base_order = order_of_base_triangles(cloth);
    ContactSurface surface = contact_surface(cloth, state.base_order);
    surface.sewn = state.sewn;
    if (!surface.sewn.empty()) {
        for (std::size_t v = surface.sewn.size(); v < cloth.x.size(); ++v)
            surface.sewn.push_back(static_cast<std::uint32_t>(v));
    }
    state.contact.set_surface(std::move(surface), cloth.x.size());
    state.has_surface = true;
}

std::vector<float> self_contact_clearances(Cloth& cloth) {
    const MovingPoints points{cloth.x.front().data(), cloth.x_prev.front().data(), cloth.x.size()};
    return cloth.solver->self_contact->contact.clearances(points);
}

SelfContactHolder::SelfContactHolder() : state_(std::make_unique<SelfContactState>()) {}
SelfContactHolder::SelfContactHolder(const SelfContactHolder& other)
    : state_(std::make_unique<SelfContactState>(*other.state_)) {}
SelfContactHolder::SelfContactHolder(SelfContactHolder&& other) noexcept = default;
SelfContactHolder& SelfContactHolder::operator=(const SelfContactHolder& other) {
    return *this = SelfContactHolder(other);
}
SelfContactHolder& SelfContactHolder::operator=(SelfContactHolder&& other) noexcept = default;
SelfContactHolder::~SelfContactHolder() = default;

}  // namespace selvedge::sim
