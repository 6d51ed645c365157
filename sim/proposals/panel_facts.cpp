#include "sim/proposals/panel_facts.h"

#include <algorithm>
#include <map>
#include <string>

#include "sim/core/math.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr std::string_view kOuterWords = "side outside outer seiten fianco flanc zijpand бок боч";
constexpr std::string_view kInnerWords = "inside inner cent middle mitte milieu средн";
constexpr std::string_view kOpeningWords = "placket button knopf bouton boton планк застеж";

// The mean length of the lower edges of sleeves, or of legs if there is no sleeve, m; 0: there is none.
double mean_hem(const Pattern& pattern, const std::vector<PanelRole>& roles) {
    constexpr double kLevel = 0.75;  // least run of a level edge over its length
    for (const GarmentPart part : {GarmentPart::Sleeve, GarmentPart::Leg}) {
        double sum = 0;
        int count = 0;
        for (std::size_t p = 0; p < roles.size(); ++p) {
            if (roles[p].part != part) continue;
            const Panel& panel = pattern.panels[p];
            double hem = 0;
            for (const OutlineEdge& edge : panel.edges) {
                const Vec2d along = outline_point(panel, edge, 1) - outline_point(panel, edge, 0);
                const double length = outline_length(panel, edge);
                if (along.x() > kLevel * length) hem += length;  // counter-clockwise: lower edges run to the right
            }
            if (hem > 0) sum += hem, ++count;
        }
        if (count > 0) return sum / count;
    }
    return 0;
}

// The number at the end of a name; 0: there is none, or no word before it.
int number_of(std::string_view name) {
    const std::size_t word = name.find_last_not_of("0123456789");
    constexpr std::size_t kMostDigits = 3;
    if (word == name.npos || word + 1 == name.size() || name.size() - word - 1 > kMostDigits) return 0;
    int number = 0;
    for (const char digit : name.substr(word + 1)) number = 10 * number + (digit - '0');
    return number;
}

// The panels between front and back that a garment of more than two lengths of cloth has.
void find_sides(std::vector<PanelFacts>& facts) {
    constexpr double kLeastHeight = 0.5;  // of the highest front or back
    double highest = 0;
    for (const PanelFacts& one : facts) {
        if (one.role.part == GarmentPart::Torso && one.role.face != Face::None) highest = std::max(highest, one.height);
    }
    bool is_any = false;
    for (PanelFacts& one : facts) {
        const bool is_of_trunk = one.role.part == GarmentPart::Torso || one.role.part == GarmentPart::Unknown;
        one.is_side = is_of_trunk && one.is_outer && one.role.face == Face::None && highest > 0 &&
                      one.height > kLeastHeight * highest;
        is_any = is_any || one.is_side;
    }
    for (PanelFacts& one : facts) one.has_side_panel = is_any;
}

// Panels without a part that are called by one word and the numbers from 1 on, as those of a corset, lie side by side
// in this order. A program that only tells equal names apart begins with 2.
void find_rows(const Pattern& pattern, std::vector<PanelFacts>& facts) {
    constexpr int kShortestRow = 3;
    std::map<std::string, std::map<int, std::size_t>> rows;  // by word and number
    for (std::size_t p = 0; p < facts.size(); ++p) {
        const Panel& panel = pattern.panels[p];
        const int number = number_of(panel.name);
        if (number == 0 || !panel.mirror_of.empty() || facts[p].role.part != GarmentPart::Unknown) continue;
        rows[panel.name.substr(0, panel.name.find_last_not_of("0123456789") + 1)].emplace(number, p);
    }
    for (const auto& [word, row] : rows) {
        const int length = static_cast<int>(row.size());
        if (length < kShortestRow || row.begin()->first != 1 || row.rbegin()->first != length) continue;
        for (const auto& [number, p] : row) {
            for (const int own : {static_cast<int>(p), facts[p].twin}) {
                if (own < 0) continue;
                facts[as_size(own)].rank = number;
                facts[as_size(own)].row_length = length;
            }
        }
    }
}

}  // namespace

bool is_at_side(const PanelFacts& panel, double x) {
    constexpr double kNear = 0.02;  // of the width
    return std::abs(x - panel.axis) > (0.5 - kNear) * panel.width;
}

std::vector<PanelFacts> facts_of(const Pattern& pattern, std::string_view hints) {
    const std::vector<PanelRole> roles = roles_of(pattern, hints);
    std::vector<PanelFacts> all;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const Panel& panel = pattern.panels[p];
        PanelFacts facts{.role = roles[p]};
        const std::vector<std::string> words = words_of_name(panel.name);
        facts.is_outer = names_any(words, kOuterWords);
        facts.is_inner = names_any(words, kInnerWords);
        const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
        facts.axis = box.center().x();
        facts.width = box.sizes().x();
        facts.height = box.sizes().y();
        const double tolerance = 0.002 + 0.002 * facts.width;  // m
        facts.is_symmetric = std::ranges::all_of(panel.edges, [&](const OutlineEdge& edge) {
            const Vec2d v = panel.vertices[static_cast<std::size_t>(edge.start)];
            return std::ranges::any_of(panel.edges, [&](const OutlineEdge& other) {
                const Vec2d w = panel.vertices[static_cast<std::size_t>(other.start)];
                return (Vec2d(2 * facts.axis - v.x(), v.y()) - w).norm() < tolerance;
            });
        });
        for (std::size_t q = 0; q < pattern.panels.size(); ++q) {
            const Panel& other = pattern.panels[q];
            if (are_mirror_images(panel, other)) facts.twin = static_cast<int>(q);
        }
        all.push_back(facts);
    }
    find_rows(pattern, all);
    find_sides(all);
    const bool has_opening = std::ranges::any_of(
        pattern.panels, [](const Panel& panel) { return names_any(words_of_name(panel.name), kOpeningWords); });
    const double opening = mean_hem(pattern, roles);
    for (PanelFacts& facts : all) {
        if (facts.role.part == GarmentPart::Cuff) facts.opening = opening;
        facts.has_opening = has_opening;
        facts.has_other_face = std::ranges::any_of(all, [&](const PanelFacts& other) {
            return other.role.part == facts.role.part && other.role.face != facts.role.face &&
                   other.role.face != Face::None && facts.role.face != Face::None;
        });
    }
    return all;
}

}  // namespace selvedge::sim
