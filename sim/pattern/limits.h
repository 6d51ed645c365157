#pragma once
// The largest values that a pattern and its panels may have. The reader of pattern files and the editor share them, so
// that whatever the editor makes can be opened again.
#include <string>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct LimitFault {
    std::string place;    // the value's key in a pattern file, from its panel on: "selvedge.layer"
    std::string problem;  // message for the user
};

// The values of the panel that are too large or not finite, but for those of its outline (read_outline() in
// sim/pattern/pattern_read.h, check_edit() in editor/geometry/draft.h).
std::vector<LimitFault> limit_faults(const Panel& panel);

// The same of a seam, and of the pattern's own fields, without its panels and seams. Places are keys.
std::vector<LimitFault> limit_faults(const Seam& seam);
std::vector<LimitFault> limit_faults(const Pattern& pattern);

inline constexpr double kLeastConeSine = 0.01;  // of a WrapCone: a sharper needle would wind the cloth round itself
inline constexpr double kLeastBodyHeight = 0.3, kGreatestBodyHeight = 3;  // m

// Edge lengths of a base mesh, m. Fewer than two of the longest ones cannot go round a leg, of 55 cm.
inline constexpr double kShortestMeshEdge = 0.005, kLongestMeshEdge = 0.3;
inline constexpr const char* kMeshEdgesText = "0.5 to 30 cm";

// The problem of a layer beyond kHighestLayer, as text.
std::string layer_problem();

}  // namespace selvedge::sim
