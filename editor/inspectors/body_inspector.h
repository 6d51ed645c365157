#pragma once
// A body on its way from a box to the document: it is worn while it is tried, made beside the interface, and becomes
// the document's together with the shifts of the panels, which can only be known once it is there.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/document/command.h"
#include "editor/inspectors/inspectors.h"
#include "editor/workspace/workspace.h"
#include "sim/body/body.h"
#include "sim/mannequin/mannequin.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

enum class BodyRequest { Try, Keep };

// Nothing is worn that is no body: the state then says why.
void wish_body(InspectorContext& context, const std::string& text, BodyRequest wish);

void drop_body_wish(InspectorContext& context);

// Once per frame.
void follow_body_wish(InspectorContext& context);

// A mannequin's text and its measures: what the boxes show, and what they make of it.

bool is_mannequin(std::string_view body);

// "mannequin:sex=female,bust=92": only what is set, in the order of the measures, to 0.01 cm and 0.01 degrees.
std::string mannequin_text(const sim::MannequinOptions& options);

// Why it is no body, in words; empty: it is one. For a mannequin only; files are tried by those who read them.
std::string wrong_with_body(const std::string& text);

// "high_hip" as "High hip"; a male's bust is his chest.
std::string measure_label(std::string_view name, sim::Sex sex);

// What a tailor measures there, in words.
const char* measure_tip(std::string_view name);

// The garment is placed about the new body as it was about the old.
SetBody set_body_command(const sim::Pattern& pattern, const std::string& text, const sim::Body& from,
                         const sim::Body& onto);

}  // namespace selvedge::editor
