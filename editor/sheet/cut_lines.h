#pragma once
// The cut lines of panels with seam allowances, kept until the panel or its allowance changes.
#include <map>
#include <string>
#include <vector>

#include "sim/paper/cut_line.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

class CutLines {
 public:
    // null: no edge of the panel has an allowance. Valid until the next call for this panel. The panel may differ from
    // the pattern's of the same name, while it is edited.
    const sim::CutLine* find(const sim::Panel& panel, const sim::Pattern& pattern);

 private:
    struct Kept {
        sim::Panel panel{};
        double pattern_allowance = 0;
        std::vector<sim::Dart> darts{};
        sim::CutLine line{};
    };
    std::map<std::string, Kept> kept_;
};

}  // namespace selvedge::editor
