#pragma once
// A garment on its way onto a body, frame by frame: its panels stand around the body, its seams close, their tension
// relaxes, and it falls until it is at rest. dress() runs one to its end, and a session runs one on its thread.
// (thesis 3.6.7, 4.2)
//
// Pattern, body and options may change at any time. A changed pattern is meshed and sewn again. If its panels, outline
// edges and seams are the same in number and kind, the cloth continues from the current drape. If garments were put
// over those that hang, they are sewn round these. Otherwise it restarts from the placed panels, and a note says why.
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sim/body/body.h"
#include "sim/collide/body_collider.h"
#include "sim/dress/anchor.h"
#include "sim/dress/drag_constraint.h"
#include "sim/dress/drape.h"
#include "sim/dress/dress_options.h"
#include "sim/dress/garment_sewing.h"
#include "sim/dress/prepared_body.h"
#include "sim/dress/sewing.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/sew.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern.h"
#include "sim/simulation/simulation.h"

namespace selvedge::sim {

// Throws InputError if the garment has layers and the options leave out the contact that keeps them in order.
void check_layers(const Pattern& pattern, const DressOptions& options);

// Throws InputError if the panels that are worn cover more than a garment can: their units are wrong, and sewing would
// take minutes or hours.
void check_size(const Pattern& pattern);

// Whether limbs get out of the way of seams that did not close round them. It takes long, and does not help a garment
// that is much too small.
enum class LimbsInTheWay { GiveWay, Stay };

class Dressing {
 public:
    // interrupt: called regularly during long operations; its exceptions propagate from any method here. store: where
    // bodies and their fields may be found and are kept; null for none. It must outlive the dressing.
    explicit Dressing(std::function<void()> interrupt = {}, const ContentStore* store = nullptr);
    Dressing(const Dressing&) = delete;
    Dressing& operator=(const Dressing&) = delete;

    // What is dressed in what. A method that throws InputError (a pattern that cannot be meshed, an unknown fabric or
    // body) changes nothing.
    void set_body(std::shared_ptr<const PreparedBody> body);  // null: none
    void set_body(std::shared_ptr<const Body> body);          // in the pose in which it is given
    void set_pattern(Pattern pattern);
    void set_options(const DressOptions& options);
    // Hidden parts of the cloth that hangs are coarsened from the next adaptation on; null: as DressOptions::seen_from
    // says. It must stay valid.
    void set_visibility(Visibility* visibility);
    void wake();  // a cloth at rest goes on
    // Added to those of the pattern, for all garments that are sewn from now on.
    void add_constraint(std::unique_ptr<ClothConstraint> constraint) { own_constraints_.add(std::move(constraint)); }

    DressingStage stage() const;
    double fraction() const;  // of Sew or of Fall, 0..1; 0 in Place and Relax

    // From Place to Sew; at a later stage it starts again. Throws InputError if there is no body, or the panels cannot
    // be meshed.
    void sew(LimbsInTheWay limbs = LimbsInTheWay::GiveWay);
    // Simulates one frame: kSewingSteps steps, or an adaptation and its steps. From Place it only begins to sew.
    // Returns whether the stage is not Done. Throws InputError if the sewn mesh is invalid; the stage is then Place.
    // Pre: the stage is not Done.
    bool advance();
    // Back to Place; removes pins and drag.
    void reset();

    // What the user should know, since the last call: panels that were moved, and why sewing starts again.
    std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

    // Panels that stand in the body, where nothing near is clear of it, since sewing began: ClearedPanels::stuck.
    // The notes tell them, too.
    const std::vector<std::string>& stuck_panels() const { return stuck_; }

    const Body* body() const { return body_ ? body_->stands().get() : nullptr; }  // in the pose in which it is dressed
    const MeasuredBody& measured() const { return body_->measured(); }            // Pre: there is a body
    const Pattern& pattern() const { return pattern_; }
    const DressOptions& options() const { return options_; }
    const Pattern& anchored();  // the pattern with its panels moved from the body that it names to this one
    GarmentMesh designed();     // the unsewn pattern where its panels were placed, round designed_for()
    const MeasuredBody&
    designed_for();                  // the body that the pattern names; made when first needed. Pre: there is a body
    const BodyCollider& collider();  // of the body; built when first needed, which is slow. Pre: there is a body
    // The same, with its body, for others to keep; null if it has not been needed.
    const std::shared_ptr<const BodyCollider>& shared_collider() const { return collider_; }

    const GarmentMesh& placed() const { return placed_; }  // for display: meshed quickly
    const Cloth* cloth() const;                            // of separate panels in Sew; null in Place
    std::span<const SeamLink> seam_links() const;          // that are closing, in Sew: vertices of the cloth

    // From Relax to Done.
    bool is_hanging() const { return drape_.has_value(); }
    const GarmentMesh& sewn_mesh() const { return drape_->mesh; }             // level 0, as it was sewn
    const std::vector<OpenSeam>& open_seams() const { return drape_->open; }  // that did not close, ascending
    const DrapeResult& result() const { return drape_->run->result(); }
    void clear_times() { drape_->run->clear_times(); }  // see DrapeRun
    // Takes the simulation away. Afterwards only what was dressed, and its result, may be asked. Pre: Done.
    Simulation take_simulation();
    bool falls() const { return drape_ && drape_->run->falls(); }
    bool hangs() const { return drape_ && drape_->run->hangs(); }
    bool hangs_calmly() const { return drape_ && drape_->run->hangs_calmly(); }
    bool takes_too_much_work() const { return drape_ && drape_->run->takes_too_much_work(*cloth()); }
    void give_up(GiveUp why) { drape_->run->give_up(drape_->simulation, why); }  // Pre: Relax or Fall, and see DrapeRun
    void reactivate();                                                           // a drape at rest falls on
    double simulated_seconds() const;                                            // since sewing began

    // Dragging and pinning of the cloth that hangs. Each returns whether anything has changed: false at other stages,
    // if nothing is dragged or pinned, or the goal is the same.
    bool pull(const MaterialPoint& at, const Vec3f& to);
    bool pull_to(const Vec3f& to);
    bool let_go();
    bool pin(const MaterialPoint& at);
    bool unpin_all();
    bool is_pulled() const { return drag_constraint_.is_pulling(); }
    std::vector<Vec3f> pins() const;  // m
    // The vertices of the cloth that are pinned at these points. Pre: is_hanging(), and not is_pulled().
    std::vector<VertexId> pinned_vertices();

    // A drape that can be restored later. Pre: is_hanging().
    struct Drape {
        Simulation simulation;
        Pattern pattern;              // that it was meshed from ...
        MeshOptions meshing;          // ... and how
        GarmentMesh mesh;             // sewn
        std::vector<OpenSeam> open;   // ascending
        std::optional<DrapeRun> run;  // never empty
    };
    const Drape& drape() const { return *drape_; }
    // Returns false, and changes nothing, if the base mesh of the pattern is another now. Pre: there is a body.
    bool restore(const Drape& drape);

 private:
    void begin_sewing(std::optional<WornGarments> worn, LimbsInTheWay limbs = LimbsInTheWay::GiveWay);
    void take_sewing_notes();
    bool sew_over();
    void end_sewing();
    void hang(Drape drape, double relax_time);
    void apply_options();
    void update_drag();
    bool has_bad_number() const { return drape_ && drape_->run->result().bad_vertex; }
    std::vector<Fabric> fabrics() const;
    ClothConstraints constraints() const;
    int deepest_level() const { return options_.deepest_level.value_or(options_.max_level); }

    void take_body();
    void place();
    void clear();
    const AnchoredPattern& anchor();
    void take_pattern(const Pattern& last);
    void change_cloth(const Pattern& pattern);
    void change_outlines(const Pattern& pattern);
    void start_again(const std::string& why);
    MeshOptions meshing() const;

    std::function<void()> interrupt_;
    const ContentStore* store_ = nullptr;
    DressOptions options_;
    Pattern pattern_;  // the newest one that can be meshed
    std::optional<AnchoredPattern> anchored_;
    std::shared_ptr<const PreparedBody> body_;
    std::shared_ptr<const BodyCollider> collider_;  // of it, or of one with an equal surface; null until it is needed
    PatternAnchor anchor_{store_};

    PanelMeshCache quick_meshes_, meshes_;
    GarmentMesh placed_;
    std::optional<GarmentSewing> sewing_;
    std::optional<Drape> drape_;
    DragConstraint drag_constraint_;
    ClothConstraints own_constraints_;
    Visibility* visibility_ = nullptr;  // instead of what the options say
    double past_seconds_ = 0;           // s, simulated before the current drape
    std::vector<std::string> notes_, stuck_;
};

// The options of the simulation of a garment that is dressed with these, and of its drape.
SimulationOptions simulation_options(const DressOptions& options);
DrapeOptions drape_options(const DressOptions& options);

inline constexpr int kSewingSteps = 4;  // per frame, as many as per adaptation

// One fabric per panel: `shell`, the panel's own or else the pattern's, with the panel's interlinings. Throws
// InputError for an unknown fabric, and as bonded() does.
std::vector<Fabric> fabrics_of(const Pattern& pattern, const std::optional<Fabric>& shell = {});

}  // namespace selvedge::sim
