#include "editor/inspectors/material_inspector.h"

#include <imgui.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>

#include "editor/geometry/outline_edit.h"
#include "editor/inspectors/controls.h"
#include "editor/inspectors/number_box.h"
#include "editor/inspectors/pattern_measures.h"
#include "editor/workspace/sett_picture.h"
#include "sim/core/error.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::editor {
namespace {

constexpr int kListedPx = 96;       // px, side of a tartan's preview in the list; shows one repeat
constexpr float kRowHeight = 2.4F;  // font heights
constexpr float kListHeight = 13.0F;
constexpr float kWovenSide = 14.0F;
constexpr int kThreadsBefore = 8;
constexpr float kThread = 0.27F;  // font heights, width of a thread in the woven preview
constexpr float kRepeat = 5.0F;   // font heights, size of a repeat in the other preview

UiTexture take_texture(const InspectorContext& context) {
    return context.take_texture ? context.take_texture() : 0;
}

void hold(InspectorContext& context, UiTexture texture, render::Image picture) {
    if (texture != 0) context.output.pictures.push_back({.texture = texture, .picture = std::move(picture)});
}

std::string shown_name(const std::string& name, const sim::Sett& sett) {
    return sett.name.empty() ? readable_name(name) : sett.name;
}

void make_pictures(InspectorContext& context) {
    MaterialState& state = context.state.material;
    if (!state.tartans.empty()) return;
    for (const std::string& name : sim::shipped_tartans()) {
        TartanPicture entry{.shown_as = {}, .sett = sim::find_tartan(name), .texture = take_texture(context)};
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
    const sim::Pattern& pattern = context.pattern();
    const bool is_chosen = pattern.tartan == name;
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
    const float text_width = room - side - 0.6F * em;
    ImGui::TextUnformatted(elided(tartan.shown_as, text_width).c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, to_colour(context.theme.faint));
    ImGui::TextUnformatted(
        elided("repeat " + quantity_text(repeat_size(tartan.sett), Unit::Centimetres), text_width).c_str());
    ImGui::PopStyleColor();
    ImGui::EndGroup();
}

// Updates the two preview textures, one of repeats and one of single threads, if the sett or the font size has changed.
void update_preview(InspectorContext& context, const sim::Sett& sett) {
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
    // Skips most of a broad first stripe, so that the next stripes are visible.
    const int first = std::max(0, sett.stripes.front().threads - kThreadsBefore);
    hold(context, state.threads,
         sett_picture(sett, {.width_px = woven,
                             .height_px = woven,
                             .px_per_thread = std::max(2.0, double(std::round(kThread * em))),
                             .first_thread = first}));
}

void draw_preview(InspectorContext& context, const sim::Sett& sett) {
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
    const std::string text = is_typing ? typed.text : state.search;
    ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 1);  // a child window with a border gets padding
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.4F * ImGui::GetFontSize(), 0.4F * ImGui::GetFontSize()});
    ImGui::BeginChild("tartans", {0, kListHeight * ImGui::GetFontSize()}, true);
    bool is_empty = true;
    for (const auto& [name, tartan] : state.tartans) {
        if (!has_all_words(tartan.shown_as + " " + name, text)) continue;
        draw_tartan(context, name, tartan);
        is_empty = false;
    }
    if (is_empty) paragraph(context, "No tartan has this name. A threadcount can be typed below.");
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
}

void draw_threadcount(InspectorContext& context) {
    const sim::Pattern& pattern = context.pattern();
    const std::optional<sim::Sett> own_sett = valid_sett(pattern);
    const auto typed_now = text_box(
        context, {.name = "tartan.threadcount",
                  .text = own_sett ? threadcount_of(sim::find_tartan(pattern.tartan)) : pattern.tartan,
                  .hint = "None: plain cloth. B/24 W4 B24 R/2",
                  .tip = "Letters of a colour and a number of threads. A slash marks the pivots between which it is "
                         "mirrored. S=#A09060; before it gives a colour of one's own, weft: a weft of its own, weave: "
                         "plain, twill or denim.",
                  .width_px = ImGui::GetContentRegionAvail().x,
                  .wrong = tartan_error});
    const TypedText& typed = context.state.boxes.typed;
    const bool is_typing = typed.box != 0 && typed.box == ImGui::GetID("##tartan.threadcount");
    if (is_typing && !typed.wrong.empty()) message_text(context.theme.error, typed.wrong);
    std::optional<sim::Sett> shown = own_sett;
    if (is_typing && typed.wrong.empty() && !typed.text.empty()) shown = sim::find_tartan(typed.text);
    if (shown) draw_preview(context, *shown);
    if (typed_now) {
        context.workspace.run(
            SetTartan{.tartan = *typed_now, .size = pattern.sett_size, .position = pattern.sett_position});
    }
}

namespace {

std::string stripe_text(const sim::SettStripe& stripe, bool is_pivot) {
    return stripe.code + (is_pivot ? "/" : "") + std::to_string(stripe.threads);
}

// Of a mirrored repeat, writes only the stripes from pivot to pivot.
std::string stripes_text(const std::vector<sim::SettStripe>& stripes, bool is_mirrored) {
    const std::size_t count = is_mirrored ? stripes.size() / 2 + 1 : stripes.size();
    std::string text;
    for (std::size_t i = 0; i < count && i < stripes.size(); ++i) {
        const bool is_pivot = is_mirrored && (i == 0 || i + 1 == count);
        text += (i > 0 ? " " : "") + stripe_text(stripes[i], is_pivot);
    }
    return text;
}

std::string own_colours(const sim::Sett& sett) {
    std::map<std::string, sim::Rgb8> own;
    for (const auto* stripes : {&sett.stripes, &sett.weft_stripes}) {
        for (const sim::SettStripe& stripe : *stripes) {
            const auto usual = sim::standard_palette().find(stripe.code);
            if (usual == sim::standard_palette().end() || usual->second != stripe.colour)
                own[stripe.code] = stripe.colour;
        }
    }
    std::string text;
    for (const auto& [code, colour] : own) {
        char buffer[32];
        std::snprintf(buffer, sizeof buffer, "=#%02X%02X%02X; ", colour[0], colour[1], colour[2]);
        text += code + buffer;
    }
    return text;
}

std::string small_letters(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

}  // namespace

std::string threadcount_of(const sim::Sett& sett) {
    std::string text = own_colours(sett) + stripes_text(sett.stripes, sett.is_mirrored);
    if (!sett.weft_stripes.empty()) text += " weft: " + stripes_text(sett.weft_stripes, sett.is_weft_mirrored);
    if (sett.weave == sim::Weave::Plain) text += " weave: plain";
    if (sett.weave == sim::Weave::Twill31) text += " weave: denim";
    return text;
}

std::string tartan_error(const std::string& name_or_threadcount) {
    if (name_or_threadcount.empty()) return "";
    try {
        sim::find_tartan(name_or_threadcount);
        return "";
    } catch (const sim::InputError& error) {
        return error.place().empty() ? error.problem() : error.place() + ": " + error.problem();
    }
}

std::optional<sim::Sett> valid_sett(const sim::Pattern& pattern) {
    try {
        return sett_of(pattern);
    } catch (const sim::InputError&) {
        return std::nullopt;
    }
}

bool has_all_words(const std::string& text, const std::string& words) {
    const std::string small = small_letters(text);
    std::istringstream stream(small_letters(words));
    for (std::string word; stream >> word;) {
        if (small.find(word) == std::string::npos) return false;
    }
    return true;
}

// The material inspector: fabrics with their values, the tartan, and how it matches at seams.

namespace {

void draw_sett_place(InspectorContext& context) {
    const sim::Pattern& pattern = context.pattern();
    SetTartan command{.tartan = pattern.tartan, .size = pattern.sett_size, .position = pattern.sett_position};
    sim::Pattern plain;
    plain.tartan = pattern.tartan;
    const std::optional<sim::Sett> sett = valid_sett(plain);
    const NumberEdit size = number_row(context,
                                       {.name = "tartan.size",
                                        .value = pattern.sett_size,
                                        .tip = "Of one repeat of the warp. Empty: the tartan's own.",
                                        .least = sim::kSmallestSett,
                                        .most = sim::kLargestSett,
                                        .may_be_empty = true,
                                        .standing_for = sett ? std::optional(repeat_size(*sett)) : std::nullopt},
                                       "s: size");
    const VectorEdit moved = vector_row(context,
                                        {.name = "tartan.position",
                                         .label = "p: position",
                                         .tip = "Where the sett begins under all panels: along the weft (X) and along "
                                                "the warp (Y)."},
                                        pattern.sett_position);
    if (size) {
        command.size = size.value;
        apply_edit(context, size, command);
    } else if (moved) {
        command.position = edited(pattern.sett_position, moved);
        apply_edit(context, moved.number, command);
    }
}

// Applies to all selected panels; shows the value of the first.
void draw_grain(InspectorContext& context) {
    const std::set<std::string> selected = context.selection().panels;
    if (selected.empty()) return;
    const std::optional<int> first = panel_index(context.pattern(), *selected.begin());
    if (!first) return;
    const NumberEdit grain =
        number_row(context,
                   {.name = "material.grain",
                    .value = context.pattern().panels[static_cast<std::size_t>(*first)].grain_angle,
                    .unit = Unit::Degrees,
                    .tip = "Of the selected panels, from upward to the warp, counter-clockwise. "
                           "45: cut on the bias."},
                   "Grain");
    if (selected.size() == 1 || grain.phase != EditPhase::Commit) {
        return apply_edit(context, grain, SetGrain{.panel = *selected.begin(), .angle = grain.value.value_or(0)});
    }
    std::vector<Command> commands;
    for (const std::string& name : selected)
        commands.push_back(SetGrain{.panel = name, .angle = grain.value.value_or(0)});
    context.workspace.run_together(commands);
}

void match(InspectorContext& context) {
    MaterialState& state = context.state.material;
    const std::set<int>& seams = context.selection().seams;
    const std::vector<int> first(seams.begin(), seams.end());
    const std::optional<sim::Sett> sett = valid_sett(context.pattern());
    if (!sett) return;
    std::vector<sim::SeamMatch> matched = match_sett(context.pattern(), *sett, {.first_seams = first}).seams;
    if (!context.workspace.run(MatchSetts{.first_seams = first})) return;
    state.matched = std::move(matched);
    state.matched_revision = context.workspace.document->revision();
}

void draw_match_table(const InspectorContext& context, const std::vector<sim::SeamMatch>& seams) {
    const ImGuiTableFlags flags = ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingFixedFit;
    if (!ImGui::BeginTable("matched", 3, flags)) return;
    const float em = ImGui::GetFontSize();
    ImGui::TableSetupColumn("Seam", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("before", ImGuiTableColumnFlags_WidthFixed, 3.6F * em);
    ImGui::TableSetupColumn("after, mm", ImGuiTableColumnFlags_WidthFixed, 4.6F * em);
    ImGui::TableHeadersRow();
    constexpr double kMet = 0.002;  // m, mismatch that counts as matched
    for (const sim::SeamMatch& seam : seams) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(elided(seam.name, ImGui::GetContentRegionAvail().x).c_str());
        show_tip(seam.name + (seam.why.empty() ? "\nIt meets all along." : "\n" + seam.why));
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(quantity_number(seam.before, Unit::Millimetres).c_str());
        ImGui::TableNextColumn();
        message_text(seam.after > kMet ? context.theme.warning : context.theme.ink,
                     quantity_number(seam.after, Unit::Millimetres));
    }
    ImGui::EndTable();
}

void draw_match(InspectorContext& context) {
    const sim::Pattern& pattern = context.pattern();
    const std::optional<sim::Sett> sett = valid_sett(pattern);
    if (pattern.seams.empty() || !sett)
        return paragraph(context, "With a tartan and seams between panels, stripes can be matched.");
    if (!pattern.matched_sett) {
        paragraph(context, "Nobody has matched the stripes at the seams yet.");
    } else if (!is_sett_of(*pattern.matched_sett, *sett)) {
        message_text(context.theme.warning, "The stripes were matched for another tartan or size. Match them again.");
    }
    ButtonRow row(context);
    if (row.button({.name = "material.match",
                    .title = "Match at seams",
                    .tip = with_key(context,
                                    "Moves the tartan under the panels so that its stripes go on across seams. "
                                    "Selected seams come first",
                                    "seam.match")})) {
        match(context);
    }
    const MaterialState& state = context.state.material;
    if (state.matched.empty()) return;
    if (state.matched_revision != context.workspace.document->revision()) {
        paragraph(context, "When it was matched last:");
    }
    draw_match_table(context, state.matched);
}

}  // namespace

void draw_materials(InspectorContext& context) {
    ImGui::PushID("materials");
    if (folding("Fabric", Fold::Open)) draw_fabric(context);
    if (folding("Surface", Fold::Open)) draw_surface(context);
    if (folding("Tartan", Fold::Open)) {
        draw_tartan_list(context);
        draw_threadcount(context);
        draw_sett_place(context);
        draw_grain(context);
    }
    if (folding("Stripes at seams", Fold::Open)) draw_match(context);
    ImGui::PopID();
}

}  // namespace selvedge::editor
