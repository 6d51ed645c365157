#pragma once
// What one frame of the editor asks of whoever shows it: scenes to draw into textures, pictures to hold as textures,
// and then ImGui's draw lists. The editor names textures by numbers of its own and knows no GL.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/scene/scene.h"

namespace selvedge {

// In ImGui's draw lists, as ImTextureID. 0 is the font's.
using UiTexture = std::uint32_t;

// A scene to be drawn into a texture before the draw lists are.
struct SceneToDraw {
    UiTexture texture = 0;
    std::shared_ptr<const Scene> scene;  // the same pointer: the same scene but for its camera and lights
    Camera camera;
    Light light;
    int width_px = 0;
    int height_px = 0;
    bool is_draft = true;      // fast: no shadows, no room light, one sample
    UiTexture legend = 0;      // gets a clear picture of the same size with the legend, where the mode is painted
    bool wants_paint = false;  // the mode of its first cloth is to be filled in first (render/show.h)
};

// A picture to be held as a texture that repeats, until another of that number comes.
struct PictureToHold {
    UiTexture texture = 0;
    Image picture;
};

enum class MouseCursor { Arrow, Text, Hand, Cross, ResizeHorizontal, ResizeVertical, Hidden };

struct FrameOutput {
    std::vector<PictureToHold> pictures;
    std::vector<SceneToDraw> scenes;  // only those that changed: a texture keeps what was drawn
    std::string window_title;
    MouseCursor cursor = MouseCursor::Arrow;
    bool wants_to_close = false;
    bool is_animating = false;  // wants a frame as soon as may be, else an event may be waited for
};

}  // namespace selvedge
