#pragma once
// Report on an animated garment as JSON: that of its dressing (sim/inspection/report.h), what was shown, and its
// quality.
#include <string>
#include <string_view>
#include <vector>

#include "sim/inspection/report.h"
#include "sim/session/animation.h"

namespace selvedge::sim {

namespace report_key {
inline constexpr std::string_view kAnimation = "animation";
inline constexpr std::string_view kMotion = "motion";
inline constexpr std::string_view kFrames = "frames";
inline constexpr std::string_view kPlannedFrames = "planned_frames";
inline constexpr std::string_view kFramesPerSecond = "frames_per_second";
inline constexpr std::string_view kSeconds = "seconds";
inline constexpr std::string_view kStretchP99 = "stretch_p99";
inline constexpr std::string_view kStretchMax = "stretch_max";
inline constexpr std::string_view kOverstretchedS = "overstretched_s";
inline constexpr std::string_view kDeepestVertexM = "deepest_vertex_m";
inline constexpr std::string_view kDeepVertices = "deep_vertices";
inline constexpr std::string_view kDeepFaces = "deep_faces";
inline constexpr std::string_view kPinched = "pinched_vertices";
inline constexpr std::string_view kHasBadNumber = "has_bad_number";
inline constexpr std::string_view kMsPerFrame = "ms_per_frame";
inline constexpr std::string_view kMsPerFrameP95 = "ms_per_frame_p95";
}  // namespace report_key

// A defect if a quality check of the motion found one.
Outcome outcome_of(const Animation& animation);

// The report of the dressing, with what the motion was and its quality under `animation`, and the times of its frames
// under `timing`. Equal input gives equal text, except for `timing`. motion: the name of the clip. notes: of the body
// and the motion as they came in, which precede those of the drape.
std::string to_json(const Animation& animation, const std::string& motion, const std::vector<ReportInput>& inputs,
                    const std::vector<std::string>& notes = {});

}  // namespace selvedge::sim
