#include "sim/simulation/schedule.h"

namespace selvedge::sim {
namespace {

constexpr float kSewingDamping = 12;   // 1/s: strong, so that panels do not swing, and what falls does not stretch
constexpr float kRelaxDamping = 12;    // 1/s, of sewn cloth without load; as strong as that of sewing, not bound to it
constexpr float kFallDamping = 2;      // 1/s, air drag
constexpr float kFinishDamping = 100;  // 1/s, while residual stretch is removed
constexpr float kHangDamping = 40;     // 1/s: it comes to rest soon

}  // namespace

Schedule closing_seams(std::span<const SeamPull> seams) {
    return {.gravity = 0,
            .damping = kSewingDamping,
            .friction = 0,
            .bias_rate = 0,  // the seams pull harder than any load
            .limit_iterations = 0,
            .seams = seams};
}

Schedule falling_unsewn(std::span<const SeamPull> seams, float weight) {
    return {.gravity = weight, .damping = kSewingDamping, .seams = seams};
}

Schedule relaxing() {
    return {.gravity = 0, .damping = kRelaxDamping, .friction = 0};
}

Schedule falling(float weight) {
    return {.gravity = weight, .damping = kFallDamping};
}

Schedule finishing(int substeps) {
    // Updated biases would set it in motion.
    return {.damping = kFinishDamping, .bias_rate = 0, .substeps = substeps};
}

Schedule hanging() {
    // What presses hard on the body is given to it as it is, also where that moves it far. Biases stay as the drape
    // left them: what is measured is the stress that they stand for.
    return {.damping = kHangDamping, .bias_rate = 0, .longest_move = 1, .offset = kRestOffset};
}

Schedule moving(float air_damping) {
    return {.damping = air_damping, .offset = kRestOffset};
}

Schedule carried_over() {
    return {.may_rejoin = false};
}

}  // namespace selvedge::sim
