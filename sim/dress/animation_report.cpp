#include "sim/dress/animation_report.h"

#include "sim/core/json.h"
#include "sim/core/math.h"

namespace selvedge::sim {

std::string to_json(const Animation& animation, const std::string& motion) {
    const MotionQuality& quality = animation.quality();
    Json json = Json::object();
    json[report_key::kMotion] = motion;
    json[report_key::kFrames] = animation.frame() + 1;
    json[report_key::kPlannedFrames] = animation.frame_count();
    json[report_key::kFramesPerSecond] = animation.frames_per_second();
    json[report_key::kSeconds] = animation.seconds();
    Json& measured = json[report_key::kQuality] = Json::object();
    measured[report_key::kStretchP99] = quality.p99_stretch;
    measured[report_key::kStretchMax] = quality.max_stretch;
    measured[report_key::kOverstretchedS] = quality.overstretched_seconds;
    measured[report_key::kDeepestVertexM] = quality.deepest_vertex;
    measured[report_key::kDeepestFaceM] = quality.deepest_face;
    measured[report_key::kDeepVertices] = quality.deep_vertices;
    measured[report_key::kDeepFaces] = quality.deep_faces;
    measured[report_key::kPinched] = quality.pinched;
    measured[report_key::kHasBadNumber] = quality.has_bad_number;
    Json& faults = json[report_key::kMotionFaults] = Json::array();
    for (const std::string& fault : quality.faults(animation.panel_names())) faults.push_back(fault);
    Json& timing = json[report_key::kTiming] = Json::object();
    timing[report_key::kMsPerFrame] = quantile(animation.frame_ms(), 0.5);
    timing[report_key::kMsPerFrameP95] = quantile(animation.frame_ms(), 0.95);
    json[report_key::kDressing] = json_of(animation.dress_report());
    return write_json(json);
}

}  // namespace selvedge::sim
