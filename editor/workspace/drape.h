#pragma once
// The garment on its body as the editor shows it: a session that is kept in step with the document, and the body that
// wears it, which is made in a task of its own.
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "editor/document/document.h"
#include "editor/workspace/messages.h"
#include "sim/body/body.h"
#include "sim/body/mannequin.h"
#include "sim/dress/arrangement.h"
#include "sim/dress/session.h"

namespace selvedge {

// Who wears what names nobody.
inline constexpr const char* kUsualBody = "mannequin:sex=female";

// What a new document begins with: no panels, to be placed about the usual body. Without its name panels would be taken
// for GarmentCode's, and moved from that program's body to the one that is seen.
PatternDocument empty_garment();

// A body that can be worn on, with all that views ask of it.
struct WornBody {
    std::string text;  // "mannequin:sex=female,bust=92", or the file it came from
    std::shared_ptr<const Body> body;
    std::optional<MeasureReport> measures;  // of a mannequin
    std::vector<ArrangementPoint> points;
};

// Makes a body from its text or file. Throws InputError. Files are read by the program, so it brings this along.
using BodyMaker = std::function<WornBody(const std::string& text)>;

// A mannequin from its text, as the editor makes it: of the lowest resolution, which is enough to draft on.
WornBody make_worn_mannequin(const std::string& text);

class Drape {
 public:
    explicit Drape(SessionDrive drive, BodyMaker maker = make_worn_mannequin);

    // Takes over what has changed in the document, and a body that is finished. Once per frame of the screen; never
    // waits; but with SessionDrive::Caller it waits for the body, and simulates one frame where the drape runs.
    void follow(const Document& document, Messages& messages);

    // Another document is followed from now on: panels stand where it places them.
    void begin_document();

    // A body of one's own, instead of the document's, until `wear({})`.
    void wear(std::optional<std::string> text);
    bool is_making_body() const { return making_.valid(); }
    const WornBody& worn() const { return worn_; }  // body is null until the first is made

    SessionOptions& options() { return options_; }  // taken over by the next `follow`

    Session& session() { return session_; }
    const Session& session() const { return session_; }
    std::shared_ptr<const SessionFrame> frame() const { return session_.frame(); }

 private:
    void begin_body(const std::string& text);
    void take_body(Messages& messages);

    SessionDrive drive_;
    BodyMaker maker_;
    WornBody worn_;
    std::optional<std::string> own_body_;  // see wear
    std::string wanted_body_;              // text of the body that is worn or being made
    std::future<WornBody> making_;
    SessionOptions options_;
    std::optional<SessionOptions> taken_options_;
    std::optional<std::uint64_t> taken_revision_;
    std::size_t told_messages_ = 0;
    Session session_;
};

}  // namespace selvedge
