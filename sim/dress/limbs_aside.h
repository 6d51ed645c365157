#pragma once
// Keeps the arms out of what is sewn below them. A wide skirt whose front and back stand before and behind the hands
// would close round the arms. Its panels therefore ignore the arms while the seams close and until the cloth has
// fallen. Then the arms are raised, whatever covers them with them, until they are clear of these panels, and are
// brought down again outside of them, as a person does who puts on a skirt.
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "sim/collide/jointed_collider.h"
#include "sim/dress/sewing.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"
#include "sim/place/measured_body.h"

namespace selvedge::sim {

class ContentStore;

class LimbsAside {
 public:
    // Null if no seam of these panels, unsewn and as placed, would close round an arm, or the body's arms were not
    // found. `sewing`: the mesh of the run, which may have other panels too. interrupt, store: see BodyCollider.
    static std::unique_ptr<LimbsAside> plan(const GarmentMesh& unsewn, const GarmentMesh& sewing,
                                            const Pattern& pattern, const MeasuredBody& body,
                                            const std::function<void()>& interrupt = {},
                                            const ContentStore* store = nullptr);

    // One step of the run, which closes the seams first. Returns false when the arms are where the body has them.
    // Pre: the run is of the planned mesh; no call returned false.
    bool advance(SewingRun& sewing);

 private:
    enum class Phase { Close, Fall, Raise, Lower };

    LimbsAside(std::unique_ptr<JointedCollider> collider, std::vector<bool> is_below);

    bool advance_phase(SewingRun& sewing);
    void begin(Phase phase, SewingRun& sewing);
    void turn_arms();
    bool is_clear(const SewingRun& sewing) const;
    float clear_angle(const SewingRun& sewing);

    std::unique_ptr<JointedCollider> collider_;
    std::vector<bool> is_below_;  // by vertex of the run's mesh: of a panel that ignores the arms
    bool is_ready_ = false;       // the run knows these vertices
    Phase phase_ = Phase::Close;
    float seconds_ = 0;  // since the phase began
    float angle_ = 0;    // rad, by which the arms are raised
    float raised_ = 0;   // rad, where they are clear
};

}  // namespace selvedge::sim
