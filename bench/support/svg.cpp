#include "bench/support/svg.h"

#include <cstdio>

namespace selvedge::bench {
namespace {

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string escaped_text(std::string_view text) {
    std::string out;
    for (const char c : text) out += c == '&' ? "&amp;" : (c == '<' ? "&lt;" : (c == '>' ? "&gt;" : std::string(1, c)));
    return out;
}

std::string dashes(const SvgStroke& stroke) {
    return stroke.is_dashed ? " stroke-dasharray=\"6 4\"" : "";
}

}  // namespace

void SvgDrawing::line(const std::vector<Vec2d>& points, const SvgStroke& stroke) {
    body_ += stroke.is_closed ? "<polygon points=\"" : "<polyline points=\"";
    for (const Vec2d& p : points) body_ += number(p.x()) + "," + number(p.y()) + " ";
    body_ += "\" fill=\"" + std::string(stroke.fill) + "\" stroke=\"" + std::string(stroke.stroke) +
             "\" stroke-width=\"" + number(stroke.width_px) + "\" stroke-linejoin=\"round\"" + dashes(stroke) + "/>\n";
}

void SvgDrawing::arrow(const Vec2d& from, const Vec2d& to, const SvgStroke& stroke) {
    const double head = 4 + 2 * stroke.width_px;  // px
    const Vec2d along = (to - from).normalized(), across(-along.y(), along.x());
    const Vec2d neck = to - head * along;
    line({from, neck}, stroke);
    line({to, neck + 0.45 * head * across, neck - 0.45 * head * across},
         {.stroke = stroke.stroke, .width_px = 0.5, .fill = stroke.stroke, .is_closed = true});
}

void SvgDrawing::circle(const Vec2d& centre, double radius_px, const SvgStroke& stroke) {
    body_ += "<circle cx=\"" + number(centre.x()) + "\" cy=\"" + number(centre.y()) + "\" r=\"" + number(radius_px) +
             "\" fill=\"" + std::string(stroke.fill) + "\" stroke=\"" + std::string(stroke.stroke) +
             "\" stroke-width=\"" + number(stroke.width_px) + "\"" + dashes(stroke) + "/>\n";
}

void SvgDrawing::dot(const Vec2d& centre, double radius_px, std::string_view fill) {
    body_ += "<circle cx=\"" + number(centre.x()) + "\" cy=\"" + number(centre.y()) + "\" r=\"" + number(radius_px) +
             "\" fill=\"" + std::string(fill) + "\"/>\n";
}

void SvgDrawing::text(const Vec2d& at, std::string_view text, const SvgText& options) {
    body_ += "<text x=\"" + number(at.x()) + "\" y=\"" + number(at.y()) + "\" font-size=\"" + number(options.size_px) +
             "\" fill=\"" + std::string(options.fill) + "\" text-anchor=\"" + std::string(options.anchor) + "\"" +
             (options.is_bold ? " font-weight=\"600\"" : "") + ">" + escaped_text(text) + "</text>\n";
}

std::string SvgDrawing::to_text() const {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(width_) + " " + number(height_) +
           "\" width=\"" + number(width_) + "\" height=\"" + number(height_) +
           "\" font-family=\"Inter, system-ui, Helvetica, Arial, sans-serif\">\n"
           "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" +
           body_ + "</svg>\n";
}

}  // namespace selvedge::bench
