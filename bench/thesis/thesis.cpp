#include "bench/thesis/thesis.h"

namespace selvedge::bench {
std::vector<Experiment> thesis_experiments() {
    return {{{"3.2", "3.3", "3.4", "3.5", "3.2-3.5"}, {}, measure_transition_cost},
            {{"3.6"}, {}, measure_traversal},
            {{"3.7", "3.8", "3.9", "3.10"}, {"3.21", "3.22"}, measure_uniform_refinement},
            {{"3.11"}, {}, measure_memory},
            {{"3.12", "3.13"}, {}, measure_uniform_drops},
            {{"3.1", "3.14"}, {}, measure_adaptive_drops},
            {{}, {"3.9"}, measure_tie_breakers},
            {{}, {"3.23", "3.24"}, measure_drop_captures, true},
            {{}, {"3.25", "3.26", "3.27", "3.28", "3.29", "3.30"}, measure_drop_timings},
            {{"4.1"}, {}, measure_point_search},
            {{"6.2", "6.3"}, {"6.2", "6.3"}, measure_curved_surface, false, true},
            {{"6.2-distance"}, {}, measure_surface_distance},
            {{}, {"6.4", "6.5"}, measure_curve_modifiers},
            {{}, {"6.6"}, measure_surface_lighting, true}};
}

}  // namespace selvedge::bench
