#pragma once
// Draws ImGui's lists with our own table of GL functions, into a texture of ours: ImGui's backend opens libGL itself,
// and so cannot draw without a window.
#include <memory>

#include "editor/ui/frame_output.h"
#include "render/gl/context.h"
#include "render/gl/picture_texture.h"

namespace selvedge {

// Belongs to one thread and to a context, which must outlive it. Textures are known by the editor's numbers.
class UiDraw {
 public:
    explicit UiDraw(GlContext& context);
    ~UiDraw();

    // Takes the place of what was held by that number. Pre: not the font's number, the picture is not empty.
    void hold(const PictureToHold& picture);

    // A texture that others own: to live, and to be told anew, as long as lists name it.
    void lend(UiTexture number, unsigned texture);

    // What ImGui::Render made last, in the present ImGui context, over black; the picture is opaque. A font atlas that
    // was built since is taken to GL, and its pixels are then cleared (ImFontAtlas::ClearTexData). A number that stands
    // for nothing draws nothing. Lists may have vertex offsets (ImGuiBackendFlags_RendererHasVtxOffset).
    // Leaves blending and scissors off. Pre: `to` has the size of the display, in px.
    void draw(PictureTexture& to);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace selvedge
