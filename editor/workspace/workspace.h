#pragma once
// All that a person works on, in one place that views and inspectors share.
#include <cstddef>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/geometry/draft.h"
#include "render/scene/scene.h"
#include "sim/body/body.h"
#include "sim/dress/session.h"
#include "sim/mannequin/mannequin.h"
#include "sim/place/arrangement.h"

namespace selvedge::editor {

// What the editor has to say to the person at it: words in the status line, and places that are lit up with them.

enum class MessageKind { Note, Warning, Error };

struct Message {
    MessageKind kind = MessageKind::Note;
    std::string words;
    std::vector<GeometryPlace> places;
};

// The newest is last. Old ones are forgotten.
class Messages {
 public:
    void say(Message message);
    void note(const std::string& words) { say({.kind = MessageKind::Note, .words = words, .places = {}}); }
    void warn(const std::string& words) { say({.kind = MessageKind::Warning, .words = words, .places = {}}); }
    void error(const GeometryError& error);

    // Takes the newest off the screen; the list keeps it.
    void dismiss() { is_shown_ = false; }

    const Message* shown() const { return is_shown_ && !all_.empty() ? &all_.back() : nullptr; }
    const std::vector<Message>& all() const { return all_; }
    std::size_t count() const { return count_; }  // ever said

 private:
    std::vector<Message> all_;
    std::size_t count_ = 0;
    bool is_shown_ = false;
};

// The garment on its body as the editor shows it: a session that is kept in step with the document, and the body that
// wears it, which is made in a task of its own.

// Who wears what names nobody.
inline constexpr const char* kDefaultBody = "mannequin:sex=female";

// What a new document begins with: no panels, to be placed about the usual body. Without its name panels would be taken
// for GarmentCode's, and moved from that program's body to the one that is seen.
sim::PatternDocument empty_garment();

// A body that can be worn on, with all that views ask of it.
struct CurrentBody {
    std::string text;  // "mannequin:sex=female,bust=92", or the file it came from
    std::shared_ptr<const sim::Body> body;
    std::optional<sim::MeasureReport> measures;  // of a mannequin
    std::vector<sim::ArrangementPoint> points;
};

// Makes a body from its text or file. Throws InputError. Files are read by the program, so it brings this along.
using BodyMaker = std::function<CurrentBody(const std::string& text)>;

// A mannequin from its text, as the editor makes it: of the lowest resolution, which is enough to draft on.
CurrentBody make_worn_mannequin(const std::string& text);

class Drape {
 public:
    explicit Drape(sim::SessionDrive drive, BodyMaker maker = make_worn_mannequin);

    // Takes over what has changed in the document, and a body that is finished. Once per frame of the screen; never
    // waits; but with SessionDrive::Caller it waits for the body, and simulates one frame where the drape runs.
    void follow(const Document& document, Messages& messages);

    // Another document is followed from now on: panels stand where it places them.
    void begin_document();

    // A body of one's own, instead of the document's, until `wear({})`.
    void wear(std::optional<std::string> text);
    bool is_making_body() const { return making_.valid(); }
    const CurrentBody& worn() const { return worn_; }  // body is null until the first is made

    sim::SessionOptions& options() { return options_; }  // taken over by the next `follow`

    sim::Session& session() { return session_; }
    const sim::Session& session() const { return session_; }
    std::shared_ptr<const sim::SessionFrame> frame() const { return session_.frame(); }

 private:
    void begin_body(const std::string& text);
    void take_body(Messages& messages);

    sim::SessionDrive drive_;
    BodyMaker maker_;
    CurrentBody worn_;
    std::optional<std::string> own_body_;  // see wear
    std::string wanted_body_;              // text of the body that is worn or being made
    std::future<CurrentBody> making_;
    sim::SessionOptions options_;
    std::optional<sim::SessionOptions> taken_options_;
    std::optional<std::uint64_t> taken_revision_;
    std::size_t reported_messages_ = 0;
    sim::Session session_;
};

// How the 3D view shows the garment.
struct FittingLook {
    render::ShowMode show = render::ShowMode::Tartan;
    bool has_body = true;
    bool has_points = true;   // arrangement points, while a panel is selected and nothing runs
    bool has_threads = true;  // of seams that are not closed
    bool has_edges = false;   // of triangles, over plain cloth
    bool as_placed = false;   // panels where they are placed, also while the garment hangs sewn
    bool own_axes = false;    // a single panel is moved and turned along its own axes, not the room's

    bool operator==(const FittingLook&) const = default;
};

struct Workspace {
    Workspace(sim::PatternDocument source, sim::SessionDrive drive, BodyMaker maker)
        : document(std::make_unique<Document>(std::move(source))), drape(drive, std::move(maker)) {}

    std::unique_ptr<Document> document;  // another one when a file is opened
    std::string file{};                  // where it is saved; empty: nowhere yet
    Drape drape;
    Hover hover{};
    Messages messages{};
    FittingLook look{};

    // Runs a command; what is wrong with it becomes a message. False: it was not carried out.
    bool run(const Command& command);
    bool preview(const Command& command);
};

}  // namespace selvedge::editor
