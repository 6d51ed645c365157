#include "sim/place/limbs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <span>
#include <utility>

#include "sim/body/joint_names.h"
#include "sim/core/assert.h"
#include "sim/place/proportions.h"

namespace selvedge::sim {
namespace {

using std::string_view_literals::operator""sv;

constexpr std::array<std::string_view, kLimbCount> kNames{"head", "left arm", "right arm", "left leg", "right leg"};

// Heights and lengths as fractions of the stature (Drillis and Contini 1966).
constexpr double kHand = 0.108;
constexpr double kForearm = 0.146;
constexpr double kUpperArm = 0.186;
constexpr double kHipHeight = 0.530;
constexpr double kThighHeight = 0.400;  // where every pose has two legs
constexpr double kKneeHeight = 0.285;
constexpr double kAnkleHeight = 0.039;
constexpr double kFingertipHeight = 0.377;  // of an arm that hangs down: no fingertip is lower
constexpr double kChinHeight = 0.870;
constexpr double kUsualRadius = 0.03;  // of a limb without a section

// A section so much larger than a limb belongs to the torso.
constexpr double kWidestArm = 0.07;  // of the stature, largest distance from the centre

double radius_of(const SectionLoop& loop) {
    return std::sqrt(loop.area / std::numbers::pi);
}

double stature_of(const HeightRange& height) {
    return height.high - height.low;
}

const Bone* find_bone(const Body& body, const std::string& name) {
    const auto found = std::ranges::find(body.bones, name, &Bone::name);
    return found == body.bones.end() ? nullptr : &*found;
}

// Joints with these names, in order; empty if one is missing.
std::vector<LimbJoint> joints_of_bones(const Body& body, const std::string& side,
                                       const std::array<std::string_view, 3>& names) {
    std::vector<LimbJoint> joints;
    for (const std::string_view name : names) {
        const Bone* bone = find_bone(body, side + std::string(name));
        if (bone == nullptr) return {};
        joints.push_back({bone->joint, 0});
    }
    return joints;
}

// Measures the section halfway between each joint and the next. Limbs overlap where they meet, so the loop nearest to
// the line is taken.
void measure_radii(const Body& body, double stature, std::vector<LimbJoint>& joints) {
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const Vec3d along = joints[i + 1].centre - joints[i].centre;
        const Vec3d middle = joints[i].centre + along / 2;
        joints[i].radius = kUsualRadius * stature;
        if (along.norm() == 0) continue;
        const auto loop = nearest_loop(section(body, {.point = middle, .normal = along.normalized()}), middle);
        if (loop && (loop->centre - middle).norm() < 2 * radius_of(*loop)) joints[i].radius = radius_of(*loop);
        if (i > 0) joints[i].radius = std::max(joints[i].radius, joints[i - 1].radius / 2);  // not of one finger
    }
    if (joints.size() > 1) joints.back().radius = joints[joints.size() - 2].radius;
}

// Legs.

// Centre of a leg at a level: of the loop nearest to the body's middle on the given side, among those that are no
// sliver, as between thighs that touch, nor a fold of clothes.
std::optional<Vec3d> leg_centre(const Body& body, double y, double side) {
    constexpr double kOffMiddle = 0.01;      // m, a loop round both legs is nearer
    constexpr double kLeastOfLargest = 0.3;  // of the area of the largest loop on that side
    std::vector<SectionLoop> loops = section(body, {.point = Vec3d(0, y, 0)});
    std::erase_if(loops, [&](const SectionLoop& loop) { return side * loop.centre.x() < kOffMiddle; });
    double largest = 0;
    for (const SectionLoop& loop : loops) largest = std::max(largest, loop.area);
    std::optional<Vec3d> found;
    for (const SectionLoop& loop : loops) {
        if (loop.area < kLeastOfLargest * largest) continue;
        if (!found || side * loop.centre.x() < side * found->x()) found = loop.centre;
    }
    return found;
}

std::vector<LimbJoint> leg_of_sections(const Body& body, const HeightRange& height, double side) {
    const auto at = [&](double share) { return leg_centre(body, height.low + share * stature_of(height), side); };
    const auto thigh = at(kThighHeight), knee = at(kKneeHeight), ankle = at(2 * kAnkleHeight);
    if (!knee || !ankle) return {};
    Vec3d hip = thigh.value_or(*knee);
    hip.y() = height.low + kHipHeight * stature_of(height);
    return {{hip, 0}, {*knee, 0}, {*ankle, 0}};
}

// Arms, on the surface.

// The edges of a surface as a graph.
class SurfaceGraph {
 public:
    explicit SurfaceGraph(const Body& body) : body_(body), starts_(body.x.size() + 1, 0) {
        for (const auto& triangle : body.triangles) {
            for (const int v : triangle) starts_[static_cast<std::size_t>(v) + 1] += 2;
        }
        for (std::size_t v = 0; v + 1 < starts_.size(); ++v) starts_[v + 1] += starts_[v];
        neighbours_.resize(static_cast<std::size_t>(starts_.back()));
        std::vector<int> next(starts_.begin(), starts_.end() - 1);
        for (const auto& triangle : body.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                int& place = next[static_cast<std::size_t>(triangle[k])];
                for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3})
                    neighbours_[static_cast<std::size_t>(place++)] = static_cast<std::size_t>(triangle[other]);
            }
        }
    }

    // Each occurs twice.
    std::span<const std::size_t> neighbours(std::size_t v) const {
        const auto first = static_cast<std::size_t>(starts_[v]);
        return std::span(neighbours_).subspan(first, static_cast<std::size_t>(starts_[v + 1]) - first);
    }

    // The length of the shortest path along edges from a vertex to each other, m; infinite beyond `farthest`.
    // (Dijkstra 1959)
    std::vector<double> distances(std::size_t from, double farthest) const {
        std::vector<double> distance(body_.x.size(), std::numeric_limits<double>::infinity());
        using Entry = std::pair<double, std::size_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
        distance[from] = 0;
        queue.emplace(0, from);
        while (!queue.empty()) {
            const auto [length, v] = queue.top();
            queue.pop();
            if (length > distance[v] || length > farthest) continue;
            for (const std::size_t w : neighbours(v)) {
                const double longer = length + (body_.x[w] - body_.x[v]).norm();
                if (longer >= distance[w]) continue;
                distance[w] = longer;
                queue.emplace(longer, w);
            }
        }
        return distance;
    }

 private:
    const Body& body_;
    std::vector<int> starts_;  // per vertex, of its part of neighbours_
    std::vector<std::size_t> neighbours_;
};

struct Ring {
    Vec3d centre = Vec3d::Zero();
    double widest = 0;  // m, largest distance from the centre
};

// The curve on which the distance has this value.
std::optional<Ring> ring_at(const Body& body, const std::vector<double>& distance, double level) {
    std::vector<Vec3d> points;
    for (const auto& triangle : body.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = static_cast<std::size_t>(triangle[k]), b = static_cast<std::size_t>(triangle[(k + 1) % 3]);
            if (!(distance[a] <= level && level < distance[b]) || std::isinf(distance[b])) continue;
            const double t = (level - distance[a]) / (distance[b] - distance[a]);
            points.emplace_back(body.x[a] + t * (body.x[b] - body.x[a]));
        }
    }
    if (points.empty()) return std::nullopt;
    Ring ring{.centre = middle_of_box(points)};
    for (const Vec3d& p : points) ring.widest = std::max(ring.widest, (p - ring.centre).norm());
    return ring;
}

// The tip of an arm: farther from the top of the head, along the surface, than all that is near it. The thighs are
// farther still, but go on downward.
std::optional<std::size_t> fingertip(const Body& body, const HeightRange& height, const SurfaceGraph& graph,
                                     const std::vector<double>& from_head, double side) {
    const double stature = stature_of(height);
    const double lowest = height.low + 0.95 * kFingertipHeight * stature;
    std::vector<std::size_t> tips;
    for (std::size_t v = 0; v < body.x.size(); ++v) {
        if (body.x[v].y() < lowest || side * body.x[v].x() <= 0 || std::isinf(from_head[v])) continue;
        if (std::ranges::all_of(graph.neighbours(v), [&](std::size_t w) { return from_head[w] <= from_head[v]; }))
            tips.push_back(v);
    }
    std::ranges::stable_sort(tips, [&](std::size_t a, std::size_t b) { return from_head[a] > from_head[b]; });
    for (const std::size_t tip : tips) {
        const std::vector<double> near = graph.distances(tip, 0.5 * kHand * stature);
        bool is_farthest = true;
        for (std::size_t v = 0; v < near.size() && is_farthest; ++v)
            is_farthest = std::isinf(near[v]) || from_head[v] <= from_head[tip];
        if (is_farthest) return tip;
    }
    return std::nullopt;
}

std::vector<LimbJoint> arm_of_surface(const Body& body, const SurfaceGraph& graph, double stature, std::size_t tip) {
    const double reach = (kHand + kForearm + kUpperArm) * stature;
    const std::vector<double> distance = graph.distances(tip, reach);
    const auto at = [&](double share) { return ring_at(body, distance, share * stature); };
    const auto wrist = at(kHand), elbow = at(kHand + kForearm), biceps = at(kHand + kForearm + 0.4 * kUpperArm);
    for (const auto& ring : {wrist, at(kHand + 0.5 * kForearm), elbow, biceps}) {
        if (!ring || ring->widest > kWidestArm * stature) return {};
    }
    const Vec3d up = (biceps->centre - elbow->centre).normalized();
    return {{elbow->centre + kUpperArm * stature * up, 0}, {elbow->centre, 0}, {wrist->centre, 0}, {body.x[tip], 0}};
}

// The middle of the limb across its line at a point; the point itself if the section there is another part's.
Vec3d middle_at(const Body& body, const Vec3d& point, const Vec3d& along, double widest) {
    const auto loop = nearest_loop(section(body, {.point = point, .normal = along.normalized()}), point);
    return loop && (loop->centre - point).norm() < widest ? loop->centre : point;
}

// Joints of curves on the surface lie off the middle of an arm that is bent, and the shoulder, which is where an upper
// arm of usual length ends, may lie outside.
void centre_arm(const Body& body, double stature, Limb& arm) {
    constexpr std::size_t kParts = 3;     // of each segment
    constexpr double kIntoArm = 1.0 / 6;  // of the upper arm, from the shoulder
    const double widest = kWidestArm * stature;
    std::vector<LimbJoint>& joints = arm.joints;
    for (std::size_t i = 1; i + 1 < joints.size(); ++i)
        joints[i].centre = middle_at(body, joints[i].centre, joints[i + 1].centre - joints[i - 1].centre, widest);
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const Vec3d &from = joints[i].centre, &to = joints[i + 1].centre;
        arm.line.push_back(i == 0 ? Vec3d(from + kIntoArm * (to - from)) : from);
        for (std::size_t k = 1; k < kParts; ++k) {
            const double share = static_cast<double>(k) / kParts;
            arm.line.push_back(middle_at(body, from + share * (to - from), to - from, widest));
        }
    }
    arm.line.push_back(joints.back().centre);
}

void find_arms(const Body& body, BodyLimbs& limbs) {
    const SurfaceGraph graph(body);
    const auto top =
        std::ranges::max_element(body.x, [](const Vec3d& a, const Vec3d& b) { return a.y() < b.y(); }) - body.x.begin();
    const auto from_head = graph.distances(static_cast<std::size_t>(top), std::numeric_limits<double>::infinity());
    for (const auto& [kind, side] : {std::pair(LimbKind::LeftArm, 1.0), std::pair(LimbKind::RightArm, -1.0)}) {
        const auto tip = fingertip(body, limbs.height, graph, from_head, side);
        if (!tip) continue;
        Limb& arm = limbs.limbs[index_of(kind)];
        arm.joints = arm_of_surface(body, graph, stature_of(limbs.height), *tip);
        if (!arm.joints.empty()) centre_arm(body, stature_of(limbs.height), arm);
    }
}

// The whole body.

bool has_known_bones(const Body& body) {
    return find_bone(body, "left_hand") != nullptr && find_bone(body, "left_foot") != nullptr;
}

void take_bones(const Body& body, BodyLimbs& limbs) {
    constexpr std::array kArm{"upper_arm"sv, "lower_arm"sv, "hand"sv}, kLeg{"upper_leg"sv, "lower_leg"sv, "foot"sv};
    for (const auto& [side, arm, leg] : {std::tuple("left_", LimbKind::LeftArm, LimbKind::LeftLeg),
                                         std::tuple("right_", LimbKind::RightArm, LimbKind::RightLeg)}) {
        std::vector<LimbJoint>& joints = limbs.limbs[index_of(arm)].joints;
        joints = joints_of_bones(body, side, kArm);
        limbs.limbs[index_of(leg)].joints = joints_of_bones(body, side, kLeg);
        if (joints.empty()) continue;
        const Vec3d along = (joints[2].centre - joints[1].centre).normalized();
        joints.push_back({joints[2].centre + kHand * stature_of(limbs.height) * along, 0});
    }
}

struct NamedLimb {
    LimbKind kind;
    std::array<Joint, 3> joints;
};
constexpr std::array<NamedLimb, 4> kNamedLimbs{
    {{LimbKind::LeftArm, {Joint::LeftUpperArm, Joint::LeftLowerArm, Joint::LeftHand}},
     {LimbKind::RightArm, {Joint::RightUpperArm, Joint::RightLowerArm, Joint::RightHand}},
     {LimbKind::LeftLeg, {Joint::LeftUpperLeg, Joint::LeftLowerLeg, Joint::LeftFoot}},
     {LimbKind::RightLeg, {Joint::RightUpperLeg, Joint::RightLowerLeg, Joint::RightFoot}}}};

// Limbs by the joints that a skeleton names: where the surface does not show them, as on some bodies of separate parts,
// or shows others, as where something is worn on an arm or held in a hand; and on figures of unusual proportions, whose
// limbs are not as long as those of people of their height.
void take_named_joints(const Body& body, const Proportions& proportions, BodyLimbs& limbs) {
    constexpr double kOther = 0.1;  // of the stature, from a joint's bone: no limb is so thick
    const JointBones bones = find_joints(body.bones);
    for (const auto& [kind, joints] : kNamedLimbs) {
        Limb& found = limbs.limbs[index_of(kind)];
        std::vector<LimbJoint>& limb = found.joints;
        if (!std::ranges::all_of(joints, [&](Joint joint) { return bones.has(joint); })) continue;
        std::array<Vec3d, 3> named;
        for (std::size_t i = 0; i < 3; ++i) named[i] = body.bones[static_cast<std::size_t>(bones[joints[i]])].joint;
        bool is_other = limb.size() < 3 || !proportions.is_usual;
        for (std::size_t i = 0; i < 3 && !is_other; ++i)
            is_other = (limb[i].centre - named[i]).norm() > kOther * stature_of(limbs.height);
        if (!is_other) continue;
        limb.clear();
        found.line.clear();
        for (const Vec3d& joint : named) limb.push_back({joint, 0});
        if (kind != LimbKind::LeftArm && kind != LimbKind::RightArm) continue;
        const Vec3d along = (limb[2].centre - limb[1].centre).normalized();
        limb.push_back({limb[2].centre + kHand * proportions.stature_by_trunk() * along, 0});
    }
}

void find_torso(const Body& body, const Stature& stature, const Proportions& proportions, BodyLimbs& limbs) {
    const TorsoHeights heights = torso_heights(body, stature);
    for (const double y : {heights.hip, heights.waist, heights.chest, heights.neck}) {
        const std::vector<Vec3d> points = trunk_points(body, y, stature_of(limbs.height));
        if (points.empty()) {
            limbs.torso.clear();
            return;
        }
        limbs.torso.push_back({middle_of_box(points), 0});
    }
    const Vec3d& neck = limbs.torso.back().centre;
    const double chin = proportions.at(kChinHeight);
    const double middle = (std::max(neck.y(), chin) + limbs.height.high) / 2;
    const std::vector<Vec3d> head = trunk_points(body, middle, stature_of(limbs.height));
    if (head.empty()) return;
    const Vec3d centre = middle_of_box(head);
    limbs.limbs[index_of(LimbKind::Head)].joints = {
        {neck, 0}, {centre, 0}, {Vec3d(centre.x(), limbs.height.high, centre.z()), 0}};
}

}  // namespace

std::string_view name_of(LimbKind kind) {
    return kNames[index_of(kind)];
}

LimbSet BodyLimbs::found() const {
    LimbSet found;
    for (std::size_t i = 0; i < kLimbCount; ++i) found[i] = limbs[i].is_found;
    return found;
}

BodyLimbs find_limbs(const Body& body) {
    return find_limbs(body, find_stature(body));
}

BodyLimbs find_limbs(const Body& body, const Stature& stature) {
    BodyLimbs found;
    if (body.triangles.empty()) return found;
    found.height = {stature.floor, stature.crown};
    const Proportions proportions = find_proportions(body, stature);
    find_torso(body, stature, proportions, found);
    if (found.torso.empty()) return found;
    if (has_known_bones(body)) {
        take_bones(body, found);
    } else {
        find_arms(body, found);
        found.limbs[index_of(LimbKind::LeftLeg)].joints = leg_of_sections(body, found.height, 1);
        found.limbs[index_of(LimbKind::RightLeg)].joints = leg_of_sections(body, found.height, -1);
        take_named_joints(body, proportions, found);
    }
    for (const LimbKind leg : {LimbKind::LeftLeg, LimbKind::RightLeg}) {
        std::vector<LimbJoint>& joints = found.limbs[index_of(leg)].joints;
        if (joints.empty()) continue;
        joints.push_back(joints.back());
        joints.back().centre.y() = found.height.low;
    }
    measure_radii(body, stature_of(found.height), found.torso);
    for (Limb& limb : found.limbs) {
        limb.is_found = !limb.joints.empty();
        measure_radii(body, stature_of(found.height), limb.joints);
        if (!limb.line.empty()) continue;
        for (const LimbJoint& joint : limb.joints) limb.line.push_back(joint.centre);
    }
    return found;
}

std::vector<Vec3d> line_to_end(const BodyLimbs& limbs, LimbKind kind) {
    SELVEDGE_ASSERT(limbs[kind].is_found);
    // Hips; up to the chest for an arm, up to the neck for the head.
    const std::size_t shared = kind == LimbKind::Head                                    ? 3
                               : kind == LimbKind::LeftLeg || kind == LimbKind::RightLeg ? 1
                                                                                         : 3;
    std::vector<Vec3d> line;
    for (std::size_t i = 0; i < shared; ++i) line.push_back(limbs.torso[i].centre);
    std::ranges::copy(limbs[kind].line, std::back_inserter(line));
    return line;
}

double nearest_share(const LimbJoint& from, const LimbJoint& to, const Vec3d& x) {
    const Vec3d along = to.centre - from.centre;
    return std::clamp(along.dot(x - from.centre) / along.squaredNorm(), 0.0, 1.0);
}

namespace {

struct NearestOnLine {
    double distance = std::numeric_limits<double>::infinity();  // m, from the section
    std::size_t joint = 0;
    double share = 0;
};

NearestOnLine nearest_on_line(const std::vector<LimbJoint>& joints, const Vec3d& x) {
    NearestOnLine nearest;
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const Vec3d along = joints[i + 1].centre - joints[i].centre;
        const double share = nearest_share(joints[i], joints[i + 1], x);
        const double distance = (joints[i].centre + share * along - x).norm() - joints[i].radius;
        if (distance < nearest.distance) nearest = {distance, i, share};
    }
    return nearest;
}

struct PartNames {
    std::array<std::string_view, 4> joints;
    std::array<std::string_view, 3> parts;  // between two joints; empty: named after the nearer joint
};
constexpr PartNames kTorsoNames{{"hips", "waist", "chest", "neck"}, {"", "", ""}};
constexpr PartNames kHeadNames{{"neck", "head", "head", "head"}, {"", "", ""}};
constexpr PartNames kArmNames{{"shoulder", "elbow", "wrist", "hand"}, {"upper arm", "forearm", "hand"}};
constexpr PartNames kLegNames{{"hip", "knee", "ankle", "foot"}, {"thigh", "calf", "foot"}};

const PartNames& names_of(const std::optional<LimbKind>& limb) {
    if (!limb) return kTorsoNames;
    if (*limb == LimbKind::Head) return kHeadNames;
    return *limb == LimbKind::LeftArm || *limb == LimbKind::RightArm ? kArmNames : kLegNames;
}

}  // namespace

std::optional<LimbPosition> nearest_on_limbs(const BodyLimbs& limbs, const Vec3d& x) {
    if (limbs.torso.empty()) return std::nullopt;
    NearestOnLine nearest = nearest_on_line(limbs.torso, x);
    std::optional<LimbKind> kind;
    for (std::size_t i = 0; i < kLimbCount; ++i) {
        if (!limbs.limbs[i].is_found) continue;
        const NearestOnLine other = nearest_on_line(limbs.limbs[i].joints, x);
        if (other.distance >= nearest.distance) continue;
        nearest = other;
        kind = static_cast<LimbKind>(i);
    }
    return LimbPosition{.limb = kind, .joint = nearest.joint, .share = nearest.share};
}

std::string place_on_body(const BodyLimbs& limbs, const Vec3d& x) {
    constexpr double kAtJoint = 0.2;  // of the part's length
    const std::optional<LimbPosition> at = nearest_on_limbs(limbs, x);
    if (!at) return "";
    const PartNames& names = names_of(at->limb);
    std::string_view name = names.parts[at->joint];
    const double reach = name.empty() ? 0.5 : kAtJoint;
    if (at->share <= reach) name = names.joints[at->joint];
    if (at->share > 1 - reach) name = names.joints[at->joint + 1];
    if (!at->limb || *at->limb == LimbKind::Head) return std::string(name);
    const bool is_left = *at->limb == LimbKind::LeftArm || *at->limb == LimbKind::LeftLeg;
    return (is_left ? "left " : "right ") + std::string(name);
}

// Torso.

Vec3d middle_of_box(const std::vector<Vec3d>& points) {
    Eigen::AlignedBox3d box;
    for (const Vec3d& p : points) box.extend(p);
    return box.center();
}

std::vector<bool> are_of_trunk(const std::vector<SectionLoop>& sections, double stature) {
    const double reach = 0.1 * stature;     // of the trunk's middle from the body's
    constexpr double kLeastOfTrunk = 0.35;  // of the largest area: both legs, but no hand before the body
    const auto is_middle = [&](const SectionLoop& loop) { return std::abs(loop.centre.x()) < reach; };
    double largest = 0;
    for (const SectionLoop& loop : sections) {
        if (is_middle(loop)) largest = std::max(largest, loop.area);
    }
    std::vector<bool> of_trunk;
    for (const SectionLoop& loop : sections) of_trunk.push_back(is_middle(loop) && loop.area > kLeastOfTrunk * largest);
    return of_trunk;
}

std::vector<Vec3d> trunk_points(const Body& body, double y, double stature) {
    const std::vector<SectionLoop> loops = section(body, {.point = Vec3d(0, y, 0)});
    const std::vector<bool> of_trunk = are_of_trunk(loops, stature);
    std::vector<Vec3d> points;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        if (of_trunk[i]) points.insert(points.end(), loops[i].points.begin(), loops[i].points.end());
    }
    return points;
}

namespace {

// Height of the smallest girth of the trunk, m.
double waist_level(const Body& body, const Stature& stature, const Proportions& proportions) {
    double least = std::numeric_limits<double>::max();
    double waist = proportions.at(0.62);
    for (double share = 0.57; share < 0.685; share += 0.01) {
        const double y = proportions.at(share);
        const std::vector<Vec3d> points = trunk_points(body, y, stature.height());
        if (points.empty()) continue;
        const double girth = tape_length({.points = points, .centre = {}, .area = 0}, {.point = Vec3d(0, y, 0)});
        if (girth >= least) continue;
        least = girth;
        waist = y;
    }
    return waist;
}

double joint_height(const Body& body, const std::string& name, double otherwise) {
    const Bone* bone = find_bone(body, name);
    return bone == nullptr ? otherwise : bone->joint.y();
}

}  // namespace

TorsoHeights torso_heights(const Body& body, const Stature& stature) {
    const Proportions proportions = find_proportions(body, stature);
    const double height = proportions.stature_by_trunk();
    return {.neck = joint_height(body, "neck", proportions.at(0.848)) + 0.012 * height,
            .chest = proportions.at(0.728),
            .waist = waist_level(body, stature, proportions),
            .hip = joint_height(body, "hips", proportions.at(0.525)) - 0.037 * height};
}

}  // namespace selvedge::sim
