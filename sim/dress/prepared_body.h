#pragma once
// Bodies made from a text or a file, with what is known of where they came from (MadeBody), and ready to be dressed, as
// often as one likes (PreparedBody): how one stands while it is dressed and afterwards, its measures, and its
// colliders.
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/body/pose.h"
#include "sim/collide/body_collider.h"
#include "sim/core/content_store.h"
#include "sim/mannequin/mannequin.h"
#include "sim/place/measured_body.h"
#include "sim/repair/load_body.h"

namespace selvedge::sim {

// A body with what is known of where it came from, for whoever dresses, moves or draws it.
struct MadeBody {
    std::string source{};  // "mannequin:sex=female,bust=92", or a file; empty: made of what has no text
    std::shared_ptr<const Body> body{};
    std::vector<std::string> notes{};             // one sentence per deviation from what was asked for, or per change
    std::optional<MannequinReadings> readings{};  // of a mannequin
    std::vector<Clip> clips{};                    // motions of its file
};

// From the text of a mannequin, or a file. store: where it may be found and is kept; null for none. Throws InputError
// as parse_mannequin(), make_mannequin() and load_moving_body() do.
MadeBody make_body(const std::string& source, const LoadBodyOptions& load = {}, const ContentStore* store = nullptr);

// A mannequin; its source is empty. Reads no file.
MadeBody make_body(const MannequinOptions& options, const ContentStore* store = nullptr);

// Several threads may ask at the same time.
class PreparedBody {
 public:
    // Finds how it stands, which is quick. made.body: not null.
    explicit PreparedBody(MadeBody made);
    PreparedBody(const PreparedBody&) = delete;
    PreparedBody& operator=(const PreparedBody&) = delete;

    // One that is dressed in the pose in which it is given, whatever its arms do. body: not null.
    static std::shared_ptr<const PreparedBody> in_given_pose(std::shared_ptr<const Body> body);
    // The same body, dressed in its own pose; null if it is anyway. Made when first asked for.
    std::shared_ptr<const PreparedBody> as_given() const;

    const MadeBody& made() const { return made_; }
    const Body& body() const { return *made_.body; }  // in its own pose
    // In the pose in which it is dressed: the same body if that is its own pose.
    const std::shared_ptr<const Body>& stands() const { return stands_; }
    bool stands_otherwise() const { return stands_ != made_.body; }
    // Its own pose, and that in which it is dressed, which is the same one for as_given(); null for a body without
    // bones, or one in_given_pose().
    const std::shared_ptr<const Pose>& own_pose() const { return own_pose_; }
    const std::shared_ptr<const Pose>& dressing_pose() const { return dressing_pose_; }
    const MeasuredBody& measured() const { return measured_; }  // stands()

    // The collider of stands(), which it keeps alive. It is built when first asked for, which takes up to seconds.
    // interrupt: called regularly meanwhile; its exceptions propagate, and the next caller builds it. store: where the
    // body's field may be found and is kept; null for none.
    std::shared_ptr<const BodyCollider> collider(const std::function<void()>& interrupt = {},
                                                 const ContentStore* store = nullptr) const;
    // The same of body(), as move_to_own_pose() leaves it; null if it is dressed in its own pose.
    std::shared_ptr<const BodyCollider> own_collider(const std::function<void()>& interrupt = {},
                                                     const ContentStore* store = nullptr) const;
    // Whether all of them are built that dressing needs.
    bool has_colliders() const;

 private:
    using PosePointer = std::shared_ptr<const Pose>;
    PreparedBody(MadeBody made, PosePointer own_pose, PosePointer dressing_pose);

    MadeBody made_;
    PosePointer own_pose_, dressing_pose_;
    std::shared_ptr<const Body> stands_;
    MeasuredBody measured_;
    mutable std::mutex building_;
    mutable std::shared_ptr<const BodyCollider> collider_, own_collider_;
    mutable std::shared_ptr<const PreparedBody> as_given_;
};

}  // namespace selvedge::sim
