#pragma once
// Draws ImGui's lists with our own table of GL functions, to a window or a texture of ours: ImGui's backend opens libGL
// itself, and so cannot draw without a window.
#include <memory>
#include <vector>

#include "editor/frame/frame.h"
#include "render/gl/context.h"
#include "render/gl/handle.h"

namespace selvedge::app {

// Where it draws.
struct UiTarget {
    unsigned framebuffer = 0;  // 0: the window's, whose first row is the lowest; of others it is the uppermost
    int width_px = 0;
    int height_px = 0;
};

inline UiTarget target_of(const render::PictureTexture& picture) {
    return {.framebuffer = picture.framebuffer(), .width_px = picture.width_px(), .height_px = picture.height_px()};
}

// Belongs to one thread and to a context, which must outlive it. Textures are known by the editor's numbers.
class UiDraw {
 public:
    explicit UiDraw(render::GlContext& context);
    ~UiDraw();

    // Takes the place of what was held by that number. Pre: not the font's number, the picture is not empty.
    void hold(const editor::PictureToHold& picture);

    // An opaque picture that others own and draw: it must live as long as lists name it.
    void lend(editor::UiTexture number, const render::PictureTexture& picture);

    // What ImGui::Render made last, in the present ImGui context, over black; the picture is opaque. A font atlas that
    // was built since is taken to GL, and its pixels are then cleared (ImFontAtlas::ClearTexData). A number that stands
    // for nothing draws nothing. Lists may have vertex offsets (ImGuiBackendFlags_RendererHasVtxOffset).
    // Leaves blending and scissors off. Pre: `to` has the size of the display, in px.
    void draw(const UiTarget& to);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace selvedge::app

// Cuts an ImGui draw command into runs of triangles that can be drawn in a cheaper way. A software renderer spends its
// time on pixels: large areas of one colour need neither texture nor, where they are opaque, blending.

struct ImDrawCmd;
struct ImDrawList;

namespace selvedge::app {

enum class RunKind {
    Textured,  // as ImGui means it
    Blended,   // the texture is white there
    Opaque,    // and nothing shines through
};

struct UiRun {
    RunKind kind = RunKind::Textured;
    unsigned first_index = 0;  // in the command's indices
    unsigned count = 0;
};

// In their order, and all triangles. Only large triangles are told apart; px_per_unit: of ImGui's positions.
std::vector<UiRun> cut_into_runs(const ImDrawList& list, const ImDrawCmd& command, float px_per_unit);

struct PictureSize {
    int width_px = 0;
    int height_px = 0;
};

// Whether the command only lays a picture of that size on the screen, pixel on pixel and untinted: each can be taken as
// it is, with no mixing of neighbours.
bool lies_pixel_on_pixel(const ImDrawList& list, const ImDrawCmd& command, const PictureSize& size, float px_per_unit);

}  // namespace selvedge::app
