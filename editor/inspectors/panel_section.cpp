// A panel's name, size, place and cloth.
#include <imgui.h>

#include <algorithm>

#include "editor/drafting/sheet_layout.h"
#include "editor/inspectors/controls.h"
#include "editor/inspectors/number_box.h"
#include "editor/inspectors/pattern_figures.h"
#include "editor/inspectors/property_sections.h"
#include "editor/inspectors/vector_row.h"
#include "sim/pattern/outline.h"

namespace selvedge {
namespace {

constexpr double kLeastScale = 0.01;
constexpr double kLeastSize = 0.001;  // m

// A panel and where it lies on the sheet.
struct PanelOnSheet {
    const Panel& panel;
    Vec2d origin = Vec2d::Zero();  // m
};

std::string area_text(double area) {
    return area < 0.1 ? quantity_figure(area * 1e4, Unit::Whole) + " cm\u00B2"
                      : quantity_figure(area, Unit::Plain) + " m\u00B2";
}

const PanelFacts& facts_of(InspectorContext& context, const Panel& panel) {
    PanelFacts& facts = context.state.panels[panel.name];
    const std::uint64_t revision = context.workspace.document->revision() + 1;  // 0: not known yet
    if (facts.revision != revision) {
        facts = {.revision = revision, .area = outline_area(panel), .perimeter = panel_perimeter(panel)};
    }
    return facts;
}

TransformPanels scaling(const std::vector<std::string>& panels, const Vec2d& centre, int axis, double factor) {
    Vec2d factors(1, 1);
    factors[axis] = factor;
    return {.panels = panels, .map = scale_about(centre, factors), .what = "Scale"};
}

Pattern only_selected(const Pattern& pattern, const Selection& selected) {
    Pattern part;
    for (const Panel& panel : pattern.panels) {
        if (selected.panels.contains(panel.name)) part.panels.push_back(panel);
    }
    return part;
}

// So much further than they are seen now, also where that is only tried.
PlacePanels placing(const Pattern& pattern, const Selection& selected, const Vec3d& by) {
    PlacePanels command;
    for (const Panel& panel : pattern.panels) {
        if (!selected.panels.contains(panel.name)) continue;
        command.places.push_back({.panel = panel.name,
                                  .translation = panel.translation + by,
                                  .rotation = panel.rotation,
                                  .wrap_radius = panel.wrap_radius});
    }
    return command;
}

void draw_name(InspectorContext& context, const Panel& panel) {
    row_label(context, "Name", "What the panel is called.");
    const auto name = text_box(context, {.name = "panel.name",
                                         .text = panel.name,
                                         .tip = "What the panel is called. No two have the same name.",
                                         .width_px = field_width(),
                                         .wrong = [](const std::string& text) -> std::string {
                                             return text.empty() ? "A panel has a name" : "";
                                         }});
    if (name) context.workspace.run(RenamePanel{.panel = panel.name, .to = *name});
}

// S XY as a factor from what it is now, or by the size that comes out.
void draw_scale(InspectorContext& context, const PanelOnSheet& shown) {
    const std::vector<std::string> panels{shown.panel.name};
    const PlaneBox box = panel_box(shown.panel);
    const Vec2d centre = box.centre() + shown.origin;
    const VectorEdit scale = vector_row(context,
                                        {.name = "panel.scale",
                                         .label = "S: scale",
                                         .unit = Unit::Factor,
                                         .tip = "Scales the outline about its middle: 1.05 or 105%.",
                                         .least = kLeastScale},
                                        Vec2d(1, 1));
    if (scale) carry(context, scale.number, scaling(panels, centre, scale.axis, scale.number.value.value_or(1)));
    const VectorEdit size = vector_row(context,
                                       {.name = "panel.size",
                                        .label = "Size",
                                        .tip = "Of the box about its outline; type one to scale the panel to it.",
                                        .axes = {"W", "H", ""},
                                        .least = kLeastSize},
                                       box.size());
    if (size && size.number.before.value_or(0) > 0) {
        const double factor = size.number.value.value_or(0) / *size.number.before;
        carry(context, size.number, scaling(panels, centre, size.axis, factor));
    }
}

// The angles that were typed, as long as the panel still stands so.
Vec3d shown_angles(const InspectorContext& context, const Panel& panel) {
    const auto typed = context.state.angles.find(panel.name);
    constexpr double kSame = 1e-9;
    if (typed != context.state.angles.end() && typed->second.rotation.isApprox(panel.rotation, kSame)) {
        return typed->second.angles;
    }
    return angles_of(panel.rotation);
}

void draw_place(InspectorContext& context, const Panel& panel) {
    PlacePanel placed{.panel = panel.name,
                      .translation = panel.translation,
                      .rotation = panel.rotation,
                      .wrap_radius = panel.wrap_radius};
    const VectorEdit moved =
        vector_row(context,
                   {.name = "panel.translation",
                    .label = "T: place",
                    .tip = "Where the panel's origin stands in the room: X to the body's left, Y up, Z to the front."},
                   panel.translation);
    const Vec3d angles = shown_angles(context, panel);
    const VectorEdit turned = vector_row(context,
                                         {.name = "panel.rotation",
                                          .label = "R: turned",
                                          .unit = Unit::Degrees,
                                          .tip = "Turned about X first, then Y, then Z, as the room has them."},
                                         angles);
    const NumberEdit wrapped = number_row(context,
                                          {.name = "panel.wrap_radius",
                                           .value = panel.wrap_radius,
                                           .tip = "Bends the panel round an upright behind it, to lie about the "
                                                  "body. 0: flat.",
                                           .least = 0},
                                          "Wrap radius");
    if (moved) {
        placed.translation = edited(panel.translation, moved);
        carry(context, moved.number, placed);
    } else if (turned) {
        const Vec3d wanted = edited(angles, turned);
        placed.rotation = rotation_of(wanted);
        const std::string name = panel.name;
        carry(context, turned.number, placed);
        context.state.angles[name] = {.angles = wanted, .rotation = rotation_of(wanted)};
    } else if (wrapped) {
        placed.wrap_radius = wrapped.value.value_or(0);
        carry(context, wrapped, placed);
    }
}

void draw_cloth(InspectorContext& context, const Panel& panel) {
    const std::string name = panel.name;
    fabric_row(context, name);
    const NumberEdit grain =
        number_row(context,
                   {.name = "panel.grain",
                    .value = panel.grain_angle,
                    .unit = Unit::Degrees,
                    .tip = "From the panel's upward direction to the warp, counter-clockwise. 45: cut on the bias."},
                   "Grain");
    carry(context, grain, SetGrain{.panel = name, .angle = grain.value.value_or(0)});
    const NumberEdit layer = number_row(context,
                                        {.name = "panel.layer",
                                         .value = panel.layer,
                                         .unit = Unit::Whole,
                                         .tip = "Higher layers lie further out.",
                                         .least = -100,
                                         .most = 100},
                                        "Layer");
    carry(context, layer, SetLayer{.panel = name, .layer = static_cast<int>(layer.value.value_or(0))});
}

std::string mirror_of(const Pattern& pattern, const Panel& panel) {
    if (!panel.mirror_of.empty()) return panel.mirror_of;
    for (const Panel& other : pattern.panels) {
        if (other.mirror_of == panel.name) return other.name;
    }
    return "";
}

void draw_links(InspectorContext& context, const Panel& panel) {
    const std::string name = panel.name;
    const std::string mirror = mirror_of(context.pattern(), panel);
    if (!panel.pins.empty()) {
        fact(context, "Pins", std::to_string(panel.pins.size()) + (panel.pins.size() == 1 ? " point" : " points"),
             "Points of the outline that stay where they are placed.");
    }
    if (!mirror.empty())
        fact(context, "Mirror of", mirror, "Both are kept alike: what is done to one is done to both.");
    ButtonRow row(context);
    const bool has_pins = !panel.pins.empty();
    if (!mirror.empty() &&
        row.button({.name = "panel.unlink",
                    .title = "Unlink",
                    .tip = with_key(context, "It and its mirror image go their own ways", "panel.unlink")})) {
        context.workspace.run(UnlinkPanel{name});
    } else if (has_pins && row.button({.name = "panel.unpin", .title = "Unpin", .tip = "No point of it is held."})) {
        context.workspace.run(SetPins{.panel = name});
    }
}

}  // namespace

void draw_panel_section(InspectorContext& context, const std::string& name) {
    const std::optional<int> index = panel_index(context.pattern(), name);
    if (!index) return;
    const auto at = static_cast<std::size_t>(*index);
    const Panel panel = context.pattern().panels[at];  // a copy: a box may change the pattern
    const Vec2d origin = sheet_positions(context.pattern())[at];
    heading(context, ("Panel " + name).c_str());
    ImGui::PushID(name.c_str());
    draw_name(context, panel);
    draw_scale(context, {.panel = panel, .origin = origin});
    draw_place(context, panel);
    draw_cloth(context, panel);
    const PanelFacts& facts = facts_of(context, panel);
    fact(context, "Area", area_text(facts.area), "Of the cloth inside the outline.");
    fact(context, "Perimeter", quantity_text(facts.perimeter, Unit::Centimetres), "The length of the outline.");
    fact(context, "Points", std::to_string(panel.vertices.size()), "Corners and joints of the outline.");
    draw_links(context, panel);
    ImGui::PopID();
}

void draw_panels_section(InspectorContext& context) {
    const Selection selected = context.selection();
    const Pattern& pattern = context.pattern();
    const std::vector<Vec2d> origins = sheet_positions(pattern);
    std::optional<PlaneBox> all;
    double area = 0;
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
        if (!selected.panels.contains(pattern.panels[i].name)) continue;
        const PlaneBox box = panel_box(pattern.panels[i]);
        if (!all) all = {.low = box.low + origins[i], .high = box.high + origins[i]};
        all->low = all->low.cwiseMin(box.low + origins[i]);
        all->high = all->high.cwiseMax(box.high + origins[i]);
        area += facts_of(context, pattern.panels[i]).area;
    }
    if (!all) return;
    heading(context, (std::to_string(selected.panels.size()) + " panels").c_str());
    ImGui::PushID("panels");
    const std::vector<std::string> names(selected.panels.begin(), selected.panels.end());
    const VectorEdit scale = vector_row(context,
                                        {.name = "panels.scale",
                                         .label = "S: scale",
                                         .unit = Unit::Factor,
                                         .tip = "Scales all of them about their common middle: 1.05 or 105%.",
                                         .least = kLeastScale},
                                        Vec2d(1, 1));
    if (scale) carry(context, scale.number, scaling(names, all->centre(), scale.axis, scale.number.value.value_or(1)));
    const VectorEdit moved = vector_row(
        context,
        {.name = "panels.move", .label = "Move by", .tip = "On the sheet; they stay where they are in the room."},
        Vec2d(0, 0));
    if (moved) carry(context, moved.number, MovePanels{.panels = names, .by = edited(Vec2d(0, 0), moved)});
    const Vec3d centre = garment_centre(only_selected(pattern, selected));
    const VectorEdit placed = vector_row(context,
                                         {.name = "panels.translation",
                                          .label = "T: place",
                                          .tip = "Moves all of them in the room, with their middle to this place."},
                                         centre);
    if (placed) carry(context, placed.number, placing(pattern, selected, edited(centre, placed) - centre));
    fact(context, "Area", area_text(area), "Of the cloth inside their outlines.");
    ImGui::PopID();
}

}  // namespace selvedge
