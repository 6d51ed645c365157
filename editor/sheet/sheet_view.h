#pragma once
// The 2D view: draws the pattern on its sheet, and passes mouse and keyboard input to the tools.
//
// Keep one instance while the document is open; call show() once per frame inside the ImGui child that it fills. The
// wheel zooms to the cursor, a middle or right drag pans, F frames the selection, or everything.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editor/frame/frame.h"
#include "editor/sheet/cloth_textures.h"
#include "editor/sheet/cut_lines.h"
#include "editor/sheet/panel_faces.h"
#include "editor/sheet/sheet_labels.h"
#include "editor/sheet/sheet_pen.h"
#include "editor/tools/tool_host.h"
#include "render/image/photo.h"

namespace selvedge::editor {

// The picture of a photo that lies under the sheet.
struct UnderlayPicture {
    std::shared_ptr<const render::Photo> photo{};  // null: there is none
    Eigen::Vector2i size_px{0, 0};                 // to which sim::Underlay::pixel_size refers
};

struct SheetContext {
    ToolHostContext host;
    ToolHost& tools;
    FrameOutput& output;
    UiTexture first_texture = 1;  // of kSheetTextures
    double ui_scale = 1;          // framebuffer px per px of the interface
    bool takes_keys = true;       // false: ignore the keyboard. An active text field always takes precedence
    bool takes_text = true;       // typed numbers are the tool's
    SheetColours colours{};
    SheetVisibility shows{};
    std::function<UnderlayPicture(const std::string& file)> underlay_picture{};  // unset: there are none
    std::function<UiTexture()> take_texture{};                                   // for the pictures of underlays
    std::uint64_t fabric_version = 0;                                            // FabricLibrary::version()
    std::vector<PartLocation> lit_parts{};                                       // of a finding about the drape
    std::vector<LitCloth::OnPanel> lit_cloth{};
};

// Result of the frame's input.
struct SheetResult {
    std::vector<Key> used_keys{};  // keys that the view has consumed
    bool wants_menu = false;       // a right click without a drag
};

class SheetView {
 public:
    SheetResult show(SheetContext& context);

    // Frames everything that is not hidden, or the selection, in the next frame.
    void frame_all() { wants_frame_ = Frame::All; }
    void frame_selected() { wants_frame_ = Frame::Selected; }

    const SheetCamera& camera() const { return camera_; }
    void set_camera(const SheetCamera& camera);

    // The names of the panels in view, and the boxes of all texts of the sheet, of the last frame.
    const std::vector<PanelName>& names() const { return names_; }
    const std::vector<LabelBox>& labels() const { return labels_.taken(); }

 private:
    enum class Frame { None, All, Selected };
    struct Mouse {
        Vec2d at = Vec2d::Zero();  // px
        Modifiers modifiers{};
        bool is_over = false;
    };

    Mouse place(SheetContext& context);
    void move_key_cursor(SheetContext& context, Mouse& mouse);
    void frame_wanted(const SheetContext& context);
    void frame_again(const SheetContext& context);
    void navigate(const SheetContext& context, const Mouse& mouse, SheetResult& answer);
    void forward_mouse(SheetContext& context, const Mouse& mouse);
    void forward_keys(SheetContext& context, const Mouse& mouse, SheetResult& answer);
    SheetBox content_box(const SheetContext& context) const;
    UiTexture underlay_texture(SheetContext& context, const std::shared_ptr<const render::Photo>& photo);
    bool draw_underlays(SheetContext& context, const SheetPen& pen);
    void draw(SheetContext& context, const Mouse& mouse);
    void draw_readout(const SheetPen& pen, const Mouse& mouse) const;
    void reserve_names(const SheetLook& look, const std::vector<const PanelShape*>& seen);
    void show_whole_name(const SheetContext& context, const Mouse& mouse) const;

    SheetCamera camera_;
    PanelFaces faces_;
    LabelPlaces labels_;
    std::vector<PanelName> names_;
    Frame wants_frame_ = Frame::All;
    SheetCamera framed_;  // camera when everything was framed
    SheetBox framed_box_;
    Vec2d last_at_ = Vec2d::Zero();
    bool is_panning_ = false;
    double panned_px_ = 0;
    bool has_left_ = false;  // the left button was pressed inside the view
    bool is_double_ = false;
    std::optional<Vec2d> key_cursor_;  // px: where keys moved the cursor; none: it is the mouse's
    Vec2d mouse_at_ = Vec2d::Zero();   // px, of the mouse in the last frame

    ClothTextures cloth_textures_;
    CutLines cut_lines_;

    // Of photos under the sheet; null: a texture that is free again.
    std::vector<std::pair<std::shared_ptr<const render::Photo>, UiTexture>> underlay_textures_;
};

// The sheet's background: the grid, and the rulers at its top and left edge.

inline constexpr double kRulerWidth = 30;  // px of the interface; fits the label "-160"

// Lines every 1 mm, 1 cm, 5 cm, 10 cm..., depending on the zoom; finer ones fade in.
void draw_grid(const SheetPen& pen);

// Labels in cm; marks the position of `cursor` (px) on both rulers.
void draw_rulers(const SheetPen& pen, const std::optional<Vec2d>& cursor);

}  // namespace selvedge::editor
