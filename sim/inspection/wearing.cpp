#include "sim/inspection/wearing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/math.h"
#include "sim/inspection/body_heights.h"
#include "sim/inspection/carried.h"
#include "sim/inspection/missed_limbs.h"
#include "sim/inspection/rolled_edges.h"
#include "sim/inspection/slips.h"
#include "sim/inspection/worn_garment.h"
#include "sim/place/hanging_seams.h"
#include "sim/place/level_on.h"
#include "sim/place/limb_pieces.h"
#include "sim/place/limbs.h"
#include "sim/place/openings.h"

namespace selvedge::sim {

namespace {

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

// The height of a panel as placed, m, in the mean over its breadth: a waistband that is cut in a curve stands higher
// where it is placed than where it is worn.
double mean_height(const GarmentMesh& mesh, std::size_t panel, const std::vector<std::size_t>& vertices) {
    double area = 0;
    for (const GarmentTriangle& t : mesh.triangles)
        if (t.panel == static_cast<int>(panel)) area += cross2(t.u[1] - t.u[0], t.u[2] - t.u[0]) / 2;
    Eigen::AlignedBox3d box;
    for (const std::size_t v : vertices) box.extend(mesh.x[v]);
    const Vec3d size = box.sizes();
    return std::min(size.y(), area / std::hypot(size.x(), size.z()));
}

// A panel is displaced if it has left more than half of the heights over which it was placed: what is gone lies where
// another part of the garment belongs. Panels stand free of the body and settle on it, a waistband by more than its
// width, and a poncho that is placed flat hangs down; so a panel shorter than from the hips to the waist may also be
// off by half of what it is shorter.
PanelShift measure_shift(const WornGarment& garment, std::size_t panel, const std::vector<std::size_t>& vertices,
                         const Heights& from, const Heights& to) {
    constexpr double kLeastCovered = 0.5;  // of the heights
    constexpr double kHanging = 0.7;       // of mean_height(): what hangs with folds has more of it left
    Range placed, hung, draped;
    PanelShift shift;
    for (const std::size_t v : vertices) {
        const double y = garment.panels.x[v].y();
        hung.extend(level_on(y, from, to));
        placed.extend(level_on(y - garment.rises[v], from, to));
        draped.extend(garment.draped[v].y());
        shift.middle += garment.draped[v] / static_cast<double>(vertices.size());
    }
    // Its place is anywhere from where it was placed to where it hangs.
    const auto [lowest, highest] = std::minmax({placed.middle(), hung.middle()});
    const double middle = std::clamp(draped.middle(), lowest, highest), half = hung.length() / 2;
    shift.moved = draped.middle() - middle;
    const double reach = std::max(0.0, (to[2] - to[1] - hung.length()) / 2);
    const double covered = std::min(middle + half, draped.high + reach) - std::max(middle - half, draped.low - reach);
    shift.is_displaced = covered < kLeastCovered * hung.length();
    shift.is_bunched = shift.is_displaced && shift.moved > 0 &&
                       draped.length() < kHanging * mean_height(garment.panels, panel, vertices);
    shift.is_at_place = !shift.is_displaced && std::abs(shift.moved) <= (to[2] - to[1]) / 2;
    return shift;
}

// Whether a panel that was placed on the head, as those of a hood are, lies below its middle.
bool is_off_head(const WornGarment& garment, const std::vector<std::size_t>& vertices, const BodyPair& bodies) {
    const Limb &from = bodies.meant_for[LimbKind::Head], &to = bodies.worn_by[LimbKind::Head];
    if (from.joints.size() < 2 || to.joints.size() < 2) return false;
    Range placed, draped;
    for (const std::size_t v : vertices) {
        placed.extend(garment.panels.x[v].y() - garment.rises[v]);
        draped.extend(garment.draped[v].y());
    }
    const double neck = from.joints[0].centre.y(), middle = from.joints[1].centre.y();
    return placed.middle() > neck && placed.high > middle && draped.high < to.joints[1].centre.y();
}

// Parts of the garment that slip, because they do not fit.
using SlippingParts = std::set<std::size_t>;

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
        shifts[p] = measure_shift(garment, p, panels[p], from, to);
        if (shifts[p]->is_at_place) is_at_place[parts[p]] = true;
    }
    for (std::size_t p = 0; p < panels.size(); ++p) {
        if (!shifts[p]) continue;
        const bool has_left_its_part = shifts[p]->is_displaced && (!is_at_place[parts[p]] || shifts[p]->is_bunched);
        // What is joined to a hood is at its place however the hood lies.
        if (!has_left_its_part && !is_off_head(garment, panels[p], bodies)) continue;
        const double moved = shifts[p]->moved;
        add_fault(report, {.kind = "displaced",
                           .place = "'" + garment.panels.panel_names[p] + "' lies " + in_centimetres(std::abs(moved)) +
                                    (moved > 0 ? " higher" : " lower") + " than it was placed, at the " +
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
            if (level_on(garment.panels.x[v].y() - garment.rises[v], from, to) > knees) ++fallen;
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
        if (lowest > floor + kLiesOnFloor || is_carried(points, bodies.wearer.body(), knees)) continue;
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
    BodyPair bodies() const { return {.meant_for = meant_for, .worn_by = worn_by, .wearer = wearer}; }
};

WearingCheck::WearingCheck(const GarmentMesh& sewn, DesignedGarment designed, const MeasuredBody& wearer) {
    SELVEDGE_ASSERT(designed.unsewn.triangles.size() == sewn.triangles.size());
    const auto known = std::make_shared<Known>(Known{.sewn = sewn, .designed = std::move(designed), .wearer = wearer});
    known_ = known;
    if (!known->has_torsos()) return;
    GarmentMesh& unsewn = known->designed.unsewn;
    const std::vector<bool> without_arms = panels_without_arms(unsewn, *known->designed.pattern, known->meant_for);
    const std::vector<Vec3d> as_placed = unsewn.x;
    hang_on_shoulders(unsewn, *known->designed.body);
    known->placed = undraped(std::move(unsewn), as_placed);
    known->designed.pattern = nullptr;
    known->panels = vertices_by_panel(known->placed.panels);
    known->parts = garment_parts(known->placed, known->panels);
    known->meant = find_meant_openings(known->placed, known->parts, without_arms, known->meant_for);
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
