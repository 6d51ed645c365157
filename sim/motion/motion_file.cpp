#include "sim/motion/motion_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "sim/body/joint_names.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_extension.h"
#include "sim/core/json.h"
#include "sim/motion/clear_arms.h"
#include "sim/motion/clip_jumps.h"
#include "sim/motion/grounding.h"
#include "sim/motion/joint_angles.h"
#include "sim/motion/retarget.h"
#include "sim/motion/standing_rest.h"

namespace selvedge::sim {

std::span<const EmbeddedFile> motion_files();

namespace {

constexpr double kMostSeconds = 600;
constexpr std::size_t kMostKeys = 10'000;
constexpr double kMostDegrees = 7200;  // twenty turns
constexpr double kMostLegs = 1000;     // leg lengths that the hips may be away
constexpr double kSampleStep = 1.0 / 60;

// A value over the times of the file's keys.
class Course {
 public:
    // Slopes are the weighted harmonic mean of those of both sides, 0 at extrema. (Fritsch and Butland 1984)
    Course(const std::vector<double>& times, std::vector<double> values, bool is_loop)
        : times_(&times), values_(std::move(values)), slopes_(times.size(), 0.0) {
        const std::size_t last = times.size() - 1;
        for (std::size_t k = 1; k < last; ++k) slopes_[k] = slope_between(k - 1, k);
        if (is_loop && last > 0) slopes_[0] = slopes_[last] = slope_between(last - 1, 0);
    }

    double at(std::size_t interval, double share) const {
        const double h = length(interval), t = share;
        return (1 + 2 * t) * (1 - t) * (1 - t) * values_[interval] + t * (1 - t) * (1 - t) * h * slopes_[interval] +
               t * t * (3 - 2 * t) * values_[interval + 1] + t * t * (t - 1) * h * slopes_[interval + 1];
    }
    double first() const { return values_.front(); }
    double last() const { return values_.back(); }

 private:
    double length(std::size_t interval) const { return (*times_)[interval + 1] - (*times_)[interval]; }

    // At the key that ends interval a and starts interval b.
    double slope_between(std::size_t a, std::size_t b) const {
        const double ha = length(a), hb = length(b);
        const double da = (values_[a + 1] - values_[a]) / ha, db = (values_[b + 1] - values_[b]) / hb;
        if (!(da * db > 0)) return 0;
        const double wa = 2 * hb + ha, wb = hb + 2 * ha;
        return (wa + wb) / (wa / da + wb / db);
    }

    const std::vector<double>* times_;
    std::vector<double> values_;
    std::vector<double> slopes_;
};

void refuse_other_keys(const JsonView& view, std::span<const std::string_view> known) {
    for (const std::string& key : view.keys()) {
        if (std::ranges::find(known, key) != known.end()) continue;
        std::string list;
        for (const std::string_view name : known) list += (list.empty() ? "" : ", ") + std::string(name);
        view.at(key).fail("no such key; known are " + list);
    }
}

class MotionReader {
 public:
    MotionReader(const JsonView& root, std::string file) : root_(root), file_(std::move(file)) {}

    BodyClips read() {
        constexpr std::array<std::string_view, 7> kKeys{"name", "title", "note", "loop", "times", "hips", "joints"};
        refuse_other_keys(root_, kKeys);
        BodyClips motion{.body = upright_skeleton(file_), .clips = {}};
        Clip clip{.name = root_.at("name").string()};
        for (const char* text : {"title", "note"})
            if (root_.has(text)) root_.at(text).string();
        if (root_.has("loop")) clip.is_loop = root_.at("loop").boolean();
        read_times(clip);
        read_joints(clip);
        if (root_.has("hips")) read_hips(clip);
        check_clip(clip, motion.body.bones, file_);
        motion.clips.push_back(std::move(clip));
        return motion;
    }

 private:
    void read_times(Clip& clip) {
        const JsonView times = root_.at("times");
        if (times.size() == 0) times.fail("empty: at least the time 0 is needed");
        if (times.size() > kMostKeys) times.fail("more than " + std::to_string(kMostKeys) + " times");
        for (std::size_t k = 0; k < times.size(); ++k) {
            const double t = times.at(k).number_between(0, kMostSeconds);
            if (k == 0 && t != 0) times.at(k).fail("the first time must be 0");
            if (k > 0 && t - times_.back() < 1e-3) times.at(k).fail("it must be 1 ms or more after the time before it");
            times_.push_back(t);
        }
        clip.seconds = times_.back();
        if (clip.is_loop && times_.size() < 2) times.fail("a loop needs at least two times");
        for (std::size_t k = 0; k + 1 < times_.size(); ++k) {
            const double h = times_[k + 1] - times_[k];
            const int pieces = std::max(1, int(std::ceil(h / kSampleStep - 1e-6)));
            for (int i = 0; i < pieces; ++i) samples_.push_back({times_[k] + h * i / pieces, k, double(i) / pieces});
        }
        if (times_.size() > 1) samples_.push_back({times_.back(), times_.size() - 2, 1});
    }

    // One number for all times or a list of as many.
    Course read_course(const JsonView& view, double most, bool is_loop) const {
        if (view.value().is_number())
            return {times_, std::vector(times_.size(), view.number_between(-most, most)), is_loop};
        if (view.size() != times_.size())
            view.fail(std::to_string(view.size()) + " values where " + std::to_string(times_.size()) + " times are");
        std::vector<double> values;
        for (std::size_t k = 0; k < view.size(); ++k) values.push_back(view.at(k).number_between(-most, most));
        return {times_, std::move(values), is_loop};
    }

    std::optional<Course> read_course_of(const JsonView& parent, std::string_view key, double most, bool is_loop,
                                         bool may_travel) const {
        if (!parent.has(key)) return std::nullopt;
        const JsonView view = parent.at(key);
        Course course = read_course(view, most, is_loop);
        if (is_loop && !may_travel && std::abs(course.last() - course.first()) > 1e-6)
            view.fail("a loop must end as it starts");
        return course;
    }

    template <class Value, class Make>
    Keys<Value> sampled(const Make& make) const {
        Keys<Value> keys;
        if (times_.size() == 1) return {{0.0}, {make([](const Course& course) { return course.first(); })}};
        for (const Sample& sample : samples_) {
            keys.times.push_back(sample.time);
            keys.values.push_back(make([&](const Course& course) { return course.at(sample.interval, sample.share); }));
        }
        return keys;
    }

    void read_joints(Clip& clip) {
        const JsonView joints = root_.at("joints");
        for (const std::string& name : joints.keys()) {
            const JsonView angles = joints.at(name);
            const std::optional<Joint> joint = find_joint(name);
            if (!joint) angles.fail("no such joint; known are " + all_joints());
            const std::array<std::string_view, 3> keys = angle_names(*joint);
            refuse_other_keys(angles, keys);
            std::array<std::optional<Course>, 3> courses;
            for (std::size_t k = 0; k < 3; ++k)
                courses[k] = read_course_of(angles, keys[k], kMostDegrees, clip.is_loop, false);
            clip.tracks.push_back(
                {.bone = int(*joint), .rotation = sampled<Eigen::Quaterniond>([&](const auto& value_at) {
                                          Vec3d radians = Vec3d::Zero();
                                          for (std::size_t k = 0; k < 3; ++k)
                                              if (courses[k])
                                                  radians[Eigen::Index(k)] =
                                                      value_at(*courses[k]) * std::numbers::pi / 180;
                                          return joint_rotation(*joint, radians);
                                      })});
        }
    }

    void read_hips(Clip& clip) {
        const JsonView hips = root_.at("hips");
        constexpr std::array<std::string_view, 3> kKeys{"left", "up", "forward"};
        refuse_other_keys(hips, kKeys);
        std::array<std::optional<Course>, 3> courses;
        Vec3d travel = Vec3d::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            courses[k] = read_course_of(hips, kKeys[k], kMostLegs, clip.is_loop, kKeys[k] != "up");
            if (courses[k]) travel[Eigen::Index(k)] = kUprightLegLength * (courses[k]->last() - courses[k]->first());
        }
        auto track = std::ranges::find(clip.tracks, int(Joint::Hips), &Track::bone);
        if (track == clip.tracks.end()) track = clip.tracks.insert(track, Track{.bone = int(Joint::Hips)});
        const Vec3d upright = upright_skeleton(file_).bones[std::size_t(Joint::Hips)].joint;
        track->translation = sampled<Vec3d>([&](const auto& value_at) {
            Vec3d way = Vec3d::Zero();
            for (std::size_t k = 0; k < 3; ++k)
                if (courses[k]) way[Eigen::Index(k)] = kUprightLegLength * value_at(*courses[k]);
            return Vec3d(upright + way);
        });
        if (!clip.is_loop) return;
        clip.travel_bone = int(Joint::Hips);
        clip.travel = travel;
    }

    static std::string all_joints() {
        std::string list;
        for (std::size_t i = 0; i < kJointCount; ++i) list += (i == 0 ? "" : ", ") + std::string(joint_name(Joint(i)));
        return list;
    }

    struct Sample {
        double time;  // s
        std::size_t interval;
        double share;
    };

    JsonView root_;
    std::string file_;
    std::vector<double> times_;
    std::vector<Sample> samples_;
};

BodyClips read_motion(const Json& document, const std::string& file) {
    return MotionReader(JsonView(document, file), file).read();
}

std::string name_of(const EmbeddedFile& file) {
    return std::filesystem::path(file.name).stem().string();
}

std::vector<std::string> shipped_names(bool is_pose) {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : motion_files())
        if ((parse_motion(file.text, std::string(file.name)).clips.front().seconds == 0) == is_pose)
            names.push_back(name_of(file));
    std::ranges::sort(names);
    return names;
}

std::string shipped_list() {
    std::string list;
    for (const EmbeddedFile& file : motion_files()) list += (list.empty() ? "" : ", ") + name_of(file);
    return list;
}

bool is_motion_file(const std::filesystem::path& path) {
    return path.has_extension();
}

// The clip and the skeleton that it was made for.
std::pair<Body, Clip> source_of(const std::string& text) {
    for (const EmbeddedFile& file : motion_files()) {
        if (name_of(file) != text) continue;
        BodyClips motion = parse_motion(file.text, std::string(file.name));
        return {std::move(motion.body), std::move(motion.clips.front())};
    }
    if (text.ends_with(".json")) {
        BodyClips motion = read_motion(read_json(text), text);
        return {std::move(motion.body), std::move(motion.clips.front())};
    }
    if (std::error_code error; std::filesystem::is_directory(text, error))
        throw InputError(text, "", "a folder is no motion");
    const auto [path, clip] = split_clip_name(text);
    if (!is_motion_file(path))
        throw InputError("", "",
                         "no motion '" + text + "': known are " + shipped_list() +
                             ", or name a .json, .bvh, .fbx, .gltf or .glb file");
    BodyClips motion = load_motion(path);
    Clip found = find_clip(motion.clips, clip, path);
    if (clip.empty() && motion.clips.size() > 1) found.notes.push_back(choice_text(motion.clips));
    stand_up(motion.body, found, {.is_y_up = motion.is_y_up});
    mend_jumps(motion.body, found);
    return {std::move(motion.body), std::move(found)};
}

// Whether both are of one file: then the clip moves the body as it was made.
bool are_of_one_file(const Body& source, const Body& body) {
    return !source.file.empty() && source.file == body.file;
}

bool has_leg(const JointBones& joints) {
    return (joints.has(Joint::LeftUpperLeg) && joints.has(Joint::LeftLowerLeg) && joints.has(Joint::LeftFoot)) ||
           (joints.has(Joint::RightUpperLeg) && joints.has(Joint::RightLowerLeg) && joints.has(Joint::RightFoot));
}

// Notes what a motion from elsewhere leaves as it is.
void note_still_joints(const JointBones& source, const JointBones& body, Clip& clip) {
    std::string still;
    for (const Joint upper : {Joint::LeftUpperArm, Joint::RightUpperArm, Joint::LeftUpperLeg, Joint::RightUpperLeg}) {
        const Joint lower = Joint(int(upper) + 1);
        for (const Joint joint : {upper, lower}) {
            if (source.has(joint) || !body.has(joint)) continue;
            still += (still.empty() ? "" : ", ") + std::string(joint_name(joint));
            break;  // what hangs on it is still too
        }
    }
    if (!still.empty())
        clip.notes.push_back("the motion's skeleton has no joint that is known as " + still + ": not moved");
    if (body.has(Joint::Hips) && (!source.has(Joint::Hips) || !has_leg(source)))
        clip.notes.push_back("the motion's skeleton has no hips with a whole leg: the body stays in its place");
}

void note_opened_arms(double angle, Clip& clip) {
    constexpr double kNotable = 15;  // degrees; a wider trunk than the recorded person's opens hanging arms by 10
    const double degrees = angle * 180 / std::numbers::pi;
    if (degrees < kNotable) return;
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "arms opened by %.0f degrees, which would be in trunk or thighs", degrees);
    clip.notes.emplace_back(text.data());
}

Clip fitted(const Body& source, const Clip& clip, const Body& body) {
    Clip result = retarget(source, clip, body);
    result.notes.insert(result.notes.begin(), clip.notes.begin(), clip.notes.end());
    note_still_joints(find_joints(source.bones), find_joints(body.bones), result);
    if (!are_of_one_file(source, body)) note_opened_arms(clear_arms(body, result), result);
    return result;
}

}  // namespace

BodyClips parse_motion(std::string_view text, const std::string& file) {
    return read_motion(parse_json(text, file), file);
}

std::vector<std::string> motion_names() {
    return shipped_names(false);
}

std::vector<std::string> pose_names() {
    return shipped_names(true);
}

Clip find_motion(const std::string& text, const Body& body) {
    const auto source = source_of(text);
    Clip clip = fitted(source.first, source.second, body);
    if (body.skin.empty()) return clip;
    if (are_of_one_file(source.first, body)) {
        stand_on_floor(body, clip);
    } else {
        keep_on_floor(body, clip);
    }
    return clip;
}

Pose find_pose(const std::string& text, const Body& body) {
    const auto source = source_of(text);
    Clip clip = fitted(source.first, source.second, body);
    clip.is_loop = false;
    Pose pose = sample(body, clip, clip.seconds);
    if (!body.skin.empty()) stand_on_floor(body, pose);
    return pose;
}

}  // namespace selvedge::sim
