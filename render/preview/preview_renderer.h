#pragma once
// The picture that an editor shows while something moves: no shadows, no room light, one sample to a pixel, no single
// threads; light is worked out at vertices. Like the renderer's in colours and view, at a small part of its cost.
#include <memory>

#include "render/gl/context.h"
#include "render/gl/handle.h"
#include "render/scene/scene.h"

namespace selvedge::render {

// Belongs to one thread and to the context, which must outlive it. Keeps what a scene has in common with the one drawn
// before: have one for each view. The same view has the same bits whatever was drawn before.
class PreviewRenderer {
 public:
    explicit PreviewRenderer(GlContext& context);
    ~PreviewRenderer();

    // Of the texture's size; its first row is the picture's uppermost. A scene may be empty.
    // Pre: the texture belongs to the context; the scene's numbers are finite.
    void draw(const SceneView& view, PictureTexture& to);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace selvedge::render
