#pragma once
// Sews round thin limbs where seams would close through them. Panels that stand loosely before and behind a limb, or
// beside it, draw together in a way that may leave a part of it, such as an ankle or a hand, outside. Then the garment
// is sewn anew: the arms and legs are thin, and lie where the sleeves and trouser legs are, until the seams are closed.
// After that they grow and move to where the body has them, and push the cloth along.
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "sim/body/body.h"
#include "sim/collide/jointed_collider.h"
#include "sim/dress/sewing.h"

namespace selvedge::sim {

class BodyCollider;
class ContentStore;

class ThinLimbs {
 public:
    // Null if all seams closed and none closed through a limb, or the limbs could not be cut off.
    // interrupt, store: see BodyCollider. Pre: the run is done, and all its values are finite.
    static std::unique_ptr<ThinLimbs> plan(const SewingRun& done, const BodyCollider& body,
                                           const std::function<void()>& interrupt = {},
                                           const ContentStore* store = nullptr);

    // The number of places where the cloth of a run that is done passes through the body, or a link is open.
    static std::size_t count_faults(const SewingRun& done, const BodyCollider& body);

    // The contact options of a run with thin limbs.
    static ContactOptions contact(const ContactOptions& usual);

    // One step of a new run, which closes the seams first. Returns false when the limbs are as the body has them, or a
    // value is not finite. Pre: no call returned false.
    bool advance(SewingRun& sewing);

 private:
    struct Shapes {
        Body full;
        std::vector<Vec3d> thin;  // m
    };

    ThinLimbs(std::unique_ptr<JointedCollider> collider, std::vector<Shapes> limbs);

    void grow(double share);

    std::unique_ptr<JointedCollider> collider_;
    std::vector<Shapes> limbs_;  // by piece
    int sizes_ = 0;              // through which the limbs grow
    int steps_ = 0;              // since they began to; 0: seams are still closing
};

}  // namespace selvedge::sim
