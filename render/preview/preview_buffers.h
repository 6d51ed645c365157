#pragma once
// What a draft draws, as GL holds it, kept from one picture to the next: of moving cloth only positions and normals go
// anew.
#include <array>
#include <cstdint>
#include <vector>

#include "render/draw/cloth_vertices.h"
#include "render/draw/sett_sums.h"
#include "render/gl/handle.h"
#include "render/image/image.h"
#include "render/scene/scene.h"

namespace selvedge::render {

class PreviewCloth {
 public:
    explicit PreviewCloth(const GladGLContext& gl);

    // before: the item that was given last, or none.
    void update(const ClothItem& item, const ClothItem* before);

    unsigned vertex_array() const { return vertex_array_.id(); }
    int vertex_count() const { return vertex_count_; }
    unsigned picture() const { return picture_.id(); }
    bool is_woven() const { return is_woven_; }
    bool is_painted() const { return is_painted_; }
    std::array<int, 2> threads() const { return threads_; }  // of a repeat, warp and weft

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
    std::vector<FixedVertex> fixed_vertices_;    // kept for their memory, as are these:
    std::vector<std::array<Vec3f, 2>> corners_;  // position, normal
    int vertex_count_ = 0;
    bool is_woven_ = false;
    bool is_painted_ = false;
    std::array<int, 2> threads_{1, 1};
};

// A body, or marks with colours of their own.
class PreviewSurface {
 public:
    explicit PreviewSurface(const GladGLContext& gl);

    void update(const BodyItem& item, const BodyItem* before);
    void update(const SolidItem& item, const SolidItem* before);

    unsigned vertex_array() const { return vertex_array_.id(); }
    int index_count() const { return index_count_; }
    bool is_closed() const { return is_closed_; }  // its inside is not seen

 private:
    void fill_points(const std::vector<Vec3f>& x, const std::vector<Vec3f>& normals);
    void fill_triangles(const std::vector<std::array<std::uint32_t, 3>>& triangles);

    const GladGLContext& gl_;
    VertexArray vertex_array_;
    Buffer positions_, normals_, colours_, indices_;
    int index_count_ = 0;
    bool is_closed_ = false;
};

// A tartan as one picture that repeats, with every smaller size of it, for drafts: a lookup by place costs one sample.
// Single threads are not drawn; each size holds the exact mean colours of the threads that a texel covers.

// From the largest, a power of two each way, down to one pixel. x is along the weft (the warp's threads), y along the
// warp.
std::vector<Image> preview_weave(const sim::Sett& sett);

Texture upload_draft_weave(const GladGLContext& gl, const std::vector<Image>& sizes);

}  // namespace selvedge::render
