#include "sim/paper/svg_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <pugixml.hpp>

#include "sim/core/error.h"
#include "sim/core/printable.h"
#include "sim/paper/path_builder.h"
#include "sim/paper/svg_path.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kLargestFile = 64U << 20U;  // bytes
constexpr int kMostElements = 200000;
constexpr std::size_t kMostEdges = 2000000;
constexpr std::size_t kMostPathText = 4 * kLargestFile;  // characters that are read as paths, over all uses
constexpr std::size_t kMostGroupsHeld = 4000000;         // of all shapes, uses and texts
constexpr int kDeepestElement = 256;
constexpr double kLargestUnits = 1e9;  // user units

std::string_view attribute(const pugi::xml_node& node, const char* name) {
    return node.attribute(name).value();
}

// xlink:href or href, without the number sign; empty for other documents.
std::string_view reference(const pugi::xml_node& node) {
    for (const pugi::xml_attribute& one : node.attributes()) {
        const std::string_view value(one.value());
        if (local_name(one.name()) == "href") return value.starts_with('#') ? value.substr(1) : std::string_view();
    }
    return {};
}

std::map<std::string, std::string> own_data(const pugi::xml_node& node) {
    constexpr std::string_view prefix = "data-selvedge-";
    std::map<std::string, std::string> data;
    for (const pugi::xml_attribute& one : node.attributes()) {
        const std::string_view name(one.name());
        if (name.starts_with(prefix)) data[std::string(name.substr(prefix.size()))] = one.value();
    }
    return data;
}

// Illustrator writes characters that an id cannot have as _xHHHH_.
std::string decoded_id(std::string_view id) {
    std::string text;
    for (std::size_t i = 0; i < id.size(); ++i) {
        const std::size_t end = id.find('_', i + 2);
        if (id.substr(i).starts_with("_x") && end != std::string_view::npos && end - i >= 4 && end - i <= 6) {
            const std::string hex(id.substr(i + 2, end - i - 2));
            char* stop = nullptr;
            const long code = std::strtol(hex.c_str(), &stop, 16);
            if (*stop == '\0' && code >= 0x20 && code < 0x7F) {
                text += static_cast<char>(code);
                i = end;
                continue;
            }
        }
        text += id[i];
    }
    return text;
}

bool is_shape(std::string_view name) {
    constexpr std::array<std::string_view, 7> shapes{"path", "rect",     "circle", "ellipse",
                                                     "line", "polyline", "polygon"};
    return std::ranges::find(shapes, name) != shapes.end();
}

class Walker {
 public:
    Walker(const pugi::xml_document& document, std::string_view text, const std::string& file)
        : document_(document), text_(text), styles_(file), file_(file) {
        for (const pugi::xml_node& node : document.children()) collect_ids(node, 0);
    }

    SvgDocument walk(const pugi::xml_node& root) {
        const std::string_view classes = attribute(root, "class");
        out_.is_freesewing = classes.find("freesewing") != std::string_view::npos || root.attribute("freesewing") ||
                             root.attribute("xmlns:freesewing");
        out_.unit = svg_unit(document_, root, out_.is_freesewing);
        if (!out_.unit.note.empty()) out_.notes.push_back(out_.unit.note);
        Place place;
        place.viewport = out_.unit.viewport;
        place.look = styles_.look_of(root, place.look);
        place.map = transform_of(root, place.look);
        walk_children(root, place);
        if (styles_.left_out() > 0)
            out_.notes.push_back(count_text(static_cast<std::size_t>(styles_.left_out()), "selector") +
                                 " of its style sheets not understood: what they hide may be read");
        out_.hidden = hidden_;
        if (hidden_ > 0) out_.notes.push_back(count_text(hidden_, "hidden element") + " left out");
        return std::move(out_);
    }

 private:
    struct Place {
        Eigen::Affine2d map = Eigen::Affine2d::Identity();
        std::vector<SvgGroup> groups = {};
        int depth = 0;
        int uses = 0;  // that lead here
        Vec2d viewport = Vec2d::Zero();
        SvgLook look = {};
        std::string use_name = {};  // of the use of a shape
    };

    [[noreturn]] void fail(const pugi::xml_node& node, const std::string& problem) const {
        const std::string_view id = attribute(node, "id");
        std::string place = "<" + std::string(local_name(node.name())) + ">";
        if (!id.empty()) place += " '" + std::string(id.substr(0, 60)) + "'";
        throw InputError(file_, place, problem);
    }

    // In the file, from 1.
    std::size_t line_number(const pugi::xml_node& node) {
        if (line_ends_.empty()) {
            for (std::size_t i = 0; i < text_.size(); ++i) {
                if (text_[i] == '\n') line_ends_.push_back(i);
            }
            line_ends_.push_back(text_.size());
        }
        const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, node.offset_debug()));
        return static_cast<std::size_t>(std::ranges::lower_bound(line_ends_, at) - line_ends_.begin()) + 1;
    }

    void collect_ids(const pugi::xml_node& node, int depth) {
        if (depth > kDeepestElement) throw InputError(file_, "", "elements lie more than 256 deep in each other");
        if (++elements_ > kMostElements) throw InputError(file_, "", "more than 200,000 elements");
        const std::string_view id = attribute(node, "id");
        if (!id.empty()) by_id_.emplace(id, node);
        if (local_name(node.name()) == "style") add_sheet(node);
        for (const pugi::xml_node& child : node.children()) {
            if (child.type() == pugi::node_element) collect_ids(child, depth + 1);
        }
    }

    void add_sheet(const pugi::xml_node& style) {
        std::string css;
        for (const pugi::xml_node& text : style.children()) css += text.value();
        styles_.add_sheet(css);
    }

    // ---- Elements.

    void walk_children(const pugi::xml_node& node, const Place& place) {
        for (const pugi::xml_node& child : node.children()) {
            if (child.type() == pugi::node_element) walk(child, place);
        }
    }

    void walk(const pugi::xml_node& node, const Place& above) {
        const std::string_view name = local_name(node.name());
        constexpr std::array<std::string_view, 8> skipped{"defs",    "symbol", "clipPath", "mask",
                                                          "pattern", "marker", "style",    "script"};
        if (std::ranges::find(skipped, name) != skipped.end()) return;
        if (name == "metadata") return read_seams(node);
        if (++visited_ > kMostElements) fail(node, "the file uses its own elements more than 200,000 times");
        if (above.depth > kDeepestElement) fail(node, "elements use each other without end");
        Place place = above;
        ++place.depth;
        place.look = styles_.look_of(node, above.look);
        if (!place.look.is_drawn) {
            ++hidden_;
            return;
        }
        place.map = above.map * transform_of(node, place.look);
        if (name == "g" || name == "svg" || name == "a" || name == "switch") return walk_group(node, place);
        if (name == "use") return walk_use(node, place);
        if (name == "text") return read_text(node, place);
        read_shape(node, name, place);
    }

    // That of the style goes before the attribute.
    Eigen::Affine2d transform_of(const pugi::xml_node& node, const SvgLook& look) const {
        const std::string_view attributes = attribute(node, "transform");
        if (attributes.empty() && look.transform.empty()) return Eigen::Affine2d::Identity();
        const auto map = look.transform.empty() ? parse_transform(attributes) : parse_css_transform(look.transform);
        if (!map || !map->matrix().allFinite()) fail(node, "the transform is wrong");
        return *map;
    }

    // As its program shows it; empty: it has only an id.
    static std::string label_of(const pugi::xml_node& node) {
        for (const std::string_view label : {attribute(node, "inkscape:label"), attribute(node, "data-name"),
                                             std::string_view(node.child("title").text().get())}) {
            if (!label.empty()) return std::string(label);
        }
        return {};
    }

    static std::string name_of(const pugi::xml_node& node) {
        std::string label = label_of(node);
        return label.empty() ? decoded_id(attribute(node, "id")) : label;
    }

    SvgGroup group_of(const pugi::xml_node& node) {
        SvgGroup group{.number = ++groups_};
        group.id = decoded_id(attribute(node, "id"));
        group.label = label_of(node);
        group.is_layer = attribute(node, "inkscape:groupmode") == "layer";
        group.data = own_data(node);
        return group;
    }

    void walk_group(const pugi::xml_node& node, Place place) {
        if (local_name(node.name()) == "svg") {
            const auto is_nothing = [&](const char* name) {
                return node.attribute(name) && !(length(node, name, place.viewport.x()) > 0);
            };
            if (is_nothing("width") || is_nothing("height")) {
                ++hidden_;
                return;
            }
            enter_viewport(node, {}, place);
        }
        place.groups.push_back(group_of(node));
        walk_children(node, place);
    }

    // Of an inner <svg>, or of a <symbol> as `use` sizes it: what is in it has coordinates of its own.
    void enter_viewport(const pugi::xml_node& node, const pugi::xml_node& use, Place& place) const {
        const pugi::xml_node& sized = use && (use.attribute("width") || use.attribute("height")) ? use : node;
        const std::vector<double> box = parse_numbers(attribute(node, "viewBox"));
        const Vec2d size(sized.attribute("width") ? length(sized, "width", place.viewport.x()) : place.viewport.x(),
                         sized.attribute("height") ? length(sized, "height", place.viewport.y()) : place.viewport.y());
        const Vec2d at =
            use ? Vec2d(0, 0) : Vec2d(length(node, "x", place.viewport.x()), length(node, "y", place.viewport.y()));
        place.map = place.map * viewport_map(box, {at, at + size}, attribute(node, "preserveAspectRatio"));
        place.viewport = box.size() == 4 ? Vec2d(box[2], box[3]) : size;
    }

    double length(const pugi::xml_node& node, const char* name, double reference) const {
        return svg_length(attribute(node, name), reference, out_.unit.pixels_per_inch);
    }

    void walk_use(const pugi::xml_node& node, Place place) {
        const std::string id(reference(node));
        const Vec2d shift(length(node, "x", place.viewport.x()), length(node, "y", place.viewport.y()));
        const Vec2d at = place.map * shift;
        count_groups(node, place);
        out_.uses.push_back({id, {at.x(), -at.y()}, place.groups});
        // FreeSewing's marks are drawings of their own: their place is all that counts.
        const auto target = by_id_.find(id);
        if (out_.is_freesewing || target == by_id_.end()) return;
        constexpr int kMostUses = 32;
        if (++place.uses > kMostUses) fail(node, "elements use each other without end");
        place.map.translate(shift);
        const std::string_view used = local_name(target->second.name());
        if (is_shape(used)) place.use_name = name_of(node);
        place.groups.push_back(group_of(node));
        if (used == "symbol") {
            enter_viewport(target->second, node, place);
            place.look = styles_.look_of(target->second, place.look);
            place.groups.push_back(group_of(target->second));
            return walk_children(target->second, place);
        }
        walk(target->second, place);
    }

    // Two lengths, along x and along y.
    Vec2d pair(const pugi::xml_node& node, const char* x, const char* y, const Place& place) const {
        return {length(node, x, place.viewport.x()), length(node, y, place.viewport.y())};
    }

    void draw_rectangle(const pugi::xml_node& node, const Place& place, bool keeps_circles, PathBuilder& pen) const {
        const Vec2d low = pair(node, "x", "y", place), size = pair(node, "width", "height", place);
        if (!(size.minCoeff() > 0)) return;
        auto [rx, ry] = std::pair(length(node, "rx", place.viewport.x()), length(node, "ry", place.viewport.y()));
        if (!node.attribute("ry")) ry = rx;
        if (!node.attribute("rx")) rx = ry;
        const Vec2d r = Vec2d(rx, ry).cwiseMax(0.0).cwiseMin(size / 2), high = low + size;
        if (!(r.minCoeff() > 0)) {
            pen.move(low);
            pen.line({high.x(), low.y()});
            pen.line(high);
            pen.line({low.x(), high.y()});
            return pen.close();
        }
        const auto text = [](double v) { return std::to_string(v); };
        const auto arc = [&](double x, double y) {
            return "A" + text(r.x()) + "," + text(r.y()) + " 0 0 1 " + text(x) + "," + text(y);
        };
        std::string data = "M" + text(low.x() + r.x()) + "," + text(low.y()) + "H" + text(high.x() - r.x());
        data += arc(high.x(), low.y() + r.y()) + "V" + text(high.y() - r.y()) + arc(high.x() - r.x(), high.y());
        data += "H" + text(low.x() + r.x()) + arc(low.x(), high.y() - r.y()) + "V" + text(low.y() + r.y());
        data += arc(low.x() + r.x(), low.y()) + "Z";
        draw_path_data(data, keeps_circles, pen);
    }

    void draw_points(const pugi::xml_node& node, bool is_closed, PathBuilder& pen) const {
        const std::vector<double> v = parse_numbers(attribute(node, "points"));
        for (std::size_t i = 0; i + 1 < v.size(); i += 2) {
            if (i == 0) pen.move({v[i], v[i + 1]});
            if (i > 0) pen.line({v[i], v[i + 1]});
        }
        if (is_closed) pen.close();
    }

    void draw(const pugi::xml_node& node, std::string_view name, const Place& place, bool keeps_circles,
              PathBuilder& pen) {
        path_text_ += attribute(node, "d").size() + attribute(node, "points").size();
        if (path_text_ > kMostPathText) fail(node, "the file uses its own paths too often");
        if (name == "path") {
            const std::string problem = draw_path_data(attribute(node, "d"), keeps_circles, pen);
            if (!problem.empty()) fail(node, problem);
        } else if (name == "rect") {
            draw_rectangle(node, place, keeps_circles, pen);
        } else if (name == "circle") {
            // A percentage is one of the viewport's diagonal over the root of 2.
            const double radius = length(node, "r", place.viewport.norm() / std::numbers::sqrt2);
            draw_ellipse(pair(node, "cx", "cy", place), Vec2d::Constant(radius), keeps_circles, pen);
        } else if (name == "ellipse") {
            draw_ellipse(pair(node, "cx", "cy", place), pair(node, "rx", "ry", place), keeps_circles, pen);
        } else if (name == "line") {
            pen.move(pair(node, "x1", "y1", place));
            pen.line(pair(node, "x2", "y2", place));
        } else {
            draw_points(node, name == "polygon", pen);
        }
    }

    // Every shape, use and text keeps the groups around it.
    void count_groups(const pugi::xml_node& node, const Place& place) {
        groups_held_ += place.groups.size();
        if (groups_held_ > kMostGroupsHeld) fail(node, "too many shapes lie too deep in groups");
    }

    // FreeSewing's classes and the lines of Selvedge say what they are, seen or not.
    bool is_seen(const pugi::xml_node& node, const SvgLook& look) const {
        if (out_.is_freesewing || !own_data(node).empty()) return look.is_visible;
        return look.is_visible && look.is_painted();
    }

    void read_shape(const pugi::xml_node& node, std::string_view name, const Place& place) {
        if (!is_shape(name)) return;
        if (!is_seen(node, place.look)) {
            ++hidden_;
            return;
        }
        const Eigen::Matrix2d linear = place.map.linear();
        const double a = linear.col(0).squaredNorm(), b = linear.col(1).squaredNorm();
        const bool keeps_circles =
            std::abs(a - b) < 1e-9 * (a + b) && std::abs(linear.col(0).dot(linear.col(1))) < 1e-9 * (a + b);
        PathBuilder pen;
        draw(node, name, place, keeps_circles, pen);
        for (DrawnPath& path : pen.take(0, 0)) {
            count_groups(node, place);
            transform(path, place.map);
            flip(path);
            edges_ += path.edges.size();
            if (edges_ > kMostEdges) fail(node, "more than 2,000,000 edges");
            for (const Vec2d& v : path.vertices) {
                if (!(v.cwiseAbs().maxCoeff() < kLargestUnits))
                    fail(node, "a coordinate is not a number, or too large");
            }
            for (const OutlineEdge& edge : path.edges) {
                if (!(edge.control[0].cwiseAbs().maxCoeff() < kLargestUnits &&
                      edge.control[1].cwiseAbs().maxCoeff() < kLargestUnits))
                    fail(node, "a coordinate is not a number, or too large");
            }
            path.name = place.use_name.empty() ? name_of(node) : place.use_name;
            path.place = "<" + std::string(name) + "> " +
                         (path.name.empty() ? "in line " + std::to_string(line_number(node)) : "'" + path.name + "'");
            SvgShape shape{.path = std::move(path), .groups = place.groups};
            shape.classes = attribute(node, "class");
            shape.text_along = attribute(node, "data-text");
            shape.markers = std::string(attribute(node, "marker-start")) + std::string(attribute(node, "marker-end"));
            shape.data = own_data(node);
            shape.look = place.look;
            out_.shapes.push_back(std::move(shape));
        }
    }

    static void append_text(const pugi::xml_node& node, std::string& text, int depth) {
        if (depth > kDeepestElement) return;
        if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata) text += node.value();
        for (const pugi::xml_node& child : node.children()) {
            const bool is_moved = child.attribute("x") || child.attribute("y") || child.attribute("dy");
            if (is_moved && !text.empty() && text.back() != ' ') text += ' ';
            append_text(child, text, depth + 1);
        }
    }

    void read_text(const pugi::xml_node& node, const Place& place) {
        if (!place.look.is_visible) return;
        count_groups(node, place);
        SvgText text;
        text.groups = place.groups;
        append_text(node, text.text.text, 0);
        while (!text.text.text.empty() && std::strchr(" \t\r\n", text.text.text.back())) text.text.text.pop_back();
        pugi::xml_node at = node;
        for (const pugi::xml_node& child : node.children()) {
            if (local_name(child.name()) == "textPath") text.along = reference(child);
            if (!node.attribute("x") && child.attribute("x")) at = child;
        }
        const Vec2d p = place.map * pair(at, "x", "y", place);
        text.text.at = {p.x(), -p.y()};
        if (!text.text.text.empty()) out_.texts.push_back(std::move(text));
    }

    void read_seams(const pugi::xml_node& metadata) {
        for (const pugi::xml_node& list : metadata.children()) {
            if (std::strcmp(list.name(), "selvedge:seams") != 0) continue;
            out_.body = attribute(list, "body");
            for (const pugi::xml_node& seam : list.children()) {
                std::map<std::string, std::string> attributes;
                for (const pugi::xml_attribute& one : seam.attributes()) attributes[one.name()] = one.value();
                if (local_name(seam.name()) == "seam") out_.seams.push_back(std::move(attributes));
            }
        }
    }

    const pugi::xml_document& document_;
    std::string_view text_;
    SvgStyles styles_;
    std::size_t hidden_ = 0;
    std::vector<std::size_t> line_ends_;  // offsets; empty: not asked for yet
    const std::string& file_;
    std::map<std::string, pugi::xml_node, std::less<>> by_id_;
    int elements_ = 0;
    int visited_ = 0;
    int groups_ = 0;
    std::size_t edges_ = 0;
    std::size_t path_text_ = 0;
    std::size_t groups_held_ = 0;
    SvgDocument out_;
};

// "line 12" of the byte at which the parser stopped.
std::string place_of_line(std::string_view text, std::ptrdiff_t offset) {
    const std::string_view before =
        text.substr(0, std::min(text.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, offset))));
    return "line " + std::to_string(1 + std::ranges::count(before, '\n'));
}

}  // namespace

SvgDocument read_svg_document(std::string_view text, const std::string& file) {
    if (text.size() > kLargestFile) throw InputError(file, "", "larger than 64 MB");
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_buffer(
        text.data(), text.size(), pugi::parse_default | pugi::parse_ws_pcdata_single | pugi::parse_comments,
        pugi::encoding_auto);
    if (!result)
        throw InputError(file, place_of_line(text, result.offset), std::string("not XML: ") + result.description());
    for (const pugi::xml_node& node : document.children()) {
        if (node.type() == pugi::node_element && local_name(node.name()) == "svg")
            return Walker(document, text, file).walk(node);
    }
    throw InputError(file, "", "no <svg> element");
}

}  // namespace selvedge::sim
