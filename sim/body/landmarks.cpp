#include "sim/body/landmarks.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "sim/body/joint_names.h"
#include "sim/body/section.h"

namespace selvedge::sim {
namespace {

constexpr int kLevels = kLandmarkLevels;

// The sections at one height. The largest loop is the trunk, or the trunk with the arms, or a leg, or the head.
struct Level {
    double y = 0;
    double width = 0;       // m, of the largest loop
    bool has_pair = false;  // two loops of similar area side by side, as of legs
};

struct Extent {
    double low = 0;
    double high = 0;
    double area = 0;
};

Extent extent_of(const SectionLoop& loop) {
    const auto [low, high] = std::ranges::minmax(loop.points, {}, [](const Vec3d& p) { return p.x(); });
    return {low.x(), high.x(), loop.area};
}

Level level_at(const LevelSections& sections, double y) {
    constexpr double kSimilar = 0.4;  // ratio of areas
    std::vector<Extent> extents;
    for (const SectionLoop& loop : sections.at(y)) extents.push_back(extent_of(loop));
    std::ranges::stable_sort(extents, std::ranges::greater(), &Extent::area);
    Level level{.y = y};
    if (extents.empty()) return level;
    const Extent& first = extents[0];
    level.width = first.high - first.low;
    if (extents.size() < 2) return level;
    const Extent& second = extents[1];
    level.has_pair = second.area > kSimilar * first.area && (second.low > first.high || second.high < first.low);
    return level;
}

std::vector<Level> levels_of(const Body& body) {
    const HeightRange height = height_range(body);
    const LevelSections sections(body);
    std::vector<Level> levels;
    for (int i = 0; i < kLevels; ++i)
        levels.push_back(level_at(sections, height.low + (i + 0.5) / kLevels * (height.high - height.low)));
    return levels;
}

double between(const Level& a, const Level& b) {
    return (a.y + b.y) / 2;
}

// Index of the first level above the legs. The soles may have any sections; a gap is skipped.
std::optional<std::size_t> above_legs(const std::vector<Level>& levels) {
    constexpr std::size_t kSoles = kLevels / 4, kGap = kLevels / 20, kShortest = kLevels / 20;
    std::size_t end = 0, count = 0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (levels[i].has_pair) {
            end = i + 1;
            ++count;
        } else if (i >= (count > 0 ? end + kGap : kSoles)) {
            break;
        }
    }
    if (count < kShortest || end == levels.size()) return std::nullopt;
    return end;
}

double trunk_width(const std::vector<Level>& levels, std::size_t first) {
    std::vector<double> widths;
    for (std::size_t i = first; i < levels.size(); ++i) widths.push_back(levels[i].width);
    std::ranges::nth_element(widths, widths.begin() + std::ptrdiff_t(widths.size() / 2));
    return widths[widths.size() / 2];
}

// Index of the first level of the neck: above the highest level of nearly the trunk's width. The top of a wide head is
// no neck: it is short and narrows, while the stump of a neck is blunt.
std::optional<std::size_t> neck_level(const std::vector<Level>& levels, std::size_t first) {
    constexpr double kShoulders = 0.9, kNeck = 0.55;  // of the trunk's width
    const double width = trunk_width(levels, first);
    std::size_t at = levels.size();
    while (at > first && levels[at - 1].width < kShoulders * width) --at;
    while (at < levels.size() && levels[at].width >= kNeck * width) ++at;
    if (at == levels.size() || at == first) return std::nullopt;
    constexpr std::size_t kShort = kLevels / 20;
    constexpr double kBlunt = 0.5;
    const bool is_tip = levels.size() - at < kShort && levels.back().width < kBlunt * levels[at].width;
    return is_tip ? std::nullopt : std::optional(at);
}

// Index of the first level at which the arms have joined the trunk: the highest jump of its width.
std::optional<std::size_t> joined_arms(const std::vector<Level>& levels, std::size_t first, std::size_t last) {
    constexpr double kJump = 1.3;  // ratio of widths, over two levels, since the arms may join one after the other
    for (std::size_t i = last; i >= first + 2; --i)
        if (levels[i].width > kJump * levels[i - 2].width) return i - 1;
    return std::nullopt;
}

// The narrowest level, if the trunk widens away from it to both sides.
std::optional<std::size_t> waist_index(const std::vector<Level>& levels, std::size_t first, std::size_t last) {
    constexpr double kWider = 1.05;
    if (first + 2 >= last) return std::nullopt;
    const auto narrower = [](const Level& a, const Level& b) { return a.width < b.width; };
    const auto begin = levels.begin() + std::ptrdiff_t(first), end = levels.begin() + std::ptrdiff_t(last);
    const auto least = std::min_element(begin, end, narrower);
    for (const auto& [from, to] : {std::pair(begin, least + 1), std::pair(least, end)})
        if (std::max_element(from, to, narrower)->width < kWider * least->width) return std::nullopt;
    return std::size_t(least - levels.begin());
}

// The default mannequin's landmarks, as shares of its stature.
constexpr double kCrotch = 0.465, kWaist = 0.645, kArmpit = 0.755, kNeck = 0.845;

struct Lower {
    double y = 0;  // m
    double share = 0;
};

// The lowest landmark below the neck.
std::optional<Lower> lower_landmark(const LandmarkHeights& landmarks) {
    if (landmarks.crotch) return Lower{*landmarks.crotch, kCrotch};
    if (landmarks.waist) return Lower{*landmarks.waist, kWaist};
    if (landmarks.armpit) return Lower{*landmarks.armpit, kArmpit};
    return std::nullopt;
}

// Which ends of a person's skeleton its surface goes on beyond, whatever the sections show of bulky clothes.
struct SkeletonEnds {
    bool has_legs = false;
    bool has_head = false;
};

SkeletonEnds skeleton_ends(const Body& body, const HeightRange& height) {
    constexpr double kHead = 0.06;  // of the surface's height, over the joint of the head: the base of the skull
    const JointBones joints = find_joints(body.bones);
    const auto y = [&](Joint joint) { return body.bones[std::size_t(joints[joint])].joint.y(); };
    SkeletonEnds ends;
    if (!joints.has(Joint::Hips) || !joints.has(Joint::LeftFoot) || !joints.has(Joint::RightFoot)) return ends;
    ends.has_legs =
        height.low < std::max(y(Joint::LeftFoot), y(Joint::RightFoot)) && y(Joint::LeftFoot) < y(Joint::Hips);
    ends.has_head = joints.has(Joint::Head) && height.high - y(Joint::Head) > kHead * (height.high - height.low);
    return ends;
}

}  // namespace

LandmarkHeights find_landmarks(const Body& body) {
    LandmarkHeights found;
    if (body.triangles.empty()) return found;
    const std::vector<Level> levels = levels_of(body);
    const std::optional<std::size_t> trunk = above_legs(levels);
    if (trunk) found.crotch = between(levels[*trunk - 1], levels[*trunk]);
    const std::size_t first = trunk.value_or(0);
    const std::optional<std::size_t> neck = neck_level(levels, first);
    if (!neck) return found;
    const std::optional<std::size_t> arms = joined_arms(levels, first, *neck - 1);
    // Far above the armpits, it is the top of a head as wide as the trunk: of a figure in a cartoon, or in a helmet.
    constexpr double kFar = 0.5;  // of the distance from crotch to armpit; 0.31 to 0.35 on mannequins
    if (trunk && arms && double(*neck - *arms) > kFar * double(*arms - first)) return found;
    found.neck = between(levels[*neck - 1], levels[*neck]);
    if (arms) found.armpit = between(levels[*arms - 1], levels[*arms]);
    if (const auto waist = waist_index(levels, first, arms.value_or(*neck))) found.waist = levels[*waist].y;
    return found;
}

Stature find_stature(const Body& body) {
    return find_stature(body, find_landmarks(body));
}

Stature find_stature(const Body& body, const LandmarkHeights& landmarks) {
    constexpr double kWhole = 0.6;  // of the expected length: a shorter head or pair of legs is taken as cut off
    const HeightRange height = height_range(body);
    Stature stature{.floor = height.low, .crown = height.high};
    const std::optional<Lower> lower = lower_landmark(landmarks);
    if (!landmarks.neck || !lower || *landmarks.neck <= lower->y) return stature;
    const double neck = *landmarks.neck;
    const double by_trunk = (neck - lower->y) / (kNeck - lower->share);
    stature.has_legs = lower->y - height.low > kWhole * lower->share * by_trunk;
    stature.has_head = height.high - neck > kWhole * (1 - kNeck) * by_trunk;
    const SkeletonEnds ends = skeleton_ends(body, height);
    stature.has_legs |= ends.has_legs;
    stature.has_head |= ends.has_head;
    if (stature.has_legs && !stature.has_head) {
        stature.crown = height.low + (neck - height.low) / kNeck;
    } else if (!stature.has_legs && stature.has_head) {
        stature.floor = height.high - (height.high - lower->y) / (1 - lower->share);
    } else if (!stature.has_legs) {
        stature.floor = neck - kNeck * by_trunk;
        stature.crown = stature.floor + by_trunk;
    }
    return stature;
}

}  // namespace selvedge::sim
