#pragma once
// The curved surface over a drape at rest, which the 3D view shows instead of the cloth's triangles. It is made in a
// task, once each time the drape comes to rest.
#include <future>
#include <memory>

#include "render/surface/curve.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/session/session.h"

namespace selvedge::editor {

class CurvedDrape {
 public:
    // Call once per displayed frame. Returns the surface over the frame's cloth, with the frame's panels; null while
    // the cloth moves, and until the task has ended. The same cloth gives the same pointer. With SessionDrive::Caller
    // it waits for the task.
    std::shared_ptr<const sim::DrawMesh> update(const std::shared_ptr<const sim::SessionFrame>& frame,
                                                sim::SessionDrive drive);

    bool is_making() const { return making_.valid(); }

 private:
    struct Made {
        render::SurfaceOverCloth over;
        std::shared_ptr<const sim::DrawMesh> mesh;  // null: there can be no surface over this cloth
    };
    static Made make(render::SurfaceOverCloth over, const sim::SessionFrame& frame);

    render::SurfaceOverCloth over_;
    std::future<Made> making_;
    std::shared_ptr<const sim::Cloth> cloth_;  // mesh_ is, or will be, the surface over it
    std::shared_ptr<const sim::DrawMesh> mesh_;
};

}  // namespace selvedge::editor
