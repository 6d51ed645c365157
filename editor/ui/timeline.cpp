#include "editor/ui/timeline.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "editor/frame/item.h"
#include "editor/inspectors/motion_names.h"
#include "editor/ui/action.h"
#include "editor/ui/app_state.h"
#include "editor/ui/files.h"
#include "editor/ui/widgets.h"

namespace selvedge::editor {
namespace {

constexpr float kTrack = 1.7F;  // font heights

std::string seconds_of(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", seconds);
    return text;
}

// The distance of labelled ticks, s: 1, 2 or 5 times a power of ten, at least so many px apart.
double tick_step(double length, float width_px, float least_px) {
    const double least = length * static_cast<double>(least_px) / static_cast<double>(std::max(1.0F, width_px));
    const double power = std::pow(10, std::floor(std::log10(std::max(least, 1e-3))));
    for (const double times : {1.0, 2.0, 5.0})
        if (times * power >= least) return times * power;
    return 10 * power;
}

std::string tick_text(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%g s", std::round(100 * seconds) / 100);
    return text;
}

struct Track {
    ImVec2 low;
    float width = 0, height = 0;
    double length = 0;  // s

    float x_of(double seconds) const {
        return length > 0 ? low.x + width * static_cast<float>(std::clamp(seconds / length, 0.0, 1.0)) : low.x;
    }
};

void draw_ticks(ImDrawList& list, const Theme& theme, const Track& track) {
    const float unit = ImGui::GetFontSize();
    const double step = tick_step(track.length, track.width, 4.5F * unit);
    const float base = track.low.y + track.height;
    for (int i = 0; i * step / 5 <= track.length * (1 + 1e-9) && i < 1000; ++i) {
        const float x = std::floor(track.x_of(i * step / 5)) + 0.5F;
        const bool is_labelled = i % 5 == 0;
        list.AddLine({x, base - (is_labelled ? 0.5F : 0.25F) * unit}, {x, base}, colour_of(theme.faint, 150));
        if (!is_labelled) continue;
        const std::string text = tick_text(i * step / 5);
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        const float left = std::min(x + 0.25F * unit, track.low.x + track.width - width);
        if (left >= x) list.AddText({left, track.low.y + 0.1F * unit}, colour_of(theme.faint), text.c_str());
    }
}

void draw_playhead(ImDrawList& list, const Theme& theme, const Track& track, double seconds) {
    const float half = 0.32F * ImGui::GetFontSize();
    const float x = std::floor(track.x_of(seconds)) + 0.5F, top = track.low.y, bottom = track.low.y + track.height;
    list.AddRectFilled({track.low.x, bottom - half / 2}, {x, bottom}, colour_of(theme.accent, 110));
    list.AddLine({x, top}, {x, bottom}, colour_of(theme.accent), 0.12F * ImGui::GetFontSize());
    list.AddTriangleFilled({x - half, top}, {x + half, top}, {x, top + 1.4F * half}, colour_of(theme.accent));
}

// Why there is no time to show.
const char* empty_text(const AppState& state) {
    const Drape& drape = state.workspace.drape;
    if (drape.is_finding_motion()) return "Reading the motion";
    if (drape.current_body().body() && !drape.frame()->motion.can_move) return "This body has no bones to move by";
    return drape.can_play() ? "Play, or choose a motion below" : "Choose a motion below";
}

// The motion's time as a strip: a press or a drag seeks. A motion that plays goes on where it is let go.
void show_track(AppState& state, const sim::SessionMotion& motion) {
    Drape& drape = state.workspace.drape;
    const float inset = 0.4F * ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const Track track{.low = {low.x + inset, low.y},
                      .width = std::max(1.0F, ImGui::GetContentRegionAvail().x - 2 * inset),
                      .height = std::floor(kTrack * ImGui::GetFontSize()),
                      .length = motion.length};
    ImGui::InvisibleButton("##track", {track.width + 2 * inset, track.height});
    note_widget(state.widgets, "timeline.track");
    if (ImGui::IsItemActivated()) {
        state.timeline.plays_on = motion.is_playing;
        state.timeline.sought.reset();
    }
    double shown = motion.seconds;
    if (ImGui::IsItemActive() && track.length > 0) {
        const double share = std::clamp((ImGui::GetIO().MousePos.x - track.low.x) / track.width, 0.0F, 1.0F);
        shown = share * track.length;
        if (state.timeline.sought != shown) drape.seek(shown);
        state.timeline.sought = shown;
    }
    if (ImGui::IsItemDeactivated() && state.timeline.plays_on) drape.play();
    show_tip("The time of the motion: drag it. The body goes there as fast as the cloth can follow.", kTipWidth);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({low.x, low.y}, {low.x + track.width + 2 * inset, low.y + track.height},
                       colour_of(state.theme.field), 3);
    if (track.length > 0) {
        draw_ticks(list, state.theme, track);
        draw_playhead(list, state.theme, track, shown);
    } else {
        const float top = low.y + (track.height - ImGui::GetTextLineHeight()) / 2;
        list.AddText({track.low.x, top}, colour_of(state.theme.faint), empty_text(state));
    }
    list.AddRect({low.x, low.y}, {low.x + track.width + 2 * inset, low.y + track.height}, colour_of(state.theme.line),
                 3);
}

void show_motions(AppState& state, float width) {
    Drape& drape = state.workspace.drape;
    const MotionChoices choices = motion_choices(drape);
    ImGui::SetNextItemWidth(width);
    const bool is_open = ImGui::BeginCombo(
        "##motion", elided(choices.shown, width - 2 * ImGui::GetFrameHeight()).c_str(), ImGuiComboFlags_HeightLarge);
    note_widget(state.widgets, "timeline.motion");
    show_tip("What the body does: the motions of its file, and those that ship", kTipWidth);
    if (!is_open) return;
    for (std::size_t i = 0; i < choices.texts.size(); ++i) {
        const bool is_chosen = static_cast<int>(i) == choices.chosen;
        if (ImGui::Selectable((choices.titles[i] + "##" + choices.texts[i]).c_str(), is_chosen))
            drape.choose_motion(choices.texts[i]);
        note_widget(state.widgets, "timeline.motion." + choices.texts[i]);
    }
    ImGui::Separator();
    if (ImGui::Selectable("From file...")) browse_for_motion(state);
    ImGui::EndCombo();
}

void show_speeds(AppState& state, float width) {
    constexpr std::array kSpeeds{0.1, 0.25, 0.5, 1.0, 1.5, 2.0};
    sim::Playback playback = state.workspace.drape.activity().playback;
    const auto text = [](double speed) {
        char shown[16];
        std::snprintf(shown, sizeof shown, "%g\u00D7", speed);
        return std::string(shown);
    };
    ImGui::SetNextItemWidth(width);
    const bool is_open = ImGui::BeginCombo("##speed", text(playback.speed).c_str());
    note_widget(state.widgets, "timeline.speed");
    show_tip("The speed of the motion", kTipWidth);
    if (!is_open) return;
    for (const double speed : kSpeeds) {
        if (ImGui::Selectable(text(speed).c_str(), speed == playback.speed)) {
            playback.speed = speed;
            state.workspace.drape.set_playback(playback);
        }
        note_widget(state.widgets, "timeline.speed." + seconds_of(speed));
    }
    ImGui::EndCombo();
}

// The time, or why it does not go on.
std::string state_text(const sim::SessionMotion& motion) {
    if (motion.is_waiting) return "Waits until the garment hangs";
    if (motion.length <= 0) return "";
    return seconds_of(motion.seconds) + " / " + seconds_of(motion.length) + " s";
}

void show_icon(AppState& state, const char* action, const char* icon) {
    icon_button(state, *find_action(state.actions, action), icon, ImGui::GetFrameHeight());
    ImGui::SameLine();
}

}  // namespace

float timeline_height() {
    const float unit = ImGui::GetFontSize();
    return std::floor(kTrack * unit) + ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y + 0.7F * unit;
}

void show_timeline(AppState& state) {
    const std::shared_ptr<const sim::SessionFrame> frame = state.workspace.drape.frame();
    const sim::SessionMotion& motion = frame->motion;
    const float unit = ImGui::GetFontSize();
    show_track(state, motion);
    show_icon(state, "motion.start", "to_start");
    show_icon(state, "motion.play", motion.is_playing ? "pause" : "play");
    show_icon(state, "motion.loop", "loop");
    const float speed = 4.2F * unit, spacing = ImGui::GetStyle().ItemSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x - speed - 8.5F * unit - 2 * spacing;
    show_motions(state, std::clamp(room, 4 * unit, 11 * unit));
    ImGui::SameLine();
    show_speeds(state, speed);
    ImGui::SameLine();
    const float left = ImGui::GetContentRegionAvail().x;
    const std::string text = state_text(motion);
    const std::string shown = elided(text, left);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, left - ImGui::CalcTextSize(shown.c_str()).x));
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", shown.c_str());
    tip_of_whole(text, shown);
}

}  // namespace selvedge::editor
