#include "sim/paper/svg_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <pugixml.hpp>

#include "sim/core/error.h"
#include "sim/paper/path_builder.h"
#include "sim/paper/svg_path.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kLargestFile = 64U << 20U;  // bytes
constexpr int kMostElements = 200000;
constexpr std::size_t kMostEdges = 2000000;
constexpr int kDeepestElement = 256;
constexpr double kLargestUnits = 1e9;  // user units
constexpr double kMetresPerInch = 0.0254;

// The name without its namespace prefix.
std::string_view local_name(const char* name) {
    const std::string_view full(name);
    const std::size_t colon = full.find(':');
    return colon == std::string_view::npos ? full : full.substr(colon + 1);
}

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

bool is_hidden(const pugi::xml_node& node) {
    const std::string_view style = attribute(node, "style"), display = attribute(node, "display");
    const auto says = [&](std::string_view what) { return style.find(what) != std::string_view::npos; };
    return display == "none" || attribute(node, "visibility") == "hidden" || says("display:none") ||
           says("display: none") || says("visibility:hidden");
}

double metres_of(std::string_view unit) {
    if (unit == "mm") return 0.001;
    if (unit == "cm") return 0.01;
    if (unit == "in") return kMetresPerInch;
    if (unit == "pt") return kMetresPerInch / 72;
    if (unit == "pc") return kMetresPerInch / 6;
    if (unit == "Q") return 0.00025;
    return 0;
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

class Walker {
 public:
    Walker(const pugi::xml_document& document, std::string_view text, const std::string& file)
        : text_(text), file_(file) {
        for (const pugi::xml_node& node : document.children()) collect_ids(node, 0);
    }

    SvgDocument walk(const pugi::xml_node& root) {
        const std::string_view classes = attribute(root, "class");
        out_.is_freesewing = classes.find("freesewing") != std::string_view::npos || root.attribute("freesewing") ||
                             root.attribute("xmlns:freesewing");
        Place place;
        walk_children(root, place);
        read_unit(root);
        return std::move(out_);
    }

 private:
    struct Place {
        Eigen::Affine2d map = Eigen::Affine2d::Identity();
        std::vector<SvgGroup> groups = {};
        int depth = 0;
        int uses = 0;  // that lead here
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
        for (const pugi::xml_node& child : node.children()) {
            if (child.type() == pugi::node_element) collect_ids(child, depth + 1);
        }
    }

    // ---- Units: lengths in the drawing are those of the root's viewBox.

    static std::optional<SvgLength> size_of(const pugi::xml_node& root, const char* name) {
        return parse_length(attribute(root, name));
    }

    void read_unit(const pugi::xml_node& root) {
        const std::vector<double> box = parse_numbers(attribute(root, "viewBox"));
        const auto width = size_of(root, "width"), height = size_of(root, "height");
        const auto unit_of = [&](const std::optional<SvgLength>& size, std::size_t axis) {
            if (!size || metres_of(size->unit) == 0) return 0.0;
            const double metres = size->value * metres_of(size->unit);
            const double units = box.size() == 4 ? box[axis] : metres / (0.0254 / 96);
            return units > 0 ? metres / units : 0.0;
        };
        const double across = unit_of(width, 2), down = unit_of(height, 3);
        if (across > 0 || down > 0) {
            out_.metres_per_unit = across > 0 && down > 0 ? std::min(across, down) : std::max(across, down);
        } else if (out_.is_freesewing) {
            out_.metres_per_unit = 0.001;
        } else if (root.attribute("inkscape:version")) {
            out_.metres_per_unit = 0.0254 / 96;
        }
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
        if (std::ranges::find(skipped, name) != skipped.end() || is_hidden(node)) return;
        if (name == "metadata") return read_seams(node);
        if (++visited_ > kMostElements) fail(node, "the file uses its own elements more than 200,000 times");
        if (above.depth > kDeepestElement) fail(node, "elements use each other without end");
        Place place = above;
        ++place.depth;
        if (const std::string_view text = attribute(node, "transform"); !text.empty()) {
            const auto map = parse_transform(text);
            if (!map || !map->matrix().allFinite()) fail(node, "the transform is wrong");
            place.map = above.map * *map;
        }
        if (name == "g" || name == "svg" || name == "a" || name == "switch") return walk_group(node, place);
        if (name == "use") return walk_use(node, place);
        if (name == "text") return read_text(node, place);
        read_shape(node, name, place);
    }

    SvgGroup group_of(const pugi::xml_node& node) {
        SvgGroup group{.number = ++groups_};
        group.id = decoded_id(attribute(node, "id"));
        group.label = attribute(node, "inkscape:label");
        if (group.label.empty()) group.label = attribute(node, "data-name");
        group.is_layer = attribute(node, "inkscape:groupmode") == "layer";
        group.data = own_data(node);
        return group;
    }

    void walk_group(const pugi::xml_node& node, Place place) {
        if (local_name(node.name()) == "svg") {
            const auto x = parse_length(attribute(node, "x")), y = parse_length(attribute(node, "y"));
            place.map.translate(Vec2d(x ? x->value : 0, y ? y->value : 0));
        }
        place.groups.push_back(group_of(node));
        walk_children(node, place);
    }

    void walk_use(const pugi::xml_node& node, Place place) {
        const std::string id(reference(node));
        const auto x = parse_length(attribute(node, "x")), y = parse_length(attribute(node, "y"));
        const Vec2d shift(x ? x->value : 0, y ? y->value : 0);
        const Vec2d at = place.map * shift;
        out_.uses.push_back({id, {at.x(), -at.y()}, place.groups});
        // FreeSewing's marks are drawings of their own: their place is all that counts.
        const auto target = by_id_.find(id);
        if (out_.is_freesewing || target == by_id_.end()) return;
        constexpr int kMostUses = 32;
        if (++place.uses > kMostUses) fail(node, "elements use each other without end");
        place.map.translate(shift);
        if (local_name(target->second.name()) == "symbol") return walk_children(target->second, place);
        walk(target->second, place);
    }

    static double number(const pugi::xml_node& node, const char* name) {
        const auto length = parse_length(attribute(node, name));
        return length ? length->value : 0;
    }

    void draw_rectangle(const pugi::xml_node& node, bool keeps_circles, PathBuilder& pen) const {
        const Vec2d low(number(node, "x"), number(node, "y")), size(number(node, "width"), number(node, "height"));
        if (!(size.minCoeff() > 0)) return;
        double rx = number(node, "rx"), ry = number(node, "ry");
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

    // Returns whether the element is a shape.
    bool draw(const pugi::xml_node& node, std::string_view name, bool keeps_circles, PathBuilder& pen) const {
        if (name == "path") {
            const std::string problem = draw_path_data(attribute(node, "d"), keeps_circles, pen);
            if (!problem.empty()) fail(node, problem);
        } else if (name == "rect") {
            draw_rectangle(node, keeps_circles, pen);
        } else if (name == "circle") {
            draw_ellipse({number(node, "cx"), number(node, "cy")}, Vec2d::Constant(number(node, "r")), keeps_circles,
                         pen);
        } else if (name == "ellipse") {
            draw_ellipse({number(node, "cx"), number(node, "cy")}, {number(node, "rx"), number(node, "ry")},
                         keeps_circles, pen);
        } else if (name == "line") {
            pen.move({number(node, "x1"), number(node, "y1")});
            pen.line({number(node, "x2"), number(node, "y2")});
        } else if (name == "polyline" || name == "polygon") {
            draw_points(node, name == "polygon", pen);
        } else {
            return false;
        }
        return true;
    }

    void read_shape(const pugi::xml_node& node, std::string_view name, const Place& place) {
        const Eigen::Matrix2d linear = place.map.linear();
        const double a = linear.col(0).squaredNorm(), b = linear.col(1).squaredNorm();
        const bool keeps_circles =
            std::abs(a - b) < 1e-9 * (a + b) && std::abs(linear.col(0).dot(linear.col(1))) < 1e-9 * (a + b);
        PathBuilder pen;
        if (!draw(node, name, keeps_circles, pen)) return;
        for (DrawnPath& path : pen.take(0, 0)) {
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
            path.name = decoded_id(attribute(node, "id"));
            if (const std::string_view label = attribute(node, "inkscape:label"); !label.empty()) path.name = label;
            path.place = "<" + std::string(name) + "> " +
                         (path.name.empty() ? "in line " + std::to_string(line_number(node)) : "'" + path.name + "'");
            SvgShape shape{.path = std::move(path), .groups = place.groups};
            shape.classes = attribute(node, "class");
            shape.text_along = attribute(node, "data-text");
            shape.markers = std::string(attribute(node, "marker-start")) + std::string(attribute(node, "marker-end"));
            shape.data = own_data(node);
            out_.shapes.push_back(std::move(shape));
        }
    }

    static void append_text(const pugi::xml_node& node, std::string& text, int depth) {
        if (depth > kDeepestElement) return;
        text += node.value();
        for (const pugi::xml_node& child : node.children()) append_text(child, text, depth + 1);
    }

    void read_text(const pugi::xml_node& node, const Place& place) {
        SvgText text;
        text.groups = place.groups;
        append_text(node, text.text.text, 0);
        while (!text.text.text.empty() && std::strchr(" \t\r\n", text.text.text.back())) text.text.text.pop_back();
        pugi::xml_node at = node;
        for (const pugi::xml_node& child : node.children()) {
            if (local_name(child.name()) == "textPath") text.along = reference(child);
            if (!node.attribute("x") && child.attribute("x")) at = child;
        }
        const Vec2d p = place.map * Vec2d(number(at, "x"), number(at, "y"));
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

    std::string_view text_;
    std::vector<std::size_t> line_ends_;  // offsets; empty: not asked for yet
    const std::string& file_;
    std::map<std::string, pugi::xml_node, std::less<>> by_id_;
    int elements_ = 0;
    int visited_ = 0;
    int groups_ = 0;
    std::size_t edges_ = 0;
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
        text.data(), text.size(), pugi::parse_default | pugi::parse_ws_pcdata_single, pugi::encoding_auto);
    if (!result)
        throw InputError(file, place_of_line(text, result.offset), std::string("not XML: ") + result.description());
    for (const pugi::xml_node& node : document.children()) {
        if (node.type() == pugi::node_element && local_name(node.name()) == "svg")
            return Walker(document, text, file).walk(node);
    }
    throw InputError(file, "", "no <svg> element");
}

}  // namespace selvedge::sim
