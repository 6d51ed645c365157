#pragma once
// What the tab Objects lists of a pattern: panels in groups, their parts, and seams; and what of it has a wanted name.
#include <string>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

enum class PanelGrouping { Garments, Fabrics };

enum class PartKind { InternalLine, Dart, Edge };

struct ListedPart {
    PartKind kind = PartKind::Edge;
    int index = 0;  // of the panel's internal line or edge; dart: of the seam
    std::string title{};
};

struct ListedPanel {
    int index = 0;                    // in Pattern::panels
    bool is_found = true;             // by its own name; all its parts are listed then, otherwise only those found
    std::vector<ListedPart> parts{};  // internal lines, then darts, then edges
};

struct PanelGroup {
    std::string name{};  // of the garment or the fabric
    std::vector<ListedPanel> panels{};
};

struct ObjectTree {
    std::vector<PanelGroup> groups{};  // garments: the outermost first; fabrics: by name
    std::vector<int> seams{};          // indices into Pattern::seams, without darts; one of each sewing

    // How many have the wanted name. Edges count by their labels.
    int panels = 0;
    int internal_lines = 0;
    int darts = 0;
    int edges = 0;
    int found_seams() const { return static_cast<int>(seams.size()); }
};

// `wanted`: words that must all be in a name; empty: everything is listed.
ObjectTree list_objects(const sim::Pattern& pattern, PanelGrouping grouping, const std::string& wanted);

// "2 panels, 1 dart and 3 seams"; without edges if nothing was wanted.
std::string count_text(const ObjectTree& tree, const std::string& wanted);

// Whether it sews two edges of one panel that meet at a point.
bool is_dart(const sim::Pattern& pattern, const sim::Seam& seam);

}  // namespace selvedge::editor
