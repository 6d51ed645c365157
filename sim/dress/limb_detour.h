#pragma once
// Limbs that get out of the way of a garment while it is sewn, and come back with the cloth on them. A detour changes
// the collider of one run, in stages, and ends where the body has its limbs. There are two kinds:
// - Raised arms keep out of what is sewn below them. A wide skirt whose front and back stand before and behind the
//   hands would close round the arms. Its panels therefore ignore the arms while the seams close and until the cloth
//   has fallen. Then the arms are raised, whatever covers them with them, until they are clear of these panels, and
//   are brought down again outside of them, as a person does who puts on a skirt.
// - Thin limbs are for a garment that is sewn anew because seams closed through a limb. Panels that stand loosely
//   before and behind a limb, or beside it, draw together in a way that may leave a part of it, such as an ankle or a
//   hand, outside. So the arms and legs are thin, and lie where the sleeves and trouser legs are, until the seams are
//   closed: first those that make tubes of sleeves, cuffs and trouser legs round them, then all others. After that they
//   grow and move to where the body has them, and push the cloth along.
#include <compare>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "sim/collide/body_collider.h"
#include "sim/collide/jointed_collider.h"
#include "sim/dress/sewing.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern.h"
#include "sim/place/limbs.h"
#include "sim/place/measured_body.h"

namespace selvedge::sim {

class ContentStore;

// For one run: the stages keep how far they are.
class LimbDetour {
 public:
    // One step of a run with these limbs, that many seconds after the stage began. Returns false when the stage is
    // over.
    using Stage = std::function<bool(SewingRun&, JointedCollider&, float seconds)>;

    struct Plan {
        std::unique_ptr<JointedCollider> limbs;  // as they are while the seams close
        std::vector<bool> trunk_only;            // SewingRun::meet_trunk_only, from the beginning; may be empty
        std::vector<bool> first_links;           // SewingRun::close_first; may be empty
        float sample_spacing = std::numeric_limits<float>::infinity();  // m, of contact at most
        std::vector<Stage> way_back;                                    // after the seams have closed
    };
    explicit LimbDetour(Plan plan) : plan_(std::move(plan)) {}

    // The run that takes the detour. Pre: `unsewn` is the mesh of the run that it was planned for.
    SewingRun start(GarmentMesh unsewn, const std::vector<Fabric>& fabrics, SewingOptions options) const;
    // One step of it: of the closing of its seams first. Returns false when the limbs are where the body has them, or a
    // value is not finite. Pre: no call returned false.
    bool advance(SewingRun& run);

 private:
    Plan plan_;
    std::size_t stage_ = 0;  // of the way back, from 1 on; 0: the seams are closing
    float seconds_ = 0;      // since it began
};

// Null if no seam of the panels `unsewn`, as placed, would close round an arm, or the body's arms were not found.
// `sewing`: the mesh of the run, which may have other panels too. interrupt, store: see BodyCollider.
std::unique_ptr<LimbDetour> plan_raised_arms(const GarmentMesh& unsewn, const GarmentMesh& sewing,
                                             const Pattern& pattern, const MeasuredBody& body,
                                             const std::function<void()>& interrupt = {},
                                             const ContentStore* store = nullptr);

// Null if all seams closed, none closed through a limb, and each arm and leg leaves the garment through the opening
// that it would leave through where the panels were placed; or if the limbs could not be cut off. Pre: the run is done,
// and all its values are finite.
std::unique_ptr<LimbDetour> plan_thin_limbs(const SewingRun& done, const BodyCollider& body, const BodyLimbs& limbs,
                                            const std::function<void()>& interrupt = {},
                                            const ContentStore* store = nullptr);

// What is wrong with a run that is done: the arms and legs that leave it through a wrong opening, and the places where
// its cloth passes through the body, or a link is open. Fewer missed limbs are better, whatever the places.
struct SewingFaults {
    std::size_t missed_limbs = 0;
    std::size_t places = 0;

    auto operator<=>(const SewingFaults&) const = default;
};
SewingFaults count_sewing_faults(const SewingRun& done, const BodyCollider& body, const BodyLimbs& limbs);

}  // namespace selvedge::sim
