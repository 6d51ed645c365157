#pragma once
// Proposes the seams of a pattern whose file has none, as those of paper patterns. Chains of unsewn edges between
// corners (open_boundary.h) are compared pair by pair: their lengths, shapes, notches, the angles at their ends, which
// way is up, and what the panels' names say. The best pair is taken as sewn; the boundary that it leaves has new
// chains, as an armhole of front and back; and so on until no pair is likely. A pair's mirror image is taken with it.
//
// Each kind of evidence adds to the logarithm of the odds that the pair is a seam, as in a naive Bayes classifier
// (Maron 1961, "Automatic Indexing: An Experimental Inquiry"); the confidence is the probability of these odds.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/proposals/open_boundary.h"

namespace selvedge::sim {

struct SeamProposal {
    // One seam that can run over several edges: pairs of stretches of equal rank, the start of the first sewn to the
    // end of the second.
    std::vector<std::pair<EdgeSpan, EdgeSpan>> parts;
    double confidence = 0;    // 0..1, that it is a seam of the garment
    std::string reason = {};  // "lengths 42.1 and 42.1 cm; front to back; notches meet"
    bool is_eased = false;    // the sides differ in length by more than 1 mm
};

struct ProposalOptions {
    double least_confidence = 0.05;  // of the proposals that are returned
    double accepted = 0.5;           // of those that others build on
    std::string_view hints = {};     // texts about the whole garment, as its title
};

// From the most to the least certain of those that exclude each other; those accepted come first, in the order in which
// they were taken. Edges that seams join already are left alone.
std::vector<SeamProposal> propose_seams(const Pattern& pattern, const ProposalOptions& options = {});

// Adds the seams of these proposals to the pattern. Edges are divided where a seam begins or ends within them; notches
// stay in place. Pre: the proposals are of this pattern, and no two of them sew the same stretch.
void accept_proposals(Pattern& pattern, const std::vector<SeamProposal>& proposals);

// Proposals of a pattern as it was before `accepted` became seams, with the edges that it has since.
std::vector<SeamProposal> after_acceptance(std::vector<SeamProposal> proposals,
                                           const std::vector<SeamProposal>& accepted);

// "front.3 to back.1 (71 %): lengths ..."
std::string describe(const Pattern& pattern, const SeamProposal& proposal);

}  // namespace selvedge::sim
