#pragma once
// A body that is ready to be dressed, as often as one likes: as it stands while it is dressed and afterwards, with its
// colliders.
#include <functional>
#include <memory>

#include "sim/body/body.h"
#include "sim/body/pose.h"
#include "sim/collide/body_collider.h"
#include "sim/place/measured_body.h"

namespace selvedge::sim {

class ContentStore;

class Wearer {
 public:
    // Builds the colliders, which takes up to seconds. body: not null. interrupt: called regularly meanwhile; its
    // exceptions propagate. store: where the body's field may be found and is kept; null for none.
    explicit Wearer(std::shared_ptr<const Body> body, const std::function<void()>& interrupt = {},
                    const ContentStore* store = nullptr);

    const Body& body() const { return *body_; }  // in its own pose
    // In the pose in which it is dressed: the same body if that is its own pose.
    const std::shared_ptr<const Body>& stands() const { return stands_; }
    bool stands_otherwise() const { return stands_ != body_; }
    const Pose& pose() const { return pose_; }  // in which it is dressed; empty without a skin
    // Of stands(), which it keeps alive.
    const std::shared_ptr<const BodyCollider>& collider() const { return collider_; }
    const std::shared_ptr<const MeasuredBody>& measured() const { return measured_; }  // stands(), not kept alive
    // Of body(), as move_to_own_pose() leaves it; null if it is dressed in its own pose.
    const BodyCollider* own_collider() const { return own_collider_.get(); }

 private:
    std::shared_ptr<const Body> body_, stands_;
    Pose pose_;
    std::shared_ptr<const BodyCollider> collider_, own_collider_;
    std::shared_ptr<const MeasuredBody> measured_;
};

// The collider of a body, which it keeps alive.
std::shared_ptr<const BodyCollider> shared_collider_of(std::shared_ptr<const Body> body,
                                                       const std::function<void()>& interrupt = {},
                                                       const ContentStore* store = nullptr);

}  // namespace selvedge::sim
