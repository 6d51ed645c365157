#include "sim/paper/svg_unit.h"

#include <algorithm>
#include <cstdlib>

#include "sim/core/lower_case.h"
#include "sim/paper/svg_path.h"

namespace selvedge::sim {
namespace {

constexpr double kMetresPerInch = 0.0254;

// "1300 MM" and "1300,5mm", as other programs write a size, as SVG has it.
std::string plain_size(std::string_view text) {
    std::string size;
    for (const char c : text) {
        if (c == ' ' || c == '\t') continue;
        size += c == ',' ? '.' : c;
    }
    return lower_case(size);
}

// Of the root: its attribute, else its style.
std::string size_of_root(const pugi::xml_node& root, const std::string& name) {
    if (const pugi::xml_attribute given = root.attribute(name.c_str())) return plain_size(given.value());
    const std::string style = lower_case(root.attribute("style").value());
    for (std::size_t at = style.find(name); at != std::string::npos; at = style.find(name, at + 1)) {
        const bool is_whole = at == 0 || style[at - 1] == ';' || style[at - 1] == ' ';
        const std::size_t colon = style.find(':', at);
        if (!is_whole || colon == std::string::npos || colon > at + name.size() + 1) continue;
        return plain_size(std::string_view(style).substr(colon + 1, style.find(';', colon) - colon - 1));
    }
    return {};
}

// 0: not a length of the world.
double metres_of(std::string_view unit) {
    if (unit == "mm") return 0.001;
    if (unit == "cm") return 0.01;
    if (unit == "in") return kMetresPerInch;
    if (unit == "pt") return kMetresPerInch / 72;
    if (unit == "pc") return kMetresPerInch / 6;
    if (unit == "Q" || unit == "q") return 0.00025;
    return 0;
}

bool is_inkscape_of_90(std::string_view version) {
    char* end = nullptr;
    const std::string text(version);
    const long major = std::strtol(text.c_str(), &end, 10);
    if (end == text.c_str() || major != 0 || *end != '.') return false;
    constexpr long kFirstOf96 = 92;
    return std::strtol(end + 1, nullptr, 10) < kFirstOf96;
}

bool is_comment_of(const pugi::xml_node& parent, std::string_view words) {
    return std::ranges::any_of(parent.children(), [&](const pugi::xml_node& child) {
        return child.type() == pugi::node_comment && std::string_view(child.value()).find(words) != std::string::npos;
    });
}

// What Illustrator leaves in its files: a comment, its namespace, an old property of the root, or names of layers.
bool is_illustrators(const pugi::xml_document& document, const pugi::xml_node& root) {
    const auto has = [&](const char* name, std::string_view part) {
        return std::string_view(root.attribute(name).value()).find(part) != std::string::npos;
    };
    const auto is_layer_name = [](const pugi::xml_node& node) {
        return std::string_view(node.attribute("id").value()).starts_with("Layer_");
    };
    return is_comment_of(document, "Adobe Illustrator") || is_comment_of(root, "Adobe Illustrator") ||
           has("style", "enable-background") || has("enable-background", "new") ||
           has("xmlns:i", "ns.adobe.com/AdobeIllustrator") || is_layer_name(root) ||
           std::ranges::any_of(root.children(), is_layer_name);
}

}  // namespace

double svg_length(std::string_view text, double reference, double pixels_per_inch) {
    const std::optional<SvgLength> length = parse_length(text);
    if (!length) return 0;
    if (length->unit == "%") return length->value / 100 * reference;
    const double metres = metres_of(length->unit);
    return metres > 0 ? length->value * metres / (kMetresPerInch / pixels_per_inch) : length->value;
}

SvgUnit svg_unit(const pugi::xml_document& document, const pugi::xml_node& root, bool is_freesewing) {
    SvgUnit unit;
    const std::string_view inkscape = root.attribute("inkscape:version").value();
    const bool is_old = is_inkscape_of_90(inkscape), is_adobe = inkscape.empty() && is_illustrators(document, root);
    if (is_old) unit.pixels_per_inch = 90;
    if (is_adobe) unit.pixels_per_inch = 72;
    const std::vector<double> box = parse_numbers(root.attribute("viewBox").value());
    const bool has_box = box.size() == 4 && box[2] > 0 && box[3] > 0;
    const std::string texts[] = {size_of_root(root, "width"), size_of_root(root, "height")};
    const std::optional<SvgLength> sizes[] = {parse_length(texts[0]), parse_length(texts[1])};
    double physical = 0, pixels = 0;  // metres, and pixels, per unit
    bool says_pixels = false;
    for (const int axis : {0, 1}) {
        const std::optional<SvgLength>& size = sizes[axis];
        if (has_box) unit.viewport[axis] = box[as_size(axis) + 2];
        if (!size || size->unit == "%" || !(size->value > 0)) continue;
        const double metres = size->value * metres_of(size->unit);
        const double count = metres > 0 ? metres / (kMetresPerInch / unit.pixels_per_inch) : size->value;
        const double units = has_box ? box[as_size(axis) + 2] : count;
        if (!has_box) unit.viewport[axis] = count;
        // The smaller of two scales is that of the drawing: it fits into its viewport.
        const auto take = [&](double& scale, double value) { scale = scale > 0 ? std::min(scale, value) : value; };
        if (metres > 0) take(physical, metres / units);
        if (metres == 0) take(pixels, count / units);
        says_pixels = says_pixels || size->unit == "px";
    }
    if (unit.viewport.minCoeff() > 0) {
        const Vec2d low = has_box ? Vec2d(box[0], box[1]) : Vec2d(0, 0);
        unit.page = Eigen::AlignedBox2d(low, low + unit.viewport);
    }
    const double pixel = (pixels > 0 ? pixels : 1) * kMetresPerInch;
    if (physical > 0) {
        unit.metres_per_unit = physical;
    } else if (is_freesewing) {
        unit.metres_per_unit = 0.001;
    } else if (!inkscape.empty() || is_adobe) {
        unit.metres_per_unit = pixel / unit.pixels_per_inch;
        if (is_old) unit.note = "drawn by an Inkscape that counts 90 pixels to the inch: 1 px taken as 0.282 mm";
        if (is_adobe) unit.note = "drawn by Illustrator, which counts 72 pixels to the inch: 1 px taken as 0.353 mm";
    } else if (says_pixels) {
        unit.likely = {{"px", "px (96 to the inch)", pixel / 96}, {"pt", "pt (72 to the inch)", pixel / 72}};
    }
    return unit;
}

Eigen::Affine2d viewport_map(const std::vector<double>& box, const Eigen::AlignedBox2d& place, std::string_view fit) {
    Eigen::Affine2d map(Eigen::Translation2d(place.min()));
    const Vec2d size = place.sizes();
    if (box.size() != 4 || !(box[2] > 0) || !(box[3] > 0) || !(size.minCoeff() > 0)) return map;
    Vec2d scale(size.x() / box[2], size.y() / box[3]);
    Vec2d spare = Vec2d::Zero();
    if (!fit.starts_with("none")) {
        const bool is_slice = fit.find("slice") != std::string_view::npos;
        scale = Vec2d::Constant(is_slice ? scale.maxCoeff() : scale.minCoeff());
        spare = size - Vec2d(scale.x() * box[2], scale.y() * box[3]);
        const auto share = [&](std::string_view least, std::string_view most) {
            if (fit.find(least) != std::string_view::npos) return 0.0;
            return fit.find(most) != std::string_view::npos ? 1.0 : 0.5;
        };
        spare = spare.cwiseProduct(Vec2d(share("xMin", "xMax"), share("YMin", "YMax")));
    }
    map.translate(spare);
    map.scale(scale);
    map.translate(Vec2d(-box[0], -box[1]));
    return map;
}

}  // namespace selvedge::sim
