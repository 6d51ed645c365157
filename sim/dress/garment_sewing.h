#pragma once
// Sews the garments of a pattern onto the body one after the other, from the innermost to the outermost. Each is worn
// before the next one is placed round it: its seams are closed, and their tension has relaxed. What is worn stays cloth
// while the next one is sewn, and contact keeps that one outside.
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/dress/limb_detour.h"
#include "sim/dress/sewing.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/garments.h"
#include "sim/simulation/simulation.h"

namespace selvedge::sim {

class BodyCollider;

// The inner garments, if they are worn already: sewn, at the positions where they hang.
struct WornGarments {
    std::size_t count = 0;
    SewingResult result;  // its mesh has the triangles of their panels, as they are meshed unsewn
};

class GarmentSewing {
 public:
    // Plans what to do with arms in the way of panels (plan_raised_arms).
    using PlanLimbs = std::function<std::unique_ptr<LimbDetour>(const GarmentMesh& unsewn, const GarmentMesh& sewing)>;

    // `unsewn`: all panels of the garments, where they are placed. Moves panels to where they can be sewn
    // (make_sewable). Several garments are always kept apart, whatever the options say. Pre: not all of them are worn.
    GarmentSewing(GarmentMesh unsewn, std::vector<Garment> garments, std::vector<Fabric> fabrics,
                  const BodyCollider& body, SewingOptions options, PlanLimbs plan_limbs = {},
                  std::optional<WornGarments> worn = {});

    // One step. Returns false when all garments are sewn, or a value is not finite. Pre: no call returned false.
    bool advance(const BodyCollider& body);

    double fraction() const;
    const Cloth& cloth() const { return relaxing_ ? relaxing_->cloth() : run_->cloth(); }  // of the garments so far
    std::span<const SeamLink> links() const;                                     // that are closing, of the cloth
    std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }  // panels that were moved
    std::vector<std::string> take_stuck() { return std::exchange(stuck_, {}); }  // ClearedPanels::stuck
    SewingResult result() &&;                                                    // of all garments

 private:
    void take_worn(WornGarments worn);
    void map_sewn_vertices();
    GarmentMesh place_next(const BodyCollider& body);
    void start_next(const BodyCollider& body);
    void start_run(GarmentMesh unsewn);
    bool sew_again(const BodyCollider& body);
    bool has_too_much_work() const;
    void take_better(const BodyCollider& body, bool is_endless);
    void wear();
    void relax(const BodyCollider& body);
    bool is_last() const { return next_ == garments_.size(); }

    GarmentMesh unsewn_;  // where its panels are now, also those that are worn
    std::vector<Garment> garments_;
    std::vector<Fabric> fabrics_;
    SewingOptions options_;
    PlanLimbs plan_limbs_;
    std::vector<bool> is_worn_;             // per panel
    std::size_t next_ = 0;                  // garment
    std::vector<int> sewn_vertex_;          // per vertex of unsewn_ that is worn: its vertex in the cloth; others -1
    std::optional<SewingRun> run_;          // of the garment before next_
    std::unique_ptr<LimbDetour> detour_{};  // of that run; null: no limb is in the way
    std::optional<SewingRun> first_run_{};  // without a detour, if its seams closed through limbs
    std::optional<Simulation> relaxing_;    // the garments so far, when it is done
    double relaxed_ = 0;                    // s
    SewingResult done_;                     // of the garments so far
    std::vector<std::string> notes_, stuck_;
};

}  // namespace selvedge::sim
