#pragma once
// Every change that can be made to a pattern, as plain data. Tools, menus, scripts and the journal all make commands,
// and Document::run is the one door through which they come.
//
// Metres and radians; points in the panel's held frame. Panels by name, their parts by index. `name` is what a command
// is called in scripts and journals, `fields` lists its fields for them (command_json.h).
#include <string>
#include <variant>

#include "editor/document/outline_commands.h"
#include "editor/document/panel_commands.h"
#include "editor/document/pattern_commands.h"
#include "editor/document/seam_commands.h"

namespace selvedge {

using Command =
    std::variant<RenamePattern, SetFabric, SetTartan, SetBody, SetEdgeLength, MatchSetts, TranslateAll, RemoveParts,
                 AddPanels, RenamePanel, DuplicatePanel, SymmetricCopy, UnlinkPanel, MovePanels, TransformPanels,
                 PlacePanel, PlacePanels, SetGrain, SetSettOffset, SetPins, SetLayer, CutPanel, MergePanels,
                 UnfoldPanel, MoveVertices, TransformVertices, SetCurve, AddVertex, AddDart, AddInternalLine,
                 SetInternalLine, AddNotch, MoveNotch, SewEdges, SewRuns, ReverseSeam, NameSeam, AcceptEase, EvenSeam>;

// What it is called in the history: "Move 3 points".
std::string label_of(const Command& command);

}  // namespace selvedge
