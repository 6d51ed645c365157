#pragma once
// Cached outlines and triangulations of panels for drawing, at a level of detail that follows the zoom, and the tartan
// texture that fills them.
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "editor/tools/sheet_geometry.h"
#include "render/image/image.h"
#include "sim/tartan/sett.h"

namespace selvedge::editor {

struct PanelFace {
    std::vector<Vec2d> points;                  // m, panel frame; the closed outline, each point once
    std::vector<std::size_t> edge_starts;       // per edge the index of its first point; then the point count
    std::vector<std::array<int, 3>> triangles;  // empty if the outline intersects itself or is too fine
};

class PanelFaces {
 public:
    // Call once per frame. Limits the number of faces that are built anew in this frame.
    void begin_frame(const SheetGeometry& geometry);

    // The face at the level for this scale (px/m); another level if the limit of this frame is used up.
    const PanelFace& face(const PanelShape& shape, double scale);

 private:
    static constexpr std::size_t kLevels = 4;

    struct Kept {
        std::uint64_t outline_version = 0;
        std::array<std::optional<PanelFace>, kLevels> levels;
    };

    std::map<std::string, Kept> kept_;
    int left_ = 0;
};

// Points of one edge of the face, including its end.
std::vector<Vec2d> edge_points(const PanelFace& face, std::size_t edge);

PanelFace make_face(const sim::Panel& panel, double chord_error);

// An image of one repeat of a sett, as a texture that tiles: tartan panels are filled with it.

// The image is `side_px` wide; its height follows from the repeats of warp and weft. Column 0 is the first thread of
// the warp, row 0 the first of the weft. From 1 to 2 px per thread, single threads of the weave fade in; below, the
// mean colour is drawn, averaged in linear light.
// Pre: the sett has threads; side_px > 0.
render::Image sett_tile(const sim::Sett& sett, int side_px);

// The image size for a repeat that is `repeat_px` wide on the screen: a power of two from 32 to 1,024.
int sett_tile_side(double repeat_px);

}  // namespace selvedge::editor
