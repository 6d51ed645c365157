#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "sim/core/json.h"
#include "sim/core/math.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_read.h"
#include "sim/pattern/topstitch_check.h"

namespace selvedge::sim {
namespace {

constexpr double kSeamTolerance = 1e-3;  // m, larger length differences between a seam's sides are reported

std::string in_file_units(const Vec2d& p, const Panel& panel, double units) {
    const auto text = [&](double value) { return Json(std::round(value * units * 1e3) / 1e3 + 0.0).number_text(); };
    return "(" + text(panel.is_mirrored ? -p.x() : p.x()) + ", " + text(p.y()) + ")";
}

class ShapeChecker {
 public:
    ShapeChecker(PatternReading& reading, std::string file, double units)
        : reading_(reading), file_(std::move(file)), units_(units) {}

    void check() {
        for (std::size_t i = 0; i < reading_.pattern.panels.size(); ++i) {
            if (reading_.is_sound[i]) check_panel(reading_.pattern.panels[i], reading_.places[i]);
        }
        for (std::size_t i = 0; i < reading_.pattern.seams.size(); ++i) check_seam(i);
    }

 private:
    void add(Severity severity, std::string place, std::string problem) {
        reading_.faults.push_back({severity, file_, std::move(place), std::move(problem)});
    }

    void check_panel(const Panel& panel, const std::string& place) {
        const std::string edges = json_path(place, "edges");
        bool has_length = true;
        for (std::size_t i = 0; i < panel.edges.size(); ++i) {
            if (outline_length(panel, panel.edges[i]) >= kShortestEdge) continue;
            add(Severity::Error, json_path(edges, i), "the edge has no length");
            has_length = false;
        }
        if (!has_length) return;
        check_crossings(panel, edges);
        for (std::size_t i = 0; i < panel.edges.size(); ++i)
            warn_of(topstitch_problem(panel, panel.edges[i]), json_path(edges, i) + ".selvedge.topstitch");
        for (std::size_t i = 0; i < panel.internal_lines.size(); ++i) {
            warn_of(topstitch_problem(panel, panel.internal_lines[i]),
                    json_path(place + ".selvedge.internal_lines", i) + ".topstitch");
        }
    }

    void warn_of(const std::optional<std::string>& problem, const std::string& place) {
        if (problem) add(Severity::Warning, place, *problem);
    }

    void check_crossings(const Panel& panel, const std::string& edges) {
        for (const OutlineCrossing& crossing : find_outline_crossings(panel)) {
            add(Severity::Error, json_path(edges, crossing.first),
                "the outline crosses or touches itself: edges " + std::to_string(crossing.first) + " and " +
                    std::to_string(crossing.second) + " meet near " + in_file_units(crossing.place, panel, units_));
        }
    }

    void check_seam(std::size_t i) {
        const Seam& seam = reading_.pattern.seams[i];
        const auto length = [&](const SeamSide& side) {
            const Panel& panel = reading_.pattern.panels[static_cast<std::size_t>(side.panel)];
            return outline_length(panel, panel.edges[static_cast<std::size_t>(side.edge)]);
        };
        for (const SeamSide& side : {seam.first, seam.second}) {
            if (!reading_.is_sound[static_cast<std::size_t>(side.panel)]) return;
        }
        const double first = length(seam.first);
        const double second = length(seam.second);
        if (std::min(first, second) >= kShortestEdge)
            warn_of(topstitch_problem(reading_.pattern, seam), place_of_seam(i));
        const double difference = std::abs(first - second);
        if (difference <= kSeamTolerance) return;
        std::array<char, 160> text{};
        std::snprintf(text.data(), text.size(), "the sides differ by %.1f mm (%.1f and %.1f, ratio %.2f)",
                      1e3 * difference, 1e3 * first, 1e3 * second, std::max(first, second) / std::min(first, second));
        const bool is_absurd = std::max(first, second) > kMaxGatherRatio * std::min(first, second);
        if (seam.is_eased && !is_absurd) return;
        add(is_absurd ? Severity::Error : Severity::Warning, place_of_seam(i), text.data());
    }

    std::string place_of_seam(std::size_t i) const {
        return json_path("pattern.stitches", static_cast<std::size_t>(reading_.seam_indices[i]));
    }

    PatternReading& reading_;
    std::string file_;
    double units_;
};

}  // namespace

void check_shapes(PatternReading& reading, const std::string& file, double units) {
    ShapeChecker(reading, file, units).check();
}

}  // namespace selvedge::sim
