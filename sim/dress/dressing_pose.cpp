#include "sim/dress/dressing_pose.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "sim/body/joint_names.h"
#include "sim/body/yielding_flesh.h"
#include "sim/cloth/contact.h"
#include "sim/dress/motion_run.h"
#include "sim/dress/work_count.h"
#include "sim/motion/motion_file.h"

namespace selvedge::sim {
namespace {

constexpr double kAsItIs = 30 * std::numbers::pi / 180;  // rad: arms that are within this of "A" stay, with room
                                                         // for sleeves above and below them

// Direction from one joint to the next in that pose, unit.
Vec3d direction(const std::vector<Eigen::Affine3d>& frames, int from, int to) {
    return (frames[static_cast<std::size_t>(to)].translation() - frames[static_cast<std::size_t>(from)].translation())
        .normalized();
}

}  // namespace

Pose dressing_pose(const Body& body) {
    Pose pose = rest_pose(body);
    const JointBones joints = find_joints(body.bones);
    constexpr std::array kArms{std::array{Joint::LeftUpperArm, Joint::LeftLowerArm},
                               std::array{Joint::RightUpperArm, Joint::RightLowerArm}};
    for (const auto& [upper, lower] : kArms)
        if (!joints.has(upper) || !joints.has(lower)) return pose;
    const Pose with_arms = find_pose("A", body);
    const auto now = bone_frames(body, pose), wanted = bone_frames(body, with_arms);
    for (const auto& [upper, lower] : kArms) {
        const Vec3d is = direction(now, joints[upper], joints[lower]);
        const Vec3d should = direction(wanted, joints[upper], joints[lower]);
        if (std::acos(std::clamp(is.dot(should), -1.0, 1.0)) < kAsItIs) continue;
        const auto bone = static_cast<std::size_t>(joints[upper]);
        // Turns the upper arm about its joint, in our frame, and leaves the rest of the arm as it is to it.
        const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(is, should);
        const Eigen::Matrix3d parent =
            body.bones[bone].parent < 0
                ? Eigen::Matrix3d(body.frame.linear())
                : Eigen::Matrix3d(now[static_cast<std::size_t>(body.bones[bone].parent)].linear());
        const Eigen::Quaterniond in_parent(Eigen::Affine3d(parent).rotation());
        Transform& local = pose.bones[bone];
        local.rotation = (in_parent.conjugate() * turn * in_parent * local.rotation).normalized();
    }
    return pose;
}

bool needs_other_pose(const Body& body, const Pose& pose) {
    constexpr double kSame = 1e-6;  // rad, rounding
    for (std::size_t i = 0; i < body.bones.size(); ++i)
        if (pose.bones[i].rotation.angularDistance(body.bones[i].rest.rotation) > kSame) return true;
    return false;
}

namespace {

void ignore_itself(Simulation& simulation) {
    SimulationOptions options = simulation.options();
    options.self_contact.reset();
    simulation.set_options(options);
}

}  // namespace

DrapeResult move_to_own_pose(Simulation& simulation, const Body& body, const Pose& start, const BodyCollider& own,
                             const DressOptions& options, const DrapeResult& draped, const Progress& progress) {
    std::optional<GiveUp> given_up = draped.given_up;
    constexpr double kToOwnPose = 1.5;  // s, that the body takes
    MovingFlesh flesh(body);
    const Pose rest = rest_pose(body);
    MotionRun moving(simulation, body, [&](double seconds, const Region& region, std::vector<Vec3f>& x) {
        const auto pose_at = [&](double at) { return blend(start, rest, smoothstep(at, 0, kToOwnPose)); };
        flesh.positions(body, pose_at, seconds, region, x);
    });
    WorkCount counted(simulation.cloth());
    double work = draped.work;
    // A heap of cloth takes ever more work. The arms have to get to their end, so it goes on without contact with
    // itself, and is given up there.
    const auto bound_work = [&] {
        if (work <= options.most_work.value_or(most_work(simulation.cloth()))) return;
        if (!given_up) given_up = GiveUp::TooMuchWork;
        ignore_itself(simulation);
    };
    bound_work();
    // Step by step: within a tenth of a second, the work of a heap can grow a hundredfold.
    const double step = moving.options().step_seconds;
    const long steps = std::lround(kToOwnPose / step);
    for (long done = 1; done <= steps; ++done) {
        moving.advance_to(simulation, static_cast<double>(done) * step);
        work += counted.of_steps(simulation.cloth(), 1);
        bound_work();
        report(progress, "moving", static_cast<double>(done) / static_cast<double>(steps));
    }
    forget_contacts(simulation.cloth());
    DrapeOptions draping = drape_options(options);
    draping.relax_time = draping.coarse_time = draping.lowering_time = 0;
    DrapeRun settling(simulation, draping);
    if (given_up && settling.falls()) settling.give_up(simulation, *given_up);
    while (settling.phase() != DrapePhase::Done && settling.advance(simulation, own)) {
        report(progress, "settling", settling.fraction());
        if (given_up || !settling.falls() || !settling.takes_too_much_work(simulation.cloth())) continue;
        given_up = GiveUp::TooMuchWork;
        settling.give_up(simulation, *given_up);
    }
    DrapeResult result = settling.result();
    result.work += work;
    result.given_up = given_up;  // also if there was no time for it
    return result;
}

}  // namespace selvedge::sim
