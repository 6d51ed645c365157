#include "sim/print/pages.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "sim/core/error.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

struct NamedSize {
    std::string_view key;
    std::string_view name;
    double width_mm, height_mm;
};
constexpr std::array kSizes = std::to_array<NamedSize>({{"a4", "A4", 210, 297},
                                                        {"a3", "A3", 297, 420},
                                                        {"a2", "A2", 420, 594},
                                                        {"a1", "A1", 594, 841},
                                                        {"a0", "A0", 841, 1189},
                                                        {"letter", "Letter", 215.9, 279.4},
                                                        {"legal", "Legal", 215.9, 355.6},
                                                        {"tabloid", "Tabloid", 279.4, 431.8}});

bool shows(const Eigen::AlignedBox2d& area, const std::vector<Vec2d>& outline) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        if (segment_meets_box(outline[i], outline[(i + 1) % outline.size()], area)) return true;
    }
    return is_inside(area.center(), outline);
}

// "A", ..., "Z", "AA", ...
std::string column_name(int column) {
    std::string name;
    for (int n = column + 1; n > 0; n = (n - 1) / 26) name.insert(name.begin(), static_cast<char>('A' + (n - 1) % 26));
    return name;
}

// A piece that the sheet turns keeps its label.
void keep_labels_on_pages(PagedSheet& paged) {
    for (std::size_t i = 0; i < paged.sheet.pieces.size(); ++i) {
        const NestPlace& place = paged.sheet.places[i];
        if (place.turn != 0) continue;
        std::vector<Eigen::AlignedBox2d> boxes;
        for (const Page& page : paged.pages) {
            boxes.push_back(paged.grid.own_area(page.column, page.row));
            boxes.back().translate(-place.shift);
        }
        move_label(paged.sheet.pieces[i], boxes);
    }
}

}  // namespace

PageSize parse_page_size(std::string_view text) {
    std::string small(text);
    std::ranges::transform(small, small.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    for (const NamedSize& size : kSizes) {
        if (small == size.key) return {std::string(size.name), Vec2d(size.width_mm, size.height_mm) / 1000};
    }
    const std::size_t x = small.find('x');
    Vec2d mm = Vec2d::Zero();
    const auto number = [](std::string_view part, double& value) {
        const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        return error == std::errc() && stop == part.data() + part.size();
    };
    if (x == std::string::npos || !number(std::string_view(small).substr(0, x), mm.x()) ||
        !number(std::string_view(small).substr(x + 1), mm.y()))
        throw InputError("", "--paper",
                         "'" + std::string(text.substr(0, 40)) +
                             "' is none of a4, a3, a2, a1, a0, letter, legal, tabloid, nor WIDTHxHEIGHT in mm");
    constexpr double kLeast = 150, kMost = 5000;
    if (!(mm.minCoeff() >= kLeast && mm.maxCoeff() <= kMost))
        throw InputError("", "--paper", "'" + std::string(text.substr(0, 40)) + "': 150 to 5000 mm on each side");
    return {small + " mm", mm / 1000};
}

Eigen::AlignedBox2d PageGrid::area(int column, int row) const {
    const Vec2d size = printable(), pitch = size - Vec2d::Constant(overlap);
    const Vec2d upper_left(column * pitch.x(), top - row * pitch.y());
    return {Vec2d(upper_left.x(), upper_left.y() - size.y()), Vec2d(upper_left.x() + size.x(), upper_left.y())};
}

Eigen::AlignedBox2d PageGrid::own_area(int column, int row) const {
    const Eigen::AlignedBox2d all = area(column, row);
    const Vec2d strip = Vec2d::Constant(overlap);
    return {Vec2d(all.min() + strip), Vec2d(all.max() - strip)};
}

PageGrid grid_over(const PaperSheet& sheet, const Vec2d& paper) {
    PageGrid grid{.paper = paper, .top = sheet.size.y()};
    const Vec2d pitch = grid.printable() - Vec2d::Constant(grid.overlap);
    const auto count = [&](Eigen::Index axis) {
        return std::max(1, static_cast<int>(std::ceil((sheet.size[axis] - grid.overlap) / pitch[axis] - 1e-9)));
    };
    grid.columns = count(0);
    grid.rows = count(1);
    return grid;
}

std::vector<Page> pages_of(const PaperSheet& sheet, const PageGrid& grid) {
    std::vector<std::vector<Vec2d>> outlines;
    for (std::size_t i = 0; i < sheet.pieces.size(); ++i) {
        outlines.push_back(sheet.pieces[i].cut);
        for (Vec2d& p : outlines.back()) p = sheet.places[i].at(p);
    }
    std::vector<Page> pages;
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const Eigen::AlignedBox2d area = grid.area(column, row);
            if (std::ranges::any_of(outlines, [&](const auto& outline) { return shows(area, outline); }))
                pages.push_back({column, row, column_name(column) + std::to_string(row + 1)});
        }
    }
    return pages;
}

PagedSheet lay_out_pages(const Pattern& pattern, const std::vector<PaperPiece>& pieces, const PageSize& paper) {
    constexpr int kMostColumns = 8, kOrders = 3;
    PagedSheet best;
    constexpr std::uint64_t kMostWork = NestOptions{}.most_work / 2;  // then the best so far is taken
    std::uint64_t work = 0;                                           // of all layouts
    double widest = 0;
    for (const PaperPiece& piece : pieces) widest = std::max(widest, piece.box().sizes().x());
    for (const bool is_landscape : {false, true}) {
        const Vec2d size = is_landscape ? Vec2d(paper.size.y(), paper.size.x()) : paper.size;
        const PageGrid one{.paper = size};
        const double pitch = one.printable().x() - one.overlap;
        const int least = std::max(1, static_cast<int>(std::ceil((widest - one.overlap) / pitch - 1e-9)));
        for (int columns = least; columns <= std::max(least, kMostColumns) && work < kMostWork; ++columns) {
            PagedSheet paged{.sheet = paper_sheet(pattern, pieces, columns * pitch + one.overlap,
                                                  {.orders = kOrders, .most_work = kMostWork})};
            work += paged.sheet.work;
            paged.grid = grid_over(paged.sheet, size);
            paged.pages = pages_of(paged.sheet, paged.grid);
            if (best.pages.empty() || paged.pages.size() < best.pages.size()) best = std::move(paged);
        }
    }
    keep_labels_on_pages(best);
    return best;
}

}  // namespace selvedge::sim
