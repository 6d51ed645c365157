#pragma once
// How the members of a team share coloured blocks.
#include <vector>

#include "sim/cloth/coloring.h"
#include "sim/core/team.h"

namespace selvedge {

// Colour by colour: blocks of one colour share no vertex, so that members may divide them, and all have done theirs
// before the next colour begins. What is too short for that the first member does alone.
// The spare point that all spare lanes stand on cannot move: whoever writes it writes the bits that it has.
// work(run, first block, number of blocks). Post: all members see what all have done.
template <class Work>
void for_runs(TeamMember& member, const std::vector<BlockColoring::Run>& runs, const Work& work) {
    constexpr std::size_t kLeast = 4;  // blocks
    bool waits = false;                // for what the first does alone
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[i].count < kLeast || member.count() == 1) {
            if (member.is_first()) work(i, runs[i].first, runs[i].count);
            waits = true;
            continue;
        }
        if (waits) member.wait();
        waits = false;
        const auto [begin, end] = member.part_of(runs[i].count);
        if (end > begin) work(i, runs[i].first + begin, end - begin);
        member.wait();
    }
    if (waits) member.wait();
}

}  // namespace selvedge
