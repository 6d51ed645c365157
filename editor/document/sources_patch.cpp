#include "editor/document/sources_patch.h"

#include <algorithm>

namespace selvedge::editor {
namespace {

// Finds the range in which two lists differ.
template <class T>
void find_range(const std::vector<T>& a, const std::vector<T>& b, std::size_t& first, std::vector<T>& before,
                std::vector<T>& after) {
    const std::size_t least = std::min(a.size(), b.size());
    while (first < least && a[first] == b[first]) ++first;
    std::size_t last = 0;  // number of equal parts at the end
    while (last < least - first && a[a.size() - 1 - last] == b[b.size() - 1 - last]) ++last;
    const auto middle = [&](const std::vector<T>& parts) {
        return std::vector<T>(parts.begin() + static_cast<std::ptrdiff_t>(first),
                              parts.end() - static_cast<std::ptrdiff_t>(last));
    };
    before = middle(a);
    after = middle(b);
}

template <class T>
void replace(std::vector<T>& parts, std::size_t first, std::size_t count, const std::vector<T>& by) {
    const auto begin = parts.begin() + static_cast<std::ptrdiff_t>(first);
    parts.insert(parts.erase(begin, begin + static_cast<std::ptrdiff_t>(count)), by.begin(), by.end());
}

}  // namespace

SourcesPatch difference(const sim::Sources& before, const sim::Sources& after) {
    SourcesPatch patch;
    find_range(before.panels, after.panels, patch.first_panel, patch.panels_before, patch.panels_after);
    find_range(before.seams, after.seams, patch.first_seam, patch.seams_before, patch.seams_after);
    if (!(before.rest == after.rest)) patch.rest.emplace(before.rest, after.rest);
    return patch;
}

void apply(sim::Sources& sources, const SourcesPatch& patch) {
    replace(sources.panels, patch.first_panel, patch.panels_before.size(), patch.panels_after);
    replace(sources.seams, patch.first_seam, patch.seams_before.size(), patch.seams_after);
    if (patch.rest) sources.rest = patch.rest->second;
}

void undo(sim::Sources& sources, const SourcesPatch& patch) {
    replace(sources.panels, patch.first_panel, patch.panels_after.size(), patch.panels_before);
    replace(sources.seams, patch.first_seam, patch.seams_after.size(), patch.seams_before);
    if (patch.rest) sources.rest = patch.rest->first;
}

}  // namespace selvedge::editor
