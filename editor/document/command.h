#pragma once
// Every change that can be made to a pattern, as plain data. Tools, menus, scripts and the journal all make commands,
// and Document::run is the one door through which they come.
//
// Metres and radians; points in the panel's held frame. Panels by name, their parts by index. `name` is what a command
// is called in scripts and journals, `fields` lists its fields for them (command_json.h).
#include <string>
#include <variant>

#include "editor/document/command_types.h"
#include "sim/core/json.h"

namespace selvedge::editor {

using Command =
    std::variant<RenamePattern, SetFabric, SetTartan, SetBody, SetEdgeLength, MatchSetts, TranslateAll, RemoveParts,
                 AddPanels, RenamePanel, DuplicatePanel, SymmetricCopy, UnlinkPanel, MovePanels, TransformPanels,
                 PlacePanel, PlacePanels, SetGrain, SetSettOffset, SetPins, SetLayer, CutPanel, MergePanels,
                 UnfoldPanel, MoveVertices, TransformVertices, SetCurve, AddVertex, AddDart, AddInternalLine,
                 SetInternalLine, AddNotch, MoveNotch, SewEdges, SewRuns, ReverseSeam, NameSeam, AcceptEase, EvenSeam>;

// What it is called in the history: "Move 3 points".
std::string label_of(const Command& command);

// Commands as JSON, in scripts and journals: {"move_vertices": {"vertices": [{"panel": "front", "index": 2}], "by":
// [0.01, 0]}}. Fields that have their usual value may be left out, and are when written.

sim::Json to_json(const Command& command);

// Throws InputError naming the path: for a command or field that there is not, and for values of another kind, out of
// range or not finite.
Command parse_command(const sim::JsonView& view);

}  // namespace selvedge::editor
