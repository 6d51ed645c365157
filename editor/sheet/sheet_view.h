#pragma once
// The 2D view: draws the pattern on its sheet, and hands mouse and keys to the tools.
//
// Hold one for as long as the document is open, and call show() once per frame inside the ImGui child that it is to
// fill. Wheel zooms to the cursor, middle and right drag pan, F frames what is selected, or all.
#include <optional>
#include <string>
#include <vector>

#include "editor/frame/frame.h"
#include "editor/sheet/panel_faces.h"
#include "editor/sheet/sheet_pen.h"
#include "editor/tools/tool_host.h"
#include "sim/tartan/sett.h"

namespace selvedge::editor {

// Textures that the sheet may hold: this many from `first_texture` on.
inline constexpr UiTexture kSheetTextures = 6;

struct SheetContext {
    ToolHostContext desk;
    ToolHost& tools;
    FrameOutput& output;
    UiTexture first_texture = 1;
    double ui_scale = 1;     // px of the framebuffer per px of the interface
    bool takes_keys = true;  // false: they are meant for others; a text box that is active has them anyway
    SheetColours colours{};
    SheetShows shows{};
};

// What the view did with this frame's input.
struct SheetAnswer {
    std::vector<Key> used_keys{};  // not to be taken for anything else
    bool wants_menu = false;       // a right click that was no drag
};

class SheetView {
 public:
    SheetAnswer show(SheetContext& context);

    // With the next frame: all of it, or what is selected.
    void frame_all() { wants_frame_ = Frame::All; }
    void frame_selected() { wants_frame_ = Frame::Selected; }

    const SheetCamera& camera() const { return camera_; }
    void set_camera(const SheetCamera& camera);

 private:
    enum class Frame { None, All, Selected };
    struct Mouse {
        Vec2d at = Vec2d::Zero();  // px
        Modifiers modifiers{};
        bool is_over = false;
    };

    Mouse place(SheetContext& context);
    void frame_wanted(const SheetContext& context);
    void frame_again(const SheetContext& context);
    void navigate(const Mouse& mouse, SheetAnswer& answer);
    void hand_mouse(SheetContext& context, const Mouse& mouse);
    void hand_keys(SheetContext& context, const Mouse& mouse, SheetAnswer& answer);
    SettTexture sett_texture(SheetContext& context);
    void draw(SheetContext& context, const Mouse& mouse);
    void draw_readout(const SheetPen& pen, const Mouse& mouse) const;

    SheetCamera camera_;
    PanelFaces faces_;
    Frame wants_frame_ = Frame::All;
    SheetCamera framed_;  // as it was when all was framed
    SheetBox framed_box_;
    Vec2d last_at_ = Vec2d::Zero();
    bool is_panning_ = false;
    double panned_px_ = 0;
    bool has_left_ = false;  // the left button was pressed in here
    bool is_double_ = false;

    // The sett that is shown, and which of its pictures are held.
    std::string sett_name_;
    std::optional<double> sett_size_;
    std::optional<sim::Sett> sett_;
    std::vector<int> held_sides_;  // px, by texture
};

// The sheet's paper: grid, and rulers along its top and left edge.

inline constexpr double kRulerWidth = 30;  // px of the interface: as wide as "-160"

// Lines of 1 mm, 1 cm, 5 cm, 10 cm... by the zoom; finer ones fade in.
void draw_grid(const SheetPen& pen);

// In cm; `cursor` (px) is marked on both.
void draw_rulers(const SheetPen& pen, const std::optional<Vec2d>& cursor);

}  // namespace selvedge::editor
