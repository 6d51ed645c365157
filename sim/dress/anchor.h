#pragma once
// Moves a pattern's panels from the body that they were placed for to the one that is dressed. The pattern names a
// mannequin, a body file in whose own frame the panels are placed, or nothing: then they were placed for GarmentCode's
// mean body (patterns/FORMAT.md).
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/body/body.h"
#include "sim/pattern/pattern.h"
#include "sim/place/measured_body.h"

namespace selvedge::sim {

class ContentStore;

// The body that the pattern's panels were placed for, in the frame in which they were placed. Throws InputError for an
// unknown mannequin, and for a file as load_body() does. store: where it may be found and is kept; null for none.
Body placed_for(const Pattern& pattern, const ContentStore* store = nullptr);

// Throws InputError if placed_for() would. Makes a coarse mannequin, and reads a body file.
void check_placed_for(const Pattern& pattern);

struct AnchoredPattern {
    Pattern pattern;
    Pattern designed;                            // as it was placed, in the frame of ...
    const MeasuredBody* designed_for = nullptr;  // ... the body that it was placed for; until the next call of anchor()
    std::vector<std::string> notes;              // one sentence per assumption
};

// Keeps the body that was named last, because it is slow to make.
class PatternAnchor {
 public:
    // store: where bodies may be found and are kept; null for none. It must outlive the anchor.
    explicit PatternAnchor(const ContentStore* store = nullptr) : store_(store) {}

    // Does not change a pattern that was placed for an equal body. Throws InputError for an unknown mannequin. If the
    // named file cannot be read, a note says so, and the panels are taken as placed for GarmentCode's body.
    AnchoredPattern anchor(const Pattern& pattern, const MeasuredBody& measured);

 private:
    const MeasuredBody& named(const std::string& text, const Pattern& pattern);

    struct NamedBody {
        NamedBody(std::string its_text, Body its_body) : text(std::move(its_text)), body(std::move(its_body)) {}

        std::string text;  // canonical
        Body body;
        MeasuredBody measured{body};
    };
    const ContentStore* store_ = nullptr;
    std::optional<NamedBody> named_;
};

// `outer` with its panels moved from the body that it names to the one that `pattern` names, so that it can be put over
// that (put_over). Appends one note per assumption. Throws InputError as placed_for() does for `pattern`.
Pattern moved_to_body_of(const Pattern& pattern, const Pattern& outer, std::vector<std::string>& notes);

// Whether the panels lie too low for a body that stands on the floor: some below the floor, and none above its knees
// and hips. Garment-Pattern-Generator places panels so, for bodies whose origin is at the chest.
bool is_placed_below_floor(const Pattern& pattern);

// Adds `lift` (m) to the height of every panel.
void raise_panels(Pattern& pattern, double lift);

}  // namespace selvedge::sim
