#pragma once
// All that a person works on, in one place that views and inspectors share.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/hover.h"
#include "editor/workspace/drape.h"
#include "editor/workspace/messages.h"
#include "render/scene/scene.h"

namespace selvedge {

// How the 3D view shows the garment.
struct FittingLook {
    ShowMode show = ShowMode::Tartan;
    bool has_body = true;
    bool has_points = true;   // arrangement points, while a panel is selected and nothing runs
    bool has_threads = true;  // of seams that are not closed
    bool has_edges = false;   // of triangles, over plain cloth
    bool as_placed = false;   // panels where they are placed, also while the garment hangs sewn
    bool own_axes = false;    // a single panel is moved and turned along its own axes, not the room's

    bool operator==(const FittingLook&) const = default;
};

struct Workspace {
    Workspace(PatternDocument source, SessionDrive drive, BodyMaker maker)
        : document(std::make_unique<Document>(std::move(source))), drape(drive, std::move(maker)) {}

    std::unique_ptr<Document> document;  // another one when a file is opened
    std::string file{};                  // where it is saved; empty: nowhere yet
    Drape drape;
    Hover hover{};
    Messages messages{};
    FittingLook look{};

    // Runs a command; what is wrong with it becomes a message. False: it was not carried out.
    bool run(const Command& command);
    bool attempt(const Command& command);
};

}  // namespace selvedge
