#pragma once
// Pictures of a character in its dress: the camera goes along with the body, so that pictures of one moment can be laid
// side by side.
#include <span>
#include <vector>

#include "render/draw/renderer.h"
#include "render/image/image.h"
#include "render/scene/scene.h"
#include "sim/body/body.h"
#include "sim/cloth/cloth.h"

namespace selvedge::bench {

// Owns the renderer's GL context: create only one at a time.
class CharacterPainter {
 public:
    // The body gives the topology and the size.
    CharacterPainter(const sim::Body& body, int height_px);

    struct Subject {
        const sim::DrawMesh* dress = nullptr;  // none: the body alone
        std::span<const Vec3f> body_x{};       // m; empty: the dress alone
        render::ShowMode show = render::ShowMode::Plain;
        std::vector<render::SolidItem> solids{};
        Vec3f place = Vec3f::Zero();  // m, of the body over the floor
        bool is_whole = false;        // from head to foot; otherwise where the dress is
    };
    // Pre: scale >= 1; the picture is so many times as high and wide.
    render::Image draw(const Subject& subject, const render::Direction& from, int scale = 1);

    int height_px() const { return height_px_; }

 private:
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    float stature_ = 0;
    int height_px_;
    render::Renderer renderer_;
};

// The edges of the leaves between two fixed vertices, as turquoise rods.  (thesis fig. 5.9)
render::SolidItem fixed_edges(const sim::Cloth& cloth);

// All edges of the leaves as rods: green where no triangle beside them faces the eye (m), dark where one does.
// (thesis fig. 5.8)
render::SolidItem edges_by_sight(const sim::Cloth& cloth, const Vec3f& eye);

}  // namespace selvedge::bench
