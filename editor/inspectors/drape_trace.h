#pragma once
// The last frames of a drape, for sparklines.
#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/dress/session.h"

namespace selvedge {

class DrapeTrace {
 public:
    static constexpr std::size_t kLength = 120;

    // Takes a frame that it does not have yet; one that counts from the beginning again begins anew.
    void take(const SessionFrame& frame);

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

}  // namespace selvedge
