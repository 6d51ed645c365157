#include "sim/paper/freesewing_lines.h"

#include <algorithm>
#include <array>
#include <vector>

#include "sim/core/lower_case.h"
#include "sim/paper/cut_text.h"

namespace selvedge::sim {
namespace {

constexpr std::array<std::string_view, 5> kMaterials{"fabric", "lining", "interfacing", "canvas", "various"};

bool has(const std::vector<std::string>& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

}  // namespace

LineKind kind_of(const FreesewingLine& line) {
    const std::vector<std::string> classes = words_of(line.classes);
    const std::string name = lower_case(line.name);
    const auto names = [&](std::string_view part) { return name.find(part) != std::string::npos; };
    if (names("cutonfold") || names("cut on fold")) return LineKind::FoldEdge;
    if (names("grainline")) return LineKind::Grain;
    if (has(classes, "hidden") || has(classes, "scalebox") || names("scalebox")) return LineKind::Help;
    if (names("fold") && !line.is_closed) return LineKind::FoldLine;
    const bool is_material = std::ranges::any_of(kMaterials, [&](std::string_view one) { return has(classes, one); });
    const bool is_broken = std::ranges::any_of(std::array<std::string_view, 4>{"dashed", "dotted", "lashed", "mark"},
                                               [&](std::string_view one) { return has(classes, one); });
    if (has(classes, "sa")) return LineKind::Cut;
    if (has(classes, "help") || has(classes, "contrast")) return LineKind::Help;
    if (is_broken) return LineKind::Internal;
    if (is_material) return line.is_closed ? LineKind::Sew : LineKind::Internal;
    // Some designs give their sewing line no class.
    return line.is_closed && !has(classes, "note") ? LineKind::Sew : LineKind::Help;
}

bool read_snippet(std::string_view name, DrawnMark& mark) {
    if (name == "notch" || name == "bnotch") {
        mark.kind = MarkKind::Notch;
        mark.count = name == "bnotch" ? 2 : 1;
        return true;
    }
    if (name.starts_with("buttonhole")) {
        mark.kind = MarkKind::Buttonhole;
        return true;
    }
    if (name == "button" || name.starts_with("snap")) {
        mark.kind = MarkKind::Button;
        return true;
    }
    return false;
}

}  // namespace selvedge::sim
