#pragma once
// Changing the garment's body. The requested body is built in the background and shown for trial; when it is ready, it
// is set in the document together with the shifts of the panels, which depend on it. Also converts mannequin
// measurements to and from text.
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

enum class BodyRequest { Preview, Commit };

// Starts building the body. Does nothing if the text is not a valid body; BodyState::wrong then holds the reason.
void request_body(InspectorContext& context, const std::string& text, BodyRequest request);

void cancel_body_request(InspectorContext& context);

// Completes or abandons a pending request. Call once per frame.
void update_body_request(InspectorContext& context);

// Conversion between a mannequin's text and its measurements.

bool is_mannequin(std::string_view body);

// "mannequin:sex=female,bust=92": lists only the values that are set, in the order of measure_names(), rounded to 0.01
// cm and 0.01 degrees.
std::string mannequin_text(const sim::MannequinOptions& options);

// The reason why the text is not a valid body; empty: it is valid. Checks mannequins only; files are checked when they
// are loaded.
std::string wrong_with_body(const std::string& text);

// "high_hip" as "High hip"; a male's "bust" as "Chest".
std::string measure_label(std::string_view name, sim::Sex sex);

// How a tailor takes this measurement.
const char* measure_tip(std::string_view name);

// Sets the body and shifts the panels so that they keep their placement relative to the body. Panels for a body from a
// file are placed in the file's frame.
SetBody set_body_command(const sim::Pattern& pattern, const std::string& text, const sim::Body& from,
                         const sim::Body& onto);

}  // namespace selvedge::editor
