#include "sim/dress/dressing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>

#include "sim/cloth/contact_surface.h"
#include "sim/cloth/solver_state.h"
#include "sim/core/assert.h"
#include "sim/core/error.h"
#include "sim/dress/carry_over.h"
#include "sim/dress/limb_detour.h"
#include "sim/pattern/field_moves.h"
#include "sim/place/placement.h"
#include "sim/simulation/elastic_bands.h"

namespace selvedge::sim {
namespace {

constexpr double kShortRelax = 0.2;    // s, after a change of outlines
constexpr float kDeepestMove = 0.03F;  // m: if a new body overlaps the drape by more than this, sewing starts again

bool has_equal_surface(const Body& a, const Body& b) {
    return a.x == b.x && a.triangles == b.triangles;
}

bool is_placed_otherwise(const Pattern& a, const Pattern& b) {
    return !std::ranges::equal(a.panels, b.panels, has_same_placement);
}

}  // namespace

std::vector<Fabric> fabrics_of(const Pattern& pattern, const std::optional<Fabric>& shell) {
    std::vector<Fabric> fabrics;
    for (const Panel& panel : pattern.panels) {
        std::vector<Fabric> interlinings;
        for (const std::string& name : panel.interlinings) interlinings.push_back(find_fabric(name));
        const Fabric own = shell ? *shell : find_fabric(panel.fabric.empty() ? pattern.fabric : panel.fabric);
        fabrics.push_back(bonded(own, interlinings, "panel '" + panel.name + "'"));
    }
    return fabrics;
}

Dressing::Dressing(std::function<void()> interrupt, const ContentStore* store)
    : interrupt_(std::move(interrupt)), store_(store) {}

DressingStage Dressing::stage() const {
    if (sewing_) return DressingStage::Sew;
    if (!drape_) return DressingStage::Place;
    switch (drape_->run->phase()) {
        case DrapePhase::Relax:
            return DressingStage::Relax;
        case DrapePhase::Fall:
        case DrapePhase::Finish:
            return DressingStage::Fall;
        case DrapePhase::Done:
            break;
    }
    return DressingStage::Done;
}

double Dressing::fraction() const {
    if (sewing_) return sewing_->fraction();
    return drape_ ? std::min(1.0, drape_->run->fraction()) : 0;
}

const Cloth* Dressing::cloth() const {
    if (sewing_) return &sewing_->cloth();
    return drape_ ? &drape_->simulation.cloth() : nullptr;
}

std::span<const SeamLink> Dressing::seam_links() const {
    return sewing_ ? sewing_->links() : std::span<const SeamLink>();
}

double Dressing::simulated_seconds() const {
    return past_seconds_ + (drape_ ? drape_->run->result().simulated_seconds : 0);
}

bool Dressing::advance() {
    switch (stage()) {
        case DressingStage::Place:
            sew();
            return true;
        case DressingStage::Sew:
            for (int i = 0; i < kSewingSteps && sewing_; ++i) {
                if (!sewing_->advance(collider())) end_sewing();
            }
            break;
        case DressingStage::Relax:
        case DressingStage::Fall:
            update_drag();
            drape_->run->advance(drape_->simulation, collider());
            break;
        case DressingStage::Done:
            SELVEDGE_ASSERT(false);
    }
    return stage() != DressingStage::Done;
}

void check_layers(const Pattern& pattern, const DressOptions& options) {
    if (options.self_collision) return;
    if (garments_of(pattern).size() > 1)
        throw InputError("", "", "garments that are worn over each other need contact of the cloth with itself");
    for (const Panel& panel : pattern.panels) {
        if (panel.layer != pattern.panels.front().layer)
            throw InputError("", "", "layers ('" + panel.name + "') need contact of the cloth with itself");
    }
}

void check_size(const Pattern& pattern) {
    constexpr double kLargest = 50;  // m^2: a ball gown over its petticoats takes 25, a sari 10
    double area = 0;                 // m^2, inside the straight lines between the corners
    for (const Panel& panel : pattern.panels) {
        if (!panel.is_worn) continue;
        double twice = 0;
        for (std::size_t v = 0; v < panel.vertices.size(); ++v)
            twice += cross2(panel.vertices[v], panel.vertices[(v + 1) % panel.vertices.size()]);
        area += std::abs(twice) / 2;
    }
    if (area > kLargest)
        throw InputError(pattern.name, "panels",
                         "they cover " + std::to_string(std::llround(area)) + " square metres, and a garment at most " +
                             std::to_string(std::llround(kLargest)) + ": is units_in_meter right?");
}

void Dressing::sew(LimbsInTheWay limbs) {
    if (!body_) throw InputError("", "", "there is no body to put it on");
    check_layers(pattern_, options_);
    check_size(pattern_);
    begin_sewing({}, limbs);
    past_seconds_ = 0;
}

void Dressing::begin_sewing(std::optional<WornGarments> worn, LimbsInTheWay limbs) {
    GarmentMesh unsewn = assemble(anchored(), meshing(), meshes_);
    SewingOptions options{.simulation = simulation_options(options_),
                          .constraints = constraints(),
                          .interrupt = interrupt_,
                          .store = store_,
                          .limbs = {},
                          .body = {body_, &measured()}};
    if (limbs == LimbsInTheWay::GiveWay) options.limbs = {body_, &measured().limbs()};
    GarmentSewing sewing(
        std::move(unsewn), garments_of(anchored()), fabrics(), collider(), std::move(options),
        [this](const GarmentMesh& next, const GarmentMesh& all) {
            return plan_raised_arms(next, all, anchored(), measured(), interrupt_, store_);
        },
        std::move(worn));
    clear();
    stuck_.clear();
    sewing_.emplace(std::move(sewing));
    std::ranges::copy(anchored_->notes, std::back_inserter(notes_));
    take_sewing_notes();
}

void Dressing::take_sewing_notes() {
    std::ranges::move(sewing_->take_notes(), std::back_inserter(notes_));
    for (std::string& stuck : sewing_->take_stuck()) {
        notes_.push_back(stuck);
        stuck_.push_back(std::move(stuck));
    }
}

// What the pattern asks for, and what was added besides.
ClothConstraints Dressing::constraints() const {
    ClothConstraints all = own_constraints_;
    if (has_elastics(pattern_)) all.add(std::make_unique<ElasticBands>(pattern_));
    return all;
}

// Sews garments that were put over those that hang round them. Returns whether there are such.
bool Dressing::sew_over() {
    if (!drape_ || has_bad_number() || !options_.self_collision || drape_->meshing != meshing()) return false;
    const std::size_t count = count_worn_under(drape_->pattern, pattern_);
    if (count == 0) return false;
    const double seconds = simulated_seconds();
    SewingResult result{.sewn = drape_->mesh, .open = drape_->open, .simulated_seconds = seconds, .bad_vertex = {}};
    for (std::size_t v = 0; v < result.sewn.x.size(); ++v)
        result.sewn.x[v] = drape_->simulation.cloth().x[v].head<3>().cast<double>();
    begin_sewing(WornGarments{.count = count, .result = std::move(result)});
    past_seconds_ = seconds;
    return true;
}

void Dressing::end_sewing() {
    take_sewing_notes();
    SewingResult sewing = std::move(*sewing_).result();
    sewing_.reset();
    past_seconds_ = sewing.simulated_seconds;
    Cloth cloth = make_cloth(sewing.sewn, fabrics(), {.max_level = deepest_level()});
    hang({.simulation = Simulation(std::move(cloth), simulation_options(options_)),
          .pattern = anchored(),
          .meshing = meshing(),
          .mesh = std::move(sewing.sewn),
          .open = std::move(sewing.open),
          .run = {}},
         DrapeOptions{}.relax_time);
    change_cloth(anchored());  // setts may have been moved while it was sewn
}

SimulationOptions simulation_options(const DressOptions& options) {
    SimulationOptions common;
    if (!options.has_gravity) common.gravity.setZero();
    if (options.self_collision) common.self_contact.emplace();
    common.adapt.criteria = options.criteria;
    common.adapt.curvature = options.curvature;
    common.adapt.shortest_edge = static_cast<float>(options.shortest_edge);
    common.adapt.max_level = options.max_level;
    common.triangle_budget = options.triangle_budget;
    common.seen_from = options.seen_from;
    return common;
}

DrapeOptions drape_options(const DressOptions& options) {
    return {.max_seconds = options.max_seconds,
            .finish_time = options.finish_time,
            .may_rest = options.may_rest,
            .most_work = options.most_work};
}

void Dressing::hang(Drape drape, double relax_time) {
    drape_ = std::move(drape);
    drape_->simulation.set_constraints(constraints());
    drag_constraint_.forget_vertices();
    DrapeOptions options = drape_options(options_);
    options.relax_time = relax_time;
    options.coarse_time = std::min(options.coarse_time, relax_time - DrapeOptions{}.coarse_time);
    drape_->run.emplace(drape_->simulation, options);
    apply_options();
}

// The simulation asks this object for the vertices that it drags.
void Dressing::apply_options() {
    if (!drape_) return;
    DrapeOptions& options = drape_->run->options();
    const double relax_time = options.relax_time, coarse_time = options.coarse_time;
    options = drape_options(options_);
    options.relax_time = relax_time;
    options.coarse_time = coarse_time;
    Simulation& simulation = drape_->simulation;
    simulation.set_options(simulation_options(options_));
    simulation.set_visibility(visibility_);
    simulation.keep(drag_constraint_.held());
    simulation.lead([this](const Cloth& cloth, float seconds) {
        return drag_constraint_.kinematic_target(cloth, collider(), seconds);
    });
}

void Dressing::update_drag() {
    Simulation& simulation = drape_->simulation;
    const bool is_other = drag_constraint_.update_held(simulation.cloth(), drape_->mesh.pins);
    const bool goes_elsewhere = drag_constraint_.take_goal_change();
    simulation.keep(drag_constraint_.held());
    if (is_other || goes_elsewhere) drape_->run->reactivate(simulation);
}

Simulation Dressing::take_simulation() {
    drape_->simulation.release();
    return std::move(drape_->simulation);
}

void Dressing::reactivate() {
    if (drape_) drape_->run->reactivate(drape_->simulation);
}

// Body.

void Dressing::set_body(std::shared_ptr<const Body> body) {
    if (body_ && body == body_->stands()) return;
    set_body(body ? PreparedBody::in_given_pose(std::move(body)) : nullptr);
}

void Dressing::set_body(std::shared_ptr<const PreparedBody> body) {
    if (body == body_) return;
    const bool is_same = body && body_ && has_equal_surface(*body->stands(), *body_->stands());
    const std::shared_ptr<const PreparedBody> last = std::exchange(body_, std::move(body));
    if (is_same) {  // collider_ is that of the previous one, which is equal, or null
        if (anchored_ && anchored_->designed_for == &last->measured()) anchored_->designed_for = &body_->measured();
        return;
    }
    const auto last_collider = std::exchange(collider_, nullptr);
    std::optional<AnchoredPattern> last_anchored = std::exchange(anchored_, std::nullopt);
    try {
        take_body();
    } catch (...) {
        body_ = last;
        collider_ = last_collider;
        anchored_ = std::move(last_anchored);
        throw;
    }
}

void Dressing::take_body() {
    if (sewing_) return start_again("");
    if (!drape_) return place();
    if (has_bad_number()) return;
    if (!body_) return start_again("there is no body: the panels are back where they are placed");
    forget_contacts(drape_->simulation.cloth());
    float deepest = 0;
    for (const VertexId v : drape_->simulation.cloth().mesh.leaf_vertices())
        deepest = std::max(deepest, -collider().contact(drape_->simulation.cloth().x[v.value].head<3>()).distance);
    if (deepest > kDeepestMove) return start_again("the body is another: sewn anew from where the panels are placed");
    reactivate();
}

const BodyCollider& Dressing::collider() {
    SELVEDGE_ASSERT(body_ || collider_);
    if (!collider_) collider_ = body_->collider(interrupt_, store_);
    return *collider_;
}

// Panels that were placed for another body move with this one.
const AnchoredPattern& Dressing::anchor() {
    if (!anchored_)
        anchored_ = body_ ? anchor_.anchor(pattern_, measured()) : AnchoredPattern{pattern_, pattern_, nullptr, {}};
    return *anchored_;
}

const Pattern& Dressing::anchored() {
    return anchor().pattern;
}

const MeasuredBody& Dressing::designed_for() {
    SELVEDGE_ASSERT(body_);
    return *anchor().designed_for;
}

// Pattern.

MeshOptions Dressing::meshing() const {
    MeshOptions meshing = options_.mesh;
    const std::optional<double>& requested = options_.edge_length ? options_.edge_length : pattern_.edge_length;
    meshing.target_edge = requested.value_or(meshing.target_edge);
    return meshing;
}

std::vector<Fabric> Dressing::fabrics() const {
    return fabrics_of(pattern_, options_.fabric);
}

GarmentMesh Dressing::designed() {
    return assemble(anchor().designed, meshing(), meshes_);
}

// The quick mesh is for display only, so its quality is not relaxed.
void Dressing::place() {
    MeshOptions quick = meshing();
    quick.relaxations = 0;
    placed_ = assemble(anchored(), quick, quick_meshes_);
}

void Dressing::set_pattern(Pattern pattern) {
    Pattern last = std::exchange(pattern_, std::move(pattern));
    std::optional<AnchoredPattern> last_anchored = std::exchange(anchored_, std::nullopt);
    try {
        fabrics();
        take_pattern(last);
    } catch (...) {
        pattern_ = std::move(last);
        anchored_ = std::move(last_anchored);
        throw;
    }
}

void Dressing::take_pattern(const Pattern& last) {
    const PatternChange change = compare(drape_ ? drape_->pattern : last, pattern_);
    if (drape_ && !has_bad_number() && change != PatternChange::Kind) {
        if (change == PatternChange::Outlines) change_outlines(anchored());
        change_cloth(anchored());
        return;
    }
    if (change == PatternChange::Kind && sew_over()) return;
    if (sewing_ && change <= PatternChange::Setts && !is_placed_otherwise(last, pattern_)) return;
    const std::string why =
        drape_ && change == PatternChange::Kind ? restart_reason(drape_->pattern, pattern_) : std::string();
    place();
    if (drape_ || sewing_) start_again(why);
}

// Applies fabrics, grain and setts to the current cloth.
void Dressing::change_cloth(const Pattern& pattern) {
    Cloth& cloth = drape_->simulation.cloth();
    std::vector<Fabric> fabrics = this->fabrics();
    const bool is_other_cloth =
        compare(drape_->pattern, pattern) == PatternChange::Fabrics || fabrics != cloth.material.fabrics;
    cloth.material.fabrics = std::move(fabrics);
    cloth.material.sett_offsets.clear();
    std::vector<int> layers;
    for (const Panel& panel : pattern.panels) layers.push_back(panel.layer);
    if (layers != cloth.material.layers) {
        cloth.material.layers = std::move(layers);
        cloth.solver->self_contact->has_surface = false;
        reactivate();
    }
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        cloth.material.grain_angles[p] = static_cast<float>(pattern.panels[p].grain_angle);
        cloth.material.sett_offsets.push_back(pattern.panels[p].sett_offset.cast<float>());
    }
    drape_->pattern = pattern;
    if (!is_other_cloth) return;
    refresh_solver(cloth);
    refresh_contacts(cloth);  // updates friction
    reactivate();
}

void Dressing::change_outlines(const Pattern& pattern) {
    GarmentMesh unsewn = assemble(anchored(), meshing(), meshes_);
    TransferredDrape over =
        transfer_drape({drape_->simulation.cloth(), drape_->pattern, drape_->open}, pattern, std::move(unsewn),
                       fabrics(), collider(), simulation_options(options_), deepest_level());
    past_seconds_ += drape_->run->result().simulated_seconds;
    std::vector<OutlineMap> maps;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p)
        maps.emplace_back(drape_->pattern.panels[p], pattern.panels[p]);
    drag_constraint_.map_anchors([&](const MaterialPoint& at) {
        return MaterialPoint{at.panel, maps[at.panel](at.u.cast<double>()).cast<float>()};
    });
    hang({.simulation = std::move(over.simulation),
          .pattern = pattern,
          .meshing = meshing(),
          .mesh = std::move(over.mesh),
          .open = std::move(over.open),
          .run = {}},
         kShortRelax);
}

void Dressing::start_again(const std::string& why) {
    reset();
    if (!why.empty()) notes_.push_back(why);
}

void Dressing::reset() {
    place();  // first: it may throw
    clear();
}

void Dressing::clear() {
    sewing_.reset();
    drape_.reset();
    drag_constraint_ = {};
}

// Options.

void Dressing::set_options(const DressOptions& options) {
    if (options == options_) return;
    const MeshOptions last_meshing = meshing();
    const DressOptions last = std::exchange(options_, options);
    try {
        if (meshing() != last_meshing) {
            if (drape_ && !has_bad_number()) {
                change_outlines(anchored());
            } else if (sewing_) {
                start_again("");
            } else {
                place();
            }
        }
    } catch (...) {
        options_ = last;
        throw;
    }
    apply_options();
    if (!drape_) return;
    if (options_.fabric != last.fabric) change_cloth(drape_->pattern);
    wake();
}

void Dressing::set_visibility(Visibility* visibility) {
    if (visibility == visibility_) return;
    visibility_ = visibility;
    apply_options();
    wake();
}

void Dressing::wake() {
    if (!drape_ || has_bad_number()) return;
    selvedge::sim::reactivate(drape_->simulation.cloth());
    reactivate();
}

// Dragging and pinning.

bool Dressing::pull(const MaterialPoint& at, const Vec3f& to) {
    if (!drape_ || has_bad_number() || !to.allFinite()) return false;
    drag_constraint_.pull(at, to);
    reactivate();
    return true;
}

bool Dressing::pull_to(const Vec3f& to) {
    if (!to.allFinite() || !drag_constraint_.pull_to(to)) return false;
    reactivate();
    return true;
}

bool Dressing::let_go() {
    if (!drag_constraint_.is_pulling()) return false;
    drag_constraint_.let_go();
    reactivate();
    return true;
}

bool Dressing::pin(const MaterialPoint& at) {
    if (!drape_ || has_bad_number()) return false;
    drag_constraint_.pin(at);
    drag_constraint_.update_held(drape_->simulation.cloth(), drape_->mesh.pins);
    return true;
}

bool Dressing::unpin_all() {
    if (!drag_constraint_.has_pins()) return false;
    drag_constraint_.unpin_all();
    reactivate();
    return true;
}

std::vector<Vec3f> Dressing::pins() const {
    return drape_ ? drag_constraint_.pin_positions(drape_->simulation.cloth()) : std::vector<Vec3f>();
}

std::vector<VertexId> Dressing::pinned_vertices() {
    drag_constraint_.update_held(drape_->simulation.cloth(), drape_->mesh.pins);
    const std::span<const VertexId> held = drag_constraint_.held();
    return {held.begin(), held.end()};
}

// Equal outlines, sampled and meshed with equal options, have equal meshes.
bool Dressing::restore(const Drape& drape) {
    if (compare(drape.pattern, pattern_) >= PatternChange::Outlines || drape.meshing != meshing()) return false;
    collider();
    Drape copy = drape;
    clear();
    drape_ = std::move(copy);
    forget_contacts(drape_->simulation.cloth());
    drag_constraint_.free_all(drape_->simulation.cloth(), drape_->mesh.pins);
    apply_options();
    change_cloth(anchored());
    return true;
}

}  // namespace selvedge::sim
