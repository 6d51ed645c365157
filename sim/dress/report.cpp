#include "sim/dress/report.h"

#include "sim/core/json.h"

namespace selvedge {
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
    return json;
}

Json stretch_json(const StretchFigures& stretch) {
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
    json[report_key::kMsPerAdaption] = timing.ms_per_adaption;
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

}  // namespace selvedge
