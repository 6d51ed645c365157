#pragma once
// Tools that draw something new: polygon, rectangle and ellipse, internal line, cut.
#include "editor/tools/path_draft.h"

namespace selvedge {

// Click by click; Backspace takes the last point back, Enter ends, a typed length sets the next point.
class PathTool : public Tool {
 public:
    void hover(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    void double_click(ToolContext& context, const SheetPointer& pointer) override;
    bool key(ToolContext& context, Key key, const Modifiers& modifiers) override;
    bool enter(ToolContext& context, const std::vector<double>& numbers) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;

 protected:
    virtual bool is_closed() const { return false; }
    virtual bool is_done(const ToolContext& context) const = 0;  // with the point that was just added
    virtual Command command(const ToolContext& context) const = 0;
    virtual void refine_aim(const ToolContext&, const SheetPointer&) {}

    PathDraft path_;
    Modifiers modifiers_{};  // at the last click

 private:
    void finish(ToolContext& context);
};

class PolygonTool : public PathTool {
 public:
    void click(ToolContext& context, const SheetPointer& pointer) override;
    std::string hint(const ToolContext& context) const override;

 protected:
    bool is_closed() const override { return true; }
    bool is_done(const ToolContext& context) const override;
    Command command(const ToolContext& context) const override;
};

class InternalLineTool : public PathTool {
 public:
    std::string hint(const ToolContext& context) const override;

 protected:
    bool is_done(const ToolContext&) const override { return false; }
    Command command(const ToolContext& context) const override;
};

class CutTool : public PathTool {
 public:
    std::string hint(const ToolContext& context) const override;

 protected:
    bool is_done(const ToolContext& context) const override;
    Command command(const ToolContext& context) const override;
    void refine_aim(const ToolContext& context, const SheetPointer& pointer) override;
};

// The axis of a mirror: two clicks.
class MirrorTool : public PathTool {
 public:
    std::string hint(const ToolContext& context) const override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;

 protected:
    bool is_done(const ToolContext& context) const override;
    Command command(const ToolContext& context) const override;
};

enum class BoxShape { Rectangle, Ellipse };

// Drags a box open; or click a corner, then click the other or type width x height.
class BoxTool : public Tool {
 public:
    explicit BoxTool(BoxShape shape) : shape_(shape) {}

    void hover(ToolContext& context, const SheetPointer& pointer) override;
    void press(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void drag(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    bool enter(ToolContext& context, const std::vector<double>& numbers) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 private:
    void aim(const ToolContext& context, const SheetPointer& pointer);
    void make(ToolContext& context);

    BoxShape shape_;
    std::optional<Vec2d> from_;
    bool is_new_ = false;  // the corner was set by the press that is under way
    Snap aimed_;
};

}  // namespace selvedge
