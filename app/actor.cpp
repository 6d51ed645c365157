#include "app/actor.h"

#include <algorithm>
#include <utility>

#include "sim/core/error.h"
#include "sim/motion/clear_arms.h"
#include "sim/motion/grounding.h"
#include "sim/motion/motion_file.h"

namespace selvedge::app {
namespace {

// Throws InputError that names the body's own motions too, if there is none of that name.
sim::Clip find_other_motion(const std::string& name, const sim::MadeBody& own) {
    try {
        return sim::find_motion(name, *own.body);
    } catch (const sim::InputError& error) {
        std::string names;
        for (const sim::Clip& clip : own.clips) names += (names.empty() ? "" : ", ") + clip.name;
        if (names.empty() || !error.file().empty()) throw;
        throw sim::InputError("", error.place(), error.problem() + "; the body's own are " + names);
    }
}

// Whether a motion of the body's own file is meant.
bool is_own(const MotionChoice& motion, const sim::MadeBody& own) {
    const std::string& name = motion.name;
    return name.empty() || std::ranges::any_of(own.clips, [&](const sim::Clip& clip) {
               return clip.name == name || clip.name.ends_with("|" + name);
           });
}

// The file of a motion from elsewhere; empty if it ships.
std::string file_of_motion(const std::string& name) {
    for (const std::vector<std::string>& shipped : {sim::motion_names(), sim::pose_names()})
        if (std::ranges::find(shipped, name) != shipped.end()) return {};
    return name.ends_with(".json") ? name : sim::split_clip_name(name).first;
}

// A motion of the body's own file, or else one that ships or is in another file.
sim::Clip choose_motion(const MotionChoice& motion, const sim::MadeBody& own, const std::string& source,
                        std::vector<std::string>& notes) {
    const std::string& name = motion.name;
    if (name.empty() && own.clips.empty())
        throw sim::InputError("", "--motion", "is missing: the body's file has no motion of its own");
    if (!is_own(motion, own)) return find_other_motion(name, own);
    sim::Clip clip = sim::find_clip(own.clips, name, source);
    if (name.empty() && own.clips.size() > 1) notes.push_back(sim::choice_text(own.clips));
    if (clip.name.empty()) clip.name = own.body->name;
    if (motion.opens_arms) sim::clear_arms(*own.body, clip);
    sim::stand_on_floor(*own.body, clip);
    return clip;
}

}  // namespace

Actor make_actor(const BodyOptions& body, const MotionChoice& motion) {
    return make_actor(make_body(body), body.source, motion);
}

Actor make_actor(const sim::MadeBody& own, const std::string& source, const MotionChoice& motion) {
    std::vector<std::string> notes = own.notes;
    if (own.body->skin.empty())
        throw sim::InputError(source, "skin", "is missing: a body moves by bones that its surface is bound to");
    sim::Clip clip = choose_motion(motion, own, source, notes);
    notes.insert(notes.end(), clip.notes.begin(), clip.notes.end());
    const bool is_of_body = is_own(motion, own);
    return {.body = own.body,
            .clip = std::move(clip),
            .notes = std::move(notes),
            .motion_file = is_of_body ? std::string() : file_of_motion(motion.name),
            .can_open_arms = is_of_body && !motion.opens_arms};
}

}  // namespace selvedge::app
