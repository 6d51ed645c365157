#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "sim/body/skin.h"
#include "sim/exchange/mesh_cache.h"
#include "sim/mannequin/mannequin.h"
#include "sim/motion/clear_arms.h"
#include "sim/motion/motion_file.h"
#include "sim/repair/load_body.h"
#include "sim/repair/self_intersections.h"
#include "tests/sim/motion/support.h"
#include "tests/support/bodies.h"
#include "tests/support/mannequin.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

std::string bone_of(const Body& body, int triangle) {
    const SkinWeights& skin = body.skin[std::size_t(body.triangles[std::size_t(triangle)][0])];
    return body.bones[skin.bones[std::size_t(std::ranges::max_element(skin.weights) - skin.weights.begin())]].name;
}

// Pairs of triangles of which one is of a forearm or a hand and cuts another part.
int forearm_cuts(const Body& body, const Pose& pose) {
    Body posed = body;
    posed.x = skin(body, pose);
    int cuts = 0;
    for (const auto& [a, b] : self_intersections(posed)) {
        const std::array names{bone_of(body, a), bone_of(body, b)};
        cuts += std::ranges::any_of(names, [](const std::string& name) {
            return name.ends_with("lower_arm") || name.ends_with("hand") || name.ends_with("finger_base");
        });
    }
    return cuts;
}

Body stout_mannequin() {
    MannequinOptions options{.subdivisions = 1};
    options.measures.bust = 1.15;
    options.measures.waist = 1.0;
    options.measures.hip = 1.25;
    return make_mannequin(options).body;
}

TEST(ClearArms, leaves_arms_that_are_clear) {
    const Body& body = test::mannequin();
    Clip still{.name = "still", .seconds = 1};
    EXPECT_EQ(clear_arms(body, still), 0);
    Clip up = find_motion("arms_up", body);
    EXPECT_EQ(clear_arms(body, up), 0);
    Body bare = body;
    bare.skin.clear();
    EXPECT_EQ(clear_arms(bare, up), 0);
}

TEST(ClearArms, opens_arms_that_cut_the_trunk) {
    const Body& body = test::mannequin();
    Clip clip{.name = "pressed", .seconds = 0};
    for (const std::string side : {"left_", "right_"}) {
        const int bone = find_bone(body, side + "upper_arm");
        const double inward = side == "left_" ? -0.8 : 0.8;
        clip.tracks.push_back(
            {.bone = bone, .rotation = {{0}, {Eigen::Quaterniond(Eigen::AngleAxisd(inward, Vec3d::UnitZ()))}}});
    }
    EXPECT_GT(forearm_cuts(body, sample(body, clip, 0)), 50);
    const double angle = clear_arms(body, clip);
    EXPECT_GT(angle, 0.1);
    EXPECT_LT(angle, 0.6);
    EXPECT_EQ(forearm_cuts(body, sample(body, clip, 0)), 0);
}

// A rig whose fingers have bones of their own: all of a hand but its first 2 cm.
Body with_fingers(Body body) {
    const std::vector<Eigen::Affine3d> rest = bone_frames(body, rest_pose(body));
    for (const std::string side : {"left_", "right_"}) {
        const int hand = find_bone(body, side + "hand");
        const Vec3d knuckles = rest[std::size_t(hand)].translation() +
                               (rest[std::size_t(hand)].translation() -
                                rest[std::size_t(find_bone(body, side + "lower_arm"))].translation())
                                       .normalized() *
                                   0.02;
        Bone fingers = body.bones[std::size_t(hand)];
        fingers.name = side + "finger_base";
        fingers.parent = hand;
        fingers.rest = {};
        const auto number = static_cast<std::uint16_t>(body.bones.size());
        body.bones.push_back(fingers);
        for (std::size_t v = 0; v < body.x.size(); ++v) {
            const bool is_finger = (body.x[v] - rest[std::size_t(hand)].translation()).norm() >
                                   (knuckles - rest[std::size_t(hand)].translation()).norm();
            for (std::size_t k = 0; k < 4; ++k)
                if (is_finger && body.skin[v].bones[k] == hand) body.skin[v].bones[k] = number;
        }
    }
    return body;
}

TEST(ClearArms, counts_fingers_as_a_part_of_their_hand) {
    for (const Body& body : {test::mannequin(), stout_mannequin()}) {
        const Body rigged = with_fingers(body);
        for (const std::string& name : motion_names()) {
            const Clip clip = find_motion(name, rigged);
            for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0})
                EXPECT_EQ(forearm_cuts(rigged, sample(rigged, clip, share * clip.seconds)), 0)
                    << body.made_from << ": " << name << " at " << share;
        }
    }
}

TEST(ClearArms, keeps_shipped_motions_of_slim_and_stout_bodies_apart_from_their_hands) {
    for (const Body& body :
         {test::mannequin(), make_mannequin({.sex = Sex::Male, .subdivisions = 1}).body, stout_mannequin()})
        for (const std::string& name : motion_names()) {
            const Clip clip = find_motion(name, body);
            for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0})
                EXPECT_EQ(forearm_cuts(body, sample(body, clip, share * clip.seconds)), 0)
                    << body.made_from << ": " << name << " at " << share;
        }
}

// As `animate --export` writes it: the body moves by its bones, beside a garment that is no part of it.
TEST(FindMotion, gives_a_body_that_was_written_with_a_motion_that_motion) {
    const Body& body = test::mannequin();
    const Clip walk = find_motion("walk", body);
    const TemporaryFolder folder;
    const std::string path = (folder / "walk.glb").string();
    constexpr std::size_t kFrames = 25;
    constexpr double kRate = 25;  // 1/s
    const DrawMesh surface = body_mesh(body),
                   garment = body_mesh(shapes::box({-0.02, 1.1, -0.02}, {0.02, 1.2, 0.02}, 2));
    const auto cache =
        open_mesh_cache(path, garment, {.frames = kFrames, .frames_per_second = kRate, .bones = &body}, &surface);
    const auto posed = [&](const Pose& pose) {
        std::vector<Vec3f> x;
        for (const Vec3d& p : skin(body, pose)) x.push_back(p.cast<float>());
        return x;
    };
    for (std::size_t i = 0; i < kFrames; ++i) {
        const Pose pose = sample(body, walk, double(i) / kRate);
        cache->add(garment.x, posed(pose), &pose);
    }
    cache->finish();
    const BodyClips own = load_moving_body(path);
    const Clip found = find_motion(path, own.body);
    EXPECT_NEAR(found.seconds, double(kFrames - 1) / kRate, 1e-5);
    const auto hand_from_hips = [](const Body& of, const Clip& clip, double t) {
        const Pose pose = sample(of, clip, t);
        return Vec3d(of.frame.linear() * (joint_at(of, pose, Joint::LeftHand) - joint_at(of, pose, Joint::Hips)));
    };
    for (const int frame : {6, 13, 24}) {
        const double t = double(frame) / kRate;
        EXPECT_LT((hand_from_hips(own.body, found, t) - hand_from_hips(body, walk, t)).norm(), 0.001) << frame;
    }
}

TEST(FindMotion, gives_a_body_its_own_clip_as_it_is) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    if (!data) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    for (const char* file : {"CesiumMan.glb", "mh_female_cmu01_01.glb"}) {
        const std::string path = (std::filesystem::path(data) / "bodies" / file).string();
        const BodyClips own = load_moving_body(path);
        const Clip found = find_motion(path, own.body);
        const Clip& clip = own.clips.front();
        const auto at = [&](const Clip& of, double t) { return skin(own.body, sample(own.body, of, t)); };
        const Vec3d shift = at(found, 0)[0] - at(clip, 0)[0];
        EXPECT_LT(std::abs(shift.y()), 0.03) << file;
        for (const double share : {0.1, 0.35, 0.7, 1.0}) {
            const std::vector<Vec3d> wanted = at(clip, share * clip.seconds), x = at(found, share * clip.seconds);
            double farthest = 0;
            for (std::size_t v = 0; v < x.size(); ++v) farthest = std::max(farthest, (x[v] - wanted[v] - shift).norm());
            EXPECT_LT(farthest, 0.005) << file << " at " << share;
        }
    }
}

}  // namespace
}  // namespace selvedge::sim
