#include "sim/dress/worn_together.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "sim/core/error.h"
#include "sim/dress/anchor.h"
#include "sim/pattern/garments.h"

namespace selvedge::sim {

Pattern worn_together(Pattern pattern, std::span<const Pattern> over, const std::string& file,
                      std::vector<std::string>& notes) {
    for (const Pattern& one : over) {
        const Pattern outer = moved_to_body_of(pattern, one, notes);
        std::ranges::move(put_over(pattern, outer), std::back_inserter(notes));
        pattern.name += " + " + outer.name;
    }
    if (std::ranges::none_of(pattern.panels, &Panel::is_worn))
        throw InputError(file, "pattern.panels", "no panel that is worn: nothing to dress");
    return pattern;
}

}  // namespace selvedge::sim
