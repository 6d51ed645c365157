#include "editor/drafting/sheet_layout.h"

#include <algorithm>

#include "editor/drafting/edge_shape.h"

namespace selvedge {
namespace {

constexpr double kGap = 0.05;       // m, between panels
constexpr double kRowLength = 1.4;  // m, a panel that would reach further begins a row

}  // namespace

// All panels take part, so that one that is put elsewhere leaves the others where they are.
std::vector<Vec2d> sheet_positions(const Pattern& pattern) {
    std::vector<Vec2d> positions;
    Vec2d corner(0, 0);  // upper left of the next
    double depth = 0;    // of the row
    for (const Panel& panel : pattern.panels) {
        const Box box = outline_box(panel);
        const Vec2d size = box.high - box.low;
        if (corner.x() > 0 && corner.x() + size.x() > kRowLength) {
            corner = {0, corner.y() - depth - kGap};
            depth = 0;
        }
        const Vec2d laid_out = corner - Vec2d(box.low.x(), box.high.y());
        positions.push_back(panel.sheet_position.value_or(laid_out));
        corner.x() += size.x() + kGap;
        depth = std::max(depth, size.y());
    }
    return positions;
}

}  // namespace selvedge
