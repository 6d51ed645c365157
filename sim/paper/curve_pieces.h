#pragma once
// Lines and cubic Beziers of a path one by one: cut at a box, and put together again where they were cut.
#include <array>
#include <vector>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

struct CurvePiece {
    bool is_line = true;
    std::array<Vec2d, 4> p = {Vec2d::Zero(), Vec2d::Zero(), Vec2d::Zero(), Vec2d::Zero()};  // of a line: 0 and 3

    Vec2d at(double t) const;
    Vec2d leaves() const;   // the direction at its start, of length 1
    Vec2d arrives() const;  // and at its end
    CurvePiece reversed() const;
};

// Pre: the path has lines and cubic curves only.
std::vector<CurvePiece> pieces_of(const DrawnPath& path);
// The path with these pieces, each from where the last one ends. All else is that of `like`.
DrawnPath path_of(const std::vector<CurvePiece>& pieces, bool is_closed, const DrawnPath& like);

// The runs of pieces within a box. Of a closed path, lines along the border are no part of them: a program that cuts
// outlines at a page closes them there.
struct CutRuns {
    std::vector<std::vector<CurvePiece>> runs = {};
    bool is_whole = false;  // nothing was cut off: there is one run, and it is closed if the path is
};
CutRuns cut_to_box(const DrawnPath& path, const Eigen::AlignedBox2d& box);

// Appends pieces to a run that ends where they begin, nearly: two parts of one line, or of one curve, become one.
void append_pieces(std::vector<CurvePiece>& run, const std::vector<CurvePiece>& more);
// Likewise joins the ends of a run, which closes it.
void close_pieces(std::vector<CurvePiece>& run);

}  // namespace selvedge::sim
