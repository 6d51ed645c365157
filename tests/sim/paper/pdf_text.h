#pragma once
// Small PDF files as text, without compression, and patterns tiled as other programs tile them: for the tests of PDF.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

inline constexpr double kPdfPointsPerMm = 72 / 25.4;

inline std::string pdf_number(double mm) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4f ", mm * kPdfPointsPerMm);
    return text;
}

inline std::string pdf_line(const std::vector<Vec2d>& points, bool is_closed = true) {
    std::string out;
    for (std::size_t i = 0; i < points.size(); ++i)
        out += pdf_number(points[i].x()) + pdf_number(points[i].y()) + (i == 0 ? "m " : "l ");
    return out + (is_closed ? "s\n" : "S\n");
}

inline std::string pdf_rectangle(double x, double y, double width, double height) {
    return pdf_number(x) + pdf_number(y) + pdf_number(width) + pdf_number(height) + "re S\n";
}

inline std::string pdf_words(double x, double y, const std::string& words, double points = 10) {
    return "BT /F1 " + std::to_string(points) + " Tf " + pdf_number(x) + pdf_number(y) + "Td (" + words + ") Tj ET\n";
}

struct PdfTextPage {
    std::string content;
    Vec2d size = {210, 297};     // mm
    std::string entries = {};    // of the page's dictionary
    std::string resources = {};  // more of its resources
};

struct PdfTextFile {
    std::vector<PdfTextPage> pages;
    std::string catalog = {};               // more entries of the catalog
    std::string trailer = {};               // and of the trailer
    std::vector<std::string> objects = {};  // from number 4 on; pages follow

    std::string bytes() const {
        std::vector<std::string> all{"<< /Type /Catalog /Pages 2 0 R " + catalog + " >>", "",
                                     "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>"};
        all.insert(all.end(), objects.begin(), objects.end());
        std::string kids;
        for (const PdfTextPage& page : pages) {
            const std::string number = std::to_string(all.size() + 1), content = std::to_string(all.size() + 2);
            kids += number + " 0 R ";
            all.push_back("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 " + pdf_number(page.size.x()) +
                          pdf_number(page.size.y()) + "] /Resources << /Font << /F1 3 0 R >> " + page.resources +
                          " >> /Contents " + content + " 0 R " + page.entries + " >>");
            all.push_back("<< /Length " + std::to_string(page.content.size()) + " >>\nstream\n" + page.content +
                          "\nendstream");
        }
        all[1] = "<< /Type /Pages /Kids [" + kids + "] /Count " + std::to_string(pages.size()) + " >>";
        std::string out = "%PDF-1.5\n", places;
        for (std::size_t i = 0; i < all.size(); ++i) {
            char place[24];
            std::snprintf(place, sizeof place, "%010zu 00000 n \n", out.size());
            places += place;
            out += std::to_string(i + 1) + " 0 obj\n" + all[i] + "\nendobj\n";
        }
        const std::string count = std::to_string(all.size() + 1), start = std::to_string(out.size());
        return out + "xref\n0 " + count + "\n0000000000 65535 f \n" + places + "trailer\n<< /Size " + count +
               " /Root 1 0 R " + trailer + " >>\nstartxref\n" + start + "\n%%EOF\n";
    }
};

inline std::string pdf_of(const std::string& content) {
    return PdfTextFile{.pages = {{.content = content}}}.bytes();
}

// ---- Tiled prints.

struct TiledPrint {
    Vec2d page = {215.9, 279.4};  // mm
    double margin = 12.7;         // mm, around the frame
    double overlap = 0;           // mm, of the frames of neighbours
    bool is_cut = false;          // outlines end at the frame; else they are drawn whole, and clipped to it
    bool has_frame = true;
    bool has_crosses = true;                             // in the middle of each side of the frame
    bool is_by_columns = false;                          // the order of the pages
    std::function<std::string(int, int)> label = {};     // of a column and a row, from the upper left
    std::function<std::string(int, int)> contents = {};  // more of what the page shows, page coordinates
};

// The runs of a closed polygon within a box.
inline std::vector<std::vector<Vec2d>> runs_in_box(const std::vector<Vec2d>& polygon, const Eigen::AlignedBox2d& box) {
    std::vector<std::vector<Vec2d>> runs;
    bool goes_on = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2d a = polygon[i], along = polygon[(i + 1) % polygon.size()] - a;
        double from = 0, to = 1;
        for (const int axis : {0, 1}) {
            if (along[axis] == 0) {
                if (a[axis] < box.min()[axis] || a[axis] > box.max()[axis]) to = -1;
                continue;
            }
            const double s = (box.min()[axis] - a[axis]) / along[axis], t = (box.max()[axis] - a[axis]) / along[axis];
            from = std::max(from, std::min(s, t));
            to = std::min(to, std::max(s, t));
        }
        if (from >= to) {
            goes_on = false;
            continue;
        }
        if (!goes_on || from > 0) runs.push_back({Vec2d(a + from * along)});
        runs.back().push_back(a + to * along);
        goes_on = to >= 1;
    }
    if (runs.size() > 1 && goes_on && runs.front().front() == polygon.front()) {
        runs.back().insert(runs.back().end(), runs.front().begin() + 1, runs.front().end());
        runs.front() = std::move(runs.back());
        runs.pop_back();
    }
    return runs;
}

inline std::string tile_marks(const TiledPrint& print) {
    const double m = print.margin, w = print.page.x(), h = print.page.y();
    std::string out;
    if (print.has_frame) out += "0.3 w 0.5 G " + pdf_rectangle(m, m, w - 2 * m, h - 2 * m) + "0 G ";
    if (!print.has_crosses) return out;
    for (const Vec2d& at : {Vec2d(m, h / 2), Vec2d(w - m, h / 2), Vec2d(w / 2, m), Vec2d(w / 2, h - m)}) {
        out += pdf_line({at - Vec2d(4, 0), at + Vec2d(4, 0)}, false);
        out += pdf_line({at - Vec2d(0, 4), at + Vec2d(0, 4)}, false);
    }
    return out;
}

// Pages of closed polygons, mm, which lie to the right of and above the origin.
inline PdfTextFile tiled(const std::vector<std::vector<Vec2d>>& polygons, const TiledPrint& print) {
    const Vec2d frame = print.page - Vec2d::Constant(2 * print.margin), pitch = frame - Vec2d::Constant(print.overlap);
    Vec2d size = Vec2d::Zero();
    for (const auto& polygon : polygons) {
        for (const Vec2d& p : polygon) size = size.cwiseMax(p);
    }
    const int columns = static_cast<int>(std::ceil((size.x() - print.overlap) / pitch.x()));
    const int rows = static_cast<int>(std::ceil((size.y() - print.overlap) / pitch.y()));
    PdfTextFile file;
    for (int i = 0; i < columns * rows; ++i) {
        const int column = print.is_by_columns ? i / rows : i % columns,
                  row = print.is_by_columns ? i % rows : i / columns;
        const Vec2d corner(column * pitch.x(), (rows - 1 - row) * pitch.y());
        const Eigen::AlignedBox2d box(corner, Vec2d(corner + frame));
        const Vec2d shift = Vec2d::Constant(print.margin) - corner;
        const auto moved = [&](std::vector<Vec2d> points) {
            for (Vec2d& p : points) p += shift;
            return points;
        };
        std::string content = "1 w ";
        if (!print.is_cut)
            content += "q " + pdf_number(print.margin) + pdf_number(print.margin) + pdf_number(frame.x()) +
                       pdf_number(frame.y()) + "re W n\n";
        for (const auto& polygon : polygons) {
            if (!print.is_cut) content += pdf_line(moved(polygon));
            if (print.is_cut) {
                for (const auto& run : runs_in_box(polygon, box)) content += pdf_line(moved(run), false);
            }
        }
        if (!print.is_cut) content += "Q\n";
        content += tile_marks(print);
        if (print.label) content += pdf_words(print.margin + 15, print.margin + 15, print.label(column, row), 18);
        if (print.contents) content += print.contents(column, row);
        file.pages.push_back({.content = content, .size = print.page});
    }
    return file;
}

}  // namespace selvedge::sim
