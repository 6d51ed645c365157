#include "editor/tools/sheet_actions.h"

#include <algorithm>

#include "editor/tools/select_tool.h"

namespace selvedge::editor {
namespace {

constexpr double kGap = 0.05;  // m, between a panel and its copy

std::vector<Command> transformed(const SheetGeometry& geometry, const Selection& selection, const PlaneMap& map,
                                 const std::string& what) {
    const std::optional<Command> command = transform_selected(geometry, selection, map, what);
    return command ? std::vector<Command>{*command} : std::vector<Command>{};
}

// One command per selected panel: make(name, shift), with shifts that put the copies side by side to the right of the
// sheet's panels. lands(shape): the bounding box of the copy without a shift.
template <class Make, class Lands>
std::vector<Command> beside(const SheetGeometry& geometry, const Selection& selection, Make&& make, Lands&& lands) {
    std::vector<Command> commands;
    double right = geometry.box().isEmpty() ? 0 : geometry.box().max().x();
    for (const std::string& name : selection.panels) {
        const PanelShape* shape = geometry.find(name);
        if (shape == nullptr || shape->box.isEmpty()) continue;
        const SheetBox box = lands(*shape);
        commands.push_back(make(name, Vec2d(right + kGap - box.min().x(), 0)));
        right += kGap + box.sizes().x();
    }
    return commands;
}

}  // namespace

std::vector<Command> mirror_selected(const SheetGeometry& geometry, const Selection& selection, MirrorAxis axis) {
    const SheetBox box = geometry.box_of(selection);
    if (box.isEmpty()) return {};
    const Vec2d direction = axis == MirrorAxis::Upright ? Vec2d(0, 1) : Vec2d(1, 0);
    return transformed(geometry, selection, mirror_over(box.center(), direction), "Mirror");
}

std::vector<Command> rotate_selected(const SheetGeometry& geometry, const Selection& selection, double angle) {
    const SheetBox box = geometry.box_of(selection);
    if (box.isEmpty()) return {};
    return transformed(geometry, selection, rotation_about(box.center(), angle), "Rotate");
}

std::vector<Command> duplicate_selected(const SheetGeometry& geometry, const Selection& selection) {
    return beside(
        geometry, selection,
        [](const std::string& name, const Vec2d& shift) {
            return DuplicatePanel{name, shift};
        },
        [](const PanelShape& shape) { return shape.sheet_box(); });
}

std::vector<Command> symmetric_copy_selected(const SheetGeometry& geometry, const Selection& selection) {
    return beside(
        geometry, selection,
        [](const std::string& name, const Vec2d& shift) {
            return SymmetricCopy{.panel = name, .is_linked = true, .shift = shift};
        },
        [](const PanelShape& shape) {
            const Vec2d low = shape.box.min(), high = shape.box.max();
            return SheetBox(Vec2d(-high.x(), low.y()) + shape.origin, Vec2d(-low.x(), high.y()) + shape.origin);
        });
}

std::vector<Command> unlink_selected(const SheetGeometry& geometry, const Selection& selection) {
    std::vector<Command> commands;
    for (const std::string& name : selection.panels) {
        const PanelShape* shape = geometry.find(name);
        if (shape != nullptr && !shape->panel.mirror_of.empty()) commands.push_back(UnlinkPanel{name});
    }
    return commands;
}

std::vector<Command> reverse_selected_seams(const Selection& selection) {
    std::vector<Command> commands;
    for (const int seam : selection.seams) commands.push_back(ReverseSeam{seam});
    return commands;
}

}  // namespace selvedge::editor
