#include "sim/paper/pdf_drawing.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/printable.h"
#include "sim/paper/path_builder.h"
#include "sim/paper/pdf_pictures.h"
#include "sim/paper/pdf_tiles.h"
#include "sim/paper/plain_parts.h"
#include "sim/paper/size_names.h"

namespace selvedge::sim {
namespace {

constexpr double kMetresPerMm = 0.001;

std::string page_name(std::size_t number) {
    return "page " + std::to_string(number);
}

// "pages 1, 3 and 4", "pages 2 to 12".
std::string page_names(const std::vector<std::size_t>& numbers) {
    if (numbers.size() == 1) return page_name(numbers.front());
    const std::size_t first = numbers.front(), last = numbers.back();
    if (numbers.size() > 2 && last - first + 1 == numbers.size())
        return "pages " + std::to_string(first) + " to " + std::to_string(last);
    constexpr std::size_t kMostNamed = 8;
    if (numbers.size() > kMostNamed) return std::to_string(numbers.size()) + " pages";
    std::string names = "pages ";
    for (std::size_t i = 0; i < numbers.size(); ++i)
        names += (i == 0 ? "" : i + 1 == numbers.size() ? " and " : ", ") + std::to_string(numbers[i]);
    return names;
}

class PdfReader {
 public:
    PdfReader(const PdfFile& pdf, const std::string& file, const PageDrawing& draw)
        : pdf_(pdf), file_(file), draw_(draw) {}

    Drawing read() {
        drawing_.title = pdf_.title;
        drawing_.format = "PDF, " + count_text(pdf_.pages.size(), "page");
        drawing_.metres_per_unit = kMetresPerMm;
        tell_layers();
        for (const PdfPage& page : pdf_.pages) is_picture_.push_back(is_picture(page));
        read_beside_pictures();
        add_pictures();
        return std::move(drawing_);
    }

 private:
    std::string pages_text() const {
        return pdf_.pages.size() == 1 ? std::string("page") : count_text(pdf_.pages.size(), "page");
    }

    void read_lines() {
        std::vector<TilePage> pages;
        for (std::size_t i = 0; i < pdf_.pages.size(); ++i) {
            if (!is_picture_[i]) pages.push_back(tile_page(i));
        }
        JoinedTiles joined = join_tiles(pages);
        std::ranges::move(joined.notes, std::back_inserter(drawing_.notes));
        joined.plain.metres_per_unit = scale_of(pages, joined.left);
        drawing_.metres_per_unit = joined.plain.metres_per_unit;
        if (joined.joined.empty() && joined.single.size() == 1)
            joined.plain.page = Eigen::AlignedBox2d(Vec2d(Vec2d::Zero()), pages[joined.single.front()].size);
        tell_left(pages, joined.left);
        if (joined.plain.shapes.empty()) {
            if (has_pictures()) return drawing_.notes.push_back("beside its scans: no line that could be a panel");
            throw InputError(file_, "", "no line on its " + pages_text() + ": no pattern");
        }
        add_parts(std::move(joined));
        if (drawing_.parts.empty())
            throw InputError(file_, "", "no closed outline on its " + pages_text() + ": nothing that could be a panel");
        tell_scale();
    }

    // Outlines that end at the borders of pages are open where nothing tells how pages lie.
    void add_parts(JoinedTiles joined) {
        try {
            add_plain_parts(std::move(joined.plain), file_, drawing_);
        } catch (const InputError& error) {
            if (!joined.joined.empty() || joined.single.size() < 2) throw;
            throw InputError(file_, error.place(),
                             error.problem() + ". Its pages could not be put together: their lines do not go on from " +
                                 "one to the next in any grid");
        }
    }

    // ---- Layers.

    // The only size that the file shows is its sample size.
    void tell_layers() {
        std::vector<std::string> shown, hidden_sizes, hidden;
        for (const PdfLayer& layer : pdf_.layers) {
            const bool is_size = size_of_name(layer.name).has_value();
            if (layer.is_hidden == 0) {
                if (is_size) shown.push_back(*size_of_name(layer.name));
            } else {
                (is_size ? hidden_sizes : hidden).push_back(layer.name);
            }
        }
        if (shown.size() == 1 && !hidden_sizes.empty()) drawing_.sample_size = shown.front();
        if (!hidden.empty())
            drawing_.notes.push_back(count_text(hidden.size(), "layer") + " that the file hides, left out: " +
                                     hidden.front().substr(0, 60) + (hidden.size() > 1 ? ", ..." : ""));
    }

    std::vector<PlainGroup> groups_of(const std::vector<std::int32_t>& layers) const {
        std::vector<PlainGroup> groups;
        for (const std::int32_t layer : layers) {
            const std::string& name = pdf_.layers[static_cast<std::size_t>(layer)].name;
            groups.push_back({.number = layer + 1, .id = name, .label = name, .is_layer = true});
        }
        return groups;
    }

    // ---- Pages.

    // Of the page's area.
    static double share_of_pictures(const PdfPage& page) {
        double pictures = 0;
        for (std::size_t i = 0; i + 1 < page.pictures.size(); i += 2)
            pictures += (page.pictures[i + 1] - page.pictures[i]).cwiseMax(0).prod();
        return pictures / page.size.prod();
    }

    // A frame of the page, or one of its sides.
    static bool is_along_border(const std::vector<Vec2d>& points, const Vec2d& page) {
        constexpr double kThin = 3, kNear = 0.15, kWide = 0.8;  // mm; of the page
        Eigen::AlignedBox2d box;
        for (const Vec2d& p : points) box.extend(p);
        const auto is_on_box = [&](const Vec2d& p) {
            return std::min((p - box.min()).minCoeff(), (box.max() - p).minCoeff()) < kThin;
        };
        if ((box.sizes().array() > kWide * page.array()).all()) return std::ranges::all_of(points, is_on_box);
        for (const int axis : {0, 1}) {
            const double near = kNear * page[axis];
            if (box.sizes()[axis] < kThin && (box.max()[axis] < near || box.min()[axis] > page[axis] - near))
                return true;
        }
        return false;
    }

    // A page with a picture over much of it, and no line as large as a part: a scan, or a photo among instructions.
    static bool is_picture(const PdfPage& page) {
        constexpr double kMuch = 0.3, kLarge = 60;  // of the page's area; mm
        if (share_of_pictures(page) < kMuch) return false;
        return std::ranges::none_of(page.shapes, [&](const PdfShape& shape) {
            Eigen::AlignedBox2d box;
            for (const Vec2d& p : shape.points) box.extend(p);
            return !is_along_border(shape.points, page.size) && box.sizes().maxCoeff() > kLarge;
        });
    }

    bool has_pictures() const { return std::ranges::find(is_picture_, true) != is_picture_.end(); }

    // Where pages are pictures, the others need not have lines. Those that they have are read, or refused.
    void read_beside_pictures() {
        bool has_lines = false;
        for (std::size_t i = 0; i < pdf_.pages.size(); ++i)
            has_lines = has_lines || (!is_picture_[i] && !pdf_.pages[i].shapes.empty());
        if (has_lines || !has_pictures()) read_lines();
    }

    // Beside pages that were read, a scan fills its page; other pictures are of a cover or of instructions.
    void add_pictures() {
        constexpr double kFilled = 0.7;  // of the page: a scan of A4 within margins of 15 mm has 0.77
        std::vector<std::size_t> left, too_many;
        for (std::size_t i = 0; i < pdf_.pages.size(); ++i) {
            if (!is_picture_[i]) continue;
            if (!drawing_.parts.empty() && share_of_pictures(pdf_.pages[i]) < kFilled) {
                left.push_back(i + 1);
            } else if (drawing_.pictures.size() == kMostUnderlays) {
                too_many.push_back(i + 1);
            } else {
                drawing_.pictures.push_back({.number = i + 1, .size = kMetresPerMm * pdf_.pages[i].size});
            }
        }
        if (!left.empty())
            drawing_.notes.push_back(page_names(left) + ": a picture on a cover or among instructions, left out");
        draw_pictures();
        tell_pictures();
        if (!too_many.empty())
            drawing_.notes.push_back(page_names(too_many) + ": left out: at most " + std::to_string(kMostUnderlays) +
                                     " scans of a file are laid under the sheet");
    }

    // They are drawn at the size of their pages, and have the scale of the lines. What was read of lines is not lost
    // with them.
    void draw_pictures() {
        try {
            if (draw_) draw_(drawing_.pictures);
        } catch (const InputError& error) {
            if (drawing_.parts.empty()) throw;
            std::vector<std::size_t> numbers;
            for (const DrawnPicture& picture : drawing_.pictures) numbers.push_back(picture.number);
            drawing_.notes.push_back(page_names(numbers) + ": only a scan, left out: " + error.problem());
            drawing_.pictures.clear();
        }
        scale_pictures(drawing_.pictures, *drawing_.metres_per_unit / kMetresPerMm);
    }

    // Pages of one size on one line.
    void tell_pictures() {
        const std::vector<DrawnPicture>& pictures = drawing_.pictures;
        for (std::size_t i = 0; i < pictures.size();) {
            const Vec2d size = pictures[i].size;
            std::vector<std::size_t> numbers;
            for (; i < pictures.size() && (pictures[i].size - size).norm() < kMetresPerMm; ++i)
                numbers.push_back(pictures[i].number);
            std::array<char, 64> text{};
            std::snprintf(text.data(), text.size(), ", %.1f x %.1f cm", 100 * size.x(), 100 * size.y());
            drawing_.notes.push_back(page_names(numbers) + ": only a scan" + text.data() +
                                     ": no panel is read of it; it lies under the sheet, to be traced in the editor");
        }
    }

    TilePage tile_page(std::size_t index) const {
        const PdfPage& page = pdf_.pages[index];
        TilePage tile{.number = index + 1, .size = page.size};
        tile.texts = page.texts;
        std::size_t number = 0;
        for (const PdfShape& shape : page.shapes) {
            ++number;
            for (DrawnPath& path : paths_of(shape)) {
                path.place = page_name(index + 1) + ", path " + std::to_string(number);
                TileShape& one = tile.shapes.emplace_back();
                one.box = box_of(path);
                one.plain.path = std::move(path);
                one.plain.groups = groups_of(shape.layers);
                one.plain.style = shape.style;
                one.plain.is_filled_only = shape.is_filled_only != 0;
                one.seen = Eigen::AlignedBox2d(shape.seen[0], shape.seen[1]);
            }
        }
        return tile;
    }

    // None, if it has no length.
    static std::vector<DrawnPath> paths_of(const PdfShape& shape) {
        constexpr double kShortest = 1e-3, kGap = 1e-3;  // mm
        PathBuilder builder;
        builder.move(shape.points.front());
        std::size_t at = 1;
        for (const std::uint8_t is_curve : shape.is_curve) {
            const Vec2d* p = &shape.points[at];
            if (is_curve != 0) {
                builder.cubic(p[0], p[1], p[2]);
            } else {
                builder.line(p[0]);
            }
            at += is_curve != 0 ? 3 : 1;
        }
        if (shape.is_closed != 0) builder.close();
        return builder.take(kShortest, kGap);
    }

    static Eigen::AlignedBox2d box_of(const DrawnPath& path) {
        Eigen::AlignedBox2d box;
        for (const Vec2d& v : path.vertices) box.extend(v);
        for (const OutlineEdge& edge : path.edges) {
            if (edge.kind != CurveKind::Cubic) continue;
            for (const Vec2d& control : edge.control) box.extend(control);
        }
        return box;
    }

    void tell_left(const std::vector<TilePage>& pages, const std::vector<std::size_t>& left) {
        std::vector<std::size_t> numbers;
        for (const std::size_t p : left) {
            if (!pages[p].shapes.empty()) numbers.push_back(pages[p].number);
        }
        if (!numbers.empty()) drawing_.notes.push_back(page_names(numbers) + ": a cover or instructions, left out");
    }

    // ---- Scale.

    // By the test square on a cover, which is read as a drawing of its own.
    std::optional<double> scale_of(const std::vector<TilePage>& pages, const std::vector<std::size_t>& left) {
        double scale = kMetresPerMm;
        for (const std::size_t p : left) {
            PlainDrawing plain{.metres_per_unit = kMetresPerMm};
            for (const TileShape& shape : pages[p].shapes) plain.shapes.push_back(shape.plain);
            for (const PdfText& text : pages[p].texts) plain.texts.push_back({text.middle(), text.text});
            Drawing cover;
            cover.metres_per_unit = kMetresPerMm;
            try {
                add_plain_parts(std::move(plain), file_, cover);
            } catch (const InputError&) {
                continue;  // of lines that are no parts
            }
            for (std::string& note : cover.notes) {
                if (note.find("test square") == std::string::npos) continue;
                has_test_square_ = true;
                if (note.find("scale is taken") != std::string::npos) drawing_.notes.push_back(std::move(note));
            }
            if (cover.metres_per_unit != kMetresPerMm) scale = *cover.metres_per_unit;
        }
        return scale;
    }

    void tell_scale() {
        for (const std::string& note : drawing_.notes)
            has_test_square_ = has_test_square_ || note.find("test square") != std::string::npos;
        drawing_.notes.push_back(has_test_square_ && drawing_.metres_per_unit == kMetresPerMm
                                     ? "the scale is proved by the test square"
                                 : has_test_square_ ? "the scale is that of the test square, not of the pages"
                                                    : "no test square: the scale is that of the pages");
    }

    const PdfFile& pdf_;
    const std::string& file_;
    const PageDrawing& draw_;
    std::vector<bool> is_picture_;
    bool has_test_square_ = false;
    Drawing drawing_;
};

}  // namespace

Drawing read_pdf(std::string_view bytes, const std::string& file) {
    const auto draw = [&](std::vector<DrawnPicture>& pages) { draw_pages(bytes, file, pages); };
    return drawing_of_pdf(read_pdf_file(bytes, file), file, draw);
}

Drawing drawing_of_pdf(const PdfFile& pdf, const std::string& file, const PageDrawing& draw) {
    return PdfReader(pdf, file, draw).read();
}

}  // namespace selvedge::sim
