// What comes in between frames: another body, pattern, options, hands.
#include <algorithm>
#include <cmath>

#include "sim/core/error.h"
#include "sim/dress/carry_over.h"
#include "sim/dress/dress.h"
#include "sim/dress/outline_map.h"
#include "sim/dress/placement.h"
#include "sim/dress/session_limits.h"
#include "sim/dress/session_run.h"

namespace selvedge {
namespace {

constexpr double kShortRelax = 0.2;    // s, after a change of outlines
constexpr float kDeepestMove = 0.03F;  // m: by more than this no body is grown into a drape

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

// --- the body

void SessionRun::set_body(std::shared_ptr<const Body> body) {
    if (body == body_) return;
    const bool is_same = body && body_ && has_equal_surface(*body, *body_);
    body_ = std::move(body);
    has_changed_ = true;
    if (is_same) return;  // what was met goes on to hold the equal one
    met_.reset();
    is_anchored_ = false;
    if (stage_ == SessionStage::Placed) return place();
    if (sewing_) return sew_anew("");
    if (!drape_ || stage_ == SessionStage::Failed) return;
    if (!body_) return sew_anew("there is no body: the panels are back where they are placed");
    meet_body();
    forget_contacts(drape_->cloth);
    float deepest = 0;
    for (const VertexId v : drape_->cloth.mesh.leaf_vertices())
        deepest = std::max(deepest, -met_->collider.contact(drape_->cloth.x[v.value].head<3>()).distance);
    if (deepest > kDeepestMove) return sew_anew("the body is another: sewn anew from where the panels are placed");
    wake();
}

void SessionRun::meet_body() {
    if (!met_) met_.reset(new BodyToMeet{body_, BodyCollider(*body_, {}, interrupt_)});
}

// Panels that were placed for another body move with this one. Growing the body that the pattern names takes long.
const Pattern& SessionRun::anchored() {
    if (is_anchored_) return anchored_;
    anchored_ = pattern_;
    is_anchored_ = true;
    if (!body_ || pattern_.panels.empty()) return anchored_;
    if (!placed_for_ || placed_for_->text != pattern_.body || placed_for_->height != pattern_.body_height)
        placed_for_ = NamedBody{pattern_.body, pattern_.body_height, selvedge::placed_for(pattern_)};
    if (!has_equal_surface(placed_for_->body, *body_)) anchor_panels(anchored_, placed_for_->body, *body_);
    return anchored_;
}

// --- the pattern

MeshOptions SessionRun::meshing() const {
    MeshOptions meshing;
    const std::optional<double>& asked = options_.edge_length ? options_.edge_length : pattern_.edge_length;
    meshing.target_edge = asked.value_or(meshing.target_edge);
    return meshing;
}

GarmentMesh SessionRun::unsewn_mesh() {
    return assemble(anchored(), meshing(), meshes_);
}

// To be seen at once: a mesh that nobody sews need not be the best.
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
    fabrics_of(pattern);  // throws while nothing has changed yet
    const PatternChange change = compare(drape_ ? drape_->pattern : pattern_, pattern);
    const std::string why =
        drape_ && change == PatternChange::Kind ? why_sewn_anew(drape_->pattern, pattern) : std::string();
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
    if (drape_ || sewing_ || is_running_) sew_anew(why);
}

// Fabrics, grain and setts lie on the cloth as it hangs.
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
    refresh_contacts(cloth);  // friction
    wake();
}

void SessionRun::change_outlines(const Pattern& pattern) {
    GarmentMesh unsewn = unsewn_mesh();
    meet_body();
    AdaptClothOptions adapting = draping().adapt;
    past_seconds_ += drape_->run->result().simulated_seconds;
    const CarriedDrape carried{drape_->cloth, drape_->pattern, drape_->open_seams};
    CarriedOver over = carry_over(carried, pattern, unsewn, fabrics_of(pattern), met_->collider, adapting);
    std::vector<OutlineMap> maps;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p)
        maps.emplace_back(drape_->pattern.panels[p], pattern.panels[p]);
    hands_.map_places([&](const MaterialPoint& at) {
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

void SessionRun::forget_drape() {
    sewing_.reset();
    drape_.reset();
    hands_ = {};
}

// Runs on if it ran.
void SessionRun::sew_anew(const std::string& why) {
    forget_drape();
    if (!why.empty()) say(why);
    place();
    if (is_running_ && stage_ == SessionStage::Placed) begin_sewing();
}

// --- options

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
            sew_anew("");
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
        selvedge::wake(drape_->cloth);
        wake();
    }
}

void SessionRun::reset() {
    is_running_ = false;
    problem_.clear();
    forget_drape();
    place();
}

// --- hands

void SessionRun::pull(const MaterialPoint& at, const Vec3f& to) {
    if (!drape_ || stage_ == SessionStage::Failed || !to.allFinite()) return;
    hands_.pull(at, to);
    wake();
}

void SessionRun::pull_to(const Vec3f& to) {
    if (to.allFinite() && hands_.pull_to(to)) wake();
}

void SessionRun::let_go() {
    if (!hands_.is_pulling()) return;
    hands_.let_go();
    wake();
}

void SessionRun::pin(const MaterialPoint& at) {
    if (!drape_ || stage_ == SessionStage::Failed) return;
    hands_.pin(at);
    hands_.take_hold(drape_->cloth, drape_->pins);
    has_changed_ = true;
}

void SessionRun::unpin_all() {
    if (!hands_.has_pins()) return;
    hands_.unpin_all();
    wake();
}

// --- drapes that are kept

void SessionRun::keep(const std::string& name) {
    if (!drape_ || stage_ == SessionStage::Failed) return say("nothing hangs yet that could be kept as '" + name + "'");
    kept_.insert_or_assign(name, KeptDrape{*drape_, stage_});
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
    forget_drape();
    drape_ = drape;
    problem_.clear();
    stage_ = found->second.stage;
    meet_body();
    forget_contacts(drape_->cloth);
    hands_.free_all(drape_->cloth, drape_->pins);
    apply_options();
    change_cloth(anchored());
    has_changed_ = true;
}

}  // namespace selvedge
