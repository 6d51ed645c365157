#include "tests/editor/viewport3d/viewport_support.h"

namespace selvedge::editor {
sim::Pattern square_pattern() {
    sim::Panel panel;
    panel.name = "square";
    panel.vertices = {{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    panel.translation = {0, 1, 0.3};
    sim::Pattern pattern;
    pattern.panels.push_back(panel);
    return pattern;
}

CurrentBody small_body(const std::string& text) {
    auto body = std::make_shared<sim::Body>();
    for (int i = 0; i < 8; ++i)
        body->x.push_back({(i & 1 ? 0.1 : -0.1), 1 + (i & 2 ? 0.1 : -0.1), (i & 4 ? 0.1 : -0.1)});
    body->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                       {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    CurrentBody made{.prepared =
                         std::make_shared<const sim::PreparedBody>(sim::MadeBody{.source = text, .body = body})};
    made.points = {{.name = "before", .position = {0, 1.35, 0.2}, .outward = {0, 0, 1}, .radius = 0.2},
                   {.name = "behind", .position = {0, 1, -0.2}, .outward = {0, 0, -1}, .radius = 0.2}};
    return made;
}

ViewportFixture::ViewportFixture(const sim::Pattern& pattern, BodyMaker maker)
    : workspace_({.pattern = pattern, .json = {}}, sim::SessionDrive::Caller, std::move(maker)) {
    controller_.look_from(StandardView::Front);
    rest();
    workspace_.drape.session().advance(0);
    rest();
}

void ViewportFixture::step(ViewportInput input) {
    workspace_.drape.update(document(), workspace_.messages);
    input.size_px = {800, 600};
    input.seconds = 1;
    input.cursor_px = cursor_;
    input.is_over = true;
    input.modifiers = modifiers;
    controller_.update(workspace_, input, choice);
}

void ViewportFixture::move_to(const Vec2f& px) {
    cursor_ = px;
    rest();
}

void ViewportFixture::press(MouseButton button) {
    ViewportInput input;
    input.buttons[static_cast<std::size_t>(button)] = {.is_down = true, .was_pressed = true};
    step(input);
}

void ViewportFixture::release(MouseButton button) {
    ViewportInput input;
    input.buttons[static_cast<std::size_t>(button)] = {.was_released = true};
    step(input);
}

void ViewportFixture::click(const Vec2f& px) {
    move_to(px);
    press();
    release();
}

void ViewportFixture::key(Key key) {
    ViewportInput input;
    input.keys = {key};
    step(input);
}

void ViewportFixture::type(const std::string& text) {
    ViewportInput input;
    input.text = text;
    step(input);
}

}  // namespace selvedge::editor
