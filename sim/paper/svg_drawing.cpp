#include "sim/paper/svg_drawing.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>

#include "sim/core/error.h"
#include "sim/core/lower_case.h"
#include "sim/paper/cut_text.h"
#include "sim/paper/field_record.h"
#include "sim/paper/freesewing_lines.h"
#include "sim/paper/path_builder.h"
#include "sim/paper/placement_record.h"
#include "sim/paper/record_words.h"
#include "sim/paper/svg_path.h"
#include "sim/paper/svg_shapes.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

constexpr double kGap = 0.2e-3;  // m: ends that are nearer than this are meant to be one

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

// ---- FreeSewing.

// "fs-stack-teagan.front-part-teagan.front" is the part teagan.front.
std::optional<std::string> freesewing_part(const std::vector<SvgGroup>& groups) {
    for (const SvgGroup& group : groups) {
        if (const std::size_t at = group.id.find("-part-"); at != std::string::npos) return group.id.substr(at + 6);
        if (group.id.starts_with("fs-part-")) return group.id.substr(8);
    }
    return std::nullopt;
}

class FreesewingReader {
 public:
    explicit FreesewingReader(const SvgDocument& document) : document_(document) {}

    Drawing read() {
        drawing_.format = "FreeSewing SVG";
        drawing_.is_y_down = true;
        drawing_.metres_per_unit = document_.metres_per_unit;
        for (const SvgText& text : document_.texts) text_along_[text.along] += text.text.text + " ";
        for (const SvgShape& shape : document_.shapes) add_shape(shape);
        for (const SvgUse& use : document_.uses) add_use(use);
        for (const SvgText& text : document_.texts) add_text(text);
        name_parts();
        return std::move(drawing_);
    }

 private:
    DrawnPart* part_of(const std::vector<SvgGroup>& groups) {
        const std::optional<std::string> name = freesewing_part(groups);
        if (!name) return nullptr;
        const auto found = std::ranges::find(drawing_.parts, *name, &DrawnPart::name);
        if (found != drawing_.parts.end()) return &*found;
        drawing_.parts.push_back({.name = *name});
        return &drawing_.parts.back();
    }

    void add_shape(const SvgShape& shape) {
        DrawnPart* part = part_of(shape.groups);
        if (!part) return;
        DrawnPath path = shape.path;
        const auto along = text_along_.find(path.name);
        const std::string text = shape.text_along + shape.markers + (along == text_along_.end() ? "" : along->second);
        path.kind = kind_of({.classes = shape.classes, .name = text, .is_closed = path.is_closed});
        if (path.kind == LineKind::Help && last_fold_text(shape)) path.kind = LineKind::FoldLine;
        part->paths.push_back(std::move(path));
    }

    // A banner's text lies on a hidden copy of the line that it is about.
    bool last_fold_text(const SvgShape& shape) const {
        if (contains(shape.classes, "hidden") || shape.path.is_closed) return false;
        return std::ranges::any_of(document_.shapes, [&](const SvgShape& other) {
            return contains(other.classes, "hidden") && contains(lower_case(other.text_along), "fold") &&
                   other.path.vertices == shape.path.vertices && other.groups == shape.groups;
        });
    }

    void add_use(const SvgUse& use) {
        DrawnPart* part = part_of(use.groups);
        DrawnMark mark;
        if (!part || !read_snippet(use.of, mark)) return;
        mark.at = use.at;
        part->marks.push_back(mark);
    }

    void add_text(const SvgText& text) {
        DrawnPart* part = part_of(text.groups);
        if (!part || !text.along.empty()) return;
        read_cut_text(text.text.text, part->cut);
        part->texts.push_back(text.text);
    }

    // All names of a design begin with it: "teagan.front".
    void name_parts() {
        for (DrawnPart& part : drawing_.parts) {
            const std::size_t dot = part.name.find('.');
            if (dot == std::string::npos) continue;
            if (drawing_.title.empty()) drawing_.title = part.name.substr(0, dot);
            part.name = part.name.substr(dot + 1);
        }
        std::erase_if(drawing_.parts, [](const DrawnPart& part) { return part.paths.empty(); });
    }

    const SvgDocument& document_;
    Drawing drawing_;
    std::map<std::string, std::string> text_along_;  // by the id of the path
};

// ---- Files of Selvedge.

class OwnReader {
 public:
    OwnReader(const SvgDocument& document, const std::string& file) : document_(document), file_(file) {}

    static bool is_own(const SvgDocument& document) {
        return std::ranges::any_of(document.shapes, [](const SvgShape& shape) { return panel_of(shape) != nullptr; });
    }

    Drawing read() {
        drawing_.format = "Selvedge SVG";
        drawing_.is_y_down = true;
        drawing_.metres_per_unit = document_.metres_per_unit;
        for (const SvgShape& shape : document_.shapes) add_shape(shape);
        for (const auto& seam : document_.seams) add_seam(seam);
        drawing_.body = read_body_phrase(document_.body);
        return std::move(drawing_);
    }

 private:
    static const SvgGroup* panel_of(const SvgShape& shape) {
        const auto found =
            std::ranges::find_if(shape.groups, [](const SvgGroup& group) { return group.data.contains("panel"); });
        return found == shape.groups.end() ? nullptr : &*found;
    }

    static std::string value(const std::map<std::string, std::string>& data, const char* key) {
        const auto found = data.find(key);
        return found == data.end() ? std::string() : found->second;
    }

    DrawnPart& part_of(const SvgGroup& group) {
        const std::string name = value(group.data, "panel");
        const auto found = std::ranges::find(drawing_.parts, name, &DrawnPart::name);
        if (found != drawing_.parts.end()) return *found;
        drawing_.parts.push_back({.name = name, .size = value(group.data, "size")});
        DrawnPart& part = drawing_.parts.back();
        const std::vector<double> pieces = parse_numbers(value(group.data, "pieces"));
        if (!pieces.empty()) part.cut.pieces = static_cast<int>(std::clamp(pieces[0], 1.0, double(kMostPieces)));
        if (const std::string fabric = value(group.data, "fabric"); is_shipped_fabric(fabric))
            part.cut.material = fabric;
        part.cut.are_mirrored = false;  // mirror images are panels of their own
        part.placement = placement_of(value(group.data, "placement"));
        return part;
    }

    // None: it is not stated, or not all of it is understood.
    static std::optional<DrawnPlacement> placement_of(std::string_view phrases) {
        if (phrases.empty()) return std::nullopt;
        DrawnPlacement placement;
        while (!phrases.empty()) {
            const std::string_view phrase = phrases.substr(0, phrases.find(';'));
            if (!read_placement_phrase(phrase, placement)) return std::nullopt;
            phrases.remove_prefix(std::min(phrases.size(), phrase.size() + 1));
        }
        return placement;
    }

    void add_shape(const SvgShape& shape) {
        const SvgGroup* group = panel_of(shape);
        if (!group) return;
        DrawnPart& part = part_of(*group);
        const std::string line = value(shape.data, "line"), mark = value(shape.data, "mark");
        const std::vector<double> at = parse_numbers(value(shape.data, "at"));
        if (!mark.empty() && at.size() == 2) return add_mark(shape, mark, {at[0], -at[1]}, part);
        static const std::map<std::string, LineKind, std::less<>> kinds{{"cut", LineKind::Cut},
                                                                        {"sew", LineKind::Sew},
                                                                        {"fold-edge", LineKind::FoldEdge},
                                                                        {"fold-line", LineKind::FoldLine},
                                                                        {"grain", LineKind::Grain},
                                                                        {"internal", LineKind::Internal},
                                                                        {"cutout", LineKind::Cutout}};
        const auto kind = kinds.find(line);
        if (kind == kinds.end()) return;
        DrawnPath path = shape.path;
        path.kind = kind->second;
        read_record_of_fields(value(shape.data, "properties"), path.line);
        read_edge_records(value(shape.data, "edges"), path);
        part.paths.push_back(std::move(path));
    }

    // "3 PHRASE; 4 PHRASE"
    static void read_edge_records(std::string_view records, DrawnPath& path) {
        while (!records.empty()) {
            const std::string_view record = records.substr(0, records.find(';'));
            RecordWords words(record);
            const auto edge = static_cast<std::size_t>(words.whole());
            if (words.is_good() && edge < path.edges.size()) read_record_phrase(words.rest(), path.edges[edge]);
            records.remove_prefix(std::min(records.size(), record.size() + 1));
        }
    }

    static void add_mark(const SvgShape& shape, const std::string& kind, const Vec2d& at, DrawnPart& part) {
        DrawnMark mark;
        mark.at = at;
        mark.kind = kind == "notch" ? MarkKind::Notch : MarkKind::Drill;
        const auto names = names_of(NotchKind{}).texts;
        const auto name = std::ranges::find(names, value(shape.data, "kind"));
        if (name != names.end()) mark.notch = static_cast<NotchKind>(name - names.begin());
        const std::vector<double> count = parse_numbers(value(shape.data, "count"));
        if (!count.empty()) mark.count = static_cast<int>(std::clamp(count[0], 1.0, double(kMostNotchesTogether)));
        const std::vector<double> edge = parse_numbers(value(shape.data, "edge"));
        if (!edge.empty() && edge[0] >= 0 && edge[0] < kMaxEdges) mark.edge = static_cast<int>(edge[0]);
        const std::vector<double> fraction = parse_numbers(value(shape.data, "fraction"));
        if (mark.edge && !fraction.empty()) move_with_outline(mark, std::clamp(fraction[0], 0.0, 1.0), part);
        if (mark.kind == MarkKind::Drill && shape.path.is_closed) mark.at = middle_of(shape.path);
        // A sign of several strokes is one mark.
        if (part.marks.empty() || part.marks.back() != mark) part.marks.push_back(mark);
    }

    // Of a circle.
    static Vec2d middle_of(const DrawnPath& path) {
        Vec2d sum = Vec2d::Zero();
        for (const Vec2d& v : path.vertices) sum += v;
        return sum / std::max<double>(1, static_cast<double>(path.vertices.size()));
    }

    // The place in the file is not that on the paper if another program moved the piece.
    static void move_with_outline(DrawnMark& mark, double fraction, const DrawnPart& part) {
        const auto outline = std::ranges::find_if(
            part.paths, [](const DrawnPath& path) { return path.kind == LineKind::Sew && path.is_closed; });
        if (outline == part.paths.end() || static_cast<std::size_t>(*mark.edge) >= outline->edges.size()) return;
        OutlineEdge edge = outline->edges[static_cast<std::size_t>(*mark.edge)];
        Panel ends;
        ends.vertices = {outline->vertices[static_cast<std::size_t>(edge.start)],
                         outline->vertices[static_cast<std::size_t>(edge.end)]};
        edge.start = 0;
        edge.end = 1;
        mark.at = outline_point(ends, edge, fraction);
    }

    // None: the part is not in the file (any more).
    std::optional<SeamSide> side_of(const std::string& text) const {
        const std::size_t colon = text.rfind(':');
        int edge = -1;
        if (colon != std::string::npos) std::from_chars(text.data() + colon + 1, text.data() + text.size(), edge);
        const auto part = std::ranges::find(drawing_.parts, text.substr(0, colon), &DrawnPart::name);
        if (edge < 0) throw InputError(file_, "selvedge:seam", "'" + text.substr(0, 80) + "' is no edge of a panel");
        if (part == drawing_.parts.end()) return std::nullopt;
        return SeamSide{static_cast<int>(part - drawing_.parts.begin()), edge};
    }

    void add_seam(const std::map<std::string, std::string>& attributes) {
        const std::string one = value(attributes, "first"), other = value(attributes, "second");
        const std::optional<SeamSide> first = side_of(one), second = side_of(other);
        if (!first || !second) {
            drawing_.notes.push_back("the seam of " + one.substr(0, 80) + " and " + other.substr(0, 80) +
                                     ": one of its panels is not there, left out");
            return;
        }
        Seam seam{.first = *first, .second = *second};
        seam.is_reversed = value(attributes, "reversed") != "false";
        seam.is_eased = value(attributes, "eased") == "true";
        seam.name = value(attributes, "name");
        seam.sewing = value(attributes, "sewing");
        read_record_of_fields(value(attributes, "properties"), seam);
        drawing_.seams.push_back(std::move(seam));
    }

    const SvgDocument& document_;
    const std::string& file_;
    Drawing drawing_;
};

// ---- Plain drawings.

// A closed path, seen as an area.
struct Area {
    std::size_t shape = 0;
    std::vector<Vec2d> points = {};
    Eigen::AlignedBox2d box = {};
    double area = 0;
    std::optional<std::size_t> parent = {};  // the smallest area around it
};

double area_of(const std::vector<Vec2d>& points) {
    double twice = 0;
    for (std::size_t i = 0; i < points.size(); ++i) twice += cross2(points[i], points[(i + 1) % points.size()]);
    return std::abs(twice) / 2;
}

// Whether points are off a line: of an outline that crosses itself, lobes that turn left and right may cancel out.
bool has_lobes(const std::vector<Vec2d>& points) {
    double area = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        area += std::abs(cross2(points[i] - points[0], points[i + 1] - points[0]));
    return area > 0;
}

bool is_generated(const std::string& id) {
    if (id.empty()) return true;
    for (const std::string_view prefix :
         {"path", "rect", "polygon", "polyline", "circle", "ellipse", "SVGID", "use", "g", "layer", "Layer_", "line"}) {
        if (!id.starts_with(prefix)) continue;
        const std::string rest = id.substr(prefix.size());
        if (std::ranges::all_of(
                rest, [](char c) { return std::isdigit(static_cast<unsigned char>(c)) || c == '-' || c == '_'; }))
            return true;
    }
    return false;
}

class PlainReader {
 public:
    PlainReader(const SvgDocument& document, const std::string& file) : document_(document), file_(file) {}

    Drawing read() {
        drawing_.format = "SVG";
        drawing_.is_y_down = true;
        drawing_.metres_per_unit = document_.metres_per_unit;
        drawing_.notes = document_.notes;
        shapes_ = document_.shapes;
        close_small_gaps();
        find_areas();
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (!areas_[a].parent) add_part(a);
        }
        if (drawing_.parts.empty()) refuse_open();
        add_open_shapes();
        add_texts();
        name_parts();
        return std::move(drawing_);
    }

 private:
    // Ends that nearly meet are one.
    void close_small_gaps() {
        const double gap = kGap / drawing_.metres_per_unit.value_or(0.001);
        for (SvgShape& shape : shapes_) {
            DrawnPath& path = shape.path;
            if (path.is_closed || path.edges.size() < 2) continue;
            const double open = (path.vertices.back() - path.vertices.front()).norm();
            if (open > gap || open == 0) continue;
            path.vertices.pop_back();
            path.edges.back().end = 0;
            path.is_closed = true;
            drawing_.notes.push_back(path.place + ": open by a fifth of a millimetre or less, closed");
        }
    }

    // Where no path is closed: names the largest of those that were meant to be.
    void refuse_open() const {
        const DrawnPath* largest = nullptr;
        double most = 0;
        for (const SvgShape& shape : shapes_) {
            Eigen::AlignedBox2d box;
            for (const Vec2d& v : shape.path.vertices) box.extend(v);
            if (shape.path.is_closed || shape.path.vertices.size() < 3 || !(box.sizes().sum() > most)) continue;
            largest = &shape.path;
            most = box.sizes().sum();
        }
        if (!largest) return;
        throw InputError(file_, largest->place,
                         open_by(gap_of(*largest), drawing_.metres_per_unit) +
                             ", and no other path is closed: nothing that could be a panel");
    }

    void find_areas() {
        for (std::size_t i = 0; i < shapes_.size(); ++i) {
            const DrawnPath& path = shapes_[i].path;
            if (!path.is_closed || path.edges.size() < 2) continue;
            Area area{.shape = i};
            const Panel panel = as_panel(path);
            for (const Vec2d& v : path.vertices) area.box.extend(v);
            const double error = std::max(1e-9, 1e-3 * area.box.sizes().maxCoeff());
            for (const OutlineEdge& edge : panel.edges) {
                const std::vector<Vec2d> line = outline_polyline(panel, edge, error);
                area.points.insert(area.points.end(), line.begin(), line.end() - 1);
            }
            for (const Vec2d& p : area.points) area.box.extend(p);
            area.area = area_of(area.points);
            if (area.area > 0 || has_lobes(area.points)) areas_.push_back(std::move(area));
            if (areas_.size() > kMostAreas) throw InputError(file_, "", "more than 3,000 closed paths");
        }
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            for (std::size_t b = 0; b < areas_.size(); ++b) {
                const bool is_around = a != b && areas_[b].area > areas_[a].area &&
                                       areas_[b].box.contains(areas_[a].box) &&
                                       is_inside(areas_[a].points[0], areas_[b].points) &&
                                       is_inside(areas_[a].points[areas_[a].points.size() / 2], areas_[b].points);
                if (is_around && (!areas_[a].parent || areas_[b].area < areas_[*areas_[a].parent].area))
                    areas_[a].parent = b;
            }
        }
    }

    // The words that the file has for a shape: its own, and those of its groups.
    static std::string words_of(const SvgShape& shape) {
        std::string words = lower_case(shape.path.name) + " " + lower_case(shape.classes);
        for (const SvgGroup& group : shape.groups) words += " " + lower_case(group.id) + " " + lower_case(group.label);
        return words;
    }

    static LineKind kind_of_words(const SvgShape& shape) {
        const std::string words = words_of(shape);
        if (contains(words, "grain") || contains(words, "fadenlauf")) return LineKind::Grain;
        if (contains(words, "fold") && !shape.path.is_closed) return LineKind::FoldEdge;
        if (contains(words, "sew") || contains(words, "stitch") || contains(words, "seamline") ||
            contains(words, "seam line") || contains(words, "seam_line")) {
            return LineKind::Sew;
        }
        if (contains(words, "cut")) return LineKind::Cut;
        if (contains(words, "help") || contains(words, "guide")) return LineKind::Help;
        return LineKind::Unknown;
    }

    // Whether one closed path runs inside another at a nearly constant distance: the sewing line in the cut line.
    bool is_inset(const Area& inner, const Area& outer) const {
        constexpr double kSpread = 0.35;
        double sum = 0;
        std::vector<double> distances;
        for (const Vec2d& p : inner.points) {
            distances.push_back(distance_to_outline(p, outer.points));
            sum += distances.back();
        }
        const double mean = sum / static_cast<double>(distances.size());
        std::ranges::sort(distances);
        const double low = distances[distances.size() / 10], high = distances[distances.size() * 9 / 10];
        const double size = std::sqrt(outer.area);
        return mean > 0 && high - low < kSpread * mean && mean < 0.15 * size && inner.area > 0.5 * outer.area;
    }

    void add_part(std::size_t a) {
        const SvgShape& shape = shapes_[areas_[a].shape];
        DrawnPart part;
        part.paths.push_back(shape.path);
        part.paths.back().kind = kind_of_words(shape);
        if (part.paths.back().kind == LineKind::Help) return;
        bool has_sewing_line = false;
        for (std::size_t b = 0; b < areas_.size(); ++b) {
            if (areas_[b].parent != a) continue;
            DrawnPath path = shapes_[areas_[b].shape].path;
            path.kind = kind_of_words(shapes_[areas_[b].shape]);
            if (!has_sewing_line && (path.kind == LineKind::Sew || is_inset(areas_[b], areas_[a]))) {
                path.kind = LineKind::Sew;
                has_sewing_line = true;
            } else if (path.kind != LineKind::Help) {
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

    // The part whose area holds a point, or is nearest to it within a reach; none outside of all.
    DrawnPart* part_at(const Vec2d& p) {
        for (std::size_t i = 0; i < drawing_.parts.size(); ++i) {
            const Area& area = areas_[part_of_area_[i]];
            if (area.box.contains(p) && is_inside(p, area.points)) return &drawing_.parts[i];
        }
        return nullptr;
    }

    static double length_of(const DrawnPath& path) {
        double length = 0;
        for (std::size_t i = 1; i < path.vertices.size(); ++i)
            length += (path.vertices[i] - path.vertices[i - 1]).norm();
        return length;
    }

    void add_open_shapes() {
        const double unit = drawing_.metres_per_unit.value_or(0.001);
        for (const SvgShape& shape : shapes_) {
            if (shape.path.is_closed || shape.path.vertices.size() < 2) continue;
            const Vec2d from = shape.path.vertices.front(), to = shape.path.vertices.back();
            DrawnPart* part = part_at((from + to) / 2);
            if (!part) part = part_at(from);
            if (!part) part = part_at(to);
            if (!part && nearly_closes(shape.path)) {
                drawing_.notes.push_back(shape.path.place + ": " +
                                         open_by(gap_of(shape.path), drawing_.metres_per_unit) + ", left out");
            }
            if (!part) continue;
            const std::string words = words_of(shape);
            const double length = unit * length_of(shape.path);
            constexpr double kShortest = 0.001, kLongest = 0.016;  // m, of a notch
            const bool is_short = length > kShortest && length < kLongest && shape.path.edges.size() <= 2;
            DrawnPath path = shape.path;
            path.kind = kind_of_words(shape);
            if (contains(words, "notch") || (is_short && path.kind == LineKind::Unknown)) {
                part->marks.push_back({.at = (from + to) / 2});
                continue;
            }
            if (path.kind != LineKind::Grain && path.kind != LineKind::FoldEdge && path.kind != LineKind::Help)
                path.kind = LineKind::Internal;
            part->paths.push_back(std::move(path));
        }
    }

    void add_texts() {
        for (const SvgText& text : document_.texts) {
            DrawnPart* part = part_at(text.text.at);
            if (!part) continue;
            read_cut_text(text.text.text, part->cut);
            part->texts.push_back(text.text);
        }
    }

    // By the path's own name, that of the nearest group of its own, its first text, or its number.
    void name_parts() {
        for (std::size_t i = 0; i < drawing_.parts.size(); ++i) {
            DrawnPart& part = drawing_.parts[i];
            const SvgShape& shape = shapes_[areas_[part_of_area_[i]].shape];
            std::vector<std::string> names{shape.path.name};
            for (auto group = shape.groups.rbegin(); group != shape.groups.rend(); ++group) {
                if (is_shared(*group)) continue;
                names.push_back(group->label);
                names.push_back(group->id);
            }
            for (const DrawnText& text : part.texts) names.push_back(text.text);
            const auto name = std::ranges::find_if(names, [](const std::string& one) { return !is_generated(one); });
            part.name = name == names.end() ? "panel_" + std::to_string(i + 1)
                                            : name->substr(0, name->find('\n')).substr(0, 60);
        }
    }

    // Whether a group holds several parts, so that its name is not that of one.
    bool is_shared(const SvgGroup& group) const {
        int parts = 0;
        for (const std::size_t area : part_of_area_) {
            const auto& groups = shapes_[areas_[area].shape].groups;
            parts +=
                std::ranges::any_of(groups, [&](const SvgGroup& one) { return one.number == group.number; }) ? 1 : 0;
        }
        return parts > 1;
    }

    static constexpr std::size_t kMostAreas = 3000;

    const SvgDocument& document_;
    const std::string& file_;
    std::vector<SvgShape> shapes_;
    std::vector<Area> areas_;
    std::vector<std::size_t> part_of_area_;  // per part: its outermost area
    Drawing drawing_;
};

}  // namespace

bool looks_like_svg(std::string_view text) {
    const std::string_view start = text.substr(0, 4096);
    return start.find("<svg") != std::string_view::npos || start.find(":svg") != std::string_view::npos;
}

Drawing read_svg(std::string_view text, const std::string& file) {
    const SvgDocument document = read_svg_document(text, file);
    Drawing drawing;
    if (document.is_freesewing) drawing = FreesewingReader(document).read();
    if (drawing.parts.empty() && OwnReader::is_own(document)) drawing = OwnReader(document, file).read();
    if (drawing.parts.empty()) drawing = PlainReader(document, file).read();
    if (drawing.parts.empty()) throw InputError(file, "", "no closed path: nothing that could be a panel");
    return drawing;
}

}  // namespace selvedge::sim
