#pragma once
// The seams of one sewing: a run of edges that was sewn to another run (1:N, M:N; see sew_runs in seam_edit.h) is as
// many seams as it has parts. They are selected, turned, eased, slid and removed together. Functions that take a seam
// mean its whole sewing; a seam that belongs to none is a sewing of its own.
#include <array>
#include <set>
#include <string>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// The seams of the seam's sewing, in the order of its first run.
std::vector<int> sewing_of(const sim::Pattern& pattern, int seam);

// The first seam of the seam's sewing in the order of the pattern: all views show the sewing in its colour.
int first_of_sewing(const sim::Pattern& pattern, int seam);

// One seam of each sewing among the seams: the first of it in the order of the pattern.
std::vector<int> one_of_each_sewing(const sim::Pattern& pattern, const std::set<int>& seams);
// The same of all seams of the pattern.
std::vector<int> one_of_each_sewing(const sim::Pattern& pattern);

// Adds the seam's sewing to the seams, or takes it out if the seam is among them.
void toggle_sewing(const sim::Pattern& pattern, int seam, std::set<int>& seams);

// Gives the sewings of the seams from index `first` on names of their own: copies of seams are not parts of the sewing
// of their originals.
void separate_sewings(sim::Pattern& pattern, std::size_t first);

enum class SewingRun { First, Second };

// The edges of a run of the seams, in outline order, panel by panel.
std::vector<sim::SeamSide> edges_of_run(const sim::Pattern& pattern, const std::vector<int>& seams, SewingRun run);

// m, the lengths of both runs.
std::array<double, 2> sewing_lengths(const sim::Pattern& pattern, int seam);

// Sews it the other way round. Points of the edges that stand only where a joint of the other run was are taken out,
// and the edges are split anew. Returns the seams that it now has.
std::vector<int> reverse_sewing(sim::Pattern& pattern, int seam);

// Slides a run along its outline by `by`, m, in the outline's direction: the points where it begins and ends and its
// joints move; corners and pinned points stay. The outline keeps its shape. Throws GeometryError if there is no such
// point, or if one would pass the end of its curve.
void slide_sewing(sim::Pattern& pattern, int seam, SewingRun run, double by);

// Whether slide_sewing would find a point to move.
bool can_slide(const sim::Pattern& pattern, int seam, SewingRun run);

}  // namespace selvedge::editor
