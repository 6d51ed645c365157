#pragma once
// Several sizes of one pattern in one drawing: by layers and names that are sizes, or by outlines that lie on each
// other, each size drawn in its own colour or dashes, or all alike.
#include <string>
#include <vector>

#include "sim/paper/plain_areas.h"

namespace selvedge::sim {

struct SizeNests {
    std::vector<std::string> sizes = {};  // per area; empty: it belongs to all sizes

    // Whether two areas are of different sizes, so that neither is a line in the other.
    bool are_sizes_of_one(std::size_t a, std::size_t b) const {
        return !sizes[a].empty() && !sizes[b].empty() && sizes[a] != sizes[b];
    }
};

// Where only outlines tell, sizes are named by the texts of the drawing that are sizes, from small to large, if there
// are as many; else "1", "2" and so on.
SizeNests find_size_nests(const PlainDrawing& drawing, const std::vector<PlainArea>& areas);

}  // namespace selvedge::sim
