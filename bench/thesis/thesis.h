#pragma once
// The experiments of the thesis' chapters 3 to 6, named by the table and figure numbers of the thesis.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bench/support/table.h"
#include "render/image/image.h"
#include "sim/body/body.h"
#include "sim/body/clip.h"

namespace selvedge::bench {

inline constexpr int kStepsPerFrame = 4;  // of the cloth, in a frame of 1/30 s

struct ThesisOptions {
    bool is_quick = false;  // small sizes and one run each, as a smoke test; the times are not meaningful
    std::filesystem::path tshirt = "patterns/tshirt_thesis.json";  // of figures 4.3 and 4.11-4.13
    std::filesystem::path dress = "patterns/dress.json";           // of chapter 5 and experiment C of chapter 6
    std::shared_ptr<const sim::Body> body{};  // that wears it, with bones and a skin; none: the mannequin, which walks
    sim::Clip motion{};                       // of that body
};

struct Capture {
    std::string name;    // of the figure, such as "3.23"
    std::string moment;  // such as "0.4s"
    render::Image image;
};

// An SVG document that is drawn directly, not from a series.
struct Drawing {
    std::string name;  // of the figure, such as "6.4"
    std::string title;
    std::string svg;
};

// Whether a run shows what the thesis reports, decided from the run's numbers.
struct Trend {
    std::string item;      // short_name() of the caption, such as "T3.5"
    std::string reported;  // what the thesis reports, a sentence
    std::string measured;  // what the numbers say, a sentence
    bool agrees = false;
};

struct ThesisResult {
    std::vector<Table> tables{};
    std::vector<Figure> figures{};
    std::vector<Capture> captures{};
    std::vector<Drawing> drawings{};
    std::vector<Trend> trends{};
};

// A group of tables and figures that are measured together. Their names are listed first, so that only the requested
// experiments run.
struct Experiment {
    std::vector<std::string> tables;
    std::vector<std::string> figures;
    ThesisResult (*measure)(const ThesisOptions&);
    bool makes_pictures_only = false;
    bool draws = false;  // needs a renderer
};

std::vector<Experiment> thesis_experiments();

// Chapter 3: mesh_tables.cpp, traversal.cpp, edge_pair_mesh.cpp, tie_breakers.cpp, drop_tables.cpp,
// configuration_drawings.cpp, mesh_drawings.cpp, mesh_pictures.cpp, length_corrections.cpp, cloth_property.cpp.
ThesisResult measure_transition_cost(const ThesisOptions& options);
ThesisResult measure_traversal(const ThesisOptions& options);
ThesisResult measure_uniform_refinement(const ThesisOptions& options);
ThesisResult measure_memory(const ThesisOptions& options);
ThesisResult measure_uniform_drops(const ThesisOptions& options);
ThesisResult measure_adaptive_drops(const ThesisOptions& options);
ThesisResult measure_edge_pair(const ThesisOptions& options);
ThesisResult measure_tie_breakers(const ThesisOptions& options);
ThesisResult measure_drop_captures(const ThesisOptions& options);
ThesisResult measure_drop_timings(const ThesisOptions& options);
ThesisResult draw_configurations(const ThesisOptions& options);
ThesisResult draw_mesh_structure(const ThesisOptions& options);
ThesisResult draw_mesh_pictures(const ThesisOptions& options);
ThesisResult draw_test_pattern(const ThesisOptions& options);
ThesisResult draw_hanging_tartans(const ThesisOptions& options);
ThesisResult measure_length_corrections(const ThesisOptions& options);
ThesisResult list_cloth_properties(const ThesisOptions& options);

// Chapter 4: point_search.cpp, collision_grid_pictures.cpp, garment_pictures.cpp, garment_drawings.cpp.
ThesisResult measure_point_search(const ThesisOptions& options);
ThesisResult draw_collision_grids(const ThesisOptions& options);
ThesisResult draw_tshirt(const ThesisOptions& options);
ThesisResult draw_seams_and_pushes(const ThesisOptions& options);

// Chapter 5: character_tables.cpp, collision_section.cpp, limb_drawings.cpp.
ThesisResult list_character_parameters(const ThesisOptions& options);
ThesisResult measure_character(const ThesisOptions& options);
ThesisResult draw_limb_frames(const ThesisOptions& options);
ThesisResult draw_cylinders(const ThesisOptions& options);
ThesisResult draw_collision_section(const ThesisOptions& options);
ThesisResult draw_timeline(const ThesisOptions& options);
ThesisResult draw_back_faces(const ThesisOptions& options);
ThesisResult measure_changing_budget(const ThesisOptions& options);

// Chapter 6: surface_tables.cpp, curve_figures.cpp, dress_surface.cpp.
ThesisResult measure_dress_surface(const ThesisOptions& options);
ThesisResult measure_curved_surface(const ThesisOptions& options);
ThesisResult measure_surface_distance(const ThesisOptions& options);
ThesisResult list_curve_weights(const ThesisOptions& options);
ThesisResult draw_edge_curves(const ThesisOptions& options);
ThesisResult draw_curve_shapes(const ThesisOptions& options);
ThesisResult draw_soft_cap(const ThesisOptions& options);
ThesisResult measure_surface_lighting(const ThesisOptions& options);

}  // namespace selvedge::bench
