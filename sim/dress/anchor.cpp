#include "sim/dress/anchor.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <utility>

#include "sim/body/landmarks.h"
#include "sim/core/error.h"
#include "sim/mannequin/mannequin.h"
#include "sim/mannequin/stored_mannequin.h"
#include "sim/place/placement.h"
#include "sim/place/strapless_tops.h"
#include "sim/repair/load_body.h"
#include "sim/repair/stored_body.h"

namespace selvedge::sim {
namespace {

// Height of the origin of SMPL's body over the floor, m, for which Garment-Pattern-Generator places panels.
// (Korosteleva and Lee 2021, Generating datasets of 3D garments with sewing patterns)
constexpr double kChestOrigin = 1.12;
constexpr double kRaisedFrame = 0.5;  // m: a body raised by more has its origin in itself, not at its feet

MannequinOptions mannequin_of(const Pattern& pattern) {
    if (!pattern.body.empty() && !is_body_file(pattern.body)) return parse_mannequin(pattern.body);
    // GarmentCode's mean body, by its published measurements.
    MannequinOptions mean;
    mean.measures.height = pattern.body_height;
    mean.measures.bust = 0.998;
    mean.measures.waist = 0.843;
    mean.measures.hip = 1.035;
    return mean;
}

// Whether the panels are taken as placed for a body with its origin at the chest: a body file has its own frame.
bool has_chest_origin(const Pattern& pattern) {
    return pattern.body.empty() && is_placed_below_floor(pattern);
}

std::string describe_rise(const char* why, double lift) {
    char text[160];
    std::snprintf(text, sizeof text, "%s: all panels moved %s %.0f mm", why, lift > 0 ? "up" : "down",
                  std::abs(lift) * 1000);
    return text;
}

void note_stature(const Stature& stature, std::vector<std::string>& notes) {
    if (stature.has_head && stature.has_legs) return;
    const char* missing = stature.has_head ? "legs" : stature.has_legs ? "head" : "head and no legs";
    char text[96];
    std::snprintf(text, sizeof text, "the body has no %s: panels placed as on a whole one %.2f m tall", missing,
                  stature.height());
    notes.emplace_back(text);
}

}  // namespace

Body placed_for(const Pattern& pattern, const ContentStore* store) {
    std::vector<std::string> notes;  // nobody asks for them
    if (is_body_file(pattern.body))
        return load_stored_body(pattern.body, {.stands_on_floor = false}, store, notes).body;
    return stored_mannequin(mannequin_of(pattern), store).body;
}

void check_placed_for(const Pattern& pattern) {
    if (is_body_file(pattern.body)) {
        load_body(pattern.body);
        return;
    }
    MannequinOptions options = mannequin_of(pattern);
    options.subdivisions = 1;
    make_mannequin(options);
}

bool is_placed_below_floor(const Pattern& pattern) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Panel& panel : pattern.panels) {
        for (const Vec2d& u : panel.vertices) {
            low = std::min(low, panel.place(u).y());
            high = std::max(high, panel.place(u).y());
        }
    }
    return low < 0 && high < pattern.body_height / 2;
}

void raise_panels(Pattern& pattern, double lift) {
    for (Panel& panel : pattern.panels) panel.translation.y() += lift;
}

const MeasuredBody& PatternAnchor::named(const std::string& text, const Pattern& pattern) {
    if (!named_ || named_->text != text) named_.emplace(text, placed_for(pattern, store_));
    return named_->measured;
}

AnchoredPattern PatternAnchor::anchor(const Pattern& pattern, const MeasuredBody& measured) {
    const Body& onto = measured.body();
    AnchoredPattern anchored{pattern, pattern, &measured, {}};
    if (pattern.panels.empty()) return anchored;
    std::vector<std::string>& notes = anchored.notes;
    Pattern named_by = pattern;
    if (is_body_file(pattern.body)) {
        if (canonical_name(pattern.body) == onto.file) {
            raise_panels(anchored.pattern, onto.lift);
            anchored.designed = anchored.pattern;
            if (std::abs(onto.lift) > 1e-4) notes.push_back(describe_rise("with the body's file", onto.lift));
            return anchored;
        }
        try {
            const MeasuredBody& from = named(pattern.body, pattern);
            note_stature(anchor_panels(anchored.pattern, from, measured), notes);
            anchored.designed_for = &from;
            return anchored;
        } catch (const InputError& error) {
            notes.push_back(std::string("the body that the pattern names is not used: ") + error.what());
            named_by.body.clear();
        }
    }
    if (has_chest_origin(named_by)) {
        const bool is_for_this_file = onto.lift > kRaisedFrame;
        const double lift = is_for_this_file ? onto.lift : kChestOrigin;
        raise_panels(anchored.pattern, lift);
        anchored.designed = anchored.pattern;
        notes.push_back(
            describe_rise("the panels lie below the floor, as for a body with its origin at the chest", lift));
        if (is_for_this_file) return anchored;
    }
    const std::string text = made_from(mannequin_of(named_by));
    const bool is_worn_by_it = text == onto.made_from;
    if (!is_worn_by_it) anchored.designed_for = &named(text, named_by);
    if (named_by.body.empty()) {
        const double rise = raise_strapless_tops(anchored.pattern, *anchored.designed_for);
        if (rise > 0) {
            anchored.designed = anchored.pattern;
            notes.push_back("panels without straps raised by up to " + std::to_string(std::lround(1000 * rise)) +
                            " mm: their upper edge is placed under the armpits");
        }
    }
    if (is_worn_by_it) return anchored;
    note_stature(anchor_panels(anchored.pattern, *anchored.designed_for, measured), notes);
    return anchored;
}

Pattern moved_to_body_of(const Pattern& pattern, const Pattern& outer, std::vector<std::string>& notes) {
    const bool is_low = has_chest_origin(pattern);
    if (outer.body == pattern.body && outer.body_height == pattern.body_height && has_chest_origin(outer) == is_low) {
        return outer;
    }
    const Body body = placed_for(pattern);
    AnchoredPattern moved = PatternAnchor().anchor(outer, MeasuredBody(body));
    std::ranges::move(moved.notes, std::back_inserter(notes));
    if (is_low) raise_panels(moved.pattern, -kChestOrigin);
    return std::move(moved.pattern);
}

}  // namespace selvedge::sim
