#include "editor/viewport3d/viewport.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "editor/frame/item.h"
#include "editor/frame/keyboard.h"
#include "editor/viewport3d/viewport_overlay.h"

namespace selvedge::editor {
namespace {

constexpr float kMinSide = 8;  // px: the view is not drawn if it is narrower or lower than this

// A view that has not changed for so many frames is at rest; then each frame adds a sample per pixel to its picture.
constexpr int kFramesToRest = 5, kRestSamples = 16;

// Keys of drags, in every key map.
constexpr std::array kDragKeys{Key::Enter, Key::KeypadEnter, Key::Backspace, Key::Escape};

bool is_typed_digit(Key key) {
    return key >= key_of('0') && key <= key_of('9');
}

// Digits may be meant for the sheet's tool: they count only while the cursor is over the view.
std::vector<Key> pressed_keys(KeyMap map, bool is_over) {
    std::vector<Key> keys;
    const auto take = [&](Key key) {
        const bool is_new = std::ranges::find(keys, key) == keys.end();
        if (is_new && is_key_pressed(key)) keys.push_back(key);
    };
    for (const Key key : kDragKeys) take(key);
    for (const ViewKey& known : view_keys(map)) {
        if (is_over || !is_typed_digit(known.key)) take(known.key);
    }
    return keys;
}

std::string typed_text(const ImGuiIO& io) {
    std::string text;
    for (const ImWchar c : io.InputQueueCharacters) {
        if (c >= 32 && c < 127) text.push_back(static_cast<char>(c));
    }
    return text;
}

ImTextureID image_of(UiTexture texture) {
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
}

}  // namespace

void Viewport::set_colours(const ViewportColours& colours) {
    colours_ = colours;
    scene_ = ViewportScene(colours);
}

std::optional<Vec2f> Viewport::world_to_px(const Vec3f& x) const {
    std::optional<Vec2f> px = px_of(controller_.viewing(), x);
    if (px) *px += low_px_;
    return px;
}

ViewportInput Viewport::take_input(const ViewportContext& context) {
    const ImGuiIO& io = ImGui::GetIO();
    ViewportInput input{.size_px = size_px_, .scale = context.scale, .seconds = context.seconds};
    input.cursor_px = Vec2f(io.MousePos.x, io.MousePos.y) - low_px_;
    input.is_over = ImGui::IsItemHovered();
    bool is_pressed = false;
    for (std::size_t i = 0; i < input.buttons.size(); ++i) {
        const auto button = static_cast<ImGuiMouseButton>(i);
        input.buttons[i] = {.is_down = ImGui::IsMouseDown(button),
                            .was_pressed = input.is_over && ImGui::IsMouseClicked(button),
                            .was_released = ImGui::IsMouseReleased(button)};
        is_pressed = is_pressed || ImGui::IsMouseClicked(button);
    }
    if (is_pressed) is_focused_ = input.is_over;
    if (input.is_over) input.wheel = io.MouseWheel;
    input.modifiers = {.ctrl = io.KeyCtrl, .shift = io.KeyShift, .alt = io.KeyAlt};
    input.key_map = context.key_map;
    is_over_ = input.is_over;
    if (!io.WantTextInput && (input.is_over || is_focused_)) {
        input.keys = pressed_keys(context.key_map, input.is_over);
        input.text = typed_text(io);
    }
    return input;
}

bool Viewport::wants_curved(const Workspace& workspace) const {
    return may_be_curved(workspace.look) && !controller_.garment().is_placed();
}

void Viewport::make_scene(const ViewportContext& context) {
    const Workspace& workspace = context.workspace;
    const Document& document = *workspace.document;
    const Message* message = workspace.messages.shown();
    ViewportMarks marks{.selection = document.selection(), .hover = workspace.hover};
    if (message && message->kind != MessageKind::Note) marks.wrong = message->places;
    marks.wrong.insert(marks.wrong.end(), workspace.lit.parts.begin(), workspace.lit.parts.end());
    marks.undrawn = undrawn_panels(document.pattern(), workspace.look, document.panel_states());
    marks.has_seam_lines = workspace.look.has_seam_lines;
    marks.has_points = controller_.shows_points();
    marks.hovered_point = controller_.under().point;
    marks.pulled_to = controller_.pulled_to();
    marks.size =
        context.scale * coarse_size(metres_per_px(controller_.viewing(), controller_.orbit().standpoint().target));
    std::shared_ptr<const sim::DrawMesh> curved;
    if (wants_curved(workspace)) curved = curved_.update(controller_.garment().shared_frame(), workspace.drape.drive());
    shown_ = scene_.update({.pattern = document.pattern(),
                            .revision = document.revision(),
                            .fabric_version = workspace.fabrics.version(),
                            .garment = controller_.garment(),
                            .current_body = workspace.drape.current_body(),
                            .curved = std::move(curved),
                            .look = workspace.look,
                            .marks = std::move(marks)});
    const render::Camera camera = controller_.orbit().camera();
    light_ = fills_show_mode(workspace.look.show) ? even_light(camera) : studio_light(camera);
}

// The sample of a view at rest that this frame adds; none: it moved lately, or has all samples. While cloth moves
// the view does not rest, however slowly it comes.
std::optional<int> Viewport::next_sample(const ViewportContext& context) {
    const sim::SessionFrame& frame = *context.workspace.drape.frame();
    if (frame.is_running && frame.stage != sim::SessionStage::Settled) frames_at_rest_ = 0;
    if (frames_at_rest_ >= kFramesToRest + kRestSamples || !context.may_refine) return std::nullopt;
    const int sample = frames_at_rest_++ - kFramesToRest;
    context.output.is_animating = true;
    return sample < 0 ? std::nullopt : std::optional(sample);
}

void Viewport::request_rendering(const ViewportContext& context) {
    if (!shown_) return;
    const Drawn wanted{.scene = shown_,
                       .standpoint = controller_.orbit().standpoint(),
                       .width_px = static_cast<int>(size_px_.x()),
                       .height_px = static_cast<int>(size_px_.y()),
                       .texture = context.texture};
    const bool has_changed = wanted != drawn_;
    if (has_changed) frames_at_rest_ = 0;
    const std::optional<int> sample = next_sample(context);
    if (!has_changed && !sample) return;
    drawn_ = wanted;
    context.output.scenes.push_back({.texture = context.texture,
                                     .scene = shown_,
                                     .camera = controller_.orbit().camera(),
                                     .light = light_,
                                     .width_px = wanted.width_px,
                                     .height_px = wanted.height_px,
                                     .is_preview = true,
                                     .sample = sample,
                                     .legend = context.legend,
                                     .fills_show_mode = fills_show_mode(context.workspace.look.show)});
}

void Viewport::choose_cursor(const ViewportContext& context) const {
    const UnderCursor& under = controller_.under();
    if (under.handle || under.point || under.joint || controller_.drag() || controller_.pulled_to())
        context.output.cursor = MouseCursor::Hand;
}

void Viewport::show(const ViewportContext& context) {
    const ImVec2 low = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
    if (room.x < kMinSide || room.y < kMinSide) return;
    low_px_ = {std::floor(low.x), std::floor(low.y)};
    size_px_ = {std::floor(room.x), std::floor(room.y)};
    press_area("viewport", size_px_, context.show_findings ? Cover::ByLaterItems : Cover::Never);
    controller_.update(context.workspace, take_input(context), context.choice);
    context.workspace.drape.look_from(camera().eye);
    make_scene(context);
    request_rendering(context);
    choose_cursor(context);
    const bool waits_for_task = wants_curved(context.workspace) && curved_.is_making();
    context.output.is_animating = context.output.is_animating || controller_.orbit().is_moving() || waits_for_task;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 from(low_px_.x(), low_px_.y()), to(low_px_.x() + size_px_.x(), low_px_.y() + size_px_.y());
    list.PushClipRect(from, to, true);
    if (shown_) {
        list.AddImage(image_of(context.texture), from, to);
        if (fills_show_mode(context.workspace.look.show)) list.AddImage(image_of(context.legend), from, to);
    } else {
        const sim::Rgb8& paper = colours_.background.edge;
        list.AddRectFilled(from, to, IM_COL32(paper[0], paper[1], paper[2], 255));
    }
    draw_overlay(list, {.low_px = low_px_, .scale = context.scale}, context.workspace, controller_, colours_);
    list.PopClipRect();
    if (context.show_findings) show_badge_button(context);
}

// Over the badge, which the overlay has drawn.
void Viewport::show_badge_button(const ViewportContext& context) {
    const BadgeBox box = stage_badge_box(context.workspace, controller_, context.scale);
    if (box.size.x() <= 0) return;
    ImGui::SetCursorScreenPos({low_px_.x() + box.low.x(), low_px_.y() + box.low.y()});
    if (ImGui::InvisibleButton("badge", {box.size.x(), box.size.y()})) context.show_findings();
    if (context.widgets != nullptr) note_widget(*context.widgets, "viewport.badge");
    show_tip("What is right and wrong with it");
    if (ImGui::IsItemHovered()) context.output.cursor = MouseCursor::Hand;
}

}  // namespace selvedge::editor
