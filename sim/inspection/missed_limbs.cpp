#include "sim/inspection/missed_limbs.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "sim/place/limb_pieces.h"

namespace selvedge::sim {

std::string list_limbs(LimbSet limbs) {
    std::string text;
    for (std::size_t i = 0; i < kLimbCount; ++i) {
        if (limbs[i]) text += (text.empty() ? "the " : " and the ") + std::string(name_of(static_cast<LimbKind>(i)));
    }
    return text;
}

namespace {

// The limbs that should not be in the opening, and those that should but are not.
struct Mismatch {
    LimbSet expected;
    LimbSet extra;
    LimbSet missing;
};

// Both sets are only defined up to their complement: what leaves through a skirt's waist is all that does not leave
// through its hem. The smaller one is what a tailor names, but for a poncho's hem: all limbs but the head.
std::optional<Mismatch> compare(LimbSet expected, LimbSet found, LimbSet known) {
    expected &= known;
    found &= known;
    const LimbSet others = known & ~expected;
    const bool is_for_all_but_head = others.count() == 1 && others[index_of(LimbKind::Head)];
    if (!is_for_all_but_head || found.none() || found == known) {
        if (expected.count() > others.count()) {
            expected = others;
            found = known & ~found;
        }
        if (2 * (expected ^ found).count() > known.count()) found = known & ~found;
    }
    if (expected == found) return std::nullopt;
    return Mismatch{.expected = expected, .extra = found & ~expected, .missing = expected & ~found};
}

// The openings that miss a limb, and those that hold it but should not: "the hem of 'skirt_front'".
struct MissedLimb {
    std::vector<std::string> missing;
    std::vector<std::string> holding;

    bool operator==(const MissedLimb&) const = default;
};
using MissedLimbs = std::array<MissedLimb, kLimbCount>;

void add_mismatch(MissedLimbs& missed, const Mismatch& mismatch, const std::string& opening) {
    for (std::size_t i = 0; i < kLimbCount; ++i) {
        for (auto [is_so, openings] :
             {std::pair(mismatch.missing[i], &missed[i].missing), std::pair(mismatch.extra[i], &missed[i].holding)}) {
            // Both ends of a sleeve may have one name.
            if (is_so && std::ranges::find(*openings, opening) == openings->end()) openings->push_back(opening);
        }
    }
}

std::string joined(const std::vector<std::string>& texts, const std::string& word) {
    std::string text;
    for (const std::string& one : texts) text += (text.empty() ? "" : " " + word + " ") + one;
    return text;
}

// "the left arm does not pass through the cuff of 'sleeve'; the hem of 'front' holds it"
std::string describe(LimbSet limbs, const MissedLimb& missed) {
    const bool is_one = limbs.count() == 1;
    std::string text;
    if (!missed.missing.empty()) {
        text = list_limbs(limbs) + (is_one ? " does" : " do") + " not pass through " + joined(missed.missing, "or");
        if (missed.holding.empty()) return text;
        text += "; ";
    }
    const std::string held = missed.missing.empty() ? list_limbs(limbs) : is_one ? "it" : "them";
    return text + joined(missed.holding, "and") + (missed.holding.size() == 1 ? " holds " : " hold ") + held;
}

// One fault for all limbs that miss the same openings.
void report_missed(const MissedLimbs& missed, DressReport& report) {
    LimbSet named;
    for (std::size_t i = 0; i < kLimbCount; ++i) {
        if (named[i] || missed[i] == MissedLimb{}) continue;
        LimbSet alike;
        for (std::size_t k = i; k < kLimbCount; ++k) alike[k] = missed[k] == missed[i];
        named |= alike;
        add_fault(
            report,
            {.kind = "limb_missed", .place = describe(alike, missed[i]), .value = static_cast<double>(alike.count())});
    }
}

// Which openings belong to a part of the garment that hangs from the shoulders, because it has a neckline or an
// armhole: an opening for some of head and arms, but not for all three.
std::vector<bool> hang_from_shoulders(const MeantOpenings& meant) {
    LimbSet above;
    for (const LimbKind kind : {LimbKind::Head, LimbKind::LeftArm, LimbKind::RightArm}) above.set(index_of(kind));
    above &= meant.limbs.known;
    std::set<std::size_t> hanging;
    for (std::size_t i = 0; i < meant.openings.size(); ++i) {
        const LimbSet leaving = meant.limbs.through[i] & above;
        if (leaving.any() && leaving != above) hanging.insert(meant.parts[i]);
    }
    std::vector<bool> hang;
    for (const std::size_t part : meant.parts) hang.push_back(hanging.contains(part));
    return hang;
}

// An arm that no panel of a part belongs round leaves it with the head, wherever the panels stand: a wide skirt stands
// before and behind the hands. without_arms: per panel; parts: of each panel.
void keep_arms_out(MeantOpenings& meant, const std::vector<std::size_t>& parts, const std::vector<bool>& without_arms) {
    if (!meant.limbs.known[index_of(LimbKind::Head)]) return;
    std::set<std::size_t> with_arms;
    for (std::size_t p = 0; p < parts.size(); ++p)
        if (!without_arms[p]) with_arms.insert(parts[p]);
    for (std::size_t i = 0; i < meant.openings.size(); ++i) {
        LimbSet& through = meant.limbs.through[i];
        if (with_arms.contains(meant.parts[i])) continue;
        for (const LimbKind arm : kArms) through[index_of(arm)] = through[index_of(LimbKind::Head)];
    }
}

}  // namespace

MeantOpenings find_meant_openings(const WornGarment& placed, const std::vector<std::size_t>& parts,
                                  const std::vector<bool>& without_arms, const BodyLimbs& meant_for) {
    MeantOpenings meant;
    meant.openings = find_openings(placed.closed);
    meant.limbs = find_passages(placed.closed, placed.closed.x, meant.openings, meant_for, {.ends_at_cloth = true});
    for (const Opening& opening : meant.openings)
        meant.parts.push_back(parts[static_cast<std::size_t>(opening.panels.front())]);
    keep_arms_out(meant, parts, without_arms);
    meant.hang_from_shoulders = hang_from_shoulders(meant);
    return meant;
}

std::string_view call_opening(LimbSet limbs, std::string_view place, bool is_of_sleeve) {
    if (limbs.none()) return "opening";
    if (limbs.count() > 2 && !limbs[index_of(LimbKind::Head)]) return "hem";  // of a poncho, flat or not
    if (limbs.count() == 1 && limbs[index_of(LimbKind::Head)]) return "neckline";
    if (limbs.count() == 1 && (limbs[index_of(LimbKind::LeftArm)] || limbs[index_of(LimbKind::RightArm)]))
        return is_of_sleeve ? "cuff" : "armhole";
    if (place == "waist") return "waist";
    return place == "chest" || place == "neck" ? "upper edge" : "hem";
}

void validate_openings(const WornGarment& garment, const PanelVertices& panels, const MeantOpenings& meant,
                       const BodyPair& bodies, DressReport& report) {
    const std::vector<Opening>& openings = meant.openings;
    // Level 0 cuts the corners that its leaves go round. If no leaf is inside the body, a limb meets cloth only there.
    const LimbPassages found = find_passages(garment.closed, garment.closed_draped, openings, bodies.worn_by,
                                             {.ends_at_cloth = report.contact.faces_in_body == 0});
    LimbSet known = meant.limbs.known & found.known;
    // An arm that leaves through the end of its own sleeve is where it belongs, whatever follows from how the panels
    // were placed: those of a sleeve that stands open do not hold it.
    std::vector<std::optional<LimbKind>> arms;  // per opening: whose sleeve it ends
    for (const Opening& opening : openings)
        arms.push_back(
            arm_of(panels[static_cast<std::size_t>(opening.panels.front())], garment.panels.x, bodies.meant_for));
    const auto is_for = [](const LimbSet& limbs, LimbKind arm) { return limbs.count() == 1 && limbs[index_of(arm)]; };
    for (std::size_t i = 0; i < openings.size(); ++i) {
        if (!arms[i] || !is_for(found.through[i], *arms[i])) continue;
        // Another opening of the sleeve, as a slit at the elbow, is none where the cuff follows from the panels.
        bool is_cuff_known = false;
        for (std::size_t j = 0; j < openings.size(); ++j)
            is_cuff_known = is_cuff_known || (arms[j] == arms[i] && is_for(meant.limbs.through[j], *arms[i]));
        if (!is_cuff_known) known[index_of(*arms[i])] = false;
    }
    MissedLimbs missed;
    for (std::size_t i = 0; i < openings.size(); ++i) {
        const auto mismatch = compare(meant.limbs.through[i], found.through[i], known);
        if (!mismatch) continue;
        const auto panel = static_cast<std::size_t>(openings[i].panels.front());
        const std::string place = place_on_body(bodies.meant_for, centre_of(openings[i], garment.closed.x));
        const std::string name = "the " + std::string(call_opening(mismatch->expected, place, arms[i].has_value())) +
                                 " of '" + garment.panels.panel_names[panel] + "'";
        add_mismatch(missed, *mismatch, name);
    }
    report_missed(missed, report);
}

}  // namespace selvedge::sim
