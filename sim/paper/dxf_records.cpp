#include "sim/paper/dxf_records.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "sim/paper/dxf_text.h"
#include "sim/paper/path_builder.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

constexpr double kLargest = 1e6;  // mm

// Words of a record, from the third on.
class Words {
 public:
    explicit Words(std::string_view text) : rest_(text) {}

    std::string_view word() {
        while (rest_.starts_with(' ')) rest_.remove_prefix(1);
        const std::string_view found = rest_.substr(0, rest_.find(' '));
        rest_.remove_prefix(found.size());
        return found;
    }

    double real() {
        const auto value = dxf_number(word());
        if (!value || !(std::abs(*value) < kLargest)) is_good_ = false;
        return is_good_ ? *value : 0;
    }

    int whole() { return whole_of(word()); }

    Vec2d point() {
        const double x = real();
        return {x, real()};
    }

    // "3:2"
    SeamSide side() {
        const std::string_view text = word();
        const std::size_t colon = text.find(':');
        if (colon == std::string_view::npos) is_good_ = false;
        if (!is_good_) return {};
        return {whole_of(text.substr(0, colon)), whole_of(text.substr(colon + 1))};
    }

    std::string rest() const {
        const std::size_t at = rest_.find_first_not_of(' ');
        return at == std::string_view::npos ? std::string() : std::string(rest_.substr(at));
    }

    void refuse() { is_good_ = false; }
    bool is_good() const { return is_good_; }

 private:
    int whole_of(std::string_view text) {
        constexpr int kMost = 100000;
        int value = 0;
        const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || stop != text.data() + text.size() || value < 0 || value > kMost) is_good_ = false;
        return is_good_ ? value : 0;
    }

    std::string_view rest_;
    bool is_good_ = true;
};

template <class T>
T value_of_name(std::string_view name, Words& words) {
    const auto& texts = names_of(T{}).texts;
    const auto found = std::ranges::find(texts, name);
    if (found == texts.end()) words.refuse();
    return found == texts.end() ? T{} : static_cast<T>(found - texts.begin());
}

bool read_edge(Words words, DrawnPath& outline) {
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

bool read_notch(Words words, std::vector<Notch>& notches) {
    Notch notch{.edge = words.whole(), .t = words.real()};
    notch.kind = value_of_name<NotchKind>(words.word(), words);
    notch.count = words.whole();
    if (!words.is_good() || !(notch.t >= 0 && notch.t <= 1)) return false;
    notch.count = std::clamp(notch.count, 1, kMostNotchesTogether);
    notches.push_back(notch);
    return true;
}

}  // namespace

bool read_dxf_record(const std::string& text, DxfRecords& records) {
    Words words(text);
    if (words.word() != "SELVEDGE") return false;
    const std::string_view what = words.word();
    if (what == "EDGE") return read_edge(words, records.outline);
    if (what == "NOTCH") return read_notch(words, records.notches);
    if (what != "LINE") return false;
    const LineUse use = value_of_name<LineUse>(words.word(), words);
    if (words.is_good()) records.lines.push_back({.name = words.rest(), .points = {}, .use = use});
    return words.is_good();
}

std::optional<DrawnSeam> read_dxf_seam(const std::string& text) {
    Words words(text);
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
    Words words(text);
    words.word();
    words.word();
    DxfSewing sewing{.side = words.side(), .number = std::string(words.word()), .name = words.rest()};
    if (!words.is_good() || sewing.number.empty()) return std::nullopt;
    return sewing;
}

bool is_outline_on(const DrawnPath& outline, const std::vector<Vec2d>& polyline, double tolerance) {
    if (outline.edges.size() < 2 || polyline.size() < 3) return false;
    const Panel panel = as_panel(outline);
    const auto is_on = [&](const Vec2d& p) { return distance_to_outline(p, polyline) <= tolerance; };
    return std::ranges::all_of(panel.edges, [&](const OutlineEdge& edge) {
        const double reach = edge.kind == CurveKind::Arc ? 2 * edge.arc_radius : kLargest;
        const Vec2d chord =
            panel.vertices[static_cast<std::size_t>(edge.end)] - panel.vertices[static_cast<std::size_t>(edge.start)];
        if (!(chord.norm() > 0) || chord.norm() > reach) return false;
        return std::ranges::all_of(std::array{0.0, 0.25, 0.5, 0.75},
                                   [&](double t) { return is_on(outline_point(panel, edge, t)); });
    });
}

}  // namespace selvedge::sim
