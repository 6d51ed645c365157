#pragma once
// The textures that fill panels on the sheet with what they show: one repeat of a sett, or a picture.
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "editor/frame/frame.h"
#include "render/looks/cloth_looks.h"
#include "sim/core/math.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// Number of textures that the sheet may use for cloth, from its first one on.
inline constexpr UiTexture kSheetTextures = 24;

struct ClothTexture {
    UiTexture texture = 0;        // 0: plain cloth
    std::array<Vec3f, 2> rows{};  // from (weft, warp, 1), m, to its coordinates (u, v)
};

class ClothTextures {
 public:
    // The texture for a panel, with its picture in `output` if it is new. A sett is drawn for this scale, px/m. A panel
    // whose pattern names no design and no tartan is plain. If all textures are in use in this frame, panels of further
    // designs are plain, too.
    ClothTexture find(FrameOutput& output, UiTexture first, const sim::Pattern& pattern, const sim::Panel& panel,
                      double scale);
    // Another version of the fabrics than in the frame before: they are read again.
    void begin_frame(std::uint64_t fabric_version);

 private:
    struct Held {
        sim::SurfaceDesign design{};
        int side_px = 0;  // of a sett's tile; 0: a picture
        std::size_t frame = 0;
    };

    std::vector<Held> held_;  // the texture of held_[i] is first + i
    std::size_t frame_ = 0;
    std::uint64_t fabric_version_ = 0;
    render::ClothLooks looks_{render::ClothLooks::Unknown::Replace};
};

}  // namespace selvedge::editor
