#include "sim/paper/dxf_records.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "sim/paper/field_record.h"
#include "sim/paper/path_builder.h"
#include "sim/paper/placement_record.h"
#include "sim/paper/record_words.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

constexpr double kFar = 1e6;  // mm: no chord is as long

template <class T>
T value_of_name(std::string_view name, RecordWords& words) {
    const auto& texts = names_of(T{}).texts;
    const auto found = std::ranges::find(texts, name);
    if (found == texts.end()) words.refuse();
    return found == texts.end() ? T{} : static_cast<T>(found - texts.begin());
}

bool read_edge(RecordWords words, DrawnPath& outline) {
    const Vec2d start = words.point();
    const std::string_view kind = words.word();
    OutlineEdge edge;
    if (kind == "QUADRATIC") {
        edge.kind = CurveKind::Quadratic;
        edge.control[0] = words.point();
    } else if (kind == "CUBIC") {
        edge.kind = CurveKind::Cubic;
        edge.control[0] = words.point();
        edge.control[1] = words.point();
    } else if (kind == "ARC") {
        edge.kind = CurveKind::Arc;
        edge.arc_radius = words.real();
        edge.is_large_arc = words.whole() == 1;
        edge.turns_right = words.whole() == 1;
        if (!(edge.arc_radius > 0)) words.refuse();
    } else if (kind != "LINE") {
        words.refuse();
    }
    if (!words.is_good() || outline.edges.size() >= kMaxEdges) return false;
    if (!outline.edges.empty()) outline.edges.back().end = static_cast<int>(outline.vertices.size());
    edge.start = static_cast<int>(outline.vertices.size());
    edge.end = 0;
    outline.vertices.push_back(start);
    outline.edges.push_back(edge);
    outline.is_closed = true;
    return true;
}

bool read_notch(RecordWords words, std::vector<Notch>& notches) {
    Notch notch{.edge = words.whole(), .t = words.real()};
    notch.kind = value_of_name<NotchKind>(words.word(), words);
    notch.count = words.whole();
    if (!words.is_good() || !(notch.t >= 0 && notch.t <= 1)) return false;
    notch.count = std::clamp(notch.count, 1, kMostNotchesTogether);
    notches.push_back(notch);
    return true;
}

bool read_property(RecordWords words, DxfRecords& records) {
    const std::string_view what = words.word();
    const auto number = static_cast<std::size_t>(words.whole());
    if (!words.is_good()) return false;
    if (what == "edge" && number < records.outline.edges.size())
        return read_record_phrase(words.rest(), records.outline.edges[number]);
    return what == "line" && number < records.lines.size() && read_record_phrase(words.rest(), records.lines[number]);
}

}  // namespace

bool read_dxf_record(const std::string& text, DxfRecords& records) {
    RecordWords words(text);
    if (words.word() != "SELVEDGE") return false;
    const std::string_view what = words.word();
    if (what == "EDGE") return read_edge(words, records.outline);
    if (what == "NOTCH") return read_notch(words, records.notches);
    if (what == "OF") return read_property(words, records);
    if (what == "PLACED") {
        if (!records.placement) records.placement.emplace();
        records.is_placement_broken |= !read_placement_phrase(words.rest(), *records.placement);
        return true;
    }
    if (what != "LINE") return false;
    const LineUse use = value_of_name<LineUse>(words.word(), words);
    if (words.is_good()) records.lines.push_back({.name = words.rest(), .points = {}, .use = use});
    return words.is_good();
}

std::optional<DrawnSeam> read_dxf_seam(const std::string& text) {
    RecordWords words(text);
    words.word();
    words.word();
    DrawnSeam seam;
    seam.first = words.side();
    seam.second = words.side();
    seam.is_reversed = words.word() != "same";
    const std::string_view ease = words.word();
    seam.is_eased = ease == "eased";
    seam.name = words.rest();
    if (!words.is_good() || (ease != "eased" && ease != "exact")) return std::nullopt;
    return seam;
}

std::optional<DxfSewing> read_dxf_sewing(const std::string& text) {
    RecordWords words(text);
    words.word();
    words.word();
    DxfSewing sewing{.side = words.side(), .number = std::string(words.word()), .name = words.rest()};
    if (!words.is_good() || sewing.number.empty()) return std::nullopt;
    return sewing;
}

bool read_dxf_seam_property(const std::string& text, std::vector<DrawnSeam>& seams) {
    RecordWords words(text);
    words.word();
    words.word();
    const SeamSide side = words.side();
    const auto seam = std::ranges::find(seams, side, &DrawnSeam::first);
    return words.is_good() && seam != seams.end() && read_record_phrase(words.rest(), *seam);
}

bool is_outline_on(const DrawnPath& outline, const std::vector<Vec2d>& polyline, double tolerance) {
    if (outline.edges.size() < 2 || polyline.size() < 3) return false;
    const Panel panel = as_panel(outline);
    const auto is_on = [&](const Vec2d& p) { return distance_to_outline(p, polyline) <= tolerance; };
    return std::ranges::all_of(panel.edges, [&](const OutlineEdge& edge) {
        const double reach = edge.kind == CurveKind::Arc ? 2 * edge.arc_radius : kFar;
        const Vec2d chord =
            panel.vertices[static_cast<std::size_t>(edge.end)] - panel.vertices[static_cast<std::size_t>(edge.start)];
        if (!(chord.norm() > 0) || chord.norm() > reach) return false;
        return std::ranges::all_of(std::array{0.0, 0.25, 0.5, 0.75},
                                   [&](double t) { return is_on(outline_point(panel, edge, t)); });
    });
}

}  // namespace selvedge::sim
