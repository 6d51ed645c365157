#pragma once
// Fits a photo or scan under the sheet (sim::Underlay) to true size: two clicks mark two of its points, and the typed
// distance between them scales it about the first one. L turns it until the line between them is level or upright. A
// drag moves it. Tab goes on to the next photo.
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "editor/tools/tool.h"
#include "editor/tools/tool_table.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// The photo turned by `angle`, rad, counter-clockwise, and scaled about that point of the sheet. Pre: scale > 0.
sim::Underlay fitted(sim::Underlay underlay, const Vec2d& about, double scale, double angle);

// The corners of a photo of that size in px on the sheet, m: its upper left, upper right, lower right and lower left.
std::array<Vec2d, 4> underlay_corners(const sim::Underlay& underlay, int width_px, int height_px);

// The box with all photos that lie under the sheet. size_px: of a file; zero if it is not known.
SheetBox extended(SheetBox box, const std::vector<sim::Underlay>& underlays,
                  const std::function<Eigen::Vector2i(const std::string& file)>& size_px);

class UnderlayTool : public Tool {
 public:
    void hover(ToolContext& context, const SheetPointer& pointer) override;
    void press(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void drag(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    bool key(ToolContext& context, Key key, const Modifiers& modifiers) override;
    bool enter(ToolContext& context, const std::vector<double>& numbers) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 private:
    std::optional<std::size_t> chosen(const ToolContext& context) const;  // index of the photo; none: there is none
    void fit(ToolContext& context, double scale, double angle, const std::string& what);

    std::size_t passed_ = 0;     // how many photos Tab has gone past, from the newest on
    std::vector<Vec2d> points_;  // none to two, on the sheet, m
    Vec2d at_ = Vec2d::Zero();   // the cursor
    Vec2d grip_ = Vec2d::Zero();
};

// Not in the toolbar: the action edit.fit_photo chooses it.
const ToolInfo& underlay_tool();

}  // namespace selvedge::editor
