#include "sim/print/print_pdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/printable.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/segment_distance.h"
#include "sim/print/pdf_canvas.h"

namespace selvedge::sim {
namespace {

using Box = Eigen::AlignedBox2d;

LineStyle style_of(PaperLayer layer) {
    switch (layer) {
        case PaperLayer::Cut:
            return {.width = 0.4e-3};
        case PaperLayer::Sew:
            return {.width = 0.25e-3, .dashes = {4e-3, 2e-3}};
        case PaperLayer::Fold:
            return {.width = 0.3e-3, .dashes = {8e-3, 2e-3, 1e-3, 2e-3}};
        case PaperLayer::Grain:
            return {.width = 0.3e-3};
        case PaperLayer::Notches:
            return {.width = 0.35e-3};
        case PaperLayer::Drill:
            return {.width = 0.25e-3};
        case PaperLayer::Internal:
            return {.width = 0.25e-3, .grey = 0.35, .dashes = {1.5e-3, 1.5e-3}};
        case PaperLayer::Labels:
            return {};
    }
    return {};
}

// As viewers list them, and as sim/paper/plain_parts.cpp understands them.
std::string title_of(PaperLayer layer) {
    switch (layer) {
        case PaperLayer::Cut:
            return "Cutting lines";
        case PaperLayer::Sew:
            return "Sewing lines";
        case PaperLayer::Fold:
            return "Fold lines";
        case PaperLayer::Grain:
            return "Grain lines";
        case PaperLayer::Notches:
            return "Notches";
        case PaperLayer::Drill:
            return "Drill points";
        case PaperLayer::Internal:
            return "Internal lines";
        case PaperLayer::Labels:
            return "Texts";
    }
    return {};
}

bool has(const LayerChoice& layers, PaperLayer layer) {
    return layers[static_cast<std::size_t>(layer)];
}

// Draws what lies on a sheet, scaled, with the sheet's point `from` at the page's point `at`.
struct SheetView {
    Vec2d from = Vec2d::Zero();  // m, of the sheet
    Vec2d at = Vec2d::Zero();    // m, of the page
    double scale = 1;

    Vec2d to_page(const Vec2d& p) const {
        const Vec2d off = scale * (p - from);
        return {at.x() + off.x(), at.y() - off.y()};
    }
};

// Where a label is drawn.
struct LabelPlace {
    Vec2d at = Vec2d::Zero();  // m, of the page: its middle
    double angle = 0;          // rad, of its text, counter-clockwise
    double scale = 1;
    Box piece;  // m, of the page: what is seen of it
};

// A text is moved along itself to lie over its piece: on a plan a name is longer than the label that it stands for, and
// of a piece on the fold only a half is seen.
Vec2d over_piece(const Vec2d& at, double length, const LabelPlace& place) {
    const Eigen::Index axis = std::abs(std::cos(place.angle)) > std::abs(std::sin(place.angle)) ? 0 : 1;
    const double low = place.piece.min()[axis] + length / 2, high = place.piece.max()[axis] - length / 2;
    Vec2d moved = at;
    moved[axis] = low < high ? std::clamp(at[axis], low, high) : (low + high) / 2;
    return moved;
}

// On a plan that is much smaller than the cloth only the name is left, at a size that can be read, but as long as the
// piece at most.
void draw_label(PdfCanvas& canvas, const PaperLabel& label, const LabelPlace& place) {
    constexpr double kReadable = 2.5e-3, kSmallest = 1.2e-3;  // m
    const bool is_plan = place.scale * label.height < kReadable;
    const bool is_level = std::abs(std::cos(place.angle)) > std::abs(std::sin(place.angle));
    const double room = is_level ? place.piece.sizes().x() : place.piece.sizes().y();
    const double fitting = room / text_width(label.lines.front());
    const double height = is_plan ? std::clamp(fitting, kSmallest, kReadable) : place.scale * label.height;
    const std::size_t count = is_plan ? 1 : label.lines.size();
    const Vec2d down(std::sin(place.angle), std::cos(place.angle));  // from one line to the next, on the page
    double longest = 0;
    for (std::size_t i = 0; i < count; ++i) longest = std::max(longest, text_width(label.lines[i]));
    Vec2d at = over_piece(place.at, height * longest, place) - height * static_cast<double>(count) / 2 * down;
    for (std::size_t i = 0; i < count; ++i) {
        canvas.draw_text(
            label.lines[i], at,
            {.height = height, .is_bold = i == 0 && !is_plan, .align = TextAlign::Centre, .angle = place.angle});
        at += height * down;
    }
}

void draw_sheet(PdfCanvas& canvas, const PaperSheet& sheet, const SheetView& view, const LayerChoice& layers) {
    for (const PaperStroke& stroke : strokes_of(sheet, layers)) {
        std::vector<Vec2d> points;
        for (const Vec2d& p : stroke.points) points.push_back(view.to_page(p));
        LineStyle style = style_of(stroke.layer);
        constexpr double kThinnest = 0.12e-3;  // m
        style.width = std::max(kThinnest, style.width * std::sqrt(view.scale));
        for (double& dash : style.dashes) dash *= std::max(0.25, view.scale);
        canvas.set_layer(stroke.is_fold_edge ? "Cut on fold" : title_of(stroke.layer));
        canvas.draw_line(points, stroke.is_closed, style);
    }
    canvas.set_layer("");
    if (!has(layers, PaperLayer::Labels)) return;
    canvas.set_layer(title_of(PaperLayer::Labels));
    const Box page(view.to_page({0, sheet.size.y()}), view.to_page({sheet.size.x(), 0}));
    for (std::size_t i = 0; i < sheet.pieces.size(); ++i) {
        const PaperLabel& label = sheet.pieces[i].label;
        Box box;
        for (const Vec2d& p : sheet.pieces[i].cut) box.extend(view.to_page(sheet.places[i].at(p)));
        draw_label(canvas, label,
                   {.at = view.to_page(sheet.places[i].at(label.at)),
                    .angle = label.angle(sheet.places[i].turn),
                    .scale = view.scale,
                    .piece = box.intersection(page)});
    }
    canvas.set_layer("");
}

// ---- The cover.

constexpr double kBorder = 0.015;  // m

class Cover {
 public:
    Cover(PdfCanvas& canvas, const Pattern& pattern, const std::vector<PaperPiece>& pieces, const Vec2d& paper)
        : canvas_(canvas), pattern_(pattern), pieces_(pieces), paper_(paper) {}

    int draw(const PagedSheet& paged, const std::string& paper_name) {
        begin();
        draw_head();
        const double top = y_;
        draw_test_square(canvas_, {kBorder, y_});
        y_ = top + kTestSquare + kGap;
        const double beside = kBorder + kTestSquare + kGap;
        const bool is_wide = paper_.x() - kBorder - beside >= kColumn;
        const double saved = y_;
        if (is_wide) x_ = beside, y_ = top;
        draw_how_to(paged, paper_name);
        draw_legend();
        x_ = kBorder;
        y_ = std::max(y_, saved);
        draw_map(paged);
        draw_list();
        return pages_;
    }

    static void draw_test_square(PdfCanvas& canvas, const Vec2d& at) {
        canvas.draw_rectangle(Box(at, Vec2d(at + Vec2d::Constant(kTestSquare))), {.width = 0.3e-3});
        canvas.draw_text("10 cm", {at.x() + kTestSquare / 2, at.y() + 0.003},
                         {.height = 0.006, .align = TextAlign::Centre});
        canvas.draw_text("Measure this square: each side is 10 cm.\nIf it is not, print again at 100 %.",
                         {at.x() + 0.008, at.y() + kTestSquare / 2 - 0.006},
                         {.height = 0.0045, .most_width = kTestSquare - 0.016});
    }

 private:
    static constexpr double kGap = 0.008, kColumn = 0.06;  // m

    void begin() {
        canvas_.begin_page(paper_);
        ++pages_;
        x_ = kBorder;
        y_ = kBorder;
    }

    void text(const std::string& words, double height, bool is_bold, double width) {
        y_ += canvas_.draw_text(words, {x_, y_}, {.height = height, .is_bold = is_bold, .most_width = width});
    }

    double width_left() const { return paper_.x() - kBorder - x_; }

    void draw_head() {
        text(pattern_.name.empty() ? "Pattern" : pattern_.name, 0.010, true, width_left());
        if (!pattern_.size.empty()) text("Size " + pattern_.size, 0.006, false, width_left());
        y_ += kGap / 2;
    }

    void draw_how_to(const PagedSheet& paged, const std::string& paper_name) {
        std::array<char, 200> text_buffer{};
        const std::size_t full =
            static_cast<std::size_t>(paged.grid.columns) * static_cast<std::size_t>(paged.grid.rows);
        std::snprintf(text_buffer.data(), text_buffer.size(),
                      "%zu pages of %s, in %d columns (A, B, ...) and %d rows%s.", paged.pages.size(),
                      paper_name.c_str(), paged.grid.columns, paged.grid.rows,
                      full == paged.pages.size() ? "" : "; pages that would be empty are left out");
        text("Print at 100 %, not fitted to the page.", 0.0045, true, width_left());
        text(text_buffer.data(), 0.004, false, width_left());
        text(
            "Cut off or fold back the margin along the grey frame on the left and at the top of each page, lay it "
            "over its neighbours so that the diamonds meet, and glue. Neighbours overlap by 1 cm.",
            0.004, false, width_left());
        y_ += kGap / 2;
    }

    void draw_legend() {
        constexpr std::array<std::pair<PaperLayer, const char*>, 5> lines{
            {{PaperLayer::Cut, "cut here"},
             {PaperLayer::Sew, "sew here"},
             {PaperLayer::Fold, "fold"},
             {PaperLayer::Grain, "grain line: along the warp"},
             {PaperLayer::Internal, "mark"}}};
        for (const auto& [layer, words] : lines) {
            canvas_.draw_line({{x_, y_ + 0.0025}, {x_ + 0.02, y_ + 0.0025}}, false, style_of(layer));
            canvas_.draw_text(words, {x_ + 0.024, y_}, {.height = 0.004});
            y_ += 0.0055;
        }
        y_ += kGap / 2;
    }

    void draw_map(const PagedSheet& paged) {
        constexpr double kLeast = 0.05, kMost = 0.12;  // m, height
        double room = paper_.y() - kBorder - y_;
        if (room < kLeast) begin(), room = paper_.y() - 2 * kBorder;
        const Box all = paged.grid.area(0, 0).merged(paged.grid.area(paged.grid.columns - 1, paged.grid.rows - 1));
        const double width = std::min(0.5 * (paper_.x() - 2 * kBorder), kMost);
        const double scale = std::min(width / all.sizes().x(), std::min(room, kMost) / all.sizes().y());
        const SheetView view{{all.min().x(), all.max().y()}, {x_, y_}, scale};
        for (int row = 0; row < paged.grid.rows; ++row) {
            for (int column = 0; column < paged.grid.columns; ++column) draw_cell(paged, column, row, view);
        }
        for (std::size_t i = 0; i < paged.sheet.pieces.size(); ++i) {
            std::vector<Vec2d> outline;
            for (const Vec2d& p : paged.sheet.pieces[i].cut)
                outline.push_back(view.to_page(paged.sheet.places[i].at(p)));
            canvas_.draw_line(outline, true, {.width = 0.2e-3});
        }
        map_width_ = scale * all.sizes().x();
    }

    void draw_cell(const PagedSheet& paged, int column, int row, const SheetView& view) {
        const Box area = paged.grid.area(column, row);
        const Vec2d a = view.to_page({area.min().x(), area.max().y()}),
                    b = view.to_page({area.max().x(), area.min().y()});
        const auto page = std::ranges::find_if(
            paged.pages, [&](const Page& other) { return other.column == column && other.row == row; });
        if (page == paged.pages.end()) return;
        canvas_.draw_rectangle(Box(a, b), {.width = 0.1e-3, .grey = 0.6});
        const double height = std::min(0.006, 0.4 * (b.y() - a.y()));
        canvas_.draw_text(page->name, {(a.x() + b.x()) / 2, (a.y() + b.y()) / 2 - height / 2},
                          {.height = height, .grey = 0.45, .align = TextAlign::Centre});
    }

    void draw_list() {
        x_ = kBorder + map_width_ + kGap;
        const double top = y_, height = 0.0045;
        for (const PaperPiece& piece : pieces_) {
            std::string line = piece.label.lines.front();
            for (const std::string& part : piece.label.lines) {
                if (part.starts_with("cut ") || part.starts_with("fuse ")) line += ", " + part;
            }
            if (y_ + 2 * height > paper_.y() - kBorder) {
                x_ += kColumn + kGap;
                y_ = top;
                if (width_left() < kColumn / 2) begin();
            }
            text(line, height, false, std::min(width_left(), 1.5 * kColumn));
        }
    }

    PdfCanvas& canvas_;
    const Pattern& pattern_;
    const std::vector<PaperPiece>& pieces_;
    Vec2d paper_;
    double x_ = kBorder, y_ = kBorder, map_width_ = 0;
    int pages_ = 0;
};

// ---- A page of the grid.

// Where two pages overlap, in the middle of their common strip: the same place on both.
void draw_diamond(PdfCanvas& canvas, const Vec2d& at) {
    constexpr double kHalf = 0.004;  // m
    canvas.draw_line({at + Vec2d(kHalf, 0), at + Vec2d(0, kHalf), at - Vec2d(kHalf, 0), at - Vec2d(0, kHalf)}, true,
                     {.width = 0.2e-3, .grey = 0.3});
    canvas.draw_line({at - Vec2d(kHalf, 0), at + Vec2d(kHalf, 0)}, false, {.width = 0.1e-3, .grey = 0.3});
    canvas.draw_line({at - Vec2d(0, kHalf), at + Vec2d(0, kHalf)}, false, {.width = 0.1e-3, .grey = 0.3});
}

constexpr double kPageTextHeight = 0.0045;  // m

// What lies on a page, m, of the page.
struct OnPage {
    std::vector<std::vector<Vec2d>> lines = {};
    std::vector<Box> labels = {};

    bool meets(const Box& box) const {
        const auto crosses = [&](const std::vector<Vec2d>& line) {
            for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                if (segment_meets_box(line[i], line[i + 1], box)) return true;
            }
            return false;
        };
        return std::ranges::any_of(lines, crosses) ||
               std::ranges::any_of(labels, [&](const Box& label) { return label.intersects(box); });
    }
};

// page: what reaches into it.
OnPage things_on(const PagedSheet& paged, const SheetView& view, const LayerChoice& layers, const Box& page) {
    OnPage things;
    for (const PaperStroke& stroke : strokes_of(paged.sheet, layers)) {
        std::vector<Vec2d> line;
        Box box;
        for (const Vec2d& p : stroke.points) box.extend(line.emplace_back(view.to_page(p)));
        if (!box.intersects(page)) continue;
        if (stroke.is_closed) line.push_back(line.front());
        things.lines.push_back(std::move(line));
    }
    for (std::size_t i = 0; i < paged.sheet.pieces.size() && has(layers, PaperLayer::Labels); ++i) {
        const Box label = label_box(paged.sheet.pieces[i].label);
        Box& box = things.labels.emplace_back();
        for (const auto corner : {Box::BottomLeft, Box::BottomRight, Box::TopLeft, Box::TopRight})
            box.extend(view.to_page(paged.sheet.places[i].at(label.corner(corner))));
    }
    return things;
}

// Where the page's own text lies over nothing, the upper left corner first, then to the right and down.
Vec2d free_place(const PagedSheet& paged, const Page& page, const std::string& text, const LayerChoice& layers) {
    constexpr double kClear = 0.003, kStep = 0.008;  // m
    const PageGrid& grid = paged.grid;
    const Box area = grid.area(page.column, page.row);
    const OnPage things = things_on(paged, {{area.min().x(), area.max().y()}, Vec2d::Constant(grid.margin), 1}, layers,
                                    {Vec2d::Zero(), grid.paper});
    const Vec2d size(kPageTextHeight * text_width(text), kPageTextHeight), clear = Vec2d::Constant(kClear);
    const Vec2d first = Vec2d::Constant(grid.margin + grid.overlap + kClear), last = grid.paper - first - size;
    for (double y = first.y(); y <= last.y(); y += kStep) {
        for (double x = first.x(); x <= last.x(); x += kStep) {
            const Vec2d at(x, y);
            if (!things.meets(Box(at - clear, Vec2d(at + size + clear)))) return at;
        }
    }
    return first;
}

void draw_page(PdfCanvas& canvas, const PagedSheet& paged, std::size_t index, const std::string& title,
               const LayerChoice& layers) {
    const Page& page = paged.pages[index];
    const PageGrid& grid = paged.grid;
    canvas.begin_page(grid.paper);
    const Box area = grid.area(page.column, page.row);
    const Vec2d corner = Vec2d::Constant(grid.margin), size = grid.printable();
    const Box frame(corner, Vec2d(corner + size));
    canvas.begin_clip(frame);
    draw_sheet(canvas, paged.sheet, {{area.min().x(), area.max().y()}, corner, 1}, layers);
    canvas.end_clip();
    canvas.draw_rectangle(frame, {.width = 0.1e-3, .grey = 0.6});
    const double strip = grid.overlap / 2;
    const LineStyle glue{.width = 0.1e-3, .grey = 0.6, .dashes = {1e-3, 2e-3}};
    const Vec2d end = corner + size;
    if (page.column > 0) draw_diamond(canvas, {corner.x() + strip, corner.y() + size.y() / 2});
    if (page.row > 0) draw_diamond(canvas, {corner.x() + size.x() / 2, corner.y() + strip});
    if (page.column + 1 < grid.columns) {
        draw_diamond(canvas, {end.x() - strip, corner.y() + size.y() / 2});
        canvas.draw_line({{end.x() - 2 * strip, corner.y()}, {end.x() - 2 * strip, end.y()}}, false, glue);
    }
    if (page.row + 1 < grid.rows) {
        draw_diamond(canvas, {corner.x() + size.x() / 2, end.y() - strip});
        canvas.draw_line({{corner.x(), end.y() - 2 * strip}, {end.x(), end.y() - 2 * strip}}, false, glue);
    }
    const std::string text = page.name + "   page " + std::to_string(index + 1) + " of " +
                             std::to_string(paged.pages.size()) + "   " + title;
    canvas.draw_text(text, free_place(paged, page, text, layers), {.height = kPageTextHeight, .grey = 0.4});
}

// ---- One large page.

PrintedPdf one_page(const Pattern& pattern, const std::vector<PaperPiece>& pieces, const PrintOptions& options) {
    const double width = options.paper.size.minCoeff() - 2 * kBorder;
    const PaperSheet sheet = paper_sheet(pattern, pieces, width);
    const double head = kTestSquare + kBorder;
    PdfCanvas canvas(pattern.name);
    canvas.begin_page(sheet.size + Vec2d(2 * kBorder, 2 * kBorder + head));
    Cover::draw_test_square(canvas, Vec2d::Constant(kBorder));
    canvas.draw_text(
        pattern.name + (pattern.size.empty() ? "" : "\nSize " + pattern.size), {2 * kBorder + kTestSquare, kBorder},
        {.height = 0.012, .is_bold = true, .most_width = std::max(0.05, sheet.size.x() - kTestSquare - kBorder)});
    draw_sheet(canvas, sheet, {{0, sheet.size.y()}, {kBorder, kBorder + head}, 1}, options.layers);
    return {.bytes = canvas.finish(), .covers = 0, .pages = 1};
}

// ---- Cutting layouts.

double area_of(const std::vector<Vec2d>& line) {
    double twice = 0;
    for (std::size_t i = 0; i < line.size(); ++i) twice += cross2(line[i], line[(i + 1) % line.size()]);
    return std::abs(twice) / 2;
}

void draw_sett(PdfCanvas& canvas, const PaperSheet& layout, const SheetView& view) {
    if (!layout.repeat) return;
    const LineStyle thin{.width = 0.1e-3, .grey = 0.75};
    for (double x = layout.repeat->x(); x < layout.size.x(); x += layout.repeat->x())
        canvas.draw_line({view.to_page({x, 0}), view.to_page({x, layout.size.y()})}, false, thin);
    for (double y = layout.repeat->y(); y < layout.size.y(); y += layout.repeat->y())
        canvas.draw_line({view.to_page({0, y}), view.to_page({layout.size.x(), y})}, false, thin);
}

void draw_layout(PdfCanvas& canvas, const PaperSheet& layout, const Vec2d& paper, bool is_true_size) {
    constexpr double kLine = 0.006;  // m
    const std::size_t lines = 2 + layout.notes.size() + (layout.repeat ? 1 : 0) + (layout.is_folded ? 1 : 0);
    const double head = kLine * (static_cast<double>(lines) + 1);
    const Vec2d page = is_true_size ? Vec2d(layout.size + Vec2d(2 * kBorder, 2 * kBorder + head)) : paper;
    canvas.begin_page(page);
    double y = kBorder;
    const double width = page.x() - 2 * kBorder;
    const auto text = [&](const std::string& words, bool is_bold) {
        y += canvas.draw_text(words, {kBorder, y}, {.height = kLine, .is_bold = is_bold, .most_width = width});
    };
    text(layout.title.empty() ? "Cutting layout" : layout.title + ": cutting layout", true);
    text(describe_layout(layout), false);
    if (layout.repeat)
        text("Lay the fabric so that the sett begins at the lower left corner; thin lines are its repeats.", false);
    if (layout.is_folded) text("The fabric is folded along the left edge, right sides together.", false);
    for (const std::string& note : layout.notes) text(note, false);
    y += kLine / 2;
    const double scale =
        is_true_size ? 1 : std::min(width / layout.size.x(), (page.y() - kBorder - y) / layout.size.y());
    const SheetView view{{0, layout.size.y()}, {kBorder, y}, scale};
    const Box fabric(view.to_page({0, layout.size.y()}), view.to_page({layout.size.x(), 0}));
    draw_sett(canvas, layout, view);
    canvas.begin_clip(fabric);
    draw_sheet(canvas, layout, view, kAllLayers);
    canvas.end_clip();
    canvas.draw_rectangle(fabric, {.width = 0.4e-3});
    if (layout.is_folded)
        canvas.draw_line({view.to_page({0, 0}), view.to_page({0, layout.size.y()})}, false, style_of(PaperLayer::Fold));
}

}  // namespace

namespace {

// More pages than anybody glues; a garment has up to a hundred.
void require_few_pages(std::size_t pages) {
    constexpr std::size_t kMostPages = 400;
    if (pages <= kMostPages) return;
    throw InputError("", "",
                     count_text(pages, "page") + ": at most " + std::to_string(kMostPages) +
                         "; --one-page makes one for a plotter, a larger --paper makes fewer");
}

// To find a place for a piece's label and to draw it takes about a millisecond.
void require_few_pieces(std::size_t pieces) {
    constexpr std::size_t kMostDrawn = 2000;
    if (pieces <= kMostDrawn) return;
    throw InputError("", "",
                     count_text(pieces, "piece") + ": at most " + std::to_string(kMostDrawn) + " are drawn in a PDF");
}

}  // namespace

PrintedPdf print_pdf(const Pattern& pattern, const PrintOptions& options) {
    require_few_pieces(pattern.panels.size());
    const std::vector<PaperPiece> pieces =
        paper_pieces(pattern, {.draws_mirror_images = options.draws_mirror_images, .are_halved = options.are_halved});
    if (options.is_one_page) return one_page(pattern, pieces, options);
    double area = 0;
    for (const PaperPiece& piece : pieces) area += area_of(piece.cut);
    require_few_pages(static_cast<std::size_t>(area / options.paper.size.prod()));  // before they are laid out
    const PagedSheet paged = lay_out_pages(pattern, pieces, options.paper);
    require_few_pages(paged.pages.size());
    PdfCanvas canvas(pattern.name);
    PrintedPdf printed;
    printed.covers = Cover(canvas, pattern, pieces, paged.grid.paper).draw(paged, options.paper.name);
    for (std::size_t i = 0; i < paged.pages.size(); ++i) draw_page(canvas, paged, i, pattern.name, options.layers);
    printed.pages = static_cast<int>(paged.pages.size());
    printed.columns = paged.grid.columns;
    printed.rows = paged.grid.rows;
    printed.bytes = canvas.finish();
    return printed;
}

PrintedPdf print_layouts(const std::vector<PaperSheet>& layouts, const PageSize& paper, bool is_true_size) {
    std::size_t pieces = 0;
    for (const PaperSheet& layout : layouts) pieces += layout.pieces.size();
    require_few_pieces(pieces);
    PdfCanvas canvas(layouts.empty() ? "" : layouts.front().title);
    for (const PaperSheet& layout : layouts) draw_layout(canvas, layout, paper.size, is_true_size);
    return {.bytes = canvas.finish(), .covers = 0, .pages = static_cast<int>(layouts.size())};
}

std::string describe_layout(const PaperSheet& layout) {
    double used = 0;
    for (std::size_t i = 0; i < layout.pieces.size(); ++i) {
        const std::vector<Vec2d>& cut = layout.pieces[i].cut;
        const bool is_on_fold = layout.is_folded && std::ranges::any_of(cut, [&](const Vec2d& p) {
                                    return layout.places[i].at(p).x() < -1e-6;
                                });
        used += area_of(cut) / (is_on_fold ? 2 : 1);
    }
    const double width = layout.size.x() * (layout.is_folded ? 2 : 1);
    const double all = layout.size.prod();
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), ", %.0f cm wide%s, %.0f %% used", 100 * width,
                  layout.is_folded ? ", folded" : "", all > 0 ? 100 * used / all : 0);
    std::array<char, 32> length{};
    std::snprintf(length.data(), length.size(), "%.2f m of ", layout.size.y());
    return length.data() + (layout.fabric.empty() ? std::string("fabric") : fabric_title(layout.fabric)) + text.data();
}

}  // namespace selvedge::sim
