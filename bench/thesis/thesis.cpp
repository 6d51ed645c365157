#include "bench/thesis/thesis.h"

namespace selvedge::bench {
std::vector<Experiment> thesis_experiments() {
    return {
        {{"3.2", "3.3", "3.4", "3.5", "3.2-3.5"}, {}, measure_transition_cost},
        {{"3.6"}, {}, measure_traversal},
        {{"3.7", "3.8", "3.9", "3.10"}, {"3.21", "3.22"}, measure_uniform_refinement},
        {{"3.11"}, {}, measure_memory},
        {{"3.12", "3.13"}, {}, measure_uniform_drops, false, true},
        {{"3.1", "3.14"}, {}, measure_adaptive_drops, false, true},
        {{}, {"3.5", "3.7", "3.8"}, draw_configurations},
        {{}, {"3.1", "3.2", "3.3", "3.4", "3.6", "3.10", "3.11", "3.12", "3.13", "3.14", "3.15"}, draw_mesh_structure},
        {{}, {"3.9"}, measure_tie_breakers, false, true},
        {{}, {"3.16", "3.17", "3.18"}, draw_mesh_pictures, true},
        {{}, {"3.19"}, draw_test_pattern, true},
        {{}, {"3.20"}, draw_hanging_tartans, true},
        {{}, {"3.23", "3.24"}, measure_drop_captures, true},
        {{}, {"3.25", "3.26", "3.27", "3.28", "3.29", "3.30"}, measure_drop_timings, false, true},
        {{"listing-3.1"}, {}, measure_edge_pair},
        {{"listing-3.12", "listing-3.12-hanging"}, {}, measure_length_corrections},
        {{"listing-3.5"}, {}, list_cloth_properties},
        {{"4.1"}, {}, measure_point_search},
        {{}, {"4.1", "4.4", "4.5", "4.6", "4.9", "4.10"}, draw_seams_and_pushes},
        {{}, {"4.7", "4.8"}, draw_collision_grids, true},
        {{}, {"4.3", "4.11", "4.12", "4.13"}, draw_tshirt, false, true},
        {{"5.1"}, {}, list_character_parameters},
        {{"5.2", "5.3", "5.4", "5.4-runs"}, {"5.9"}, measure_character, false, true},
        {{}, {"5.4"}, draw_collision_section},
        {{}, {"5.1", "5.2", "5.3"}, draw_limb_frames},
        {{}, {"5.5"}, draw_cylinders, true},
        {{}, {"5.6"}, draw_timeline},
        {{}, {"5.7", "5.8"}, draw_back_faces, true},
        {{}, {"5.10", "5.11"}, measure_changing_budget},
        {{"6.1"}, {}, list_curve_weights},
        {{"6.2", "6.3"}, {"6.8", "6.9"}, measure_curved_surface, false, true},
        {{"6.4"}, {"6.7", "6.10"}, measure_dress_surface, false, true},
        {{"6.2-distance"}, {}, measure_surface_distance},
        {{}, {"6.1", "6.2", "6.3"}, draw_edge_curves},
        {{}, {"6.4"}, draw_curve_shapes},
        {{}, {"6.5"}, draw_soft_cap},
        {{}, {"6.6"}, measure_surface_lighting, true}};
}

}  // namespace selvedge::bench
