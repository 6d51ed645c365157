#pragma once
// Pages of a PDF on which lines and texts are drawn: Cairo and Pango behind plain calls. Page coordinates: m, from the
// upper left corner, y down. The same calls give the same bytes; no date is written.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

struct LineStyle {
    double width = 0.25e-3;           // m
    double grey = 0;                  // 0: black, 1: white
    std::vector<double> dashes = {};  // m, on and off in turn; empty: solid
};

enum class TextAlign { Left, Centre, Right };

struct TextStyle {
    double height = 3.5e-3;  // m, from line to line, about
    double grey = 0;
    bool is_bold = false;
    TextAlign align = TextAlign::Left;
    double angle = 0;       // rad, counter-clockwise about the text's place
    double most_width = 0;  // m: longer lines are broken; 0: they are not
};

class PdfCanvas {
 public:
    explicit PdfCanvas(const std::string& title);
    ~PdfCanvas();
    PdfCanvas(const PdfCanvas&) = delete;
    PdfCanvas& operator=(const PdfCanvas&) = delete;

    // The first page begins with this, too.
    void begin_page(const Vec2d& size);

    void draw_line(const std::vector<Vec2d>& points, bool is_closed, const LineStyle& style);
    void draw_rectangle(const Eigen::AlignedBox2d& box, const LineStyle& style);
    void fill(const std::vector<Vec2d>& outline, double grey);

    // `at` is the upper end of the text's first line. Returns the height, m.
    double draw_text(const std::string& text, const Vec2d& at, const TextStyle& style);

    // Until end_clip(), draws within the box only.
    void begin_clip(const Eigen::AlignedBox2d& box);
    void end_clip();

    // What is drawn from now on lies in this layer, which viewers list by its name (ASCII) and can hide; empty: in
    // none. It ends with the page. Pre: a page has begun; the layer before began within the same clip.
    void set_layer(const std::string& name);

    // The file. Throws std::runtime_error if Cairo could not make it.
    std::string finish();

 private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace selvedge::sim
