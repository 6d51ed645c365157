#pragma once
// The pieces of a DXF file: its blocks, as the drawing and other blocks place them.
#include <string>
#include <vector>

#include "sim/paper/dxf_entities.h"

namespace selvedge::sim {

// Without the place at which a block stands: its scale, its turn and its mirroring count. A block that holds lines of
// its own takes in the blocks that it places; one that only places others is a layout, and they are pieces. A file that
// places nothing has all its blocks as pieces. Where it places some, a block that it does not place is left out, unless
// it says "Piece Name", as pattern programs do; so is one of a file whose outlines lie beside its blocks (has_loose).
// Throws InputError for blocks that place each other without end.
std::vector<DxfPiece> placed_pieces(const std::vector<DxfPiece>& blocks, const std::vector<DxfInsert>& inserts,
                                    bool has_loose, const std::string& file, std::vector<std::string>& notes);

}  // namespace selvedge::sim
