#include "sim/dress/made_body.h"

#include <utility>

#include "sim/mannequin/stored_mannequin.h"
#include "sim/pattern/pattern.h"
#include "sim/repair/stored_body.h"

namespace selvedge::sim {

MadeBody make_body(const std::string& source, const LoadBodyOptions& load, const ContentStore* store) {
    MadeBody made;
    if (is_body_file(source)) {
        BodyClips content = load_stored_body(source, load, store, made.notes);
        made.body = std::make_shared<const Body>(std::move(content.body));
        made.clips = std::move(content.clips);
    } else {
        made = make_body(parse_mannequin(source), store);
    }
    made.source = source;
    return made;
}

MadeBody make_body(const MannequinOptions& options, const ContentStore* store) {
    Mannequin mannequin = stored_mannequin(options, store);
    return {.body = std::make_shared<const Body>(std::move(mannequin.body)),
            .notes = std::move(mannequin.report.messages),
            .readings = std::move(mannequin.report)};
}

}  // namespace selvedge::sim
