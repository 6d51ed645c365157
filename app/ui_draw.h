#pragma once
// Draws ImGui's draw lists with the project's own GL function table, to a window or a texture. ImGui's GL backend loads
// libGL itself and therefore cannot draw offscreen.
#include <memory>
#include <vector>

#include "editor/frame/frame.h"
#include "render/gl/context.h"
#include "render/gl/target.h"

struct ImDrawCmd;
struct ImDrawList;

namespace selvedge::app {

// The render target.
struct UiTarget {
    unsigned framebuffer = 0;  // 0: the window, whose first row is the lowest; of others the first row is the uppermost
    int width_px = 0;
    int height_px = 0;
};

inline UiTarget target_of(const render::PictureTexture& picture) {
    return {.framebuffer = picture.framebuffer(), .width_px = picture.width_px(), .height_px = picture.height_px()};
}

// Use it on one CPU thread, with a context that outlives it. The editor's texture numbers identify textures.
class UiDraw {
 public:
    explicit UiDraw(render::GlContext& context);
    ~UiDraw();

    // Replaces the texture with that number. Pre: it is not the font's number; the picture is not empty.
    void hold(const editor::TextureUpload& picture);

    // Registers an opaque picture that the caller owns; it must live as long as draw lists refer to it.
    void lend(editor::UiTexture number, const render::PictureTexture& picture);

    // Draws the lists of the last ImGui::Render() of the current ImGui context over black; the result is opaque.
    // Uploads a new font atlas and then frees its pixels (ImFontAtlas::ClearTexData). Unknown texture numbers draw
    // nothing. Lists may use vertex offsets (ImGuiBackendFlags_RendererHasVtxOffset). Leaves blending and the scissor
    // test disabled. Pre: `to` has the size of the display, in px.
    void draw(const UiTarget& to);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Splits an ImGui draw command into runs of triangles that can be drawn more cheaply. A software renderer spends most
// of its time per pixel: large areas of one colour need no texture, and no blending if they are opaque.

enum class RunKind {
    Textured,  // textured and blended, as ImGui specifies
    Blended,   // untextured: the texture is white there
    Opaque,    // untextured and opaque
};

struct UiRun {
    RunKind kind = RunKind::Textured;
    unsigned first_index = 0;  // relative to the command's indices
    unsigned count = 0;
};

// Returns all triangles in order. Classifies large triangles only. px_per_unit: px per unit of ImGui's positions.
std::vector<UiRun> cut_into_runs(const ImDrawList& list, const ImDrawCmd& command, float px_per_unit);

struct PictureSize {
    int width_px = 0;
    int height_px = 0;
};

// Whether the command draws one untinted picture of this size with its pixels aligned to the screen's:
// nearest-neighbour sampling is then exact.
bool lies_pixel_on_pixel(const ImDrawList& list, const ImDrawCmd& command, const PictureSize& size, float px_per_unit);

}  // namespace selvedge::app
