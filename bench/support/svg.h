#pragma once
// A small SVG drawing: lines, filled shapes, dots and text in pixels from the top left.
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::bench {

struct SvgStroke {
    std::string_view stroke = "#222222";
    double width_px = 1.5;
    std::string_view fill = "none";
    bool is_closed = false;
    bool is_dashed = false;
};

struct SvgText {
    double size_px = 13;
    std::string_view fill = "#222222";
    std::string_view anchor = "start";  // or middle, end
    bool is_bold = false;
};

class SvgDrawing {
 public:
    SvgDrawing(double width_px, double height_px) : width_(width_px), height_(height_px) {}

    void line(const std::vector<Vec2d>& points, const SvgStroke& stroke = {});
    void arrow(const Vec2d& from, const Vec2d& to, const SvgStroke& stroke = {});  // with its head at `to`
    void circle(const Vec2d& centre, double radius_px, const SvgStroke& stroke = {});
    void dot(const Vec2d& centre, double radius_px, std::string_view fill);
    void text(const Vec2d& at, std::string_view text, const SvgText& options = {});  // `at`: its baseline

    // A whole document that also stands inside an HTML page.
    std::string to_text() const;

 private:
    double width_, height_;  // px
    std::string body_;
};

}  // namespace selvedge::bench
