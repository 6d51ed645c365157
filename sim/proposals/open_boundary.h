#pragma once
// The boundary of panels that are sewn in part, as chains of unsewn stretches: at the end of a seam the outline of one
// panel goes on along that of the other. After the side and shoulder seams, the armhole of front and back is one closed
// chain. Seam proposals compare such chains.
//
//        shoulder seam
//     front )|( back         ) ( are one chain, because the angles of both panels at the seam's end make 180 degrees
//           )|(
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "sim/pattern/outline.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// A stretch of an edge, as fractions of its length, from < to.
struct EdgeSpan {
    int panel = 0;
    int edge = 0;
    double from = 0;
    double to = 1;

    bool operator==(const EdgeSpan&) const = default;
};

// Unsewn stretches, each from where the last one ends, up to the next corner. A loop has no corner, or one.
struct Chain {
    std::vector<int> atoms;  // of the boundary
    double length = 0;       // m
    bool is_loop = false;
    double angle_before = 0;  // rad, inside the cloth, from the stretch before to the first one; also of a loop
    double angle_after = 0;   // rad, from the last stretch to the one after it
};

class OpenBoundary {
 public:
    // All edges of worn panels that no seam joins yet.
    explicit OpenBoundary(const Pattern& pattern);

    struct Atom {
        EdgeSpan span;
        double length = 0;  // m
        int mate = -1;      // the atom that it is sewn to: the start of one to the end of the other
    };

    const Pattern& pattern() const { return *pattern_; }
    const Atom& atom(int index) const { return atoms_[static_cast<std::size_t>(index)]; }
    int atom_count() const { return static_cast<int>(atoms_.size()); }

    // The atom after it along the unsewn boundary, and the angle inside the cloth between both, rad.
    struct Step {
        int atom = 0;
        double angle = 0;
        int seams = 0;  // that are crossed on the way
    };
    Step next(int atom) const;

    // All chains. Corners are where the angle differs from a straight line by more than `corner_angle`, rad.
    std::vector<Chain> chains(double corner_angle) const;

    // The other panels that seams join to this one, ascending.
    std::vector<int> joined_panels(int panel) const;

    // The atoms of the first panel that are sewn to the second.
    std::vector<int> atoms_between(int first, int second) const;

    // The fraction of a chain's length at which each of its atoms begins.
    std::vector<double> starts(const Chain& chain) const;

    Vec2d point(int atom, double t) const;  // at the fraction t of the atom, panel frame, m

    // Divides an atom at the fraction t of its length. The atom keeps the first part; returns the index of the second.
    int split(int atom, double t);

    // Sews two unsewn atoms, the start of one to the end of the other.
    void sew(int first, int second);

 private:
    // The points of an edge that were asked for, by the bits of their fraction of its length. A search asks for the
    // same ones again and again, and each costs many arc lengths.
    struct EdgePoints {
        EdgeLengths lengths = {};
        std::unordered_map<std::uint64_t, Vec2d> known = {};
    };
    using PanelPoints = std::vector<std::vector<EdgePoints>>;  // per panel and edge

    const OutlineEdge& edge_of(const EdgeSpan& span) const;
    Vec2d point_of_edge(const EdgeSpan& span, double t) const;
    int after_in_panel(int atom) const;
    Vec2d direction(int atom, double t) const;
    double corner_angle(int atom) const;  // inside the panel, between the atom and the next of its panel

    const Pattern* pattern_;
    std::vector<Atom> atoms_;
    std::vector<std::vector<int>> of_panel_;  // per panel: its atoms in order
    std::shared_ptr<PanelPoints> points_;     // copies share it: used by one thread
};

}  // namespace selvedge::sim
