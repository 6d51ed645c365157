#include "editor/inspectors/tartan_list.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "editor/inspectors/controls.h"
#include "editor/inspectors/fabric_text.h"
#include "editor/inspectors/number_box.h"
#include "editor/inspectors/threadcount_text.h"
#include "editor/workspace/sett_picture.h"
#include "sim/core/error.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge {
namespace {

constexpr int kListedPx = 96;       // side of a listed tartan's picture, one repeat
constexpr float kRowHeight = 2.4F;  // of the font's size
constexpr float kListHeight = 13.0F;
constexpr float kWovenSide = 14.0F;
constexpr int kThreadsBefore = 8;
constexpr float kThread = 0.27F;  // of the font's size: a thread of the woven picture
constexpr float kRepeat = 5.0F;   // a repeat beside it

UiTexture take_texture(const InspectorContext& context) {
    return context.take_texture ? context.take_texture() : 0;
}

void hold(InspectorContext& context, UiTexture texture, Image picture) {
    if (texture != 0) context.output.pictures.push_back({.texture = texture, .picture = std::move(picture)});
}

std::string shown_name(const std::string& name, const Sett& sett) {
    return sett.name.empty() ? readable_name(name) : sett.name;
}

void make_pictures(InspectorContext& context) {
    MaterialState& state = context.state.material;
    if (!state.tartans.empty()) return;
    for (const std::string& name : shipped_tartans()) {
        TartanPicture entry{.shown_as = {}, .sett = find_tartan(name), .texture = take_texture(context)};
        entry.shown_as = shown_name(name, entry.sett);
        hold(context, entry.texture, sett_picture(entry.sett, {.width_px = kListedPx, .height_px = kListedPx}));
        state.tartans.emplace_back(name, std::move(entry));
    }
}

void draw_picture(const InspectorContext& context, UiTexture texture, const ImVec2& size, const ImVec2& share) {
    const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + size.x, low.y + size.y);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (texture != 0) list.AddImage(texture_id(texture), low, high, {0, 0}, share);
    list.AddRect(low, high, ImGui::GetColorU32(to_colour(context.theme.line)));
    ImGui::Dummy(size);
}

void draw_tartan(InspectorContext& context, const std::string& name, const TartanPicture& tartan) {
    const Pattern& pattern = context.pattern();
    const bool is_chosen = (pattern.tartan.empty() ? kDefaultTartan : pattern.tartan) == name;
    const float em = ImGui::GetFontSize(), side = kRowHeight * em, left = ImGui::GetCursorPosX();
    const float room = ImGui::GetContentRegionAvail().x;
    if (ImGui::Selectable(("##" + name).c_str(), is_chosen, 0, {room, side})) {
        context.workspace.run(SetTartan{.tartan = name, .size = pattern.sett_size, .position = pattern.sett_position});
    }
    note_widget(context, "tartan." + name);
    show_tip(tartan.shown_as + "\n" + threadcount_of(tartan.sett));
    back_to(left);
    draw_picture(context, tartan.texture, {side, side}, {1, 1});
    ImGui::SameLine(0, 0.6F * em);
    ImGui::BeginGroup();
    const float words = room - side - 0.6F * em;
    ImGui::TextUnformatted(elided(tartan.shown_as, words).c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, to_colour(context.theme.faint));
    ImGui::TextUnformatted(
        elided("repeat " + quantity_text(repeat_size(tartan.sett), Unit::Centimetres), words).c_str());
    ImGui::PopStyleColor();
    ImGui::EndGroup();
}

// Two pictures, one of repeats and one of threads; made anew when something else is to be seen.
void update_preview(InspectorContext& context, const Sett& sett) {
    MaterialState& state = context.state.material;
    const float em = ImGui::GetFontSize();
    const std::string wanted = threadcount_of(sett) + " " + std::to_string(em);
    if (state.previewed == wanted) return;
    state.previewed = wanted;
    if (state.repeats == 0) state.repeats = take_texture(context);
    if (state.threads == 0) state.threads = take_texture(context);
    const int repeat = static_cast<int>(std::lround(kRepeat * em)),
              woven = static_cast<int>(std::lround(kWovenSide * em));
    hold(context, state.repeats, sett_picture(sett, {.width_px = repeat, .height_px = repeat}));
    // Of a broad first stripe only the end, so that the next are seen, too.
    const int first = std::max(0, sett.stripes.front().threads - kThreadsBefore);
    hold(context, state.threads,
         sett_picture(sett, {.width_px = woven,
                             .height_px = woven,
                             .px_per_thread = std::max(2.0, double(std::round(kThread * em))),
                             .first_thread = first}));
}

void draw_preview(InspectorContext& context, const Sett& sett) {
    update_preview(context, sett);
    const MaterialState& state = context.state.material;
    const float em = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
    const float height = std::floor(std::min(width, 7 * em));
    const float repeat = std::round(kRepeat * em), woven = std::round(kWovenSide * em);
    draw_picture(context, state.repeats, {width, height}, {width / repeat, height / repeat});
    show_tip("The cloth from afar.");
    ImGui::SameLine(0, gap);
    draw_picture(context, state.threads, {width, height}, {width / woven, height / woven});
    show_tip("The cloth from near: single threads, as they are woven.");
}

}  // namespace

void draw_tartan_list(InspectorContext& context) {
    make_pictures(context);
    MaterialState& state = context.state.material;
    const auto searched = text_box(context, {.name = "tartan.search",
                                             .text = state.search,
                                             .hint = "Search tartans",
                                             .tip = "Part of a name. Empty: all of them.",
                                             .width_px = ImGui::GetContentRegionAvail().x});
    const TypedText& typed = context.state.boxes.typed;
    const bool is_typing = typed.box != 0 && typed.box == ImGui::GetID("##tartan.search");
    if (searched) state.search = *searched;
    const std::string words = is_typing ? typed.text : state.search;
    ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 1);  // with it the list has a margin
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.4F * ImGui::GetFontSize(), 0.4F * ImGui::GetFontSize()});
    ImGui::BeginChild("tartans", {0, kListHeight * ImGui::GetFontSize()}, true);
    bool is_empty = true;
    for (const auto& [name, tartan] : state.tartans) {
        if (!has_words(tartan.shown_as + " " + name, words)) continue;
        draw_tartan(context, name, tartan);
        is_empty = false;
    }
    if (is_empty) paragraph(context, "None is called so. A threadcount can be typed below.");
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
}

void draw_threadcount(InspectorContext& context) {
    const Pattern& pattern = context.pattern();
    const std::optional<Sett> worn = sett_of(pattern);
    const bool has_name = pattern.tartan.empty() || wrong_with_tartan(pattern.tartan).empty();
    const auto typed_now = text_box(
        context, {.name = "tartan.threadcount",
                  .text = has_name && worn
                              ? threadcount_of(find_tartan(pattern.tartan.empty() ? kDefaultTartan : pattern.tartan))
                              : pattern.tartan,
                  .hint = "B/24 W4 B24 R/2",
                  .tip = "Letters of a colour and a number of threads. A slash marks the pivots between which it is "
                         "mirrored. S=#A09060; before it gives a colour of one's own, weft: a weft of its own, weave: "
                         "plain, twill or denim.",
                  .width_px = ImGui::GetContentRegionAvail().x,
                  .wrong = wrong_with_tartan});
    const TypedText& typed = context.state.boxes.typed;
    const bool is_typing = typed.box != 0 && typed.box == ImGui::GetID("##tartan.threadcount");
    if (is_typing && !typed.wrong.empty()) complaint(context.theme.error, typed.wrong);
    std::optional<Sett> shown = worn;
    if (is_typing && typed.wrong.empty() && !typed.text.empty()) shown = find_tartan(typed.text);
    if (shown) draw_preview(context, *shown);
    if (typed_now) {
        context.workspace.run(
            SetTartan{.tartan = *typed_now, .size = pattern.sett_size, .position = pattern.sett_position});
    }
}

}  // namespace selvedge
