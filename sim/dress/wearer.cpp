#include "sim/dress/wearer.h"

#include <utility>

#include "sim/core/assert.h"
#include "sim/dress/animation.h"
#include "sim/dress/dressing_pose.h"
#include "sim/dress/own_pose.h"

namespace selvedge::sim {
namespace {

struct ColliderOfBody {
    std::shared_ptr<const Body> body;
    BodyCollider collider;
};

}  // namespace

std::shared_ptr<const BodyCollider> shared_collider_of(std::shared_ptr<const Body> body,
                                                       const std::function<void()>& interrupt,
                                                       const ContentStore* store) {
    const Body& surface = *body;
    const std::shared_ptr<const ColliderOfBody> made(
        new ColliderOfBody{std::move(body), BodyCollider(surface, {}, interrupt, store)});
    return {made, &made->collider};
}

Wearer::Wearer(std::shared_ptr<const Body> body, const std::function<void()>& interrupt, const ContentStore* store)
    : body_(std::move(body)), stands_(body_) {
    SELVEDGE_ASSERT(body_);
    if (!body_->skin.empty()) pose_ = dressing_pose(*body_);
    if (!body_->skin.empty() && needs_other_pose(*body_, pose_))
        stands_ = std::make_shared<const Body>(posed(*body_, pose_));
    collider_ = shared_collider_of(stands_, interrupt, store);
    measured_ = std::make_shared<const MeasuredBody>(*stands_);
    if (!stands_otherwise()) return;
    auto rests = std::make_shared<const Body>(posed(*body_, rest_pose(*body_)));
    own_collider_ = shared_collider_of(std::move(rests), interrupt, store);
}

}  // namespace selvedge::sim
