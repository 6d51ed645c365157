#include "sim/print/nesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>

#include "sim/core/error.h"
#include "sim/core/printable.h"

namespace selvedge::sim {
namespace {

// ---- Shapes on a raster.

// The cells of one row that a shape covers, first and last.
struct Run {
    int from = 0;
    int to = 0;
};

struct Mask {
    int width = 0;                       // cells
    std::vector<std::vector<Run>> rows;  // from the bottom
};

// All cells that the shape touches; its box begins at the raster's origin.
class MaskMaker {
 public:
    MaskMaker(const std::vector<Vec2d>& outline, double cell) : outline_(outline), cell_(cell) {
        Eigen::AlignedBox2d box;
        for (const Vec2d& p : outline) box.extend(p);
        origin_ = box.min();
        width_ = cells(box.sizes().x()) + 1;
        height_ = cells(box.sizes().y()) + 1;
        covered_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), false);
    }

    // Grown by a margin on all sides, in cells; the raster's origin then lies `margin` cells further inside.
    Mask make(int margin) {
        draw_boundary();
        fill();
        grow(margin);
        Mask mask{.width = width_, .rows = std::vector<std::vector<Run>>(static_cast<std::size_t>(height_))};
        for (int y = 0; y < height_; ++y) {
            std::vector<Run>& row = mask.rows[static_cast<std::size_t>(y)];
            for (int x = 0; x < width_; ++x) {
                if (!covered_[index(x, y)]) continue;
                if (row.empty() || row.back().to + 1 < x) row.push_back({x, x});
                row.back().to = x;
            }
        }
        return mask;
    }

 private:
    int cells(double length) const { return static_cast<int>(std::floor(length / cell_)); }

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    void cover(const Vec2d& p) {
        const Vec2d at = p - origin_;
        covered_[index(std::clamp(cells(at.x()), 0, width_ - 1), std::clamp(cells(at.y()), 0, height_ - 1))] = true;
    }

    void draw_boundary() {
        for (std::size_t i = 0; i < outline_.size(); ++i) {
            const Vec2d from = outline_[i], along = outline_[(i + 1) % outline_.size()] - from;
            const int steps = 1 + 4 * cells(along.norm()) + 4;
            for (int k = 0; k <= steps; ++k) cover(from + along * k / steps);
        }
    }

    // Cells whose middle lies inside, row by row.
    void fill() {
        std::vector<double> crossings;
        for (int y = 0; y < height_; ++y) {
            const double level = origin_.y() + (y + 0.5) * cell_;
            crossings.clear();
            for (std::size_t i = 0; i < outline_.size(); ++i) {
                const Vec2d &a = outline_[i], &b = outline_[(i + 1) % outline_.size()];
                if ((a.y() > level) == (b.y() > level)) continue;
                crossings.push_back(a.x() + (b.x() - a.x()) * (level - a.y()) / (b.y() - a.y()) - origin_.x());
            }
            std::ranges::sort(crossings);
            for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
                const int first = std::max(0, cells(crossings[k])),
                          last = std::min(width_ - 1, cells(crossings[k + 1]));
                for (int x = first; x <= last; ++x) covered_[index(x, y)] = true;
            }
        }
    }

    void grow(int margin) {
        const std::vector<bool> core = covered_;
        const int core_width = width_, core_height = height_;
        width_ += 2 * margin;
        height_ += 2 * margin;
        covered_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), false);
        std::vector<int> reach;  // half width of the disc per row
        for (int dy = -margin; dy <= margin; ++dy)
            reach.push_back(static_cast<int>(std::floor(std::sqrt(double(margin * margin - dy * dy)))));
        for (int y = 0; y < core_height; ++y) {
            for (int x = 0; x < core_width; ++x) {
                const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(core_width);
                if (!core[at + static_cast<std::size_t>(x)]) continue;
                const bool is_inner = x > 0 && x + 1 < core_width && core[at + static_cast<std::size_t>(x) - 1] &&
                                      core[at + static_cast<std::size_t>(x) + 1] && y > 0 && y + 1 < core_height &&
                                      core[at + static_cast<std::size_t>(x + core_width)] &&
                                      core[at + static_cast<std::size_t>(x) - static_cast<std::size_t>(core_width)];
                for (int dy = is_inner ? 0 : -margin; dy <= (is_inner ? 0 : margin); ++dy) {
                    const int half = is_inner ? 0 : reach[static_cast<std::size_t>(dy + margin)];
                    for (int dx = -half; dx <= half; ++dx) covered_[index(x + margin + dx, y + margin + dy)] = true;
                }
            }
        }
    }

    const std::vector<Vec2d>& outline_;
    double cell_;
    Vec2d origin_ = Vec2d::Zero();
    int width_ = 0;
    int height_ = 0;
    std::vector<bool> covered_;
};

// ---- The strip.

// For each cell of a row, the last covered cell at or before it; -1: none.
class Strip {
 public:
    explicit Strip(int width) : width_(width) {}

    // The last covered cell that a mask would meet at (x, y), as the x from which on it no longer meets it; none: free.
    // Adds the number of rows to `work`.
    std::optional<int> blocked_until(const Mask& mask, int x, int y, std::uint64_t& work) const {
        const std::size_t count = mask.rows.size();
        for (const std::size_t start : {std::size_t{0}, std::size_t{3}, std::size_t{1}, std::size_t{5}, std::size_t{2},
                                        std::size_t{7}, std::size_t{4}, std::size_t{6}}) {
            for (std::size_t r = start; r < count; r += 8) {  // far rows first: they tell sooner
                const int row = y + static_cast<int>(r);
                ++work;
                if (row < 0 || static_cast<std::size_t>(row) >= last_.size()) continue;
                for (const Run& run : mask.rows[r]) {
                    const int from = std::max(0, x + run.from), to = std::min(width_ - 1, x + run.to);
                    if (to < from) continue;
                    const int last = last_[static_cast<std::size_t>(row)][static_cast<std::size_t>(to)];
                    if (last >= from) return last - run.from + 1;
                }
            }
        }
        return std::nullopt;
    }

    void put(const Mask& mask, int x, int y) {
        const int top = y + static_cast<int>(mask.rows.size());
        const std::vector<int> none(static_cast<std::size_t>(width_), -1);
        if (top > 0 && static_cast<std::size_t>(top) > last_.size()) last_.resize(static_cast<std::size_t>(top), none);
        for (std::size_t r = 0; r < mask.rows.size(); ++r) {
            const int row = y + static_cast<int>(r);
            if (row < 0) continue;
            std::vector<int>& last = last_[static_cast<std::size_t>(row)];
            for (const Run& run : mask.rows[r]) {
                for (int c = std::max(0, x + run.from); c <= std::min(width_ - 1, x + run.to); ++c)
                    last[static_cast<std::size_t>(c)] = c;
            }
            for (std::size_t c = 1; c < last.size(); ++c) last[c] = std::max(last[c], last[c - 1]);
        }
    }

    int rows() const { return static_cast<int>(last_.size()); }

 private:
    int width_;
    std::vector<std::vector<int>> last_;
};

// ---- Placing.

// An item in one of its turns.
struct Shape {
    double turn = 0;
    Vec2d corner = Vec2d::Zero();  // m, of the turned outline's box
    Vec2d size = Vec2d::Zero();    // m
    Mask core = {};                // what it covers
    Mask grown = {};               // with the gap
};

bool are_alike(const NestItem& one, const NestItem& other) {
    return one.outline == other.outline && one.turns == other.turns && one.repeat == other.repeat &&
           one.phase == other.phase && one.axis_at == other.axis_at;
}

struct Spot {
    int x = 0, y = 0;  // cells
    Vec2d shift = Vec2d::Zero();
    double top = std::numeric_limits<double>::infinity();
};

class Nester {
 public:
    Nester(const std::vector<NestItem>& items, const NestOptions& options) : items_(items), options_(options) {
        // Shapes on a lattice are rounded to the raster, by half a cell at most.
        margin_ = static_cast<int>(std::ceil(options.gap / options.cell));
        for (const NestItem& item : items) {
            std::size_t kind = 0;
            while (kind < kinds_.size() && !are_alike(items[kinds_[kind]], item)) ++kind;
            if (kind == kinds_.size()) {
                kinds_.push_back(static_cast<std::size_t>(&item - items.data()));
                shapes_.push_back(shapes_of(item));
            }
            kind_.push_back(kind);
        }
    }

    // What takes too long ends the search with the best so far.
    Nest run() {
        Nest best;
        best.length = std::numeric_limits<double>::infinity();
        for (int k = 0; k < std::max(1, options_.orders); ++k) {
            const std::optional<Nest> nest = place(order(k));
            if (!nest) break;
            if (nest->length < best.length - 1e-9) best = *nest;
        }
        if (best.places.empty())
            throw InputError("", "", count_text(items_.size(), "piece") + " are more than can be laid out together");
        best.work = work_;
        return best;
    }

 private:
    std::vector<Shape> shapes_of(const NestItem& item) const {
        std::vector<Shape> shapes;
        for (const double turn : item.turns) {
            Shape shape{.turn = turn};
            std::vector<Vec2d> outline;
            Eigen::AlignedBox2d box;
            for (const Vec2d& p : item.outline) {
                outline.push_back(Eigen::Rotation2Dd(turn) * p);
                box.extend(outline.back());
            }
            shape.corner = box.min();
            shape.size = box.sizes();
            if (shape.size.x() > options_.width + 1e-9) continue;
            shape.core = MaskMaker(outline, options_.cell).make(item.repeat ? 1 : 0);
            shape.grown = MaskMaker(outline, options_.cell).make(margin_ + (item.repeat ? 1 : 0));
            shapes.push_back(std::move(shape));
        }
        if (shapes.empty()) {
            std::array<char, 96> text{};
            std::snprintf(text.data(), text.size(), "wider than the %.4g cm that there are", 100 * options_.width);
            throw InputError("", item.name, text.data());
        }
        return shapes;
    }

    // Large ones first, by area, height or width; then the same with some exchanged.
    std::vector<std::size_t> order(int k) const {
        std::vector<std::size_t> indices(items_.size());
        std::iota(indices.begin(), indices.end(), std::size_t{0});
        const auto merit = [&](std::size_t i) {
            const Vec2d size = shapes_[kind_[i]].front().size;
            return k % 3 == 0 ? -size.prod() : k % 3 == 1 ? -size.y() : -size.x();
        };
        std::ranges::stable_sort(indices, {}, merit);
        std::uint32_t state = 0x9E3779B9U * static_cast<std::uint32_t>(k / 3 + 1);
        for (int swaps = 0; swaps < k / 3 && indices.size() > 1; ++swaps) {
            state = state * 1664525U + 1013904223U;  // linear congruential generator (Knuth 1997, 3.3.4)
            const std::size_t at = (state >> 8U) % (indices.size() - 1);
            std::swap(indices[at], indices[at + 1]);
        }
        return indices;
    }

    // None: the search has taken too long.
    std::optional<Nest> place(const std::vector<std::size_t>& order) {
        Strip strip(static_cast<int>(std::floor(options_.width / options_.cell + 1e-9)));
        Nest nest;
        nest.places.resize(items_.size());
        std::map<const Shape*, Spot> last;  // what is alike finds no place before the last one
        for (const std::size_t i : order) {
            Spot best;
            const Shape* chosen = nullptr;
            for (const Shape& shape : shapes_[kind_[i]]) {
                const Spot spot = items_[i].repeat ? lattice_spot(items_[i], shape, strip)
                                                   : free_spot(items_[i], shape, strip, last[&shape]);
                if (work_ > options_.most_work) return std::nullopt;
                last[&shape] = spot;
                if (spot.top < best.top - 1e-9) best = spot, chosen = &shape;
            }
            if (!chosen) throw InputError("", items_[i].name, "no place on the width that keeps to the sett");
            strip.put(chosen->core, best.x - (items_[i].repeat ? 1 : 0), best.y - (items_[i].repeat ? 1 : 0));
            nest.places[i] = {chosen->turn, best.shift};
            nest.length = std::max(nest.length, best.top);
        }
        return nest;
    }

    // The lowest free place on the raster, then the leftmost, from `from` on.
    Spot free_spot(const NestItem& item, const Shape& shape, const Strip& strip, const Spot& from) {
        const double cell = options_.cell;
        const int columns = item.axis_at ? 1 : static_cast<int>((options_.width - shape.size.x()) / cell + 1e-9) + 1;
        for (int y = from.y; y <= strip.rows() + margin_ && work_ <= options_.most_work; ++y) {
            int x = y == from.y ? from.x : 0;
            while (x < columns) {
                const auto next = strip.blocked_until(shape.grown, x - margin_, y - margin_, work_);
                if (!next) {
                    const Vec2d corner(item.axis_at ? shape.corner.x() - *item.axis_at : x * cell, y * cell);
                    return {x, y, corner - shape.corner, corner.y() + shape.size.y()};
                }
                x = *next + margin_;
            }
        }
        return {};
    }

    // The lowest free place of those that keep the phase.
    Spot lattice_spot(const NestItem& item, const Shape& shape, const Strip& strip) {
        const double cell = options_.cell;
        const Vec2d repeat = *item.repeat;
        const auto first = [&](Eigen::Index axis) {  // the first corner that is not negative
            const double at = shape.corner[axis] + item.phase[axis];
            return at - repeat[axis] * std::floor(at / repeat[axis] + 1e-9);
        };
        const double most = (strip.rows() + margin_ + 2) * cell + repeat.y();
        for (double y = first(1); y <= most && work_ <= options_.most_work; y += repeat.y()) {
            for (double x = first(0); x + shape.size.x() <= options_.width + 1e-9; x += repeat.x()) {
                const int cx = static_cast<int>(std::lround(x / cell)), cy = static_cast<int>(std::lround(y / cell));
                if (strip.blocked_until(shape.grown, cx - margin_ - 1, cy - margin_ - 1, work_)) continue;
                return {cx, cy, Vec2d(x, y) - shape.corner, y + shape.size.y()};
            }
        }
        return {};
    }

    const std::vector<NestItem>& items_;
    const NestOptions& options_;
    int margin_ = 0;                          // cells
    std::vector<std::size_t> kinds_;          // an item of each kind: items of one kind are alike
    std::vector<std::size_t> kind_;           // of each item
    std::vector<std::vector<Shape>> shapes_;  // of each kind
    std::uint64_t work_ = 0;                  // rows compared so far
};

}  // namespace

Nest nest(const std::vector<NestItem>& items, const NestOptions& options) {
    if (items.empty()) return {};
    return Nester(items, options).run();
}

}  // namespace selvedge::sim
