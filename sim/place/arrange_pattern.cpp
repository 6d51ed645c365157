#include "sim/place/arrange_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "sim/body/landmarks.h"
#include "sim/body/section.h"
#include "sim/collide/body_collider.h"
#include "sim/core/math.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/place/body_anchors.h"
#include "sim/place/elastic_waist.h"
#include "sim/place/hood_places.h"
#include "sim/place/leg_places.h"
#include "sim/place/limbs.h"
#include "sim/place/panel_cones.h"
#include "sim/place/panel_flanks.h"
#include "sim/place/panel_ring.h"
#include "sim/place/placement.h"
#include "sim/place/sleeve_panels.h"

namespace selvedge::sim {
namespace {

constexpr double kBefore = 0.12, kBehind = 0.08;  // m, from the trunk to a flat front and to a flat back
constexpr double kApart = 0.01;                   // m, between halves in the middle
constexpr double kBelowCrotch = 0.015;            // m, from the body's crotch to that of trousers
constexpr double kOffWaist = 0.02;                // m, from the body to a band that is bent round it
constexpr float kArrangedClear = 0.015F;          // m: dressing moves panels that are nearer than 1 cm

class Arranger {
 public:
    Arranger(Pattern& pattern, const Body& body, std::string_view hints)
        : pattern_(pattern),
          body_(body),
          stature_(find_stature(body)),
          anchors_(anchors_of(body, stature_)),
          points_(arrangement_points(body)),
          sewn_(sewn_edges(pattern)) {
        out_.roles = roles_of(pattern, hints);
        is_placed_.resize(pattern.panels.size(), false);
        for (const Panel& panel : pattern.panels) boxes_.push_back(outline_box(panel, 1e-3));
    }

    Arrangement run() {
        find_flanks(pattern_, sewn_, out_.roles);
        for (std::size_t p = 0; p < out_.roles.size(); ++p) {
            level_band(p);
            raise_sleeve(p);
        }
        if (!gathers_waist()) anchors_.waist = resting_height(body_, anchors_, stature_, waist_length());
        for (const auto part : {GarmentPart::Torso, GarmentPart::Leg, GarmentPart::Skirt}) {
            for (const Face face : {Face::Front, Face::Back, Face::None}) place_all(part, face);
        }
        place_sleeves();
        for (std::size_t p = 0; p < out_.roles.size(); ++p) {
            if (is_part(static_cast<int>(p), GarmentPart::Waistband)) place_round(p, "waist", band_height(p));
        }
        for (std::size_t p = 0; p < out_.roles.size(); ++p) {
            place_cuff(p);
            place_leg_cuff(p);
        }
        place_hoods();
        place_rings();
        continue_seams(false);
        for (const auto part : {GarmentPart::CollarStand, GarmentPart::Collar}) {
            for (std::size_t p = 0; p < out_.roles.size(); ++p) {
                if (out_.roles[p].part == part) place_collar(p);
            }
        }
        continue_seams(true);
        place_rest();
        label_panels(pattern_, sewn_, out_.roles);
        pattern_.body_height = stature_.height();
        return std::move(out_);
    }

 private:
    Panel& panel(std::size_t p) { return pattern_.panels[p]; }
    bool is_part(int p, GarmentPart part) const { return out_.roles[as_size(p)].part == part; }

    double middle_of_body(std::size_t p) const { return middle_side(pattern_, sewn_, out_.roles, p); }
    Vec2d middle_of(const SeamSide& side) const { return middle_of_edge(pattern_, side); }

    // ---- Flat panels before and behind the body.

    void place_all(GarmentPart part, Face face) {
        for (std::size_t p = 0; p < out_.roles.size(); ++p) {
            if (out_.roles[p].part == part && out_.roles[p].face == face && panel(p).is_worn && !is_placed_[p])
                place_flat(p);
        }
    }

    bool closes_round(std::size_t p) const {
        return std::ranges::any_of(
            sewn_[p], [&](const SewnEdge& sewn) { return as_size(sewn.panel) == p && sewn.own != sewn.other; });
    }

    void place_flat(std::size_t p) {
        const PanelRole& role = out_.roles[p];
        if (role.face == Face::None && role.part == GarmentPart::Skirt && place_round_skirt(p)) return;
        if (role.part == GarmentPart::Leg && place_leg_tube(p)) return;
        const bool is_back = role.face == Face::Back;
        Panel& own = panel(p);
        const Eigen::AlignedBox2d& box = boxes_[p];
        own.wrap_radius = 0;
        own.wrap_cone.reset();
        own.rotation = is_back ? Eigen::AngleAxisd(std::numbers::pi, Vec3d::UnitY()).toRotationMatrix()
                               : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
        const double flip = is_back ? -1 : 1;
        double x = anchors_.centre.x() - flip * box.center().x();
        if (role.flank != Flank::None) {
            // The edge in the middle of the body stands beside the middle.
            const double way = role.flank == Flank::Left ? 1 : -1;
            const double inner = flip * way > 0 ? box.min().x() : box.max().x();
            x = anchors_.centre.x() + way * kApart / 2 - flip * inner;
        }
        const double z = is_back ? anchors_.back - kBehind : anchors_.front + kBefore;
        own.translation = {x, height_of(p), z};
        std::vector<int> shoulders;
        for (const SewnEdge& sewn : sewn_[p]) {
            const PanelRole& other = out_.roles[as_size(sewn.panel)];
            if (other.part == GarmentPart::Torso && other.face != role.face) shoulders.push_back(sewn.own.edge);
        }
        own.translation.y() += lift_over_shoulders(body_, anchors_, own, shoulders);
        if (role.part == GarmentPart::Leg && role.flank != Flank::None) {
            const Limb& leg = leg_of(role.flank == Flank::Left);
            if (const auto crotch = crotch_of(own, middle_of_body(p)); crotch && leg.is_found)
                lean_to_leg(own, *crotch, leg);
        }
        is_placed_[p] = true;
    }

    // The panel's origin: so that it meets what it is sewn to and is placed already; else by what it is.
    double height_of(std::size_t p) const {
        double sum = 0;
        int count = 0;
        for (const SewnEdge& sewn : sewn_[p]) {
            const auto other = as_size(sewn.panel);
            if (other == p || !is_placed_[other] || pattern_.panels[other].wrap_radius != 0) continue;
            sum += pattern_.panels[other].place(middle_of(sewn.other)).y() - middle_of(sewn.own).y();
            ++count;
        }
        if (count > 0) return sum / count;
        const Eigen::AlignedBox2d& box = boxes_[p];
        const GarmentPart part = out_.roles[p].part;
        if (part == GarmentPart::Skirt) return anchors_.waist - box.max().y();
        if (part != GarmentPart::Leg) return anchors_.shoulder - box.max().y();
        const auto crotch = crotch_of(pattern_.panels[p], middle_of_body(p));
        if (!crotch) return anchors_.waist - box.max().y();
        return anchors_.crotch - kBelowCrotch - crotch->y();
    }

    // Whether an elastic holds the waist, which the drawing does not show.
    bool gathers_waist() {
        const ClosedWaist waist = closed_waist(pattern_, out_.roles, sewn_);
        if (waist.edges.empty()) return false;
        const auto girth_at = [&](double y) { return trunk_section(body_, y, stature_.height()).girth; };
        if (!gather_waist(pattern_, waist, girth_at(anchors_.waist), girth_at(anchors_.hip))) return false;
        note(as_size(waist.edges.front().panel),
             "as wide as the hips, and closed: taken to have an elastic that gathers it to the waist");
        return true;
    }

    // m, round the top of the skirt or the trousers; 0: not known.
    double waist_length() const {
        double band = 0, arc_length = 0;
        for (std::size_t p = 0; p < out_.roles.size(); ++p) {
            const Panel& own = pattern_.panels[p];
            if (!own.is_worn) continue;
            if (out_.roles[p].part == GarmentPart::Waistband) band += boxes_[p].sizes().x();
            if (out_.roles[p].part != GarmentPart::Skirt || !closes_round(p)) continue;
            const WaistArc arc = waist_arc(own);
            arc_length += arc.angle * arc.radius;
        }
        return band > 0 ? band : arc_length;
    }

    bool place_round_skirt(std::size_t p) {
        if (!closes_round(p)) return false;
        const TrunkSection waist = trunk_section(body_, anchors_.waist, stature_.height());
        is_placed_[p] = bend_round_waist(panel(p), waist, anchors_.waist);
        boxes_[p] = outline_box(panel(p), 1e-3);  // it may be turned
        return is_placed_[p];
    }

    // ---- Wrapped panels.

    const ArrangementPoint* point_named(const std::string& name) const {
        const auto found = std::ranges::find(points_, name, &ArrangementPoint::name);
        return found == points_.end() ? nullptr : &*found;
    }

    // Under sleeves last: where they begin follows from the upper ones, whose top meets the shoulder.
    void place_sleeves() {
        for (const bool is_under : {false, true}) {
            for (std::size_t p = 0; p < out_.roles.size(); ++p) {
                const PanelRole& role = out_.roles[p];
                if (role.part == GarmentPart::Sleeve && (role.face == Face::Back) == is_under) place_sleeve(p);
            }
        }
    }

    // Sleeves may be drawn along the arm: turned so that the edges that are sewn to the trunk are above.
    void raise_sleeve(std::size_t p) {
        if (!is_part(static_cast<int>(p), GarmentPart::Sleeve)) return;
        const Vec2d up = towards(p, GarmentPart::Torso) + towards(p, GarmentPart::Yoke);
        if (up.norm() > 0) turn_by_quarters(p, std::numbers::pi / 2 - std::atan2(up.y(), up.x()));
    }

    // Sleeves are wrapped round the arm, the halves of a two-piece sleeve from both sides: from outside and below, or
    // from before and behind.
    void place_sleeve(std::size_t p) {
        if (!panel(p).is_worn || is_placed_[p]) return;
        const bool is_left = out_.roles[p].flank != Flank::Right;
        const std::string arm = is_left ? "left" : "right";
        const ArrangementPoint* outside = point_named(arm + " upper arm outside");
        const Limb& limb = limbs()[is_left ? LimbKind::LeftArm : LimbKind::RightArm];
        if (!outside || !limb.is_found) return note(p, "the body has no " + arm + " arm to place it round");
        ArrangementPoint point = *outside;
        constexpr double kAboveJoint = 0.02;  // m, from the shoulder's joint up to the top of a sleeve's cap
        constexpr double kTallestCap = 0.16;  // m, of a set-in sleeve: a raglan's reaches on to the neck
        const double cap = cap_height(pattern_, sewn_, p), above = kAboveJoint + std::max(0.0, cap - kTallestCap);
        const double arm_length = (limb.joints[2].centre - limb.joints[0].centre).norm();
        const Vec3d shoulder = limb.joints[0].centre, elbow = limb.joints[1].centre, wrist = limb.joints[2].centre;
        if (boxes_[p].sizes().y() - above > (elbow - shoulder).norm()) {
            // Below the elbow the arm bends forward: along the line from shoulder to wrist, halfway towards the elbow.
            const Vec3d along = (shoulder - wrist).normalized();
            const Vec3d off = (elbow - wrist) - (elbow - wrist).dot(along) * along;
            point.upward = along;
            point.outward = (point.outward - point.outward.dot(along) * along).normalized();
            point.position = shoulder + off / 2 + point.radius * point.outward;
        }
        const double now = (point.position - shoulder).dot(point.upward);
        point.position += (above - boxes_[p].sizes().y() / 2 - now) * point.upward;
        double width = boxes_[p].sizes().x();
        if (const auto half = other_half_of_sleeve(p)) {
            const Vec3d axis = point.position - point.radius * point.outward;
            width += boxes_[*half].sizes().x();
            if (are_front_and_back(panel(p), panel(*half)))
                point.outward = (Vec3d::UnitZ() - point.upward.z() * point.upward).normalized();
            if (out_.roles[p].face == Face::Back) point.outward = -point.outward;
            point.position = axis + point.radius * point.outward;
            if (const auto placed = sleeve_points_.find(*half); placed != sleeve_points_.end())
                point.position += (placed->second.position - point.position).dot(point.upward) * point.upward +
                                  level_between(pattern_, sewn_, p, *half) * point.upward;
        }
        Tube tube{.cone = cone_of_sleeve(pattern_, sewn_, p), .width = width};
        // The cap of a raglan reaches over the shoulder to the neck: only the tube below it has room round the arm.
        if (cap > kTallestCap) tube.top = boxes_[p].max().y() - cap;
        wrap_clear(p, point, arm_length, tube);
        is_placed_[p] = true;
    }

    // The other panel of a sleeve of two panels.
    std::optional<std::size_t> other_half_of_sleeve(std::size_t p) const {
        if (closes_round(p)) return std::nullopt;
        for (const SewnEdge& sewn : sewn_[p]) {
            if (is_part(sewn.panel, GarmentPart::Sleeve)) return as_size(sewn.panel);
        }
        return std::nullopt;
    }

    // ---- Bands.

    // Cuffs, waistbands and collars may be drawn along the cloth, or upside down: turned so that they run round the
    // body, the edge that is sewn to the garment towards it.
    void level_band(std::size_t p) {
        using enum GarmentPart;
        const GarmentPart part = out_.roles[p].part;
        if (part != Cuff && part != Waistband && part != CollarStand && part != Collar) return;
        const SewnEdge* longest = nullptr;
        double length = 0;
        for (const SewnEdge& sewn : sewn_[p]) {
            const double own = outline_length(panel(p), panel(p).edges[as_size(sewn.own.edge)]);
            const bool is_outer = part == CollarStand && is_part(sewn.panel, Collar);
            if (as_size(sewn.panel) == p || is_outer || own <= length) continue;
            longest = &sewn;
            length = own;
        }
        if (!longest) return;
        const OutlineEdge& edge = panel(p).edges[as_size(longest->own.edge)];
        const Vec2d along = outline_point(panel(p), edge, 1) - outline_point(panel(p), edge, 0);
        // Outlines run counter-clockwise: a lower edge to the right, an upper one to the left.
        const bool is_above = is_part(longest->panel, Skirt) || is_part(longest->panel, Leg);
        const bool is_lower_edge = part == Waistband ? is_above : part != Cuff;
        turn_by_quarters(p, (is_lower_edge ? 0 : std::numbers::pi) - std::atan2(along.y(), along.x()));
    }

    // Turns the panel by the multiple of a right angle that is nearest to the angle, rad.
    void turn_by_quarters(std::size_t p, double angle) {
        const double right_angle = std::numbers::pi / 2, quarter = std::round(angle / right_angle);
        if (std::fmod(quarter, 4) == 0) return;
        panel(p) = mapped_panel(panel(p), Eigen::Affine2d(Eigen::Rotation2Dd(quarter * right_angle)));
        boxes_[p] = outline_box(panel(p), 1e-3);
    }

    // A waistband lies at the waist, or at the hem of the bodice that it ends.
    double band_height(std::size_t p) const {
        double sum = 0;
        int count = 0;
        for (const SewnEdge& sewn : sewn_[p]) {
            if (!is_part(sewn.panel, GarmentPart::Torso) || !is_placed_[as_size(sewn.panel)]) {
                if (as_size(sewn.panel) != p) return anchors_.waist;
                continue;
            }
            sum += pattern_.panels[as_size(sewn.panel)].place(middle_of(sewn.other)).y();
            ++count;
        }
        return count > 0 ? sum / count - boxes_[p].sizes().y() : anchors_.waist;
    }

    // A cuff goes on where its sleeve ends, round the same arm. It stays at the wrist if it would be over the hand
    // otherwise, where it cannot close, but not within a sleeve that ends farther on: that one would fold over it.
    void place_cuff(std::size_t p) {
        if (out_.roles[p].part != GarmentPart::Cuff || !panel(p).is_worn || is_placed_[p]) return;
        for (const SewnEdge& sewn : sewn_[p]) {
            const auto sleeve = sleeve_points_.find(as_size(sewn.panel));
            if (sleeve == sleeve_points_.end()) continue;
            constexpr double kWrist = 0.035, kBelow = 0.01;  // m: least radius, and from the sleeve
            constexpr double kWithin = 0.03;                 // m, of a cuff that may lie in its sleeve
            ArrangementPoint point = sleeve->second;
            const bool is_left = out_.roles[sleeve->first].flank != Flank::Right;
            const Limb& limb = limbs()[is_left ? LimbKind::LeftArm : LimbKind::RightArm];
            const double height = boxes_[p].sizes().y();
            const double to_hem = boxes_[sleeve->first].sizes().y() / 2 + height / 2 + kBelow;
            const double to_wrist = (point.position - limb.joints[2].centre).dot(point.upward) - height / 2;
            point.position += (kWrist - point.radius) * point.outward - to_hem * point.upward;
            point.radius = kWrist;
            if (to_wrist < to_hem && to_hem - to_wrist < kWithin) {
                const Vec3d wrist = limb.joints[2].centre;
                point.upward = (limb.joints[1].centre - wrist).normalized();
                point.outward = (point.outward - point.outward.dot(point.upward) * point.upward).normalized();
                point.position = wrist + height / 2 * point.upward + kWrist * point.outward;
            }
            wrap_clear(p, facing_partners(p, point), 4 * kBelow, {.width = boxes_[p].sizes().x()});
            is_placed_[p] = true;
            return;
        }
    }

    void place_leg_cuff(std::size_t p) {
        if (out_.roles[p].part != GarmentPart::Cuff || !panel(p).is_worn || is_placed_[p]) return;
        for (const SewnEdge& sewn : sewn_[p]) {
            const auto leg = as_size(sewn.panel);
            if (out_.roles[leg].part != GarmentPart::Leg || !is_placed_[leg]) continue;
            const Vec3d hem = panel(leg).place(middle_of(sewn.other));
            const Limb& limb = leg_of(hem.x() > anchors_.centre.x());
            if (!limb.is_found) return;
            sim::arrange(panel(p), facing_partners(p, place_of_leg_cuff(panel(p), hem, limb)));
            is_placed_[p] = true;
            return;
        }
    }

    const Limb& leg_of(bool is_left) { return limbs()[is_left ? LimbKind::LeftLeg : LimbKind::RightLeg]; }

    bool place_leg_tube(std::size_t p) {
        if (!closes_round(p)) return false;
        std::vector<int> crotch;
        for (const SewnEdge& sewn : sewn_[p]) {
            if (are_mirror_images(panel(p), panel(as_size(sewn.panel)))) crotch.push_back(sewn.own.edge);
        }
        const auto tube = leg_tube(panel(p), crotch);
        if (!tube || !leg_of(tube->is_of_left).is_found) return false;
        const double height = anchors_.crotch - kBelowCrotch;
        const auto point = place_of_tube(panel(p), *tube, leg_of(tube->is_of_left), height);
        if (!point) return false;
        out_.roles[p].flank = tube->is_of_left ? Flank::Left : Flank::Right;
        sim::arrange(panel(p), *point);
        is_placed_[p] = true;
        return true;
    }

    // ---- Hoods.

    // The sides of a hood stand beside the head, their round edge behind it; the strip between them is bent over it.
    void place_hoods() {
        const Limb& head = limbs()[LimbKind::Head];
        if (!head.is_found || head.joints.size() < 2) return;
        for (std::size_t p = 0; p < out_.roles.size(); ++p) {
            if (out_.roles[p].part != GarmentPart::Hood || !panel(p).is_worn || is_placed_[p]) continue;
            if (is_hood_strip(p))
                place_hood_strip(p, head);
            else
                place_hood_side(p, head);
        }
    }

    bool is_hood_strip(std::size_t p) const {
        constexpr double kStrip = 2.5;
        return boxes_[p].sizes().maxCoeff() > kStrip * boxes_[p].sizes().minCoeff();
    }

    // Where the middle of all edges lies that are sewn to panels of the part, from the middle of the panel, m.
    Vec2d towards(std::size_t p, GarmentPart part) const {
        Vec2d sum = Vec2d::Zero();
        for (const SewnEdge& sewn : sewn_[p]) {
            if (is_part(sewn.panel, part) && as_size(sewn.panel) != p) sum += middle_of(sewn.own) - boxes_[p].center();
        }
        return sum;
    }

    void place_hood_side(std::size_t p, const Limb& head) {
        const double x = towards(p, GarmentPart::Hood).x();
        if (x == 0) return;
        // The right side faces outward: on the left of the body, the panel's x runs to the back.
        out_.roles[p].flank = x > 0 ? Flank::Left : Flank::Right;
        stand_beside_head(panel(p), x > 0 ? 1 : -1, head);
        is_placed_[p] = true;
    }

    void place_hood_strip(std::size_t p, const Limb& head) {
        if (boxes_[p].sizes().y() > boxes_[p].sizes().x()) turn_by_quarters(p, std::numbers::pi / 2);
        // Which side of the hood the lower edge belongs to.
        double left = 0;
        for (const SewnEdge& sewn : sewn_[p]) {
            if (!is_part(sewn.panel, GarmentPart::Hood)) continue;
            const bool is_low = middle_of(sewn.own).y() < boxes_[p].center().y();
            const double x = towards(as_size(sewn.panel), GarmentPart::Hood).x();
            left += (is_low ? 1 : -1) * x;
        }
        bend_over_head(panel(p), left > 0 ? 1 : -1, head);
        is_placed_[p] = true;
    }

    struct Tube {
        std::optional<WrapCone> cone = {};
        double top = std::numeric_limits<double>::infinity();  // y of the panel, m, above which it need not be clear
        double width = 0;                                      // m, of all panels round it
    };

    // Wraps a tube round an arm. Where it meets shoulder, chest or arm it slides towards the hand, and stands open
    // wider, until it is clear.
    void wrap_clear(std::size_t p, const ArrangementPoint& at, double arm_length, const Tube& tube) {
        const std::optional<WrapCone>& cone = tube.cone;
        constexpr double kStep = 0.01, kMost = 0.45;       // m; of the arm's length
        constexpr std::array kOpen{1.04, 1.15, 1.3, 1.5};  // of a full turn, so that the edges do not meet
        const double least = at.radius;
        const auto wrap = [&](double open, double slid) {
            ArrangementPoint point = at;
            point.radius = std::max(least, open * tube.width / (2 * std::numbers::pi));
            point.position += (point.radius - least) * point.outward - slid * point.upward;
            sleeve_points_[p] = point;
            if (cone)
                bend_to_cone(p, point, {.apex = cone->apex, .sine = cone->sine * open});
            else
                sim::arrange(panel(p), point);
        };
        // None is clear: the one that is least in the body.
        double best_open = kOpen[0], best_slid = 0;
        float best = -std::numeric_limits<float>::infinity();
        for (const double open : kOpen) {
            for (double slid = 0; slid <= kMost * arm_length; slid += kStep) {
                wrap(open, slid);
                const float clearance = clearance_of(part_below(panel(p), tube.top), collider());
                if (clearance > kArrangedClear) return;
                if (clearance > best) best = clearance, best_open = open, best_slid = slid;
            }
        }
        wrap(best_open, best_slid);
    }

    // The middle of the panel's height lies beside the point, the cone's axis along the limb.
    void bend_to_cone(std::size_t p, const ArrangementPoint& point, const WrapCone& cone) {
        Panel& own = panel(p);
        own.wrap_radius = 0;
        own.wrap_cone = cone;
        own.rotation.col(1) = point.upward;
        own.rotation.col(2) = point.outward;
        own.rotation.col(0) = point.upward.cross(point.outward);
        own.translation.setZero();
        const Vec2d middle = boxes_[p].center();
        const double along = (own.place({cone.apex.x(), middle.y()})).dot(point.upward);
        const Vec3d axis = point.position - point.radius * point.outward;
        own.translation = axis - own.rotation.col(0) * cone.apex.x() - along * point.upward;
    }

    // ---- Which part of a band lies where.

    static constexpr double kTurned = 0.35;  // rad: bands that are turned by less stay as they are

    // By how much a band must turn about an axis so that its edges lie beside those that they are sewn to, rad.
    double turn_to_partners(std::size_t p, const Vec3d& centre, const Vec3d& axis) const {
        double cosine = 0, sine = 0;
        for (const SewnEdge& sewn : sewn_[p]) {
            const auto other = as_size(sewn.panel);
            if (other == p || !is_placed_[other]) continue;
            const auto off_axis = [&](const Vec3d& at) -> Vec3d {
                return (at - centre) - (at - centre).dot(axis) * axis;
            };
            const Vec3d own = off_axis(pattern_.panels[p].place(middle_of(sewn.own)));
            const Vec3d wanted = off_axis(pattern_.panels[other].place(middle_of(sewn.other)));
            cosine += own.dot(wanted);
            sine += axis.dot(own.cross(wanted));
        }
        return cosine == 0 && sine == 0 ? 0 : std::atan2(sine, cosine);
    }

    // The point of a tube, turned about its axis so that its edges lie beside those that they are sewn to.
    ArrangementPoint facing_partners(std::size_t p, const ArrangementPoint& point) {
        sim::arrange(panel(p), point);
        const Vec3d axis = point.position - point.radius * point.outward;
        const double turn = turn_to_partners(p, axis, point.upward);
        return std::abs(turn) > kTurned ? turned(point, axis, turn) : point;
    }

    const BodyLimbs& limbs() {
        if (!limbs_) limbs_ = find_limbs(body_);
        return *limbs_;
    }

    const BodyCollider& collider() {
        if (!collider_) collider_.emplace(body_);
        return *collider_;
    }

    bool is_collar_strip(std::size_t p) const {
        constexpr double kStrip = 2.5;  // of its height
        const GarmentPart part = out_.roles[p].part;
        return (part == GarmentPart::CollarStand || part == GarmentPart::Collar) &&
               boxes_[p].sizes().x() > kStrip * boxes_[p].sizes().y();
    }

    // Strips of a collar are wrapped round the neck, above what they are sewn to, as near as they go without touching
    // it: flat before or behind it, their ends would have to find their way round.
    void place_collar(std::size_t p) {
        if (!is_collar_strip(p) || !panel(p).is_worn || is_placed_[p]) return;
        const bool is_held = std::ranges::any_of(sewn_[p], [&](const SewnEdge& sewn) {
            return as_size(sewn.panel) != p && is_placed_[as_size(sewn.panel)];
        });
        if (!is_held) return;
        const Limb& head = limbs()[LimbKind::Head];
        if (!head.is_found || head.joints.size() < 2) return;
        constexpr double kOpen = 1.03;                    // of a full turn, so that the ends do not meet
        constexpr double kWider = 0.005, kWidest = 0.04;  // m
        ArrangementPoint point;
        const Vec3d neck = head.joints[0].centre;
        point.upward = (head.joints[1].centre - neck).normalized();
        point.outward = (Vec3d::UnitZ() - point.upward.z() * point.upward).normalized();
        double low = (anchors_.shoulder - neck.y()) / point.upward.y();
        for (const SewnEdge& sewn : sewn_[p]) {
            const auto other = as_size(sewn.panel);
            if (other == p || !is_placed_[other] || !is_part(sewn.panel, GarmentPart::CollarStand)) continue;
            low = std::max(low, (panel(other).place(boxes_[other].max()) - neck).dot(point.upward));
        }
        const Vec2d size = boxes_[p].sizes();
        const Vec3d centre = neck + (low + size.y() / 2) * point.upward;
        const double nearest = kOpen * size.x() / (2 * std::numbers::pi);
        for (double wider = 0; wider < kWidest; wider += kWider) {
            point.radius = nearest + wider;
            point.position = centre + point.radius * point.outward;
            sim::arrange(panel(p), point);
            const double turn = turn_to_partners(p, centre, point.upward);
            if (std::abs(turn) > kTurned) sim::arrange(panel(p), turned(point, centre, turn));
            if (clearance_of(panel(p), collider()) > kArrangedClear) break;
        }
        is_placed_[p] = true;
    }

    void place_round(std::size_t p, const std::string& where, double height) {
        if (!panel(p).is_worn || is_placed_[p]) return;
        const ArrangementPoint* front = point_named(where + " front");
        if (!front) return;
        ArrangementPoint point = *front;
        const bool is_back = out_.roles[p].face == Face::Back;
        if (is_back) {
            if (const ArrangementPoint* back = point_named(where + " back")) point = *back;
        }
        constexpr double kOpen = 1.03;  // of a full turn, so that the ends do not meet
        const Vec2d size = boxes_[p].sizes();
        const TrunkSection low = trunk_section(body_, height, stature_.height());
        const TrunkSection high = trunk_section(body_, height + size.y(), stature_.height());
        const double reach = std::max(low.reach, high.reach);  // 0: the trunk is not found there
        const double clear = reach > 0 ? reach + kOffWaist : point.radius;
        point.radius = std::max(clear, kOpen * size.x() / (2 * std::numbers::pi));
        point.position = low.centre + point.radius * point.outward;
        point.position.y() = height + size.y() / 2;
        sim::arrange(panel(p), point);
        const double turn = turn_to_partners(p, low.centre, point.upward);
        if (std::abs(turn) > kTurned) sim::arrange(panel(p), turned(point, low.centre, turn));
        is_placed_[p] = true;
    }

    // ---- Panels that continue others.

    // In the plane of its neighbour, turned so that both sides of the seam are parallel, and beside it.
    void continue_seams(bool with_collars) {
        for (bool has_changed = true; has_changed;) {
            has_changed = false;
            for (std::size_t p = 0; p < pattern_.panels.size(); ++p) {
                if (is_placed_[p] || !panel(p).is_worn) continue;
                if (is_collar_strip(p) && !with_collars) continue;
                if (const SewnEdge* best = seam_to_continue(p)) {
                    continue_over(p, *best);
                    has_changed = true;
                }
            }
        }
    }

    // The longest edge to the placed panel that it is sewn to the most: a yoke goes on from the back, not from a front.
    const SewnEdge* seam_to_continue(std::size_t p) const {
        const auto length_of = [&](const SewnEdge& sewn) {
            return outline_length(pattern_.panels[p], pattern_.panels[p].edges[as_size(sewn.own.edge)]);
        };
        std::map<int, double> lengths;  // by the other panel, m
        for (const SewnEdge& sewn : sewn_[p]) {
            if (is_placed_[as_size(sewn.panel)]) lengths[sewn.panel] += length_of(sewn);
        }
        if (lengths.empty()) return nullptr;
        const int partner = std::ranges::max_element(lengths, {}, [](const auto& one) { return one.second; })->first;
        const SewnEdge* best = nullptr;
        for (const SewnEdge& sewn : sewn_[p]) {
            if (sewn.panel == partner && (!best || length_of(sewn) > length_of(*best))) best = &sewn;
        }
        return best;
    }

    void continue_over(std::size_t p, const SewnEdge& sewn) {
        Panel& own = panel(p);
        const Panel& other = pattern_.panels[as_size(sewn.panel)];
        const OutlineEdge& edge = own.edges[as_size(sewn.own.edge)];
        const OutlineEdge& partner = other.edges[as_size(sewn.other.edge)];
        const Vec2d along = outline_point(own, edge, 1) - outline_point(own, edge, 0);
        Vec2d wanted = outline_point(other, partner, 0) - outline_point(other, partner, 1);
        if (!sewn.is_reversed) wanted = -wanted;
        const double turn = std::atan2(cross2(along, wanted), along.dot(wanted));
        own.wrap_radius = 0;
        own.wrap_cone.reset();
        own.rotation = other.rotation * Eigen::AngleAxisd(turn, Vec3d::UnitZ()).toRotationMatrix();
        own.translation.setZero();
        own.translation = other.place(middle_of(sewn.other)) - own.place(middle_of(sewn.own));
        is_placed_[p] = true;
    }

    // Panels without a part that are sewn side to side go round the waist.
    void place_rings() {
        const auto may_be = [&](std::size_t p) {
            return panel(p).is_worn && !is_placed_[p] && out_.roles[p].part == GarmentPart::Unknown;
        };
        constexpr std::size_t kFewest = 4;
        for (std::size_t p = 0; p < pattern_.panels.size(); ++p) {
            const auto ring = may_be(p) ? ring_of(pattern_, sewn_, p, may_be) : std::vector<RingPlace>();
            if (ring.size() < kFewest) continue;
            const TrunkSection waist = trunk_section(body_, anchors_.waist, stature_.height());
            arrange_ring(pattern_, ring, waist.centre + Vec3d(0, anchors_.waist - waist.centre.y(), 0),
                         waist.reach + kOffWaist);
            for (const RingPlace& place : ring) is_placed_[place.panel] = true;
        }
    }

    // What nothing tells of stands before the body, or behind it, by turns.
    void place_rest() {
        bool is_back = false;
        for (std::size_t p = 0; p < pattern_.panels.size(); ++p) {
            if (is_placed_[p] || !panel(p).is_worn) continue;
            out_.roles[p].face = is_back ? Face::Back : Face::Front;
            place_flat(p);
            note(p, std::string("placed ") + (is_back ? "behind" : "before") + " the body by guess");
            is_back = !is_back;
        }
    }

    void note(std::size_t p, const std::string& text) { out_.notes.push_back(pattern_.panels[p].name + ": " + text); }

    Pattern& pattern_;
    const Body& body_;
    Stature stature_;
    Anchors anchors_;
    std::vector<ArrangementPoint> points_;
    std::optional<BodyLimbs> limbs_;        // found when they are first asked for
    std::optional<BodyCollider> collider_;  // made for the first sleeve
    SewnEdges sewn_;                        // per panel
    std::vector<Eigen::AlignedBox2d> boxes_;
    std::vector<bool> is_placed_;
    std::map<std::size_t, ArrangementPoint> sleeve_points_;  // where panels lie that are wrapped round an arm
    Arrangement out_;
};

}  // namespace

Arrangement arrange_pattern(Pattern& pattern, const Body& body, std::string_view hints) {
    return Arranger(pattern, body, hints).run();
}

}  // namespace selvedge::sim
