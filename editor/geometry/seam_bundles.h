#pragma once
// Seams while the outlines of linked panels change under them. A seam is a bundle: on either side, pieces of edges by
// their keys. Where one side is divided and the other is not, the other is divided too, in its whole family; and so on.
// For update_links (linked_panels.h); for the sources of this module.
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "editor/geometry/panel_families.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

struct BundleSide {
    int panel = 0;
    EdgePieces pieces;  // empty: what was sewn is no more
};

struct SeamBundle {
    sim::Seam seam;  // what it has besides its sides, and is_reversed
    BundleSide first;
    BundleSide second;
    bool wants_join = false;  // the edges of the longer side are to be joined, or the seam ends
};

struct BundledSeams {
    std::vector<std::optional<sim::Seam>> kept;  // per bundle; none: it ended
    std::vector<sim::Seam> parts;                // of seams that were divided: all but the first, without names
};

class SeamBundles {
 public:
    // families: what is split and joined.
    SeamBundles(PanelFamilies& families, std::vector<SeamBundle> bundles)
        : families_(families), bundles_(std::move(bundles)) {}

    // The seams on the families' panels as they then are. Throws GeometryError if splits would never end.
    BundledSeams seams();

 private:
    bool merge_joined();
    void merge_group(int panel, const sim::EdgeKey& key);
    bool split_partial();
    bool even_one();
    bool has_run(const BundleSide& side) const;
    void end(SeamBundle& bundle);
    std::pair<std::vector<double>, double> joints_of(const BundleSide& side) const;
    bool divide(const BundleSide& side, const BundleSide& other, bool is_reversed);
    void split(int panel, const sim::EdgeKey& key, std::vector<double> fractions);
    bool join(const BundleSide& run);
    // Replaces pieces of edges of the panel's family: `become` has, for a whole edge, the pieces in the direction of
    // `panel`.
    void replace(int panel, const std::function<const EdgePieces*(const sim::EdgeKey&)>& become);
    double length_of(int panel, const EdgePiece& piece) const;
    sim::SeamSide side_at(const BundleSide& side, std::size_t piece) const;

    PanelFamilies& families_;
    std::vector<SeamBundle> bundles_;
};

// What the parts of `piece` are where the whole edge becomes `heirs`.
EdgePieces heirs_of(const EdgePiece& piece, const std::vector<EdgeHeir>& heirs);

}  // namespace selvedge::editor
