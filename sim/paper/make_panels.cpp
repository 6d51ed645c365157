#include "sim/paper/make_panels.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "sim/core/error.h"
#include "sim/core/lower_case.h"
#include "sim/paper/drawing_unit.h"
#include "sim/paper/drawn_outline.h"
#include "sim/paper/part_panel.h"
#include "sim/paper/path_builder.h"
#include "sim/paper/size_names.h"
#include "sim/paper/upright_panels.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/outline.h"
#include "sim/proposals/panel_role.h"

namespace selvedge::sim {
namespace {

// "sleeve" for "left_sleeve", of which the other is cut, too: seams tell which is which.
std::string without_side(const std::string& name) {
    const std::string small = lower_case(name);
    for (const std::string_view side : {"left", "right"}) {
        const std::size_t at = small.find(side);
        if (at == std::string::npos || small.size() != name.size()) continue;
        std::string rest = name.substr(0, at), after = name.substr(at + side.size());
        const auto is_gap = [](char c) { return c == '_' || c == ' ' || c == '-'; };
        while (!after.empty() && is_gap(after.front())) after.erase(0, 1);
        if (after.empty()) {
            while (!rest.empty() && is_gap(rest.back())) rest.pop_back();
        }
        return rest + after;
    }
    return name;
}

// ---- Sizes.

std::vector<std::string> sizes_of(const Drawing& drawing) {
    std::vector<std::string> sizes;
    for (const DrawnPart& part : drawing.parts) {
        if (!part.size.empty() && std::ranges::find(sizes, part.size) == sizes.end()) sizes.push_back(part.size);
    }
    return sizes;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

// ---- The pattern.

class PanelMaker {
 public:
    PanelMaker(const Drawing& drawing, const std::string& file, const MakePanelsOptions& options)
        : drawing_(drawing), file_(file), options_(options) {}

    PanelsOfDrawing make() {
        out_.notes = drawing_.notes;
        out_.hints = std::filesystem::path(file_).stem().string() + " ";
        out_.pattern.name = drawing_.title;
        out_.sizes = sizes_of(drawing_);
        choose_size();
        choose_scale();
        std::vector<int> first_panel;
        for (const DrawnPart& part : drawing_.parts) {
            first_panel.push_back(static_cast<int>(out_.pattern.panels.size()));
            if (!part.size.empty() && part.size != out_.pattern.size) continue;
            add_part(part);
        }
        if (out_.pattern.panels.empty()) {
            if (!drawing_.pictures.empty()) return std::move(out_);
            throw InputError(
                file_, "",
                "no closed outline: " + (first_open_.empty() ? "nothing that could be a panel" : first_open_));
        }
        doubt_scale();
        if (!drawing_.is_upright && drawing_.seams.empty() && turn_upright(out_.pattern.panels))
            out_.notes.emplace_back("the parts lie on their sides: turned upright");
        add_seams(first_panel);
        finish_pairs();
        place_on_body();
        share_fabric();
        if (drawing_.allowance) out_.pattern.allowance = std::clamp(*drawing_.allowance, 0.0, kWidestAllowance);
        return std::move(out_);
    }

 private:
    void choose_size() {
        if (!options_.size.empty()) {
            const auto size = find_size(options_.size);
            if (!size) {
                throw InputError(file_, "",
                                 out_.sizes.empty() ? "the file names no sizes"
                                                    : "no size '" + options_.size + "': " + joined(out_.sizes));
            }
            out_.pattern.size = *size;
            return;
        }
        if (out_.sizes.empty()) return;
        const auto sample = find_size(drawing_.sample_size);
        std::vector<std::string> sorted = out_.sizes;
        sort_sizes(sorted);
        out_.pattern.size = sample ? *sample : sorted[(sorted.size() - 1) / 2];
        if (out_.sizes.size() > 1) {
            out_.notes.push_back("sizes " + joined(out_.sizes) + ": took " + out_.pattern.size +
                                 (sample ? ", the sample size" : "") + "; --size takes another");
        }
    }

    // The size of the file that is meant, in whatever case it is written; none: it has no such size.
    std::optional<std::string> find_size(const std::string& wanted) const {
        if (std::ranges::find(out_.sizes, wanted) != out_.sizes.end()) return wanted;
        const auto found = std::ranges::find_if(
            out_.sizes, [&](const std::string& size) { return lower_case(size) == lower_case(wanted); });
        return found == out_.sizes.end() ? std::nullopt : std::optional(*found);
    }

    void choose_scale() {
        if (drawing_.parts.empty()) return;
        if (options_.metres_per_unit || drawing_.metres_per_unit) {
            scale_ = options_.metres_per_unit ? *options_.metres_per_unit : *drawing_.metres_per_unit;
            return;
        }
        const DrawingUnit unit = guess_unit(drawing_);
        scale_ = unit.metres;
        out_.is_unit_guessed = true;
        out_.notes.push_back(std::string("the file names no unit: 1 unit taken as 1 ") + unit.name +
                             " from the size of the parts; --unit sets another");
    }

    void doubt_scale() {
        double largest = 0;
        for (const Panel& panel : out_.pattern.panels)
            largest = std::max(largest, outline_box(panel, 1e-3).sizes().maxCoeff());
        if (const std::string doubt = doubt_of_size(largest, scale_); !doubt.empty()) out_.notes.push_back(doubt);
    }

    static bool is_other_material(const std::string& material) {
        const PanelRole role = role_of_name(material);
        return role.part == GarmentPart::Accessory;
    }

    static bool has_fold_edge(const DrawnPart& part) {
        return std::ranges::any_of(part.paths, [](const DrawnPath& path) { return path.kind == LineKind::FoldEdge; });
    }

    // FreeSewing writes "on the fold" beside parts that have none, and draws each fold that there is.
    DrawnPart without_false_fold(DrawnPart part) {
        const bool is_told_only = part.cut.is_on_fold.value_or(false) && !has_fold_edge(part);
        if (!is_told_only || !drawing_.format.starts_with("FreeSewing") ||
            std::ranges::none_of(drawing_.parts, has_fold_edge))
            return part;
        part.cut.is_on_fold = false;
        out_.notes.push_back(part.name +
                             ": cut on the fold by its text, but its fold is not drawn, as those of other parts are: "
                             "not unfolded");
        return part;
    }

    void add_part(const DrawnPart& part) {
        for (const DrawnText& text : part.texts) out_.hints += text.text + " ";
        const std::optional<double> allowance = options_.allowance ? options_.allowance : drawing_.allowance;
        PartPanel read;
        try {
            read = panel_of_part(without_false_fold(part), drawing_, scale_, allowance, file_);
        } catch (const InputError& error) {
            if (drawing_.parts.size() == 1 || !drawing_.seams.empty()) throw;
            out_.notes.push_back(part.name + ": " + error.problem() + ": left out");
            return;
        }
        out_.notes.insert(out_.notes.end(), read.notes.begin(), read.notes.end());
        std::optional<Panel>& panel = read.panel;
        if (!panel) {
            const std::string open = open_outline(part);
            out_.notes.push_back(part.name + ": no closed outline, left out" + (open.empty() ? "" : ": " + open));
            if (first_open_.empty()) first_open_ = open;
            return;
        }
        const PanelRole role = role_of_name(panel->name), told = role_of_name(part.category);
        const bool is_named = role.part != GarmentPart::Unknown || role.face != Face::None;
        if (!is_named && (told.part != GarmentPart::Unknown || told.face != Face::None))
            panel->name += " " + part.category;
        panel->name = free_name(panel->name.empty() ? "panel" : panel->name);
        if (is_shipped_fabric(part.cut.material)) {
            panel->fabric = part.cut.material;
        } else if (part.cut.material == "ribbing") {
            panel->fabric = "jersey";  // the shipped knit
            out_.ribbing.push_back(panel->name);
            out_.notes.push_back(panel->name + ": cut from ribbing, which is taken for jersey");
        } else if (is_other_material(part.cut.material)) {
            panel->is_worn = false;
            out_.notes.push_back(panel->name + ": cut from " + part.cut.material + ", not worn");
        }
        is_placed_ = is_placed_ && read.is_placed;
        is_mirrored_.push_back(read.is_mirrored);
        is_pair_.push_back(is_pair(part, read.is_unfolded));
        out_.pattern.panels.push_back(std::move(*panel));
    }

    // "parts.front.paths.seam is open by 3 mm": of the part's longest open line that could be its outline; empty: it
    // has none.
    std::string open_outline(const DrawnPart& part) const {
        const DrawnPath* longest = nullptr;
        for (const DrawnPath& path : part.paths) {
            const bool may_be =
                path.kind == LineKind::Sew || path.kind == LineKind::Cut || path.kind == LineKind::Unknown;
            if (!may_be || path.is_closed || path.edges.size() < 2) continue;
            if (!longest || size_of(path) > size_of(*longest)) longest = &path;
        }
        if (!longest) return {};
        return longest->place + " is " + open_by(gap_of(*longest), scale_);
    }

    // Whether the part is cut twice, once mirrored; none: the drawing does not say.
    static std::optional<bool> is_pair(const DrawnPart& part, bool is_unfolded) {
        const CutInstructions& cut = part.cut;
        // A half whose fold is not found: its name and shape tell.
        const bool is_half = cut.is_on_fold.value_or(false) && !is_unfolded && !has_fold_edge(part);
        if (is_half && !cut.are_mirrored.value_or(false)) return std::nullopt;
        if (cut.pieces && *cut.pieces % 2 != 0) return false;
        // "Cut 2, mirrored, on the fold" without a fold edge: two pieces from folded cloth.
        if (cut.is_on_fold.value_or(false) && (has_fold_edge(part) || !cut.are_mirrored.value_or(false))) return false;
        if (cut.are_mirrored) return *cut.are_mirrored && cut.pieces.value_or(2) >= 2;
        return std::nullopt;
    }

    std::string free_name(const std::string& wanted) const {
        const auto is_taken = [&](const std::string& name) {
            return std::ranges::any_of(out_.pattern.panels, [&](const Panel& panel) { return panel.name == name; });
        };
        std::string name = wanted;
        for (int number = 2; is_taken(name); ++number) name = wanted + "_" + std::to_string(number);
        return name;
    }

    // Seams that the file states. A part that was unfolded or left out has none.
    void add_seams(const std::vector<int>& first_panel) {
        for (Seam seam : drawing_.seams) {
            bool is_whole = true;
            for (SeamSide* side : {&seam.first, &seam.second}) {
                if (side->panel < 0 || as_size(side->panel) >= first_panel.size()) {
                    is_whole = false;
                    continue;
                }
                side->panel = first_panel[as_size(side->panel)];
                is_whole = is_whole && as_size(side->panel) < out_.pattern.panels.size() && side->edge >= 0 &&
                           as_size(side->edge) < out_.pattern.panels[as_size(side->panel)].edges.size();
            }
            if (!is_whole) {
                out_.notes.push_back("a seam names an edge that is not there: left out");
                continue;
            }
            for (SeamSide* side : {&seam.first, &seam.second}) {
                if (!is_mirrored_[as_size(side->panel)]) continue;
                // The same corners stay together.
                side->edge = static_cast<int>(out_.pattern.panels[as_size(side->panel)].edges.size()) - 1 - side->edge;
                seam.is_reversed = !seam.is_reversed;
            }
            out_.pattern.seams.push_back(std::move(seam));
        }
        has_seams_ = !drawing_.seams.empty();
    }

    void place_on_body() {
        if (!drawing_.body || !is_placed_) return;
        out_.is_placed = true;
        out_.pattern.body = drawing_.body->text;
        out_.pattern.body_height = drawing_.body->height;
    }

    // What all panels are cut from is the fabric of the garment.
    void share_fabric() {
        const std::string fabric = out_.pattern.panels.front().fabric;
        if (!std::ranges::all_of(out_.pattern.panels, [&](const Panel& panel) { return panel.fabric == fabric; }))
            return;
        out_.pattern.fabric = fabric;
        for (Panel& panel : out_.pattern.panels) panel.fabric.clear();
    }

    // Adds the second panel of each mirrored pair. A drawing with seams or a body of its own has all panels.
    void finish_pairs() {
        if (has_seams_ || drawing_.body) return;
        const std::vector<PanelRole> roles = roles_of(out_.pattern, out_.hints);
        const std::size_t count = out_.pattern.panels.size();
        for (std::size_t p = 0; p < count; ++p) {
            const bool is_told = is_pair_[p].has_value();
            const bool is_lone = roles[p].flank == Flank::None && !has_twin(p, count);
            const bool is_wanted = is_told ? *is_pair_[p] : is_lone && is_one_of_a_pair(p, roles[p]);
            if (!is_wanted || is_inner_layer(p, roles[p])) continue;
            if (!is_told)
                out_.notes.push_back(out_.pattern.panels[p].name + ": taken for one of a pair, by its name or shape");
            add_mirror_image(p);
        }
    }

    // Whether a second piece lies under the first: the part spans the middle of the body already, as a yoke that is cut
    // twice.
    bool is_inner_layer(std::size_t p, const PanelRole& role) const {
        using enum GarmentPart;
        const bool comes_once = role.part == Collar || role.part == CollarStand || role.part == Yoke ||
                                role.part == Waistband || role.part == Hood ||
                                (role.part == Torso && role.face != Face::None);
        return comes_once && is_mirrored_in_itself(out_.pattern.panels[p], 0);
    }

    // By its name, or because it is the front or the back of one half of the body, or lies beside the middle of a
    // garment that is cut on the fold there.
    bool is_one_of_a_pair(std::size_t p, const PanelRole& role) const {
        using enum GarmentPart;
        const Panel& panel = out_.pattern.panels[p];
        if (comes_in_pairs(role, panel.name)) return true;
        const bool may_lie_beside = role.part == Unknown || role.part == Torso || role.part == Skirt;
        const bool has_fold = std::ranges::any_of(drawing_.parts, has_fold_edge);
        if (has_fold && may_lie_beside && !is_mirrored_in_itself(panel, 0) && !is_mirrored_in_itself(panel, 1))
            return true;
        const bool is_face =
            (role.face != Face::None && (role.part == GarmentPart::Torso || role.part == GarmentPart::Skirt)) ||
            role.part == GarmentPart::Hood || role.part == GarmentPart::Yoke;
        return is_face && !is_mirrored_in_itself(panel, 0) && !is_mirrored_in_itself(panel, 1);
    }

    // Whether the file draws the mirror image itself.
    bool has_twin(std::size_t p, std::size_t count) const {
        const Panel& panel = out_.pattern.panels[p];
        for (std::size_t q = 0; q < count; ++q) {
            const Panel& other = out_.pattern.panels[q];
            if (q == p || other.edges.size() != panel.edges.size()) continue;
            const double area = outline_area(panel);
            if (std::abs(outline_area(other) - area) < 1e-6 * area) return true;
        }
        return false;
    }

    void add_mirror_image(std::size_t p) {
        Panel image = mapped_panel(out_.pattern.panels[p], Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
        Panel& panel = out_.pattern.panels[p];
        panel.pieces = std::max(1, panel.pieces / 2);
        image.pieces = panel.pieces;
        if (const std::string name = without_side(panel.name); !name.empty() && free_name(name) == name)
            panel.name = name;
        image.mirror_of = panel.name;
        image.name = free_name(panel.name + "_mirrored");
        out_.pattern.panels.push_back(std::move(image));
    }

    const Drawing& drawing_;
    const std::string& file_;
    const MakePanelsOptions& options_;
    double scale_ = 1;
    bool has_seams_ = false;
    bool is_placed_ = true;                     // so far, every panel
    std::vector<bool> is_mirrored_;             // per panel of the drawing: see PartPanel
    std::string first_open_;                    // place and gap of the first outline that is open
    std::vector<std::optional<bool>> is_pair_;  // per panel of the drawing
    PanelsOfDrawing out_;
};

}  // namespace

PanelsOfDrawing make_panels(const Drawing& drawing, const std::string& file, const MakePanelsOptions& options) {
    return PanelMaker(drawing, file, options).make();
}

}  // namespace selvedge::sim
