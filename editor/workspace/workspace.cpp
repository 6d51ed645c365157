#include "editor/workspace/workspace.h"

#include <chrono>

#include "sim/core/error.h"
#include "sim/dress/anchor.h"
#include "sim/dress/dress.h"
#include "sim/pattern/garments.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::editor {
bool Workspace::run(const Command& command) {
    try {
        document->run(command);
        return true;
    } catch (const GeometryError& error) {
        messages.error(error);
        return false;
    }
}

bool Workspace::preview(const Command& command) {
    try {
        document->preview(command);
        return true;
    } catch (const GeometryError& error) {
        messages.error(error);
        return false;
    }
}

void Messages::say(Message message) {
    constexpr std::size_t kMaxMessages = 200;
    all_.push_back(std::move(message));
    if (all_.size() > kMaxMessages) all_.erase(all_.begin());
    ++count_;
    is_shown_ = true;
}

void Messages::error(const GeometryError& error) {
    say({.kind = MessageKind::Error, .text = error.what(), .places = error.places()});
}

sim::PatternDocument empty_garment() {
    constexpr double kUsualStature = 1.606;  // m, stature of the default body
    sim::PatternDocument garment;
    garment.pattern.body = kDefaultBody;
    garment.pattern.body_height = kUsualStature;
    return garment;
}

CurrentBody make_mannequin_body(const std::string& text) {
    sim::MannequinOptions options = sim::parse_mannequin(text);
    options.subdivisions = 1;
    sim::Mannequin mannequin = make_mannequin(options);
    CurrentBody made{.text = text,
                     .body = std::make_shared<const sim::Body>(std::move(mannequin.body)),
                     .measures = std::move(mannequin.report),
                     .points = {}};
    made.points = arrangement_points(*made.body);
    return made;
}

Drape::Drape(sim::SessionDrive drive, BodyMaker maker) : drive_(drive), maker_(std::move(maker)), session_(drive) {}

void Drape::show_body(std::optional<std::string> text) {
    body_override_ = std::move(text);
}

void Drape::begin_document() {
    taken_revision_.reset();
    session_.reset();
}

void Drape::begin_body(const std::string& text) {
    wanted_body_ = text;
    making_ = std::async(std::launch::async, maker_, text);
}

void Drape::update_body(Messages& messages) {
    try {
        current_body_ = making_.get();
        session_.set_body(current_body_.body);
        for (const std::string& note : current_body_.notes) messages.note("Body: " + note);
    } catch (const sim::InputError& error) {
        messages.say({.kind = MessageKind::Error, .text = error.what(), .places = {}});
    }
}

void Drape::update(const Document& document, Messages& messages) {
    const std::string drafted = document.pattern().body.empty() ? kDefaultBody : document.pattern().body;
    const std::string text = body_override_.value_or(drafted);
    if (!making_.valid() && text != wanted_body_) begin_body(text);
    const bool waits = drive_ == sim::SessionDrive::Caller;
    if (making_.valid() && (waits || making_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)) {
        update_body(messages);
    }
    if (!taken_options_ || !(*taken_options_ == options_)) {
        taken_options_ = options_;
        session_.set_options(options_);
    }
    if (taken_revision_ != document.revision()) {
        taken_revision_ = document.revision();
        session_.set_pattern(document.pattern());
    }
    if (waits) session_.advance(session_.frame()->is_running ? 1 : 0);
    const std::vector<std::string> reported = session_.frame()->messages;
    reported_messages_ = std::min(reported_messages_, reported.size());
    for (; reported_messages_ < reported.size(); ++reported_messages_) messages.note(reported[reported_messages_]);
}

bool Workspace::wear_over(const sim::PatternDocument& outer) {
    std::vector<std::string> notes;
    const sim::PatternDocument moved{moved_to_body_of(document->pattern(), outer.pattern, notes), outer.json};
    sim::Pattern worn = document->pattern();
    for (std::string& note : put_over(worn, moved.pattern)) notes.push_back(std::move(note));
    if (!run(PutOver{.file = outer.pattern.name + ".json", .text = write_pattern(moved)})) return false;
    for (const std::string& note : notes) messages.note(note);
    return true;
}

}  // namespace selvedge::editor
