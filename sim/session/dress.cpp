#include "sim/session/dress.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>
#include <optional>

#include "sim/core/math.h"
#include "sim/core/stopwatch.h"
#include "sim/dress/dressing.h"
#include "sim/dress/dressing_pose.h"
#include "sim/dress/wearer.h"
#include "sim/inspection/inspection.h"
#include "sim/inspection/wearing.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/place/fit_table.h"
#include "sim/place/hanging_seams.h"
#include "sim/place/placed_fit.h"
#include "sim/session/animation.h"
#include "sim/session/dressed_faults.h"
#include "sim/session/session_frame.h"

namespace selvedge::sim {
namespace {

// Measures the wall time of each phase of a dressing.
class PhaseTimer {
 public:
    explicit PhaseTimer(DressTiming& timing) : timing_(timing) {}

    void done(const std::string& phase) {
        timing_.wall_s = seconds_since(start_);
        timing_.phases_s[phase] += seconds_since(phase_start_);
        phase_start_ = Clock::now();
    }

 private:
    DressTiming& timing_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point phase_start_ = start_;
};

double peak_memory_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

void record_drape(DressReport& report, const DrapeResult& result) {
    report.settled = result.settled;
    report.stopped_because = result.stopped_because();
    report.simulated_seconds = result.simulated_seconds;
    report.work = result.work;
    report.mesh.splits = result.splits;
    report.mesh.rejoins = result.rejoins;
    report.mesh.transitions = result.transitions;
    report.timing.ms_per_adaptation = quantile(result.adaptation_ms, 0.5);
    report.timing.ms_per_step = quantile(result.step_ms, 0.5);
    report.timing.ms_adapt_plus_4_steps = report.timing.ms_per_adaptation + 4 * report.timing.ms_per_step;
}

void record_mesh(DressReport& report, const Pattern& pattern, const GarmentMesh& mesh) {
    const MeshReport found = report_mesh(pattern, mesh);
    report.mesh.base_triangles = found.triangles;
    report.mesh.min_angle_deg = found.min_angle_deg;
    report.seams.count = static_cast<int>(pattern.seams.size());
    report.seams.worst_length_mismatch = found.worst_mismatch ? found.worst_mismatch->ratio - 1 : 0;
}

// Runs the dressing to the end of this stage.
void finish_stage(Dressing& dressing, DressingStage stage, std::string_view phase, const Progress& progress) {
    while (dressing.stage() == stage) {
        dressing.advance();
        if (dressing.stage() == stage) report(progress, phase, dressing.fraction());
    }
}

// A garment that is not part of an outfit.
bool is_single(const Dressing& dressing) {
    return garments_of(dressing.pattern()).size() == 1;
}

// Runs the relaxation to its end, or until it took more work than a drape may: cloth that cannot close round the body
// crumples in it already. A garment that is known to be too small has less: other garments of an outfit are waited for.
void relax(Dressing& dressing, bool known_too_small, const Progress& progress) {
    constexpr double kMostOfMisfit = 4e6;  // DrapeResult::work: half of what most garments take as a whole
    while (dressing.stage() == DressingStage::Relax) {
        dressing.advance();
        if (dressing.stage() != DressingStage::Relax) return;
        report(progress, "draping", dressing.fraction());
        const bool takes_long = known_too_small && is_single(dressing) && dressing.result().work > kMostOfMisfit;
        if (takes_long || dressing.takes_too_much_work())
            dressing.give_up(known_too_small ? GiveUp::TooSmall : GiveUp::TooMuchWork);
    }
}

// Runs the fall to its end, or until the garment slips down the body, was too small for it at two tests, or took
// more work than a drape may. What is `known_too_small` is given up at once, for it would only crumple; an outfit hangs
// first.
// Pre: there is a check if it falls.
void fall_or_give_up(Dressing& dressing, bool known_too_small, const std::optional<WearingCheck>& wearing,
                     const Progress& progress) {
    // s of simulated time, in which cloth that hangs calmly slides into place, and what slips does not get far
    constexpr double kBetweenTests = 0.5;
    const bool is_one = is_single(dressing);       // others of an outfit are waited for
    double next_fit_test = 0, next_slip_test = 0;  // s
    bool was_too_small = false;
    while (dressing.stage() == DressingStage::Fall) {
        dressing.advance();
        report(progress, "draping", dressing.fraction());
        if (!dressing.falls()) continue;  // finer sub-steps at the end
        if (dressing.takes_too_much_work()) {
            dressing.give_up(known_too_small ? GiveUp::TooSmall : GiveUp::TooMuchWork);
            continue;
        }
        const double now = dressing.simulated_seconds();
        const bool tests_slip = is_one && now >= next_slip_test;
        if (tests_slip) next_slip_test = now + kBetweenTests;
        if (known_too_small && (is_one || dressing.hangs())) {
            dressing.give_up(GiveUp::TooSmall);
        } else if (tests_slip && wearing->slips(*dressing.cloth())) {
            dressing.give_up(GiveUp::SlipsDown);
        } else if (dressing.hangs_calmly() && now >= next_fit_test) {
            next_fit_test = now + kBetweenTests;
            const bool is_small = is_too_small(*dressing.cloth(), *dressing.body());
            if (is_small && was_too_small) dressing.give_up(GiveUp::TooSmall);
            was_too_small = is_small;
        }
    }
}

// Whatever it shows.
void fall_on(Dressing& dressing, const Progress& progress) {
    while (dressing.stage() == DressingStage::Fall) {
        dressing.advance();
        report(progress, "draping", dressing.fraction());
        if (dressing.falls() && dressing.takes_too_much_work()) dressing.give_up(GiveUp::TooMuchWork);
    }
}

// A garment that is too small is not waited for: it crumples and stretches without coming to rest. Nor is one that
// slips down: it would fall to the floor. One that could not be pulled over the body, or slipped while it was sewn,
// stays as it was sewn; an outfit hangs, for the sake of its other garments. Returns what of the sewn garment fits
// nowhere. If the end shows that a verdict was wrong, it falls on; but what cannot close round the body ends anywhere,
// and does not show it. as_placed: that; none if it may fit.
std::optional<TightLevel> relax_and_fall(Dressing& dressing, const std::optional<WearingCheck>& wearing,
                                         const std::optional<TightLevel>& as_placed, const Progress& progress) {
    std::optional<TightLevel> too_small;
    if (as_placed && dressing.stage() == DressingStage::Relax) {
        dressing.give_up(GiveUp::TooSmall);
        fall_on(dressing, progress);
        return std::nullopt;
    }
    if (dressing.stage() == DressingStage::Relax) too_small = fits_nowhere(*dressing.cloth(), *dressing.body());
    const bool is_one = is_single(dressing);
    if (is_one && too_small && excess_stretch(*too_small) > FaultLimits{}.stretch_max) {
        dressing.give_up(GiveUp::TooSmall);
    } else if (is_one && dressing.stage() == DressingStage::Relax && wearing->slips(*dressing.cloth())) {
        dressing.give_up(GiveUp::SlipsDown);
    }
    relax(dressing, too_small.has_value(), progress);
    fall_or_give_up(dressing, too_small.has_value(), wearing, progress);
    const Cloth& cloth = *dressing.cloth();
    const std::optional<GiveUp> given_up = dressing.result().given_up;
    if (!given_up || dressing.result().bad_vertex) return std::nullopt;
    if (given_up == GiveUp::TooMuchWork) return std::nullopt;
    if (given_up == GiveUp::SlipsDown && wearing->slips(cloth)) return std::nullopt;
    const bool shows_it = is_too_small(cloth, *dressing.body()) || (too_small && is_overstretched(cloth));
    if (given_up == GiveUp::TooSmall && shows_it) return too_small;
    dressing.reactivate();
    fall_on(dressing, progress);
    return std::nullopt;
}

// How a garment's size is wrong as its panels will hang round the body, before it is sewn.
struct Misfit {
    std::optional<TightLevel> too_small;  // of a single garment
    double below_floor = 0;               // m
};

Misfit find_misfit(const Dressing& dressing, const MeasuredBody& body) {
    GarmentMesh hung = dressing.placed();
    hang_on_shoulders(hung, body);
    Misfit misfit{.too_small = {}, .below_floor = depth_below_floor(hung, body)};
    if (!is_single(dressing)) return misfit;
    PlacedFitOptions options;
    for (const Fabric& fabric : fabrics_of(dressing.pattern(), dressing.options().fabric))
        options.strain_limits.push_back(fabric.strain_limit);
    misfit.too_small = too_small_as_placed(hung, body, options);
    return misfit;
}

void blame(const Misfit& misfit, const MeasuredBody& body, DressReport& report) {
    constexpr double kKnees = 0.285;  // of the stature (Drillis and Contini 1966)
    if (misfit.too_small) blame_size(*misfit.too_small, body.limbs(), report);
    blame_length(misfit.below_floor, body.proportions().at(kKnees), report);
}

// What cannot be put on crumples; contact of its heaps with themselves takes long and shows nothing. What is much too
// long lies in a heap round the feet, which does not come to rest soon.
void begin_sewing(Dressing& dressing, DressOptions options, const Misfit& misfit) {
    constexpr double kMostOfHeap = 30e6;  // DrapeResult::work: a circle skirt takes 27e6 to come to rest
    const std::vector<Panel>& panels = dressing.pattern().panels;
    const auto has_same_layer = [&](const Panel& panel) { return panel.layer == panels.front().layer; };
    if (misfit.too_small && std::ranges::all_of(panels, has_same_layer)) options.self_collision = false;
    if (misfit.below_floor > 2 * kMuchTooLong && !options.most_work) options.most_work = kMostOfHeap;
    dressing.set_options(options);
    dressing.sew(misfit.too_small ? LimbsInTheWay::Stay : LimbsInTheWay::GiveWay);
}

// What is too small for the body with lowered arms may fit it as it stands, and falls there.
std::optional<GiveUp> still_given_up(std::optional<GiveUp> given_up, const Cloth& cloth, const Body& as_it_stands) {
    if (given_up != GiveUp::TooSmall || fits_nowhere(cloth, as_it_stands)) return given_up;
    return is_too_small(cloth, as_it_stands) && is_overstretched(cloth) ? given_up : std::nullopt;
}

// "not worn, as the pattern says: 'facing', 'pocket'"
void note_unworn(const Pattern& pattern, DressReport& report) {
    std::string names;
    for (const Panel& panel : pattern.panels)
        if (!panel.is_worn) names += (names.empty() ? "'" : ", '") + panel.name + "'";
    if (!names.empty()) report.notes.push_back("not worn, as the pattern says: " + names);
}

// None for cloth that is not finite: nothing is checked of it.
std::optional<WearingCheck> check_wearing(Dressing& dressing, const MeasuredBody& wearer) {
    if (dressing.result().bad_vertex) return std::nullopt;
    return WearingCheck(
        dressing.sewn_mesh(),
        {.unsewn = dressing.designed(), .pattern = &dressing.pattern(), .body = &dressing.designed_for()}, wearer);
}

// What slipped may not slip in another pose. Then nothing excuses that it is not at rest.
void excuse_no_slip(const WearingCheck& wearing, const Cloth& cloth, DrapeResult& result) {
    const bool slipped = result.given_up == GiveUp::SlipsDown && !result.bad_vertex;
    if (slipped && !wearing.slips(cloth)) result.given_up.reset();
}

// Fills in the report's faults and fit. `wearing`, the collider and its measured body have the wearer in the same pose.
void inspect(DressedGarment& dressed, Dressing& dressing, const std::optional<WearingCheck>& wearing,
             const BodyCollider& collider, const MeasuredBody& measured, const DrapeResult& result,
             const std::optional<TightLevel>& too_small) {
    const Cloth& cloth = dressed.cloth();
    report_faults(cloth, dressing, collider, result, too_small, dressed.report);
    if (result.bad_vertex) return;
    wearing->validate(cloth, dressed.report);
    dressed.report.fit = measure_fit(dressed.mesh, measured);
}

// Round the body in the pose in which it is dressed. Returns the body in that pose.
std::shared_ptr<const PreparedBody> place(Dressing& dressing, const Pattern& pattern,
                                          const std::shared_ptr<const PreparedBody>& body) {
    dressing.set_body(body);
    dressing.set_pattern(pattern);
    std::shared_ptr<const PreparedBody> wearer = wearer_of(dressing.placed(), dressing.anchored(), body);
    dressing.set_body(wearer);
    return wearer;
}

// Returns that of the body's own pose; null if it is dressed in that.
std::shared_ptr<const BodyCollider> build_colliders(Dressing& dressing, const PreparedBody& wearer,
                                                    const Progress& progress, const ContentStore* store) {
    if (!wearer.has_colliders()) report(progress, "reading the body", 0);
    dressing.collider();
    return wearer.own_collider({}, store);
}

DressReport report_of(const Pattern& pattern, const Body& body, const DressOptions& options) {
    DressReport report;
    report.options = options;
    report.garment = pattern.name;
    report.garments = garment_names(pattern);
    report.body = body.name;
    return report;
}

}  // namespace

std::vector<std::string> girths_unlike_asked(const std::vector<FitRow>& fit, const MannequinReadings& mannequin) {
    constexpr double kSame = 0.003;  // m
    std::vector<std::string> notes;
    for (const FitRow& row : fit) {
        const auto asked = std::ranges::find(mannequin.readings, row.measure, &MeasureReading::name);
        if (asked == mannequin.readings.end() || !asked->requested || !asked->level || !row.body_girth) continue;
        if (std::abs(*row.body_girth - *asked->requested) <= kSame) continue;
        std::array<char, 192> text{};
        std::snprintf(text.data(), text.size(),
                      "%s: the mannequin was asked for %.1f cm and has %.1f cm at a height of %.1f cm; the fit table "
                      "measures %.1f cm",
                      std::string(row.measure).c_str(), 100 * *asked->requested, 100 * asked->measured,
                      100 * *asked->level, 100 * *row.body_girth);
        notes.emplace_back(text.data());
    }
    return notes;
}

namespace {

void note_girths(const MadeBody& made, DressReport& report) {
    if (made.readings)
        std::ranges::move(girths_unlike_asked(report.fit, *made.readings), std::back_inserter(report.notes));
}

}  // namespace

DressedGarment::DressedGarment() = default;
DressedGarment::DressedGarment(DressedGarment&&) noexcept = default;
DressedGarment& DressedGarment::operator=(DressedGarment&&) noexcept = default;
DressedGarment::~DressedGarment() = default;

const Cloth& DressedGarment::cloth() const {
    return simulation->cloth();
}

DressedGarment dress(const Pattern& pattern, const Body& body, const DressOptions& options, const Progress& progress,
                     const ContentStore* store) {
    const std::shared_ptr<const Body> unowned(std::shared_ptr<void>(), &body);
    return dress(pattern, std::make_shared<const PreparedBody>(MadeBody{.body = unowned}), options, progress, store);
}

DressedGarment dress(const Pattern& pattern, const std::shared_ptr<const PreparedBody>& prepared,
                     const DressOptions& options, const Progress& progress, const ContentStore* store) {
    check_layers(pattern, options);
    check_size(pattern);
    const Body& body = prepared->body();
    DressedGarment dressed;
    DressReport& report = dressed.report = report_of(pattern, body, options);
    PhaseTimer timer(report.timing);
    Dressing dressing({}, store);
    dressing.set_options(options);
    const std::shared_ptr<const PreparedBody> wearer = place(dressing, pattern, prepared);
    timer.done("mesh");
    const std::shared_ptr<const BodyCollider> own_collider = build_colliders(dressing, *wearer, progress, store);
    timer.done("body");

    const Misfit misfit = find_misfit(dressing, dressing.measured());
    begin_sewing(dressing, options, misfit);
    report.notes = dressing.take_notes();
    note_unworn(pattern, report);
    timer.done("mesh");

    finish_stage(dressing, DressingStage::Sew, "sewing", progress);
    selvedge::sim::report(progress, "sewing", 1);
    std::ranges::move(dressing.take_notes(), std::back_inserter(report.notes));
    record_mesh(report, pattern, dressing.sewn_mesh());
    timer.done("sewing");

    selvedge::sim::report(progress, "draping", 0);
    std::optional<WearingCheck> wearing = check_wearing(dressing, dressing.measured());
    std::optional<TightLevel> too_small = relax_and_fall(dressing, wearing, misfit.too_small, progress);
    selvedge::sim::report(progress, "draping", 1);
    dressed.simulation = std::make_unique<Simulation>(dressing.take_simulation());
    Simulation& simulation = *dressed.simulation;
    const Cloth& cloth = simulation.cloth();
    DrapeResult result = dressing.result();
    const BodyCollider* const own = result.bad_vertex ? nullptr : own_collider.get();
    const MeasuredBody as_given(body);
    if (own != nullptr) {
        if (!misfit.too_small) result.given_up = still_given_up(result.given_up, cloth, own->body());
        result = move_to_own_pose(simulation, body, *wearer->dressing_pose(), *own, options, result, progress);
        too_small.reset();  // it was found in the other pose
        wearing = check_wearing(dressing, as_given);
        excuse_no_slip(*wearing, cloth, result);
        report.notes.emplace_back("dressed with lowered arms, which then moved into the pose of the body");
    }
    record_drape(report, result);
    timer.done("draping");

    dressed.mesh = draw_mesh(cloth, dressing.sewn_mesh().panel_names);
    const BodyCollider& collider = own ? *own : dressing.collider();
    const MeasuredBody at_rest(collider.body());
    inspect(dressed, dressing, wearing, collider, own ? at_rest : dressing.measured(), result, too_small);
    blame(misfit, dressing.measured(), report);
    note_girths(prepared->made(), report);
    dressed.hierarchy = triangle_hierarchy(cloth);
    dressed.meshing = dressing.drape().meshing;
    timer.done("inspection");
    report.timing.peak_memory_mb = peak_memory_mb();
    return dressed;
}

}  // namespace selvedge::sim
