#include "editor/inspectors/body_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>
#include <utility>

#include "editor/inspectors/quantity.h"
#include "sim/core/error.h"
#include "sim/dress/placement.h"

namespace selvedge {
namespace {

constexpr std::array<std::pair<std::string_view, const char*>, 19> kTips{{
    {"height", "Floor to crown."},
    {"inseam", "Floor to the crotch, inside the leg."},
    {"shoulder", "Across, from shoulder joint to shoulder joint."},
    {"arm", "From the shoulder joint over the elbow to the wrist."},
    {"bust", "Level round the fullest part."},
    {"underbust", "Level round the ribs, below the bust."},
    {"waist", "Level round the narrowest part."},
    {"high_hip", "Level, halfway from hip to waist."},
    {"hip", "Level round the fullest part of the seat."},
    {"neck", "Round the neck, lower in front."},
    {"biceps", "Round the upper arm, halfway."},
    {"elbow", "Round the elbow."},
    {"forearm", "Round the forearm, below the elbow."},
    {"wrist", "Round the wrist."},
    {"thigh", "Level round the thigh, 3 cm below the crotch."},
    {"mid_thigh", "Round the thigh, above the knee."},
    {"knee", "Round the knee."},
    {"calf", "Round the fullest part of the calf."},
    {"ankle", "Round the ankle."},
}};

}  // namespace

bool is_mannequin(std::string_view body) {
    return body.empty() || body.starts_with("mannequin");
}

std::string mannequin_text(const MannequinOptions& options) {
    std::string text = options.sex == Sex::Female ? "mannequin:sex=female" : "mannequin:sex=male";
    MannequinMeasures measures = options.measures;
    for (const std::string_view name : measure_names()) {
        const std::optional<double>* value = find_measure(measures, name);
        if (*value) text += "," + std::string(name) + "=" + quantity_figure(**value, Unit::Centimetres);
    }
    if (options.stance) text += ",stance=" + quantity_figure(*options.stance, Unit::Degrees);
    return text;
}

std::string wrong_with_body(const std::string& text) {
    if (!is_mannequin(text)) return "";
    try {
        parse_mannequin(text.empty() ? kUsualBody : text);
        return "";
    } catch (const InputError& error) {
        return error.place() + ": " + error.problem();
    }
}

std::string measure_label(std::string_view name, Sex sex) {
    if (name == "bust" && sex == Sex::Male) return "Chest";
    std::string words(name);
    std::replace(words.begin(), words.end(), '_', ' ');
    if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words;
}

const char* measure_tip(std::string_view name) {
    const auto* const found =
        std::find_if(kTips.begin(), kTips.end(), [&](const auto& entry) { return entry.first == name; });
    return found == kTips.end() ? "" : found->second;
}

SetBody set_body_command(const Pattern& pattern, const std::string& text, const Body& from, const Body& onto) {
    Pattern moved = pattern;
    anchor_panels(moved, from, onto);
    SetBody command{.body = text};
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
        command.shifts.push_back(moved.panels[i].translation - pattern.panels[i].translation);
    }
    return command;
}

}  // namespace selvedge
