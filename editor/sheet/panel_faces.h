#pragma once
// Outlines and triangles of panels for drawing, as fine as the zoom asks for, kept until the outline changes.
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "editor/tools/sheet_geometry.h"

namespace selvedge {

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

PanelFace make_face(const Panel& panel, double chord_error);

}  // namespace selvedge
