#include "render/marks/legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

namespace selvedge::render {
namespace {

// All in font pixels, of which capitals of the bitmap font are seven high.
constexpr int kPadding = 8, kMargin = 10, kSwatch = 9, kGap = 6;
constexpr int kRow = 13, kTitle = 16;
constexpr int kBarWidth = 132, kBarHeight = 9, kBarRow = kBarHeight + 4 + kRow;
constexpr int kBetween = 4;  // above the notes
constexpr int kRadius = 3;
constexpr std::size_t kMinLetters = 14;  // that remain of a name that does not fit
constexpr float kCapital = 7, kEm = 11;  // kEm: of an outline font, with which its letters are about as wide

constexpr Rgba8 kPaper{0xFC, 0xFB, 0xF9, 0xD6}, kRim{0x30, 0x30, 0x38, 0x2A};
constexpr Rgba8 kInk{0x26, 0x26, 0x2B, 255}, kSoftInk{0x55, 0x55, 0x5C, 255};

Rgba8 opaque(const sim::Rgb8& colour) {
    return {colour[0], colour[1], colour[2], 255};
}

std::string left_out(const Legend& legend, std::size_t rows) {
    return "and " + std::to_string(legend.rows.size() - rows + 1) + " more";
}

float width_of(const Legend& legend, const std::string& text) {
    return legend.font ? kEm * legend.font->text_width(text) : static_cast<float>(text_width(text));
}

float value_width(const Legend& legend, const std::string& figure) {
    return figure.empty() ? 0 : 2 * kGap + width_of(legend, figure);
}

float inner_width(const Legend& legend) {
    float width = width_of(legend, legend.title);
    for (const LegendRow& row : legend.rows) {
        width = std::max(width, kSwatch + kGap + width_of(legend, row.label) + value_width(legend, row.figure));
    }
    for (const auto& [name, figure] : legend.notes)
        width = std::max(width, width_of(legend, name) + value_width(legend, figure));
    return legend.scale ? std::max(width, static_cast<float>(kBarWidth)) : width;
}

bool is_continuation_byte(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

// Without its last letter. Pre: the text is not empty.
void shorten(std::string& text) {
    while (text.size() > 1 && is_continuation_byte(text.back())) text.pop_back();
    text.pop_back();
}

// With labels cut to kMinLetters.
float min_width(const Legend& legend) {
    Legend cut = legend;
    const auto letters = [](const std::string& text) {
        return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, is_continuation_byte));
    };
    for (LegendRow& row : cut.rows) {
        while (letters(row.label) > kMinLetters) shorten(row.label);
    }
    return inner_width(cut);
}

int inner_height(const Legend& legend, std::size_t rows) {
    int height = kTitle + static_cast<int>(rows) * kRow + (legend.scale ? kBarRow : 0);
    if (!legend.notes.empty()) height += kBetween + static_cast<int>(legend.notes.size()) * kRow;
    return height - (kRow - kSwatch);
}

PixelBox in_corner(int width, int height, int margin, Corner corner, int width_px, int height_px) {
    const bool is_left = corner == Corner::LowerLeft || corner == Corner::UpperLeft;
    const bool is_low = corner == Corner::LowerLeft || corner == Corner::LowerRight;
    return {.left = is_left ? margin : width_px - margin - width,
            .top = is_low ? height_px - margin - height : margin,
            .width = width,
            .height = height};
}

// As much of the text as fits, followed by two dots if it was cut.
std::string shortened(const Legend& legend, const std::string& text, float room) {
    constexpr float kRounding = 0.01F;
    if (width_of(legend, text) <= room + kRounding) return text;
    std::string kept = text;
    while (!kept.empty() && width_of(legend, kept + "..") > room) shorten(kept);
    return kept + "..";
}

int whole(float px) {
    return static_cast<int>(std::lround(px));
}

// Draws from the top down; coordinates are in font pixels.
class Pen {
 public:
    Pen(Image& image, const Legend& legend, const LegendLayout& layout)
        : image_(image), legend_(legend), box_(layout.box), scale_(layout.scale) {}

    float inner() const { return static_cast<float>(box_.width) / scale_ - 2 * kPadding; }
    int inner_px() const { return left(inner()) - left(0); }
    void down(int by) { y_ += by; }

    void box(float x, int y, float width, int height, const Rgba8& colour) const {
        fill_box(image_, {left(x), top(y), left(x + width) - left(x), top(y + height) - top(y)}, colour);
    }
    void column(int x_px, int height, const Rgba8& colour) const {
        fill_box(image_, {left(0) + x_px, top(0), 1, top(height) - top(0)}, colour);
    }
    // (x, y): the upper left of the first capital letter.
    void text(float x, int y, const std::string& line, const Rgba8& colour) const {
        if (!legend_.font) {
            draw_text(image_, left(x), top(y), line, {.scale = whole(scale_), .colour = colour});
            return;
        }
        const float feet = static_cast<float>(y) + 0.5F * (kCapital + kEm * legend_.font->capital_height());
        legend_.font->draw(
            image_, line, {.left_px = left_px(x), .baseline_px = top(feet), .size_px = kEm * scale_, .colour = colour});
    }
    void text_at_right(int y, const std::string& line, const Rgba8& colour) const {
        text(inner() - width_of(legend_, line), y, line, colour);
    }

 private:
    float left_px(float x) const { return static_cast<float>(box_.left) + (kPadding + x) * scale_; }
    int left(float x) const { return whole(left_px(x)); }
    int top(float y) const { return box_.top + whole((static_cast<float>(y_) + y) * scale_); }
    int top(int y) const { return top(static_cast<float>(y)); }

    Image& image_;
    const Legend& legend_;
    PixelBox box_;
    float scale_;
    int y_ = kPadding;
};

void draw_rows(Pen& pen, const Legend& legend, std::size_t rows) {
    for (std::size_t i = 0; i < rows; ++i) {
        const bool is_last = i + 1 == rows && rows < legend.rows.size();
        if (is_last) {
            pen.text(kSwatch + kGap, 1, left_out(legend, rows), kSoftInk);
        } else {
            pen.box(0, 0, kSwatch, kSwatch, opaque(legend.rows[i].colour));
            const float room = pen.inner() - kSwatch - kGap - value_width(legend, legend.rows[i].figure);
            pen.text(kSwatch + kGap, 1, shortened(legend, legend.rows[i].label, room), kInk);
            pen.text_at_right(1, legend.rows[i].figure, kSoftInk);
        }
        pen.down(kRow);
    }
}

void draw_scale(Pen& pen, const Legend& legend, const LegendScale& scale) {
    const float width = pen.inner();
    const int width_px = pen.inner_px();
    for (int x = 0; x < width_px; ++x) {
        const auto last = static_cast<float>(scale.map.size() - 1);
        const auto at = static_cast<std::size_t>(std::lround(float(x) / float(std::max(width_px - 1, 1)) * last));
        pen.column(x, kBarHeight, opaque(scale.map[at]));
    }
    for (const LegendScale::Tick& tick : scale.ticks) {
        const float x = std::round(tick.place * (width - 1));
        pen.box(x, kBarHeight, 1, 2, kSoftInk);
        const float room = width_of(legend, tick.label);
        pen.text(std::clamp(x - std::floor(room / 2), 0.0F, width - room), kBarHeight + 4, tick.label, kInk);
    }
    pen.down(kBarRow);
}

// The legend's place at this scale, or nullopt. Rows that do not fit are left out. Long names are cut at scale 1 only.
std::optional<LegendLayout> place_at_scale(const Legend& legend, float scale, int width_px, int height_px,
                                           Corner corner) {
    const auto outer_px = [&](float inner) { return static_cast<int>(std::ceil((inner + 2 * kPadding) * scale)); };
    int width = outer_px(inner_width(legend));
    if (scale <= 1) width = std::min(width, std::max(outer_px(min_width(legend)), width_px / 2));
    const auto height_of = [&](std::size_t rows) { return outer_px(static_cast<float>(inner_height(legend, rows))); };
    const int max_height = height_px * 3 / 4;
    std::size_t rows = legend.rows.size();
    while (rows > 0 && height_of(rows) > max_height) --rows;
    const bool shows_too_little = rows < std::min<std::size_t>(legend.rows.size(), 2);
    if (width > width_px / 2 || shows_too_little || height_of(rows) > max_height) return std::nullopt;
    return LegendLayout{.box = in_corner(width, height_of(rows), whole(kMargin * scale), corner, width_px, height_px),
                        .scale = scale,
                        .rows = rows};
}

}  // namespace

std::optional<LegendLayout> place_legend(const Legend& legend, int width_px, int height_px, Corner corner) {
    const float step = legend.font ? 0.25F : 1;
    const float largest = std::floor(static_cast<float>(std::min(width_px, height_px)) / 512 / step) * step;
    for (float scale = std::max(1.0F, largest); scale >= 1; scale -= step) {
        const auto place = place_at_scale(legend, scale, width_px, height_px, corner);
        if (place) return place;
    }
    return std::nullopt;
}

void draw_legend(Image& image, const Legend& legend, Corner corner) {
    const std::optional<LegendLayout> place = place_legend(legend, image.width_px, image.height_px, corner);
    if (!place) return;
    const PixelBox& box = place->box;
    const int rim = whole(place->scale);
    fill_rounded(image, {box.left - rim, box.top - rim, box.width + 2 * rim, box.height + 2 * rim},
                 whole((kRadius + 1) * place->scale), kRim);
    fill_rounded(image, box, whole(kRadius * place->scale), kPaper);
    Pen pen(image, legend, *place);
    pen.text(0, 0, legend.title, kInk);
    pen.down(kTitle);
    draw_rows(pen, legend, place->rows);
    if (legend.scale) draw_scale(pen, legend, *legend.scale);
    if (!legend.notes.empty()) pen.down(kBetween);
    for (const auto& [name, figure] : legend.notes) {
        pen.text(0, 0, name, kSoftInk);
        pen.text_at_right(0, figure, kInk);
        pen.down(kRow);
    }
}

namespace {

// px from the upper left; far outside the picture for points behind the eye.
Vec2f on_picture(const Eigen::Matrix4f& matrix, const Vec3f& point, const PictureSize& size) {
    const Eigen::Vector4f clip = matrix * point.homogeneous();
    if (clip.w() <= 0) return {-1e6F, -1e6F};
    return {(0.5F + 0.5F * clip.x() / clip.w()) * float(size.width_px),
            (0.5F - 0.5F * clip.y() / clip.w()) * float(size.height_px)};
}

// Number of triangles whose bounding box on the screen overlaps the legend's box.
long count_under(const PixelBox& legend, const Eigen::Matrix4f& matrix, const PictureSize& size,
                 const std::vector<Vec3f>& x, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::vector<Vec2f> at;
    at.reserve(x.size());
    for (const Vec3f& point : x) at.push_back(on_picture(matrix, point, size));
    const Vec2f low(float(legend.left), float(legend.top));
    const Vec2f high(float(legend.left + legend.width), float(legend.top + legend.height));
    return std::count_if(triangles.begin(), triangles.end(), [&](const auto& t) {
        const Vec2f least = at[t[0]].cwiseMin(at[t[1]]).cwiseMin(at[t[2]]);
        const Vec2f most = at[t[0]].cwiseMax(at[t[1]]).cwiseMax(at[t[2]]);
        return (least.array() < high.array()).all() && (most.array() > low.array()).all();
    });
}

// Numbers of triangles under the legend, summed over all turns.
struct Cover {
    long cloth = 0;
    long body = 0;
};
Cover cover_of(const PixelBox& legend, const Camera& camera, const LegendSubject& subject, const PictureSize& size) {
    Cover cover;
    for (const float angle : subject.turns) {
        const Eigen::Matrix4f matrix =
            projection_matrix(camera, size.aspect()) * view_matrix(turned(camera, angle, subject.axis));
        for (const ClothItem& cloth : subject.scene.cloths)
            cover.cloth += count_under(legend, matrix, size, cloth.mesh.x, cloth.mesh.triangles);
        for (const BodyItem& body : subject.scene.bodies)
            cover.body += count_under(legend, matrix, size, body.x, body.triangles);
    }
    return cover;
}

// A camera and the legend's corner.
struct Candidate {
    LegendPlace place;
    long hidden = std::numeric_limits<long>::max();  // triangles under the legend that belong to the framed subject
    float pixel_size = 0;                            // m
    long beside = 0;                                 // other triangles under the legend

    auto cost() const { return std::tuple(hidden, pixel_size, beside); }
};

// Frames with a free strip for the legend at the left or at the bottom, and frames with a wider margin.
std::vector<SubjectFrame> with_room(const SubjectFrame& frame, const LegendLayout& legend, const PictureSize& size) {
    const float edge = 8 * legend.scale;
    const float right = float(legend.box.left + legend.box.width) + edge;
    const float top = float(size.height_px - legend.box.top) + edge;
    const float margin = frame.options.margin / 2;  // already free on each side
    std::vector<SubjectFrame> frames{frame, frame};
    frames[0].options.free_left = std::max(right / float(size.width_px) - margin, 0.0F);
    frames[1].options.free_below = std::max(top / float(size.height_px) - margin, 0.0F);
    for (const float more : {0.08F, 0.16F, 0.24F, 0.32F}) {
        frames.push_back(frame);
        frames.back().options.margin += more;
    }
    return frames;
}

// Enlarged, because marks extend beyond the cloth.
PixelBox with_edge(const LegendLayout& place) {
    const int edge = whole(6 * place.scale);
    return {place.box.left - edge, place.box.top - edge, place.box.width + 2 * edge, place.box.height + 2 * edge};
}

}  // namespace

LegendPlace find_legend_place(const Legend& legend, const LegendSubject& subject, const PictureSize& size) {
    const SubjectFrame& frame = subject.frame;
    Candidate best{.place = {.camera = subject.scene.camera}};
    const auto try_corners = [&](const Camera& tried) {
        for (const Corner corner : {Corner::LowerLeft, Corner::LowerRight, Corner::UpperLeft, Corner::UpperRight}) {
            const auto place = place_legend(legend, size.width_px, size.height_px, corner);
            if (!place) return;
            const auto [cloth, body] = cover_of(with_edge(*place), tried, subject, size);
            const Candidate candidate{.place = {.camera = tried, .corner = corner},
                                      .hidden = cloth + (frame.holds_bodies ? body : 0),
                                      .pixel_size = pixel_size(tried, size.height_px),
                                      .beside = frame.holds_bodies ? 0 : body};
            if (candidate.cost() < best.cost()) best = candidate;
        }
    };
    try_corners(subject.scene.camera);
    const auto place = place_legend(legend, size.width_px, size.height_px, Corner::LowerLeft);
    if (best.hidden == 0 || !place || !frame.may_move) return best.place;
    for (const SubjectFrame& roomy : with_room(frame, *place, size)) try_corners(roomy.camera());
    return best.place;
}

}  // namespace selvedge::render
