#include "editor/sheet/sheet_view.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "editor/frame/item.h"
#include "editor/frame/keyboard.h"
#include "editor/sheet/panel_faces.h"
#include "editor/sheet/sheet_labels.h"
#include "editor/sheet/sheet_paint.h"
#include "editor/tools/select_tool.h"
#include "editor/tools/underlay_tool.h"

namespace selvedge::editor {
namespace {

Modifiers modifiers_now() {
    const ImGuiIO& io = ImGui::GetIO();
    return {.ctrl = io.KeyCtrl, .shift = io.KeyShift, .alt = io.KeyAlt};
}

bool is_repeating(Key key) {
    return key == Key::Backspace || (key >= Key::Right && key <= Key::Up);
}

// Keys pressed since the last frame that the view or its tools may use.
std::vector<Key> pressed_keys() {
    std::vector<Key> keys;
    const auto look_at = [&](Key key) {
        if (is_repeating(key) ? is_key_repeated(key) : is_key_pressed(key)) keys.push_back(key);
    };
    for (char letter = 'A'; letter <= 'Z'; ++letter) look_at(key_of(letter));
    for (const Key key : {Key::Escape, Key::Enter, Key::KeypadEnter, Key::Backspace, Key::Delete, Key::Tab, Key::Left,
                          Key::Right, Key::Up, Key::Down}) {
        look_at(key);
    }
    return keys;
}

// ASCII text typed since the last frame; enough for numbers.
std::string written() {
    std::string text;
    for (const ImWchar c : ImGui::GetIO().InputQueueCharacters) {
        if (c >= 32 && c < 127) text += static_cast<char>(c);
    }
    return text;
}

}  // namespace

void SheetView::set_camera(const SheetCamera& camera) {
    camera_.centre = camera.centre;
    camera_.scale = camera.scale;
    wants_frame_ = Frame::None;
}

// Fills the child's remaining region with the view; returns the mouse state.
SheetView::Mouse SheetView::place(SheetContext& context) {
    const ImVec2 low = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
    camera_.view_low = Vec2d(double(low.x), double(low.y));
    camera_.view_size = Vec2d(std::max(1.0, double(size.x)), std::max(1.0, double(size.y)));
    ImGui::InvisibleButton(
        "sheet", {float(camera_.view_size.x()), float(camera_.view_size.y())},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle | ImGuiButtonFlags_MouseButtonRight);
    const ImVec2 at = ImGui::GetIO().MousePos;
    const bool is_over = ImGui::IsItemHovered() && ImGui::IsMousePosValid(&at);
    if (is_over && context.tools.info().is_drawing) context.output.cursor = MouseCursor::Cross;
    if (is_panning_) context.output.cursor = MouseCursor::Hand;
    const bool is_valid = ImGui::IsMousePosValid(&at);
    return {is_valid ? Vec2d(double(at.x), double(at.y)) : last_at_, modifiers_now(), is_over};
}

SheetBox SheetView::content_box(const SheetContext& context) const {
    const SheetBox box = context.tools.geometry().drawn_box();
    if (!context.underlay_picture) return box;
    return extended(box, context.host.document.pattern().underlays,
                    [&](const std::string& file) { return context.underlay_picture(file).size_px; });
}

void SheetView::frame_wanted(const SheetContext& context) {
    if (wants_frame_ == Frame::None) return;
    SheetBox box = content_box(context);
    if (wants_frame_ == Frame::Selected) {
        const SheetBox chosen = context.tools.geometry().box_of(context.host.document.selection());
        if (!chosen.isEmpty()) box = chosen;
    }
    const bool is_all = wants_frame_ == Frame::All;
    wants_frame_ = Frame::None;
    SheetCamera inner = camera_;  // the region inside the rulers
    const double ruler = kRulerWidth * context.ui_scale;
    inner.view_size -= Vec2d::Constant(ruler);
    constexpr double kMargin = 36, kLargestShare = 0.1;  // px; of the smaller side of the view
    frame(inner, box, std::min(kMargin * context.ui_scale, kLargestShare * inner.view_size.minCoeff()));
    if (box.isEmpty()) inner = {.centre = Vec2d(0.5, 0.4), .scale = 700 * context.ui_scale};
    camera_.scale = inner.scale;
    camera_.centre = inner.centre + Vec2d(-ruler, ruler) / (2 * inner.scale);
    if (!is_all) return;
    framed_ = camera_;
    framed_box_ = content_box(context);
}

// Keeps everything framed if the view is resized, as long as the camera and the bounding box are unchanged since
// everything was framed.
void SheetView::frame_again(const SheetContext& context) {
    const SheetBox box = content_box(context);
    const bool is_same = camera_.centre == framed_.centre && camera_.scale == framed_.scale && !has_left_ &&
                         box.min() == framed_box_.min() && box.max() == framed_box_.max();
    if (is_same && camera_.view_size != framed_.view_size && wants_frame_ == Frame::None) frame_all();
}

void SheetView::navigate(const SheetContext& context, const Mouse& mouse, SheetResult& answer) {
    const ImGuiIO& io = ImGui::GetIO();
    if (mouse.is_over && io.MouseWheel != 0) zoom_at(camera_, mouse.at, double(io.MouseWheel));
    const bool is_held = ImGui::IsMouseDown(ImGuiMouseButton_Middle) || ImGui::IsMouseDown(ImGuiMouseButton_Right);
    const bool begins = ImGui::IsMouseClicked(ImGuiMouseButton_Middle) || ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    constexpr double kClick = 4;  // px
    const bool is_right = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    if (is_right && mouse.is_over && !is_panning_ && context.tools.ask_number(context.host)) {
        last_at_ = mouse.at;
        return;
    }
    if (begins && mouse.is_over) {
        is_panning_ = true;
        panned_px_ = 0;
    } else if (is_panning_) {
        const Vec2d by = mouse.at - last_at_;
        panned_px_ += by.norm();
        pan(camera_, by);
        if (!is_held) {
            is_panning_ = false;
            answer.wants_menu = ImGui::IsMouseReleased(ImGuiMouseButton_Right) && panned_px_ < kClick;
        }
    }
    last_at_ = mouse.at;
}

// Alt and an arrow move the cursor by a step of the grid, with Shift by a millimetre; Alt and Enter click there. The
// mouse takes it back when it moves.
void SheetView::move_key_cursor(SheetContext& context, Mouse& mouse) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    const Vec2d mouse_now = ImGui::IsMousePosValid(&at) ? Vec2d(double(at.x), double(at.y)) : mouse_at_;
    if (mouse_now != mouse_at_ || has_left_) key_cursor_.reset();
    mouse_at_ = mouse_now;
    const bool may_move = context.takes_keys && !ImGui::GetIO().WantTextInput && mouse.modifiers.alt &&
                          (mouse.is_over || ImGui::IsWindowFocused() || key_cursor_);
    if (may_move) {
        constexpr double kFineStep = 0.001, kLeastPx = 5;  // m; px between two steps
        const double step = mouse.modifiers.shift ? kFineStep : grid_step(camera_, kLeastPx * context.ui_scale);
        const Vec2d by(double(is_key_repeated(Key::Right)) - double(is_key_repeated(Key::Left)),
                       double(is_key_repeated(Key::Up)) - double(is_key_repeated(Key::Down)));
        if (by.norm() > 0) {
            const Vec2d from =
                to_sheet(camera_, key_cursor_.value_or(mouse.is_over ? mouse.at : to_px(camera_, camera_.centre)));
            key_cursor_ = to_px(camera_, (from / step).array().round().matrix() * step + step * by);
        }
    }
    if (!key_cursor_) return;
    mouse.at = *key_cursor_;
    mouse.is_over = true;
    const bool clicks = may_move && (is_key_pressed(Key::Enter) || is_key_pressed(Key::KeypadEnter));
    mouse.modifiers.alt = false;  // it says that the keys move the cursor
    if (!clicks) return;
    context.tools.press(context.host, mouse.at, mouse.modifiers);
    context.tools.release(context.host, mouse.at, mouse.modifiers);
}

void SheetView::forward_mouse(SheetContext& context, const Mouse& mouse) {
    ToolHost& tools = context.tools;
    if (mouse.is_over && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        has_left_ = true;
        is_double_ = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        tools.press(context.host, mouse.at, mouse.modifiers);
    } else if (mouse.is_over || has_left_) {
        tools.move(context.host, mouse.at, mouse.modifiers);
    } else {
        tools.leave(context.host);
    }
    if (!has_left_ || ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    has_left_ = false;
    tools.release(context.host, mouse.at, mouse.modifiers);
    if (is_double_) tools.double_click(context.host, mouse.at, mouse.modifiers);
}

void SheetView::forward_keys(SheetContext& context, const Mouse& mouse, SheetResult& answer) {
    // Where nothing has the focus, as after a choice in a menu, keys are the sheet's.
    const bool is_here =
        mouse.is_over || has_left_ || ImGui::IsWindowFocused() || !ImGui::IsWindowFocused(ImGuiFocusedFlags_AnyWindow);
    if (!context.takes_keys || !is_here || ImGui::GetIO().WantTextInput) return;
    const bool was_typing = !context.tools.typed().is_empty() || context.tools.is_asking();
    const bool takes_text = context.takes_text && !mouse.modifiers.ctrl && !mouse.modifiers.alt;
    if (takes_text) context.tools.text(context.host, written());
    for (const Key key : pressed_keys()) {
        if (ImGui::GetIO().KeyAlt && (key == Key::Enter || key == Key::KeypadEnter || key >= Key::Right)) continue;
        if (context.tools.key(context.host, key, mouse.modifiers)) {
            answer.used_keys.push_back(key);
        } else if (key == key_of('F') && mouse.modifiers == Modifiers{} && !was_typing) {
            frame_selected();
            answer.used_keys.push_back(key);
        }
    }
}

SheetResult SheetView::show(SheetContext& context) {
    SheetResult answer;
    Mouse mouse = place(context);
    context.tools.begin_frame(context.host.document, camera_, context.ui_scale);
    move_key_cursor(context, mouse);
    frame_again(context);
    frame_wanted(context);
    navigate(context, mouse, answer);
    context.tools.begin_frame(context.host.document, camera_, context.ui_scale);
    if (!is_panning_) forward_mouse(context, mouse);
    forward_keys(context, mouse, answer);
    frame_wanted(context);
    context.tools.begin_frame(context.host.document, camera_, context.ui_scale);
    draw(context, mouse);
    return answer;
}

// A texture whose photo is no longer held is taken for the next one.
UiTexture SheetView::underlay_texture(SheetContext& context, const std::shared_ptr<const render::Photo>& photo) {
    const auto is_of = [](const std::shared_ptr<const render::Photo>& wanted) {
        return [wanted](const auto& held) { return held.first == wanted; };
    };
    auto found = std::ranges::find_if(underlay_textures_, is_of(photo));
    if (found != underlay_textures_.end()) return found->second;
    found = std::ranges::find_if(underlay_textures_, is_of(nullptr));
    if (found == underlay_textures_.end())
        found = underlay_textures_.insert(underlay_textures_.end(), {nullptr, context.take_texture()});
    found->first = photo;
    context.output.pictures.push_back({.texture = found->second, .picture = photo->image, .has_levels = true});
    return found->second;
}

// Returns whether there are any.
bool SheetView::draw_underlays(SheetContext& context, const SheetPen& pen) {
    const std::vector<sim::Underlay>& underlays = context.host.document.pattern().underlays;
    if (!context.underlay_picture || !context.take_texture) return false;
    for (auto& [photo, texture] : underlay_textures_) {
        if (photo && photo.use_count() == 1) photo.reset();  // of a document that was closed, or removed
    }
    bool has_any = false;
    for (const sim::Underlay& underlay : underlays) {
        const UnderlayPicture picture = context.underlay_picture(underlay.file);
        if (!picture.photo) continue;
        has_any = true;
        const auto corners = underlay_corners(underlay, picture.size_px.x(), picture.size_px.y());
        const auto texture = static_cast<std::uintptr_t>(underlay_texture(context, picture.photo));
        pen.list.AddImageQuad(reinterpret_cast<ImTextureID>(texture), pen.px(corners[0]), pen.px(corners[1]),
                              pen.px(corners[2]), pen.px(corners[3]), {0, 0}, {1, 0}, {1, 1}, {0, 1},
                              packed(faded({255, 255, 255, 255}, underlay.opacity)));
    }
    return has_any;
}

namespace {

void draw_key_cursor(const SheetPen& pen, const Vec2d& at) {
    const ImVec2 middle{std::floor(float(at.x())) + 0.5F, std::floor(float(at.y())) + 0.5F};
    const float arm = pen.px(11), gap = pen.px(3);
    for (const float width : {3.5F, 1.5F}) {
        const ImU32 colour = packed(width > 2 ? pen.colours.plate : pen.colours.accent);
        pen.list.AddLine({middle.x - arm, middle.y}, {middle.x - gap, middle.y}, colour, pen.px(double(width)));
        pen.list.AddLine({middle.x + gap, middle.y}, {middle.x + arm, middle.y}, colour, pen.px(double(width)));
        pen.list.AddLine({middle.x, middle.y - arm}, {middle.x, middle.y - gap}, colour, pen.px(double(width)));
        pen.list.AddLine({middle.x, middle.y + gap}, {middle.x, middle.y + arm}, colour, pen.px(double(width)));
    }
}

}  // namespace

void SheetView::draw(SheetContext& context, const Mouse& mouse) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Vec2d low = camera_.view_low, high = low + camera_.view_size;
    list.PushClipRect({float(low.x()), float(low.y())}, {float(high.x()), float(high.y())}, true);
    const SheetPen pen{list, camera_, context.colours, static_cast<float>(context.ui_scale)};
    const SheetGeometry& geometry = context.tools.geometry();
    const ToolOverlay overlay = context.tools.overlay(context.host);
    const std::set<std::string> touched = touched_panels(context.host.document.selection());
    faces_.begin_frame(geometry);
    if (context.shows.grid) draw_grid(pen);
    constexpr double kTracedThrough = 0.35;  // share of a panel's cloth over photos
    const double cloth_opacity = draw_underlays(context, pen) ? kTracedThrough : 1;
    cloth_textures_.begin_frame(context.fabric_version);
    const auto cloth_of = [&](const sim::Panel& panel) {
        return cloth_textures_.find(context.output, context.first_texture, context.host.document.pattern(), panel,
                                    camera_.scale);
    };
    const SheetLook look{pen,
                         context.host.document.pattern(),
                         geometry,
                         faces_,
                         context.host.document.selection(),
                         context.host.hover,
                         overlay,
                         touched,
                         context.shows,
                         labels_,
                         cloth_opacity,
                         cloth_of,
                         &cut_lines_};
    std::vector<const PanelShape*> seen;
    for (const PanelShape& shape : geometry.panels()) {
        if (is_in_view(look, shape)) seen.push_back(&shape);
    }
    for (const PanelShape* shape : seen) draw_cut_line(look, *shape);
    reserve_names(look, seen);
    for (const PanelShape* shape : seen) draw_cloth(look, *shape), draw_outline(look, *shape);
    draw_seams(look);
    for (std::size_t i = 0; i < seen.size(); ++i) draw_marks(look, *seen[i], names_[i]);
    draw_hovered(look);
    for (const PanelShape* shape : seen) draw_selected(look, *shape), draw_lengths(look, *shape);
    if (const Message* message = context.host.messages.shown()) draw_lit_places(look, message->places);
    draw_lit_places(look, context.lit_parts);
    draw_lit_cloth(look, context.lit_cloth);
    draw_overlay(look);
    if (key_cursor_) draw_key_cursor(pen, *key_cursor_);
    draw_rulers(pen, mouse.is_over ? std::optional<Vec2d>(mouse.at) : std::nullopt);
    draw_readout(pen, mouse);
    if (mouse.is_over || has_left_) draw_bubble(pen, mouse.at, overlay, context.tools);
    list.PopClipRect();
    if (overlay.readout.empty()) show_whole_name(context, mouse);
}

// Call before anything is drawn, so that the badges avoid the names.
void SheetView::reserve_names(const SheetLook& look, const std::vector<const PanelShape*>& seen) {
    labels_ = {};
    names_.clear();
    for (const PanelShape* shape : seen) {
        names_.push_back(look.shows.names ? name_of(look, *shape) : PanelName{.panel = shape->panel.name});
        if (!names_.back().shown.empty()) labels_.reserve(names_.back().box);
    }
}

// A tooltip, where the panel under the cursor does not show its whole name.
void SheetView::show_whole_name(const SheetContext& context, const Mouse& mouse) const {
    if (!mouse.is_over || has_left_ || is_panning_ || !context.tools.typed().is_empty()) return;
    const auto has_cursor = [&](const PanelName& name) { return name.panel == context.host.hover.panel; };
    const auto found = std::ranges::find_if(names_, has_cursor);
    if (found != names_.end() && !found->is_whole()) show_tip(found->panel);
}

// The cursor's position on the sheet, at the lower right.
void SheetView::draw_readout(const SheetPen& pen, const Mouse& mouse) const {
    if (!mouse.is_over) return;
    const Vec2d at = to_sheet(camera_, mouse.at) * 100;
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.1f, %.1f cm", at.x(), at.y());
    const ImVec2 size = ImGui::CalcTextSize(text.data());
    const Vec2d high = camera_.view_low + camera_.view_size;
    const ImVec2 low{std::round(float(high.x()) - size.x - pen.px(10)),
                     std::round(float(high.y()) - size.y - pen.px(6))};
    pen.list.AddRectFilled({low.x - pen.px(6), low.y - pen.px(2)},
                           {low.x + size.x + pen.px(6), low.y + size.y + pen.px(2)}, packed(pen.colours.plate),
                           pen.px(3));
    pen.list.AddText(low, packed(pen.colours.ruler_text), text.data());
}

namespace {

constexpr std::array<double, 6> kSteps{0.001, 0.01, 0.05, 0.10, 0.50, 1.0};  // m
constexpr double kSeenFrom = 5;                                              // px between lines: fading in
constexpr double kFullFrom = 14;                                             // px: fully visible
constexpr double kCoarseFrom = 45;                                           // px: drawn in the colour of coarse lines
constexpr double kLabelsApart = 52;                                          // px

struct Range {
    long first = 0;
    long last = 0;
};

Range lines_in(double low, double high, double step) {
    return {static_cast<long>(std::ceil(low / step)), static_cast<long>(std::floor(high / step))};
}

float crisp(double at) {
    return static_cast<float>(std::floor(at) + 0.5);
}

// Draws the lines of one step, except those that the next coarser step draws.
void draw_lines(const SheetPen& pen, double step, double next, const render::Rgba8& colour) {
    const SheetBox box = visible_box(pen.camera);
    const Vec2d low = pen.camera.view_low, high = low + pen.camera.view_size;
    const long per_next = std::lround(next / step);
    for (int axis = 0; axis < 2; ++axis) {
        const Range range = lines_in(box.min()[axis], box.max()[axis], step);
        for (long i = range.first; i <= range.last; ++i) {
            if (per_next > 1 && i % per_next == 0) continue;
            const Vec2d at = to_px(pen.camera, Vec2d::Constant(double(i) * step));
            const render::Rgba8& drawn = i == 0 ? pen.colours.axis : colour;
            if (axis == 0) {
                pen.list.AddRectFilled({crisp(at.x()) - 0.5F, float(low.y())}, {crisp(at.x()) + 0.5F, float(high.y())},
                                       packed(drawn));
            } else {
                pen.list.AddRectFilled({float(low.x()), crisp(at.y()) - 0.5F}, {float(high.x()), crisp(at.y()) + 0.5F},
                                       packed(drawn));
            }
        }
    }
}

double label_step(const SheetPen& pen) {
    for (const double step : {0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0}) {
        if (step * pen.camera.scale >= double(pen.px(kLabelsApart))) return step;
    }
    return 10;
}

std::string label(double metres, double step) {
    char text[32];
    std::snprintf(text, sizeof text, step < 0.01 ? "%.1f" : "%.0f", metres * 100);
    return text[0] == '-' && std::string(text).find_first_not_of("-0.") == std::string::npos ? text + 1 : text;
}

void draw_ticks(const SheetPen& pen, int axis) {
    const SheetBox box = visible_box(pen.camera);
    const Vec2d low = pen.camera.view_low;
    const float width = pen.px(kRulerWidth);
    const double labelled = label_step(pen);
    const double step = labelled / (labelled * pen.camera.scale >= double(pen.px(100)) ? 10 : 5);
    const Range range = lines_in(box.min()[axis], box.max()[axis], step);
    const long per_label = std::lround(labelled / step);
    for (long i = range.first; i <= range.last; ++i) {
        const Vec2d at = to_px(pen.camera, Vec2d::Constant(double(i) * step));
        const bool has_label = i % per_label == 0;
        const bool is_half = per_label % 2 == 0 && i % (per_label / 2) == 0;
        const float length = pen.px(has_label ? 9 : is_half ? 6 : 4);
        const float along = crisp(axis == 0 ? at.x() : at.y());
        if (along < float(low[axis]) + width) continue;
        const std::string text = has_label ? label(double(i) * step, labelled) : "";
        const float size = pen.px(11);
        ImFont* font = ImGui::GetFont();
        if (axis == 0) {
            const float base = float(low.y()) + width;
            pen.list.AddLine({along, base}, {along, base - length}, packed(pen.colours.ruler_tick));
            if (has_label)
                pen.list.AddText(font, size, {along + pen.px(3), float(low.y()) + pen.px(2)},
                                 packed(pen.colours.ruler_text), text.c_str());
        } else {
            const float base = float(low.x()) + width;
            pen.list.AddLine({base, along}, {base - length, along}, packed(pen.colours.ruler_tick));
            if (has_label)
                pen.list.AddText(font, size, {float(low.x()) + pen.px(2), along + pen.px(1)},
                                 packed(pen.colours.ruler_text), text.c_str());
        }
    }
}

}  // namespace

void draw_grid(const SheetPen& pen) {
    const Vec2d low = pen.camera.view_low, high = low + pen.camera.view_size;
    pen.list.AddRectFilled({float(low.x()), float(low.y())}, {float(high.x()), float(high.y())},
                           packed(pen.colours.paper));
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
        const double apart = kSteps[i] * pen.camera.scale / double(pen.ui);
        if (apart < kSeenFrom) continue;
        const double next = i + 1 < kSteps.size() ? kSteps[i + 1] : kSteps[i];
        const double seen = std::clamp((apart - kSeenFrom) / (kFullFrom - kSeenFrom), 0.0, 1.0);
        const double coarse = std::clamp((apart - kCoarseFrom / 2) / (kCoarseFrom / 2), 0.0, 1.0);
        const render::Rgba8 fine = faded(pen.colours.fine_grid, seen);
        draw_lines(pen, kSteps[i], next, mixed(fine, pen.colours.coarse_grid, coarse));
    }
}

void draw_rulers(const SheetPen& pen, const std::optional<Vec2d>& cursor) {
    const Vec2d low = pen.camera.view_low, high = low + pen.camera.view_size;
    const float width = pen.px(kRulerWidth);
    const ImVec2 corner{float(low.x()), float(low.y())}, end{float(high.x()), float(high.y())};
    pen.list.AddRectFilled(corner, {end.x, corner.y + width}, packed(pen.colours.ruler));
    pen.list.AddRectFilled(corner, {corner.x + width, end.y}, packed(pen.colours.ruler));
    for (const int axis : {0, 1}) draw_ticks(pen, axis);
    pen.list.AddLine({corner.x, corner.y + width}, {end.x, corner.y + width}, packed(pen.colours.ruler_line));
    pen.list.AddLine({corner.x + width, corner.y}, {corner.x + width, end.y}, packed(pen.colours.ruler_line));
    pen.list.AddRectFilled(corner, {corner.x + width, corner.y + width}, packed(pen.colours.ruler));
    pen.list.AddText(ImGui::GetFont(), pen.px(11), {corner.x + pen.px(4), corner.y + pen.px(5)},
                     packed(pen.colours.ruler_text), "cm");
    if (!cursor) return;
    const float x = crisp(cursor->x()), y = crisp(cursor->y()), half = pen.px(3.5);
    if (x > corner.x + width) {
        pen.list.AddTriangleFilled({x - half, corner.y + width - pen.px(6)}, {x + half, corner.y + width - pen.px(6)},
                                   {x, corner.y + width}, packed(pen.colours.accent));
    }
    if (y > corner.y + width) {
        pen.list.AddTriangleFilled({corner.x + width - pen.px(6), y - half}, {corner.x + width, y},
                                   {corner.x + width - pen.px(6), y + half}, packed(pen.colours.accent));
    }
}

}  // namespace selvedge::editor
