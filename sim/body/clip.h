#pragma once
// Animation clips: keys over time for the rotation, translation and scale of bones, each with times of its own.
#include <string>
#include <utility>
#include <vector>

#include "sim/body/pose.h"

namespace selvedge::sim {

// Values at ascending times; before the first and after the last time, these hold.
template <class Value>
struct Keys {
    std::vector<double> times;  // s
    std::vector<Value> values;  // as many
};

// Local transforms of one bone. What has no keys stays as in the rest pose.
struct Track {
    int bone = 0;
    Keys<Eigen::Quaterniond> rotation = {};
    Keys<Vec3d> translation = {};
    Keys<Vec3d> scale = {};
};

struct Clip {
    std::string name;
    double seconds = 0;
    std::vector<Track> tracks = {};       // at most one per bone
    bool is_loop = false;                 // its end continues at its start, `travel` farther
    int travel_bone = -1;                 // the bone that is moved by `travel` with each loop; -1: none
    Vec3d travel = Vec3d::Zero();         // in the frame of that bone's parent
    std::vector<std::string> notes = {};  // what of it is not as in its file, and why
};

// The pose at time t (s): linear between keys, rotations along the shorter arc. Times outside the clip give its first
// or last pose, but for a loop, which continues. Pre: the tracks name bones of the body.
Pose sample(const Body& body, const Clip& clip, double t);

// The clip between two of its times, which becomes [0, to - from]. Pre: 0 <= from < to; it is no loop.
Clip part_of(const Clip& clip, double from, double to);

// Seconds and keys that a clip may have: an hour of motion at 120 Hz for each of 60 joints is 26 million keys and
// more than a gigabyte; a tenth of that is ample.
struct ClipLimits {
    double seconds = 3600;
    std::size_t keys = 4'000'000;
};

// Throws InputError(file, "clip 'walk', bone 'Hips', rotation key 3", ...) if a number is not finite, a time is
// negative or earlier than the one before, a rotation has no length, a scale is 0, a track names no bone, or the clip
// exceeds the limits.
void check_clip(const Clip& clip, const std::vector<Bone>& bones, const std::string& file,
                const ClipLimits& limits = {});

// The clip that is called `name` or, if none is, the one with that number (from 0). If the name is empty, the first
// that moves, for files begin with clips of one pose, or else the first. A clip called "Armature|walk" is also called
// "walk". Throws InputError that lists the clips.
const Clip& find_clip(const std::vector<Clip>& clips, const std::string& name, const std::string& file);

// "the file has 3 motions: 'idle' is played, and not 'walk', 'run'", where nobody chose. Pre: there are two or more.
std::string choice_text(const std::vector<Clip>& clips);

// "walk.bvh#2" as a path and the name of a clip, which is empty when there is none.
std::pair<std::string, std::string> split_clip_name(const std::string& text);

// A clip that leads from pose a to pose b within that time, starting and ending at rest.
Clip transition(const Pose& a, const Pose& b, double seconds, std::string name);

}  // namespace selvedge::sim
