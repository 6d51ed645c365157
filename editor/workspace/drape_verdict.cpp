#include "editor/workspace/drape_verdict.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace selvedge::editor {
namespace {

// "at the waist (y 1.02 m) by 3 cm: in detail" gives "at the waist by 3 cm".
std::string shortened(std::string text) {
    const std::size_t open = text.find(" (y "), close = text.find(')', open);
    if (open != std::string::npos && close != std::string::npos) text.erase(open, close + 1 - open);
    const std::size_t detail = text.find(": ");
    if (detail != std::string::npos) text.resize(detail);
    const std::size_t position = text.find(" at x ");
    if (position != std::string::npos) text.resize(position);
    return text;
}

bool begins_edge(const std::string& text, std::size_t at, int& edge) {
    return std::sscanf(text.c_str() + at, " edge %d", &edge) == 1;
}

// The panels that the text names in quotes, with the edge if it names one.
std::vector<PartLocation> parts_in(const std::string& text, const sim::Pattern& pattern) {
    std::vector<PartLocation> parts;
    for (const sim::Panel& panel : pattern.panels) {
        const std::string quoted = "'" + panel.name + "'";
        for (std::size_t at = text.find(quoted); at != std::string::npos; at = text.find(quoted, at + 1)) {
            PartLocation part{.panel = panel.name};
            int edge = -1;
            if (begins_edge(text, at + quoted.size(), edge)) part.edge = edge;
            if (std::ranges::find(parts, part) == parts.end()) parts.push_back(part);
        }
    }
    return parts;
}

std::optional<Vec3d> point_in(const std::string& text) {
    for (std::size_t at = text.find("x "); at != std::string::npos; at = text.find("x ", at + 1)) {
        Vec3d point;
        if (std::sscanf(text.c_str() + at, "x %lf y %lf z %lf m", &point.x(), &point.y(), &point.z()) == 3)
            return point;
    }
    return std::nullopt;
}

// "(y 1.02 m)", "1.02 m up", "from 1.02 to 1.10 m up".
std::optional<double> level_in(const std::string& text) {
    double low = 0, high = 0;
    const std::size_t height = text.find("(y ");
    if (height != std::string::npos && std::sscanf(text.c_str() + height, "(y %lf m)", &low) == 1) return low;
    const std::size_t range = text.find("from ");
    if (range != std::string::npos && std::sscanf(text.c_str() + range, "from %lf to %lf m up", &low, &high) == 2)
        return (low + high) / 2;
    const std::size_t up = text.find(" m up"), before = up == std::string::npos ? up : text.rfind(' ', up - 1);
    if (before == std::string::npos || std::sscanf(text.c_str() + before, " %lf m up", &low) != 1) return std::nullopt;
    return low;
}

FindingPlace place_in(const std::string& text, const sim::Pattern& pattern) {
    FindingPlace place{.parts = parts_in(text, pattern), .point = point_in(text)};
    if (!place.point) place.level = level_in(text);
    return place;
}

const sim::FitRow* tightest(const sim::DressReport& report) {
    const sim::FitRow* found = nullptr;
    for (const sim::FitRow& row : report.fit) {
        if (row.ease() && *row.ease() < 0 && (found == nullptr || *row.ease() < *found->ease())) found = &row;
    }
    return found;
}

// Of the notes: that the garment is smaller than the body.
const std::string* note_of_tightness(const sim::DressReport& report) {
    const auto is_it = [](const std::string& note) { return note.starts_with(sim::kSmallerThanBody); };
    const auto found = std::ranges::find_if(report.notes, is_it);
    return found == report.notes.end() ? nullptr : &*found;
}

// "the garment of 'front' left the waist at 1.20 s and hangs on the left hand" gives "left the waist at 1.20 s".
std::string shortened_motion(const std::string& text) {
    const std::size_t begin = text.find(" left the "), end = text.find(" and ", begin);
    return begin == std::string::npos ? text : text.substr(begin + 1, end - begin - 1);
}

std::string with_more(std::string text, std::size_t more) {
    if (more > 0) text += ", and " + std::to_string(more) + (more == 1 ? " more fault" : " more faults");
    return text;
}

std::string readable(std::string_view measure) {
    std::string text(measure);
    std::ranges::replace(text, '_', ' ');
    return text;
}

}  // namespace

std::vector<Finding> findings_of(const sim::DressReport& report, const sim::Pattern& pattern) {
    std::vector<Finding> findings;
    for (const sim::DressFault& fault : report.faults) {
        const bool is_of_fit = class_of(fault) == sim::FaultClass::DoesNotFit;
        const std::string text = cause_of(fault);
        findings.push_back({.kind = is_of_fit ? FindingKind::DoesNotFit : FindingKind::Defect,
                            .text = text,
                            .place = place_in(text, pattern)});
    }
    for (const std::string& note : report.notes)
        findings.push_back({.kind = FindingKind::Note, .text = note, .place = place_in(note, pattern)});
    return findings;
}

VerdictText verdict_of(const sim::DressReport& report) {
    if (!report.faults.empty()) {
        const auto is_of_fit = [](const sim::DressFault& fault) {
            return class_of(fault) == sim::FaultClass::DoesNotFit;
        };
        const auto worst = std::ranges::find_if(report.faults, is_of_fit);
        const sim::DressFault& first = worst == report.faults.end() ? report.faults.front() : *worst;
        return {.verdict = Verdict::Wrong, .text = with_more(shortened(cause_of(first)), report.faults.size() - 1)};
    }
    const std::string* note = note_of_tightness(report);
    if (note == nullptr) return {};
    std::string text = note->substr(0, note->find(','));
    if (const sim::FitRow* row = tightest(report)) text += " at the " + readable(row->measure);
    return {.verdict = Verdict::Tight, .text = text};
}

std::vector<Finding> findings_of(const sim::SessionFrame& frame, const sim::Pattern& pattern) {
    std::vector<Finding> findings;
    for (const std::string& fault : frame.motion.faults)
        findings.push_back({.kind = FindingKind::Defect, .text = fault, .place = place_in(fault, pattern)});
    if (!frame.report) return findings;
    const std::vector<Finding> at_rest = findings_of(*frame.report, pattern);
    findings.insert(findings.end(), at_rest.begin(), at_rest.end());
    return findings;
}

VerdictText verdict_of(const sim::SessionFrame& frame) {
    const std::vector<std::string>& moved = frame.motion.faults;
    if (!moved.empty()) {
        const std::size_t at_rest = frame.report ? frame.report->faults.size() : 0;
        return {.verdict = Verdict::Wrong,
                .text = with_more(shortened_motion(moved.front()), moved.size() - 1 + at_rest)};
    }
    return frame.report ? verdict_of(*frame.report) : VerdictText{};
}

namespace {

void light_level(double level, const sim::DrawMesh& mesh, LitCloth& lit) {
    const auto height = static_cast<float>(level);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::vector<Vec3f> in_space;
        std::vector<Vec2d> on_panel;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            const Vec3f &a = mesh.x[mesh.triangles[t][k]], &b = mesh.x[mesh.triangles[t][next]];
            if ((a.y() < height) == (b.y() < height)) continue;
            const float share = (height - a.y()) / (b.y() - a.y());
            in_space.emplace_back(a + share * (b - a));
            on_panel.emplace_back((mesh.u[t][k] + share * (mesh.u[t][next] - mesh.u[t][k])).cast<double>());
        }
        if (in_space.size() != 2) continue;
        lit.in_space.push_back({in_space[0], in_space[1]});
        lit.on_panels.push_back({mesh.panel_names[mesh.panel[t]], {on_panel[0], on_panel[1]}});
    }
}

// The corner of a triangle that is nearest to the point.
void light_point(const Vec3d& point, const sim::DrawMesh& mesh, LitCloth& lit) {
    const Vec3f at = point.cast<float>();
    lit.in_space.push_back({at, at});
    float nearest = INFINITY;
    LitCloth::OnPanel found;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const float distance = (mesh.x[mesh.triangles[t][k]] - at).squaredNorm();
            if (distance >= nearest) continue;
            nearest = distance;
            const Vec2d u = mesh.u[t][k].cast<double>();
            found = {mesh.panel_names[mesh.panel[t]], {u, u}};
        }
    }
    if (!found.panel.empty()) lit.on_panels.push_back(std::move(found));
}

}  // namespace

LitCloth lit_cloth(const FindingPlace& place, const sim::DrawMesh& mesh) {
    LitCloth lit;
    if (mesh.u.size() != mesh.triangles.size() || mesh.panel.size() != mesh.triangles.size()) return lit;
    if (place.point) light_point(*place.point, mesh, lit);
    if (place.level) light_level(*place.level, mesh, lit);
    return lit;
}

}  // namespace selvedge::editor
