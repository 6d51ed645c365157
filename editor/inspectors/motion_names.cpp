#include "editor/inspectors/motion_names.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "sim/motion/motion_file.h"

namespace selvedge::editor {
namespace {

void add(MotionChoices& choices, const std::string& text, const std::string& title, const std::string& chosen) {
    if (std::ranges::find(choices.texts, text) != choices.texts.end()) return;
    if (text == chosen) choices.chosen = static_cast<int>(choices.texts.size());
    choices.texts.push_back(text);
    choices.titles.push_back(title);
}

std::string file_name(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

}  // namespace

std::string title_of(const std::string& name) {
    if (name.size() == 1) return name + "-pose";
    std::string title = name;
    std::ranges::replace(title, '_', ' ');
    if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    return title;
}

MotionChoices motion_choices(const Drape& drape) {
    const std::string& chosen = drape.activity().motion;
    MotionChoices choices;
    add(choices, "", "No motion", chosen);
    for (const sim::Clip& clip : drape.current_body().made().clips)
        if (!clip.name.empty()) add(choices, clip.name, clip.name, chosen);
    for (const std::string& name : sim::motion_names()) add(choices, name, title_of(name), chosen);
    add(choices, chosen, file_name(chosen), chosen);
    choices.shown = choices.titles[static_cast<std::size_t>(choices.chosen)];
    return choices;
}

MotionChoices pose_choices(const Drape& drape) {
    constexpr std::array kEnds{"arms_down", "arms_up", "sit"};  // of motions, in which a garment is looked at
    const std::string& chosen = drape.activity().pose;
    MotionChoices choices;
    add(choices, "", "As it is dressed", chosen);
    if (drape.current_body().has_other_start()) add(choices, kOwnPose, "Its own pose", chosen);
    for (const std::string& name : sim::pose_names()) add(choices, name, title_of(name), chosen);
    for (const char* name : kEnds) add(choices, name, title_of(name), chosen);
    for (const std::string& file : drape.pose_files()) add(choices, file, file_name(file), chosen);
    if (drape.activity().turned) {
        choices.chosen = -1;
        choices.shown = "Turned by hand";
    } else if (drape.frame()->motion.is_in_motion) {
        choices.chosen = -1;
        choices.shown = "As in the motion";
    } else {
        choices.shown = choices.titles[static_cast<std::size_t>(choices.chosen)];
    }
    return choices;
}

}  // namespace selvedge::editor
