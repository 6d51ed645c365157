#include "sim/paper/plain_parts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>
#include <sstream>

#include "sim/core/error.h"
#include "sim/core/lower_case.h"
#include "sim/core/printable.h"
#include "sim/paper/closed_chains.h"
#include "sim/paper/cut_text.h"
#include "sim/paper/joined_path.h"
#include "sim/paper/not_panels.h"
#include "sim/paper/path_builder.h"
#include "sim/paper/plain_areas.h"
#include "sim/paper/size_names.h"
#include "sim/paper/size_nests.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/polyline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

bool says(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

bool is_generated(const std::string& id) {
    if (id.empty()) return true;
    for (const std::string_view prefix : {"path", "rect", "polygon", "polyline", "circle", "ellipse", "SVGID", "XMLID_",
                                          "Artboard", "use", "g", "layer", "Layer_", "line"}) {
        if (!id.starts_with(prefix)) continue;
        const std::string rest = id.substr(prefix.size());
        if (std::ranges::all_of(rest, [](char c) {
                return std::isdigit(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == ' ';
            }))
            return true;
    }
    return false;
}

// What is written along the lines of a part, whole: "Grainline", "Place on fold", "SA included".
bool is_instruction(const std::vector<std::string>& words) {
    static constexpr auto kWords = std::to_array<std::string_view>(
        {"grain",         "grainline", "line",  "straight", "fadenlauf",  "droit",     "fil",       "hilo",
         "draadrichting", "on",        "the",   "place",    "fold",       "seam",      "allowance", "sa",
         "incl",          "included",  "notch", "notches",  "nahtzugabe", "inklusive", "enthalten"});
    return std::ranges::all_of(words, [](const std::string& word) {
        return std::isdigit(static_cast<unsigned char>(word.front())) != 0 || word == "cm" || word == "mm" ||
               std::ranges::find(kWords, word) != kWords.end();
    });
}

// Whether a text in a part can be its name: no size, number, measure or instruction.
bool is_name(const std::string& text) {
    CutInstructions cut;
    const bool has_letters = std::ranges::any_of(words_of(text), [](const std::string& word) {
        return word.size() > 2 && !std::isdigit(static_cast<unsigned char>(word.front()));
    });
    return has_letters && !size_of_name(text) && !says(text, "=") && !text.starts_with('#') && !says(text, "www.") &&
           !is_instruction(words_of(text)) && !read_cut_text(text, cut);
}

// The words that the file has for a shape: its own, and those of its groups.
std::string words_for(const PlainShape& shape) {
    std::string words = lower_case(shape.path.name) + " " + lower_case(shape.classes);
    for (const PlainGroup& group : shape.groups) words += " " + lower_case(group.id) + " " + lower_case(group.label);
    return words;
}

LineKind kind_for(const PlainShape& shape) {
    if (shape.path.kind != LineKind::Unknown) return shape.path.kind;
    const std::string words = words_for(shape);
    if (says(words, "grain") || says(words, "fadenlauf")) return LineKind::Grain;
    if (says(words, "fold lines") || says(words, "fold_lines")) return LineKind::FoldLine;
    if (says(words, "fold") && !shape.path.is_closed) return LineKind::FoldEdge;
    if (says(words, "sew") || says(words, "stitch") || says(words, "seamline") || says(words, "seam line") ||
        says(words, "seam_line")) {
        return LineKind::Sew;
    }
    if (says(words, "cut")) return LineKind::Cut;
    if (says(words, "help") || says(words, "guide")) return LineKind::Help;
    return LineKind::Unknown;
}

class PlainReader {
 public:
    PlainReader(PlainDrawing plain, const std::string& file, Drawing& drawing)
        : plain_(std::move(plain)), file_(file), drawing_(drawing) {}

    void read() {
        const std::size_t first = drawing_.parts.size();
        for (PlainShape& shape : plain_.shapes) shape.path.kind = kind_for(shape);
        take_drill_points();
        gap_ = gap_between_ends();
        join_lines();
        close_small_gaps();
        areas_ = find_areas(plain_.shapes, file_);
        const std::size_t closed = areas_.size();
        NotPanels left_out = leave_out_what_is_no_panel(plain_, areas_);
        std::ranges::move(left_out.notes, std::back_inserter(drawing_.notes));
        if (left_out.metres_per_unit) drawing_.metres_per_unit = plain_.metres_per_unit = left_out.metres_per_unit;
        nests_ = find_size_nests(plain_, areas_);
        for (std::size_t a = 0; a < areas_.size(); ++a) around_.push_back(part_around(a));
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (!areas_[a].is_left_out && !around_[a]) add_part(a);
        }
        if (closed == 0 && drawing_.parts.empty()) refuse_open();
        add_open_shapes();
        tell_outside();
        tell_lines_inside();
        add_texts();
        for (const DrawnMark& mark : plain_.marks) {
            for (DrawnPart* part : parts_at(mark.at)) part->marks.push_back(mark);
        }
        name_parts(first);
    }

 private:
    double gap_between_ends() const {
        Eigen::AlignedBox2d box;
        for (const PlainShape& shape : plain_.shapes) box.extend(box_around(shape.path.vertices));
        return join_gap(plain_.metres_per_unit, box.isEmpty() ? 0 : box.diagonal().norm());
    }

    // Whether its ends nearly meet, far from all of it: no short piece of an outline.
    bool meets_itself(const DrawnPath& path) const {
        constexpr double kLong = 4;  // gaps
        return gap_of(path) <= gap_ && polyline_length(points_of_path(path)) > kLong * gap_;
    }

    // Ends that nearly meet are one.
    void close_small_gaps() {
        for (PlainShape& shape : plain_.shapes) {
            DrawnPath& path = shape.path;
            if (path.is_closed || path.edges.size() < 2 || !meets_itself(path) || is_mark_kind(path.kind)) continue;
            const double open = gap_of(path);
            path.vertices.pop_back();
            path.edges.back().end = 0;
            path.is_closed = true;
            if (open > 0)
                drawing_.notes.push_back(path.place + ": " + open_by(open, drawing_.metres_per_unit) + ", closed");
        }
    }

    static bool is_mark_kind(LineKind kind) {
        return kind == LineKind::Grain || kind == LineKind::FoldEdge || kind == LineKind::FoldLine ||
               kind == LineKind::Help;
    }

    // Small signs on a layer for them, or in a group: circles with crosses, one point each.
    void take_drill_points() {
        constexpr double kLargest = 0.015, kSame = 1e-3;  // m
        const double unit = plain_.metres_per_unit.value_or(0.001);
        std::erase_if(plain_.shapes, [&](const PlainShape& shape) {
            const Eigen::AlignedBox2d box = box_around(shape.path.vertices);
            if (!says(words_for(shape), "drill") || unit * box.sizes().maxCoeff() > kLargest) return false;
            const Vec2d at = box.center();
            const bool is_known = std::ranges::any_of(plain_.marks, [&](const DrawnMark& mark) {
                return mark.kind == MarkKind::Drill && unit * (mark.at - at).norm() < kSame;
            });
            if (!is_known) plain_.marks.push_back({.kind = MarkKind::Drill, .at = at});
            return true;
        });
    }

    // ---- Outlines that are drawn in pieces.

    void join_lines() {
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < plain_.shapes.size(); ++i) {
            const DrawnPath& path = plain_.shapes[i].path;
            if (path.is_closed || path.edges.empty() || meets_itself(path) || is_mark_kind(path.kind)) continue;
            open.push_back(i);
        }
        constexpr std::size_t kMost = 20000;
        if (open.size() > kMost) {
            drawing_.notes.push_back(count_text(open.size(), "open line") + ": more than 20,000 are not joined");
            return;
        }
        if (open.size() < 2) return;
        const bool has_groups = groups_tell_parts(open);
        std::vector<KeyedLine> lines;
        for (const std::size_t i : open) {
            const PlainShape& shape = plain_.shapes[i];
            const std::string group = shape.groups.empty() ? "" : std::to_string(shape.groups.back().number);
            lines.push_back({points_of_path(shape.path), {group + "|" + shape.style, shape.style}});
        }
        const Branches first = has_groups ? Branches::Outer : Branches::Faces;
        const ClosedChains joined = join_in_passes(lines, gap_, {first, Branches::Faces, Branches::Faces});
        if (joined.chains.empty()) return;
        replace_joined(open, joined);
    }

    // Whether groups hold one part each: they are several, and no layers.
    bool groups_tell_parts(const std::vector<std::size_t>& open) const {
        std::set<int> groups;
        for (const std::size_t i : open) {
            const std::vector<PlainGroup>& all = plain_.shapes[i].groups;
            if (all.empty() || all.back().is_layer) return false;
            groups.insert(all.back().number);
        }
        return groups.size() > 1;
    }

    void replace_joined(const std::vector<std::size_t>& open, const ClosedChains& joined) {
        std::vector<PlainShape> outlines;
        std::set<std::size_t> used;
        for (const std::size_t i : joined.repeated) used.insert(open[i]);
        for (const ClosedChain& chain : joined.chains) {
            std::vector<const DrawnPath*> paths;
            for (const ChainLink& link : chain) {
                paths.push_back(&plain_.shapes[open[link.line]].path);
                used.insert(open[link.line]);
            }
            PlainShape outline = plain_.shapes[open[chain.front().line]];
            outline.path = joined_path(paths, chain);
            outline.path.place = paths.front()->place + " and what meets it";
            if (!std::ranges::all_of(paths, [&](const DrawnPath* one) { return one->name == outline.path.name; }))
                outline.path.name.clear();
            outline.is_filled_only = false;
            outlines.push_back(std::move(outline));
        }
        tell_joined(joined);
        std::vector<PlainShape> kept;
        for (std::size_t i = 0; i < plain_.shapes.size(); ++i) {
            if (!used.contains(i)) kept.push_back(std::move(plain_.shapes[i]));
        }
        // From left to right: the largest of what is joined would come first otherwise.
        std::ranges::stable_sort(outlines, {},
                                 [](const PlainShape& shape) { return box_around(shape.path.vertices).min().x(); });
        std::ranges::move(kept, std::back_inserter(outlines));
        plain_.shapes = std::move(outlines);
    }

    void tell_joined(const ClosedChains& joined) {
        std::string note = joined_note(joined.chains.size(), joined.widest_gap, drawing_.metres_per_unit);
        if (joined.shared > 0)
            note += "; " + count_text(static_cast<std::size_t>(joined.shared), "line") +
                    " between two of them: both have it";
        drawing_.notes.push_back(note);
    }

    // Where no path is closed: names the largest of those that were meant to be.
    void refuse_open() const {
        const DrawnPath* largest = nullptr;
        double most = 0;
        for (const PlainShape& shape : plain_.shapes) {
            const Eigen::AlignedBox2d box = box_around(shape.path.vertices);
            if (shape.path.is_closed || shape.path.vertices.size() < 3 || !(box.sizes().sum() > most)) continue;
            largest = &shape.path;
            most = box.sizes().sum();
        }
        if (!largest) return;
        throw InputError(file_, largest->place,
                         open_by(gap_of(*largest), drawing_.metres_per_unit) +
                             ", and no other line is closed: nothing that could be a panel");
    }

    // ---- Parts.

    // The outermost area around it, of its own size: a pocket within the sewing line lies in the part, too.
    std::optional<std::size_t> part_around(std::size_t a) const {
        std::optional<std::size_t> part = parent_of_same_size(a);
        while (part) {
            const std::optional<std::size_t> outer = parent_of_same_size(*part);
            if (!outer) break;
            part = outer;
        }
        return part;
    }

    // An area within another size of the same part is a part of its own.
    std::optional<std::size_t> parent_of_same_size(std::size_t a) const {
        std::optional<std::size_t> parent = areas_[a].parent;
        while (parent && (areas_[*parent].is_left_out || nests_.are_sizes_of_one(a, *parent)))
            parent = areas_[*parent].parent;
        return parent;
    }

    void add_part(std::size_t a) {
        const PlainShape& shape = plain_.shapes[areas_[a].shape];
        DrawnPart part;
        part.size = nests_.sizes[a];
        part.paths.push_back(shape.path);
        if (is_mark_kind(part.paths.back().kind)) return;
        bool has_sewing_line = false;
        for (std::size_t b = 0; b < areas_.size(); ++b) {
            if (areas_[b].is_left_out || around_[b] != a) continue;
            DrawnPath path = plain_.shapes[areas_[b].shape].path;
            if (!has_sewing_line && (path.kind == LineKind::Sew || is_inset(areas_[b], areas_[a]))) {
                insets_ += path.kind == LineKind::Sew ? 0 : 1;
                path.kind = LineKind::Sew;
                has_sewing_line = true;
            } else if (path.kind != LineKind::Help && path.kind != LineKind::Cutout) {
                constexpr double kLarge = 0.05;  // of the part's area
                large_lines_ += areas_[b].area > kLarge * areas_[a].area ? 1 : 0;
                path.kind = LineKind::Internal;
            }
            part.paths.push_back(std::move(path));
        }
        LineKind& outer = part.paths.front().kind;
        if (has_sewing_line) outer = LineKind::Cut;
        if (outer != LineKind::Cut && outer != LineKind::Sew) outer = LineKind::Unknown;
        part_of_area_.push_back(a);
        drawing_.parts.push_back(std::move(part));
    }

    void tell_lines_inside() {
        if (insets_ > 0)
            drawing_.notes.push_back(
                count_text(insets_, "part") +
                " drawn as two outlines at an even distance: the inner is taken for the sewing line");
        if (large_lines_ > 0)
            drawing_.notes.push_back(count_text(large_lines_, "closed outline") +
                                     " within a part: taken for lines in it, not for parts");
    }

    std::size_t first_part() const { return drawing_.parts.size() - part_of_area_.size(); }

    // The parts whose areas hold a point: of a nest of sizes, several.
    std::vector<DrawnPart*> parts_at(const Vec2d& p) {
        std::vector<DrawnPart*> found;
        for (std::size_t i = 0; i < part_of_area_.size(); ++i) {
            const PlainArea& area = areas_[part_of_area_[i]];
            if (area.box.contains(p) && is_inside(p, area.points)) found.push_back(&drawing_.parts[first_part() + i]);
        }
        return found;
    }

    void add_open_shapes() {
        const double unit = drawing_.metres_per_unit.value_or(0.001);
        for (const PlainShape& shape : plain_.shapes) {
            if (shape.path.is_closed || shape.path.vertices.size() < 2) continue;
            const Vec2d from = shape.path.vertices.front(), to = shape.path.vertices.back();
            std::vector<DrawnPart*> parts = parts_at((from + to) / 2);
            if (parts.empty()) parts = parts_at(from);
            if (parts.empty()) parts = parts_at(to);
            if (parts.empty() && !is_mark_kind(shape.path.kind)) note_outside(shape);
            if (parts.empty() && nearly_closes(shape.path)) {
                drawing_.notes.push_back(shape.path.place + ": " +
                                         open_by(gap_of(shape.path), drawing_.metres_per_unit) + ", left out");
            }
            for (DrawnPart* part : parts) add_open(shape, unit, *part);
        }
    }

    // Of lines that lie in no part, the longest: it may be of a part that is not closed.
    void note_outside(const PlainShape& shape) {
        const double size = box_around(shape.path.vertices).diagonal().norm();
        ++outside_;
        if (size <= longest_outside_) return;
        longest_outside_ = size;
        place_outside_ = shape.path.place;
    }

    void tell_outside() {
        constexpr double kShare = 0.3;  // of the largest part's size
        double largest = 0;
        for (const std::size_t a : part_of_area_) largest = std::max(largest, areas_[a].box.diagonal().norm());
        if (outside_ == 0 || longest_outside_ < kShare * largest) return;
        drawing_.notes.push_back(count_text(outside_, "open line") +
                                 " in no part, left out: is an outline not closed? The longest is " + place_outside_);
    }

    static void add_open(const PlainShape& shape, double unit, DrawnPart& part) {
        const Vec2d from = shape.path.vertices.front(), to = shape.path.vertices.back();
        const double length = unit * polyline_length(shape.path.vertices);
        constexpr double kShortest = 0.001, kLongest = 0.016;  // m, of a notch
        const bool is_short = length > kShortest && length < kLongest && shape.path.edges.size() <= 2;
        DrawnPath path = shape.path;
        if (says(words_for(shape), "notch") || (is_short && path.kind == LineKind::Unknown)) {
            part.marks.push_back({.at = (from + to) / 2});
            return;
        }
        if (!is_mark_kind(path.kind)) path.kind = LineKind::Internal;
        part.paths.push_back(std::move(path));
    }

    void add_texts() {
        constexpr std::size_t kMostTexts = 5000;  // of a drawing with thousands of parts upon each other
        if (plain_.texts.size() > kMostTexts && part_of_area_.size() > 100) {
            drawing_.notes.push_back("more than 5,000 texts: not read");
            return;
        }
        for (const DrawnText& text : plain_.texts) {
            std::vector<DrawnPart*> parts = parts_at(text.at);
            if (parts.empty() && names_fold(text.text)) parts = part_beside(text.at);
            for (DrawnPart* part : parts) {
                read_cut_text(text.text, part->cut);
                part->texts.push_back(text);
            }
        }
    }

    // The nearest part, if it is as near as a text that stands along its fold.
    std::vector<DrawnPart*> part_beside(const Vec2d& p) {
        constexpr double kBeside = 0.03;  // m
        double least = kBeside / plain_.metres_per_unit.value_or(0.001);
        std::vector<DrawnPart*> found;
        for (std::size_t i = 0; i < part_of_area_.size(); ++i) {
            const double distance = distance_to_outline(p, areas_[part_of_area_[i]].points);
            if (!(distance < least)) continue;
            least = distance;
            found = {&drawing_.parts[first_part() + i]};
        }
        return found;
    }

    // By the path's own name, that of the nearest group of its own, its first text, or its number. The own name of a
    // path that several parts use comes behind the groups.
    void name_parts(std::size_t first) {
        for (std::size_t i = 0; i < part_of_area_.size(); ++i) {
            DrawnPart& part = drawing_.parts[first + i];
            const PlainShape& shape = plain_.shapes[areas_[part_of_area_[i]].shape];
            const auto own_uses = std::ranges::count_if(part_of_area_, [&](std::size_t area) {
                return plain_.shapes[areas_[area].shape].path.name == shape.path.name;
            });
            std::vector<std::string> names;
            if (own_uses == 1) names.push_back(shape.path.name);
            for (auto group = shape.groups.rbegin(); group != shape.groups.rend(); ++group) {
                if (is_shared(*group) || (group->is_layer && names_kind_of_line(*group))) continue;
                names.push_back(group->label);
                names.push_back(group->id);
            }
            for (const DrawnPath& path : part.paths) names.push_back(path.name);
            for (const DrawnText& text : part.texts) {
                std::istringstream lines(text.text);
                for (std::string line; std::getline(lines, line);) {
                    if (is_name(line)) names.push_back(line);
                }
            }
            const auto name = std::ranges::find_if(names, [&](const std::string& one) {
                return !is_generated(one) && (part.size.empty() || size_of_name(one) != part.size);
            });
            part.name = name == names.end() ? "panel_" + std::to_string(i + 1)
                                            : name->substr(0, name->find('\n')).substr(0, 60);
            if (const auto split = split_size(part.name); split && split->second == part.size) part.name = split->first;
        }
    }

    // "Cutting lines" is no name of a part.
    static bool names_kind_of_line(const PlainGroup& group) {
        const std::string name = lower_case(group.label.empty() ? group.id : group.label);
        return std::ranges::any_of(std::array<std::string_view, 8>{"cutting", "sewing", "stitch", "seam", "fold",
                                                                   "grain", "notch", "internal"},
                                   [&](std::string_view kind) { return says(name, kind); });
    }

    // Whether a group holds several parts, or is used by several, so that its name is not that of one.
    bool is_shared(const PlainGroup& group) const {
        int parts = 0;
        for (const std::size_t area : part_of_area_) {
            const std::vector<PlainGroup>& groups = plain_.shapes[areas_[area].shape].groups;
            const auto is_same = [&](const PlainGroup& one) {
                return one.number == group.number || (!group.id.empty() && one.id == group.id);
            };
            parts += std::ranges::any_of(groups, is_same) ? 1 : 0;
        }
        return parts > 1;
    }

    PlainDrawing plain_;
    const std::string& file_;
    Drawing& drawing_;
    double gap_ = 0;              // file units
    std::size_t outside_ = 0;     // open lines that lie in no part
    double longest_outside_ = 0;  // file units
    std::string place_outside_;
    std::size_t insets_ = 0;       // parts whose inner line was taken for the sewing line by its distance alone
    std::size_t large_lines_ = 0;  // closed lines in a part that are large
    std::vector<PlainArea> areas_;
    SizeNests nests_;
    std::vector<std::optional<std::size_t>> around_;  // per area: the outermost around it, of its own size
    std::vector<std::size_t> part_of_area_;           // per part of this drawing: its outermost area
};

}  // namespace

void add_plain_parts(PlainDrawing plain, const std::string& file, Drawing& drawing) {
    PlainReader(std::move(plain), file, drawing).read();
}

}  // namespace selvedge::sim
