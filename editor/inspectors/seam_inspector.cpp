// The seam inspector: the list of seams, and the actions on one seam.
#include <imgui.h>

#include <cmath>

#include "editor/geometry/seam_edit.h"
#include "editor/geometry/sewing.h"
#include "editor/inspectors/controls.h"
#include "editor/inspectors/field_rows.h"
#include "editor/inspectors/number_box.h"
#include "editor/inspectors/pattern_measures.h"
#include "editor/inspectors/property_inspector.h"
#include "render/scene/colour.h"

namespace selvedge::editor {
namespace {

bool has_seam(const sim::Pattern& pattern, int seam) {
    return seam >= 0 && static_cast<std::size_t>(seam) < pattern.seams.size();
}

std::string lengths_text(const SeamMeasures& measures) {
    const std::string first = quantity_number(measures.first, Unit::Centimetres);
    const std::string second = quantity_text(measures.second, Unit::Centimetres);
    return measures.is_uneven ? first + " : " + second : second;
}

void draw_chip(const InspectorContext& context, int seam, float side_px) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float top = low.y + (ImGui::GetTextLineHeight() - side_px) / 2;
    const auto first = static_cast<std::size_t>(first_of_sewing(context.pattern(), seam));
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, top}, {low.x + side_px, top + side_px},
                                              ImGui::GetColorU32(to_colour(render::line_colour(first))), side_px / 4);
    ImGui::Dummy({side_px, ImGui::GetTextLineHeight()});
}

void choose(InspectorContext& context, int seam) {
    Selection selected;
    if (ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl) selected = context.selection();
    toggle_sewing(context.pattern(), seam, selected.seams);
    context.workspace.document->select(std::move(selected));
}

// Highlights the seam in all views while the cursor is over its row.
void light_up_seam(InspectorContext& context, int seam, bool is_hovered) {
    std::optional<int>& lit = context.state.hovered_seam;
    if (is_hovered) {
        context.workspace.hover = {.seam = seam};
        lit = seam;
    } else if (lit == seam) {
        if (context.workspace.hover == Hover{.seam = seam}) context.workspace.hover = {};
        lit.reset();
    }
}

// Draws text that ends at `right`; returns its left end.
float right_aligned(const std::string& text, float right, const sim::Rgb8& colour) {
    const float left = right - ImGui::CalcTextSize(text.c_str()).x;
    back_to(left);
    ImGui::PushStyleColor(ImGuiCol_Text, to_colour(colour));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    return left;
}

void draw_seam_row(InspectorContext& context, int seam, const SeamMeasures& measures) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, left = ImGui::GetCursorPosX();
    const std::string name = "seams." + std::to_string(seam);
    const ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight());
    if (ImGui::Selectable(("##" + name).c_str(), context.selection().seams.contains(seam), 0, size))
        choose(context, seam);
    note_widget(context, name);
    light_up_seam(context, seam, ImGui::IsItemHovered());
    const std::string state = measures.is_wrong()
                                  ? "\nIts sides differ by more than 1 mm: even it, or accept it as ease."
                              : measures.is_uneven ? "\nEased: its sides are meant to differ."
                                                   : "";
    std::string title = measures.name;
    for (const std::string& part : measures.parts) title += "\n    " + part;
    show_tip(title + "\n" + lengths_text(measures) + ", difference " + difference_text(measures) + state);
    const float chip = 0.7F * ImGui::GetFontSize();
    float right = left + size.x;
    if (measures.is_uneven) {
        right = right_aligned(difference_text(measures), right,
                              measures.is_wrong() ? context.theme.error : context.theme.faint) -
                2 * gap;
    }
    right = right_aligned(lengths_text(measures), right, context.theme.faint) - gap;
    back_to(left);
    draw_chip(context, seam, chip);
    ImGui::SameLine(0, gap);
    ImGui::TextUnformatted(elided(measures.name, right - left - chip - gap).c_str());
}

void draw_name_row(InspectorContext& context, int seam, const SeamMeasures& measures) {
    const sim::Seam& held = context.pattern().seams[static_cast<std::size_t>(seam)];
    row_label(context, "Name", "What the seam is called.");
    const auto name = text_box(context, {.name = "seam.name",
                                         .text = measures.parts.empty() ? held.name : held.sewing,
                                         .hint = measures.name,
                                         .tip = "What the seam is called. Without a name it goes by its edges.",
                                         .width_px = field_width(),
                                         .wrong = [](const std::string& text) -> std::string {
                                             return text.find_first_of(",+") == std::string::npos
                                                        ? ""
                                                        : "A seam's name has no comma and no plus sign";
                                         }});
    if (name) context.workspace.run(NameSeam{.seam = seam, .to = *name});
}

// A row for each run that can be slid.
void draw_slide_rows(InspectorContext& context, int seam) {
    for (const SewingRun run : {SewingRun::First, SewingRun::Second}) {
        const bool is_second = run == SewingRun::Second;
        if (!can_slide(context.pattern(), seam, run)) continue;
        const NumberEdit slid = number_row(
            context,
            {.name = is_second ? "seam.slide.second" : "seam.slide.first",
             .value = 0,
             .tip = "Moves the points where it begins, ends and changes from part to part along the outline."},
            is_second ? "Slide second" : "Slide first");
        if (slid) apply_edit(context, slid, SlideSewing{.seam = seam, .is_second = is_second, .by = slid.by()});
    }
}

}  // namespace

void seam_buttons(InspectorContext& context, int seam) {
    if (!has_seam(context.pattern(), seam)) return;
    const SeamMeasures measures = seam_measures(context.pattern(), seam);
    ButtonRow row(context);
    if (row.button({.name = "seam.even",
                    .title = "Even",
                    .tip = with_key(context, "Makes the second side as long as the first", "seam.even"),
                    .is_enabled = measures.is_uneven})) {
        context.workspace.run(EvenSeam{seam});
    } else if (row.button(
                   {.name = "seam.ease",
                    .title = measures.is_eased ? "Not eased" : "Accept ease",
                    .tip = measures.is_eased
                               ? std::string("Its sides are to be of one length again")
                               : with_key(context, "The longer side is gathered: it is meant to be so", "seam.accept"),
                    .is_enabled = measures.is_eased || measures.is_uneven})) {
        context.workspace.run(AcceptEase{.seam = seam, .is_eased = !measures.is_eased});
    } else if (row.button({.name = "seam.reverse",
                           .title = "Reverse",
                           .tip = with_key(context,
                                           "Sews it the other way round: right side to wrong side, or back to right "
                                           "side to right side",
                                           "seam.reverse")})) {
        context.workspace.run(ReverseSeam{seam});
    } else if (row.button({.name = "seam.delete",
                           .title = "Delete",
                           .tip = with_key(context, "Takes the seam out; the panels stay", "seam.delete")})) {
        context.workspace.run(RemoveParts{.seams = sewing_of(context.pattern(), seam)});
    }
}

void draw_seam_section(InspectorContext& context, int seam) {
    if (!has_seam(context.pattern(), seam)) return;
    const SeamMeasures measures = seam_measures(context.pattern(), seam);
    heading(context, ("Seam " + measures.name).c_str());
    ImGui::PushID(("seam " + std::to_string(seam)).c_str());
    draw_name_row(context, seam, measures);
    fact(context, "First side", quantity_text(measures.first, Unit::Centimetres), "The length of its first side.");
    fact(context, "Second side", quantity_text(measures.second, Unit::Centimetres), "The length of its second side.");
    fact(context, "Difference", difference_text(measures) + (measures.is_eased ? ", eased" : ""),
         "What the second side has more than the first.");
    if (!measures.parts.empty()) {
        fact(context, "Parts", std::to_string(measures.parts.size()),
             "The seams that are sewn as one: they are selected, turned, slid and deleted together.");
    }
    draw_slide_rows(context, seam);
    field_rows(context, {.part = FieldOwner::Seam, .index = seam},
               sim::Seam(context.pattern().seams[static_cast<std::size_t>(seam)]));
    if (joins_right_to_wrong(context.pattern().seams[static_cast<std::size_t>(seam)])) {
        message_text(context.theme.faint, "Right side to wrong side: Reverse joins it right side to right side.");
        note_widget(context, "seam.right_wrong");
    }
    if (measures.is_wrong()) {
        message_text(context.theme.error, "The sides differ by more than 1 mm: even them, or accept it as ease.");
    }
    if (is_crossed(context.pattern(), context.pattern().seams[static_cast<std::size_t>(seam)])) {
        message_text(context.theme.warning, "The seam looks twisted. Reverse sews it the other way round.");
    }
    seam_buttons(context, seam);
    ImGui::PopID();
}

void draw_seams(InspectorContext& context) {
    if (context.pattern().seams.empty())
        return paragraph(context, "No seams yet. Choose Sew edges (N) and click two edges.");
    std::size_t wrong = 0;
    for (const int seam : one_of_each_sewing(context.pattern())) {
        const SeamMeasures measures = seam_measures(context.pattern(), seam);
        wrong += measures.is_wrong() ? 1 : 0;
        draw_seam_row(context, seam, measures);
    }
    ImGui::Spacing();
    if (wrong > 0) {
        message_text(context.theme.error, wrong == 1
                                              ? std::string("One seam has sides of different lengths.")
                                              : std::to_string(wrong) + " seams have sides of different lengths.");
    }
    const std::set<int>& selected = context.selection().seams;
    if (one_of_each_sewing(context.pattern(), selected).size() == 1)
        return draw_seam_section(context, *selected.begin());
    paragraph(context, selected.empty() ? "Click a seam to change it." : "Several seams are selected.");
    ButtonRow row(context);
    if (selected.size() > 1 &&
        row.button({.name = "seams.delete", .title = "Delete all selected", .tip = "The panels stay."})) {
        context.workspace.run(RemoveParts{.seams = {selected.begin(), selected.end()}});
    }
}

}  // namespace selvedge::editor
