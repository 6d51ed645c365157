#pragma once
// Edges that go round the trunk, waists and upper edges of what does not hang from the shoulders, and which of them
// have slid from where they were placed. What is wider below an edge, the hips or the bust, holds it. One that lies
// below that has slipped: it is too large, too stretchy for the weight below it, or drawn down by something else.
#include <cstddef>
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/inspection/missed_limbs.h"
#include "sim/inspection/report.h"
#include "sim/inspection/worn_garment.h"
#include "sim/place/openings.h"

namespace selvedge::sim {

// A waist or upper edge, and where it was placed and lies, m.
struct TrunkEdge {
    const Opening* edge = nullptr;
    double placed = 0;
    double draped = 0;
    double held_at = 0;  // where the hips or the chest that should hold it end
    bool is_of_chest = false;

    double moved() const { return placed - draped; }
    bool has_slipped() const { return draped <= held_at; }
    const char* holder() const { return is_of_chest ? "chest" : "hips"; }
};

// A waist or upper edge that has slipped.
struct Slip {
    DressFault fault;
    std::size_t panel = 0;  // that has the edge
};

bool does_not_fit(const Slip& slip);

// Edges that go round the trunk, and were placed where the hips or the chest hold them: the waists and upper edges of
// what does not hang from the shoulders. Each part has one, the highest; one below it is the hem of what is short.
std::vector<TrunkEdge> trunk_edges(const WornGarment& garment, const MeantOpenings& meant, const BodyPair& bodies);

// Those that lie lower than they were placed by a waistband's width, because panels settle by as much.
std::vector<TrunkEdge> lowered_edges(const WornGarment& garment, const MeantOpenings& meant, const BodyPair& bodies);

// What is wider below it, the bust or the hips, holds an edge that goes round the trunk. It has slipped if it was
// placed above that and now lies below. One that is as wide as the body where it was placed also slides down if the
// cloth is too stretchy for its weight.
std::vector<Slip> find_slips(const std::vector<TrunkEdge>& edges, const Cloth& cloth, const WornGarment& garment,
                             const BodyPair& bodies);

// "the waist of 'front' lies 15 cm lower than it was placed": a skirt that is too wide for the waist hangs on the hips.
void note_lowered_edges(const std::vector<TrunkEdge>& edges, const WornGarment& garment, DressReport& report);

// "the waist of 'skirt' lies 5 cm higher than it was placed": what is worn over a garment may push it up.
void note_raised_edges(const std::vector<TrunkEdge>& edges, const WornGarment& garment, DressReport& report);

}  // namespace selvedge::sim
