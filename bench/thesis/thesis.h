#pragma once
// The experiments of the thesis' chapters 3, 4 and 6, named by the table and figure numbers of the thesis.
#include <filesystem>
#include <string>
#include <vector>

#include "bench/support/table.h"
#include "render/image/image.h"

namespace selvedge::bench {

struct ThesisOptions {
    bool is_quick = false;  // small sizes and one run each, as a smoke test; the times are not meaningful
};

struct Capture {
    std::string name;    // of the figure, such as "3.23"
    std::string moment;  // such as "0.4s"
    render::Image image;
};

struct ThesisResult {
    std::vector<Table> tables;
    std::vector<Figure> figures;
    std::vector<Capture> captures;
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

// Defined in mesh_tables.cpp (transition cost, traversal, uniform refinement, memory, tie breakers), drop_tables.cpp
// (drops), point_search.cpp, and surface_tables.cpp (curved surface).
ThesisResult measure_transition_cost(const ThesisOptions& options);
ThesisResult measure_traversal(const ThesisOptions& options);
ThesisResult measure_uniform_refinement(const ThesisOptions& options);
ThesisResult measure_memory(const ThesisOptions& options);
ThesisResult measure_uniform_drops(const ThesisOptions& options);
ThesisResult measure_adaptive_drops(const ThesisOptions& options);
ThesisResult measure_tie_breakers(const ThesisOptions& options);
ThesisResult measure_drop_captures(const ThesisOptions& options);
ThesisResult measure_drop_timings(const ThesisOptions& options);
ThesisResult measure_point_search(const ThesisOptions& options);
ThesisResult measure_curved_surface(const ThesisOptions& options);
ThesisResult measure_surface_distance(const ThesisOptions& options);
ThesisResult measure_curve_modifiers(const ThesisOptions& options);
ThesisResult measure_surface_lighting(const ThesisOptions& options);

}  // namespace selvedge::bench
