#include "sim/inspection/wearing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "sim/body/section.h"
#include "sim/core/assert.h"
#include "sim/core/disjoint_sets.h"
#include "sim/core/math.h"
#include "sim/inspection/body_heights.h"
#include "sim/inspection/carried.h"
#include "sim/inspection/hoop_support.h"
#include "sim/inspection/rolled_edges.h"
#include "sim/mesh/sew.h"
#include "sim/place/level_on.h"
#include "sim/place/limb_pieces.h"
#include "sim/place/limbs.h"
#include "sim/place/openings.h"

namespace selvedge::sim {

// Parts of WearingCheck::Known: so they have external linkage.

// The garment before and after draping: its separate panels, and the same with all seams closed. A seam that did not
// close joins its two sides here at their mean positions.
struct WornGarment {
    GarmentMesh panels;                // as placed
    std::vector<Vec3d> draped;         // m, per vertex of `panels`
    GarmentMesh closed;                // as placed
    std::vector<int> in_closed;        // vertex of `closed`, per vertex of `panels`
    std::vector<Vec3d> closed_draped;  // m, per vertex of `closed`
};

// The openings of a garment, and the limbs that were meant to leave through each.
struct MeantOpenings {
    std::vector<Opening> openings;
    LimbPassages limbs;
    std::vector<bool> hang_from_shoulders;  // per opening: what it belongs to does, so it need not hold anything up
};

namespace {

// The garment as it was placed.
WornGarment undraped(GarmentMesh unsewn) {
    WornGarment garment{.panels = unsewn, .draped = unsewn.x, .closed = unsewn, .in_closed = {}, .closed_draped = {}};
    garment.in_closed = merge_seams(garment.closed);
    return garment;
}

WornGarment compare_drape(const Cloth& cloth, const GarmentMesh& sewn, WornGarment garment) {
    for (std::size_t t = 0; t < sewn.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto now = static_cast<std::size_t>(sewn.triangles[t].vertices[k]);
            garment.draped[static_cast<std::size_t>(garment.panels.triangles[t].vertices[k])] =
                cloth.x[now].head<3>().cast<double>();
        }
    }
    garment.closed_draped.assign(garment.closed.x.size(), Vec3d::Zero());
    std::vector<int> joined(garment.closed.x.size(), 0);
    for (std::size_t v = 0; v < garment.draped.size(); ++v) {
        const auto at = static_cast<std::size_t>(garment.in_closed[v]);
        garment.closed_draped[at] += garment.draped[v];
        ++joined[at];
    }
    for (std::size_t v = 0; v < joined.size(); ++v) garment.closed_draped[v] /= joined[v];
    return garment;
}

// "the left arm and the right arm"
std::string list_limbs(LimbSet limbs) {
    std::string text;
    for (std::size_t i = 0; i < kLimbCount; ++i) {
        if (limbs[i]) text += (text.empty() ? "the " : " and the ") + std::string(name_of(static_cast<LimbKind>(i)));
    }
    return text;
}

// The arm to which most of the vertices are nearest.
std::optional<LimbKind> arm_of(const std::vector<std::size_t>& vertices, const std::vector<Vec3d>& x,
                               const BodyLimbs& body) {
    std::vector<Vec3d> points;
    for (const std::size_t v : vertices) points.push_back(x[v]);
    return arm_nearest_to(points, body, 0.5);
}

// What a tailor calls an opening for these limbs, from its place on the body for which the garment was placed.
std::string_view call_opening(LimbSet limbs, std::string_view place, bool is_of_sleeve) {
    if (limbs.none()) return "opening";
    if (limbs.count() > 2 && !limbs[index_of(LimbKind::Head)]) return "hem";  // of a poncho, flat or not
    if (limbs.count() == 1 && limbs[index_of(LimbKind::Head)]) return "neckline";
    if (limbs.count() == 1 && (limbs[index_of(LimbKind::LeftArm)] || limbs[index_of(LimbKind::RightArm)]))
        return is_of_sleeve ? "cuff" : "armhole";
    if (place == "waist") return "waist";
    return place == "chest" || place == "neck" ? "upper edge" : "hem";
}

// The limbs that should not be in the opening, and those that should but are not.
struct Mismatch {
    LimbSet expected;
    LimbSet extra;
    LimbSet missing;
};

// Both sets are only defined up to their complement: what leaves through a skirt's waist is all that does not leave
// through its hem. The smaller one is what a tailor names, but for a poncho's hem: all limbs but the head.
std::optional<Mismatch> compare(LimbSet expected, LimbSet found, LimbSet known) {
    expected &= known;
    found &= known;
    const LimbSet others = known & ~expected;
    const bool is_for_all_but_head = others.count() == 1 && others[index_of(LimbKind::Head)];
    if (!is_for_all_but_head || found.none() || found == known) {
        if (expected.count() > others.count()) {
            expected = others;
            found = known & ~found;
        }
        if (2 * (expected ^ found).count() > known.count()) found = known & ~found;
    }
    if (expected == found) return std::nullopt;
    return Mismatch{.expected = expected, .extra = found & ~expected, .missing = expected & ~found};
}

// The openings that miss a limb, and those that hold it but should not: "the hem of 'skirt_front'".
struct MissedLimb {
    std::vector<std::string> missing;
    std::vector<std::string> holding;

    bool operator==(const MissedLimb&) const = default;
};
using MissedLimbs = std::array<MissedLimb, kLimbCount>;

void add_mismatch(MissedLimbs& missed, const Mismatch& mismatch, const std::string& opening) {
    for (std::size_t i = 0; i < kLimbCount; ++i) {
        for (auto [is_so, openings] :
             {std::pair(mismatch.missing[i], &missed[i].missing), std::pair(mismatch.extra[i], &missed[i].holding)}) {
            // Both ends of a sleeve may have one name.
            if (is_so && std::ranges::find(*openings, opening) == openings->end()) openings->push_back(opening);
        }
    }
}

std::string joined(const std::vector<std::string>& texts, const std::string& word) {
    std::string text;
    for (const std::string& one : texts) text += (text.empty() ? "" : " " + word + " ") + one;
    return text;
}

// "the left arm does not pass through the cuff of 'sleeve'; the hem of 'front' holds it"
std::string describe(LimbSet limbs, const MissedLimb& missed) {
    const bool is_one = limbs.count() == 1;
    std::string text;
    if (!missed.missing.empty()) {
        text = list_limbs(limbs) + (is_one ? " does" : " do") + " not pass through " + joined(missed.missing, "or");
        if (missed.holding.empty()) return text;
        text += "; ";
    }
    const std::string held = missed.missing.empty() ? list_limbs(limbs) : is_one ? "it" : "them";
    return text + joined(missed.holding, "and") + (missed.holding.size() == 1 ? " holds " : " hold ") + held;
}

// One fault for all limbs that miss the same openings.
void report_missed(const MissedLimbs& missed, DressReport& report) {
    LimbSet named;
    for (std::size_t i = 0; i < kLimbCount; ++i) {
        if (named[i] || missed[i] == MissedLimb{}) continue;
        LimbSet alike;
        for (std::size_t k = i; k < kLimbCount; ++k) alike[k] = missed[k] == missed[i];
        named |= alike;
        add_fault(
            report,
            {.kind = "limb_missed", .place = describe(alike, missed[i]), .value = static_cast<double>(alike.count())});
    }
}

// The body for which a garment was placed, and the one that wears it.
struct BodyPair {
    const BodyLimbs& meant_for;
    const BodyLimbs& worn_by;
    const Body& wearer;
};

using PanelVertices = std::vector<std::vector<std::size_t>>;  // per panel, ascending

PanelVertices vertices_by_panel(const GarmentMesh& mesh) {
    PanelVertices panels(mesh.panel_names.size());
    for (const GarmentTriangle& t : mesh.triangles) {
        for (const int v : t.vertices) panels[static_cast<std::size_t>(t.panel)].push_back(static_cast<std::size_t>(v));
    }
    for (std::vector<std::size_t>& vertices : panels) {
        std::ranges::sort(vertices);
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
    return panels;
}

void validate_openings(const WornGarment& garment, const PanelVertices& panels, const MeantOpenings& meant,
                       const BodyPair& bodies, DressReport& report) {
    const std::vector<Opening>& openings = meant.openings;
    // Level 0 cuts the corners that its leaves go round. If no leaf is inside the body, a limb meets cloth only there.
    const LimbPassages found = find_passages(garment.closed, garment.closed_draped, openings, bodies.worn_by,
                                             {.ends_at_cloth = report.contact.faces_in_body == 0});
    LimbSet known = meant.limbs.known & found.known;
    // An arm that leaves through the end of its own sleeve is where it belongs, whatever follows from how the panels
    // were placed: those of a sleeve that stands open do not hold it.
    std::vector<std::optional<LimbKind>> arms;  // per opening: whose sleeve it ends
    for (const Opening& opening : openings)
        arms.push_back(
            arm_of(panels[static_cast<std::size_t>(opening.panels.front())], garment.panels.x, bodies.meant_for));
    const auto is_for = [](const LimbSet& limbs, LimbKind arm) { return limbs.count() == 1 && limbs[index_of(arm)]; };
    for (std::size_t i = 0; i < openings.size(); ++i) {
        if (!arms[i] || !is_for(found.through[i], *arms[i])) continue;
        // Another opening of the sleeve, as a slit at the elbow, is none where the cuff follows from the panels.
        bool is_cuff_known = false;
        for (std::size_t j = 0; j < openings.size(); ++j)
            is_cuff_known = is_cuff_known || (arms[j] == arms[i] && is_for(meant.limbs.through[j], *arms[i]));
        if (!is_cuff_known) known[index_of(*arms[i])] = false;
    }
    MissedLimbs missed;
    for (std::size_t i = 0; i < openings.size(); ++i) {
        const auto mismatch = compare(meant.limbs.through[i], found.through[i], known);
        if (!mismatch) continue;
        const auto panel = static_cast<std::size_t>(openings[i].panels.front());
        const std::string place = place_on_body(bodies.meant_for, centre_of(openings[i], garment.closed.x));
        const std::string name = "the " + std::string(call_opening(mismatch->expected, place, arms[i].has_value())) +
                                 " of '" + garment.panels.panel_names[panel] + "'";
        add_mismatch(missed, *mismatch, name);
    }
    report_missed(missed, report);
}

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void extend(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    double middle() const { return (low + high) / 2; }
    double length() const { return high - low; }
};

struct PanelShift {
    double moved = 0;              // m, upward, of the middle
    Vec3d middle = Vec3d::Zero();  // m, draped
    bool is_displaced = false;
    bool is_bunched = false;   // it was pushed up, and does not hang down again
    bool is_at_place = false;  // so that seams may have drawn other panels to it
};

// A panel is displaced if it has left more than half of the heights over which it was placed: what is gone lies where
// another part of the garment belongs. Panels stand free of the body and settle on it, a waistband by more than its
// width, and a poncho that is placed flat hangs down; so a panel shorter than from the hips to the waist may also be
// off by half of what it is shorter.
PanelShift measure_shift(const WornGarment& garment, const std::vector<std::size_t>& vertices, const Heights& from,
                         const Heights& to) {
    constexpr double kLeastCovered = 0.5;  // of the heights
    constexpr double kHanging = 0.7;       // of its own height as placed: what hangs with folds has more of it left
    Range own, placed, draped;
    PanelShift shift;
    for (const std::size_t v : vertices) {
        own.extend(garment.panels.x[v].y());
        placed.extend(level_on(garment.panels.x[v].y(), from, to));
        draped.extend(garment.draped[v].y());
        shift.middle += garment.draped[v] / static_cast<double>(vertices.size());
    }
    shift.moved = draped.middle() - placed.middle();
    const double reach = std::max(0.0, (to[2] - to[1] - placed.length()) / 2);
    const double covered = std::min(placed.high, draped.high + reach) - std::max(placed.low, draped.low - reach);
    shift.is_displaced = covered < kLeastCovered * placed.length();
    shift.is_bunched = shift.is_displaced && shift.moved > 0 && draped.length() < kHanging * own.length();
    shift.is_at_place = !shift.is_displaced && std::abs(shift.moved) <= (to[2] - to[1]) / 2;
    return shift;
}

// Whether a panel that was placed on the head, as those of a hood are, lies below its middle.
bool is_off_head(const WornGarment& garment, const std::vector<std::size_t>& vertices, const BodyPair& bodies) {
    const Limb &from = bodies.meant_for[LimbKind::Head], &to = bodies.worn_by[LimbKind::Head];
    if (from.joints.size() < 2 || to.joints.size() < 2) return false;
    Range placed, draped;
    for (const std::size_t v : vertices) {
        placed.extend(garment.panels.x[v].y());
        draped.extend(garment.draped[v].y());
    }
    const double neck = from.joints[0].centre.y(), middle = from.joints[1].centre.y();
    return placed.middle() > neck && placed.high > middle && draped.high < to.joints[1].centre.y();
}

// Per panel, the first of those that seams join it with.
std::vector<std::size_t> garment_parts(const WornGarment& garment, const PanelVertices& panels) {
    DisjointSets parts(panels.size());
    std::vector<int> panel_at(garment.closed.x.size(), -1);
    for (std::size_t p = 0; p < panels.size(); ++p) {
        for (const std::size_t v : panels[p]) {
            int& panel = panel_at[static_cast<std::size_t>(garment.in_closed[v])];
            if (panel >= 0) parts.join(panel, static_cast<int>(p));
            panel = static_cast<int>(p);
        }
    }
    std::vector<std::size_t> first;
    for (std::size_t p = 0; p < panels.size(); ++p)
        first.push_back(static_cast<std::size_t>(parts.find(static_cast<int>(p))));
    return first;
}

// The girth of the wearer's trunk at this height, m.
double girth_at(const BodyPair& bodies, double y) {
    const Plane plane{.point = Vec3d(0, y, 0)};
    const HeightRange& height = bodies.worn_by.height;
    SectionLoop trunk;
    trunk.points = trunk_points(bodies.wearer, y, height.high - height.low);
    return trunk.points.empty() ? 0 : tape_length(trunk, plane);
}

// A waist or upper edge, and where it was placed and lies, m.
struct TrunkEdge {
    const Opening* edge = nullptr;
    double placed = 0;
    double draped = 0;
    double held_at = 0;  // height of the hips or the chest, which should hold it
    bool is_of_chest = false;

    double moved() const { return placed - draped; }
    bool has_slipped() const { return draped <= held_at; }
    const char* holder() const { return is_of_chest ? "chest" : "hips"; }
};

std::string in_centimetres(double x) {
    return std::to_string(std::lround(100 * x)) + " cm";
}

// "the upper edge of 'front' lies 7 cm lower than it was placed".
std::string describe(const TrunkEdge& lowered, const GarmentMesh& mesh) {
    return "the " + std::string(lowered.is_of_chest ? "upper edge" : "waist") + " of '" +
           mesh.panel_names[static_cast<std::size_t>(lowered.edge->panels.front())] + "' lies " +
           in_centimetres(std::abs(lowered.moved())) + (lowered.moved() < 0 ? " higher" : " lower") +
           " than it was placed";
}

// An edge that slipped: "the upper edge of 'front' lies 7 cm lower than it was placed, below the chest". If it is at
// least 1 cm longer than the body is round where it was placed, it says so: "too large above the chest by 14 cm: ...".
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

// A waist or upper edge that has slipped.
struct Slip {
    DressFault fault;
    std::size_t panel = 0;  // that has the edge
};

bool does_not_fit(const Slip& slip) {
    return class_of(slip.fault) == FaultClass::DoesNotFit;
}

// Parts of the garment that slip, because they do not fit.
using SlippingParts = std::set<std::size_t>;

// Which openings belong to a part of the garment that hangs from the shoulders, because it has a neckline or an
// armhole: an opening for some of head and arms, but not for all three. parts: of each panel.
std::vector<bool> hang_from_shoulders(const MeantOpenings& meant, const std::vector<std::size_t>& parts) {
    LimbSet above;
    for (const LimbKind kind : {LimbKind::Head, LimbKind::LeftArm, LimbKind::RightArm}) above.set(index_of(kind));
    above &= meant.limbs.known;
    const auto part_of = [&](std::size_t i) {
        return parts[static_cast<std::size_t>(meant.openings[i].panels.front())];
    };
    std::set<std::size_t> hanging;
    for (std::size_t i = 0; i < meant.openings.size(); ++i) {
        const LimbSet leaving = meant.limbs.through[i] & above;
        if (leaving.any() && leaving != above) hanging.insert(part_of(i));
    }
    std::vector<bool> hang;
    for (std::size_t i = 0; i < meant.openings.size(); ++i) hang.push_back(hanging.contains(part_of(i)));
    return hang;
}

// Edges that go round the trunk, and were placed where the hips or the chest hold them: the waists and upper edges of
// what does not hang from the shoulders.
std::vector<TrunkEdge> trunk_edges(const WornGarment& garment, const MeantOpenings& meant, const BodyPair& bodies) {
    std::vector<TrunkEdge> edges;
    const Heights from = heights_of(bodies.meant_for), to = heights_of(bodies.worn_by);
    if (!is_ascending(from) || !is_ascending(to)) return edges;
    const double hips = to[1], chest = to[3];
    const std::vector<Opening>& openings = meant.openings;
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
                                .held_at = placed > chest ? chest : hips,
                                .is_of_chest = placed > chest};
        if (placed >= lowered.held_at) edges.push_back(lowered);
    }
    return edges;
}

// Those that lie lower than they were placed by a waistband's width, because panels settle by as much.
std::vector<TrunkEdge> lowered_edges(const WornGarment& garment, const MeantOpenings& meant, const BodyPair& bodies) {
    std::vector<TrunkEdge> edges = trunk_edges(garment, meant, bodies);
    std::erase_if(edges, [](const TrunkEdge& edge) { return edge.moved() < kWaistbandWidth; });
    return edges;
}

// What is wider below it, the bust or the hips, holds an edge that goes round the trunk. It has slipped if it was
// placed above that and now lies below. One that is as wide as the body where it was placed also slides down if the
// cloth is too stretchy for its weight.
std::vector<Slip> find_slips(const std::vector<TrunkEdge>& edges, const Cloth& cloth, const WornGarment& garment,
                             const BodyPair& bodies) {
    std::vector<Slip> slips;
    for (const TrunkEdge& lowered : edges) {
        if (!lowered.has_slipped()) continue;
        DressFault fault = fault_of_slip(lowered, garment.panels, girth_at(bodies, lowered.placed));
        if (class_of(fault) == FaultClass::Defect) {
            if (auto weakness = weakness_of(lowered, garment, cloth, bodies)) fault = std::move(*weakness);
        }
        slips.push_back({.fault = std::move(fault), .panel = static_cast<std::size_t>(lowered.edge->panels.front())});
    }
    return slips;
}

// "the waist of 'front' lies 15 cm lower than it was placed": a skirt that is too wide for the waist hangs on the hips.
void note_lowered_edges(const std::vector<TrunkEdge>& edges, const WornGarment& garment, DressReport& report) {
    for (const TrunkEdge& lowered : edges) {
        if (!lowered.has_slipped()) report.notes.push_back(describe(lowered, garment.panels));
    }
}

// "the waist of 'skirt' lies 5 cm higher than it was placed": what is worn over a garment may push it up.
void note_raised_edges(const std::vector<TrunkEdge>& edges, const WornGarment& garment, DressReport& report) {
    for (const TrunkEdge& raised : edges) {
        if (-raised.moved() >= kWaistbandWidth) report.notes.push_back(describe(raised, garment.panels));
    }
}

// Panels that seams join are displaced together: where one is at its place, the others are as near to theirs as their
// seams let them, and were placed loosely, as GarmentCode does with long skirts. A panel is at its place if it moved by
// at most half of the height from the hips to the waist; a long skirt may have fallen with its bodice by more, and
// still cover half of its heights. But seams hold none up that lies bunched above its place. Panels round an arm are
// left out: they cannot leave it unless their openings miss it; and those of what slips, which has a fault of its own.
void validate_panels(const WornGarment& garment, const PanelVertices& panels, const std::vector<std::size_t>& parts,
                     const SlippingParts& slipping, const BodyPair& bodies, DressReport& report) {
    const Heights from = heights_of(bodies.meant_for), to = heights_of(bodies.worn_by);
    if (!is_ascending(from) || !is_ascending(to)) return;
    std::vector<std::optional<PanelShift>> shifts(panels.size());
    std::vector<bool> is_at_place(panels.size(), false);  // per part
    for (std::size_t p = 0; p < panels.size(); ++p) {
        if (panels[p].empty() || slipping.contains(parts[p])) continue;
        if (arm_of(panels[p], garment.panels.x, bodies.meant_for)) continue;
        shifts[p] = measure_shift(garment, panels[p], from, to);
        if (shifts[p]->is_at_place) is_at_place[parts[p]] = true;
    }
    for (std::size_t p = 0; p < panels.size(); ++p) {
        if (!shifts[p]) continue;
        const bool has_left_its_part = shifts[p]->is_displaced && (!is_at_place[parts[p]] || shifts[p]->is_bunched);
        // What is joined to a hood is at its place however the hood lies.
        if (!has_left_its_part && !is_off_head(garment, panels[p], bodies)) continue;
        const double moved = shifts[p]->moved;
        add_fault(report, {.kind = "displaced",
                           .place = "'" + garment.panels.panel_names[p] + "' lies " +
                                    std::to_string(std::lround(100 * std::abs(moved))) + " cm " +
                                    (moved > 0 ? "higher" : "lower") + " than it was placed, at the " +
                                    place_on_body(bodies.worn_by, shifts[p]->middle),
                           .value = std::abs(moved)});
    }
}

constexpr double kLiesOnFloor = 0.02;  // m, above the floor

// Cloth on the floor has fallen if it was placed above the knees; a hem that was placed lower is only long. What slips
// has a fault of its own.
void validate_floor(const WornGarment& garment, const PanelVertices& panels, const std::vector<std::size_t>& parts,
                    const SlippingParts& slipping, const BodyPair& bodies, DressReport& report) {
    constexpr double kShare = 0.01;  // of the vertices
    const Heights from = heights_of(bodies.meant_for), to = heights_of(bodies.worn_by);
    if (!is_ascending(from) || !is_ascending(to)) return;
    const double knees = (to[0] + to[1]) / 2;  // half the height of the hips
    long lying = 0, fallen = 0;
    for (std::size_t p = 0; p < panels.size(); ++p) {
        if (slipping.contains(parts[p])) continue;
        for (const std::size_t v : panels[p]) {
            if (garment.draped[v].y() >= bodies.worn_by.height.low + kLiesOnFloor) continue;
            ++lying;
            if (level_on(garment.panels.x[v].y(), from, to) > knees) ++fallen;
        }
    }
    const auto vertices = static_cast<double>(garment.draped.size());
    if (static_cast<double>(fallen) > kShare * vertices) {
        add_fault(report, {.kind = "on_floor",
                           .place = "cloth lies on the floor that was placed above the knees",
                           .value = static_cast<double>(fallen) / vertices});
    } else if (static_cast<double>(lying) > kShare * vertices) {
        report.notes.emplace_back("part of the garment lies on the floor: is it too long for this body?");
    }
}

// A part that goes round no limb, lies on no shoulder and reaches the floor is not worn: it stands there.
void validate_carried(const WornGarment& garment, const PanelVertices& panels, const std::vector<std::size_t>& parts,
                      const MeantOpenings& meant, const BodyPair& bodies, DressReport& report) {
    const LimbSet& known = meant.limbs.known;
    const auto tells = [&](LimbKind end) { return known[index_of(end)]; };  // an end of the trunk
    if (!tells(LimbKind::Head) || !tells(LimbKind::LeftLeg) || !tells(LimbKind::RightLeg)) return;
    if (std::ranges::find(report.faults, "on_floor", &DressFault::kind) != report.faults.end()) return;
    std::set<std::size_t> round_limbs;
    for (std::size_t i = 0; i < meant.openings.size(); ++i) {
        const LimbSet leaving = meant.limbs.through[i] & known;
        if (leaving.any() && leaving != known)
            round_limbs.insert(parts[static_cast<std::size_t>(meant.openings[i].panels.front())]);
    }
    std::map<std::size_t, std::vector<Vec3d>> others;  // per part, m
    for (std::size_t p = 0; p < panels.size(); ++p) {
        if (round_limbs.contains(parts[p])) continue;
        for (const std::size_t v : panels[p]) others[parts[p]].push_back(garment.draped[v]);
    }
    const double floor = bodies.worn_by.height.low, knees = (floor + heights_of(bodies.worn_by)[1]) / 2;
    for (const auto& [part, points] : others) {
        const double lowest = std::ranges::min(points, {}, [](const Vec3d& p) { return p.y(); }).y();
        if (lowest > floor + kLiesOnFloor || is_carried(points, bodies.wearer, knees)) continue;
        add_fault(report, {.kind = "on_floor",
                           .place = "'" + garment.panels.panel_names[part] +
                                    "' stands on the floor: it goes round no part of the body, and lies on none",
                           .value = static_cast<double>(points.size()) / static_cast<double>(garment.draped.size())});
    }
}

// Of hems and cuffs: edges of the trunk's and the legs' lower ends, and of sleeves. Upper edges, as collars, may turn
// over; they have no cloth that was placed above them.
void validate_edges(const WornGarment& garment, const PanelVertices& panels, const MeantOpenings& meant,
                    const BodyPair& bodies, DressReport& report) {
    for (std::size_t i = 0; i < meant.openings.size(); ++i) {
        const Opening& edge = meant.openings[i];
        const auto panel = static_cast<std::size_t>(edge.panels.front());
        const auto arm = arm_of(panels[panel], garment.panels.x, bodies.meant_for);
        const std::string place = place_on_body(bodies.meant_for, centre_of(edge, garment.closed.x));
        const auto name = call_opening(meant.limbs.through[i], place, arm.has_value());
        if (name != "hem" && name != "cuff") continue;
        const auto of = [&](const BodyLimbs& body) { return arm ? &body[*arm] : nullptr; };
        if (arm && (!bodies.meant_for[*arm].is_found || !bodies.worn_by[*arm].is_found)) continue;
        const RolledEdge rolled =
            measure_rolled_edge(garment.closed, edge, inward_of(garment.closed.x, of(bodies.meant_for)),
                                inward_of(garment.closed_draped, of(bodies.worn_by)));
        if (rolled.share == 0) continue;
        const Vec3d& lies_at = garment.closed_draped[rolled.vertex];
        add_fault(report, {"rolled_edge",
                           "the " + std::string(name) + " of '" + garment.panels.panel_names[panel] +
                               "' is rolled up or folded over by " + in_centimetres(rolled.by) + " over " +
                               std::to_string(std::lround(100 * rolled.share)) + " % of its length, at the " +
                               place_on_body(bodies.worn_by, lies_at),
                           rolled.share, "", lies_at.y()});
    }
}

void note_missing_limbs(const BodyLimbs& body, DressReport& report) {
    if (body.found().all()) return;
    report.notes.push_back("could not find " + list_limbs(~body.found()) + " of the body: not checked what covers it");
}

}  // namespace

struct WearingCheck::Known {
    const GarmentMesh& sewn;
    DesignedGarment designed;
    const MeasuredBody& wearer;
    const BodyLimbs& meant_for = designed.body->limbs();
    const BodyLimbs& worn_by = wearer.limbs();
    WornGarment placed{};
    PanelVertices panels{};
    std::vector<std::size_t> parts{};  // garment_parts()
    MeantOpenings meant{};

    bool has_torsos() const { return !worn_by.torso.empty() && !meant_for.torso.empty(); }
    BodyPair bodies() const { return {.meant_for = meant_for, .worn_by = worn_by, .wearer = wearer.body()}; }
};

WearingCheck::WearingCheck(const GarmentMesh& sewn, DesignedGarment designed, const MeasuredBody& wearer) {
    SELVEDGE_ASSERT(designed.unsewn.triangles.size() == sewn.triangles.size());
    const auto known = std::make_shared<Known>(Known{.sewn = sewn, .designed = std::move(designed), .wearer = wearer});
    known_ = known;
    if (!known->has_torsos()) return;
    known->placed = undraped(std::move(known->designed.unsewn));
    known->panels = vertices_by_panel(known->placed.panels);
    known->parts = garment_parts(known->placed, known->panels);
    const GarmentMesh& closed = known->placed.closed;
    known->meant.openings = find_openings(closed);
    known->meant.limbs =
        find_passages(closed, closed.x, known->meant.openings, known->meant_for, {.ends_at_cloth = true});
    known->meant.hang_from_shoulders = hang_from_shoulders(known->meant, known->parts);
}

bool WearingCheck::slips(const Cloth& cloth) const {
    if (!known_->has_torsos()) return false;
    const WornGarment garment = compare_drape(cloth, known_->sewn, known_->placed);
    const BodyPair bodies = known_->bodies();
    const std::vector<TrunkEdge> edges = lowered_edges(garment, known_->meant, bodies);
    return std::ranges::any_of(find_slips(edges, cloth, garment, bodies), does_not_fit);
}

void WearingCheck::validate(const Cloth& cloth, DressReport& report) const {
    note_missing_limbs(known_->worn_by, report);
    if (!known_->has_torsos()) return;
    const PanelVertices& panels = known_->panels;
    const WornGarment garment = compare_drape(cloth, known_->sewn, known_->placed);
    const BodyPair bodies = known_->bodies();
    validate_openings(garment, panels, known_->meant, bodies, report);
    const std::vector<TrunkEdge> edges = lowered_edges(garment, known_->meant, bodies);
    const std::vector<Slip> slips = find_slips(edges, cloth, garment, bodies);
    note_lowered_edges(edges, garment, report);
    const std::vector<std::size_t>& parts = known_->parts;
    std::set<std::size_t> worn_together;
    for (std::size_t p = 0; p < panels.size(); ++p) {
        if (!panels[p].empty()) worn_together.insert(parts[p]);
    }
    if (worn_together.size() > 1) note_raised_edges(trunk_edges(garment, known_->meant, bodies), garment, report);
    SlippingParts slipping;
    for (const Slip& slip : slips) {
        if (does_not_fit(slip)) slipping.insert(parts[slip.panel]);
    }
    validate_panels(garment, panels, parts, slipping, bodies, report);
    for (const Slip& slip : slips) add_fault(report, slip.fault);
    validate_floor(garment, panels, parts, slipping, bodies, report);
    validate_carried(garment, panels, parts, known_->meant, bodies, report);
    const auto is_crumpled = [](const DressFault& fault) {
        return class_of(fault) == FaultClass::DoesNotFit || fault.kind == "on_floor" || fault.kind == "displaced";
    };
    if (std::ranges::none_of(report.faults, is_crumpled))
        validate_edges(garment, panels, known_->meant, bodies, report);
}

}  // namespace selvedge::sim
