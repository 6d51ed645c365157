#include "sim/motion/grounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/body/joint_names.h"
#include "sim/body/skin.h"
#include "sim/body/soles.h"

namespace selvedge::sim {
namespace {

double lowest_of(const std::vector<Vec3f>& x) {
    float lowest = std::numeric_limits<float>::infinity();
    for (const Vec3f& p : x) lowest = std::min(lowest, p.y());
    return double(lowest);
}

// A way in our frame, in the frame of the root bones.
Vec3d in_root_frame(const Body& body, const Vec3d& way) {
    return body.frame.linear().inverse() * way;
}

constexpr double kRate = 30;  // 1/s, of the looks at a clip
constexpr int kMostSamples = 3000;

// Times at which a clip is looked at, s.
std::vector<double> looks_at(const Clip& clip) {
    const int intervals = std::clamp(int(std::ceil(clip.seconds * kRate)), 1, kMostSamples);
    std::vector<double> times;
    for (int i = 0; i <= intervals; ++i) times.push_back(clip.seconds * i / intervals);
    return times;
}

// Between the first and the last time; linear.
double value_at(const std::vector<double>& times, const std::vector<double>& values, double t) {
    const auto after = std::ranges::upper_bound(times, t);
    if (after == times.begin()) return values.front();
    if (after == times.end()) return values.back();
    const auto k = std::size_t(after - times.begin());
    const double share = (t - times[k - 1]) / (times[k] - times[k - 1]);
    return (1 - share) * values[k - 1] + share * values[k];
}

// Lifts the root bones of a clip, m in our frame at those times (s).
void lift(const Body& body, const std::vector<double>& times, const std::vector<double>& lifts, Clip& clip) {
    for (std::size_t i = 0; i < body.bones.size(); ++i) {
        if (body.bones[i].parent >= 0) continue;
        auto track = std::ranges::find(clip.tracks, int(i), &Track::bone);
        if (track == clip.tracks.end()) track = clip.tracks.insert(track, Track{.bone = int(i)});
        Keys<Vec3d>& keys = track->translation;
        if (keys.times.size() < 2) {
            const Vec3d place = keys.values.empty() ? body.bones[i].rest.translation : keys.values.front();
            keys = {times, std::vector<Vec3d>(times.size(), place)};
        }
        for (std::size_t k = 0; k < keys.times.size(); ++k)
            keys.values[k] += in_root_frame(body, Vec3d(0, value_at(times, lifts, keys.times[k]), 0));
    }
}

}  // namespace

double lowest_point(const Body& body, const Pose& pose) {
    std::vector<Vec3f> x;
    SkinnedSurface(body).positions(body, pose, x);
    return lowest_of(x);
}

double lowest_point(const Body& body, const Clip& clip) {
    const SkinnedSurface surface(body);
    std::vector<Vec3f> x;
    double lowest = std::numeric_limits<double>::infinity();
    for (const double t : looks_at(clip)) {
        surface.positions(body, sample(body, clip, t), x);
        lowest = std::min(lowest, lowest_of(x));
    }
    return lowest;
}

double stand_on_floor(const Body& body, Pose& pose) {
    const double lift = -lowest_point(body, pose);
    shift(body, pose, Vec3d(0, lift, 0));
    return lift;
}

double stand_on_floor(const Body& body, Clip& clip) {
    const double up = -lowest_point(body, clip);
    lift(body, {0}, {up}, clip);
    return up;
}

void keep_on_floor(const Body& body, Clip& clip) {
    constexpr double kLower = 0.1;  // share of the time
    const Soles soles(body, find_joints(body.bones));
    if (soles.empty()) {
        stand_on_floor(body, clip);
        return;
    }
    const SkinnedSurface surface(body);
    const std::vector<double> times = looks_at(clip);
    std::vector<double> lowest, feet;
    std::vector<Vec3f> x;
    for (const double t : times) {
        const Pose pose = sample(body, clip, t);
        surface.positions(body, pose, x);
        lowest.push_back(lowest_of(x));
        feet.push_back(soles.height(bone_frames(body, pose)));
    }
    const auto standing = feet.begin() + std::ptrdiff_t(kLower * double(feet.size() - 1));
    std::ranges::nth_element(feet, standing);
    const double up = -*standing - lowest_point(body, rest_pose(body));
    std::vector<double> lifts;
    for (const double height : lowest) lifts.push_back(std::max(up, -height));
    lift(body, times, lifts, clip);
}

Vec3d hips_of(const Body& body, const Pose& pose) {
    const int hips = std::max(0, find_joints(body.bones)[Joint::Hips]);
    return bone_frames(body, pose)[static_cast<std::size_t>(hips)].translation();
}

Vec3d way_over_floor(const Body& body, const Pose& from, const Pose& to) {
    const Vec3d way = hips_of(body, to) - hips_of(body, from);
    return {way.x(), 0, way.z()};
}

Pose blend_on_floor(const Body& body, const Pose& a, const Pose& b, double share) {
    Pose pose = blend(a, b, share);
    const Soles soles(body, find_joints(body.bones));
    if (soles.empty()) return pose;
    const auto height = [&](const Pose& of) { return soles.height(bone_frames(body, of)); };
    shift(body, pose, Vec3d(0, (1 - share) * height(a) + share * height(b) - height(pose), 0));
    return pose;
}

void shift(const Body& body, Pose& pose, const Vec3d& by) {
    const Vec3d way = in_root_frame(body, by);
    for (std::size_t i = 0; i < pose.bones.size(); ++i)
        if (body.bones[i].parent < 0) pose.bones[i].translation += way;
}

}  // namespace selvedge::sim
