#pragma once
// Text for the state and statistics of a drape, and the recent history that its inspector plots.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "sim/session/session.h"

namespace selvedge::editor {

// For example "Sewing: seams close" or "Settled: at rest".
std::string stage_sentence(sim::SessionStage stage, bool is_running);

// For example "3.2 s", "1.40 ms", "0.8 cm/s".
std::string seconds_text(double seconds);
std::string milliseconds_text(double milliseconds);
std::string speed_text(double metres_per_second);

// For example "1,234".
std::string count_text(int count);

// Sets the split or rejoin angle (rad) and keeps the rejoin angle below the split angle.
sim::CurvatureOptions curvature_with(sim::CurvatureOptions options, std::optional<double> split,
                                     std::optional<double> rejoin);

// A name that is not in `kept` yet: "drape", "drape 2".
std::string free_drape_name(const std::vector<std::string>& kept, const std::string& wanted);

// Statistics of the last kLength frames of a drape, for sparklines.

class DrapeTrace {
 public:
    static constexpr std::size_t kLength = 120;

    // Appends the frame unless it is already the newest one. Clears the history if the frame numbers start again.
    void take(const sim::SessionFrame& frame);

    std::size_t size() const { return size_; }

    // Index 0 is the oldest. Pre: index < size().
    float frame_ms(std::size_t index) const { return rows_[place(index)].frame_ms; }
    float triangles(std::size_t index) const { return rows_[place(index)].triangles; }

 private:
    struct Row {
        float frame_ms = 0;
        float triangles = 0;
    };

    std::size_t place(std::size_t index) const { return (first_ + index) % kLength; }

    std::array<Row, kLength> rows_{};
    std::size_t first_ = 0;
    std::size_t size_ = 0;
    std::uint64_t last_number_ = 0;
};

}  // namespace selvedge::editor
