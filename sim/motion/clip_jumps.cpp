#include "sim/motion/clip_jumps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <optional>

#include "sim/body/joint_names.h"

namespace selvedge::sim {
namespace {

// m/s, of a joint between two frames. Hands and feet reach 10 m/s in a punch (Whiting, Gregor, Finerman
// 1988: 9 m/s) and more in a kick, but their neighbouring frames are fast too. At 10 Hz a jump looks slower; beside a
// pose that is held at an end of the clip, a lower speed is none of a person.
constexpr double kJumpSpeed = 10, kJumpSpeedAtEnd = 4;
constexpr double kNoPerson = 25;  // m/s: the wrist of who pitches a ball at 40 m/s; faster ones jump whatever is around
constexpr double kTimesNeighbours = 5;  // as fast as the same joint is in the median of the intervals around
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

// How far what a turn moves gets at a hand's length, m.
double swing_of(double turn) {
    constexpr double kReach = 0.19;  // m, of a hand beyond its wrist
    return kReach * 2 * std::sin(turn / 2);
}

// A bone that is looked at.
struct WatchedBone {
    std::size_t bone = 0;
    std::optional<Joint> joint;  // none: the skeleton is not known by its names
};

// The joints of a person, or all bones where none is known.
std::vector<WatchedBone> watched_bones(const Body& skeleton, const JointBones& joints) {
    std::vector<WatchedBone> watched;
    for (std::size_t i = 0; i < kJointCount; ++i)
        if (joints.bone[i] >= 0) watched.push_back({static_cast<std::size_t>(joints.bone[i]), Joint(i)});
    for (std::size_t i = 0; watched.empty() && i < skeleton.bones.size(); ++i) watched.push_back({i, std::nullopt});
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

// What a bone does between each time and the next one.
struct Steps {
    std::vector<double> ways;   // of its joint, m
    std::vector<double> turns;  // rad
};

// metres: per unit of the skeleton.
std::vector<Steps> steps_between(const Body& skeleton, const Clip& clip, const std::vector<WatchedBone>& watched,
                                 const std::vector<double>& times, double metres) {
    std::vector<Steps> steps(watched.size());
    std::vector<Eigen::Affine3d> before;
    for (const double t : times) {
        std::vector<Eigen::Affine3d> frames = bone_frames(skeleton, sample(skeleton, clip, t));
        for (std::size_t i = 0; i < watched.size() && !before.empty(); ++i) {
            const Eigen::Affine3d &now = frames[watched[i].bone], &then = before[watched[i].bone];
            steps[i].ways.push_back(metres * (now.translation() - then.translation()).norm());
            steps[i].turns.push_back(rotation_of(now).angularDistance(rotation_of(then)));
        }
        before = std::move(frames);
    }
    return steps;
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

// How far a bone turns and how far it goes between two times, to its parent.
struct LocalStep {
    double turn = 0;  // rad
    double way = 0;   // in the skeleton's unit
};

LocalStep local_step(const Pose& a, const Pose& b, std::size_t bone) {
    return {.turn = a.bones[bone].rotation.angularDistance(b.bones[bone].rotation),
            .way = (a.bones[bone].translation - b.bones[bone].translation).norm()};
}

double middle_of(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

// Of each track whether its bone takes part in the jump: it goes or turns to its parent farther than in the frames
// around.
std::vector<bool> jumping_tracks(const Body& skeleton, const Clip& clip, const ClipJump& jump) {
    constexpr double kTimes = 3, kLeastTurn = 0.03, kLeastShift = 1e-3;  // rad; of the bone's place to its parent
    constexpr int kFrames = 4;                                           // before and after
    const double frame = jump.to - jump.from;
    std::vector<Pose> poses;
    for (int k = -kFrames; k <= kFrames + 1; ++k) poses.push_back(sample(skeleton, clip, jump.from + k * frame));
    std::vector<bool> jumping;
    for (const Track& track : clip.tracks) {
        const auto bone = static_cast<std::size_t>(track.bone);
        std::vector<double> turns, ways;
        LocalStep at_jump;
        for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
            const LocalStep step = local_step(poses[k], poses[k + 1], bone);
            if (k == kFrames) at_jump = step;
            if (k == kFrames) continue;
            turns.push_back(step.turn);
            ways.push_back(step.way);
        }
        const double place = poses[kFrames].bones[bone].translation.norm();
        jumping.push_back((at_jump.turn > kLeastTurn && at_jump.turn > kTimes * middle_of(turns)) ||
                          (at_jump.way > kLeastShift * place && at_jump.way > kTimes * middle_of(ways)));
    }
    return jumping;
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
double blend_over(const Body& skeleton, const ClipJump& jump, bool all_bones, Clip& clip) {
    const double way = std::max(jump.way, swing_of(jump.turn));
    const double seconds = std::min(std::max(kLeastBlend, way / kBlendSpeed), clip.seconds - jump.from);
    const Pose before = sample(skeleton, clip, jump.from);
    const std::vector<bool> jumping = jumping_tracks(skeleton, clip, jump);
    std::vector<Track> tracks;
    for (std::size_t i = 0; i < clip.tracks.size(); ++i)
        tracks.push_back(all_bones || jumping[i]
                             ? blended(skeleton, clip, clip.tracks[i], before, jump.from, jump.from + seconds)
                             : clip.tracks[i]);
    clip.tracks = std::move(tracks);
    return seconds;
}

std::string jump_text(const ClipJump& jump) {
    constexpr double kDegrees = 180 / std::numbers::pi;
    std::array<char, 48> text{};
    if (jump.way > 0)
        std::snprintf(text.data(), text.size(), "the motion jumps by %.2f m", jump.way);
    else
        std::snprintf(text.data(), text.size(), "a joint turns by %.0f degrees in a frame", kDegrees * jump.turn);
    return text.data();
}

std::string places_text(const ClipJump& first, std::size_t count) {
    std::string text = jump_text(first) + " at " + moment_text(first.to);
    if (count > 1) text += " and at " + std::to_string(count - 1) + " more places";
    return text;
}

// Blends over those of the jumps that are between two times. Blends of jumps that are near each other change what the
// next one jumps to: they are looked for again, and then whole poses blended.
void blend_jumps(const Body& skeleton, std::vector<ClipJump> jumps, double from, double to, Clip& clip) {
    constexpr int kMostPasses = 4;
    const auto leave_out = [&] {
        std::erase_if(jumps, [&](const ClipJump& jump) { return jump.to <= from || jump.from >= to; });
    };
    leave_out();
    if (jumps.empty()) return;
    const ClipJump first = jumps.front();
    const std::size_t count = jumps.size();
    double seconds = 0;
    for (int pass = 0; pass < kMostPasses && !jumps.empty(); ++pass) {
        for (const ClipJump& jump : jumps) seconds = std::max(seconds, blend_over(skeleton, jump, pass > 0, clip));
        jumps = find_jumps(skeleton, clip);
        leave_out();
    }
    clip.notes.push_back(places_text(first, count) + ": blended over " + moment_text(seconds));
    if (!jumps.empty()) clip.notes.push_back("still " + places_text(jumps.front(), jumps.size()));
}

// What jumps between two times: whether joints of both sides or of the middle do, and how far.
struct JumpingJoints {
    ClipJump jump;
    bool has_left = false, has_right = false, has_middle = false;

    void add_way(const std::optional<Joint>& joint, double way) {
        jump.way = std::max(jump.way, way);
        has_middle = has_middle || !joint || mirrored(*joint) == *joint;
        has_left = has_left || (joint && mirrored(*joint) > *joint);
        has_right = has_right || (joint && mirrored(*joint) < *joint);
    }
    void add_turn(double turn) { jump.turn = std::max(jump.turn, turn); }
    bool is_any() const { return jump.way > 0 || jump.turn > 0; }
    ClipJump result() const {
        ClipJump all = jump;
        all.is_whole = has_middle || (has_left && has_right);
        return all;
    }
};

}  // namespace

std::vector<ClipJump> find_jumps(const Body& skeleton, const Clip& clip) {
    std::vector<ClipJump> jumps;
    if (clip.is_loop) return jumps;
    const std::vector<double> times = frame_times(clip);
    if (times.size() < 3) return jumps;
    const JointBones joints = find_joints(skeleton.bones);
    const std::vector<WatchedBone> watched = watched_bones(skeleton, joints);
    const std::vector<Steps> steps = steps_between(skeleton, clip, watched, times, metres_per_unit(skeleton, joints));
    const std::size_t intervals = times.size() - 1;
    // m/s: of the joints, and of what they turn at a hand's length
    std::vector<std::vector<double>> speeds(watched.size()), turning(watched.size());
    std::vector<double> fastest(intervals, 0.0);
    for (std::size_t k = 0; k < intervals; ++k) {
        const double seconds = times[k + 1] - times[k];
        for (std::size_t i = 0; i < watched.size(); ++i) {
            speeds[i].push_back(steps[i].ways[k] / seconds);
            turning[i].push_back(swing_of(steps[i].turns[k]) / seconds);
            fastest[k] = std::max(fastest[k], speeds[i][k]);
        }
    }
    for (std::size_t k = 0; k < intervals; ++k) {
        if (times[k + 1] - times[k] >= kLongestFrame) continue;
        const double least = is_beside_held_pose(fastest, times, k) ? kJumpSpeedAtEnd : kJumpSpeed;
        const auto is_jump = [&](const std::vector<double>& of_bone, double way) {
            return of_bone[k] > least && way > kLeastWay &&
                   (of_bone[k] > kNoPerson || of_bone[k] > kTimesNeighbours * median_around(of_bone, times, k));
        };
        JumpingJoints jumping{.jump = {.from = times[k], .to = times[k + 1]}};
        for (std::size_t i = 0; i < watched.size(); ++i) {
            if (is_jump(speeds[i], steps[i].ways[k])) jumping.add_way(watched[i].joint, steps[i].ways[k]);
            if (is_jump(turning[i], swing_of(steps[i].turns[k]))) jumping.add_turn(steps[i].turns[k]);
        }
        if (jumping.is_any()) jumps.push_back(jumping.result());
    }
    return jumps;
}

void mend_jumps(const Body& skeleton, Clip& clip) {
    std::vector<ClipJump> within;
    double from = 0, to = clip.seconds;
    for (const ClipJump& jump : find_jumps(skeleton, clip)) {
        if (!jump.is_whole) {
            within.push_back(jump);
        } else if (jump.to <= kEndSeconds && clip.seconds - jump.to > kEndSeconds) {
            from = jump.to;
            clip.notes.push_back(jump_text(jump) + " from a pose at its start: its first " + moment_text(jump.to) +
                                 " are left out");
        } else if (clip.seconds - jump.from <= kEndSeconds && jump.from > kEndSeconds) {
            if (to == clip.seconds)
                clip.notes.push_back(jump_text(jump) + " to a pose at its end: its last " +
                                     moment_text(clip.seconds - jump.from) + " are left out");
            to = std::min(to, jump.from);
        } else {
            within.push_back(jump);
        }
    }
    blend_jumps(skeleton, std::move(within), from, to, clip);
    if (from > 0 || to < clip.seconds) clip = part_of(clip, from, to);
}

std::string moment_text(double seconds) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f s", seconds);
    return text.data();
}

}  // namespace selvedge::sim
