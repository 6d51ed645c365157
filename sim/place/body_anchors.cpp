#include "sim/place/body_anchors.h"

#include <algorithm>

#include "sim/body/section.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {

Anchors anchors_of(const Body& body, const Stature& stature) {
    constexpr double kNeckSide = 0.845, kCrotch = 0.47;  // of the stature (the mannequin's proportions)
    Anchors anchors;
    const TorsoHeights heights = torso_heights(body, stature);
    const LandmarkHeights landmarks = find_landmarks(body);
    anchors.shoulder = stature.floor + kNeckSide * stature.height();
    anchors.waist = heights.waist;
    anchors.hip = heights.hip;
    anchors.crotch = landmarks.crotch.value_or(stature.floor + kCrotch * stature.height());
    Eigen::AlignedBox3d box;
    for (const double y : {heights.chest, heights.waist, heights.hip}) {
        for (const Vec3d& p : trunk_points(body, y, stature.height())) box.extend(p);
    }
    if (box.isEmpty()) box.extend(Vec3d(0, heights.waist, 0));
    anchors.centre = Vec3d(box.center().x(), heights.waist, box.center().z());
    anchors.front = box.max().z();
    anchors.back = box.min().z();
    return anchors;
}

TrunkSection trunk_section(const Body& body, double y, double stature) {
    TrunkSection section;
    SectionLoop loop;
    loop.points = trunk_points(body, y, stature);
    if (loop.points.empty()) return section;
    section.centre = middle_of_box(loop.points);
    for (const Vec3d& p : loop.points) section.reach = std::max(section.reach, (p - section.centre).norm());
    section.girth = tape_length(loop, {.point = section.centre, .normal = Vec3d::UnitY()});
    return section;
}

}  // namespace selvedge::sim
