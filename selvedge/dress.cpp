#include "selvedge/dress.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

#include "selvedge/content.h"
#include "sim/cloth/cloth.h"
#include "sim/core/assert.h"
#include "sim/core/error.h"
#include "sim/core/numbers.h"
#include "sim/core/parallel.h"
#include "sim/dress/dress_limits.h"
#include "sim/dress/worn_together.h"
#include "sim/exchange/garmentcode_element.h"
#include "sim/inspection/report.h"
#include "sim/pattern/fabric.h"
#include "sim/place/fit.h"
#include "sim/session/dress.h"
#include "sim/session/dress_check.h"
#include "sim/session/share_done.h"

namespace selvedge {
namespace {

sim::DressOptions dress_options(const DressOptions& options) {
    sim::DressOptions dress;
    if (!options.fabric.empty()) dress.fabric = sim::find_fabric(options.fabric);
    dress.max_seconds = sim::within(options.seconds, sim::kDrapeSeconds, "seconds");
    dress.edge_length = sim::within(options.edge_length, sim::kEdgeLengthsCm, "edge_length", kCm);
    dress.max_level = sim::within(options.max_level, sim::kLevels, "max_level");
    dress.shortest_edge = sim::within(options.shortest_edge, sim::kShortestEdgesCm, "shortest_edge", kCm);
    dress.triangle_budget = sim::within(options.triangles, sim::kTriangleBudgets, "triangles");
    dress.self_collision = options.self_collision;
    return dress;
}

// The garment with those over it.
sim::Pattern whole_pattern(const Pattern& pattern, const DressOptions& options, std::vector<std::string>& notes) {
    const sim::DressCheck check{
        .has_fabrics = options.fabric.empty(), .makes_body_and_mesh = false, .edge_length = options.edge_length};
    const auto checked = [&](const Pattern& one) -> const sim::Pattern& {
        const auto& [document, file] = one.content();
        for (const sim::Fault& warning : document.warnings) notes.push_back(describe(warning));
        refuse_undressable(document.pattern, file, check);
        return document.pattern;
    };
    const sim::Pattern& innermost = checked(pattern);
    std::vector<sim::Pattern> over;
    for (const Pattern& one : options.over) over.push_back(checked(one));
    return sim::worn_together(innermost, over, pattern.content().file, notes);
}

// Ends a dressing; no exception of the standard library, so that nothing takes it for one of its own.
struct Stopped {};

// Calls the caller's function. What it throws is kept here: it reaches the caller unchanged.
class CallersProgress {
 public:
    explicit CallersProgress(const DressOptions& options) : progress_(options.progress) {}

    void tell(double done, std::string_view phase) {
        if (!progress_) return;
        bool goes_on = false;
        try {
            goes_on = progress_(done, phase);
        } catch (...) {
            thrown_ = std::current_exception();
        }
        if (!goes_on) throw Stopped();
    }

    [[noreturn]] void throw_reason() const {
        if (thrown_) std::rethrow_exception(thrown_);
        throw Cancelled();
    }

 private:
    const std::function<bool(double, std::string_view)>& progress_;
    std::exception_ptr thrown_;
};

Mesh public_mesh(const sim::DrawMesh& mesh) {
    Mesh copy;
    for (const Vec3f& x : mesh.x) copy.positions.push_back({x.x(), x.y(), x.z()});
    for (const Vec3f& n : mesh.normals) copy.normals.push_back({n.x(), n.y(), n.z()});
    copy.triangles = mesh.triangles;
    for (const auto& [a, b, c] : mesh.u)
        copy.material.push_back({std::array{a.x(), a.y()}, std::array{b.x(), b.y()}, std::array{c.x(), c.y()}});
    copy.panel = mesh.panel;
    copy.panel.resize(mesh.triangles.size());
    copy.level = mesh.level;
    copy.level.resize(mesh.triangles.size());
    copy.panel_names = mesh.panel_names;
    return copy;
}

void keep(Result::Content& result, sim::DressedGarment dressed, std::vector<std::string> notes) {
    std::vector<std::string>& all = dressed.report.notes;
    all.insert(all.begin(), std::make_move_iterator(notes.begin()), std::make_move_iterator(notes.end()));
    result.report_text = to_json(dressed.report);
    for (const sim::DressFault& fault : dressed.report.faults) {
        const bool is_of_fit = class_of(fault) == sim::FaultClass::DoesNotFit;
        result.faults.push_back({.verdict = is_of_fit ? Verdict::DoesNotFit : Verdict::Defect,
                                 .kind = fault.kind,
                                 .sentence = cause_of(fault)});
    }
    for (const sim::TriangleStrain& one : measure_strain(dressed.cloth()))
        result.strain.push_back({.warp = one.warp, .weft = one.weft, .shear = one.shear});
    result.mesh = public_mesh(dressed.mesh);
    result.garment = std::move(dressed.mesh);
    result.hierarchy = std::move(dressed.hierarchy);
    result.meshing = dressed.meshing;
    result.report = std::move(dressed.report);
}

// As the command dresses: see dress_and_write() in app/dress.cpp.
Result dress_on(const Pattern& pattern, const Body* body, const DressOptions& options, CallersProgress& progress) {
    const sim::DressOptions dressing = dress_options(options);
    sim::within(options.threads, sim::kThreadCounts, "threads");
    std::vector<std::string> notes;
    sim::PatternDocument worn{.pattern = whole_pattern(pattern, options, notes), .json = {}};
    if (options.over.empty()) worn.json = pattern.content().document.json;
    std::optional<sim::ThreadLimit> limit;
    if (options.threads) limit.emplace(*options.threads);
    const std::string& named = worn.pattern.body;
    const Body wearer = body != nullptr ? *body : make_body(named.empty() ? sim::kDefaultBody : named);
    const std::vector<std::string> of_body = wearer.notes();
    notes.insert(notes.end(), of_body.begin(), of_body.end());
    const Pattern whole(std::make_shared<const Pattern::Content>(
        Pattern::Content{.document = std::move(worn), .file = pattern.content().file}));
    auto result = std::make_shared<Result::Content>(whole, wearer);
    result->fabric = options.fabric;
    keep(*result,
         sim::dress(
             whole.content().document.pattern, wearer.content().prepared, dressing,
             [&](std::string_view phase, double fraction) { progress.tell(sim::share_done(phase, fraction), phase); }),
         std::move(notes));
    progress.tell(1, "done");
    return Result(std::move(result));
}

Result dress_for_caller(const Pattern& pattern, const Body* body, const DressOptions& options) {
    CallersProgress progress(options);
    try {
        return dress_on(pattern, body, options, progress);
    } catch (const Stopped&) {
        progress.throw_reason();
    } catch (...) {
        throw_for_caller();
    }
}

}  // namespace

Result dress(const Pattern& pattern, const Body& body, const DressOptions& options) {
    return dress_for_caller(pattern, &body, options);
}

Result dress(const Pattern& pattern, const DressOptions& options) {
    return dress_for_caller(pattern, nullptr, options);
}

Result::Result(std::shared_ptr<Content> content) : content_(std::move(content)) {
    SELVEDGE_ASSERT(content_ != nullptr);
}

Result::Result(const Result&) = default;

Result& Result::operator=(const Result&) = default;

Result::~Result() = default;

Verdict Result::verdict() const {
    switch (outcome_of(content_->report)) {
        case sim::Outcome::Dressed:
            return Verdict::Dressed;
        case sim::Outcome::DoesNotFit:
            return Verdict::DoesNotFit;
        case sim::Outcome::Defect:
        case sim::Outcome::Refused:
            break;
    }
    return Verdict::Defect;
}

const std::vector<DrapeFault>& Result::faults() const {
    return content_->faults;
}

const std::vector<std::string>& Result::notes() const {
    return content_->report.notes;
}

bool Result::is_settled() const {
    return content_->report.settled;
}

const std::string& Result::report() const {
    return content_->report_text;
}

const Mesh& Result::mesh() const {
    return content_->mesh;
}

const std::vector<Strain>& Result::strain() const {
    return content_->strain;
}

const std::vector<float>& Result::clearance() const {
    return for_caller([&]() -> const auto& {
        return content_->clearance.get(
            [&] { return sim::measure_clearance(content_->garment.x, content_->body.content().body()); });
    });
}

const std::vector<std::vector<int>>& Result::seams_of_vertices() const {
    return for_caller([&]() -> const auto& {
        return content_->seams.get([&] {
            return sim::seams_of_vertices(content_->garment, content_->pattern.content().document.pattern,
                                          content_->meshing);
        });
    });
}

const Body& Result::body() const {
    return content_->body;
}

const Pattern& Result::pattern() const {
    return content_->pattern;
}

}  // namespace selvedge
