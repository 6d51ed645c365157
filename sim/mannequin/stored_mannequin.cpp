#include "sim/mannequin/stored_mannequin.h"

#include <utility>

namespace selvedge::sim {

MadeBody stored_mannequin(const MannequinOptions& options, const ContentStore* store) {
    return stored_body(made_from(options), store, [&] {
        Mannequin made = make_mannequin(options);
        return MadeBody{.body = std::move(made.body), .notes = std::move(made.report.messages)};
    });
}

}  // namespace selvedge::sim
