#pragma once
// The outlines of a DXF piece among its lines: closed, or joined of several that meet; and its lines as drawn paths.
#include <optional>

#include "sim/paper/closed_chains.h"
#include "sim/paper/drawing.h"
#include "sim/paper/dxf_entities.h"

namespace selvedge::sim {

// The diagonal of a line's box; how far its ends lie apart.
double extent_of(const DxfLine& line);
double gap_of(const DxfLine& line);

// The largest closed line of a layer; null: it has none.
const DxfLine* largest_closed(const DxfPiece& piece, int layer);

// Layer 14, or a closed line on layer 8 that is nearly as large as the boundary; null: there is none.
const DxfLine* find_sewing_line(const DxfPiece& piece);

// What joining did, summed up over pieces.
struct DxfJoints {
    std::size_t outlines = 0;
    double widest_gap = 0;
};

// Joins what is open on the layers of boundaries, sewing lines and cutouts. Ends up to `gap` apart meet. A sewing line
// that ends on the boundary, as of a half whose fold has no allowance, goes on along it.
void join_outlines(DxfPiece& piece, double gap, DxfJoints& joints);

// Joins the open lines of a drawing without blocks, those of one style first.
void join_loose(DxfPiece& loose, double gap, DxfJoints& joints);

// A line as it is: files of Selvedge have the curves of outlines as records, and their other lines stay polylines.
DrawnPath as_drawn(const DxfLine& line, LineKind kind);

// A line with curves between its corners: the turn points of layer 2 if the piece has them, else those that the line
// has, else found by its turns.
DrawnPath path_of(const DxfPiece& piece, const DxfLine& line, LineKind kind,
                  const std::optional<double>& metres_per_unit);

}  // namespace selvedge::sim
