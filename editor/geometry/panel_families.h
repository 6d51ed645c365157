#pragma once
// Panels that are linked, as families: one is drawn, the others are derived from it. What is split or joined in one is
// split or joined in all. For update_links (linked_panels.h); for the sources of this module.
#include <optional>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// A part of an edge, between two fractions of its length in the direction of its panel's outline.
struct EdgePiece {
    sim::EdgeKey key;
    double from = 0;
    double to = 1;
    bool is_joined = false;  // it was an edge before edges were joined

    bool is_whole() const;
};

// Consecutive pieces of one outline, in its order.
using EdgePieces = std::vector<EdgePiece>;

inline constexpr double kSameFraction = 1e-6;  // of an edge's length, closer ones are one

// Adds a piece; joins it to the last one if it goes on there.
void add_piece(EdgePieces& pieces, EdgePiece piece);

// A part of an edge as it was, and what became of it.
struct EdgeHeir {
    double from = 0;
    double to = 1;
    EdgePiece piece;
};

// Pieces, or heirs of an edge, of an outline as those of one that runs the other way.
EdgePieces turned(EdgePieces pieces);
std::vector<EdgeHeir> turned(std::vector<EdgeHeir> heirs);

class PanelFamilies {
 public:
    // Pre: all panels have keys, and links lead to panels that are there.
    explicit PanelFamilies(const sim::Pattern& pattern);

    const std::vector<sim::Panel>& panels() const { return panels_; }
    const sim::Panel& panel(int panel) const { return panels_[as_size(panel)]; }
    int root_of(int panel) const { return root_[as_size(panel)]; }
    bool is_turned(int panel) const { return is_turned_[as_size(panel)]; }  // it runs the other way than its root

    // The panels with this root, itself first.
    std::vector<int> members(int root) const;

    // The root becomes what gives this panel, which is `shown`, and all of the family what the root gives. The panels'
    // own fields stay.
    void put(int panel, const sim::Panel& shown);

    // The panel was mirrored in its plane, and so is its place on the cloth.
    void turn_on_cloth(int panel) { panels_[as_size(panel)].sett_offset.x() *= -1; }

    // Splits an edge in the whole family, at fractions in the direction of `panel`, ascending. Returns the parts in
    // that direction.
    EdgePieces split(int panel, const sim::EdgeKey& key, std::vector<double> fractions);

    // Joins consecutive edges, in the order of `panel`, to one in the whole family. Returns the part of the joined edge
    // that each was, in that order. None, and nothing changed, if they meet in a corner or in a pinned point.
    std::optional<EdgePieces> join(int panel, const EdgePieces& edges);

 private:
    void derive(int root);
    void derive_panel(int panel, std::vector<bool>& is_done);

    std::vector<sim::Panel> panels_;
    std::vector<std::optional<int>> source_;
    std::vector<int> root_;
    std::vector<bool> is_turned_;
};

}  // namespace selvedge::editor
