#pragma once
// What is drawn of a panel on paper, in the panel frame, m: the line along which it is cut, the sewing line, fold
// lines, the grain line, notches, drill points, internal lines and the label. All files for paper are made of it.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/paper/cut_line.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

enum class PaperLayer { Cut, Sew, Fold, Grain, Notches, Drill, Internal, Labels };
inline constexpr int kPaperLayers = 8;

// "cut", "sew", "fold", "grain", "notches", "drill", "internal", "labels".
std::string_view layer_name(PaperLayer layer);
std::optional<PaperLayer> find_layer(std::string_view name);

struct PaperLine {
    PaperLayer layer = PaperLayer::Internal;
    std::vector<Vec2d> points;
    bool is_dart_fold = false;  // from a dart's tip to its cap
    bool is_fold_edge = false;  // the piece is cut on it, on folded fabric
};

// Lines of text round a point.
struct PaperLabel {
    std::vector<std::string> lines = {};
    Vec2d at = Vec2d::Zero();  // m, the middle
    double height = 0;         // m, from one line to the next
    bool runs_up = false;      // the text runs up the panel, as on a narrow strip

    // The angle of its text, rad, counter-clockwise, on a sheet on which the panel is turned: read from below or from
    // the right.
    double angle(double turn = 0) const;
};

// What the lines of a label cover, in the panel frame, m.
Eigen::AlignedBox2d label_box(const PaperLabel& label);

// About the width of a line of text over its height: that of a mean of sans-serif faces.
double text_width(std::string_view line);

struct PaperPiece {
    int panel = 0;                // index into Pattern::panels
    int cut_from_fabric = 1;      // pieces, mirror images included that are not drawn themselves
    std::vector<Vec2d> cut = {};  // closed; along the sewing line where there is no allowance
    std::vector<Vec2d> sew = {};  // closed
    bool has_allowance = false;
    bool is_on_fold = false;                  // half of it is drawn; the other lies beyond its fold line
    std::vector<NotchLine> notches = {};      // as Panel::notches, if it is whole
    std::vector<NotchLine> leg_notches = {};  // where the legs of darts, carried on, meet the cut line
    std::vector<PaperLine> lines = {};        // grain line, folds, internal lines
    std::vector<Vec2d> drill_points = {};
    PaperLabel label = {};

    Eigen::AlignedBox2d box() const;  // of the cut line
};

struct PaperPieceOptions {
    bool draws_mirror_images = true;  // false: a panel and its mirror image are one piece, "cut 1 pair"
    bool are_halved = false;          // symmetric panels with an upright grain are drawn as the half to cut on a fold
    double chord_error = 2e-5;        // m
};

// The x of the upright axis in which a closed line is its own mirror image, within 0.5 mm; none if it is not.
std::optional<double> fold_axis(const std::vector<Vec2d>& line);

// The part of a closed line at or to the right of an upright.  (Sutherland and Hodgman 1974)
std::vector<Vec2d> right_of(const std::vector<Vec2d>& line, double x);

// Moves the label to where the panel has room for it in one of the boxes, panel frame, m: clear of what is drawn
// inside, and no smaller than half its size. It stays if it lies in one already, or if none has room.
void move_label(PaperPiece& piece, const std::vector<Eigen::AlignedBox2d>& boxes);

std::vector<PaperPiece> paper_pieces(const Pattern& pattern, const PaperPieceOptions& options = {});

}  // namespace selvedge::sim
