#pragma once
// The garment as the 3D view shows it, and the marks on it: selection, hover, errors, lines between the sides of open
// seams, pins, arrangement points. All marks are balls and tubes in one triangle mesh.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/document/selection.h"
#include "editor/geometry/draft.h"
#include "editor/viewport3d/cloth_outline.h"
#include "render/scene/scene.h"
#include "sim/pattern/pattern.h"
#include "sim/place/placement.h"
#include "sim/session/session.h"

namespace selvedge::editor {

// The colours of the 3D view, except for cloth and body.

struct ViewportColours {
    render::Background background{};       // the same grey as in exported pictures
    sim::Rgb8 selected{0x1E, 0x9C, 0xC8};  // outlines of the selection: the interface's accent colour, lighter
    sim::Rgb8 hovered{0x86, 0xC9, 0xDE};   // the same, lighter
    sim::Rgb8 error{0xC2, 0x3B, 0x30};     // parts that a message names
    sim::Rgb8 point{0x5B, 0x86, 0xA8};     // arrangement points
    sim::Rgb8 hovered_point{0xE0, 0x8A, 0x2C};
    sim::Rgb8 pin{0xC9, 0x4F, 0x46};  // heads of pins
    sim::Rgb8 needle{0x8A, 0x8D, 0x91};
    sim::Rgb8 pull{0xE0, 0x8A, 0x2C};                                                             // pull target
    std::array<sim::Rgb8, 3> axes{{{0xC2, 0x5A, 0x4E}, {0x4F, 0x8F, 0x5A}, {0x45, 0x74, 0xB2}}};  // x, y, z
    sim::Rgb8 held_axis{0xE0, 0x8A, 0x2C};  // the handle under the cursor, or being dragged
    sim::Rgb8 ink{0x26, 0x29, 0x2E};        // text
    sim::Rgb8 faint{0x77, 0x78, 0x7A};
    sim::Rgb8 badge{0xFB, 0xFA, 0xF8};  // behind text
    sim::Rgb8 badge_line{0xD5, 0xD2, 0xCB};
    sim::Rgb8 good{0x3F, 0x86, 0x5B};  // dot of the stage badge: settled,
    sim::Rgb8 busy{0xD0, 0x8B, 0x2E};  // and sewing or draping
};

ViewportColours dark_viewport_colours();

// The garment as the 3D view shows it: draped, or its panels as placed, before sewing.

enum class GarmentState {
    AsItIs,   // the session's latest frame
    AsPlaced  // the panels where the pattern places them, unsewn
};

// Separates the mesh into its panels and moves each to where the pattern places it. The triangles stay the same; seam
// vertices are duplicated. A panel that the pattern does not contain keeps its current positions. Pre: the mesh has
// material coordinates.
sim::DrawMesh placed_mesh(const sim::DrawMesh& mesh, const sim::Pattern& pattern);

// Returns the 3D position of the material coordinates `u` (m) in panel `panel` (index in the mesh), from the first
// triangle that contains them. None: no triangle does.
std::optional<Vec3f> place_of(const sim::DrawMesh& mesh, std::uint16_t panel, const Vec2f& u);

class DisplayedGarment {
 public:
    // Takes over changes of the pattern and of the frame. Before sewing, the panels are always shown as placed, so that
    // a drag is visible before the session has processed it.
    void update(const sim::Pattern& pattern, std::uint64_t revision, std::shared_ptr<const sim::SessionFrame> frame,
                GarmentState wanted);

    const sim::DrawMesh& mesh() const { return is_placed_ ? placed_ : frame_->mesh; }  // same triangles as the frame
    const sim::SessionFrame& frame() const { return *frame_; }
    const std::shared_ptr<const sim::SessionFrame>& shared_frame() const { return frame_; }
    bool is_placed() const { return is_placed_; }
    // m, of the body's surface while the garment hangs on it elsewhere than where it was dressed; null: Body::x.
    std::shared_ptr<const std::vector<Vec3f>> body_positions() const { return is_placed_ ? nullptr : frame_->motion.x; }
    Vec3f body_way() const { return is_placed_ ? Vec3f(Vec3f::Zero()) : frame_->motion.way; }  // m, over the floor
    const std::vector<ClothOutline>& outlines() const { return outlines_; }  // one per panel of the pattern
    std::uint64_t version() const { return version_; }                       // increases with every change

 private:
    void find_outlines_again(const sim::Pattern& pattern, bool is_pattern_new);

    std::shared_ptr<const sim::SessionFrame> frame_ = std::make_shared<const sim::SessionFrame>();
    sim::DrawMesh placed_;
    bool is_placed_ = false;
    std::vector<ClothOutline> outlines_;
    std::vector<std::array<std::uint32_t, 3>> outlined_;  // the triangles that outlines_ was computed from
    std::vector<std::array<Vec2f, 3>> outlined_u_;
    std::uint64_t revision_ = 0;
    std::uint64_t version_ = 0;
};

struct ViewportMarks {
    Selection selection{};
    Hover hover{};
    std::vector<PartLocation> wrong{};  // parts that a message names
    bool has_seam_lines = true;         // lines between the two sides of open seams
    bool has_points = false;            // shows the arrangement points
    std::optional<std::size_t> hovered_point{};
    std::optional<Vec3f> pulled_to{};  // m
    std::set<std::string> undrawn{};   // panels whose parts and seams are not marked
    float size = 0.0028F;              // m, approximate size of a pixel: keeps the marks' size on the screen constant

    bool operator==(const ViewportMarks&) const = default;
};

// Rounds a size to coarse steps, so that zooming rarely requires new marks.
float coarse_size(float metres_per_px);

render::SolidItem make_marks(const sim::Pattern& pattern, const DisplayedGarment& garment,
                             const std::vector<sim::ArrangementPoint>& points, const ViewportMarks& marks,
                             const ViewportColours& colours);

}  // namespace selvedge::editor
