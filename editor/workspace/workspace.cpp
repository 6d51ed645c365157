#include "editor/workspace/workspace.h"

namespace selvedge {

bool Workspace::run(const Command& command) {
    try {
        document->run(command);
        return true;
    } catch (const DraftError& error) {
        messages.error(error);
        return false;
    }
}

bool Workspace::attempt(const Command& command) {
    try {
        document->attempt(command);
        return true;
    } catch (const DraftError& error) {
        messages.error(error);
        return false;
    }
}

}  // namespace selvedge
