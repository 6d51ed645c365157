#include "editor/workspace/workspace.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/printable.h"
#include "sim/dress/anchor.h"
#include "sim/mannequin/mannequin.h"
#include "sim/motion/grounding.h"
#include "sim/pattern/garments.h"
#include "sim/pattern/pattern_file.h"
#include "sim/place/free_place.h"
#include "sim/session/dress.h"

namespace selvedge::editor {
std::set<std::string> undrawn_panels(const sim::Pattern& pattern, const ViewOptions& look, const PanelStates& states) {
    std::set<std::string> undrawn = states.hidden;
    if (look.hidden_garments.empty()) return undrawn;
    for (const sim::Panel& panel : pattern.panels) {
        if (look.hidden_garments.contains(garment_of(pattern, panel))) undrawn.insert(panel.name);
    }
    return undrawn;
}

bool Workspace::run_together(const std::vector<Command>& commands) {
    if (commands.empty()) return true;
    try {
        document->run_together(commands);
        tell_notes();
        return true;
    } catch (const GeometryError& error) {
        messages.error(error);
        return false;
    }
}

void Workspace::tell_notes() {
    for (const std::string& text : document->take_notes()) messages.warn(sim::printable(text));
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

namespace {

const sim::Body* body_of(const Drape* drape) {
    return drape == nullptr ? nullptr : drape->current_body().body().get();
}

}  // namespace

Vec3d free_move(const Document& document, const Drape* drape, const std::vector<sim::Panel>& panels) {
    return sim::free_move(document.pattern(), panels, body_of(drape));
}

sim::Panel placed_freely(const Document& document, const Drape* drape, sim::Panel panel) {
    place_freely(panel, document.pattern(), body_of(drape));
    return panel;
}

const BodyJoint* chosen_joint(const Workspace& workspace) {
    const std::vector<BodyJoint>& joints = workspace.drape.current_body().joints;
    const auto found = std::ranges::find(joints, workspace.joint.bone.value_or(-1), &BodyJoint::bone);
    return found == joints.end() ? nullptr : &*found;
}

Eigen::Quaterniond axes_of(const Drape& drape, const BodyJoint& joint) {
    return axes_of_angles(*drape.current_body().body(), *drape.shown_pose(), *drape.angles(), joint.bone);
}

sim::PatternDocument empty_garment() {
    constexpr double kUsualStature = 1.606;  // m, stature of the default body
    sim::PatternDocument garment;
    garment.pattern.body = kDefaultBody;
    garment.pattern.body_height = kUsualStature;
    return garment;
}

const sim::MadeBody& CurrentBody::made() const {
    static const sim::MadeBody none;
    return prepared ? prepared->made() : none;
}

std::shared_ptr<const sim::Pose> CurrentBody::start_pose() const {
    return has_other_start() ? prepared->dressing_pose() : own_pose();
}

CurrentBody current_body(sim::MadeBody made) {
    CurrentBody current{.prepared = std::make_shared<const sim::PreparedBody>(std::move(made))};
    current.points = arrangement_points(*current.body());
    current.joints = joints_of(*current.body());
    return current;
}

CurrentBody make_mannequin_body(const std::string& text) {
    sim::MannequinOptions options = sim::parse_mannequin(text);
    options.subdivisions = 1;
    sim::MadeBody made = make_body(options);
    made.source = text;
    return current_body(std::move(made));
}

Drape::Drape(sim::SessionDrive drive, BodyMaker maker, MotionFinder motions)
    : drive_(drive), maker_(std::move(maker)), motions_(std::move(motions)), session_(drive) {
    options_.reports_faults = true;
}

void Drape::show_body(std::optional<std::string> text) {
    body_override_ = std::move(text);
}

void Drape::look_from(const Vec3f& eye) {
    if (!options_.coarsens_back_faces || taken_eye_ == eye) return;
    taken_eye_ = eye;
    session_.look_from({.eye = eye});
}

void Drape::begin_document() {
    taken_revision_.reset();
    reset();
}

// The pattern is sent again, too: the session may have refused it for a fabric that can be read now.
void Drape::reread_fabrics() {
    taken_revision_.reset();
    session_.reread_fabrics();
}

void Drape::begin_body(const std::string& text) {
    wanted_body_ = text;
    making_ = std::async(std::launch::async, maker_, text);
}

void Drape::update_body(Messages& messages) {
    try {
        current_body_ = making_.get();
        session_.set_body(current_body_.prepared);
        stand_as_made();
        taken_motion_ = "";
        taken_turned_.reset();
        for (std::optional<sim::PoseAngles>* angles : {&activity_.turned, &unturned_})
            if (*angles) (*angles)->bones.clear();  // those of another body
        if (current_body_.made().readings) return;  // what could not be met stands beside the measures
        for (const std::string& note : current_body_.made().notes) messages.note("Body: " + note);
    } catch (const sim::InputError& error) {
        messages.say({.kind = MessageKind::Error, .text = error.what(), .places = {}});
    }
}

// Poses and motions.

// The session's new body stands as it is dressed, has no motion, and goes into its own pose if that is another.
void Drape::stand_as_made() {
    taken_pose_ = current_body_.has_other_start() ? kOwnPose : "";
    if (activity_.pose.empty() || activity_.pose == kOwnPose) activity_.pose = *taken_pose_;
}

void Drape::continue_simulation() {
    const sim::SessionFrame& frame = *session_.frame();
    const bool is_sewn = frame.stage != sim::SessionStage::Empty && frame.stage != sim::SessionStage::Placed;
    if (is_sewn && !frame.is_running && frame.stage != sim::SessionStage::Failed) session_.start();
}

void Drape::choose_pose(const std::string& name) {
    activity_.pose = name;
    activity_.turned.reset();
    taken_pose_.reset();  // sent also if it is the same: the body may have left it since
    if (name.ends_with(".json") && std::ranges::find(pose_files_, name) == pose_files_.end())
        pose_files_.push_back(name);
    continue_simulation();
}

std::shared_ptr<const sim::Pose> Drape::shown_pose() const {
    const std::shared_ptr<const sim::Pose> pose = session_.frame()->motion.pose;
    const std::shared_ptr<const sim::Pose> own = current_body_.own_pose();
    return pose && own && pose->bones.size() == own->bones.size() ? pose : own;
}

const sim::PoseAngles* Drape::angles() const {
    if (!current_body_.own_pose()) return nullptr;
    if (activity_.turned) return &*activity_.turned;
    std::shared_ptr<const sim::Pose> pose;
    if (session_.frame()->motion.is_in_motion) {
        pose = shown_pose();
    } else if (taken_pose_ == activity_.pose) {
        pose = activity_.pose.empty()       ? current_body_.start_pose()
               : activity_.pose == kOwnPose ? current_body_.own_pose()
                                            : chosen_pose_;
    }
    if (!pose) return nullptr;
    if (measured_ != pose) angles_ = pose_angles(*current_body_.body(), *pose);
    measured_ = pose;
    return &angles_;
}

void Drape::turn(const sim::PoseAngles& angles) {
    const sim::PoseAngles* now = this->angles();
    if (!now) return;
    if (!activity_.turned) unturned_ = *now;
    activity_.turned = angles;
    plays_when_found_ = false;
    continue_simulation();
}

void Drape::reset_angles(const BodyJoint& joint, bool has_both_sides) {
    if (!activity_.turned || !unturned_) return;
    set_angles(*activity_.turned, joint, angles_of(*unturned_, joint), false);
    if (has_both_sides && joint.joint) {
        const auto other = static_cast<std::size_t>(mirrored(*joint.joint));
        activity_.turned->joints[other] = unturned_->joints[other];
    }
    continue_simulation();
}

void Drape::reset_angles() {
    if (activity_.turned) choose_pose(activity_.pose);
}

void Drape::choose_motion(const std::string& text) {
    activity_.motion = text;
    plays_when_found_ = false;
}

bool Drape::can_play() const {
    return !activity_.motion.empty() ||
           std::ranges::any_of(current_body_.made().clips, [](const sim::Clip& clip) { return !clip.name.empty(); });
}

void Drape::play() {
    if (!can_play()) return;
    if (activity_.motion.empty()) {
        choose_motion(std::ranges::find_if(current_body_.made().clips, [](const sim::Clip& clip) {
                          return !clip.name.empty();
                      })->name);
    }
    activity_.turned.reset();
    if (!session_.frame()->is_running) session_.start();
    if (taken_motion_ == activity_.motion) {
        session_.play();
    } else {
        plays_when_found_ = true;
    }
}

void Drape::pause_motion() {
    plays_when_found_ = false;
    session_.pause_motion();
}

void Drape::seek(double seconds) {
    activity_.turned.reset();
    session_.seek(seconds);
    continue_simulation();
}

void Drape::back_to_start() {
    activity_.pose.clear();
    activity_.turned.reset();
    taken_pose_ = "";
    plays_when_found_ = false;
    session_.back_to_start();
}

void Drape::reset() {
    back_to_start();
    session_.reset();
    stand_as_made();
}

void Drape::begin_finding(const std::string& text, bool is_pose) {
    const auto find = [text, is_pose, body = current_body_.body(), own = current_body_.made().clips,
                       motions = motions_] {
        FoundMotion found{.text = text, .body = body};
        try {
            const auto clip = std::ranges::find(own, text, &sim::Clip::name);
            sim::Clip motion = clip != own.end() ? *clip : motions(text, *body);
            if (clip != own.end()) stand_on_floor(*body, motion);
            if (!is_pose) {
                found.clip = std::make_shared<const sim::Clip>(std::move(motion));
            } else {
                found.pose = sample(*body, motion, motion.seconds);
                stand_on_floor(*body, *found.pose);
            }
        } catch (const sim::InputError& error) {
            found.problem = error.what();
        }
        return found;
    };
    finding_ = std::async(std::launch::async, find);
}

void Drape::begin_turning() {
    const auto find = [angles = *activity_.turned, body = current_body_.body()] {
        return FoundMotion{.text = {}, .body = body, .pose = pose_of(angles, *body), .turned = angles};
    };
    finding_ = std::async(std::launch::async, find);
}

void Drape::take_found(Messages& messages) {
    const FoundMotion found = finding_.get();
    if (found.body != current_body_.body()) return;  // looked for again on the body that is there now
    if (found.turned) {
        taken_turned_ = found.turned;
        if (activity_.turned) session_.follow(found.body, *found.pose);
        return;
    }
    const bool is_pose = found.pose.has_value();
    if (!found.problem.empty()) {
        messages.say({.kind = MessageKind::Error, .text = found.problem, .places = {}});
        std::erase(pose_files_, found.text);
        if (activity_.pose == found.text) activity_.pose = *(taken_pose_ = "");
        if (activity_.motion == found.text) activity_.motion = *(taken_motion_ = "");
    } else if (is_pose) {
        taken_pose_ = found.text;
        chosen_pose_ = std::make_shared<const sim::Pose>(*found.pose);
        if (activity_.pose == found.text && !activity_.turned) session_.go_to(found.body, *found.pose);
    } else {
        taken_motion_ = found.text;
        for (const std::string& note : found.clip->notes) messages.note(note);
        session_.set_clip(found.body, found.clip);
        if (activity_.motion == found.text && std::exchange(plays_when_found_, false)) session_.play();
    }
}

void Drape::update_activity(Messages& messages) {
    const bool waits = drive_ == sim::SessionDrive::Caller;
    if (finding_.valid() && (waits || finding_.wait_for(std::chrono::seconds(0)) == std::future_status::ready))
        take_found(messages);
    if (taken_playback_ != activity_.playback) {
        taken_playback_ = activity_.playback;
        session_.set_playback(activity_.playback);
    }
    const std::shared_ptr<const sim::Body>& body = current_body_.body();
    if (finding_.valid() || !body || body->skin.empty() || body->bones.empty()) return;
    if (taken_turned_ != activity_.turned) {
        if (activity_.turned) return begin_turning();
        taken_turned_.reset();
    }
    if (!activity_.turned && taken_pose_ != activity_.pose) {
        const bool is_own = activity_.pose == kOwnPose;
        if (!is_own && !activity_.pose.empty()) return begin_finding(activity_.pose, true);
        taken_pose_ = activity_.pose;
        session_.go_to(body, is_own ? *current_body_.own_pose() : *current_body_.start_pose());
    }
    if (taken_motion_ != activity_.motion) {
        if (!activity_.motion.empty()) return begin_finding(activity_.motion, false);
        taken_motion_ = "";
        session_.set_clip(body, nullptr);
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
    update_activity(messages);
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
