#pragma once
// The example of docs/adding-a-tool.md: a tool that puts a rectangular panel, a pocket, where the user clicks.
#include "editor/tools/tool.h"
#include "editor/tools/tool_table.h"

namespace selvedge::editor {

// [tool]
class PocketTool : public Tool {
 public:
    void hover(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void drag(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    bool enter(ToolContext& context, const std::vector<double>& numbers) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 private:
    AddPanels command(const ToolContext& context) const;

    Vec2d at_ = Vec2d::Zero();  // on the sheet, m: the centre
    Vec2d size_{0.12, 0.14};    // m, kept for the next pocket
};
// [/tool]

extern const ToolInfo kPocket;

}  // namespace selvedge::editor
