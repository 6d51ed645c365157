#include "editor/viewport3d/curved_drape.h"

#include <chrono>
#include <new>
#include <utility>

#include "render/surface/curve.h"
#include "sim/core/error.h"

namespace selvedge::editor {

CurvedDrape::Made CurvedDrape::make(render::SurfaceOverCloth over, const sim::SessionFrame& frame) {
    render::CurveOptions options;
    options.move.body = frame.collider.get();
    try {
        // Interpolated normals light it like the leaf triangles, so that little changes when the cloth comes to rest.
        const render::CurvedSurface& surface = over.curve(*frame.cloth, options);
        auto mesh =
            std::make_shared<const sim::DrawMesh>(draw_mesh(surface, frame.mesh, render::LightNormals::Interpolated));
        return {.over = std::move(over), .mesh = std::move(mesh)};
    } catch (const sim::InputError&) {  // too many triangles: the leaves are drawn
        return {};
    } catch (const std::bad_alloc&) {
        return {};
    }
}

std::shared_ptr<const sim::DrawMesh> CurvedDrape::update(const std::shared_ptr<const sim::SessionFrame>& frame,
                                                         sim::SessionDrive drive) {
    const bool waits = drive == sim::SessionDrive::Caller;
    const auto take = [&] {
        Made made = making_.get();
        over_ = std::move(made.over);
        mesh_ = std::move(made.mesh);
    };
    if (making_.valid() && (waits || making_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)) take();
    if (!making_.valid() && frame->cloth && frame->cloth != cloth_) {
        cloth_ = frame->cloth;
        mesh_.reset();
        making_ = std::async(std::launch::async,
                             [over = std::move(over_), frame]() mutable { return make(std::move(over), *frame); });
        if (waits) take();
    }
    return frame->cloth && frame->cloth == cloth_ ? mesh_ : nullptr;
}

}  // namespace selvedge::editor
