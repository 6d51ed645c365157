#include "sim/dress/prepared_body.h"

#include <utility>

#include "sim/body/yielding_flesh.h"
#include "sim/core/assert.h"
#include "sim/dress/dressing_pose.h"
#include "sim/mannequin/stored_mannequin.h"
#include "sim/motion/clip_jumps.h"
#include "sim/pattern/pattern.h"
#include "sim/repair/stored_body.h"

namespace selvedge::sim {
namespace {

struct ColliderOfBody {
    std::shared_ptr<const Body> body;
    BodyCollider collider;
};

// It keeps the body alive.
std::shared_ptr<const BodyCollider> shared_collider_of(std::shared_ptr<const Body> body,
                                                       const std::function<void()>& interrupt,
                                                       const ContentStore* store) {
    const Body& surface = *body;
    const std::shared_ptr<const ColliderOfBody> made(
        new ColliderOfBody{std::move(body), BodyCollider(surface, {}, interrupt, store)});
    return {made, &made->collider};
}

// Null if the body cannot be posed.
std::shared_ptr<const Pose> pose_if_boned(const std::shared_ptr<const Body>& body, Pose (*pose_of)(const Body&)) {
    SELVEDGE_ASSERT(body);
    const bool has_bones = !body->bones.empty() && !body->skin.empty();
    return has_bones ? std::make_shared<const Pose>(pose_of(*body)) : nullptr;
}

std::shared_ptr<const Body> standing(const std::shared_ptr<const Body>& body, const Pose* pose) {
    SELVEDGE_ASSERT(body);
    return pose && needs_other_pose(*body, *pose) ? std::make_shared<const Body>(posed(*body, *pose)) : body;
}

}  // namespace

MadeBody make_body(const std::string& source, const LoadBodyOptions& load, const ContentStore* store) {
    MadeBody made;
    if (is_body_file(source)) {
        BodyClips content = load_stored_body(source, load, store, made.notes);
        made.body = std::make_shared<const Body>(std::move(content.body));
        made.clips = std::move(content.clips);
        for (Clip& clip : made.clips) mend_jumps(*made.body, clip);
    } else {
        made = make_body(parse_mannequin(source), store);
    }
    made.source = source;
    return made;
}

MadeBody make_body(const MannequinOptions& options, const ContentStore* store) {
    Mannequin mannequin = stored_mannequin(options, store);
    return {.body = std::make_shared<const Body>(std::move(mannequin.body)),
            .notes = std::move(mannequin.report.messages),
            .readings = std::move(mannequin.report)};
}

PreparedBody::PreparedBody(MadeBody made)
    : PreparedBody(made, pose_if_boned(made.body, rest_pose), pose_if_boned(made.body, sim::dressing_pose)) {}

PreparedBody::PreparedBody(MadeBody made, PosePointer own_pose, PosePointer dressing_pose)
    : made_(std::move(made)),
      own_pose_(std::move(own_pose)),
      dressing_pose_(std::move(dressing_pose)),
      stands_(standing(made_.body, dressing_pose_.get())),
      measured_(*stands_) {}

std::shared_ptr<const PreparedBody> PreparedBody::in_given_pose(std::shared_ptr<const Body> body) {
    return std::shared_ptr<const PreparedBody>(new PreparedBody({.body = std::move(body)}, nullptr, nullptr));
}

std::shared_ptr<const PreparedBody> PreparedBody::as_given() const {
    if (!stands_otherwise()) return nullptr;
    const std::scoped_lock lock(building_);
    if (!as_given_) as_given_.reset(new PreparedBody(made_, own_pose_, own_pose_));
    return as_given_;
}

std::shared_ptr<const BodyCollider> PreparedBody::collider(const std::function<void()>& interrupt,
                                                           const ContentStore* store) const {
    const std::scoped_lock lock(building_);
    if (!collider_) collider_ = shared_collider_of(stands_, interrupt, store);
    return collider_;
}

std::shared_ptr<const BodyCollider> PreparedBody::own_collider(const std::function<void()>& interrupt,
                                                               const ContentStore* store) const {
    if (!stands_otherwise()) return nullptr;
    const std::scoped_lock lock(building_);
    if (!own_collider_)
        own_collider_ = shared_collider_of(std::make_shared<const Body>(posed(body(), *own_pose_)), interrupt, store);
    return own_collider_;
}

bool PreparedBody::has_colliders() const {
    const std::scoped_lock lock(building_);
    return collider_ && (own_collider_ || !stands_otherwise());
}

}  // namespace selvedge::sim
