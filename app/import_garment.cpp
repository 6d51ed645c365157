#include "app/import_garment.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <span>

#include "app/fitted_mannequin.h"
#include "app/options.h"
#include "render/image/photo.h"
#include "sim/core/disjoint_sets.h"
#include "sim/core/error.h"
#include "sim/core/printable.h"
#include "sim/paper/drawing_file.h"
#include "sim/paper/folded_ribbing.h"
#include "sim/paper/pdf_pictures.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/outline.h"
#include "sim/place/arrange_pattern.h"
#include "sim/proposals/panel_role.h"

namespace selvedge::app {
namespace {

bool is_photo_file(const std::filesystem::path& file) {
    std::array<char, 8> head{};
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), head.size());
    return render::is_photo({head.data(), static_cast<std::size_t>(stream.gcount())});
}

// Moves the pictures of one drawing to those of all, as many as can lie under a sheet. They have the unit that the user
// states for its parts.
void take_pictures(sim::Drawing& one, const std::string& file, const std::optional<double>& metres_per_unit,
                   std::vector<sim::DrawnPicture>& pictures) {
    if (metres_per_unit && one.metres_per_unit && !one.parts.empty())
        scale_pictures(one.pictures, *metres_per_unit / *one.metres_per_unit);
    const std::size_t room = sim::kMostUnderlays - pictures.size();
    if (one.pictures.size() > room) {
        one.notes.push_back(file + ": " + sim::count_text(one.pictures.size() - room, "scan") + ", from page " +
                            std::to_string(one.pictures[room].number) + " on, left out: at most " +
                            std::to_string(sim::kMostUnderlays) + " are laid under the sheet");
        one.pictures.resize(room);
    }
    std::ranges::move(one.pictures, std::back_inserter(pictures));
    one.pictures.clear();
}

// The drawings of several files as one: parts whose names are taken get a number when they become panels.
sim::Drawing read_drawings(const std::vector<std::filesystem::path>& files, const ImportOptions& options,
                           std::vector<std::string>& notes) {
    sim::Drawing all;
    std::vector<sim::DrawnPicture> pictures;
    for (const std::filesystem::path& file : files) {
        if (is_photo_file(file)) {
            const std::string ending = file.extension().string();
            const bool is_named_so = ending == ".png" || ending == ".jpg" || ending == ".jpeg";
            throw sim::InputError(file.string(), "",
                                  is_named_so ? "a photo: trace it in the editor, selvedge edit '" + file.string() + "'"
                                              : "a photo: name it .png or .jpg, and trace it in the editor");
        }
        sim::Drawing one = sim::read_drawing(file);
        notes.push_back(file.string() + ": " + one.format + ", " + sim::count_text(one.parts.size(), "part"));
        take_pictures(one, file.string(), options.panels.metres_per_unit, pictures);
        if (all.parts.empty() || one.parts.empty()) {  // the first, or only scans
            std::vector<std::string> told = std::move(all.notes);
            std::ranges::move(one.notes, std::back_inserter(told));
            if (all.parts.empty()) all = std::move(one);
            all.notes = std::move(told);
            continue;
        }
        if (one.metres_per_unit != all.metres_per_unit)
            throw sim::InputError(file.string(), "", "its unit differs from that of " + files.front().string());
        if (one.body != all.body) all.body.reset();  // they are placed anew, round one body
        const int first = static_cast<int>(all.parts.size());
        for (sim::DrawnSeam& seam : one.seams) {
            seam.first.panel += first;
            seam.second.panel += first;
            all.seams.push_back(seam);
        }
        std::ranges::move(one.parts, std::back_inserter(all.parts));
        std::ranges::move(one.notes, std::back_inserter(all.notes));
    }
    all.pictures = std::move(pictures);
    return all;
}

// Bindings are folded in layers, which a flat strip of cloth is not.
void lay_aside_folded(sim::Pattern& pattern, const std::vector<sim::PanelRole>& roles,
                      std::vector<std::string>& notes) {
    for (std::size_t p = 0; p < roles.size(); ++p) {
        sim::Panel& panel = pattern.panels[p];
        if (roles[p].part != sim::GarmentPart::Binding || !panel.is_worn) continue;
        panel.is_worn = false;
        notes.push_back(panel.name + ": a binding, folded in layers: cut and sewn, but not draped");
    }
}

// Of a sleeve that no seam joins: the one of its side that is worn in its place; empty: there is none.
std::string sleeve_instead_of(std::size_t sleeve, const sim::Pattern& pattern,
                              const std::vector<sim::PanelRole>& roles) {
    if (roles[sleeve].part != sim::GarmentPart::Sleeve) return {};
    for (std::size_t p = 0; p < roles.size(); ++p) {
        const bool is_of_its_side = pattern.panels[p].mirror_of.empty() == pattern.panels[sleeve].mirror_of.empty();
        if (roles[p].part == sim::GarmentPart::Sleeve && pattern.panels[p].is_worn && is_of_its_side)
            return pattern.panels[p].name;
    }
    return {};
}

// Panels that no seam joins to the garment would fall off the body. A part of several panels may be a garment of its
// own; a single one beside such parts is none, however large.
void lay_aside_loose(sim::Pattern& pattern, const std::vector<sim::PanelRole>& roles, std::vector<std::string>& notes) {
    constexpr double kSmall = 0.4;  // of the largest part's area: less is no garment of its own
    sim::DisjointSets sets(pattern.panels.size());
    const auto is_worn = [&](int p) { return pattern.panels[static_cast<std::size_t>(p)].is_worn; };
    std::vector<bool> is_joined(pattern.panels.size(), false);  // by a seam, also with itself
    for (const sim::Seam& seam : pattern.seams) {
        if (!is_worn(seam.first.panel) || !is_worn(seam.second.panel)) continue;
        sets.join(seam.first.panel, seam.second.panel);
        for (const int p : {seam.first.panel, seam.second.panel}) is_joined[static_cast<std::size_t>(p)] = true;
    }
    const bool has_parts = std::ranges::count(is_joined, true) > 1;
    std::vector<double> area(pattern.panels.size(), 0);
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        if (pattern.panels[p].is_worn)
            area[static_cast<std::size_t>(sets.find(static_cast<int>(p)))] += outline_area(pattern.panels[p]);
    }
    const double largest = *std::ranges::max_element(area);
    std::vector<std::size_t> loose;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const double own = area[static_cast<std::size_t>(sets.find(static_cast<int>(p)))];
        const bool is_accessory = roles[p].part == sim::GarmentPart::Accessory && own < largest;
        const bool is_single = has_parts && !is_joined[p];
        if (is_worn(static_cast<int>(p)) && (own < kSmall * largest || is_accessory || is_single)) loose.push_back(p);
    }
    for (const std::size_t p : loose) pattern.panels[p].is_worn = false;
    for (const std::size_t p : loose) {
        const std::string other = sleeve_instead_of(p, pattern, roles);
        notes.push_back(pattern.panels[p].name + ": no seam joins it to the garment" +
                        (other.empty() ? "" : ", where '" + other + "' is sewn in as the sleeve") +
                        ": on the sheet, but not worn");
    }
}

std::string without_suffix(const std::string& name, const std::string& suffix) {
    return name.ends_with(suffix) ? name.substr(0, name.size() - suffix.size()) : name;
}

// sleeve and sleeve_mirrored become left_sleeve and right_sleeve, whichever they are; also in notes about panels.
void name_sides(sim::Pattern& pattern, const std::vector<sim::PanelRole>& roles, std::span<std::string> notes) {
    for (std::size_t p = 0; p < roles.size(); ++p) {
        sim::Panel& panel = pattern.panels[p];
        const std::string old = panel.name;
        const bool has_twin =
            std::ranges::any_of(pattern.panels, [&](const sim::Panel& other) { return other.mirror_of == old; });
        if ((panel.mirror_of.empty() && !has_twin) || roles[p].flank == sim::Flank::None) continue;
        const std::string side = roles[p].flank == sim::Flank::Left ? "left_" : "right_";
        const std::string name = side + without_suffix(old, "_mirrored");
        if (std::ranges::any_of(pattern.panels, [&](const sim::Panel& other) { return other.name == name; })) continue;
        panel.name = name;
        for (std::string& note : notes) {
            if (note.starts_with(old + ": ")) note.replace(0, old.size(), name);
            if (const std::size_t at = note.find("'" + old + "'"); at != note.npos)
                note.replace(at + 1, old.size(), name);
        }
        for (sim::Panel& other : pattern.panels) {
            if (other.mirror_of == old) other.mirror_of = name;
        }
    }
}

std::string describe_panel(const sim::Panel& panel, const sim::PanelRole& role) {
    const Eigen::AlignedBox2d box = outline_box(panel);
    std::array<char, 96> size{};
    std::snprintf(size.data(), size.size(), ", %.1f x %.1f cm", 100 * box.sizes().x(), 100 * box.sizes().y());
    std::string text = panel.name + ": " + std::string(name_of(role.part));
    if (role.face != sim::Face::None) text += role.face == sim::Face::Front ? ", front" : ", back";
    if (!panel.is_worn) text += ", not worn";
    return text + size.data();
}

std::vector<std::string> describe_all(const sim::Pattern& pattern, const std::vector<sim::SeamProposal>& proposals) {
    std::vector<std::string> lines;
    for (const sim::SeamProposal& proposal : proposals) lines.push_back(describe(pattern, proposal));
    return lines;
}

// The body round which the panels are placed: as asked, else of measurements, else the female mannequin.
std::string body_of(const sim::Drawing& drawing, const ImportOptions& options, std::vector<std::string>& lines) {
    if (!options.body.empty()) return options.body;
    if (options.measurements.empty() && drawing.measurements.empty()) return "mannequin:sex=female";
    FittedMannequin body = options.measurements.empty()
                               ? fitted_mannequin(drawing.measurements, drawing.measurement_set + " " + drawing.title)
                               : read_fitted_mannequin(options.measurements);
    lines = std::move(body.lines);
    return mannequin_text(body.fit.options);
}

// Puts round the body what can be worn of the garment.
std::vector<sim::PanelRole> place(ImportedGarment& out, const sim::Drawing& drawing, const ImportOptions& options) {
    const std::size_t read = out.notes.size();  // those before it are about the parts of the files
    for (sim::Panel& panel : out.pattern.panels) take_placement(panel, {});  // where the drawing has it does not count
    const std::vector<sim::PanelRole> roles = roles_of(out.pattern, out.hints);
    lay_aside_folded(out.pattern, roles, out.notes);
    if (!out.pattern.seams.empty()) lay_aside_loose(out.pattern, roles, out.notes);
    out.pattern.body = body_of(drawing, options, out.body);
    const sim::MadeBody body = make_body({.source = out.pattern.body});
    sim::Arrangement arrangement = arrange_pattern(out.pattern, *body.body, out.hints);
    std::ranges::move(arrangement.notes, std::back_inserter(out.notes));
    name_sides(out.pattern, arrangement.roles, std::span(out.notes).subspan(read));
    return std::move(arrangement.roles);
}

// Whether the body that a drawing names can be made; if not, a note says why.
bool is_mannequin(const std::string& body, std::vector<std::string>& notes) {
    try {
        make_body({.source = body});
        return true;
    } catch (const sim::InputError& error) {
        notes.push_back(std::string("the file's body is not used: ") + error.what());
        return false;
    }
}

}  // namespace

ImportedGarment import_garment(const std::vector<std::filesystem::path>& files, const ImportOptions& options) {
    ImportedGarment out;
    const sim::Drawing drawing = read_drawings(files, options, out.notes);
    sim::PanelsOfDrawing made = make_panels(drawing, files.front().string(), options.panels);
    std::ranges::move(made.notes, std::back_inserter(out.notes));
    out.pattern = std::move(made.pattern);
    out.hints = std::move(made.hints);
    out.sizes = std::move(made.sizes);
    if (out.pattern.panels.empty()) {
        out.pattern.body = body_of(drawing, options, out.body);
        out.pictures = lay_pictures(out.pattern, drawing.pictures);
        return out;
    }
    std::vector<sim::SeamProposal> sewn, possible;
    if (out.pattern.seams.empty() && !made.is_placed) {
        for (sim::SeamProposal& proposal :
             propose_seams(out.pattern, {.accepted = options.least_confidence, .hints = out.hints})) {
            const bool is_sewn = proposal.confidence >= options.least_confidence;
            (is_sewn ? sewn : possible).push_back(std::move(proposal));
        }
        accept_proposals(out.pattern, sewn);
        std::ranges::move(fold_ribbing(out.pattern, made.ribbing), std::back_inserter(out.notes));
    }
    const bool is_placed = made.is_placed && options.body.empty() && options.measurements.empty() &&
                           is_mannequin(out.pattern.body, out.notes);
    const std::vector<sim::PanelRole> roles =
        is_placed ? roles_of(out.pattern, out.hints) : place(out, drawing, options);
    out.sewn = describe_all(out.pattern, after_acceptance(sewn, sewn));
    out.possible = describe_all(out.pattern, after_acceptance(possible, sewn));
    for (std::size_t p = 0; p < out.pattern.panels.size(); ++p)
        out.panels.push_back(describe_panel(out.pattern.panels[p], roles[p]));
    out.pictures = lay_pictures(out.pattern, drawing.pictures);
    return out;
}

}  // namespace selvedge::app
