#pragma once
// The pieces of a pattern laid out on one large sheet of paper, or on cloth as they are cut (a cutting layout), and
// what is drawn of them there. Sheet coordinates: m, x to the right, y up, the lower left corner at the origin.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/print/nesting.h"
#include "sim/print/paper_piece.h"

namespace selvedge::sim {

using LayerChoice = std::array<bool, kPaperLayers>;  // by PaperLayer
inline constexpr LayerChoice kAllLayers{true, true, true, true, true, true, true, true};

struct PaperSheet {
    std::string title = {};
    std::vector<PaperPiece> pieces = {};
    std::vector<NestPlace> places = {};  // as the pieces
    Vec2d size = Vec2d::Zero();          // m
    std::uint64_t work = 0;              // of the search for places (Nest)

    // Of a cutting layout only.
    std::string fabric = {};
    std::optional<Vec2d> repeat = {};     // m, of the sett that begins at the origin
    bool is_folded = false;               // the fabric is folded along x = 0, and cut through both layers
    std::vector<std::string> notes = {};  // what the cutter has to know
};

// A line as it is drawn.
struct PaperStroke {
    PaperLayer layer = PaperLayer::Cut;
    std::vector<Vec2d> points;  // m, sheet coordinates
    bool is_closed = false;
    bool is_fold_edge = false;  // see PaperLine
};

// Of a piece in its own frame. Where there is no allowance the sewing line is left to the cut line, if that is drawn.
std::vector<PaperStroke> strokes_of(const PaperPiece& piece, const LayerChoice& layers = kAllLayers);

// Of all pieces, placed.
std::vector<PaperStroke> strokes_of(const PaperSheet& sheet, const LayerChoice& layers = kAllLayers);

// All pieces on a sheet of paper as wide as `width`, m; wider if a piece is. Of `search`, orders and most_work count.
PaperSheet paper_sheet(const Pattern& pattern, const std::vector<PaperPiece>& pieces, double width,
                       const NestOptions& search = {});

struct CuttingOptions {
    double width = 1.5;       // m, of the fabric
    double gap = 0.005;       // m, between pieces
    bool is_one_way = false;  // all pieces point one way, as for velvet; otherwise they may be turned upside down
    bool is_folded = false;   // in half, along its length: pairs are cut together, symmetric panels on the fold
    std::string fabric = {};  // of panels that name none
};

// One layout for each fabric that the panels name, in the order of the panels. Panels of a matched sett keep their
// phase: their material coordinates differ from those of the fabric by whole repeats. Throws InputError if a panel is
// wider than the fabric.
std::vector<PaperSheet> cutting_layouts(const Pattern& pattern, const CuttingOptions& options);

}  // namespace selvedge::sim
