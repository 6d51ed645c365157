#include "sim/paper/not_panels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "sim/core/lower_case.h"
#include "sim/core/printable.h"
#include "sim/paper/cut_text.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

using Words = std::vector<std::string>;

bool has_one_of(const Words& words, std::initializer_list<std::string_view> wanted) {
    return std::ranges::any_of(words, [&](const std::string& word) {
        return std::ranges::find(wanted, std::string_view(word)) != wanted.end();
    });
}

// Without the digits at the end of each: "page2" is "page".
Words plain_words(const std::string& text) {
    Words words = words_of(text);
    for (std::string& word : words) {
        while (!word.empty() && word.back() >= '0' && word.back() <= '9') word.pop_back();
    }
    return words;
}

bool is_page_word(const Words& words) {
    return has_one_of(words, {"page", "pages", "frame", "border", "background", "artboard", "sheet", "paper", "rahmen",
                              "seite", "blatt", "hintergrund", "cadre", "fond", "marco", "fondo", "kader"});
}

bool is_legend_word(const Words& words) {
    return has_one_of(words, {"legend", "legende", "légende", "leyenda", "copyright"});
}

// Words that only a test square has.
bool is_test_square_word(const Words& words) {
    return has_one_of(words, {"testsquare", "testquadrat", "prüfquadrat", "kontrollquadrat", "calibration"}) ||
           (has_one_of(words, {"test", "scale", "control"}) && has_one_of(words, {"square", "box"}));
}

bool is_ornament_word(const Words& words) {
    return is_test_square_word(words) || is_legend_word(words) ||
           has_one_of(words, {"logo", "logos", "watermark", "lettering", "scalebar", "ruler", "lineal", "maßstab",
                              "massstab", "scalebox", "titleblock"});
}

bool is_test_word(const Words& words) {
    return has_one_of(words, {"test", "testsquare", "square", "scale", "quadrat", "testquadrat", "prüfquadrat",
                              "kontrollquadrat", "carré", "carre", "cuadrado", "cuadro", "vierkant", "calibration"});
}

// A text that is nothing but lengths: "10 cm", "4\" / 10 cm".
bool is_only_lengths(const std::string& text) {
    return std::ranges::all_of(words_of(text), [](const std::string& word) {
        const bool is_unit = word == "cm" || word == "mm" || word == "in" || word == "inch" || word == "inches" ||
                             word == "x" || word == "zoll";
        return is_unit || std::isdigit(static_cast<unsigned char>(word.front())) != 0;
    });
}

struct Paper {
    double width, height;  // m
};

// ISO 216 A0 to A5 and the formats of ANSI/ASME Y14.1 with legal.
constexpr std::array kPapers = std::to_array<Paper>({{0.841, 1.189},
                                                     {0.594, 0.841},
                                                     {0.420, 0.594},
                                                     {0.297, 0.420},
                                                     {0.210, 0.297},
                                                     {0.148, 0.210},
                                                     {0.2159, 0.2794},
                                                     {0.2159, 0.3556},
                                                     {0.2794, 0.4318},
                                                     {0.4318, 0.5588},
                                                     {0.5588, 0.8636},
                                                     {0.8636, 1.1176}});

class NotPanelFinder {
 public:
    NotPanelFinder(const PlainDrawing& drawing, std::vector<PlainArea>& areas)
        : drawing_(drawing), areas_(areas), is_tile_(areas.size(), false) {}

    NotPanels find() {
        find_test_squares();
        leave_out_ornaments();
        // A frame within a frame shows once the outer one is gone.
        while (leave_out_one_frame()) {
        }
        leave_out_small_ones();
        leave_out_what_lies_in_letters();
        if (small_ > 0)
            out_.notes.push_back(count_text(static_cast<std::size_t>(small_), "small closed shape") +
                                 ": lettering or marks, left out");
        return std::move(out_);
    }

 private:
    const PlainShape& shape(const PlainArea& area) const { return drawing_.shapes[area.shape]; }

    // The words of a shape's own name, and of a group that holds it alone.
    Words own_words(std::size_t a) const {
        const PlainShape& of = shape(areas_[a]);
        Words words = plain_words(of.path.name);
        if (of.groups.empty()) return words;
        const PlainGroup& group = of.groups.back();
        const auto is_in = [&](const PlainArea& other) {
            const std::vector<PlainGroup>& groups = shape(other).groups;
            return std::ranges::find(groups, group.number, &PlainGroup::number) != groups.end();
        };
        if (std::ranges::count_if(areas_, is_in) > 1) return words;
        for (std::string& word : plain_words(group.label + " " + group.id)) words.push_back(std::move(word));
        return words;
    }

    // Those of all groups, too.
    Words all_words(std::size_t a) const {
        Words words = plain_words(shape(areas_[a]).path.name);
        for (const PlainGroup& group : shape(areas_[a]).groups) {
            for (std::string& word : plain_words(group.label + " " + group.id)) words.push_back(std::move(word));
        }
        return words;
    }

    std::string name_of(std::size_t a) const { return shape(areas_[a]).path.place; }

    bool is_kept(std::size_t a) const { return !areas_[a].is_left_out; }

    double largest_area() const {
        double largest = 0;
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (is_kept(a)) largest = std::max(largest, areas_[a].area);
        }
        return largest;
    }

    // With all that lies in it.
    void leave_out_whole(std::size_t a) {
        areas_[a].is_left_out = true;
        for (std::size_t b = 0; b < areas_.size(); ++b) {
            if (areas_[b].parent == a && is_kept(b)) leave_out_whole(b);
        }
    }

    void leave_out_frame(std::size_t a, const std::string& why) {
        areas_[a].is_left_out = true;
        leave_out_title_blocks(a);
        for (PlainArea& other : areas_) {
            if (other.parent == a) other.parent = areas_[a].parent;
        }
        out_.notes.push_back(name_of(a) + ": " + why + ", left out");
    }

    // Rectangles that share a corner with a frame: nobody lays a part there.
    void leave_out_title_blocks(std::size_t frame) {
        constexpr double kNear = 2e-3;    // of the frame's size
        constexpr double kLargest = 0.2;  // of its area
        const Eigen::AlignedBox2d& outer = areas_[frame].box;
        const double near = kNear * outer.diagonal().norm();
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (!is_kept(a) || areas_[a].parent != frame || areas_[a].area > kLargest * areas_[frame].area ||
                !is_upright_rectangle(areas_[a], shape(areas_[a])))
                continue;
            const auto meets = [&](int axis) {
                return std::min(areas_[a].box.min()[axis] - outer.min()[axis],
                                outer.max()[axis] - areas_[a].box.max()[axis]) < near;
            };
            if (!meets(0) || !meets(1)) continue;
            leave_out_whole(a);
            out_.notes.push_back(name_of(a) + ": a title block in a corner of the page frame, left out");
        }
    }

    // ---- Test squares.

    static bool is_square(const PlainArea& area) {
        constexpr double kEven = 0.02;
        const Vec2d size = area.box.sizes();
        return size.minCoeff() > (1 - kEven) * size.maxCoeff();
    }

    void find_test_squares() {
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (!is_kept(a) || !is_square(areas_[a]) || !is_upright_rectangle(areas_[a], shape(areas_[a]))) continue;
            read_test_square(a);
        }
    }

    void read_test_square(std::size_t a) {
        const double side = areas_[a].box.sizes().mean();
        Eigen::AlignedBox2d reach = areas_[a].box;
        reach.extend(reach.min() - Vec2d(side, side) / 2);
        reach.extend(reach.max() + Vec2d(side, side) / 2);
        std::string said;
        bool is_named = is_test_word(own_words(a));
        for (const DrawnText& text : drawing_.texts) {
            if (!reach.contains(text.at)) continue;
            if (CutInstructions cut; read_cut_text(text.text, cut)) continue;  // of a part
            said += text.text + " ";
            is_named = is_named || is_test_word(words_of(lower_case(text.text))) ||
                       (!lengths_in(text.text).empty() && is_only_lengths(text.text));
        }
        constexpr double kTrue = 0.02, kExact = 0.003;
        constexpr double kSmallest = 0.009, kLargest = 0.21;  // m, of test squares
        const double stated = drawing_.metres_per_unit.value_or(0);
        // Of "4 in / 10 cm" the one that the file's own unit makes true, or nearly.
        std::optional<double> said_length;
        const auto off = [&](double length) { return stated > 0 ? std::abs(std::log(length / side / stated)) : 0; };
        for (const double length : lengths_in(said)) {
            if (length < kSmallest || length > kLargest) continue;
            if (!said_length || off(length) < off(*said_length)) said_length = length;
        }
        if (!said_length) return;
        const bool is_true = stated > 0 && off(*said_length) < kTrue;
        // Natural logarithms: 72 for 96 pixels is 0.29, millimetres for inches 3.2. More is another thing's label.
        constexpr double kFarthest = 0.45, kFarthestNamed = 3.5;
        const double farthest = is_test_square_word(words_of(lower_case(said))) ? kFarthestNamed : kFarthest;
        if (!is_true && (!is_named || off(*said_length) > farthest)) return;
        if (!(stated > 0) || off(*said_length) > kExact) tell_scale(a, *said_length, side, stated);
        leave_out_whole(a);
        out_.notes.push_back(name_of(a) + ": a test square, left out");
    }

    void tell_scale(std::size_t a, double length, double side, double stated) {
        if (out_.metres_per_unit) return;
        out_.metres_per_unit = length / side;
        std::array<char, 160> text{};
        if (stated > 0) {
            std::snprintf(text.data(), text.size(),
                          "the test square of %.4g cm is drawn as %.4g cm: the scale is taken from it", 100 * length,
                          100 * stated * side);
        } else {
            std::snprintf(text.data(), text.size(),
                          "the file names no unit: taken from the test square of %.4g cm, which is %.6g units wide",
                          100 * length, side);
        }
        out_.notes.push_back(name_of(a) + ": " + text.data());
    }

    // ---- Page frames.

    bool is_on_page(const PlainArea& area) const {
        constexpr double kShare = 0.9;
        if (drawing_.page.isEmpty()) return false;
        const Vec2d size = area.box.sizes(), page = drawing_.page.sizes();
        return size.x() > kShare * page.x() && size.y() > kShare * page.y();
    }

    bool is_paper(const PlainArea& area) const {
        constexpr double kNear = 1.5e-3;  // m
        if (!drawing_.metres_per_unit) return false;
        const Vec2d size = *drawing_.metres_per_unit * area.box.sizes();
        return std::ranges::any_of(kPapers, [&](const Paper& paper) {
            return std::abs(size.minCoeff() - paper.width) < kNear && std::abs(size.maxCoeff() - paper.height) < kNear;
        });
    }

    // Whether other areas lie partly in it: a sheet of a tiled print.
    bool is_crossed(std::size_t a) const {
        for (std::size_t b = 0; b < areas_.size(); ++b) {
            if (b == a || !is_kept(b) || is_upright_rectangle(areas_[b], shape(areas_[b]))) continue;
            std::size_t inside = 0;
            for (const Vec2d& p : areas_[b].points) inside += areas_[a].box.contains(p) ? 1 : 0;
            if (inside > 0 && inside < areas_[b].points.size()) return true;
        }
        return false;
    }

    bool leave_out_one_frame() {
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (!is_kept(a) || areas_[a].parent || !fills_its_box(areas_[a])) continue;
            if (!(is_upright_rectangle(areas_[a], shape(areas_[a])) ? is_frame(a) || is_tile(a) : is_background(a)))
                continue;
            is_tile_[a] = is_upright_rectangle(areas_[a], shape(areas_[a]));
            leave_out_frame(a, "a page frame");
            return true;
        }
        return false;
    }

    // One of several rectangles of one size, which together hold all else: the sheets of a tiled print.
    bool is_tile(std::size_t a) const {
        constexpr int kLeast = 6;
        constexpr double kSame = 2e-3;
        int tiles = 0;
        bool has_other = false;
        Eigen::AlignedBox2d all, others;
        for (std::size_t b = 0; b < areas_.size(); ++b) {
            if (areas_[b].is_left_out && !is_tile_[b]) continue;
            const Vec2d off = areas_[b].box.sizes() - areas_[a].box.sizes();
            const bool is_one = is_upright_rectangle(areas_[b], shape(areas_[b])) &&
                                off.norm() < kSame * areas_[a].box.diagonal().norm();
            tiles += is_one ? 1 : 0;
            has_other = has_other || !is_one;
            (is_one ? all : others).extend(areas_[b].box);
        }
        return tiles >= kLeast && has_other && all.contains(others);
    }

    // Whether a shape that is no rectangle, as a frame with round corners, holds all else, and parts that fill much of
    // it.
    bool is_background(std::size_t a) const {
        constexpr double kFilled = 0.2;  // of its area
        if (shape(areas_[a]).path.kind == LineKind::Cut || shape(areas_[a]).path.kind == LineKind::Sew) return false;
        double filled = 0;
        int parts = 0;
        for (std::size_t b = 0; b < areas_.size(); ++b) {
            if (b == a || !is_kept(b)) continue;
            if (!areas_[b].parent) {
                if (areas_[b].area > 0.1 * areas_[a].area) return false;  // a part beside it
                continue;
            }
            if (areas_[b].parent != a) continue;
            if (shape(areas_[b]).path.kind == LineKind::Sew) return false;
            if (is_inset(areas_[b], areas_[a])) return has_parts_in(b);
            filled += areas_[b].area;
            parts += areas_[b].area > 0.03 * areas_[a].area ? 1 : 0;
        }
        return (parts > 1 || is_page_word(own_words(a))) && filled > kFilled * areas_[a].area;
    }

    // Whether a rectangle that lies in no other is a page frame.
    bool is_frame(std::size_t a) const {
        constexpr double kLeastPart = 0.03, kLargePart = 0.2;  // of the frame's area
        const LineKind kind = shape(areas_[a]).path.kind;
        if (kind == LineKind::Cut || kind == LineKind::Sew) return false;
        int inside = 0, parts = 0, curved = 0;
        bool has_large = false, has_inset = false;
        std::size_t outside = 0;
        for (std::size_t b = 0; b < areas_.size(); ++b) {
            if (b == a || !is_kept(b)) continue;
            if (areas_[b].parent != a) {
                outside += areas_[b].parent ? 0 : 1;
                continue;
            }
            ++inside;
            const bool is_inner_line = is_inset(areas_[b], areas_[a]);
            has_inset = has_inset || is_inner_line || shape(areas_[b]).path.kind == LineKind::Sew;
            const bool is_box = is_upright_rectangle(areas_[b], shape(areas_[b]));
            // A frame within the frame, with the parts in it.
            if (is_inner_line && is_box && has_parts_in(b)) return true;
            if (is_inner_line || areas_[b].area < kLeastPart * areas_[a].area) continue;
            ++parts;
            curved += is_box ? 0 : 1;
            has_large = has_large || (!is_box && areas_[b].area > kLargePart * areas_[a].area);
        }
        if (is_page_word(own_words(a)) && (inside > 0 || is_crossed(a))) return true;
        if (has_inset) return false;  // a part with its sewing line
        if (is_on_page(areas_[a]) && (inside > 0 || outside > 0)) return true;
        if (is_paper(areas_[a]) && (parts > 0 || is_crossed(a))) return true;
        return outside == 0 && curved > 0 && (parts > 1 || has_large);
    }

    bool has_parts_in(std::size_t a) const {
        for (std::size_t b = 0; b < areas_.size(); ++b) {
            if (is_kept(b) && areas_[b].parent == a && !is_inset(areas_[b], areas_[a]) &&
                !is_upright_rectangle(areas_[b], shape(areas_[b])) && areas_[b].area > 0.03 * areas_[a].area)
                return true;
        }
        return false;
    }

    // ---- Letters, logos, legends, bars.

    void leave_out_ornaments() {
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (!is_kept(a)) continue;
            const bool is_named = is_ornament_word(all_words(a));
            if (!is_named && !is_legend(a)) continue;
            leave_out_whole(a);
            out_.notes.push_back(name_of(a) + ": " +
                                 (is_named ? "a logo or a legend by its name" : "a legend by its text") + ", left out");
        }
    }

    // A small rectangle that says it is one.
    bool is_legend(std::size_t a) const {
        constexpr double kSmall = 0.2;  // of the largest area
        if (areas_[a].area > kSmall * largest_area() || !is_upright_rectangle(areas_[a], shape(areas_[a])))
            return false;
        return std::ranges::any_of(drawing_.texts, [&](const DrawnText& text) {
            return is_legend_word(words_of(lower_case(text.text))) && areas_[a].box.contains(text.at) &&
                   innermost_at(text.at) == a;
        });
    }

    std::optional<std::size_t> innermost_at(const Vec2d& p) const {
        std::optional<std::size_t> found;
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (!is_kept(a) || !areas_[a].box.contains(p) || !is_inside(p, areas_[a].points)) continue;
            if (!found || areas_[a].area < areas_[*found].area) found = a;
        }
        return found;
    }

    void leave_out_small_ones() {
        constexpr double kSmall = 0.03, kNarrow = 0.008;        // m: no panel is as small, or as narrow
        constexpr double kLittle = 0.01, kFilledLittle = 0.05;  // of the largest area
        constexpr double kTiny = 0.02;                          // of the largest length, where no unit is known
        const double largest = largest_area();
        double longest = 0;
        bool are_parts_lined = false;  // the largest shape has a line round it
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (!is_kept(a)) continue;
            longest = std::max(longest, areas_[a].box.sizes().maxCoeff());
            if (areas_[a].area == largest) are_parts_lined = !shape(areas_[a]).is_filled_only;
        }
        const double unit = drawing_.metres_per_unit.value_or(0);
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (!is_kept(a) || areas_[a].area == largest) continue;
            const Vec2d size = areas_[a].box.sizes();
            const bool is_small = unit > 0 ? unit * size.maxCoeff() < kSmall || unit * size.minCoeff() < kNarrow
                                           : size.maxCoeff() < kTiny * longest;
            const bool is_little = areas_[a].area < kLittle * largest;
            const bool is_letter =
                are_parts_lined && shape(areas_[a]).is_filled_only && areas_[a].area < kFilledLittle * largest;
            if (!is_letter && (areas_[a].parent || !is_small || !is_little)) continue;
            areas_[a].is_left_out = true;
            ++small_;
        }
    }

    // The hole of an "o" goes with it.
    void leave_out_what_lies_in_letters() {
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (is_kept(a) || !areas_[a].parent) continue;
            for (PlainArea& other : areas_) {
                if (other.parent == a) other.is_left_out = true;
            }
        }
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (is_kept(a) && areas_[a].parent && areas_[*areas_[a].parent].is_left_out) areas_[a].is_left_out = true;
        }
    }

    const PlainDrawing& drawing_;
    std::vector<PlainArea>& areas_;
    NotPanels out_;
    std::vector<bool> is_tile_;  // rectangles that were left out as frames
    int small_ = 0;
};

}  // namespace

NotPanels leave_out_what_is_no_panel(const PlainDrawing& drawing, std::vector<PlainArea>& areas) {
    return NotPanelFinder(drawing, areas).find();
}

std::vector<double> lengths_in(std::string_view text) {
    std::vector<double> lengths;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] < '0' || text[i] > '9') {
            ++i;
            continue;
        }
        std::size_t end = i;
        std::string digits;
        while (end < text.size() && ((text[end] >= '0' && text[end] <= '9') || text[end] == '.' || text[end] == ','))
            digits += text[end] == ',' ? '.' : text[end], ++end;
        double number = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), number);
        std::size_t unit = end;
        while (unit < text.size() && (text[unit] == ' ' || text[unit] == '-')) ++unit;
        const std::string rest = lower_case(text.substr(unit, 6));
        double metres = 0;
        if (rest.starts_with("mm")) metres = 0.001;
        if (rest.starts_with("cm") || rest.starts_with("zentim") || rest.starts_with("centim")) metres = 0.01;
        const bool is_inch = rest == "in" || rest.starts_with("inch") || rest.starts_with("in ") ||
                             rest.starts_with("in.") || rest.starts_with("in/") || rest.starts_with("in,") ||
                             rest.starts_with("in)");
        if (is_inch || rest.starts_with("\"") || rest.starts_with("''") || rest.starts_with("zoll") ||
            rest.starts_with("pouc") || rest.starts_with("\xE2\x80\xB3") || rest.starts_with("\xE2\x80\x9D"))
            metres = 0.0254;
        if (metres > 0 && number > 0) lengths.push_back(metres * number);
        i = end;
    }
    return lengths;
}

}  // namespace selvedge::sim
