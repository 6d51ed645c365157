#include "sim/dress/own_pose.h"

#include <optional>
#include <vector>

#include "sim/body/yielding_flesh.h"
#include "sim/cloth/contact.h"
#include "sim/dress/motion_run.h"

namespace selvedge::sim {

bool needs_other_pose(const Body& body, const Pose& pose) {
    constexpr double kSame = 1e-6;  // rad, rounding
    for (std::size_t i = 0; i < body.bones.size(); ++i)
        if (pose.bones[i].rotation.angularDistance(body.bones[i].rest.rotation) > kSame) return true;
    return false;
}

DrapeResult move_to_own_pose(Simulation& simulation, const Body& body, const Pose& start, const BodyCollider& own,
                             const DressOptions& options, std::optional<GiveUp> given_up, const Progress& progress) {
    constexpr double kReport = 0.1;  // s
    MovingFlesh flesh(body);
    const Pose rest = rest_pose(body);
    MotionRun moving(simulation, body, [&](double seconds, const Region& region, std::vector<Vec3f>& x) {
        const auto pose_at = [&](double at) { return blend(start, rest, smoothstep(at, 0, kToOwnPose)); };
        flesh.positions(body, pose_at, seconds, region, x);
    });
    for (double seconds = kReport; seconds <= kToOwnPose + kReport / 2; seconds += kReport) {
        moving.advance_to(simulation, seconds);
        report(progress, "moving", seconds / kToOwnPose);
    }
    forget_contacts(simulation.cloth());
    DrapeOptions draping = drape_options(options);
    draping.relax_time = draping.coarse_time = draping.lowering_time = 0;
    DrapeRun settling(simulation, draping);
    if (given_up && settling.falls()) settling.give_up(simulation, *given_up);
    while (settling.phase() != DrapePhase::Done && settling.advance(simulation, own))
        report(progress, "settling", settling.fraction());
    DrapeResult result = settling.result();
    result.given_up = given_up;  // also if there was no time for it
    return result;
}

}  // namespace selvedge::sim
