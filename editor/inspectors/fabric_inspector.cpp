// The section of the fabric: its values as text, or rows to edit them as a draft, and what is made of it.
#include <imgui.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/inspectors/controls.h"
#include "editor/inspectors/material_inspector.h"
#include "editor/inspectors/number_box.h"
#include "editor/workspace/fabric_library.h"
#include "sim/pattern/fabric_file.h"

namespace selvedge::editor {
namespace {

// Three significant digits without an exponent: 8000, 56, 0.35.
std::string number_text(double value) {
    char buffer[64];
    const double size = value < 0 ? -value : value;
    const int decimals = size >= 100 || size == 0 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
    std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
    std::string text = buffer;
    if (text.find('.') == std::string::npos) return text;
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string both(double warp, double weft, const char* unit) {
    const std::string a = number_text(warp), b = number_text(weft);
    return (a == b ? a : a + " \u00D7 " + b) + unit;
}

}  // namespace

std::vector<FabricRow> fabric_rows(const sim::Fabric& fabric) {
    return {
        {"Weight", number_text(fabric.area_density * 1e3) + " g/m\u00B2", "What a square metre weighs."},
        {"Stretch", both(fabric.stretch_warp, fabric.stretch_weft, " N/m"),
         "Force per width that would double its length: along the warp \u00D7 along the weft."},
        {"Shear", number_text(fabric.shear) + " N/m", "Force per width and radian that makes squares of it oblique."},
        {"Bending", both(fabric.bending_warp * 1e6, fabric.bending_weft * 1e6, " \u00B5N\u00B7m"),
         "How stiffly it bends: along the warp \u00D7 along the weft. Silk about 5, denim about 40."},
        {"Thickness", number_text(fabric.thickness * 1e3) + " mm", "Of one layer."},
        {"Friction", number_text(fabric.friction), "Against the body: 0 slides like oil, 1 hardly slides."},
        {"Damping", number_text(fabric.damping) + " /s", "How fast its motion dies away by itself."},
        {"Strain limit", number_text(fabric.strain_limit * 100) + " %", "Beyond this strain it no longer gives."},
    };
}

std::string readable_name(const std::string& name) {
    const std::size_t slash = name.find_last_of('/');
    if (name.ends_with(".json")) return slash == std::string::npos ? name : name.substr(slash + 1);
    std::string text = name;
    for (char& c : text) c = c == '_' ? ' ' : c;
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

namespace {

// A value that can be edited.
struct EditedValue {
    const char* label;
    double sim::Fabric::*value;
    Unit unit;
    std::optional<double> step;
    const char* tip;
};

constexpr std::array kEditedValues{
    EditedValue{"Weight",
                &sim::Fabric::area_density,
                Unit::GramsPerArea,
                {},
                "What a square metre weighs. Heavier cloth hangs straighter and pulls its folds down."},
    EditedValue{"Stretch, warp", &sim::Fabric::stretch_warp, Unit::NewtonsPerMetre, 100,
                "Force per width that would double its length along the grain. Less: it gives under its own weight."},
    EditedValue{"Stretch, weft", &sim::Fabric::stretch_weft, Unit::NewtonsPerMetre, 100,
                "Force per width that would double its width across the grain. Less: it gives around the body."},
    EditedValue{
        "Shear",
        &sim::Fabric::shear,
        Unit::NewtonsPerMetre,
        {},
        "Force per width and radian that makes squares of it oblique. Less: it drapes in two directions at once "
        "and hangs soft on the bias."},
    EditedValue{"Bending, warp",
                &sim::Fabric::bending_warp,
                Unit::MicronewtonMetres,
                {},
                "How stiffly it bends along the grain. More: fewer and wider folds. Silk about 3, denim about 45."},
    EditedValue{"Bending, weft",
                &sim::Fabric::bending_weft,
                Unit::MicronewtonMetres,
                {},
                "How stiffly it bends across the grain. More: fewer and wider folds. Silk about 2, denim about 25."},
    EditedValue{"Hysteresis, bending",
                &sim::Fabric::bending_hysteresis,
                Unit::Millinewtons,
                {},
                "Friction inside the fabric when it bends (KES 2HB). More: wrinkles stay."},
    EditedValue{"Hysteresis, shear", &sim::Fabric::shear_hysteresis, Unit::NewtonsPerMetre, 0.1,
                "Friction between its yarns when it shears (KES 2HG). More: it stays as it was pulled."},
    EditedValue{
        "Thickness", &sim::Fabric::thickness, Unit::Thickness, {}, "Of one layer: how far apart layers of cloth stay."},
    EditedValue{"Friction", &sim::Fabric::friction, Unit::Plain, 0.05,
                "Against the body: 0 slides like oil, 1 hardly slides."},
    EditedValue{"Damping",
                &sim::Fabric::damping,
                Unit::PerSecond,
                {},
                "How fast its motion dies away by itself. It does not change how the cloth hangs at rest."},
    EditedValue{"Strain limit",
                &sim::Fabric::strain_limit,
                Unit::Percent,
                {},
                "Beyond this strain along warp or weft it no longer gives."},
    EditedValue{"Gloss", &sim::Fabric::gloss, Unit::Plain, 0.005,
                "Share of light that it reflects as a mirror does. Only its look: silk 0.05, cotton 0.008."},
    EditedValue{"Roughness", &sim::Fabric::roughness, Unit::Plain, 0.05,
                "Width of the highlight. Only its look: less is glossier."},
    EditedValue{"Sheen", &sim::Fabric::sheen, Unit::Plain, 0.005,
                "Light that its fibres reflect at grazing angles. Only its look."},
};

std::string garment_fabric(const sim::Pattern& pattern) {
    return pattern.fabric.empty() ? sim::Fabric{}.name : pattern.fabric;
}

}  // namespace

std::string fabric_of(const sim::Pattern& pattern, const sim::Panel& panel) {
    return panel.fabric.empty() ? garment_fabric(pattern) : panel.fabric;
}

namespace {

std::string users_of(const sim::Pattern& pattern, const std::string& fabric) {
    std::string names;
    std::size_t count = 0;
    for (const sim::Panel& panel : pattern.panels) {
        const bool is_made_of = fabric_of(pattern, panel) == fabric;
        const bool is_interlined = std::ranges::find(panel.interlinings, fabric) != panel.interlinings.end();
        if (!is_made_of && !is_interlined) continue;
        names += (names.empty() ? "" : ", ") + panel.name + (is_made_of ? "" : " (interlining)");
        if (is_made_of) ++count;
    }
    if (names.empty()) return "no panel";
    return count == pattern.panels.size() ? "all panels" : names;
}

// The shipped fabrics, those of files that were read, and the one that is shown.
std::vector<std::string> listed_fabrics(const FabricLibrary& fabrics, const std::string& shown) {
    std::vector<std::string> names = sim::fabric_names();
    for (const std::string& file : fabrics.files()) names.push_back(file);
    if (std::ranges::find(names, shown) == names.end()) names.push_back(shown);
    return names;
}

// Names of files are short unless two are alike.
std::string list_label(const std::vector<std::string>& names, const std::string& name) {
    const std::string readable = readable_name(name);
    const auto is_alike = [&](const std::string& other) { return readable_name(other) == readable; };
    return std::ranges::count_if(names, is_alike) > 1 ? name : readable;
}

void draw_fabric_choice(InspectorContext& context, const std::string& shown) {
    FabricLibrary& fabrics = context.workspace.fabrics;
    const std::vector<std::string> names = listed_fabrics(fabrics, shown), changed = fabrics.changed();
    std::vector<std::string> labels;
    for (const std::string& name : names) {
        const bool has_changes = std::ranges::find(changed, name) != changed.end();
        labels.push_back(list_label(names, name) + (has_changes ? " *" : ""));
    }
    const auto chosen = static_cast<std::size_t>(std::ranges::find(names, shown) - names.begin());
    const int now = choice_box(context, {.name = "material.fabric",
                                         .shown = labels[chosen],
                                         .items = labels,
                                         .chosen = static_cast<int>(chosen),
                                         .tip = "The fabric whose values are shown. The buttons below put it to use.",
                                         .width_px = ImGui::GetContentRegionAvail().x});
    if (now >= 0) fabrics.show(names[static_cast<std::size_t>(now)]);
}

// Without the rounding of its conversion from another unit: 12 digits.
double rounded(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.12g", value);
    return std::strtod(text.data(), nullptr);
}

void edit_value(InspectorContext& context, const EditedValue& row, const sim::Fabric& saved, sim::Fabric& draft) {
    const sim::FabricKey& key = sim::fabric_key(row.value);
    const std::string name = std::string("fabric.") + key.key;
    const std::string tip = std::string(row.tip) + "\nFrom " + quantity_text(key.least, row.unit) + " to " +
                            quantity_text(key.most, row.unit) +
                            "; saved: " + quantity_text(saved.*row.value, row.unit) + ".";
    const NumberEdit edit = number_row(context,
                                       {.name = name.c_str(),
                                        .value = draft.*row.value,
                                        .unit = row.unit,
                                        .tip = tip,
                                        .least = key.least,
                                        .most = key.most,
                                        .step = row.step},
                                       row.label);
    if (!edit || !edit.value) return;
    const bool is_back = edit.phase == EditPhase::Rollback;
    draft.*row.value = is_back ? *edit.value : std::clamp(rounded(*edit.value), key.least, key.most);
}

void draw_draft(InspectorContext& context, const std::string& name, const FabricLibrary::Entry& entry) {
    sim::Fabric draft = *entry.draft;
    ImGui::PushID(name.c_str());
    for (const EditedValue& row : kEditedValues) edit_value(context, row, entry.file.fabric, draft);
    const DesignEdit edit = design_rows(
        context, {.now = draft.surface,
                  .names = "fabric.surface.",
                  .none = "What the garment says",
                  .tip = "What the fabric shows where neither the panel nor the garment says something else.",
                  .open_picture = [&] {
                      if (context.open_fabric_picture) context.open_fabric_picture(name);
                  }});
    if (edit) draft.surface = edit.surface;
    ImGui::PopID();
    if (draft != *entry.draft) context.workspace.fabrics.set_draft(name, draft);
    if (entry.has_changes()) {
        message_text(context.theme.warning, "Not saved yet: the garment hangs as " + readable_name(name) + " was.");
    } else if (sim::is_shipped_fabric(name)) {
        paragraph(context, "A fabric that ships: what you change is saved as a file of your own.");
    }
}

void draw_draft_buttons(InspectorContext& context, const std::string& name, const FabricLibrary::Entry& entry) {
    const bool is_shipped = sim::is_shipped_fabric(name), has_changes = entry.has_changes();
    ButtonRow row(context);
    const bool saves = !is_shipped && row.button({.name = "material.fabric.save",
                                                  .title = "Save",
                                                  .tip = "Writes " + name + ". The garment takes the values at once.",
                                                  .is_enabled = has_changes && bool(context.save_fabric)});
    const bool saves_as = row.button(
        {.name = "material.fabric.save_as",
         .title = "Save as...",
         .tip = "Writes another file. What is made of this fabric, or interlined with it, is then made of that.",
         .is_enabled = bool(context.save_fabric_as)});
    const bool cancels = row.button({.name = "material.fabric.cancel",
                                     .title = "Cancel",
                                     .tip = has_changes ? "Drops the changes." : "Ends the editing."});
    if (saves) context.save_fabric(name);
    if (saves_as) context.save_fabric_as(name);
    if (cancels) context.workspace.fabrics.drop_draft(name);
}

void draw_file_buttons(InspectorContext& context, const std::string& name, const FabricLibrary::Entry& entry) {
    ButtonRow row(context);
    if (!entry.problem.empty() && row.button({.name = "material.fabric.again",
                                              .title = "Read again",
                                              .tip = "After the file was repaired by another program."})) {
        context.workspace.fabrics.read_again(name);
        return context.workspace.drape.reread_fabrics();
    }
    const bool edits = row.button({.name = "material.fabric.edit",
                                   .title = "Edit",
                                   .tip = "Changes the values. The garment takes them when they are saved as a file.",
                                   .is_enabled = entry.problem.empty()});
    const bool opens = row.button({.name = "material.fabric.open",
                                   .title = "Open...",
                                   .tip = "Shows the values of a fabric file.",
                                   .is_enabled = bool(context.open_fabric)});
    if (opens) context.open_fabric();
    if (edits) context.workspace.fabrics.begin_draft(name);
}

void draw_use_buttons(InspectorContext& context, const std::string& shown) {
    const std::set<std::string>& selected = context.selection().panels;
    ButtonRow row(context);
    if (row.button({.name = "material.fabric.garment",
                    .title = "Use for the garment",
                    .tip = "All panels that have no fabric of their own are made of it.",
                    .is_enabled = shown != garment_fabric(context.pattern())})) {
        context.workspace.run(SetFabric{.fabric = shown});
    }
    const std::string title = selected.size() == 1 ? "Use for " + *selected.begin() : "Use for selected panels";
    if (row.button({.name = "material.fabric.panels",
                    .title = title.c_str(),
                    .tip = selected.empty() ? "Select panels first." : "The selected panels are made of it.",
                    .is_enabled = !selected.empty()})) {
        std::vector<Command> commands;
        for (const std::string& name : selected) commands.push_back(SetFabric{.panel = name, .fabric = shown});
        context.workspace.run_together(commands);
    }
}

}  // namespace

void draw_fabric(InspectorContext& context) {
    FabricLibrary& fabrics = context.workspace.fabrics;
    const std::string shown = fabrics.shown().empty() ? garment_fabric(context.pattern()) : fabrics.shown();
    draw_fabric_choice(context, shown);
    const FabricLibrary::Entry entry = fabrics.find(shown);  // a copy: the buttons change it
    if (!entry.problem.empty()) message_text(context.theme.error, entry.problem);
    if (entry.draft) {
        draw_draft(context, shown, entry);
        draw_draft_buttons(context, shown, entry);
    } else {
        if (entry.problem.empty()) {
            for (const FabricRow& row : fabric_rows(entry.file.fabric)) fact(context, row.label, row.value, row.tip);
        }
        draw_file_buttons(context, shown, entry);
    }
    const std::string users = users_of(context.pattern(), shown);
    fact(context, "Used by", users, "The panels that are made of it, or interlined with it: " + users + ".");
    draw_use_buttons(context, shown);
}

}  // namespace selvedge::editor
