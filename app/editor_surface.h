#pragma once
// The editor as the loop that shows it wants it, and the letters that it is given.
#include "app/edit_loop.h"
#include "editor/ui/editor.h"

namespace selvedge {

class EditorSurface final : public EditSurface {
 public:
    explicit EditorSurface(Editor& editor) : editor_(editor) {}

    FrameOutput frame(const FrameInput& input) override;

 private:
    Editor& editor_;
};

// The system's; empty where it has none.
FontBytes read_fonts();

}  // namespace selvedge
