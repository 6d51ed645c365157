#pragma once
// A drape's state in words.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "sim/dress/session.h"

namespace selvedge::editor {

// "Sewing: seams close", "Settled: it hangs still".
std::string stage_text(sim::SessionStage stage, bool is_running);

// "3.2 s", "1.40 ms", "0.8 cm/s".
std::string seconds_text(double seconds);
std::string milliseconds_text(double milliseconds);
std::string speed_text(double metres_per_second);

// "1,234".
std::string count_text(int count);

// Angles that the criteria can be asked with: rejoining stays below splitting.
sim::CurvatureOptions curvature_with(sim::CurvatureOptions options, std::optional<double> split,
                                     std::optional<double> rejoin);

// A name that is not among those yet: "drape", "drape 2".
std::string free_drape_name(const std::vector<std::string>& kept, const std::string& wanted);

// The last frames of a drape, for sparklines.

class DrapeTrace {
 public:
    static constexpr std::size_t kLength = 120;

    // Takes a frame that it does not have yet; one that counts from the beginning again begins anew.
    void take(const sim::SessionFrame& frame);

    std::size_t size() const { return size_; }

    // The oldest is 0. Pre: index < size().
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
