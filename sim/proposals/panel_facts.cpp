#include "sim/proposals/panel_facts.h"

#include <algorithm>

#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr std::string_view kOuterWords = "side outside outer seiten fianco flanc zijpand бок боч";
constexpr std::string_view kInnerWords = "inside inner cent middle mitte milieu средн";
constexpr std::string_view kOpeningWords = "placket button zip knopf bouton boton планк застеж";

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

}  // namespace

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
