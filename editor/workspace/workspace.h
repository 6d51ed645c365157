#pragma once
// The editor's shared state: document, drape, hover, messages and 3D view options. Views, tools and inspectors share
// one Workspace.
#include <cstddef>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/geometry/draft.h"
#include "editor/workspace/body_joints.h"
#include "editor/workspace/drape_verdict.h"
#include "editor/workspace/fabric_library.h"
#include "render/scene/scene.h"
#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/dress/prepared_body.h"
#include "sim/motion/joint_angles.h"
#include "sim/motion/motion_file.h"
#include "sim/place/placement.h"
#include "sim/session/session.h"

namespace selvedge::editor {

// Messages for the user: a text in the status line and the parts of the pattern to highlight.

enum class MessageKind { Note, Warning, Error };

struct Message {
    MessageKind kind = MessageKind::Note;
    std::string text;
    std::vector<PartLocation> places;
};

// The message list, newest last. It keeps the last 200 messages.
class Messages {
 public:
    void say(Message message);
    void note(const std::string& text) { say({.kind = MessageKind::Note, .text = text, .places = {}}); }
    void warn(const std::string& text) { say({.kind = MessageKind::Warning, .text = text, .places = {}}); }
    void error(const GeometryError& error);

    // Hides the newest message; it stays in the list.
    void dismiss() { is_shown_ = false; }

    const Message* shown() const { return is_shown_ && !all_.empty() ? &all_.back() : nullptr; }
    const std::vector<Message>& all() const { return all_; }
    std::size_t count() const { return count_; }  // total number of messages so far, including discarded ones

 private:
    std::vector<Message> all_;
    std::size_t count_ = 0;
    bool is_shown_ = false;
};

// The draped garment and its body: a simulation session synchronized with the document, and the body, which is built
// asynchronously.

// The default body: used if the pattern names no body.
inline constexpr const char* kDefaultBody = "mannequin:sex=female";

// A new document without panels, for the default body. The body is named explicitly: an empty name would mean
// GarmentCode's body (patterns/FORMAT.md), and panels would be moved from that body to the displayed one.
sim::PatternDocument empty_garment();

// The body that is shown and dressed, with the data that the views need beside it.
struct CurrentBody {
    std::shared_ptr<const sim::PreparedBody> prepared{};  // null: none is ready yet
    std::vector<sim::ArrangementPoint> points{};
    std::vector<BodyJoint> joints{};

    const sim::MadeBody& made() const;  // nothing until one is ready
    const std::shared_ptr<const sim::Body>& body() const { return made().body; }

    // Its own pose, and the one in which it is dressed, which may have lowered arms; null: it has no bones.
    std::shared_ptr<const sim::Pose> own_pose() const { return prepared ? prepared->own_pose() : nullptr; }
    std::shared_ptr<const sim::Pose> start_pose() const;
    bool has_other_start() const { return prepared && prepared->stands_otherwise(); }
};

// Finds its arrangement points and its joints.
CurrentBody current_body(sim::MadeBody made);

// Makes a body from its text or file. Throws InputError. The host program provides this function, since it reads the
// files.
using BodyMaker = std::function<CurrentBody(const std::string& text)>;

// Makes a mannequin from its text. Uses one subdivision, which is enough for the editor.
CurrentBody make_mannequin_body(const std::string& text);

// A motion or pose by name or file, on the skeleton of that body, as sim::find_motion takes it. Throws InputError. The
// host program provides this function, since it reads the files.
using MotionFinder = std::function<sim::Clip(const std::string& text, const sim::Body& body)>;

// The pose of the body's own file, of a body that is dressed in another one: with lowered arms.
inline constexpr const char* kOwnPose = "own";

// What the body does while the garment hangs on it. Like the settings of the drape, it is not saved with the garment.
struct BodyActivity {
    // A shipped pose, a file with one, or kOwnPose; empty: as it is dressed.
    std::string pose{};
    std::optional<sim::PoseAngles> turned{};  // that pose with joints turned by hand; none: it is as it is
    std::string motion{};  // a clip of the body's file, a shipped motion, or a file with one; empty: none
    sim::Playback playback{};

    bool operator==(const BodyActivity&) const = default;
};

class Drape {
 public:
    explicit Drape(sim::SessionDrive drive, BodyMaker maker = make_mannequin_body,
                   MotionFinder motions = sim::find_motion);

    // Sends changes of the document, the body and the options to the session, and its messages to `messages`. Call once
    // per displayed frame. Does not block with SessionDrive::Thread. With SessionDrive::Caller it waits for the body
    // and simulates one frame while the drape is running.
    void update(const Document& document, Messages& messages);

    // Call when another document was opened: resets the drape to the panels' placement.
    void begin_document();

    // Call when the file of a fabric was written: the garment takes its values with the next `update`.
    void reread_fabrics();

    // Shows this body instead of the document's; `show_body({})` returns to the document's body.
    void show_body(std::optional<std::string> text);
    bool is_making_body() const { return making_.valid(); }
    sim::SessionDrive drive() const { return drive_; }
    const CurrentBody& current_body() const { return current_body_; }

    sim::SessionOptions& options() { return options_; }  // takes effect at the next `update`
    void look_from(const Vec3f& eye);                    // m: for back faces that are coarsened

    // The body's poses and motions. Poses are gone to, and motions are played, once the garment hangs; a simulation
    // that is paused goes on then. play() also starts one that has not begun.
    const BodyActivity& activity() const { return activity_; }
    void choose_pose(const std::string& name);
    void choose_motion(const std::string& text);
    const std::vector<std::string>& pose_files() const { return pose_files_; }  // that were chosen so far

    // Joints turned by hand. The body follows them from where it stands or goes. angles() are the present ones; null:
    // there is no body with bones yet, or its pose is still looked for. reset_angles() gives the joint the angle of the
    // pose that it had before the first turn.
    const sim::PoseAngles* angles() const;
    void turn(const sim::PoseAngles& angles);
    void reset_angles(const BodyJoint& joint, bool has_both_sides);
    void reset_angles();
    std::shared_ptr<const sim::Pose> shown_pose() const;  // of the body in the newest frame; null: it has no bones
    void set_playback(const sim::Playback& playback) { activity_.playback = playback; }
    bool can_play() const;  // a motion is chosen, or the body has its own, of which play() then chooses the first
    void play();
    void pause_motion();
    void seek(double seconds);
    void back_to_start();  // the body and the garment as they were dressed
    void reset();          // the panels too: as they are placed
    bool is_finding_motion() const { return finding_.valid(); }

    sim::Session& session() { return session_; }
    const sim::Session& session() const { return session_; }
    std::shared_ptr<const sim::SessionFrame> frame() const { return session_.frame(); }

 private:
    // A pose or motion that was looked for.
    struct FoundMotion {
        std::string text;
        std::shared_ptr<const sim::Body> body;
        std::optional<sim::Pose> pose{};
        std::optional<sim::PoseAngles> turned{};  // of the pose
        std::shared_ptr<const sim::Clip> clip{};
        std::string problem{};  // why there is none
    };

    void begin_body(const std::string& text);
    void update_body(Messages& messages);
    void update_activity(Messages& messages);
    void begin_finding(const std::string& text, bool is_pose);
    void begin_turning();
    void take_found(Messages& messages);
    void continue_simulation();
    void stand_as_made();

    sim::SessionDrive drive_;
    BodyMaker maker_;
    MotionFinder motions_;
    CurrentBody current_body_;
    std::optional<std::string> body_override_;  // body set by `show_body`; none: the document's
    std::string wanted_body_;                   // text of the current body or of the one being made
    std::future<CurrentBody> making_;
    sim::SessionOptions options_;
    std::optional<sim::SessionOptions> taken_options_;
    std::optional<Vec3f> taken_eye_;
    std::optional<std::uint64_t> taken_revision_;
    BodyActivity activity_;
    std::optional<std::string> taken_pose_ = "", taken_motion_ = "";  // that the session has; none: to be sent
    std::optional<sim::PoseAngles> taken_turned_;
    std::optional<sim::PoseAngles> unturned_;            // before the first turn by hand
    std::shared_ptr<const sim::Pose> chosen_pose_;       // of the current body: that of taken_pose_
    mutable std::shared_ptr<const sim::Pose> measured_;  // the pose of which these are the angles
    mutable sim::PoseAngles angles_;
    std::vector<std::string> pose_files_;
    std::optional<sim::Playback> taken_playback_;
    bool plays_when_found_ = false;
    std::future<FoundMotion> finding_;
    std::size_t reported_messages_ = 0;
    sim::Session session_;
};

// sim::free_move and sim::place_freely (sim/place/free_place.h) for the document's pattern and the body that the drape
// shows. `drape` null: there is no body.
Vec3d free_move(const Document& document, const Drape* drape, const std::vector<sim::Panel>& panels);
sim::Panel placed_freely(const Document& document, const Drape* drape, sim::Panel panel);

// Display options of the 3D view.
struct ViewOptions {
    render::ShowMode show = render::ShowMode::Tartan;
    bool has_body = true;
    bool has_points = true;                   // arrangement points, while selected panels can be placed
    bool has_joints = false;                  // the joints of the body, which can be turned
    bool has_seam_lines = true;               // connecting lines of open seams
    bool has_edges = false;                   // triangle edges, over plain cloth
    bool is_curved = true;                    // at rest, the curved surface over the cloth instead of its triangles
    bool as_placed = false;                   // shows panels at their placement, even if the garment is sewn
    std::set<std::string> hidden_garments{};  // not drawn
    bool own_axes = false;                    // gizmo for a single panel uses its own axes, not the world axes

    bool operator==(const ViewOptions&) const = default;
};

// The panels that the 3D view does not draw: those that are hidden, and those of hidden garments.
std::set<std::string> undrawn_panels(const sim::Pattern& pattern, const ViewOptions& look, const PanelStates& states);

struct Workspace {
    Workspace(sim::PatternDocument source, sim::SessionDrive drive, BodyMaker maker,
              MotionFinder motions = sim::find_motion, FabricReader fabric_reader = sim::read_fabric_file)
        : document(std::make_unique<Document>(std::move(source))),
          drape(drive, std::move(maker), std::move(motions)),
          fabrics(std::move(fabric_reader)) {}

    std::unique_ptr<Document> document;  // replaced when a file is opened
    std::string file{};                  // the document's file; empty: not saved yet
    Drape drape;
    FabricLibrary fabrics;
    JointChoice joint{};
    Hover hover{};
    Messages messages{};
    ViewOptions look{};
    FindingPlace lit{};  // of a finding about the drape: shown on the sheet and in the 3D view

    // Puts the garments of a file over the document's, moved to the body that this one names. Assumptions become notes.
    // Throws InputError if the document's body cannot be made.
    bool wear_over(const sim::PatternDocument& outer);

    // Applies a command; a GeometryError becomes a message. Returns whether the command was applied.
    bool run(const Command& command) { return run_together({command}); }
    bool run_together(const std::vector<Command>& commands);  // as one step of the history; none: no effect
    bool preview(const Command& command);

    // Shows what the document did besides (Document::take_notes).
    void tell_notes();
};

// The joint that the user has chosen; null: none, or the present body does not have it.
const BodyJoint* chosen_joint(const Workspace& workspace);

// The axes about which the angles of that joint count, in our frame, where the body is shown. Pre: Drape::angles() is
// not null.
Eigen::Quaterniond axes_of(const Drape& drape, const BodyJoint& joint);

}  // namespace selvedge::editor
