#include "sim/dress/session_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "sim/core/error.h"
#include "sim/core/math.h"
#include "sim/dress/carry_over.h"
#include "sim/dress/dress.h"
#include "sim/dress/report.h"
#include "sim/dress/session_frame.h"
#include "sim/pattern/pattern.h"
#include "sim/place/placement.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kTimedFrames = 30;
constexpr std::size_t kMostMessages = 50;
constexpr int kSewingSteps = 4;  // per frame, as many as per adaptation

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double sum_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum;
}

std::vector<std::string> names_of(const Pattern& pattern) {
    std::vector<std::string> names;
    for (const Panel& panel : pattern.panels) names.push_back(panel.name);
    return names;
}

}  // namespace

void FrameTimes::note(const SessionTimes& frame) {
    if (last_.size() < kTimedFrames) {
        last_.push_back(frame);
    } else {
        last_[next_] = frame;
    }
    next_ = (next_ + 1) % kTimedFrames;
}

SessionTimes FrameTimes::medians() const {
    const auto median = [&](double SessionTimes::*part) {
        std::vector<double> values;
        for (const SessionTimes& one : last_) values.push_back(one.*part);
        return quantile(values, 0.5);
    };
    return {median(&SessionTimes::adaptation), median(&SessionTimes::steps), median(&SessionTimes::frame)};
}

SessionRun::SessionRun(std::function<void()> interrupt) : interrupt_(std::move(interrupt)) {}

bool SessionRun::moves() const {
    return is_running_ && (stage_ == SessionStage::Sewing || stage_ == SessionStage::Draping);
}

double SessionRun::frame_seconds() const {
    return kSewingSteps * StepOptions{}.substeps * static_cast<double>(ClothOptions{}.substep);
}

void SessionRun::start() {
    is_running_ = has_changed_ = true;
    if (stage_ == SessionStage::Placed || stage_ == SessionStage::Failed) begin_sewing();
}

void SessionRun::pause() {
    is_running_ = false;
    has_changed_ = true;
}

void SessionRun::say(std::string message) {
    if (messages_.size() == kMostMessages) messages_.erase(messages_.begin());
    messages_.push_back(std::move(message));
    has_changed_ = true;
}

void SessionRun::fail(const std::string& problem) {
    stage_ = SessionStage::Failed;
    is_running_ = false;
    has_changed_ = true;
    problem_ = problem;
}

void SessionRun::advance() {
    const auto start = Clock::now();
    has_changed_ = true;
    SessionTimes times;
    if (stage_ == SessionStage::Sewing) {
        try {
            sew_frame();
        } catch (const InputError& error) {  // invalid seams
            sewing_.reset();
            fail(error.what());
        }
        times.steps = ms_since(start);
    } else {
        drape_frame();
        if (drape_) {
            times.adaptation = sum_of(drape_->run->result().adaptation_ms);
            times.steps = sum_of(drape_->run->result().step_ms);
            drape_->run->clear_times();
        }
    }
    times.frame = ms_since(start);
    times_.note(times);
}

bool SessionRun::may_prepare() const {
    return body_ && !met_ && stage_ == SessionStage::Placed;
}

// Sewing.

void SessionRun::begin_sewing() {
    clear_drape();
    problem_.clear();
    if (!body_) return fail("there is no body to put it on");
    ensure_collider();
    try {
        GarmentMesh unsewn = unsewn_mesh();
        for (std::string& note : make_sewable(unsewn, met_->collider)) say(std::move(note));
        sewing_.emplace(std::move(unsewn), fabrics_of(pattern_), SewingOptions{});
    } catch (const InputError& error) {
        return fail(error.what());
    }
    past_seconds_ = 0;
    stage_ = SessionStage::Sewing;
}

void SessionRun::sew_frame() {
    for (int i = 0; i < kSewingSteps; ++i) {
        if (!sewing_->advance(met_->collider)) return end_sewing();
    }
}

void SessionRun::end_sewing() {
    SewingResult sewing = sewing_->result();
    past_seconds_ = sewing.simulated_seconds;
    if (sewing.bad_vertex) {
        sewing_.reset();
        return fail("a value is not finite while it was sewn: do its panels stand where they can be sewn?");
    }
    std::vector<int> open;
    for (const OpenSeam& seam : sewing.open) {
        const long gap = std::lround(1000 * seam.gap);
        say("seam '" + seam_name(pattern_, pattern_.seams[static_cast<std::size_t>(seam.seam)]) +
            "' did not close: it gapes by " + std::to_string(gap) + " mm");
        open.push_back(seam.seam);
    }
    Drape drape{.cloth = make_cloth(sewing.sewn, fabrics_of(pattern_), {.max_level = kDeepestSessionLevel}),
                .pattern = anchored(),
                .unsewn = sewing_->unsewn(),
                .open_seams = std::move(open),
                .pins = sewing.sewn.pins,
                .run = {}};
    sewing_.reset();
    hang(std::move(drape), DrapeOptions{}.relax_time);
}

// Draping.

DrapeOptions SessionRun::draping() const {
    DrapeOptions draping{.max_seconds = std::numeric_limits<double>::infinity(), .may_rest = true};
    if (!options_.has_gravity) draping.gravity.setZero();
    draping.adapt.criteria = options_.criteria;
    draping.adapt.curvature = options_.curvature;
    draping.adapt.shortest_edge = static_cast<float>(options_.shortest_edge);
    draping.adapt.max_level = options_.max_level;
    return draping;
}

void SessionRun::hang(Drape drape, double relax_time) {
    drape_ = std::move(drape);
    drag_constraint_.forget_vertices();
    DrapeOptions options = draping();
    options.relax_time = relax_time;
    options.coarse_time = std::min(options.coarse_time, relax_time - DrapeOptions{}.coarse_time);
    drape_->run.emplace(drape_->cloth, options);
    apply_options();
    stage_ = SessionStage::Draping;
    has_changed_ = true;
}

// The options hold pointers to members of this object.
void SessionRun::apply_options() {
    if (options_.triangle_budget) {
        const auto target = static_cast<std::size_t>(*options_.triangle_budget);
        if (!budget_) budget_.emplace(BudgetOptions{.target = target});
        budget_->set_target(target);
    } else {
        budget_.reset();
    }
    if (!drape_) return;
    DrapeOptions& options = drape_->run->options();
    const double relax_time = options.relax_time, coarse_time = options.coarse_time;
    options = draping();
    options.relax_time = relax_time;
    options.coarse_time = coarse_time;
    options.adapt.budget = budget_ ? &*budget_ : nullptr;
    options.adapt.kept_vertices = drag_constraint_.held();
    options.kinematic_vertices = [this](const Cloth& cloth, float seconds) {
        return drag_constraint_.kinematic_target(cloth, met_->collider, seconds);
    };
}

void SessionRun::update_drag() {
    const bool is_other = drag_constraint_.update_held(drape_->cloth, drape_->pins);
    const bool goes_elsewhere = drag_constraint_.take_goal_change();
    drape_->run->options().adapt.kept_vertices = drag_constraint_.held();
    if (is_other || goes_elsewhere) drape_->run->reactivate(drape_->cloth);
}

void SessionRun::drape_frame() {
    ensure_collider();
    update_drag();
    const DrapeResult before = drape_->run->result();
    const bool goes_on = drape_->run->advance(drape_->cloth, met_->collider);
    const DrapeResult& after = drape_->run->result();
    splits_ = static_cast<int>(after.splits - before.splits);
    rejoins_ = static_cast<int>(after.rejoins - before.rejoins);
    if (after.bad_vertex)
        return fail("a value is not finite " + describe_place(drape_->cloth, drape_->pattern, *after.bad_vertex));
    if (!goes_on) stage_ = SessionStage::Settled;
}

void SessionRun::reactivate() {
    has_changed_ = true;
    if (!drape_ || stage_ == SessionStage::Failed) return;
    drape_->run->reactivate(drape_->cloth);
    stage_ = SessionStage::Draping;
}

// Frames.

bool SessionRun::take_change() {
    const bool had_changed = has_changed_;
    has_changed_ = false;
    return had_changed;
}

std::shared_ptr<SessionFrame> SessionRun::make_frame() {
    auto frame = std::make_shared<SessionFrame>();
    frame->stage = stage_;
    frame->is_running = is_running_;
    frame->problem = problem_;
    frame->messages = messages_;
    frame->statistics.simulated_seconds = past_seconds_;
    if (drape_) {
        show_cloth(*frame, drape_->cloth, names_of(pattern_));
        frame->pins = drag_constraint_.pin_positions(drape_->cloth);
        frame->statistics.simulated_seconds += drape_->run->result().simulated_seconds;
        frame->statistics.rms_speed = static_cast<double>(drape_->run->result().rms_speed);
        frame->statistics.splits = splits_;
        frame->statistics.rejoins = rejoins_;
    } else if (sewing_) {
        show_cloth(*frame, sewing_->cloth(), names_of(pattern_));
        add_seam_lines(*frame, sewing_->unsewn().links, sewing_->cloth().x);
    } else {
        show_placed(*frame, placed_);
    }
    frame->statistics.times = times_.medians();
    return frame;
}

// Changes between frames: body, pattern, options, user constraints.

namespace {

constexpr double kShortRelax = 0.2;    // s, after a change of outlines
constexpr float kDeepestMove = 0.03F;  // m: if a new body overlaps the drape by more than this, sewing restarts

bool has_equal_surface(const Body& a, const Body& b) {
    return a.x == b.x && a.triangles == b.triangles;
}

template <class Number>
Number clamped(Number value, Number low, Number high, Number otherwise) {
    return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
}

bool is_placed_otherwise(const Pattern& a, const Pattern& b) {
    return !std::ranges::equal(a.panels, b.panels, [](const Panel& p, const Panel& q) {
        return p.translation == q.translation && p.rotation == q.rotation && p.wrap_radius == q.wrap_radius;
    });
}

}  // namespace

SessionOptions within_limits(SessionOptions options) {
    const SessionOptions usual;
    if (options.edge_length) options.edge_length = clamped(*options.edge_length, 0.005, 0.5, 0.05);
    options.max_level = std::clamp(options.max_level, 0, kDeepestSessionLevel);
    options.shortest_edge = clamped(options.shortest_edge, 0.002, 1.0, usual.shortest_edge);
    CurvatureOptions& curvature = options.curvature;
    curvature.split_angle = clamped(curvature.split_angle, 0.01F, 3.0F, usual.curvature.split_angle);
    curvature.rejoin_angle =
        clamped(curvature.rejoin_angle, 0.0F, 0.95F * curvature.split_angle, 0.3F * curvature.split_angle);
    if (options.triangle_budget) options.triangle_budget = std::max(1, *options.triangle_budget);
    return options;
}

// Body.

void SessionRun::set_body(std::shared_ptr<const Body> body) {
    if (body == body_) return;
    const bool is_same = body && body_ && has_equal_surface(*body, *body_);
    body_ = std::move(body);
    has_changed_ = true;
    if (is_same) return;  // met_ still holds the previous body, which is equal
    met_.reset();
    is_anchored_ = false;
    if (stage_ == SessionStage::Placed) return place();
    if (sewing_) return restart_sewing("");
    if (!drape_ || stage_ == SessionStage::Failed) return;
    if (!body_) return restart_sewing("there is no body: the panels are back where they are placed");
    ensure_collider();
    forget_contacts(drape_->cloth);
    float deepest = 0;
    for (const VertexId v : drape_->cloth.mesh.leaf_vertices())
        deepest = std::max(deepest, -met_->collider.contact(drape_->cloth.x[v.value].head<3>()).distance);
    if (deepest > kDeepestMove)
        return restart_sewing("the body is another: sewn anew from where the panels are placed");
    reactivate();
}

void SessionRun::ensure_collider() {
    if (!met_) met_.reset(new ColliderOfBody{body_, BodyCollider(*body_, {}, interrupt_)});
}

// Panels that were placed for another body move with this one. Making the body that the pattern names is slow, so it is
// cached.
const Pattern& SessionRun::anchored() {
    if (is_anchored_) return anchored_;
    anchored_ = pattern_;
    is_anchored_ = true;
    if (!body_ || pattern_.panels.empty()) return anchored_;
    if (!placed_for_ || placed_for_->text != pattern_.body || placed_for_->height != pattern_.body_height)
        placed_for_ = NamedBody{pattern_.body, pattern_.body_height, selvedge::sim::placed_for(pattern_)};
    if (!has_equal_surface(placed_for_->body, *body_)) anchor_panels(anchored_, placed_for_->body, *body_);
    return anchored_;
}

// Pattern.

MeshOptions SessionRun::meshing() const {
    MeshOptions meshing;
    const std::optional<double>& asked = options_.edge_length ? options_.edge_length : pattern_.edge_length;
    meshing.target_edge = asked.value_or(meshing.target_edge);
    return meshing;
}

GarmentMesh SessionRun::unsewn_mesh() {
    return assemble(anchored(), meshing(), meshes_);
}

// The quick mesh is for display only, so its quality is not relaxed.
void SessionRun::place() {
    MeshOptions quick = meshing();
    quick.relaxations = 0;
    placed_ = assemble(anchored(), quick, quick_meshes_);
    stage_ = placed_.triangles.empty() ? SessionStage::Empty : SessionStage::Placed;
    has_changed_ = true;
}

void SessionRun::set_pattern(Pattern pattern) {
    if (pattern == pattern_ && problem_.empty()) return;
    has_changed_ = true;
    const Pattern last = pattern_;
    const bool was_anchored = is_anchored_;
    const Pattern last_anchored = anchored_;
    const SessionStage last_stage = stage_;
    try {
        take_pattern(std::move(pattern));
    } catch (const InputError& error) {
        pattern_ = last;
        anchored_ = last_anchored;
        is_anchored_ = was_anchored;
        stage_ = last_stage;
        problem_ = error.what();
    }
}

void SessionRun::take_pattern(Pattern pattern) {
    fabrics_of(pattern);  // throws before anything has changed
    const PatternChange change = compare(drape_ ? drape_->pattern : pattern_, pattern);
    const std::string why =
        drape_ && change == PatternChange::Kind ? restart_reason(drape_->pattern, pattern) : std::string();
    const bool is_seen_only = change <= PatternChange::Setts && !is_placed_otherwise(pattern_, pattern);
    const bool had_failed = stage_ == SessionStage::Failed;
    pattern_ = std::move(pattern);
    is_anchored_ = false;
    if (drape_ && !had_failed && change != PatternChange::Kind) {
        if (change == PatternChange::Outlines) change_outlines(anchored());
        change_cloth(anchored());
        problem_.clear();
        return;
    }
    problem_.clear();
    if (sewing_ && is_seen_only) return;
    place();
    if (drape_ || sewing_ || is_running_) restart_sewing(why);
}

// Applies fabrics, grain and setts to the current cloth.
void SessionRun::change_cloth(const Pattern& pattern) {
    Cloth& cloth = drape_->cloth;
    const bool is_other_cloth = compare(drape_->pattern, pattern) == PatternChange::Fabrics;
    cloth.material.fabrics = fabrics_of(pattern);
    cloth.material.sett_offsets.clear();
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

void SessionRun::change_outlines(const Pattern& pattern) {
    GarmentMesh unsewn = unsewn_mesh();
    ensure_collider();
    AdaptClothOptions adapting = draping().adapt;
    past_seconds_ += drape_->run->result().simulated_seconds;
    const DrapeState carried{drape_->cloth, drape_->pattern, drape_->open_seams};
    TransferredDrape over = transfer_drape(carried, pattern, unsewn, fabrics_of(pattern), met_->collider, adapting);
    std::vector<OutlineMap> maps;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p)
        maps.emplace_back(drape_->pattern.panels[p], pattern.panels[p]);
    drag_constraint_.map_anchors([&](const MaterialPoint& at) {
        return MaterialPoint{at.panel, maps[at.panel](at.u.cast<double>()).cast<float>()};
    });
    hang({.cloth = std::move(over.cloth),
          .pattern = pattern,
          .unsewn = std::move(unsewn),
          .open_seams = drape_->open_seams,
          .pins = std::move(over.pins),
          .run = {}},
         kShortRelax);
}

void SessionRun::clear_drape() {
    sewing_.reset();
    drape_.reset();
    drag_constraint_ = {};
}

// Continues to run if it was running.
void SessionRun::restart_sewing(const std::string& why) {
    clear_drape();
    if (!why.empty()) say(why);
    place();
    if (is_running_ && stage_ == SessionStage::Placed) begin_sewing();
}

// Options.

void SessionRun::set_options(const SessionOptions& asked) {
    const SessionOptions options = within_limits(asked);
    if (options == options_) return;
    const bool is_other_mesh = options.edge_length != options_.edge_length;
    const SessionOptions last = options_;
    options_ = options;
    has_changed_ = true;
    try {
        if (is_other_mesh && drape_ && stage_ != SessionStage::Failed) {
            change_outlines(anchored());
        } else if (is_other_mesh && sewing_) {
            restart_sewing("");
        } else if (is_other_mesh) {
            place();
        }
    } catch (const InputError& error) {
        options_.edge_length = last.edge_length;
        problem_ = error.what();
    }
    apply_options();
    SessionOptions as_before = last;
    as_before.keeps_real_time = options.keeps_real_time;
    if (drape_ && options_ != as_before) {
        selvedge::sim::reactivate(drape_->cloth);
        reactivate();
    }
}

void SessionRun::reset() {
    is_running_ = false;
    problem_.clear();
    clear_drape();
    place();
}

// User constraints.

void SessionRun::pull(const MaterialPoint& at, const Vec3f& to) {
    if (!drape_ || stage_ == SessionStage::Failed || !to.allFinite()) return;
    drag_constraint_.pull(at, to);
    reactivate();
}

void SessionRun::pull_to(const Vec3f& to) {
    if (to.allFinite() && drag_constraint_.pull_to(to)) reactivate();
}

void SessionRun::let_go() {
    if (!drag_constraint_.is_pulling()) return;
    drag_constraint_.let_go();
    reactivate();
}

void SessionRun::pin(const MaterialPoint& at) {
    if (!drape_ || stage_ == SessionStage::Failed) return;
    drag_constraint_.pin(at);
    drag_constraint_.update_held(drape_->cloth, drape_->pins);
    has_changed_ = true;
}

void SessionRun::unpin_all() {
    if (!drag_constraint_.has_pins()) return;
    drag_constraint_.unpin_all();
    reactivate();
}

// Saved drapes.

void SessionRun::keep(const std::string& name) {
    if (!drape_ || stage_ == SessionStage::Failed) return say("nothing hangs yet that could be kept as '" + name + "'");
    kept_.insert_or_assign(name, SavedDrape{*drape_, stage_});
    say("kept as '" + name + "'");
}

void SessionRun::restore(const std::string& name) {
    const auto found = kept_.find(name);
    if (found == kept_.end()) return say("no drape was kept as '" + name + "'");
    const Drape& drape = found->second.drape;
    const auto is_same = [](const GarmentTriangle& a, const GarmentTriangle& b) {
        return a.vertices == b.vertices && a.u == b.u && a.panel == b.panel;
    };
    if (compare(drape.pattern, pattern_) == PatternChange::Kind ||
        !std::ranges::equal(drape.unsewn.triangles, unsewn_mesh().triangles, is_same))
        return say("'" + name + "' was kept of another cut: the pattern's pieces have changed since");
    clear_drape();
    drape_ = drape;
    problem_.clear();
    stage_ = found->second.stage;
    ensure_collider();
    forget_contacts(drape_->cloth);
    drag_constraint_.free_all(drape_->cloth, drape_->pins);
    apply_options();
    change_cloth(anchored());
    has_changed_ = true;
}

}  // namespace selvedge::sim
