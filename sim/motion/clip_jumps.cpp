#include "sim/motion/clip_jumps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

#include "sim/body/joint_names.h"

namespace selvedge::sim {
namespace {

// m/s, of the fastest joint between two frames. Hands and feet reach 10 m/s in a punch (Whiting, Gregor, Finerman
// 1988: 9 m/s) and more in a kick, but their neighbouring frames are fast too. At 10 Hz a jump looks slower; beside a
// pose that is held at an end of the clip, a lower speed is none of a person.
constexpr double kJumpSpeed = 10, kJumpSpeedAtEnd = 4;
constexpr double kTimesNeighbours = 5;  // as fast as the median of the intervals around
constexpr double kAround = 0.1;         // s, before and after
constexpr std::size_t kLeastAround = 2;
constexpr double kLeastWay = 0.05;      // m
constexpr double kLongestFrame = 0.11;  // s: keys that are farther apart are a motion, not two frames
constexpr double kEndSeconds = 0.5;     // what is left out at most
constexpr double kBlendSpeed = 3;       // m/s, on average over a blend: of an arm that swings
constexpr double kLeastBlend = 0.3;     // s
constexpr double kApart = 1e-4;         // s: nearer keys are of one frame

std::vector<double> frame_times(const Clip& clip) {
    std::vector<double> all{0}, times;
    for (const Track& track : clip.tracks)
        for (const std::vector<double>* keys : {&track.rotation.times, &track.translation.times})
            all.insert(all.end(), keys->begin(), keys->end());
    std::ranges::sort(all);
    for (const double t : all)
        if (t <= clip.seconds && (times.empty() || t - times.back() > kApart)) times.push_back(t);
    return times;
}

// The bones that are looked at: the joints of a person, or all where none is known.
std::vector<std::size_t> watched_bones(const Body& skeleton, const JointBones& joints) {
    std::vector<std::size_t> watched;
    for (const int bone : joints.bone)
        if (bone >= 0) watched.push_back(static_cast<std::size_t>(bone));
    for (std::size_t i = 0; watched.empty() && i < skeleton.bones.size(); ++i) watched.push_back(i);
    return watched;
}

// m per unit of the skeleton, if its person is of average size; 0 where nothing is known of it.
double metres_per_unit(const Body& skeleton, const JointBones& joints) {
    constexpr double kLeg = 0.85, kTrunk = 0.6;  // m, from hip to ankle and from the hips to the head
    const std::vector<Eigen::Affine3d> frames = bone_frames(skeleton, rest_pose(skeleton));
    const auto length = [&](std::initializer_list<Joint> chain) {
        double sum = 0;
        const Joint* before = nullptr;
        for (const Joint& joint : chain) {
            if (!joints.has(joint)) return 0.0;
            if (before != nullptr)
                sum += (frames[static_cast<std::size_t>(joints[joint])].translation() -
                        frames[static_cast<std::size_t>(joints[*before])].translation())
                           .norm();
            before = &joint;
        }
        return sum;
    };
    if (const double leg = length({Joint::LeftUpperLeg, Joint::LeftLowerLeg, Joint::LeftFoot}); leg > 0)
        return kLeg / leg;
    if (const double leg = length({Joint::RightUpperLeg, Joint::RightLowerLeg, Joint::RightFoot}); leg > 0)
        return kLeg / leg;
    const double trunk = length({Joint::Hips, Joint::Head});
    return trunk > 0 ? kTrunk / trunk : 0;
}

// Between each time and the next one, m.
std::vector<double> ways_between(const Body& skeleton, const Clip& clip, const std::vector<double>& times) {
    const JointBones joints = find_joints(skeleton.bones);
    const double metres = metres_per_unit(skeleton, joints);
    const std::vector<std::size_t> watched = watched_bones(skeleton, joints);
    std::vector<double> ways;
    std::vector<Eigen::Affine3d> before;
    for (const double t : times) {
        std::vector<Eigen::Affine3d> frames = bone_frames(skeleton, sample(skeleton, clip, t));
        double way = 0;
        for (const std::size_t bone : watched)
            if (!before.empty()) way = std::max(way, (frames[bone].translation() - before[bone].translation()).norm());
        if (!before.empty()) ways.push_back(metres * way);
        before = std::move(frames);
    }
    return ways;
}

double median_around(const std::vector<double>& speeds, const std::vector<double>& times, std::size_t k) {
    std::vector<double> around;
    const auto is_near = [&](std::size_t i, std::size_t steps) {
        return steps <= kLeastAround || std::abs(times[i] - times[k]) <= kAround;
    };
    for (std::size_t i = k; i > 0 && is_near(i - 1, k - i + 1); --i) around.push_back(speeds[i - 1]);
    for (std::size_t i = k + 1; i < speeds.size() && is_near(i, i - k); ++i) around.push_back(speeds[i]);
    if (around.empty()) return 0;
    const auto middle = around.begin() + std::ptrdiff_t(around.size() / 2);
    std::ranges::nth_element(around, middle);
    return *middle;
}

// Whether a clip only holds a pose before interval k, at its start, or after it, at its end.
bool is_beside_held_pose(const std::vector<double>& speeds, const std::vector<double>& times, std::size_t k) {
    constexpr double kStill = 0.1;  // m/s
    const auto is_still = [&](double speed) { return speed < kStill; };
    const auto at = speeds.begin() + std::ptrdiff_t(k);
    return (times[k] - times.front() <= kEndSeconds && std::all_of(speeds.begin(), at, is_still)) ||
           (times.back() - times[k + 1] <= kEndSeconds && std::all_of(at + 1, speeds.end(), is_still));
}

// The track with the pose before going over into it between two times.
Track blended(const Body& skeleton, const Clip& clip, const Track& track, const Pose& before, double from, double to) {
    constexpr double kStep = 1.0 / 60;  // s
    std::vector<double> times;
    const int steps = std::max(1, int(std::ceil((to - from) / kStep)));
    for (int i = 0; i <= steps; ++i) times.push_back(from + (to - from) * i / steps);
    const auto bone = static_cast<std::size_t>(track.bone);
    const auto mend = [&](auto& keys, const auto& value_of) {
        if (keys.times.size() < 2) return;
        std::remove_reference_t<decltype(keys)> mended;
        const auto add = [&](double t, const auto& value) {
            mended.times.push_back(t);
            mended.values.push_back(value);
        };
        for (std::size_t k = 0; k < keys.times.size() && keys.times[k] < from; ++k) add(keys.times[k], keys.values[k]);
        for (const double t : times)
            add(t, value_of(blend(before.bones[bone], sample(skeleton, clip, t).bones[bone],
                                  smoothstep((t - from) / (to - from), 0, 1))));
        for (std::size_t k = 0; k < keys.times.size(); ++k)
            if (keys.times[k] > to) add(keys.times[k], keys.values[k]);
        keys = std::move(mended);
    };
    Track result = track;
    mend(result.rotation, [](const Transform& transform) { return transform.rotation; });
    mend(result.translation, [](const Transform& transform) { return transform.translation; });
    mend(result.scale, [](const Transform& transform) { return transform.scale; });
    return result;
}

// Returns the seconds that it takes.
double blend_over(const Body& skeleton, const ClipJump& jump, Clip& clip) {
    const double seconds = std::min(std::max(kLeastBlend, jump.way / kBlendSpeed), clip.seconds - jump.from);
    const Pose before = sample(skeleton, clip, jump.from);
    std::vector<Track> tracks;
    for (const Track& track : clip.tracks)
        tracks.push_back(blended(skeleton, clip, track, before, jump.from, jump.from + seconds));
    clip.tracks = std::move(tracks);
    return seconds;
}

std::string jump_text(const ClipJump& jump) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "jumps by %.2f m", jump.way);
    return text.data();
}

void note_blends(const std::vector<ClipJump>& jumps, double seconds, Clip& clip) {
    if (jumps.empty()) return;
    std::string note = "the motion " + jump_text(jumps.front()) + " at " + moment_text(jumps.front().to);
    if (jumps.size() > 1) note += " and at " + std::to_string(jumps.size() - 1) + " more places";
    clip.notes.push_back(note + ": blended over " + moment_text(seconds));
}

}  // namespace

std::vector<ClipJump> find_jumps(const Body& skeleton, const Clip& clip) {
    std::vector<ClipJump> jumps;
    if (clip.is_loop) return jumps;
    const std::vector<double> times = frame_times(clip);
    const std::vector<double> ways = ways_between(skeleton, clip, times);
    std::vector<double> speeds;
    for (std::size_t k = 0; k < ways.size(); ++k) speeds.push_back(ways[k] / (times[k + 1] - times[k]));
    for (std::size_t k = 0; k < speeds.size(); ++k) {
        const double least = is_beside_held_pose(speeds, times, k) ? kJumpSpeedAtEnd : kJumpSpeed;
        if (speeds[k] > least && ways[k] > kLeastWay && times[k + 1] - times[k] < kLongestFrame && speeds.size() > 1 &&
            speeds[k] > kTimesNeighbours * median_around(speeds, times, k))
            jumps.push_back({times[k], times[k + 1], ways[k]});
    }
    return jumps;
}

void mend_jumps(const Body& skeleton, Clip& clip) {
    std::vector<ClipJump> within;
    double from = 0, to = clip.seconds;
    for (const ClipJump& jump : find_jumps(skeleton, clip)) {
        if (jump.to <= kEndSeconds && clip.seconds - jump.to > kEndSeconds) {
            from = jump.to;
            clip.notes.push_back("the motion " + jump_text(jump) + " from a pose at its start: its first " +
                                 moment_text(jump.to) + " are left out");
        } else if (clip.seconds - jump.from <= kEndSeconds && jump.from > kEndSeconds) {
            if (to == clip.seconds)
                clip.notes.push_back("the motion " + jump_text(jump) + " to a pose at its end: its last " +
                                     moment_text(clip.seconds - jump.from) + " are left out");
            to = std::min(to, jump.from);
        } else {
            within.push_back(jump);
        }
    }
    double seconds = 0;
    for (const ClipJump& jump : within) seconds = std::max(seconds, blend_over(skeleton, jump, clip));
    note_blends(within, seconds, clip);
    if (from > 0 || to < clip.seconds) clip = part_of(clip, from, to);
}

std::string moment_text(double seconds) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f s", seconds);
    return text.data();
}

}  // namespace selvedge::sim
