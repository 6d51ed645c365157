#pragma once
// What the report of a garment at rest (sim/inspection/report.h), and what its session saw while its body moved, say to
// their user: whether it fits in a few words, and each fault and note with its place on the panels and in space.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "editor/geometry/draft.h"
#include "sim/core/math.h"
#include "sim/inspection/report.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/pattern/pattern.h"
#include "sim/session/session.h"

namespace selvedge::editor {

// Where a finding is. What of it is not known is empty.
struct FindingPlace {
    std::vector<PartLocation> parts = {};
    std::optional<Vec3d> point = {};   // m, in space
    std::optional<double> level = {};  // m, height: all round the body

    bool is_empty() const { return parts.empty() && !point && !level; }
    bool operator==(const FindingPlace&) const = default;
};

enum class FindingKind {
    DoesNotFit,  // a fault: `dress` ends with 4
    Defect,      // a fault: `dress` or `animate` ends with 3
    Note
};

struct Finding {
    FindingKind kind = FindingKind::Note;
    std::string text;
    FindingPlace place = {};
};

// The faults, then the notes.
std::vector<Finding> findings_of(const sim::DressReport& report, const sim::Pattern& pattern);

// The faults of the motion, then those of the garment at rest, if it was looked at.
std::vector<Finding> findings_of(const sim::SessionFrame& frame, const sim::Pattern& pattern);

// How well it fits, for the badge.
enum class Verdict {
    Good,   // nothing is wrong
    Tight,  // it is smaller than the body, and stretches no more than its fabric may
    Wrong   // `dress` or `animate` would end with 3 or 4
};

struct VerdictText {
    Verdict verdict = Verdict::Good;
    std::string text = {};  // "too small at the bust by 2.2 cm"; empty: nothing is wrong
};

VerdictText verdict_of(const sim::DressReport& report);

// Of the motion, where that has a fault: "left the waist at 1.20 s".
VerdictText verdict_of(const sim::SessionFrame& frame);

// The place on cloth that hangs: lines in space and on the panels, m. A point is a line without length.
struct LitCloth {
    struct OnPanel {
        std::string panel;
        std::array<Vec2d, 2> ends;
    };
    std::vector<std::array<Vec3f, 2>> in_space = {};
    std::vector<OnPanel> on_panels = {};
};

LitCloth lit_cloth(const FindingPlace& place, const sim::DrawMesh& mesh);

}  // namespace selvedge::editor
