#pragma once
// Making panels, cutting them apart and joining them. All throw GeometryError and leave the pattern as it was when the
// result would be no panel. Names that are taken get a number: front, front_2.
#include <string>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// A name that no panel has: `wanted`, else with the lowest number that is free.
std::string free_panel_name(const sim::Pattern& pattern, const std::string& wanted);

// Gives it a name that no panel has; those that mirror it follow. In a document's file: rename_panel_in_file.
void rename_panel(sim::Pattern& pattern, int panel, const std::string& name);

// Panels of one counter-clockwise outline. Points in any direction of turning; they are put counter-clockwise.
sim::Panel make_polygon(std::vector<Vec2d> points);
sim::Panel make_rectangle(const Vec2d& low, const Vec2d& high);
sim::Panel make_ellipse(const Vec2d& centre, const Vec2d& radii);  // four cubic arcs

// Adds it under a free name; returns its index. Throws when its outline is none.
int add_panel(sim::Pattern& pattern, sim::Panel panel);

// Removes panels with their seams; panels that mirror one of them stand alone.
void remove_panels(sim::Pattern& pattern, const std::vector<int>& panels);

// A copy beside it, unsewn, moved on the sheet by `shift`.
int duplicate_panel(sim::Pattern& pattern, int panel, const Vec2d& shift);

// The panel's mirror image for the body's other side: geometry mirrored on the sheet, placed mirrored in the room
// (x to -x); on the sheet it covers the panel's place, moved by `shift`. Of its seams only darts are copied. Vertices
// keep their indices, edge e of n is the image of edge (n - e) % n, turned round. left_sleeve becomes right_sleeve.
// `is_linked`: kept a mirror image from then on, which a mirror image cannot have of its own.
int symmetric_copy(sim::Pattern& pattern, int panel, bool is_linked, const Vec2d& shift);

// After a change of the pattern (compared with `before`): panels that mirror each other follow, in all but names and
// places on the sheet. Whichever side was edited leads; if both were, the one whose count of edges changed more, else
// the one that is mirrored. Seams at the follower stay: where the leader's edges were split or joined, its own and what
// they are sewn to are, too; a stretch of its outline that was redrawn otherwise loses its seams.
void update_mirrors(sim::Pattern& pattern, const sim::Pattern& before);

// Cuts the panel along the path, which begins and ends on its outline (ends are moved to the nearest point of it) and
// keeps inside. The panel keeps the side on the left of the path, the new one the right. `is_sewn`: the cut is sewn up.
// Edges that stay keep their order, the path's stand where the others were; the new panel's are those others from the
// path's beginning on, then the path backwards. In the room both stay where they are. Ends the panel's links. Returns
// the new panel's index, the last.
int cut_panel(sim::Pattern& pattern, int panel, const std::vector<Vec2d>& path, bool is_sewn);

// Joins the two panels of a seam to one in the plane, along that seam; the second is turned and moved to the first.
// Its sides must be of one length, to 1 mm, and have one shape. Seams that go on along it just so are joined with it.
// The second's edges stand where those of the seam were; its panel goes, and links with them end. Returns the index of
// the joined panel.
int merge_panels(sim::Pattern& pattern, int seam);

// The panel with its mirror image over a straight edge, as one: what was cut on the fold is opened. Its edges before
// the fold keep their indices, the image's follow (from that of the edge before the fold on backwards), then those
// behind it. Seams stay with the half that was there, darts are doubled; a seam at the fold goes, and so do links.
void unfold_panel(sim::Pattern& pattern, sim::SeamSide fold);

// Cuts a wedge of the width and depth out of the panel at the fraction t of an edge, and sews its legs together. The
// edge e becomes e, leg, leg, e + 3. If it was sewn, its two parts stay sewn to the whole other side, which is split by
// share of their lengths: the width is eased. Notches within the mouth go.
void insert_dart(sim::Pattern& pattern, sim::SeamSide at, double t, double width, double depth);

// Where panels lie on the drafting sheet that were never put anywhere: side by side in rows, in their order.

// The origin of each panel on the sheet, m: sheet_position where there is one. No two that are laid out overlap.
std::vector<Vec2d> sheet_positions(const sim::Pattern& pattern);

}  // namespace selvedge::editor
