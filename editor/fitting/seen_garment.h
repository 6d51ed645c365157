#pragma once
// The garment as the 3D view shows it: as it hangs, or its panels as they are placed, before sewing.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "editor/fitting/cloth_outline.h"
#include "sim/dress/session.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

enum class GarmentState {
    AsItIs,   // what the session has last published
    AsPlaced  // its panels where the pattern places them, unsewn
};

// The mesh's panels apart, where the pattern places them: each triangle stays, vertices on seams become several.
// Panels that the pattern does not have are left out of place. Pre: the mesh has material coordinates.
PlainMesh placed_mesh(const PlainMesh& mesh, const Pattern& pattern);

// Where the panel (of the mesh's) has the material coordinate, m: in the first triangle that holds it. None: nowhere.
std::optional<Vec3f> place_of(const PlainMesh& mesh, std::uint16_t panel, const Vec2f& u);

class SeenGarment {
 public:
    // Takes over what has changed. While the session is not sewing, panels are shown as placed in any case: a drag is
    // then seen before the session has taken it in.
    void follow(const Pattern& pattern, std::uint64_t revision, std::shared_ptr<const SessionFrame> frame,
                GarmentState wanted);

    const PlainMesh& mesh() const { return is_placed_ ? placed_ : frame_->mesh; }  // triangles as in the frame's
    const SessionFrame& frame() const { return *frame_; }
    bool is_placed() const { return is_placed_; }
    const std::vector<ClothOutline>& outlines() const { return outlines_; }  // by the pattern's panels
    std::uint64_t version() const { return version_; }                       // counts up with every change

 private:
    void find_outlines_again(const Pattern& pattern, bool is_pattern_new);

    std::shared_ptr<const SessionFrame> frame_ = std::make_shared<const SessionFrame>();
    PlainMesh placed_;
    bool is_placed_ = false;
    std::vector<ClothOutline> outlines_;
    std::vector<std::array<std::uint32_t, 3>> outlined_;  // the triangles that the outlines are of
    std::vector<std::array<Vec2f, 3>> outlined_u_;
    std::uint64_t revision_ = 0;
    std::uint64_t version_ = 0;
};

}  // namespace selvedge
