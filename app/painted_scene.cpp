#include "app/painted_scene.h"

#include <utility>

#include "render/show.h"
#include "sim/dress/clearance.h"

namespace selvedge {
namespace {

Body body_of(const BodyItem& item) {
    Body body;
    for (const Vec3f& x : item.x) body.x.push_back(x.cast<double>());
    for (const auto& t : item.triangles) {
        body.triangles.push_back({static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])});
    }
    return body;
}

// Whether it has what its mode shows.
bool can_show(const Scene& scene) {
    if (scene.cloths.empty() || scene.cloths.front().mesh.triangles.empty()) return false;
    const ClothItem& cloth = scene.cloths.front();
    if (wants_material(cloth.show) && cloth.mesh.u.empty()) return false;
    return cloth.show != ShowMode::Hierarchy && (cloth.show != ShowMode::Clearance || !scene.bodies.empty());
}

}  // namespace

const PaintedScene& ScenePaint::painted(const std::shared_ptr<const Scene>& scene) {
    if (scene == last_) return painted_;
    last_ = scene;
    auto copy = std::make_shared<Scene>(*scene);
    painted_.legend.reset();
    if (can_show(*copy)) {
        ShowFacts facts;
        const ClothItem& cloth = copy->cloths.front();
        if (cloth.show == ShowMode::Clearance) {
            facts.clearance = measure_clearance(cloth.mesh.x, body_of(copy->bodies.front()));
        }
        painted_.legend = fill_show(*copy, facts);
    } else if (!copy->cloths.empty()) {
        copy->cloths.front().show = ShowMode::Plain;
    }
    painted_.scene = std::move(copy);
    return painted_;
}

}  // namespace selvedge
