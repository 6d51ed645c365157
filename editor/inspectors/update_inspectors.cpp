#include "editor/inspectors/body_change.h"
#include "editor/inspectors/inspector_context.h"
#include "editor/inspectors/number_box.h"

namespace selvedge {

void update_inspectors(InspectorContext& context) {
    context.state.drape.trace.take(*context.workspace.drape.frame());
    follow_body_wish(context);
    forget_lost_boxes(context);
}

}  // namespace selvedge
