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
#include "sim/paper/plain_parts.h"
#include "sim/paper/record_words.h"
#include "sim/paper/svg_path.h"
#include "sim/paper/svg_shapes.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

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
        drawing_.metres_per_unit = document_.unit.metres_per_unit;
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
        drawing_.metres_per_unit = document_.unit.metres_per_unit;
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

PlainGroup plain_group(const SvgGroup& group) {
    return {.number = group.number, .id = group.id, .label = group.label, .is_layer = group.is_layer};
}

Drawing read_plain(const SvgDocument& document, const std::string& file) {
    Drawing drawing;
    drawing.format = "SVG";
    drawing.is_y_down = true;
    drawing.metres_per_unit = document.unit.metres_per_unit;
    drawing.likely_units = document.unit.likely;
    drawing.notes = document.notes;
    PlainDrawing plain{.metres_per_unit = document.unit.metres_per_unit};
    for (const SvgShape& shape : document.shapes) {
        PlainShape& one = plain.shapes.emplace_back(PlainShape{.path = shape.path, .classes = shape.classes});
        std::ranges::transform(shape.groups, std::back_inserter(one.groups), plain_group);
        one.style = shape.look.stroke + "|" + shape.look.dashes;
        one.is_filled_only = !shape.look.has_stroke() && shape.look.has_fill();
    }
    for (const SvgText& text : document.texts) plain.texts.push_back(text.text);
    if (!document.unit.page.isEmpty()) {
        const Eigen::AlignedBox2d& page = document.unit.page;
        plain.page =
            Eigen::AlignedBox2d(Vec2d(page.min().x(), -page.max().y()), Vec2d(page.max().x(), -page.min().y()));
    }
    add_plain_parts(std::move(plain), file, drawing);
    return drawing;
}

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
    if (drawing.parts.empty()) drawing = read_plain(document, file);
    if (drawing.parts.empty()) {
        throw InputError(
            file, "",
            "no closed path: nothing that could be a panel" +
                (document.hidden > 0 ? "; " + std::to_string(document.hidden) + " elements are hidden" : ""));
    }
    return drawing;
}

}  // namespace selvedge::sim
