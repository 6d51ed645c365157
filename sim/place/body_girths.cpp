#include "sim/place/body_girths.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/body/landmarks.h"
#include "sim/place/garment_section.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {
namespace {

constexpr double kLargestShare = 0.05;  // of the largest section's area, from which on a section is a part of the body
constexpr int kLevels = 12;             // at which a girth is measured to find the largest or the least
constexpr double kExact = 1e-4;         // m, of the level at which sections join or part

// Heights between which a girth lies, m.
struct GirthRange {
    double low = 0;
    double high = 0;

    double at(int level) const { return low + (high - low) * level / kLevels; }
};

void add_section(BodyGirth& girth, const SectionLoop& loop) {
    girth.inside.points.insert(girth.inside.points.end(), loop.points.begin(), loop.points.end());
    girth.centres.push_back(loop.centre);
}

// The larger where `sign` is 1, the smaller where it is -1, of those that there are.
void keep_extreme(std::optional<BodyGirth>& best, std::optional<BodyGirth> other, double sign) {
    if (other && (!best || sign * other->length() > sign * best->length())) best = std::move(other);
}

std::optional<BodyGirth> widest_of_trunk(const MeasuredBody& body, const GirthRange& range) {
    std::optional<BodyGirth> widest;
    for (int i = 0; i <= kLevels; ++i) keep_extreme(widest, trunk_girth(body, range.at(i)), 1);
    return widest;
}

// Where a value that is false at `low` and true at `high` changes, to kExact.
template <class IsTrue>
double bisect(double low, double high, const IsTrue& is_true) {
    while (std::abs(high - low) > kExact) {
        const double middle = (low + high) / 2;
        (is_true(middle) ? high : low) = middle;
    }
    return high;
}

// Where the trunk's parts lie.

// Shares of the stature between which waist and hip lie on bodies whose crotch and armpits are where most people have
// them; those of other bodies lie in the same way between their own.
constexpr double kCrotchShare = 0.475, kArmpitShare = 0.757;
constexpr double kHighestHip = 0.56, kLowestWaist = 0.57, kHighestWaist = 0.685;

// Whether the surface shows the ends of the trunk, or it lies where people of that stature have it. Some figures of
// cartoons and games do neither: their skeletons tell where their waist is, and nothing where a tape would measure it.
bool shows_trunk(const MeasuredBody& body) {
    return (body.landmarks().crotch && body.landmarks().armpit) || body.proportions().is_usual;
}

bool has_usual_trunk(const MeasuredBody& body) {
    if (!shows_trunk(body)) return false;
    constexpr double kUsual = 0.02;  // of the stature: most people's, and what find_landmarks() does not tell
    const Stature& stature = body.stature();
    const auto is_usual = [&](const std::optional<double>& y, double share) {
        return !y || std::abs((*y - stature.floor) / stature.height() - share) <= kUsual;
    };
    return is_usual(body.landmarks().crotch, kCrotchShare) && is_usual(body.landmarks().armpit, kArmpitShare);
}

// Of a share of the stature on a body of usual proportions, m.
double height_on_trunk(const MeasuredBody& body, double share) {
    const auto usual = [&](double other) { return body.stature().floor + other * body.stature().height(); };
    if (has_usual_trunk(body)) return usual(share);
    if (!shows_trunk(body)) return body.proportions().at(share);
    const double crotch = body.landmarks().crotch.value_or(usual(kCrotchShare));
    const double armpit = body.landmarks().armpit.value_or(usual(kArmpitShare));
    return std::lerp(crotch, armpit, (share - kCrotchShare) / (kArmpitShare - kCrotchShare));
}

// That of the smallest girth between hips and ribs, m.
double waist_height(const MeasuredBody& body) {
    constexpr double kStep = 0.005;  // of the usual stature
    double waist = torso_heights(body.body(), body.stature()).waist;
    if (has_usual_trunk(body)) return waist;
    std::optional<BodyGirth> least;
    for (double share = kLowestWaist; share <= kHighestWaist; share += kStep) {
        const double y = height_on_trunk(body, share);
        std::optional<BodyGirth> girth = trunk_girth(body, y);
        if (!girth || (least && girth->length() >= least->length())) continue;
        least = std::move(girth);
        waist = y;
    }
    return waist;
}

// Bust.

double width_of(const std::optional<BodyGirth>& trunk) {
    if (!trunk) return 0;
    const auto [low, high] = std::ranges::minmax(trunk->inside.points, {}, [](const Vec3d& p) { return p.x(); });
    return high.x() - low.x();
}

// The lowest level above the waist at which an arm has joined the trunk, which is suddenly wider there. Breasts that
// hang join it too, but lie before it.
std::optional<double> armpit_above(const MeasuredBody& body, double waist) {
    constexpr double kStep = 0.005;  // of the stature
    constexpr double kJump = 1.2;    // of the width, in a step: two arms that hang close add twice as much
    constexpr double kLowest = 0.1;  // of the stature, below the shoulders' joints: lower, the trunk itself widens
    const double step = kStep * body.stature().height();
    const auto width_at = [&](double y) { return width_of(trunk_girth(body, y)); };
    double lowest = waist;
    for (const LimbKind arm : {LimbKind::LeftArm, LimbKind::RightArm}) {
        const Limb& limb = body.limbs()[arm];
        if (limb.is_found)
            lowest = std::max(lowest, limb.joints.front().centre.y() - kLowest * body.stature().height());
    }
    double below = width_at(waist);
    for (double y = waist + step; y < body.stature().crown; y += step) {
        const double width = width_at(y);
        if (y > lowest && below > 0 && width > kJump * below)
            return bisect(y - step, y, [&](double at) { return width_at(at) > (below + width) / 2; });
        below = width;
    }
    return std::nullopt;
}

// Limbs.

// The largest of the loops that go round the point; none: the nearest, if the point lies not farther from its middle
// than a circle of its area reaches. A section of flesh that is folded or overlaps has slivers beside it, and what is
// inside a mouth or a throat has loops within it.
std::optional<SectionLoop> loop_round(const std::vector<SectionLoop>& loops, const Plane& plane, const Vec3d& point) {
    std::optional<SectionLoop> own;
    for (const SectionLoop& loop : loops) {
        if ((!own || loop.area > own->area) && goes_round(loop.points, plane, point)) own = loop;
    }
    if (own) return own;
    own = nearest_loop(loops, point);
    if (own && std::numbers::pi * (own->centre - point).squaredNorm() > own->area) own.reset();
    return own;
}

// Of the limb whose line goes through the plane's point.
std::optional<BodyGirth> limb_girth(const Body& body, const Plane& plane) {
    const std::vector<SectionLoop> loops = section(body, plane);
    const std::optional<SectionLoop> own = loop_round(loops, plane, plane.point);
    if (!own) return std::nullopt;
    BodyGirth girth{.plane = plane};
    add_section(girth, *own);
    for (const SectionLoop& loop : loops) {
        if (loop.centre != own->centre && loop.area > kLargestShare * own->area)
            girth.other_centres.push_back(loop.centre);
    }
    return girth;
}

// From a limb's first joint to its second.
struct LimbSegment {
    Vec3d from = Vec3d::Zero();
    Vec3d along = Vec3d::Zero();  // m

    Plane across(double share) const { return {.point = from + share * along, .normal = along.normalized()}; }
};

std::optional<LimbSegment> first_segment(const Limb& limb) {
    if (!limb.is_found || limb.joints.size() < 2) return std::nullopt;
    const LimbSegment segment{limb.joints[0].centre, limb.joints[1].centre - limb.joints[0].centre};
    if (!(segment.along.norm() > 0)) return std::nullopt;
    return segment;
}

// Where the line through a segment meets the plane.
Vec3d meets(const LimbSegment& segment, const Plane& plane) {
    const double slope = segment.along.dot(plane.normal);
    if (slope == 0) return segment.from;
    return segment.from + (plane.point - segment.from).dot(plane.normal) / slope * segment.along;
}

bool goes_round_segment(const BodyGirth& girth, const LimbSegment& segment) {
    const auto is_beyond = [&](const Vec3d& x) { return (x - girth.plane.point).dot(girth.plane.normal) > 0; };
    return is_beyond(segment.from) != is_beyond(segment.from + segment.along) &&
           goes_round(girth.inside.points, girth.plane, meets(segment, girth.plane));
}

// Whether a section of a limb also goes round the torso, or round the limb on the other side: a coat that the arm lies
// against, thighs that touch.
bool holds_another_part(const BodyLimbs& limbs, LimbKind limb, const BodyGirth& girth) {
    const std::vector<LimbJoint>& torso = limbs.torso;
    for (std::size_t i = 0; i + 1 < torso.size(); ++i) {
        if (goes_round_segment(girth, {torso[i].centre, torso[i + 1].centre - torso[i].centre})) return true;
    }
    for (std::size_t i = 0; i < kLimbCount; ++i) {
        const auto other = first_segment(limbs.limbs[i]);
        if (i != index_of(limb) && other && goes_round_segment(girth, *other)) return true;
    }
    return false;
}

// A thigh beside the other one, cut by parallel planes.
class ThighCuts {
 public:
    ThighCuts(const Body& body, const LimbSegment& thigh, const LimbSegment& other)
        : body_(body), thigh_(thigh), other_(other) {
        const Vec3d along = thigh.along.normalized();
        stands_ = -along.y() > std::cos(kStandingLean);
        normal_ = stands_ ? -Vec3d::UnitY() : along;
    }

    // The plane so far beyond the hip joint along its normal, m, through the thigh's line.
    Plane at(double distance) const {
        const Plane plane{.point = thigh_.from + distance * normal_, .normal = normal_};
        return {.point = meets(thigh_, plane), .normal = normal_};
    }

    // Whether the section round the thigh's line is the thigh's alone.
    bool is_alone(double distance) const {
        const Plane plane = at(distance);
        const auto own = loop_round(section(body_, plane), plane, plane.point);
        return own && !goes_round(own->points, plane, meets(other_, plane));
    }

    // The nearest plane to the hip from which on the legs are apart: at the crotch. None: they are not down to the
    // knee.
    std::optional<double> crotch() const {
        constexpr double kStep = 0.01;      // m
        constexpr double kAboveHip = 0.25;  // of the thigh: short trunks part above the hip that is expected
        const double last = thigh_.along.dot(normal_);
        double distance = stands_ ? -kAboveHip * last : 0;
        while (distance < last && is_alone(distance)) distance += kStep;  // loops of the buttocks behind the hip
        for (; distance < last; distance += kStep) {
            if (is_alone(distance)) return bisect(distance - kStep, distance, [&](double at) { return is_alone(at); });
        }
        return std::nullopt;
    }

 private:
    static constexpr double kStandingLean = 30 * kDegree;  // of a thigh from the vertical

    const Body& body_;
    LimbSegment thigh_, other_;
    bool stands_ = true;
    Vec3d normal_ = -Vec3d::UnitY();  // of the planes, towards the knee
};

std::optional<ThighCuts> thigh_cuts(const MeasuredBody& body, LimbKind leg) {
    const LimbKind opposite = leg == LimbKind::LeftLeg ? LimbKind::RightLeg : LimbKind::LeftLeg;
    const auto thigh = first_segment(body.limbs()[leg]), other = first_segment(body.limbs()[opposite]);
    if (!thigh || !other) return std::nullopt;
    return ThighCuts(body.body(), *thigh, *other);
}

// The crotch of a body that stands, m.
std::optional<double> crotch_height(const MeasuredBody& body) {
    const auto cuts = thigh_cuts(body, LimbKind::LeftLeg);
    if (!cuts) return std::nullopt;
    const auto crotch = cuts->crotch();
    if (!crotch) return std::nullopt;
    return cuts->at(*crotch).point.y();
}

}  // namespace

std::optional<BodyGirth> trunk_girth(const MeasuredBody& body, double y) {
    BodyGirth girth{.plane = {.point = Vec3d(0, y, 0)}};
    const std::vector<SectionLoop> loops = body.sections().at(y);
    const std::vector<bool> of_trunk = are_of_trunk(loops, body.stature().height());
    double largest = 0;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        if (!of_trunk[i]) continue;
        add_section(girth, loops[i]);
        largest = std::max(largest, loops[i].area);
    }
    if (girth.centres.empty()) return std::nullopt;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        if (!of_trunk[i] && loops[i].area > kLargestShare * largest) girth.other_centres.push_back(loops[i].centre);
    }
    return girth;
}

std::optional<BodyGirth> waist_girth(const MeasuredBody& body) {
    if (!shows_trunk(body)) return std::nullopt;
    return trunk_girth(body, waist_height(body));
}

std::optional<BodyGirth> bust_girth(const MeasuredBody& body) {
    if (!shows_trunk(body)) return std::nullopt;
    constexpr double kFarthest = 0.07;  // of the stature, below the armpits: no bust lies lower
    constexpr double kNearest = 0.015;  // of the stature: nearer, the muscles of the arms are in the section
    const double waist = waist_height(body), height = body.stature().height();
    const std::optional<double> armpit = armpit_above(body, waist);
    if (!armpit) return std::nullopt;
    const double high = *armpit - kNearest * height;
    if (high <= waist) return std::nullopt;
    return widest_of_trunk(body, {std::max(waist, *armpit - kFarthest * height), high});
}

double highest_hip(const MeasuredBody& body) {
    return height_on_trunk(body, kHighestHip);
}

std::optional<BodyGirth> hip_girth(const MeasuredBody& body) {
    constexpr double kAboveCrotch = 0.02;  // m: nearer, its folds are in the section
    constexpr double kUsualCrotch = 0.45;  // of the stature
    const Stature& stature = body.stature();
    const double low = crotch_height(body).value_or(stature.floor + kUsualCrotch * stature.height()) + kAboveCrotch;
    const double high = highest_hip(body);
    if (high <= low) return std::nullopt;
    return widest_of_trunk(body, {low, high});
}

std::optional<BodyGirth> neck_girth(const MeasuredBody& body) {
    constexpr double kHighest = 0.6;  // of the way from its base to the middle of the head: below the chin
    constexpr double kWider = 1.02;   // than the narrowest: where it has ended
    const auto neck = first_segment(body.limbs()[LimbKind::Head]);
    if (!neck) return std::nullopt;
    const auto at = [&](int level) { return limb_girth(body.body(), neck->across(kHighest * level / kLevels)); };
    std::optional<BodyGirth> narrowest;
    for (int i = 0; i <= kLevels; ++i) keep_extreme(narrowest, at(i), -1);
    // A large head begins lower than is usual, and the neck below it.
    for (int i = -1; narrowest; --i) {
        std::optional<BodyGirth> lower = at(i);
        if (!lower || lower->length() > kWider * narrowest->length()) break;
        keep_extreme(narrowest, std::move(lower), -1);
    }
    const auto head = limb_girth(body.body(), neck->across(1));
    if (narrowest && (!head || narrowest->length() >= head->length())) return std::nullopt;
    return narrowest;
}

std::optional<BodyGirth> upper_limb_girth(const MeasuredBody& body, LimbKind limb, double share) {
    const auto upper = first_segment(body.limbs()[limb]);
    if (!upper) return std::nullopt;
    std::optional<BodyGirth> girth = limb_girth(body.body(), upper->across(share));
    if (girth && holds_another_part(body.limbs(), limb, *girth)) return std::nullopt;
    return girth;
}

std::optional<BodyGirth> sleeve_girth(const MeasuredBody& body, LimbKind arm) {
    return upper_limb_girth(body, arm, 0.5);
}

std::optional<BodyGirth> thigh_girth(const MeasuredBody& body, LimbKind leg) {
    constexpr double kBelowCrotch = 0.03;  // m
    const auto cuts = thigh_cuts(body, leg);
    if (!cuts) return std::nullopt;
    const auto crotch = cuts->crotch();
    if (!crotch || !cuts->is_alone(*crotch + kBelowCrotch)) return std::nullopt;
    return limb_girth(body.body(), cuts->at(*crotch + kBelowCrotch));
}

}  // namespace selvedge::sim
