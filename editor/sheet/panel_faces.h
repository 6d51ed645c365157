#pragma once
// Outlines and triangles of panels for drawing, as fine as the zoom asks for, kept until the outline changes.
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
    std::vector<Vec2d> points;                  // m, held frame; the closed outline, each point once
    std::vector<std::size_t> edge_starts;       // per edge its first point, and last the number of points
    std::vector<std::array<int, 3>> triangles;  // none where the outline bounds no clean inside
};

class PanelFaces {
 public:
    // Once per frame: how many faces may be made anew before coarser ones serve.
    void begin_frame(const SheetGeometry& geometry);

    // Of the level that is right for the scale (px/m), or another one while it waits for its turn.
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

// Points of one edge of the face, its end included.
std::vector<Vec2d> edge_points(const PanelFace& face, std::size_t edge);

PanelFace make_face(const sim::Panel& panel, double chord_error);

// One repeat of a sett as a picture that can be laid side by side: what a tartan panel is filled with.

// `side_px` wide, as high in proportion; column 0 is the first thread of the warp, row 0 the first of the weft. Where
// threads are a px or wider each one is seen as the weave crosses them, else their mean, in linear light.
// Pre: the sett has threads; side_px > 0.
render::Image sett_tile(const sim::Sett& sett, int side_px);

// The size for a picture whose repeat is seen so many px wide: a power of two from 32 to 1,024.
int sett_tile_side(double repeat_px);

}  // namespace selvedge::editor
