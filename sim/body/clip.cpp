#include "sim/body/clip.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

// The last key at or before t and how far t is to the next one, 0..1.
struct Interval {
    std::size_t from = 0;
    std::size_t to = 0;
    double share = 0;
};

Interval interval_at(const std::vector<double>& times, double t) {
    const auto after = std::ranges::upper_bound(times, t);
    if (after == times.begin()) return {};
    const std::size_t to = std::size_t(after - times.begin());
    if (to == times.size()) return {.from = to - 1, .to = to - 1};
    return {.from = to - 1, .to = to, .share = (t - times[to - 1]) / (times[to] - times[to - 1])};
}

Vec3d value_at(const Keys<Vec3d>& keys, double t) {
    const Interval at = interval_at(keys.times, t);
    return keys.values[at.from] + at.share * (keys.values[at.to] - keys.values[at.from]);
}

Eigen::Quaterniond value_at(const Keys<Eigen::Quaterniond>& keys, double t) {
    const Interval at = interval_at(keys.times, t);
    return keys.values[at.from].slerp(at.share, keys.values[at.to]);
}

}  // namespace

Pose sample(const Body& body, const Clip& clip, double t) {
    double loops = 0;
    if (clip.is_loop && clip.seconds > 0) {
        loops = std::floor(t / clip.seconds);
        t -= loops * clip.seconds;
    }
    Pose pose = rest_pose(body);
    for (const Track& track : clip.tracks) {
        Transform& bone = pose.bones[std::size_t(track.bone)];
        if (!track.rotation.times.empty()) bone.rotation = value_at(track.rotation, t);
        if (!track.translation.times.empty()) bone.translation = value_at(track.translation, t);
        if (!track.scale.times.empty()) bone.scale = value_at(track.scale, t);
    }
    if (clip.travel_bone >= 0) pose.bones[std::size_t(clip.travel_bone)].translation += loops * clip.travel;
    return pose;
}

namespace {

template <class Value>
Keys<Value> part_of_keys(const Keys<Value>& keys, double from, double to) {
    if (keys.times.size() < 2) return keys;
    Keys<Value> part{{0.0}, {value_at(keys, from)}};
    for (std::size_t k = 0; k < keys.times.size(); ++k) {
        if (keys.times[k] <= from || keys.times[k] >= to) continue;
        part.times.push_back(keys.times[k] - from);
        part.values.push_back(keys.values[k]);
    }
    part.times.push_back(to - from);
    part.values.push_back(value_at(keys, to));
    return part;
}

}  // namespace

Clip part_of(const Clip& clip, double from, double to) {
    Clip part{.name = clip.name, .seconds = to - from, .notes = clip.notes};
    for (const Track& track : clip.tracks)
        part.tracks.push_back({.bone = track.bone,
                               .rotation = part_of_keys(track.rotation, from, to),
                               .translation = part_of_keys(track.translation, from, to),
                               .scale = part_of_keys(track.scale, from, to)});
    return part;
}

namespace {

bool is_sound(const Vec3d& value) {
    constexpr double kLargest = 1e6;  // admits a path of 1 km in mm
    return value.allFinite() && value.cwiseAbs().maxCoeff() <= kLargest;
}

bool is_sound(const Eigen::Quaterniond& value) {
    return value.coeffs().allFinite() && std::abs(value.norm() - 1) < 1e-3;
}

bool has_volume(const Vec3d& scale) {
    return scale.cwiseAbs().minCoeff() > 1e-6;
}

template <class Value>
void check_keys(const Keys<Value>& keys, const std::string& file, const std::string& place) {
    const auto fail = [&](std::size_t key, const char* problem) {
        throw InputError(file, place + " key " + std::to_string(key), problem);
    };
    for (std::size_t k = 0; k < keys.times.size(); ++k) {
        if (!std::isfinite(keys.times[k])) fail(k, "its time is not a number");
        if (keys.times[k] < 0) fail(k, "its time is negative");
        if (k > 0 && keys.times[k] < keys.times[k - 1]) fail(k, "its time is before that of the key before it");
        if (!is_sound(keys.values[k])) fail(k, "its value is not a reasonable number");
    }
}

}  // namespace

void check_clip(const Clip& clip, const std::vector<Bone>& bones, const std::string& file, const ClipLimits& limits) {
    const std::string place = "clip '" + clip.name + "'";
    if (!std::isfinite(clip.seconds) || clip.seconds < 0) throw InputError(file, place, "its length is not a time");
    if (clip.seconds > limits.seconds)
        throw InputError(file, place, "it is longer than " + std::to_string(int(limits.seconds)) + " s");
    std::size_t keys = 0;
    for (const Track& track : clip.tracks) {
        if (track.bone < 0 || track.bone >= int(bones.size()))
            throw InputError(file, place, "a track names a bone that is not there");
        keys += track.rotation.times.size() + track.translation.times.size() + track.scale.times.size();
        if (keys > limits.keys)
            throw InputError(file, place, "it has more than " + std::to_string(limits.keys) + " keys");
        const std::string bone = place + ", bone '" + bones[std::size_t(track.bone)].name + "', ";
        check_keys(track.rotation, file, bone + "rotation");
        check_keys(track.translation, file, bone + "translation");
        check_keys(track.scale, file, bone + "scale");
        for (std::size_t k = 0; k < track.scale.values.size(); ++k)
            if (!has_volume(track.scale.values[k]))
                throw InputError(file, bone + "scale key " + std::to_string(k), "its scale is 0");
    }
}

namespace {

// "walk" of "Armature|walk".
std::string short_name(const std::string& name) {
    const std::size_t bar = name.rfind('|');
    return bar == std::string::npos ? name : name.substr(bar + 1);
}

std::string list_of(const std::vector<Clip>& clips) {
    constexpr std::size_t kMost = 20;
    std::string list;
    for (std::size_t i = 0; i < std::min(clips.size(), kMost); ++i)
        list += (i == 0 ? "" : ", ") + std::to_string(i) + " '" + clips[i].name + "'";
    return clips.size() > kMost ? list + " ..." : list;
}

template <class Value>
bool is_moving(const Keys<Value>& keys) {
    constexpr double kRounding = 1e-6;  // of a pose that is written at each frame
    return std::ranges::any_of(keys.values,
                               [&](const Value& value) { return !value.isApprox(keys.values.front(), kRounding); });
}

bool is_moving(const Clip& clip) {
    return std::ranges::any_of(clip.tracks, [](const Track& track) {
        return is_moving(track.rotation) || is_moving(track.translation) || is_moving(track.scale);
    });
}

// Which one is played if nobody chooses: the first that moves. Pre: there is one.
std::size_t index_of_default(const std::vector<Clip>& clips) {
    const auto moving = std::ranges::find_if(clips, [](const Clip& clip) { return is_moving(clip); });
    return moving == clips.end() ? 0 : std::size_t(moving - clips.begin());
}

}  // namespace

const Clip& find_clip(const std::vector<Clip>& clips, const std::string& name, const std::string& file) {
    if (clips.empty()) throw InputError(file, "", "it holds no animation");
    if (name.empty()) return clips[index_of_default(clips)];
    for (const Clip& clip : clips)
        if (clip.name == name) return clip;
    for (const Clip& clip : clips)
        if (short_name(clip.name) == name) return clip;
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
    if (error == std::errc() && end == name.data() + name.size() && index < clips.size()) return clips[index];
    throw InputError(file, "clip '" + name + "'", "not there; the clips are " + list_of(clips));
}

std::string choice_text(const std::vector<Clip>& clips) {
    constexpr std::size_t kMost = 10;
    const std::size_t played = index_of_default(clips);
    std::string others;
    std::size_t count = 0;
    for (std::size_t i = 0; i < clips.size(); ++i)
        if (i != played && ++count <= kMost) others += (others.empty() ? "'" : ", '") + clips[i].name + "'";
    if (count > kMost) others += " ...";
    return "the file has " + std::to_string(clips.size()) + " motions: '" + clips[played].name +
           "' is played, and not " + others;
}

std::pair<std::string, std::string> split_clip_name(const std::string& text) {
    const std::size_t mark = text.rfind('#');
    if (mark == std::string::npos || text.find('/', mark) != std::string::npos) return {text, ""};
    return {text.substr(0, mark), text.substr(mark + 1)};
}

Clip transition(const Pose& a, const Pose& b, double seconds, std::string name) {
    constexpr int kSteps = 30;  // straight pieces of the smooth course
    Clip clip{.name = std::move(name), .seconds = seconds};
    for (std::size_t i = 0; i < a.bones.size(); ++i) {
        Track track{.bone = int(i)};
        for (int step = 0; step <= kSteps; ++step) {
            const double u = double(step) / kSteps;
            const Transform at = blend(a.bones[i], b.bones[i], smoothstep(u, 0, 1));
            const double t = u * seconds;
            track.rotation.times.push_back(t);
            track.rotation.values.push_back(at.rotation);
            track.translation.times.push_back(t);
            track.translation.values.push_back(at.translation);
        }
        clip.tracks.push_back(std::move(track));
    }
    return clip;
}

}  // namespace selvedge::sim
