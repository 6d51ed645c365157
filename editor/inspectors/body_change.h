#pragma once
// A body on its way from a box to the document: it is worn while it is tried, made beside the interface, and becomes
// the document's together with the shifts of the panels, which can only be known once it is there.
#include <string>

#include "editor/inspectors/inspector_context.h"

namespace selvedge {

enum class BodyWish { Try, Keep };

// Nothing is worn that is no body: the state then says why.
void wish_body(InspectorContext& context, const std::string& text, BodyWish wish);

void drop_body_wish(InspectorContext& context);

// Once per frame.
void follow_body_wish(InspectorContext& context);

}  // namespace selvedge
