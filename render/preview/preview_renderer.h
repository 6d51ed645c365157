#pragma once
// Draws the picture that an editor shows while something moves: no shadows, no ambient occlusion, one sample per pixel,
// no single threads, lighting per vertex. Colours and view are those of Renderer, at a small part of its cost.
#include <memory>

#include "render/gl/context.h"
#include "render/gl/handle.h"
#include "render/scene/scene.h"

namespace selvedge::render {

// Belongs to one CPU thread and to the context, which must outlive it. It keeps GPU data that the next scene shares
// with this one, so use one renderer per view. Equal views give byte-identical pictures, whatever was drawn before.
class PreviewRenderer {
 public:
    explicit PreviewRenderer(GlContext& context);
    ~PreviewRenderer();

    // Draws at the texture's size; row 0 of the texture is the top row of the picture. The scene may be empty.
    // Pre: the texture belongs to the context; the scene's numbers are finite.
    void draw(const SceneView& view, PictureTexture& to);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace selvedge::render
