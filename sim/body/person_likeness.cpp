#include "sim/body/person_likeness.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "sim/body/section.h"

namespace selvedge::sim {
namespace {

constexpr int kCheckedLevels = 60;

// Shares of the stature between which people lie in any pose in which they are dressed, from children to cartoons. The
// crotch is at 0.40 of the stature of a child of four and at 0.47 of an adult's (Drillis and Contini 1966: 0.47 to
// 0.53 for the hip above it), the chin at 0.80 and 0.87.
struct ShareRange {
    double least = 0;
    double most = 0;

    bool holds(double share) const { return share >= least && share <= most; }
};
constexpr ShareRange kCrotchShare{0.30, 0.60};
constexpr ShareRange kNeckShare{0.60, 0.93};
constexpr double kLeastPart = 0.25;            // height of what is there: from the waist to the neck
constexpr ShareRange kDepthShare{0.06, 0.50};  // of the whole surface, with feet and lifted hands
constexpr ShareRange kWidthShare{0.12, 1.30};  // of the whole surface: arms that are spread reach as far as it is tall
constexpr ShareRange kTrunkShare{0.08, 0.50};  // breadth of the trunk

struct Extents {
    double width = 0;  // along x
    double depth = 0;  // along z
};

Extents extents_of(const std::vector<Vec3d>& points) {
    Eigen::AlignedBox3d box;
    for (const Vec3d& p : points) box.extend(p);
    return {box.sizes().x(), box.sizes().z()};
}

// The sections at one height, the largest first.
struct CheckedLevel {
    double y = 0;
    double width = 0;  // of the largest section
    double depth = 0;
    std::size_t similar = 0;  // sections of similar area as the largest, with it
};

std::vector<CheckedLevel> checked_levels(const Body& body) {
    constexpr double kSimilar = 0.4;  // ratio of areas, as for the pairs of find_landmarks()
    const HeightRange height = height_range(body);
    const LevelSections sections(body);
    std::vector<CheckedLevel> levels;
    for (int i = 0; i < kCheckedLevels; ++i) {
        CheckedLevel& level = levels.emplace_back();
        level.y = height.low + (i + 0.5) / kCheckedLevels * (height.high - height.low);
        const std::vector<SectionLoop> loops = sections.at(level.y);
        const auto largest = std::ranges::max_element(loops, {}, &SectionLoop::area);
        if (largest == loops.end()) continue;
        const Extents box = extents_of(largest->points);
        level.width = box.width;
        level.depth = box.depth;
        level.similar = std::size_t(std::ranges::count_if(
            loops, [&](const SectionLoop& loop) { return loop.area > kSimilar * largest->area; }));
    }
    return levels;
}

template <class Value>
double median_between(const std::vector<CheckedLevel>& levels, double low, double high, const Value& value) {
    std::vector<double> values;
    for (const CheckedLevel& level : levels)
        if (level.y > low && level.y < high && level.similar > 0) values.push_back(value(level));
    if (values.empty()) return 0;
    std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(values.size() / 2));
    return values[values.size() / 2];
}

// What of a person is not there; empty if enough is.
std::string missing_parts(const LandmarkHeights& marks) {
    if (!marks.neck && !marks.crotch) return "no neck and no two legs were found on it";
    // The neck of a figure whose head is as wide as its trunk is not found: it has two legs.
    if (marks.neck && !marks.crotch && !marks.waist && !marks.armpit)
        return "no legs, no waist and no armpits were found on it";
    return "";
}

// Where the landmarks lie.
std::string wrong_shares(const PersonLikeness& found) {
    const LandmarkHeights& marks = found.landmarks;
    const Stature& stature = found.stature;
    const auto share = [&](double y) { return (y - stature.floor) / stature.height(); };
    if (marks.crotch && !kCrotchShare.holds(share(*marks.crotch))) return "its legs are not as long as a person's";
    if (marks.neck && !kNeckShare.holds(share(*marks.neck))) return "its head is not as large as a person's";
    return "";
}

std::string wrong_proportions(const PersonLikeness& found, const Body& body, const std::vector<CheckedLevel>& levels) {
    const LandmarkHeights& marks = found.landmarks;
    const Stature& stature = found.stature;
    const Extents box = extents_of(body.x);
    const HeightRange height = height_range(body);
    if (height.high - height.low < kLeastPart * stature.height()) return "it is too small a part of a person";
    if (!kDepthShare.holds(box.depth / stature.height()) || !kWidthShare.holds(box.width / stature.height()))
        return "it is not as wide and deep as a person who stands";
    const double low = marks.crotch.value_or(stature.floor);
    const double high = marks.neck.value_or(stature.crown);
    const double width = median_between(levels, low, high, [](const CheckedLevel& level) { return level.width; });
    if (!kTrunkShare.holds(width / stature.height())) return "its trunk is not as wide as a person's";
    // A person's trunk is wider than it is deep; a bottle, which has a neck too, is round.
    constexpr double kFlat = 1.1;
    const double flatness = median_between(
        levels, low, high, [](const CheckedLevel& level) { return level.width / std::max(level.depth, 1e-9); });
    if (!marks.crotch && flatness < kFlat) return "its trunk is as deep as it is wide, and it has no legs";
    return "";
}

// Chairs, tables and animals on four legs have more than two; a body on its head has them above.
std::string wrong_legs(const PersonLikeness& found, const std::vector<CheckedLevel>& levels) {
    const auto count = [](const CheckedLevel& level) { return double(level.similar); };
    const Stature& stature = found.stature;
    if (found.landmarks.crotch && stature.has_legs) {
        const double crotch = *found.landmarks.crotch;
        // Between ankles and crotch: the feet may have any sections.
        const double legs = median_between(levels, stature.floor + 0.2 * (crotch - stature.floor), crotch, count);
        if (legs > 2) return "it stands on more than two legs";
    }
    const double upper = (stature.floor + stature.crown) / 2;
    if (median_between(levels, upper, stature.crown, count) >= 2) return "its upper half is in several parts";
    return "";
}

// From the shins to the feet before them, on average over both legs.
std::optional<Vec2d> direction_of_feet(const PersonLikeness& found, const Body& body) {
    constexpr double kSole = 0.015, kShin = 0.07;  // of the stature; the ankle is at 0.039 (Drillis and Contini 1966)
    constexpr double kClear = 0.012;               // of the stature: feet reach 0.03 farther to the front than shins
    const Stature& stature = found.stature;
    if (!found.landmarks.crotch || !stature.has_legs) return std::nullopt;
    const LevelSections sections(body);
    const auto middle_at = [&](double share) -> std::optional<Vec2d> {
        Vec2d moment = Vec2d::Zero();
        double area = 0;
        for (const SectionLoop& loop : sections.at(stature.floor + share * stature.height())) {
            moment += loop.area * Vec2d(loop.centre.x(), loop.centre.z());
            area += loop.area;
        }
        return area > 0 ? std::optional<Vec2d>(moment / area) : std::nullopt;
    };
    const std::optional<Vec2d> sole = middle_at(kSole), shin = middle_at(kShin);
    if (!sole || !shin || (*sole - *shin).norm() < kClear * stature.height()) return std::nullopt;
    return *sole - *shin;
}

}  // namespace

double cuts_of_likeness(const Body& body) {
    const HeightRange height = height_range(body);
    if (!(height.high > height.low)) return 0;
    double spans = 0;
    for (const auto& [a, b, c] : body.triangles) {
        const auto [low, high] =
            std::minmax({body.x[std::size_t(a)].y(), body.x[std::size_t(b)].y(), body.x[std::size_t(c)].y()});
        spans += high - low;
    }
    return (kLandmarkLevels + kCheckedLevels) * spans / (height.high - height.low);
}

PersonLikeness person_likeness(const Body& body) {
    PersonLikeness found;
    if (body.triangles.empty()) return {.lacks = "it has no surface"};
    found.landmarks = find_landmarks(body);
    found.stature = find_stature(body, found.landmarks);
    found.lacks = missing_parts(found.landmarks);
    if (found.lacks.empty()) found.lacks = wrong_shares(found);
    if (!found.lacks.empty()) return found;
    const std::vector<CheckedLevel> levels = checked_levels(body);
    found.lacks = wrong_proportions(found, body, levels);
    if (found.lacks.empty()) found.lacks = wrong_legs(found, levels);
    if (found.lacks.empty()) found.faces = direction_of_feet(found, body);
    return found;
}

}  // namespace selvedge::sim
