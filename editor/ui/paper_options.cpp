#include "editor/ui/paper_options.h"

#include <imgui.h>
#include <imgui_stdlib.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "editor/frame/item.h"
#include "editor/ui/app_state.h"
#include "editor/ui/widgets.h"
#include "sim/core/error.h"
#include "sim/paper/drawing_unit.h"

namespace selvedge::editor {
namespace {

constexpr std::array kUnits{"Unit: the file's", "mm", "cm", "m", "in", "pt", "px"};
constexpr std::array kPapers{"a4", "a3", "a2", "a1", "a0", "letter", "legal", "tabloid"};
constexpr std::array kLayers{"cut", "sew", "fold", "grain", "notches", "drill", "internal", "labels"};
constexpr double kWidestAllowanceMm = 100, kNarrowestFabricCm = 10, kWidestFabricCm = 1000;

void end_option(AppState& state, const char* name, const char* tip) {
    note_widget(state.widgets, std::string("browser.") + name);
    show_tip(tip, kTipWidth);
}

void show_unit(AppState& state) {
    sim::MakePanelsOptions& panels = state.import_options.panels;
    int chosen = 0;
    for (std::size_t i = 1; i < kUnits.size(); ++i) {
        if (panels.metres_per_unit == sim::metres_of_unit(kUnits[i])) chosen = static_cast<int>(i);
    }
    ImGui::SetNextItemWidth(9 * ImGui::GetFontSize());
    if (ImGui::Combo("##unit", &chosen, kUnits.data(), static_cast<int>(kUnits.size()))) {
        panels.metres_per_unit.reset();
        if (chosen > 0) panels.metres_per_unit = sim::metres_of_unit(kUnits[static_cast<std::size_t>(chosen)]);
    }
    end_option(state, "unit", "Of the numbers in the drawing, where its pieces come too large or too small");
}

void show_allowance(AppState& state) {
    std::optional<double>& allowance = state.import_options.panels.allowance;
    std::string text;
    if (allowance) {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), 1000 * *allowance,
                                       std::chars_format::general, 4);
        text.assign(digits.data(), end.ptr);
    }
    ImGui::SetNextItemWidth(9 * ImGui::GetFontSize());
    if (ImGui::InputTextWithHint("##allowance", "Allowance in mm", &text, ImGuiInputTextFlags_CharsDecimal)) {
        double mm = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), mm);
        allowance.reset();
        if (error == std::errc() && mm >= 0 && mm <= kWidestAllowanceMm) allowance = mm / 1000;
    }
    end_option(state, "allowance",
               "The seam allowance that outlines include where only the cut line is drawn. Empty: the file's, or none");
}

void browse_for_measurements(AppState& state) {
    const auto choose = [](AppState& current, const std::string& file) {
        current.import_options.measurements = file;
        browse_to_import(current);
    };
    state.browser.open({.title = "Body measurements for the import",
                        .verb = "Choose",
                        .endings = {".json", ".yaml", ".yml", ".smis", ".vit", ".smml"},
                        .choose = choose},
                       state.services);
}

void check(AppState& state, const char* name, const char* title, bool& value, const char* tip) {
    ImGui::Checkbox(title, &value);
    end_option(state, name, tip);
}

void show_paper(AppState& state) {
    std::string& paper = state.print_settings.paper;
    ImGui::SetNextItemWidth(7 * ImGui::GetFontSize());
    if (ImGui::BeginCombo("##paper", paper.c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const char* known : kPapers) {
            if (ImGui::Selectable(known, paper == known)) paper = known;
            note_widget(state.widgets, std::string("browser.paper.") + known);
        }
        ImGui::SetNextItemWidth(-1);
        ImGui::InputTextWithHint("##size", "WIDTHxHEIGHT mm", &paper);
        ImGui::EndCombo();
    }
    end_option(state, "paper", "The paper of a PDF. At the end of the list, another size in mm: 914x1200");
}

// All are drawn while none is named.
void show_layers(AppState& state) {
    std::vector<std::string>& layers = state.print_settings.layers;
    const std::string shown = layers.empty() ? "All lines" : std::to_string(layers.size()) + " kinds of line";
    ImGui::SetNextItemWidth(9 * ImGui::GetFontSize());
    if (ImGui::BeginCombo("##layers", shown.c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const char* layer : kLayers) {
            const auto found = std::ranges::find(layers, layer);
            bool is_drawn = layers.empty() || found != layers.end();
            const bool is_changed = ImGui::Checkbox(layer, &is_drawn);
            note_widget(state.widgets, std::string("browser.layers.") + layer);
            if (!is_changed) continue;
            if (layers.empty()) layers.assign(kLayers.begin(), kLayers.end());
            std::erase(layers, layer);
            if (is_drawn) layers.emplace_back(layer);
            if (layers.size() == kLayers.size()) layers.clear();
        }
        ImGui::EndCombo();
    }
    end_option(state, "layers", "What is drawn of the panels");
}

void show_layout(AppState& state) {
    sim::PrintSettings& settings = state.print_settings;
    check(state, "layout", "Cutting layout", settings.is_layout, "All pieces on the fabric, and how much it takes");
    if (!settings.is_layout) return;
    ImGui::SameLine();
    ImGui::SetNextItemWidth(6 * ImGui::GetFontSize());
    double cm = 100 * settings.fabric_width;
    if (ImGui::InputDouble("##fabric_width", &cm, 0, 0, "%.0f cm"))
        settings.fabric_width = std::clamp(cm, kNarrowestFabricCm, kWidestFabricCm) / 100;
    end_option(state, "fabric_width", "Width of the fabric without its selvedges");
    ImGui::SameLine();
    check(state, "folded", "Folded", settings.is_folded, "Along its length: pairs are cut at once");
    ImGui::SameLine();
    check(state, "one_way", "One way", settings.is_one_way, "All pieces point one way, as on velvet");
}

}  // namespace

void show_import_options(AppState& state) {
    sim::ImportOptions& options = state.import_options;
    show_unit(state);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(7 * ImGui::GetFontSize());
    ImGui::InputTextWithHint("##size", "Size", &options.panels.size);
    end_option(state, "size", "Of a file with several sizes. Empty: its own choice, and the editor asks");
    ImGui::SameLine();
    show_allowance(state);
    if (button(state, "browser.measurements", "Measurements...")) browse_for_measurements(state);
    show_tip("A file of FreeSewing, Valentina, Seamly2D or GarmentCode: the panels are placed round that body",
             kTipWidth);
    ImGui::SameLine();
    const std::string file = options.measurements.filename().string();
    if (file.empty()) return ImGui::TextDisabled("the drawing's, else the female mannequin");
    ImGui::TextUnformatted(file.c_str());
    ImGui::SameLine();
    if (button(state, "browser.no_measurements", "Remove")) options.measurements.clear();
}

int print_option_rows(const std::string& ending) {
    return ending == ".pdf" ? 3 : ending == ".svg" ? 2 : 1;
}

void show_print_options(AppState& state, const std::string& ending) {
    sim::PrintSettings& settings = state.print_settings;
    if (ending == ".dxf") {
        check(state, "astm", "By ASTM D6673", settings.is_astm, "Instead of AAMA: notches tell their kind");
        return;
    }
    if (ending == ".pdf") {
        show_paper(state);
        ImGui::SameLine();
    }
    show_layers(state);
    if (ending == ".pdf") {
        ImGui::SameLine();
        check(state, "one_page", "One page for a plotter", settings.is_one_page,
              "At true size, as wide as the paper, or as the fabric of a layout");
        check(state, "on_fold", "Halves on the fold", settings.is_on_fold,
              "Symmetric panels as halves to cut on a fold");
        ImGui::SameLine();
        check(state, "all_pieces", "Mirror images too", settings.prints_all, "Instead of \"cut 1 pair\"");
    }
    show_layout(state);
}

namespace {

// The words of a script, one after the other.
class Words {
 public:
    explicit Words(std::span<const std::string> words) : words_(words) {}

    bool has_more() const { return at_ < words_.size(); }
    const std::string& next() { return words_[at_++]; }
    const std::string& value_of(const std::string& option) {
        if (!has_more()) throw sim::InputError("", option, "a value is missing");
        return next();
    }
    double number_of(const std::string& option, double least, double most) {
        const std::string& text = value_of(option);
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || !(value >= least && value <= most))
            throw sim::InputError("", option,
                                  "'" + text + "' is no number from " + std::to_string(std::lround(least)) + " to " +
                                      std::to_string(std::lround(most)));
        return value;
    }

 private:
    std::span<const std::string> words_;
    std::size_t at_ = 0;
};

std::vector<std::string> split_at_commas(const std::string& text) {
    std::vector<std::string> parts{""};
    for (const char c : text) {
        if (c == ',') {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

}  // namespace

sim::ImportOptions parse_import_options(std::span<const std::string> given) {
    sim::ImportOptions options;
    Words words(given);
    while (words.has_more()) {
        const std::string& option = words.next();
        if (option == "unit") {
            options.panels.metres_per_unit = sim::metres_of_unit(words.value_of(option));
        } else if (option == "size") {
            options.panels.size = words.value_of(option);
        } else if (option == "allowance") {
            options.panels.allowance = words.number_of(option, 0, kWidestAllowanceMm) / 1000;
        } else if (option == "measurements") {
            options.measurements = words.value_of(option);
        } else {
            throw sim::InputError("", option, "none of unit, size, allowance, measurements");
        }
    }
    return options;
}

sim::PrintSettings parse_print_options(std::span<const std::string> given) {
    sim::PrintSettings settings;
    const std::array<std::pair<std::string_view, bool*>, 7> switches{{{"one-page", &settings.is_one_page},
                                                                      {"all", &settings.prints_all},
                                                                      {"on-fold", &settings.is_on_fold},
                                                                      {"layout", &settings.is_layout},
                                                                      {"folded", &settings.is_folded},
                                                                      {"one-way", &settings.is_one_way},
                                                                      {"astm", &settings.is_astm}}};
    Words words(given);
    while (words.has_more()) {
        const std::string& option = words.next();
        const auto found = std::ranges::find(switches, option, &std::pair<std::string_view, bool*>::first);
        if (found != switches.end()) {
            *found->second = true;
        } else if (option == "paper") {
            settings.paper = words.value_of(option);
        } else if (option == "layers") {
            settings.layers = split_at_commas(words.value_of(option));
        } else if (option == "width") {
            settings.fabric_width = words.number_of(option, kNarrowestFabricCm, kWidestFabricCm) / 100;
        } else {
            throw sim::InputError(
                "", option, "none of paper, layers, width, one-page, all, on-fold, layout, folded, one-way, astm");
        }
    }
    return settings;
}

}  // namespace selvedge::editor
