#include "sim/session/animation_report.h"

#include "sim/core/json.h"
#include "sim/core/math.h"

namespace selvedge::sim {

namespace {

// faults: of the motion, as sentences.
Outcome outcome_with(const std::vector<std::string>& faults, const Animation& animation) {
    return faults.empty() ? outcome_of(animation.dress_report()) : Outcome::Defect;
}

}  // namespace

Outcome outcome_of(const Animation& animation) {
    return outcome_with(animation.motion_faults(), animation);
}

std::string to_json(const Animation& animation, const std::string& motion, const std::vector<ReportInput>& inputs,
                    const std::vector<std::string>& notes) {
    const MotionQuality& quality = animation.quality();
    const std::vector<std::string> found = animation.motion_faults();
    DressReport report = animation.dress_report();
    report.inputs = inputs;
    report.notes.insert(report.notes.begin(), notes.begin(), notes.end());
    Json json = json_of(report);
    json[report_key::kOutcome] = name_of(outcome_with(found, animation));
    Json& moved = json[report_key::kAnimation] = Json::object();
    moved[report_key::kMotion] = motion;
    moved[report_key::kFrames] = animation.frame() + 1;
    moved[report_key::kPlannedFrames] = animation.frame_count();
    moved[report_key::kFramesPerSecond] = animation.frames_per_second();
    moved[report_key::kSeconds] = animation.seconds();
    moved[report_key::kStretchP99] = quality.p99_stretch;
    moved[report_key::kStretchMax] = quality.max_stretch;
    moved[report_key::kOverstretchedS] = quality.overstretched_seconds;
    moved[report_key::kDeepestVertexM] = quality.deepest_vertex;
    moved[report_key::kDeepestFaceM] = quality.deepest_face;
    moved[report_key::kDeepVertices] = quality.deep_vertices;
    moved[report_key::kDeepFaces] = quality.deep_faces;
    moved[report_key::kPinched] = quality.pinched;
    moved[report_key::kHasBadNumber] = quality.has_bad_number;
    Json& faults = moved[report_key::kFaults] = Json::array();
    for (const std::string& fault : found) faults.push_back(fault);
    Json& timing = json[report_key::kTiming];
    timing[report_key::kMsPerFrame] = quantile(animation.frame_ms(), 0.5);
    timing[report_key::kMsPerFrameP95] = quantile(animation.frame_ms(), 0.95);
    return write_json(json);
}

}  // namespace selvedge::sim
