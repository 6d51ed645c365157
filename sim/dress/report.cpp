#include "sim/dress/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "sim/adaptive/check.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/contact_surface.h"
#include "sim/collide/body_collider.h"
#include "sim/core/json.h"
#include "sim/core/math.h"
#include "sim/place/fit.h"

namespace selvedge::sim {
namespace {

Json faults_json(const std::vector<DressFault>& faults) {
    Json list = Json::array();
    for (const DressFault& fault : faults) {
        Json item = Json::object();
        item[report_key::kKind] = fault.kind;
        item[report_key::kPlace] = fault.place;
        item[report_key::kValue] = fault.value;
        list.push_back(std::move(item));
    }
    return list;
}

Json mesh_json(const MeshCounts& mesh) {
    Json json = Json::object();
    json[report_key::kBaseTriangles] = mesh.base_triangles;
    json[report_key::kLeafTriangles] = mesh.leaf_triangles;
    json[report_key::kLeafVertices] = mesh.leaf_vertices;
    Json levels = Json::array();
    for (const int count : mesh.by_level) levels.push_back(count);
    json[report_key::kByLevel] = std::move(levels);
    json[report_key::kMinAngleDeg] = mesh.min_angle_deg;
    json[report_key::kSplits] = mesh.splits;
    json[report_key::kRejoins] = mesh.rejoins;
    json[report_key::kTransitions] = mesh.transitions;
    return json;
}

Json seams_json(const SeamCounts& seams) {
    Json json = Json::object();
    json[report_key::kCount] = seams.count;
    json[report_key::kOpen] = seams.open;
    json[report_key::kWorstLengthMismatch] = seams.worst_length_mismatch;
    return json;
}

Json contact_json(const ContactCounts& contact) {
    Json json = Json::object();
    json[report_key::kInside] = contact.inside;
    json[report_key::kDeepestM] = contact.deepest_m;
    json[report_key::kSelfCrossings] = contact.self_crossings;
    return json;
}

Json stretch_json(const StretchStatistics& stretch) {
    Json json = Json::object();
    json[report_key::kWarpWeftP50] = stretch.warp_weft_p50;
    json[report_key::kWarpWeftP99] = stretch.warp_weft_p99;
    json[report_key::kWarpWeftMax] = stretch.warp_weft_max;
    json[report_key::kShearDegP99] = stretch.shear_deg_p99;
    return json;
}

Json timing_json(const DressTiming& timing) {
    Json json = Json::object();
    json[report_key::kWallS] = timing.wall_s;
    json[report_key::kMsPerAdaption] = timing.ms_per_adaptation;
    json[report_key::kMsPerStep] = timing.ms_per_step;
    json[report_key::kMsAdaptPlus4Steps] = timing.ms_adapt_plus_4_steps;
    Json phases = Json::object();
    for (const auto& [phase, seconds] : timing.phases_s) phases[phase] = seconds;
    json[report_key::kPhases] = std::move(phases);
    json[report_key::kPeakMemoryMb] = timing.peak_memory_mb;
    return json;
}

}  // namespace

std::string to_json(const DressReport& report) {
    Json json = Json::object();
    json[report_key::kGarment] = report.garment;
    json[report_key::kBody] = report.body;
    json[report_key::kSettled] = report.settled;
    json[report_key::kStoppedBecause] = report.stopped_because;
    json[report_key::kSimulatedSeconds] = report.simulated_seconds;
    json[report_key::kFaults] = faults_json(report.faults);
    Json notes = Json::array();
    for (const std::string& note : report.notes) notes.push_back(note);
    json[report_key::kNotes] = std::move(notes);
    json[report_key::kMesh] = mesh_json(report.mesh);
    json[report_key::kSeams] = seams_json(report.seams);
    json[report_key::kContact] = contact_json(report.contact);
    json[report_key::kStretch] = stretch_json(report.stretch);
    json[report_key::kTiming] = timing_json(report.timing);
    return write_json(json);
}

namespace {

void add_fault(DressReport& report, std::string kind, std::string place, double value) {
    report.faults.push_back({std::move(kind), std::move(place), value});
}

std::string describe_seam(const Pattern& pattern, int seam) {
    const auto side = [&](const SeamSide& s) {
        return "'" + pattern.panels[static_cast<std::size_t>(s.panel)].name + "' edge " + std::to_string(s.edge);
    };
    const Seam& sewn = pattern.seams[static_cast<std::size_t>(seam)];
    return "seam " + std::to_string(seam) + ", " + side(sewn.first) + " to " + side(sewn.second);
}

void validate_mesh(const Cloth& cloth, DressReport& report) {
    report.mesh.leaf_triangles = static_cast<int>(cloth.mesh.leaf_triangles().size());
    report.mesh.leaf_vertices = static_cast<int>(cloth.mesh.leaf_vertices().size());
    report.mesh.by_level.assign(static_cast<std::size_t>(cloth.mesh.max_level()) + 1, 0);
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) ++report.mesh.by_level[t.level];
    for (const std::string& broken : check(cloth.mesh)) add_fault(report, "broken_mesh", broken, 0);
}

void validate_contact(const Cloth& cloth, const BodyCollider& body, const Pattern& pattern, const FaultLimits& limits,
                      DressReport& report) {
    VertexId deepest;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const auto closest = body.surface().closest(cloth.x[v.value].head<3>(), std::numeric_limits<float>::infinity());
        if (!closest || closest->distance >= 0) continue;
        ++report.contact.inside;
        if (-closest->distance <= report.contact.deepest_m) continue;
        report.contact.deepest_m = -closest->distance;
        deepest = v;
    }
    if (report.contact.deepest_m <= limits.depth) return;
    add_fault(report, "inside_body", describe_place(cloth, pattern, deepest), report.contact.deepest_m);
}

float larger_of(const TriangleStrain& strain) {
    return std::max(strain.warp, strain.weft);
}

TriangleStrain beyond_limit(const TriangleStrain& strain, const Fabric& fabric) {
    const auto limit = static_cast<float>(fabric.strain_limit);
    return {.warp = strain.warp - limit, .weft = strain.weft - limit, .shear = strain.shear};
}

Vec3d middle_of(const Cloth& cloth, const LeafTriangle& t) {
    return ((cloth.x[t.v[0].value] + cloth.x[t.v[1].value] + cloth.x[t.v[2].value]) / 3.0F).head<3>().cast<double>();
}

StretchStatistics stretch_statistics(const std::vector<TriangleStrain>& strains) {
    std::vector<double> yarn_strains;
    std::vector<double> shears;
    StretchStatistics statistics;
    for (const TriangleStrain& strain : strains) {
        yarn_strains.push_back(strain.warp);
        yarn_strains.push_back(strain.weft);
        shears.push_back(strain.shear * 180 / std::numbers::pi);
        statistics.warp_weft_max = std::max(statistics.warp_weft_max, static_cast<double>(larger_of(strain)));
    }
    statistics.warp_weft_p50 = quantile(yarn_strains, 0.5);
    statistics.warp_weft_p99 = quantile(yarn_strains, 0.99);
    statistics.shear_deg_p99 = quantile(shears, 0.99);
    return statistics;
}

// For example "smaller than the body and the gap kept from it by up to 7.3 cm, between 1.14 and 1.26 m up: it stretches
// there".
std::string describe_tight(const std::vector<TightLevel>& tight) {
    double least = 0;
    for (const TightLevel& level : tight) least = std::max(least, level.body_girth - level.garment_girth);
    char text[160];
    std::snprintf(text, sizeof text,
                  "smaller than the body and the gap kept from it by up to %.1f cm, between %.2f and %.2f m up: it "
                  "stretches there",
                  least * 100, tight.front().y, tight.back().y);
    return text;
}

// Cloth that passes through itself.
void validate_crossings(const Cloth& cloth, DressReport& report) {
    const ContactSurface surface = contact_surface(cloth, order_of_base_triangles(cloth));
    report.contact.self_crossings = static_cast<int>(find_crossing_triangles(surface, cloth.x.front().data()).size());
}

void validate_rest(const DrapeResult& draped, DressReport& report) {
    if (!draped.settled) {
        add_fault(report, "not_settled", "whole garment, rms speed in m/s", draped.rms_speed);
    } else if (draped.rms_speed > DrapeOptions{}.rest_speed) {
        const long speed = std::lround(1000 * draped.rms_speed);
        report.notes.push_back("had settled, but moves by " + std::to_string(speed) + " mm/s in finer sub-steps");
    }
}

// Stretch where the garment is smaller than the body is unavoidable: a note. Elsewhere it is a fault.
void validate_stretch(const Cloth& cloth, const Body& body, const Pattern& pattern, const FaultLimits& limits,
                      DressReport& report) {
    const std::vector<TriangleStrain> strains = measure_strain(cloth);
    report.stretch = stretch_statistics(strains);
    const std::vector<TightLevel> tight = tight_levels(draw_mesh(cloth, {}), body);
    if (!tight.empty()) report.notes.push_back(describe_tight(tight));
    std::vector<TriangleStrain> free, beyond;  // beyond: strain minus the fabric's strain limit
    std::size_t worst = 0;
    float max_beyond = -std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const LeafTriangle& leaf = cloth.mesh.leaf_triangles()[i];
        if (is_tight_at(tight, middle_of(cloth, leaf))) continue;
        free.push_back(strains[i]);
        beyond.push_back(beyond_limit(strains[i], cloth.material.fabrics[leaf.panel]));
        if (larger_of(beyond.back()) <= max_beyond) continue;
        max_beyond = larger_of(beyond.back());
        worst = i;
    }
    if (free.empty()) return;
    const StretchStatistics statistics = stretch_statistics(beyond);
    const std::string place = describe_place(cloth, pattern, cloth.mesh.leaf_triangles()[worst].v[0]);
    if (statistics.warp_weft_p99 > limits.stretch_p99) {
        add_fault(report, "overstretched", "99th percentile, worst at " + place,
                  stretch_statistics(free).warp_weft_p99);
    }
    if (statistics.warp_weft_max > limits.stretch_max) {
        add_fault(report, "overstretched", place, static_cast<double>(larger_of(strains[worst])));
    }
}

// Not a fault of the drape but unwanted: the garment did not hold on the body and lies on the floor.
void validate_floor(const Cloth& cloth, DressReport& report) {
    constexpr float kNear = 0.02F;   // m, above the floor
    constexpr double kShare = 0.01;  // of the vertices
    const auto lies = [&](VertexId v) { return cloth.x[v.value].y() < kNear; };
    const std::span<const VertexId> vertices = cloth.mesh.leaf_vertices();
    const auto lying = std::count_if(vertices.begin(), vertices.end(), lies);
    if (static_cast<double>(lying) > kShare * static_cast<double>(vertices.size())) {
        report.notes.push_back("part of the garment lies on the floor: does it hold on this body?");
    }
}

}  // namespace

void validate(const Cloth& cloth, const BodyCollider& body, const Pattern& pattern,
              std::span<const OpenSeam> open_seams, const DrapeResult& draped, DressReport& report,
              const FaultLimits& limits) {
    report.seams.open = static_cast<int>(open_seams.size());
    for (const OpenSeam& open : open_seams) add_fault(report, "open_seam", describe_seam(pattern, open.seam), open.gap);
    if (draped.bad_vertex) {
        add_fault(report, "not_finite", describe_place(cloth, pattern, *draped.bad_vertex), 0);
    } else {
        validate_contact(cloth, body, pattern, limits, report);
        validate_crossings(cloth, report);
        validate_stretch(cloth, body.body(), pattern, limits, report);
        validate_floor(cloth, report);
    }
    validate_rest(draped, report);
    validate_mesh(cloth, report);
}

std::string describe_place(const Cloth& cloth, const Pattern& pattern, VertexId vertex) {
    std::string panels;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const auto touches = [&](TriangleId t) { return cloth.mesh.triangle(t).panel == p; };
        bool found = false;
        for (const TriangleId t : cloth.mesh.triangles_at(vertex)) found = found || touches(t);
        if (found) panels += (panels.empty() ? "'" : " beside '") + pattern.panels[p].name + "'";
    }
    const Vec4f& x = cloth.x[vertex.value];
    char where[96];
    std::snprintf(where, sizeof where, " at x %.3f y %.3f z %.3f m", static_cast<double>(x.x()),
                  static_cast<double>(x.y()), static_cast<double>(x.z()));
    return panels + where;
}

}  // namespace selvedge::sim
