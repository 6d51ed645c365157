#pragma once
// The parts of the workspace that tools work on.
#include "editor/tools/tool_host.h"
#include "editor/workspace/workspace.h"

namespace selvedge {

inline ToolDesk tool_desk(Workspace& workspace) {
    return {.document = *workspace.document, .hover = workspace.hover, .messages = workspace.messages};
}

}  // namespace selvedge
