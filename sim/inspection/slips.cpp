#include "sim/inspection/slips.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "sim/inspection/body_heights.h"
#include "sim/inspection/hoop_support.h"
#include "sim/place/body_girths.h"
#include "sim/place/level_on.h"

namespace selvedge::sim {

namespace {

// The girth of the wearer's trunk at this height, m; 0 where there is none.
double girth_at(const BodyPair& bodies, double y) {
    const auto girth = trunk_girth(bodies.wearer, y);
    return girth ? girth->length() : 0;
}

// The girth of the wearer that an edge must not exceed, m: of the bust, or where the edge was placed.
double girth_that_holds(const TrunkEdge& edge, const BodyPair& bodies) {
    const auto bust = edge.is_of_chest ? bust_girth(bodies.wearer) : std::nullopt;
    return bust ? bust->length() : girth_at(bodies, edge.placed);
}

// "the upper edge of 'front' lies 7 cm lower than it was placed".
std::string describe(const TrunkEdge& lowered, const GarmentMesh& mesh) {
    return "the " + std::string(lowered.is_of_chest ? "upper edge" : "waist") + " of '" +
           mesh.panel_names[static_cast<std::size_t>(lowered.edge->panels.front())] + "' lies " +
           in_centimetres(std::abs(lowered.moved())) + (lowered.moved() < 0 ? " higher" : " lower") +
           " than it was placed";
}

// An edge that slipped: "the upper edge of 'front' lies 7 cm lower than it was placed, below the chest". If it is at
// least 1 cm longer than the girth that should hold it, it says so: "too large above the chest by 14 cm: ...".
DressFault fault_of_slip(const TrunkEdge& lowered, const GarmentMesh& mesh, double girth) {
    const std::string lies = describe(lowered, mesh) + ", below the " + lowered.holder();
    constexpr double kLeast = 0.01;  // m, by which an edge is too large
    const double excess = lowered.edge->length - girth;
    if (girth <= 0 || excess < kLeast) return {.kind = "displaced", .place = lies, .value = lowered.moved()};
    return {
        .kind = "does_not_fit",
        .place = "too large above the " + std::string(lowered.holder()) + " by " + in_centimetres(excess) + ": " + lies,
        .value = excess};
}

// "too stretchy above the hips: stretched to the fabric's limit, the cloth below the waist of 'wb_front' carries at
// most 1.2 of the garment's 3.0 N, and it lies 68 cm lower than it was placed". None if its hoop tension and friction
// can carry the garment anywhere between where the edge was placed and what should hold it.
std::optional<DressFault> weakness_of(const TrunkEdge& lowered, const WornGarment& garment, const Cloth& cloth,
                                      const BodyPair& bodies) {
    constexpr double kStep = 0.02;  // m, between heights at which the body is measured
    const std::vector<Fabric>& fabrics = cloth.material.fabrics;
    std::map<long, double> girths;  // at multiples of kStep, because sections are slow
    const auto level = [&](long i) {
        const auto [at, is_new] = girths.try_emplace(i, 0);
        if (is_new) at->second = girth_at(bodies, static_cast<double>(i) * kStep);
        return at->second;
    };
    const GirthAtHeight girth = [&](double y) {
        const long below = std::lround(std::floor(y / kStep));
        const double share = y / kStep - static_cast<double>(below);
        return (1 - share) * level(below) + share * level(below + 1);
    };
    double friction = 0;
    for (const int p : lowered.edge->panels)
        friction = std::max(friction, fabrics[static_cast<std::size_t>(p)].friction);
    const double weight = weight_below(garment.closed, *lowered.edge, fabrics);
    const double carried = largest_hoop_support(hoop_rows(garment.closed, *lowered.edge, fabrics), girth, friction,
                                                lowered.held_at, lowered.placed);
    if (carried >= weight) return std::nullopt;
    char text[64];
    std::snprintf(text, sizeof text, "%.1f of the garment's %.1f N", carried, weight);
    const auto panel = static_cast<std::size_t>(lowered.edge->panels.front());
    return DressFault{.kind = "does_not_fit",
                      .place = "too stretchy above the " + std::string(lowered.holder()) +
                               ": stretched to the fabric's limit, the cloth below the " +
                               (lowered.is_of_chest ? "upper edge" : "waist") + " of '" +
                               garment.panels.panel_names[panel] + "' carries at most " + text + ", and it lies " +
                               in_centimetres(lowered.moved()) + " lower than it was placed",
                      .value = weight - carried,
                      .unit = "N"};
}

}  // namespace

bool does_not_fit(const Slip& slip) {
    return class_of(slip.fault) == FaultClass::DoesNotFit;
}

std::vector<TrunkEdge> trunk_edges(const WornGarment& garment, const MeantOpenings& meant, const BodyPair& bodies) {
    std::vector<TrunkEdge> edges;
    const Heights from = heights_of(bodies.meant_for), to = heights_of(bodies.worn_by);
    if (!is_ascending(from) || !is_ascending(to)) return edges;
    // The bust holds an edge that was placed nearer to the chest than to the waist; there it has left the bust.
    const double hips = to[1], chest = to[3], under_bust = (to[2] + chest) / 2;
    const std::vector<Opening>& openings = meant.openings;
    std::map<std::size_t, std::size_t> edge_of;  // by part
    for (std::size_t i = 0; i < openings.size(); ++i) {
        const std::size_t limbs = meant.limbs.through[i].count(), others = meant.limbs.known.count() - limbs;
        if (limbs < 2 || others < 2) continue;       // a neckline, an armhole, a cuff or a leg's hem
        if (meant.hang_from_shoulders[i]) continue;  // a hem
        double placed = 0;
        for (const int v : openings[i].vertices)
            placed += level_on(garment.closed.x[static_cast<std::size_t>(v)].y(), from, to);
        placed /= static_cast<double>(openings[i].vertices.size());
        const TrunkEdge lowered{.edge = &openings[i],
                                .placed = placed,
                                .draped = centre_of(openings[i], garment.closed_draped).y(),
                                .held_at = placed > chest        ? chest
                                           : placed > under_bust ? under_bust
                                                                 : hips,
                                .is_of_chest = placed > under_bust};
        if (placed < lowered.held_at) continue;
        const auto [of_part, is_first] = edge_of.try_emplace(meant.parts[i], edges.size());
        if (is_first) {
            edges.push_back(lowered);
        } else if (placed > edges[of_part->second].placed) {
            edges[of_part->second] = lowered;
        }
    }
    return edges;
}

std::vector<TrunkEdge> lowered_edges(const WornGarment& garment, const MeantOpenings& meant, const BodyPair& bodies) {
    std::vector<TrunkEdge> edges = trunk_edges(garment, meant, bodies);
    std::erase_if(edges, [](const TrunkEdge& edge) { return edge.moved() < kWaistbandWidth; });
    return edges;
}

std::vector<Slip> find_slips(const std::vector<TrunkEdge>& edges, const Cloth& cloth, const WornGarment& garment,
                             const BodyPair& bodies) {
    std::vector<Slip> slips;
    for (const TrunkEdge& lowered : edges) {
        if (!lowered.has_slipped()) continue;
        DressFault fault = fault_of_slip(lowered, garment.panels, girth_that_holds(lowered, bodies));
        if (class_of(fault) == FaultClass::Defect) {
            if (auto weakness = weakness_of(lowered, garment, cloth, bodies)) fault = std::move(*weakness);
        }
        slips.push_back({.fault = std::move(fault), .panel = static_cast<std::size_t>(lowered.edge->panels.front())});
    }
    return slips;
}

void note_lowered_edges(const std::vector<TrunkEdge>& edges, const WornGarment& garment, DressReport& report) {
    for (const TrunkEdge& lowered : edges) {
        if (!lowered.has_slipped()) report.notes.push_back(describe(lowered, garment.panels));
    }
}

void note_raised_edges(const std::vector<TrunkEdge>& edges, const WornGarment& garment, DressReport& report) {
    for (const TrunkEdge& raised : edges) {
        if (-raised.moved() >= kWaistbandWidth) report.notes.push_back(describe(raised, garment.panels));
    }
}

}  // namespace selvedge::sim
