#pragma once
// Letting a sewn garment fall, adapt and settle.
#include <optional>
#include <string>
#include <vector>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/step.h"
#include "sim/core/progress.h"

namespace selvedge {

struct DrapeOptions {
    double max_seconds = 12;  // of simulated time
    int steps_per_adaption = 4;
    float calm_speed = 0.05F;  // m/s rms over mass: below it no edge rejoins any more
    float damping_growth = 4;  // 1/s per second of the adaptive drape, so that it comes to rest
    float rest_speed = 0.01F;  // m/s rms over mass: below it the garment is at rest
    double rest_time = 1.0;    // s for which it must stay there
    double relax_time = 0.6;   // s without gravity and friction
    double coarse_time = 0.2;  // s of them at level 0
    double finish_time = 0.2;  // s of all in finer sub-steps, at the end; longer if it takes longer to rest
    AdaptClothOptions adapt{};
    ContactOptions contact{};
};

struct DrapeResult {
    bool settled = false;
    std::string stopped_because;
    std::optional<VertexId> bad_vertex;
    float rms_speed = 0;  // m/s at the end; `settled` is of before it was finished
    double simulated_seconds = 0;
    long splits = 0;
    long rejoins = 0;
    long transitions = 0;
    std::vector<double> adaption_ms;  // wall time, one per adaption
    std::vector<double> step_ms;      // wall time, one per step of the adaptive part
};

DrapeResult drape(Cloth& cloth, const Collider& body, const DrapeOptions& options, const Progress& progress);

}  // namespace selvedge
