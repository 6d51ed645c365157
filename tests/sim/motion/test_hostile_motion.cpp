// Files of animations with faults: each is refused by one line that names the file and the place, or read without the
// fault; none harms the program.
#include <gtest/gtest.h>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "sim/body/skin.h"
#include "sim/core/error.h"
#include "sim/repair/load_body.h"
#include "tests/support/bodies.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::string base64(const std::string& bytes) {
    constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? std::uint8_t(bytes[i + k]) : std::uint32_t{0});
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63];
    }
    return text;
}

// A box of 1.7 m on two joints, the upper of which turns.
struct SkinnedBox {
    std::vector<float> times{0, 0.5F, 1};
    std::vector<float> rotations{0, 0, 0, 1, 0.1F, 0, 0, 0.995F, 0, 0, 0, 1};
    std::uint16_t last_joint = 1;  // of the last vertex
    float last_weight = 1;
    std::string node_rest{};  // more of the upper joint, such as "\"scale\": [0, 0, 0], "
    std::string path = "rotation";
    int target = 2;  // node that is animated
    std::string more_nodes{};
    int skin_joint = 2;  // the second joint of the skin
};

class Buffer {
 public:
    template <class T>
    int add(const std::vector<T>& items, int component, const char* type, std::size_t width) {
        while (bytes_.size() % 4 != 0) bytes_ += '\0';
        views_ += (views_.empty() ? "" : ", ") + std::string("{\"buffer\": 0, \"byteOffset\": ") +
                  std::to_string(bytes_.size()) + ", \"byteLength\": " + std::to_string(items.size() * sizeof(T)) + "}";
        accessors_ += (accessors_.empty() ? "" : ", ") + std::string("{\"bufferView\": ") + std::to_string(count_) +
                      ", \"componentType\": " + std::to_string(component) +
                      ", \"count\": " + std::to_string(items.size() / width) + ", \"type\": \"" + type + "\"}";
        bytes_.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T));
        return count_++;
    }
    std::string json() const {
        return "\"accessors\": [" + accessors_ + "], \"bufferViews\": [" + views_ +
               "], \"buffers\": [{\"byteLength\": " + std::to_string(bytes_.size()) +
               ", \"uri\": \"data:application/octet-stream;base64," + base64(bytes_) + "\"}]";
    }

 private:
    std::string bytes_, views_, accessors_;
    int count_ = 0;
};

std::string gltf_of(const SkinnedBox& box) {
    constexpr int kFloat = 5126, kShort = 5123;
    const Body surface = shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 2);
    std::vector<float> x, weights;
    std::vector<std::uint16_t> joints, corners;
    for (const Vec3d& p : surface.x) {
        for (int k = 0; k < 3; ++k) x.push_back(float(p[k]));
        joints.insert(joints.end(), {std::uint16_t(p.y() > 0.5 ? 1 : 0), 0, 0, 0});
        weights.insert(weights.end(), {1, 0, 0, 0});
    }
    joints[joints.size() - 4] = box.last_joint;
    weights[weights.size() - 4] = box.last_weight;
    for (const auto& triangle : surface.triangles)
        for (const int v : triangle) corners.push_back(std::uint16_t(v));
    std::vector<float> binds;
    for (const float height : {0.0F, 0.8F})
        binds.insert(binds.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -height, 0, 1});
    Buffer buffer;
    const int position = buffer.add(x, kFloat, "VEC3", 3);
    const int index = buffer.add(corners, kShort, "SCALAR", 1);
    const int joint = buffer.add(joints, kShort, "VEC4", 4), weight = buffer.add(weights, kFloat, "VEC4", 4);
    const int bind = buffer.add(binds, kFloat, "MAT4", 16);
    const int time = buffer.add(box.times, kFloat, "SCALAR", 1);
    const int value = box.path == "rotation" ? buffer.add(box.rotations, kFloat, "VEC4", 4)
                                             : buffer.add(box.rotations, kFloat, "VEC3", 3);
    std::ostringstream text;
    text << R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}], "nodes": [
        {"name": "Box", "mesh": 0, "skin": 0}, {"name": "Hips", "children": [2]},
        {"name": "Chest", )"
         << box.node_rest << R"("translation": [0, 0.8, 0]})" << box.more_nodes << R"(],
        "skins": [{"joints": [1, )"
         << box.skin_joint << R"(], "inverseBindMatrices": )" << bind << R"(}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": )"
         << position << R"(, "JOINTS_0": )" << joint << R"(, "WEIGHTS_0": )" << weight << R"(}, "indices": )" << index
         << R"(}]}],
        "animations": [{"name": "sway", "samplers": [{"input": )"
         << time << R"(, "output": )" << value << R"(}], "channels": [{"sampler": 0, "target": {"node": )" << box.target
         << R"(, "path": ")" << box.path << R"("}}]}], )" << buffer.json() << "}";
    return text.str();
}

class HostileMotion : public testing::Test {
 protected:
    // What is wrong with a file of this content, without the folder; "" if nothing is.
    std::string message_of(const char* name, const std::string& content) {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        try {
            const bool has_surface = std::string(name).find("gltf") != std::string::npos;
            motion_ = has_surface ? load_moving_body(folder_ / name) : load_motion(folder_ / name);
            for (const Clip& clip : motion_.clips) expect_finite(clip);
            return "";
        } catch (const InputError& error) {
            const std::string text = error.what();
            EXPECT_TRUE(text.starts_with((folder_ / name).string() + ": ")) << text;
            EXPECT_EQ(text.find('\n'), std::string::npos);
            return text.substr((folder_ / name).string().size() + 2);
        }
    }
    std::string message_of(const SkinnedBox& box) { return message_of("box.gltf", gltf_of(box)); }

    void expect_finite(const Clip& clip) {
        for (double t = 0; t <= clip.seconds; t += clip.seconds / 7 + 0.01)
            for (const Eigen::Affine3d& frame : bone_frames(motion_.body, sample(motion_.body, clip, t)))
                EXPECT_TRUE(frame.matrix().allFinite());
    }

    TemporaryFolder folder_;
    BodyClips motion_;
};

TEST_F(HostileMotion, of_a_sound_gltf_is_none) {
    ASSERT_EQ(message_of(SkinnedBox()), "");
    ASSERT_EQ(motion_.clips.size(), 1U);
    EXPECT_NEAR(motion_.clips.front().seconds, 1, 1e-6);
    const std::vector<Vec3d> x = skin(motion_.body, sample(motion_.body, motion_.clips.front(), 0.5));
    double moved = 0;
    for (std::size_t v = 0; v < x.size(); ++v) moved = std::max(moved, (x[v] - motion_.body.x[v]).norm());
    EXPECT_GT(moved, 0.1);
}

TEST_F(HostileMotion, in_gltf_keys_is_named_with_clip_bone_and_key) {
    SkinnedBox box;
    box.rotations[6] = kNan;
    EXPECT_EQ(message_of(box), "clip 'sway', bone 'Chest', rotation key 1: its value is not a reasonable number");
    box = {};
    box.rotations = {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1};
    EXPECT_EQ(message_of(box), "clip 'sway', bone 'Chest', rotation key 0: its value is not a reasonable number");
    box = {};
    box.times = {0, kNan, 1};
    EXPECT_EQ(message_of(box), "clip 'sway', bone 'Chest', rotation key 1: its time is not a number");
    box.times = {0, 1, 0.5F};
    EXPECT_EQ(message_of(box),
              "clip 'sway', bone 'Chest', rotation key 2: its time is before that of the key before it");
    box.times = {-1, 0, 1};
    EXPECT_EQ(message_of(box), "clip 'sway', bone 'Chest', rotation key 0: its time is negative");
    box.times = {0, 1, 1e5F};
    EXPECT_EQ(message_of(box), "clip 'sway': it is longer than 3600 s");
    box = {};
    box.path = "scale";
    box.rotations = {1, 1, 1, 0, 0, 0, 1, 1, 1};
    EXPECT_EQ(message_of(box), "clip 'sway', bone 'Chest', scale key 1: its scale is 0");
    box.path = "translation";
    box.rotations = {1, 1, 1, 1e30F, 0, 0, 1, 1, 1};
    EXPECT_EQ(message_of(box), "clip 'sway', bone 'Chest', translation key 1: its value is not a reasonable number");
    box = {};
    box.times = {0, 0, 0};  // all at once: a clip of no length
    EXPECT_EQ(message_of(box), "");
}

TEST_F(HostileMotion, in_gltf_skeleton_and_skin_is_named) {
    SkinnedBox box;
    box.node_rest = R"("scale": [0, 0, 0], )";
    box.target = 1;
    EXPECT_EQ(message_of(box), "bone 'Chest': it squeezes the skin to nothing: is its scale 0?");
    box = {};
    box.last_joint = 500;
    EXPECT_EQ(message_of(box),
              "meshes[0].primitives[0].attributes.JOINTS_0: vertex 25 hangs on joint 500 of a skin that has 2");
    box.last_weight = 0;
    EXPECT_EQ(message_of(box), "");  // what is not used may be anything
    box = {};
    box.last_weight = kNan;
    EXPECT_EQ(message_of(box), "");  // the vertex follows the node of the mesh
    for (const Vec3d& x : skin(motion_.body, rest_pose(motion_.body))) EXPECT_TRUE(x.allFinite());
    box = {};
    box.skin_joint = 77;
    EXPECT_NE(message_of(box), "");
    box = {};
    box.target = 77;
    EXPECT_NE(message_of(box), "");
    box = {};
    for (int i = 0; i < 10'000; ++i) {
        const std::string child = i + 1 < 10'000 ? R"(, "children": [)" + std::to_string(i + 4) + "]" : "";
        box.more_nodes += R"(, {"name": "j)" + std::to_string(i) + "\"" + child + "}";
    }
    box.node_rest = R"("children": [3], )";
    EXPECT_EQ(message_of(box), "cannot be read: nodes[4098]: more than 4096 nodes lie above it");
    box = {};
    for (int i = 0; i < 10'000; ++i) {
        box.more_nodes += R"(, {"name": "j)" + std::to_string(i) + "\"}";
        box.node_rest += (i == 0 ? R"("children": [)" : ", ") + std::to_string(i + 3);
    }
    box.node_rest += "], ";
    EXPECT_EQ(message_of(box), "cannot be read: it has more than 4096 joints");
}

TEST_F(HostileMotion, of_gltf_bytes_garbled_anywhere_is_found_or_harmless) {
    std::mt19937 random(11);
    const std::string sound = gltf_of(SkinnedBox());
    for (int i = 0; i < 40; ++i) {
        std::string text = sound;
        for (int k = 0; k < 4; ++k) text[random() % text.size()] = char(32 + random() % 90);
        message_of("garbled.gltf", text);
    }
}

std::string bvh_of(const std::string& joints, const std::string& frames, const std::string& frame_time,
                   const std::string& values) {
    return "HIERARCHY\nROOT Hips\n{\n  OFFSET 0 0 0\n  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
           "Yrotation\n" +
           joints + "}\nMOTION\nFrames: " + frames + "\nFrame Time: " + frame_time + "\n" + values;
}

const std::string kLeg =
    "  JOINT LeftUpLeg\n  {\n    OFFSET 10 -5 0\n    CHANNELS 3 Zrotation Xrotation Yrotation\n    End Site\n    {\n"
    "      OFFSET 0 -40 0\n    }\n  }\n";

TEST_F(HostileMotion, in_bvh_text_is_named) {
    const std::string frame = "0 90 0 0 0 0 1 2 3\n";
    ASSERT_EQ(message_of("a.bvh", bvh_of(kLeg, "2", "0.0333", frame + frame)), "");
    EXPECT_NEAR(motion_.clips.front().seconds, 0.0333, 0.04);
    const auto message = [&](const std::string& frames, const std::string& time, const std::string& rows,
                             const std::string& joints = kLeg) {
        return message_of("a.bvh", bvh_of(joints, frames, time, rows));
    };
    EXPECT_EQ(message("2", "0.0333", frame + "0 nan 0 0 0 0 1 2 3\n"), "line 20: a channel is no number: 'nan'");
    EXPECT_EQ(message("2", "0.0333", frame + "0 1e99 0 0 0 0 1 2 3\n"),
              "line 20: a channel is not a reasonable number");
    EXPECT_EQ(message("2", "0.0333", "0 90 0 0 0 0 1 two 3\n" + frame), "line 19: a channel is no number: 'two'");
    for (const char* time : {"0", "-0.03", "1e9", "1e-30"})
        EXPECT_EQ(message("2", time, frame + frame), "line 18: the time of a frame is not between 0.001 and 1 s");
    EXPECT_EQ(message("2", "nan", frame + frame), "line 18: the time of a frame is no number: 'nan'");
    EXPECT_EQ(message("3", "0.0333", frame), "line 19: the file ends in row 2 of 3, after 0 of 9 numbers");
    EXPECT_EQ(message("1", "0.0333", frame + frame), "");
    EXPECT_EQ(message("1", "0.0333", frame + "1 2 3\n" + frame),
              "line 20: neither a row of 9 numbers nor the end, after the 1 rows of 'Frames:'");
    EXPECT_EQ(message("0", "0.0333", ""), "line 17: its motion has no frames");
    for (const char* frames : {"-1", "3.7"})
        EXPECT_EQ(message(frames, "0.0333", frame), "line 17: the number of frames is not a whole number");
    EXPECT_EQ(message("many", "0.0333", frame), "line 17: the number of frames is no number: 'many'");
    EXPECT_EQ(message("999999999999", "0.0333", frame), "line 17: its motion is too long: more than 4000000 keys");
    EXPECT_EQ(message("5000", "0.9", frame), "line 18: its motion is longer than 3600 s");
}

TEST_F(HostileMotion, in_a_bvh_skeleton_is_named) {
    const std::string row = "0 90 0 0 0 0\n", frame = "0 90 0 0 0 0 1 2 3\n";
    const auto message = [&](const std::string& joints) {
        return message_of("a.bvh", bvh_of(joints, "1", "0.0333", frame));
    };
    EXPECT_EQ(message("  JOINT LeftUpLeg\n  {\n"), "line 8: 'OFFSET' is missing, before '}'");
    EXPECT_EQ(message(kLeg + kLeg), "line 15: a second joint is called 'LeftUpLeg'");
    std::string leg = kLeg;
    leg.replace(leg.find("Xrotation"), 9, "Zrotation");
    EXPECT_EQ(message(leg), "line 9: a second channel 'Zrotation' of one joint");
    leg.replace(leg.find("Zrotation"), 9, "Wrotation");
    EXPECT_EQ(message(leg), "line 9: the name of a channel, as Xrotation, is missing, before 'Wrotation'");
    leg = kLeg;
    leg.replace(leg.find("CHANNELS 3"), 10, "CHANNELS 7");
    EXPECT_EQ(message(leg), "line 9: a joint has 0 to 6 channels");
    leg = kLeg;
    leg.replace(leg.find("10 -5"), 5, "10 1e7");
    EXPECT_EQ(message(leg), "line 8: an offset is not a reasonable number");
    std::string many, ends;
    for (int i = 0; i < 100'000; ++i) {
        many += "JOINT j" + std::to_string(i) + "\n{\nOFFSET 0 1 0\nCHANNELS 0\n";
        ends += "}\n";
    }
    many += "End Site\n{\nOFFSET 0 1 0\n}\n" + ends;
    EXPECT_EQ(message_of("a.bvh", bvh_of(many, "1", "0.0333", row)), "line 16386: more than 4096 joints");
    const std::string sound = bvh_of(kLeg, "1", "0.0333", frame);
    EXPECT_EQ(message_of("a.bvh", "\xEF\xBB\xBF" + sound),
              "it starts with a byte-order mark: save it as UTF-8 without one");
    for (std::size_t length = 0; length + frame.size() < sound.size(); ++length)
        EXPECT_NE(message_of("a.bvh", sound.substr(0, length)), "") << "cut after " << length;
}

TEST_F(HostileMotion, of_bvh_bytes_garbled_anywhere_is_found_or_harmless) {
    std::mt19937 random(12);
    const std::string frame = "0 90 0 0 0 0 1 2 3\n", sound = bvh_of(kLeg, "2", "0.0333", frame + frame);
    for (int i = 0; i < 200; ++i) {
        std::string text = sound;
        for (int k = 0; k < 2; ++k) text[random() % text.size()] = char(32 + random() % 90);
        message_of("garbled.bvh", text);
    }
}

const std::string kFbxJoint = R"(; FBX 7.3.0 project file
FBXHeaderExtension:  {
  FBXHeaderVersion: 1003
  FBXVersion: 7300
}
GlobalSettings:  {
  Version: 1000
  Properties70:  {
    P: "UpAxis", "int", "Integer", "",1
    P: "TimeSpanStart", "KTime", "Time", "",0
    P: "TimeSpanStop", "KTime", "Time", "",46186158000
  }
}
Objects:  {
  Model: 100, "Model::Hips", "LimbNode" {
    Version: 232
    Properties70:  {
      P: "Lcl Translation", "Lcl Translation", "", "A",0,90,0
      P: "Lcl Rotation", "Lcl Rotation", "", "A",0,0,0
    }
  }
  NodeAttribute: 101, "NodeAttribute::", "LimbNode" {
    TypeFlags: "Skeleton"
  }
)";

// FBX as text: one joint whose rotation about x has two keys; times in 1/46,186,158,000 s.
std::string fbx_of(const std::string& times, const std::string& values) {
    return kFbxJoint +
           R"(  AnimationStack: 200, "AnimStack::Take", "" {
    Properties70:  {
      P: "LocalStop", "KTime", "Time", "",46186158000
    }
  }
  AnimationLayer: 201, "AnimLayer::Base", "" {
  }
  AnimationCurveNode: 202, "AnimCurveNode::R", "" {
    Properties70:  {
      P: "d|X", "Number", "", "A",0
    }
  }
  AnimationCurve: 203, "AnimCurve::", "" {
    Default: 0
    KeyVer: 4008
    KeyTime: *2 {
      a: )" +
           times + R"(
    }
    KeyValueFloat: *2 {
      a: )" +
           values + R"(
    }
    KeyAttrFlags: *1 {
      a: 24836
    }
    KeyAttrDataFloat: *4 {
      a: 0,0,0,0
    }
    KeyAttrRefCount: *1 {
      a: 2
    }
  }
}
Connections:  {
  C: "OO",100,0
  C: "OO",101,100
  C: "OO",201,200
  C: "OO",202,201
  C: "OP",202,100, "Lcl Rotation"
  C: "OP",203,202, "d|X"
}
)";
}

TEST_F(HostileMotion, in_fbx_text_is_named) {
    ASSERT_EQ(message_of("a.fbx", fbx_of("0,46186158000", "0,45")), "");
    ASSERT_EQ(motion_.clips.size(), 1U);
    EXPECT_NEAR(motion_.clips.front().seconds, 1, 0.05);
    // assimp leaves out what it cannot read: the rest is sound.
    for (const auto& [times, values] : {std::pair("0,46186158000", "0,nan"), std::pair("46186158000,0", "0,45"),
                                        std::pair("0,46186158000000000", "0,45"), std::pair("0,46186158000", "0")}) {
        EXPECT_EQ(message_of("a.fbx", fbx_of(times, values)), "") << times << " " << values;
        for (const Clip& clip : motion_.clips) check_clip(clip, motion_.body.bones, "a.fbx");
    }
    std::string text = fbx_of("0,46186158000", "0,45");
    text.replace(text.find("0,90,0"), 6, "0,1e20,0");
    EXPECT_NE(message_of("a.fbx", text), "");
    text = fbx_of("0,46186158000", "0,45");
    EXPECT_NE(message_of("a.fbx", text.substr(0, text.size() / 2)), "");
}

// A joint with a turn of its own before the animated one, whether assimp animates its pivots or the whole of it.
TEST_F(HostileMotion, in_fbx_turns_a_joint_by_its_pivots_once) {
    for (const bool moves_too : {false, true}) {
        std::string text = fbx_of("0,46186158000", "0,45");
        text.insert(text.find("      P: \"Lcl Rotation\""),
                    "      P: \"RotationActive\", \"bool\", \"\", \"\",1\n"
                    "      P: \"PreRotation\", \"Vector3D\", \"Vector\", \"\",90,0,0\n");
        if (moves_too) text.replace(text.find("0,90,0"), 6, "0,80,0");
        ASSERT_EQ(message_of("a.fbx", text), "");
        ASSERT_EQ(motion_.clips.size(), 1U);
        const int hips = find_bone(motion_.body, "Hips");
        ASSERT_GE(hips, 0);
        for (const double t : {0.0, 1.0}) {
            const auto frames = bone_frames(motion_.body, sample(motion_.body, motion_.clips[0], t));
            const Eigen::Quaterniond turn = rotation_of(frames[static_cast<std::size_t>(hips)]);
            EXPECT_NEAR(turn.angularDistance(Eigen::Quaterniond::Identity()) * 180 / 3.14159265, 90 + 45 * t, 0.5);
        }
    }
}

}  // namespace
}  // namespace selvedge::sim
