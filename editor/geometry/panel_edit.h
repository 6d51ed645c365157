#pragma once
// Creates, copies, mirrors, cuts and merges panels, and lays them out on the sheet. All functions throw GeometryError
// and leave the pattern unchanged if the result would be invalid (see outline_edit.h). A name that is in use gets a
// number: front, front_2.
#include <optional>
#include <string>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// A name that no panel has: `wanted`, else with the lowest free number appended.
std::string free_panel_name(const sim::Pattern& pattern, const std::string& wanted);

// Renames a panel; mirror_of of its images is updated. Throws if the name is empty or in use. See rename_panel_in_file.
void rename_panel(sim::Pattern& pattern, int panel, const std::string& name);

// New panels with one counter-clockwise outline. The points may be in either orientation.
sim::Panel make_polygon(std::vector<Vec2d> points);
sim::Panel make_rectangle(const Vec2d& low, const Vec2d& high);
sim::Panel make_ellipse(const Vec2d& centre, const Vec2d& radii);  // four cubic curves

// Adds the panel under a free name and returns its index. Throws if its outline is invalid.
int add_panel(sim::Pattern& pattern, sim::Panel panel);

// Removes panels with their seams. Panels that mirror one of them lose their mirror link.
void remove_panels(sim::Pattern& pattern, const std::vector<int>& panels);

// The seams that have both sides on these panels, darts too, without their names. A side's panel is a position in
// `panels`.
std::vector<sim::Seam> seams_among(const sim::Pattern& pattern, const std::vector<int>& panels);

// Adds panels under free names, and seams between them as seams_among returns them. Returns the panels' indices.
// Throws if an outline or a seam is invalid.
std::vector<int> add_panels(sim::Pattern& pattern, std::vector<sim::Panel> panels, const std::vector<sim::Seam>& seams);

// By how much copies are moved away from their originals, m.
struct CopyShift {
    Vec2d on_sheet = Vec2d::Zero();
    Vec3d in_world = Vec3d::Zero();
};

enum class CopyLink { None, Linked };

// Adds copies with the seams among the panels. Returns their indices, in the order of `panels`. Linked: update_links
// (linked_panels.h) keeps them copies from then on.
std::vector<int> duplicate_panels(sim::Pattern& pattern, const std::vector<int>& panels, const CopyShift& shift,
                                  CopyLink link = CopyLink::None);

// Adds the panels' mirror images for the other side of the body: outlines are mirrored, 3D placements reflected (x to
// -x), and on the sheet they are mirrored within their common bounding box, then moved by `shift`. Vertices keep their
// indices; edge e of n is the image of edge (n - e) % n, reversed. left_sleeve becomes right_sleeve. `is_linked`:
// update_links (linked_panels.h) keeps them mirror images from then on; throws if a panel is itself linked to another.
//
// Seams come along, without their names: darts, seams among the panels, and seams to a panel that has a linked mirror
// image, or that stands in the middle of the body and has an edge that mirrors the sewn one, such as the armholes of a
// front. An edge that is sewn already keeps its seam. Returns the indices of the copies, in the order of `panels`.
std::vector<int> symmetric_copies(sim::Pattern& pattern, const std::vector<int>& panels, bool is_linked,
                                  const Vec2d& shift);

// Cuts the panel along a path that runs inside it. The ends of the path are moved to the nearest points of the outline.
// The panel keeps the part on the left of the path; the part on the right becomes a new panel. `is_sewn`: a seam joins
// both along the cut. Remaining edges keep their order, with the edges of the path in place of the removed ones; the
// new panel has the removed edges, from the start of the path on, then the path reversed. Both keep their 3D placement.
// Ends the panel's mirror links. Returns the index of the new panel, the last.
int cut_panel(sim::Pattern& pattern, int panel, const std::vector<Vec2d>& path, bool is_sewn);

struct Merged {
    int panel = 0;                        // its index
    std::vector<std::string> notes = {};  // where the moved panel differed from the one that stays: grain, fabric
};

// Merges the two panels of a seam into one in the plane: one stays where it lies, on the sheet and on the body, with
// its name, grain and fabric, and the other is rotated and moved to it with its lines, notches and pins. `stays`: the
// index of the one that stays; none: the larger one. Both sides must have the same length and shape to within 1 mm.
// Adjacent seams between the same panels that match in the same way are merged too. The remaining edges of the moved
// panel replace those of the seam; the moved panel is removed, and the mirror links of both end.
Merged merge_panels(sim::Pattern& pattern, int seam, std::optional<int> stays = {});

// Unfolds a panel that was cut on the fold: joins it to its mirror image over a straight edge. Edges before the fold
// keep their indices; then come the images of all edges, in reverse order from the edge before the fold on; then the
// edges after the fold. Seams stay with the original half, darts are copied to the other; the seam at the fold and the
// links are removed. Linked: update_links keeps the halves mirror images of each other from then on.
void unfold_panel(sim::Pattern& pattern, sim::SeamSide fold, CopyLink link = CopyLink::None);

// Cuts a wedge (width and depth in m) out of the panel, centred at the fraction t of an edge, and sews its legs
// together. Edge e becomes edges e, leg, leg, e + 3. If it was sewn, its two parts stay sewn to the whole other side,
// which is split in the ratio of their lengths, so the dart's width is eased. Notches within the mouth are removed.
void insert_dart(sim::Pattern& pattern, sim::SeamSide at, double t, double width, double depth);

// Layout of panels on the sheet.

// The origin of each panel on the sheet, m: its sheet_position, if set; else its position in an automatic layout in
// rows, in the order of the panels. Panels placed by the layout do not overlap each other.
std::vector<Vec2d> sheet_positions(const sim::Pattern& pattern);

// The shortest shift to the right, m, after which panels at their sheet_position, moved together, are 5 cm clear of the
// pattern's panels. 0 if they are where they lie. Pre: each of `panels` has a sheet_position.
Vec2d free_shift(const sim::Pattern& pattern, const std::vector<sim::Panel>& panels);

}  // namespace selvedge::editor
