#pragma once
// Marks on the garment and round the body: what is selected, under the cursor or wrong, threads of open seams, pins,
// arrangement points. Balls and tubes of one surface.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "editor/document/selection.h"
#include "editor/geometry/draft.h"
#include "editor/viewport3d/cloth_outline.h"
#include "render/scene/scene.h"
#include "sim/dress/session.h"
#include "sim/pattern/pattern.h"
#include "sim/place/arrangement.h"

namespace selvedge::editor {

// The colours of the 3D view, but for cloth and body.

struct ViewportColours {
    render::Background background{};       // the picture renderer's own paper grey
    sim::Rgb8 selected{0x1E, 0x9C, 0xC8};  // outlines of what is selected: the interface's accent, lighter
    sim::Rgb8 hovered{0x86, 0xC9, 0xDE};   // the same, lighter
    sim::Rgb8 error{0xC2, 0x3B, 0x30};     // places that a message names
    sim::Rgb8 point{0x5B, 0x86, 0xA8};     // arrangement points
    sim::Rgb8 hovered_point{0xE0, 0x8A, 0x2C};
    sim::Rgb8 pin{0xC9, 0x4F, 0x46};  // heads of pins
    sim::Rgb8 needle{0x8A, 0x8D, 0x91};
    sim::Rgb8 pull{0xE0, 0x8A, 0x2C};                                                             // the hand that pulls
    std::array<sim::Rgb8, 3> axes{{{0xC2, 0x5A, 0x4E}, {0x4F, 0x8F, 0x5A}, {0x45, 0x74, 0xB2}}};  // x, y, z
    sim::Rgb8 held_axis{0xE0, 0x8A, 0x2C};  // the handle that is under the cursor or held
    sim::Rgb8 ink{0x26, 0x29, 0x2E};        // words
    sim::Rgb8 faint{0x77, 0x78, 0x7A};
    sim::Rgb8 badge{0xFB, 0xFA, 0xF8};  // behind words
    sim::Rgb8 badge_line{0xD5, 0xD2, 0xCB};
    sim::Rgb8 good{0x3F, 0x86, 0x5B};  // of the badge's dot: settled,
    sim::Rgb8 busy{0xD0, 0x8B, 0x2E};  // sewing and draping
};

// The garment as the 3D view shows it: as it hangs, or its panels as they are placed, before sewing.

enum class GarmentState {
    AsItIs,   // what the session has last published
    AsPlaced  // its panels where the pattern places them, unsewn
};

// The mesh's panels apart, where the pattern places them: each triangle stays, vertices on seams become several.
// Panels that the pattern does not have are left out of place. Pre: the mesh has material coordinates.
sim::PlainMesh placed_mesh(const sim::PlainMesh& mesh, const sim::Pattern& pattern);

// Where the panel (of the mesh's) has the material coordinate, m: in the first triangle that holds it. None: nowhere.
std::optional<Vec3f> place_of(const sim::PlainMesh& mesh, std::uint16_t panel, const Vec2f& u);

class DisplayedGarment {
 public:
    // Takes over what has changed. While the session is not sewing, panels are shown as placed in any case: a drag is
    // then seen before the session has taken it in.
    void follow(const sim::Pattern& pattern, std::uint64_t revision, std::shared_ptr<const sim::SessionFrame> frame,
                GarmentState wanted);

    const sim::PlainMesh& mesh() const { return is_placed_ ? placed_ : frame_->mesh; }  // triangles as in the frame's
    const sim::SessionFrame& frame() const { return *frame_; }
    bool is_placed() const { return is_placed_; }
    const std::vector<ClothOutline>& outlines() const { return outlines_; }  // by the pattern's panels
    std::uint64_t version() const { return version_; }                       // counts up with every change

 private:
    void find_outlines_again(const sim::Pattern& pattern, bool is_pattern_new);

    std::shared_ptr<const sim::SessionFrame> frame_ = std::make_shared<const sim::SessionFrame>();
    sim::PlainMesh placed_;
    bool is_placed_ = false;
    std::vector<ClothOutline> outlines_;
    std::vector<std::array<std::uint32_t, 3>> outlined_;  // the triangles that the outlines are of
    std::vector<std::array<Vec2f, 3>> outlined_u_;
    std::uint64_t revision_ = 0;
    std::uint64_t version_ = 0;
};

struct ViewportMarks {
    Selection selection{};
    Hover hover{};
    std::vector<GeometryPlace> wrong{};  // places that a message names
    bool has_threads = true;             // of seams that are not closed
    bool has_points = false;             // arrangement points
    std::optional<std::size_t> hovered_point{};
    std::optional<Vec3f> pulled_to{};  // m
    float size = 0.0028F;              // m, of a pixel of the view, about: marks keep their size on the screen

    bool operator==(const ViewportMarks&) const = default;
};

// A size in coarse steps, so that a zooming camera seldom asks for other marks.
float coarse_size(float metres_per_px);

render::SolidItem make_marks(const sim::Pattern& pattern, const DisplayedGarment& garment,
                             const std::vector<sim::ArrangementPoint>& points, const ViewportMarks& marks,
                             const ViewportColours& colours);

}  // namespace selvedge::editor
