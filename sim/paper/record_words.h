#pragma once
// Reads the words of a record of Selvedge in an SVG or DXF file, one after the other. What is missing or broken makes
// the whole record bad and reads as 0.
#include <string>
#include <string_view>

#include "sim/core/math.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

class RecordWords {
 public:
    explicit RecordWords(std::string_view text) : rest_(text) {}

    // Up to the next blank; empty: there is none.
    std::string_view word();

    // Less than a million.
    double real();

    // 0 to 100,000.
    int whole();

    Vec2d point();
    Vec3d point_in_space();

    // "3:2": a panel and an edge.
    SeamSide side();

    // What was not read yet, from the next word on.
    std::string rest() const;

    bool is_at_end() const { return rest().empty(); }
    void refuse() { is_good_ = false; }
    bool is_good() const { return is_good_; }

 private:
    int whole_of(std::string_view text);

    std::string_view rest_;
    bool is_good_ = true;
};

}  // namespace selvedge::sim
