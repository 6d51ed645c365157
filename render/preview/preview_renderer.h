#pragma once
// Draws the picture that an editor shows while something moves: no shadows, no ambient occlusion, one sample per pixel,
// no single threads, lighting per vertex. Colours and view are those of Renderer, at a small part of its cost. A view
// that rests is refined: its picture becomes the mean of several samples per pixel, one more with each frame.
// Also its GL buffers.
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/draw/edge_marks.h"
#include "render/gl/context.h"
#include "render/gl/target.h"
#include "render/image/image.h"
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

    // Draws sample number `sample` of each pixel, from 0 on, and shows the mean of the samples so far. Sample 0 is the
    // picture of draw(). Pre: as draw(); for other samples, the calls of refine() before drew the samples before, of
    // the same view at the same size.
    void refine(const SceneView& view, int sample, PictureTexture& to);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// GL buffers of the preview renderer, kept from one picture to the next: when cloth moves, only its positions and
// normals are uploaded again. Also the tartan as a mipmapped texture.

class PreviewCloth {
 public:
    explicit PreviewCloth(const GladGLContext& gl);

    // before: the item of the previous call, or null.
    void update(const ClothItem& item, const ClothItem* before);

    unsigned vertex_array() const { return vertex_array_.id(); }
    int vertex_count() const { return vertex_count_; }
    unsigned picture() const { return picture_.id(); }
    bool is_woven() const { return is_woven_; }
    bool is_printed() const { return is_printed_; }
    bool is_painted() const { return is_painted_; }
    std::array<int, 2> threads() const { return threads_; }  // in one repeat of warp and weft

 private:
    struct FixedVertex {
        std::array<float, 2> place;
        std::uint32_t marks;
    };
    void fill_fixed(const ClothItem& item);
    void fill_moving(const ClothItem& item);
    void fill_picture(const ClothItem& item);

    const GladGLContext& gl_;
    VertexArray vertex_array_;
    Buffer fixed_, moving_;
    Texture picture_;
    std::vector<TriangleMarks> marks_;
    std::vector<FixedVertex> fixed_vertices_;    // kept to reuse its memory, like corners_
    std::vector<std::array<Vec3f, 2>> corners_;  // position, normal
    int vertex_count_ = 0;
    bool is_woven_ = false;
    bool is_printed_ = false;
    bool is_painted_ = false;
    std::array<int, 2> threads_{1, 1};
};

// A body, or a solid with a colour per vertex.
class PreviewSurface {
 public:
    explicit PreviewSurface(const GladGLContext& gl);

    void update(const BodyItem& item, const BodyItem* before);
    void update(const SolidItem& item, const SolidItem* before);

    unsigned vertex_array() const { return vertex_array_.id(); }
    int index_count() const { return index_count_; }
    bool is_closed() const { return is_closed_; }  // back faces are culled

 private:
    void fill_points(const std::vector<Vec3f>& x, const std::vector<Vec3f>& normals);
    void fill_triangles(const std::vector<std::array<std::uint32_t, 3>>& triangles);

    const GladGLContext& gl_;
    VertexArray vertex_array_;
    Buffer positions_, normals_, colours_, indices_;
    int index_count_ = 0;
    bool is_closed_ = false;
};

// A tartan as one repeating mipmapped texture, for previews: one texture sample per pixel. Single threads are not
// drawn; each texel has the exact mean colour of the threads that it covers.

// Mip levels from the largest (each side a power of two, at most 512 texels) down to 1 x 1. x runs along the weft,
// across the warp's threads; y runs along the warp.
std::vector<Image> preview_weave(const sim::Sett& sett);

Texture upload_preview_weave(const GladGLContext& gl, const std::vector<Image>& sizes);

}  // namespace selvedge::render
