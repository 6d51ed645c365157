#pragma once
// Every possible change of a pattern as plain data. Tools, menus, scripts and the journal create commands;
// Document::run and Document::preview apply them. Also the JSON form of commands.
//
// Metres and radians; points in the panel's held frame. Panels by name, their parts by index. `name` is the command's
// key in scripts and journals; `fields` visits its fields for JSON reading and writing.
#include <cstddef>
#include <string>
#include <variant>

#include "editor/document/command_types.h"
#include "editor/document/part_commands.h"
#include "sim/core/json.h"

namespace selvedge::editor {

using Command = std::variant<RenamePattern, SetFabric, ReplaceFabric, SetTartan, SetBody, SetEdgeLength, MatchSetts,
                             TranslateAll, RemoveParts, AddPanels, RenamePanel, DuplicatePanels, SymmetricCopy,
                             UnlinkPanel, MovePanels, TransformPanels, PlacePanel, PlacePanels, SetGrain, SetSettOffset,
                             SetPins, SetLayer, CutPanel, MergePanels, UnfoldPanel, MoveVertices, TransformVertices,
                             SetCurve, AddVertex, AddDart, AddInternalLine, SetInternalLine, AddNotch, MoveNotch,
                             SewEdges, SewRuns, ReverseSeam, NameSeam, AcceptEase, SlideSewing, EvenSeam, PutOver,
                             TakeOff, SetUnderlays, SetSurface, SetAllowance, SetFields>;

// The command that changes one of the photos under the sheet. Pre: the pattern has it.
SetUnderlays set_underlay(const sim::Pattern& pattern, std::size_t index, const sim::Underlay& changed,
                          const std::string& what);

// The label in the history: "Move 3 points".
std::string label_of(const Command& command);

// Commands as JSON, in scripts and journals: {"move_vertices": {"vertices": [{"panel": "front", "index": 2}], "by":
// [0.01, 0]}}. Fields with their default value may be left out; writing leaves them out.

sim::Json to_json(const Command& command);

// Throws InputError with the JSON path for an unknown command or field, and for a value of the wrong type, out of range
// or not finite.
Command parse_command(const sim::JsonView& view);

}  // namespace selvedge::editor
