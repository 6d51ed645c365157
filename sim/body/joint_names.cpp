#include "sim/body/joint_names.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <string>

#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

struct JointEntry {
    std::string_view name;
    int parent;
};

constexpr std::array<JointEntry, kJointCount> kJoints{{
    {"hips", -1},
    {"spine", 0},
    {"chest", 1},
    {"neck", 2},
    {"head", 3},
    {"left_shoulder", 2},
    {"left_upper_arm", 5},
    {"left_lower_arm", 6},
    {"left_hand", 7},
    {"left_upper_leg", 0},
    {"left_lower_leg", 9},
    {"left_foot", 10},
    {"left_toe", 11},
    {"right_shoulder", 2},
    {"right_upper_arm", 13},
    {"right_lower_arm", 14},
    {"right_hand", 15},
    {"right_upper_leg", 0},
    {"right_lower_leg", 17},
    {"right_foot", 18},
    {"right_toe", 19},
}};

}  // namespace

std::string_view joint_name(Joint joint) {
    return kJoints[static_cast<std::size_t>(joint)].name;
}

std::optional<Joint> find_joint(std::string_view name) {
    const auto found = std::ranges::find(kJoints, name, &JointEntry::name);
    if (found == kJoints.end()) return std::nullopt;
    return static_cast<Joint>(found - kJoints.begin());
}

std::optional<Joint> joint_parent(Joint joint) {
    const int parent = kJoints[static_cast<std::size_t>(joint)].parent;
    return parent < 0 ? std::nullopt : std::optional(static_cast<Joint>(parent));
}

Joint mirrored(Joint joint) {
    const auto i = static_cast<std::size_t>(joint);
    if (i < kMiddleJoints) return joint;
    return static_cast<Joint>(i < kMiddleJoints + kSideJoints ? i + kSideJoints : i - kSideJoints);
}

namespace {

enum class Side { Middle, Left, Right };

// What a bone's name says: its words in lower case without separators, numbers, prefixes and the word of its side.
struct BoneName {
    std::string stem;  // empty: says nothing
    Side side = Side::Middle;
};

// A name of a joint; `joint` is the left one of two. Of a rig's bones with several of a joint's names, the one with the
// lowest rank is the joint: "LeftLeg" is the shin where there is a "LeftUpLeg", and otherwise the thigh.
struct KnownName {
    Joint joint;
    std::string_view stem;
    int rank;
};

constexpr int kChainRank = 9;  // names that a rig gives to all bones of a limb, in their order
constexpr std::array kKnownNames{
    KnownName{Joint::Hips, "hips", 0},
    KnownName{Joint::Hips, "hip", 0},
    KnownName{Joint::Hips, "pelvis", 0},
    KnownName{Joint::Neck, "neck", 0},
    KnownName{Joint::Head, "head", 0},
    KnownName{Joint::Head, "neck", kChainRank},
    KnownName{Joint::LeftUpperArm, "upperarm", 0},
    KnownName{Joint::LeftUpperArm, "uparm", 0},
    KnownName{Joint::LeftUpperArm, "arm", 0},
    KnownName{Joint::LeftUpperArm, "shoulder", 1},  // beside a collar
    KnownName{Joint::LeftUpperArm, "shldr", 1},
    KnownName{Joint::LeftLowerArm, "forearm", 0},
    KnownName{Joint::LeftLowerArm, "lowerarm", 0},
    KnownName{Joint::LeftLowerArm, "lowarm", 0},
    KnownName{Joint::LeftLowerArm, "elbow", 0},
    KnownName{Joint::LeftLowerArm, "arm", kChainRank},
    KnownName{Joint::LeftHand, "wrist", 0},
    KnownName{Joint::LeftHand, "hand", 1},
    KnownName{Joint::LeftHand, "arm", kChainRank},
    KnownName{Joint::LeftShoulder, "clavicle", 0},
    KnownName{Joint::LeftShoulder, "collar", 0},
    KnownName{Joint::LeftShoulder, "collarbone", 0},
    KnownName{Joint::LeftShoulder, "shoulder", 1},
    KnownName{Joint::LeftShoulder, "shldr", 1},
    KnownName{Joint::LeftUpperLeg, "upleg", 0},
    KnownName{Joint::LeftUpperLeg, "upperleg", 0},
    KnownName{Joint::LeftUpperLeg, "thigh", 0},
    KnownName{Joint::LeftUpperLeg, "hip", 1},
    KnownName{Joint::LeftUpperLeg, "leg", 2},
    KnownName{Joint::LeftLowerLeg, "lowerleg", 0},
    KnownName{Joint::LeftLowerLeg, "lowleg", 0},
    KnownName{Joint::LeftLowerLeg, "shin", 0},
    KnownName{Joint::LeftLowerLeg, "calf", 0},
    KnownName{Joint::LeftLowerLeg, "knee", 0},
    KnownName{Joint::LeftLowerLeg, "leg", 1},
    KnownName{Joint::LeftFoot, "ankle", 0},
    KnownName{Joint::LeftFoot, "foot", 1},
    KnownName{Joint::LeftFoot, "leg", kChainRank},
    KnownName{Joint::LeftToe, "toe", 0},
    KnownName{Joint::LeftToe, "toes", 0},
    KnownName{Joint::LeftToe, "toebase", 0},
    KnownName{Joint::LeftToe, "ball", 0},
    KnownName{Joint::LeftToe, "foot", 1},  // beyond an ankle
    KnownName{Joint::LeftToe, "leg", kChainRank},
};

constexpr std::array<std::string_view, 24> kPrefixes{"skeleton", "armature",   "rig",   "character", "mixamorig", "bip",
                                                     "biped",    "valvebiped", "valve", "cc",        "base",      "def",
                                                     "org",      "mch",        "j",     "b",         "bn",        "c",
                                                     "jnt",      "smpl",       "smplx", "avg",       "m",         "f"};
constexpr std::array<std::string_view, 4> kFillers{"joint", "jnt", "jt", "bone"};

template <class Words>
bool is_in(const Words& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

bool is_known_stem(std::string_view stem) {
    return std::ranges::find(kKnownNames, stem, &KnownName::stem) != kKnownNames.end();
}

bool is(int (*kind)(int), char c) {
    return kind(static_cast<unsigned char>(c)) != 0;
}

// "LHipJoint" as "l", "hip", "joint"; "thigh_l.001" as "thigh", "l".
std::vector<std::string> words_of(std::string_view name) {
    std::vector<std::string> words;
    bool is_open = false;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        if (!is(std::isalpha, c)) {
            is_open = false;
            continue;
        }
        const bool follows_lower = i > 0 && is(std::islower, name[i - 1]);
        const bool leads_lower = i + 1 < name.size() && is(std::islower, name[i + 1]);
        if (is(std::isupper, c) && (follows_lower || leads_lower)) is_open = false;
        if (!is_open) words.emplace_back();
        words.back() += char(std::tolower(static_cast<unsigned char>(c)));
        is_open = true;
    }
    return words;
}

// Takes "left" from "leftarm" and "l" from "lthigh".
void split_glued_side(BoneName& name) {
    struct Glued {
        std::string_view word;
        Side side;
    };
    for (const Glued& glued :
         {Glued{"left", Side::Left}, Glued{"right", Side::Right}, Glued{"l", Side::Left}, Glued{"r", Side::Right}}) {
        if (!name.stem.starts_with(glued.word) || !is_known_stem(name.stem.substr(glued.word.size()))) continue;
        name.stem.erase(0, glued.word.size());
        name.side = glued.side;
        return;
    }
}

BoneName read_name(std::string_view text) {
    constexpr std::size_t kLongest = 200;
    if (text.size() > kLongest || text.find("$AssimpFbx$") != std::string_view::npos) return {};  // pivots of FBX
    text.remove_prefix(text.find_last_of(":|") + 1);                                              // npos + 1 is 0
    BoneName name;
    for (const std::string& word : words_of(text)) {
        if (word == "left" || word == "l") {
            name.side = Side::Left;
        } else if (word == "right" || word == "r") {
            name.side = Side::Right;
        } else if (!is_in(kFillers, word) && !(name.stem.empty() && is_in(kPrefixes, word))) {
            name.stem += word;
        }
    }
    if (name.side == Side::Middle && !is_known_stem(name.stem)) split_glued_side(name);
    return name;
}

bool descends_from(const std::vector<Bone>& bones, int bone, int ancestor) {
    while (bone > ancestor) bone = bones[std::size_t(bone)].parent;
    return bone == ancestor;
}

// -1: there is none.
int common_ancestor(const std::vector<Bone>& bones, int a, int b) {
    while (a != b) (a > b ? a : b) = bones[std::size_t(std::max(a, b))].parent;
    return a;
}

class JointFinder {
 public:
    explicit JointFinder(const std::vector<Bone>& bones) : bones_(bones), is_taken_(bones.size(), false) {
        for (const Bone& bone : bones) names_.push_back(read_name(bone.name));
    }

    JointBones find() {
        for (const Side side : {Side::Left, Side::Right}) find_limbs(side);
        find_hips();
        find_trunk();
        return found_;
    }

 private:
    Joint on(Side side, Joint left) const { return side == Side::Right ? mirrored(left) : left; }

    // The bone with a name of that joint that `is_fit`; of those with the best rank the first.
    template <class IsFit>
    int best_bone(Joint joint, Side side, const IsFit& is_fit) const {
        int best = -1;
        int best_rank = std::numeric_limits<int>::max();
        for (std::size_t i = 0; i < bones_.size(); ++i) {
            if (is_taken_[i] || names_[i].side != side || names_[i].stem.empty()) continue;
            for (const KnownName& known : kKnownNames) {
                if (known.joint != joint || known.stem != names_[i].stem || known.rank >= best_rank) continue;
                if (!is_fit(int(i))) continue;
                best = int(i);
                best_rank = known.rank;
            }
        }
        return best;
    }

    void take(Joint joint, int bone) {
        found_[joint] = bone;
        if (bone >= 0) is_taken_[std::size_t(bone)] = true;
    }

    // Each joint of a limb hangs on the one before it that was found.
    void find_limbs(Side side) {
        const std::array<std::vector<Joint>, 2> limbs{
            std::vector{Joint::LeftUpperArm, Joint::LeftLowerArm, Joint::LeftHand},
            std::vector{Joint::LeftUpperLeg, Joint::LeftLowerLeg, Joint::LeftFoot, Joint::LeftToe}};
        for (const std::vector<Joint>& limb : limbs) {
            int above = -1;
            for (const Joint joint : limb) {
                const auto hangs = [&](int bone) { return above < 0 || descends_from(bones_, bone, above); };
                const int bone = best_bone(joint, side, hangs);
                take(on(side, joint), bone);
                if (bone >= 0) above = bone;
            }
        }
        const int arm = found_[on(side, Joint::LeftUpperArm)];
        if (arm < 0) return;
        take(on(side, Joint::LeftShoulder),
             best_bone(Joint::LeftShoulder, side, [&](int bone) { return descends_from(bones_, arm, bone); }));
    }

    // By name if legs and arms hang on it, and otherwise what both legs hang on.
    void find_hips() {
        const auto carries_limbs = [&](int bone) {
            return std::ranges::all_of(
                std::array{Joint::LeftUpperLeg, Joint::RightUpperLeg, Joint::LeftUpperArm, Joint::RightUpperArm},
                [&](Joint joint) { return !found_.has(joint) || descends_from(bones_, found_[joint], bone); });
        };
        int hips = best_bone(Joint::Hips, Side::Middle, carries_limbs);
        if (hips < 0 && found_.has(Joint::LeftUpperLeg) && found_.has(Joint::RightUpperLeg))
            hips = common_ancestor(bones_, found_[Joint::LeftUpperLeg], found_[Joint::RightUpperLeg]);
        take(Joint::Hips, hips);
    }

    // The chest is what both arms hang on; the spine is the first bone from the hips to it.
    void find_trunk() {
        const int hips = found_[Joint::Hips];
        const int left = found_[Joint::LeftUpperArm], right = found_[Joint::RightUpperArm];
        if (hips >= 0 && left >= 0 && right >= 0) {
            const int chest = common_ancestor(bones_, left, right);
            if (chest > hips && descends_from(bones_, chest, hips) && !is_taken_[std::size_t(chest)]) {
                for (int bone = bones_[std::size_t(chest)].parent; bone > hips; bone = bones_[std::size_t(bone)].parent)
                    if (!is_pivot(bone)) found_[Joint::Spine] = bone;
                take(Joint::Spine, found_[Joint::Spine]);
                take(Joint::Chest, chest);
            }
        }
        int below = found_.has(Joint::Chest) ? found_[Joint::Chest] : hips;
        for (const Joint joint : {Joint::Neck, Joint::Head}) {
            const auto hangs = [&](int bone) { return below < 0 || descends_from(bones_, bone, below); };
            take(joint, best_bone(joint, Side::Middle, hangs));
            if (found_.has(joint)) below = found_[joint];
        }
    }

    bool is_pivot(int bone) const { return bones_[std::size_t(bone)].name.find("$AssimpFbx$") != std::string::npos; }

    const std::vector<Bone>& bones_;
    std::vector<BoneName> names_;
    std::vector<bool> is_taken_;
    JointBones found_;
};

std::string some_names(const std::vector<Bone>& bones) {
    constexpr std::size_t kMost = 8;
    std::string list;
    for (std::size_t i = 0; i < std::min(bones.size(), kMost); ++i) {
        std::string name = bones[i].name.substr(0, 40);
        std::ranges::replace_if(
            name, [](char c) { return is(std::iscntrl, c); }, ' ');
        list += (i == 0 ? "'" : ", '") + name + "'";
    }
    return bones.size() > kMost ? list + " ..." : list;
}

}  // namespace

JointBones find_joints(const std::vector<Bone>& bones) {
    return JointFinder(bones).find();
}

JointBones require_joints(const Body& body) {
    const std::string& file = body.file.empty() ? body.name : body.file;
    if (body.bones.empty()) throw InputError(file, "", "it has no skeleton");
    const JointBones joints = find_joints(body.bones);
    for (const Joint joint :
         {Joint::Hips, Joint::LeftUpperArm, Joint::RightUpperArm, Joint::LeftUpperLeg, Joint::RightUpperLeg})
        if (joints.has(joint)) return joints;
    throw InputError(file, "bones",
                     "none is known by its name as hips, leg or arm; they are " + some_names(body.bones));
}

}  // namespace selvedge::sim
