#include "sim/paper/page_grid_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "sim/paper/curve_pieces.h"
#include "sim/paper/page_labels.h"

namespace selvedge::sim {
namespace {

// Where a line of a page meets a border of its cell.
struct BorderCrossing {
    double at = 0;     // mm, along the border
    double angle = 0;  // rad, of the line, 0 to pi
};

using CellGuess = std::pair<double, double>;  // the lower and the upper border, mm

double angle_between(double a, double b) {
    const double off = std::abs(a - b);
    return std::min(off, std::numbers::pi - off);
}

int count_matches(std::vector<BorderCrossing> ours, const std::vector<BorderCrossing>& theirs) {
    constexpr double kNear = 1.2;    // mm: a pen's width, and what paper and print give
    constexpr double kAngle = 0.35;  // rad
    int matched = 0;
    for (const BorderCrossing& one : theirs) {
        const auto fits = [&](const BorderCrossing& other) {
            return std::abs(other.at - one.at) < kNear && angle_between(other.angle, one.angle) < kAngle;
        };
        const auto found = std::ranges::find_if(ours, fits);
        if (found == ours.end()) continue;
        ours.erase(found);
        ++matched;
    }
    return matched;
}

class GridFitter {
 public:
    GridFitter(const std::vector<const TilePage*>& pages, const std::vector<std::vector<bool>>& is_furniture)
        : pages_(pages), is_furniture_(is_furniture) {
        for (std::size_t p = 0; p < pages.size(); ++p) add_lines(p);
    }

    std::optional<GridFit> fit() {
        std::optional<GridFit> best;
        double most = 0;
        for (const std::vector<std::pair<int, int>>& places : arrangements()) {
            GridFit fit{.places = places};
            if (!choose_cell(0, fit) || !choose_cell(1, fit)) continue;
            const double score = score_of(fit.matched, fit.unmatched);
            constexpr double kBetter = 1.05;  // the first, which labels tell, wins where another is hardly better
            if (score <= kBetter * most) continue;
            most = score;
            best = std::move(fit);
        }
        if (best && best->matched <= best->unmatched) return std::nullopt;
        return best;
    }

 private:
    static double score_of(int matched, int unmatched) { return matched - 0.5 * unmatched; }

    // ---- What crosses a border.

    void add_lines(std::size_t p) {
        std::vector<std::vector<Vec2d>>& lines = lines_.emplace_back();
        const TilePage& page = *pages_[p];
        for (std::size_t s = 0; s < page.shapes.size(); ++s) {
            if (is_furniture_[p][s] || page.shapes[s].plain.is_filled_only) continue;
            for (const CurvePiece& piece : pieces_of(page.shapes[s].plain.path)) {
                constexpr int kSteps = 24;
                std::vector<Vec2d>& line = lines.emplace_back();
                const int steps = piece.is_line ? 1 : kSteps;
                for (int i = 0; i <= steps; ++i) line.push_back(piece.at(i / static_cast<double>(steps)));
            }
        }
    }

    // Lines are met a little within the cell, because they may end at its border, and carried on to it.
    const std::vector<BorderCrossing>& crossings(std::size_t p, Eigen::Index axis, double border, bool is_upper) {
        const auto key = std::make_tuple(p, axis, border, is_upper);
        if (const auto known = crossings_.find(key); known != crossings_.end()) return known->second;
        constexpr double kWithin = 0.5;  // mm
        const double at = is_upper ? border - kWithin : border + kWithin;
        std::vector<BorderCrossing> found;
        for (const std::vector<Vec2d>& line : lines_[p]) {
            for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                const Vec2d &a = line[i], &b = line[i + 1];
                if ((a[axis] < at) == (b[axis] < at)) continue;
                const double steep = (b[1 - axis] - a[1 - axis]) / (b[axis] - a[axis]);
                constexpr double kFlattest = 6;  // lines along the border are its own
                if (std::abs(steep) > kFlattest) continue;
                const double where = a[1 - axis] + steep * (border - a[axis]);
                found.push_back({where, std::atan(steep) + std::numbers::pi / 2});
            }
        }
        std::ranges::sort(found, {}, &BorderCrossing::at);
        return crossings_[key] = std::move(found);
    }

    // ---- Where pages lie.

    std::vector<std::vector<std::pair<int, int>>> arrangements() const {
        std::vector<std::vector<std::pair<int, int>>> all;
        std::vector<const std::vector<PdfText>*> texts;
        for (const TilePage* page : pages_) texts.push_back(&page->texts);
        if (const std::vector<std::pair<int, int>> labels = page_labels(texts); !labels.empty()) {
            for (const bool is_column_first : {true, false}) {
                for (const bool is_downward : {true, false}) {
                    std::vector<std::pair<int, int>>& places = all.emplace_back();
                    for (const auto& [first, second] : labels) {
                        const int column = is_column_first ? first : second, row = is_column_first ? second : first;
                        places.emplace_back(column, is_downward ? -row : row);
                    }
                }
            }
        }
        const int count = static_cast<int>(pages_.size());
        for (int width = count; width >= 1; --width) {
            for (const bool is_by_rows : {true, false}) {
                for (const bool is_downward : {true, false}) {
                    std::vector<std::pair<int, int>>& places = all.emplace_back();
                    for (int i = 0; i < count; ++i) {
                        const int column = is_by_rows ? i % width : i / width, row = is_by_rows ? i / width : i % width;
                        places.emplace_back(column, is_downward ? -row : row);
                    }
                }
            }
        }
        return all;
    }

    // ---- Where borders lie.

    // Of one axis: what recurring lines, rectangles and marks tell, the clipping, and the edges of the page.
    std::vector<CellGuess> guesses(Eigen::Index axis) const {
        std::set<double> low, high;
        const TilePage& page = *pages_.front();
        const double size = page.size[axis];
        const auto add = [&](double value) {
            constexpr double kSide = 0.35;  // of the page: borders lie near its edges
            const double rounded = std::round(100 * value) / 100;
            if (value < kSide * size) low.insert(rounded);
            if (value > (1 - kSide) * size) high.insert(rounded);
        };
        add(0), add(size);
        for (std::size_t p = 0; p < pages_.size(); ++p) {
            for (std::size_t s = 0; s < pages_[p]->shapes.size(); ++s) {
                const TileShape& shape = pages_[p]->shapes[s];
                if (shape.seen.sizes()[axis] < size - 0.5) add(shape.seen.min()[axis]), add(shape.seen.max()[axis]);
                if (!is_furniture_[p][s]) continue;
                const Vec2d extent = shape.box.sizes();
                constexpr double kLong = 0.5;  // of the page
                if (extent[1 - axis] > kLong * pages_[p]->size[1 - axis])
                    add(shape.box.min()[axis]), add(shape.box.max()[axis]);
                constexpr double kMark = 30;  // mm
                if (extent.maxCoeff() < kMark) {
                    add(shape.box.center()[axis]);
                    add(shape.box.min()[axis]), add(shape.box.max()[axis]);
                }
            }
            if (low.size() > kMostGuesses || high.size() > kMostGuesses) break;
        }
        std::vector<CellGuess> all;
        for (const double a : low) {
            for (const double b : high) all.emplace_back(a, b);
        }
        return all;
    }

    static constexpr std::size_t kMostGuesses = 24;  // on each side

    // Whether small shapes of the print, drawn near the upper and the lower border, lie on each other in this grid.
    bool do_marks_meet(Eigen::Index axis, const CellGuess& guess) const {
        constexpr double kMark = 30, kSame = 0.5;  // mm
        Vec2d pitch = Vec2d::Zero();
        pitch[axis] = guess.second - guess.first;
        std::vector<const TileShape*> marks;
        for (std::size_t p = 0; p < pages_.size() && marks.size() < 200; ++p) {
            for (std::size_t s = 0; s < pages_[p]->shapes.size(); ++s) {
                const TileShape& shape = pages_[p]->shapes[s];
                if (is_furniture_[p][s] && shape.box.sizes().maxCoeff() < kMark) marks.push_back(&shape);
            }
        }
        return std::ranges::any_of(marks, [&](const TileShape* low) {
            return std::ranges::any_of(marks, [&](const TileShape* high) {
                return (low->box.min() + pitch - high->box.min()).norm() < kSame &&
                       (low->box.max() + pitch - high->box.max()).norm() < kSame;
            });
        });
    }

    // Takes the borders across which most lines go on. False: the grid has no neighbours there, and any will do.
    bool choose_cell(Eigen::Index axis, GridFit& fit) {
        std::map<std::pair<int, int>, std::size_t> at;
        for (std::size_t p = 0; p < fit.places.size(); ++p) at[fit.places[p]] = p;
        if (at.size() != fit.places.size()) return false;
        std::vector<std::pair<std::size_t, std::size_t>> neighbours;  // lower first
        for (const auto& [place, p] : at) {
            const auto next = at.find(axis == 0 ? std::make_pair(place.first + 1, place.second)
                                                : std::make_pair(place.first, place.second + 1));
            if (next != at.end()) neighbours.emplace_back(p, next->second);
        }
        if (guesses_[static_cast<std::size_t>(axis)].empty()) guesses_[static_cast<std::size_t>(axis)] = guesses(axis);
        double most = -1e9;
        int matched = 0, unmatched = 0;
        CellGuess best = {0, pages_.front()->size[axis]};
        for (const CellGuess& guess : guesses_[static_cast<std::size_t>(axis)]) {
            int good = 0, all = 0;
            for (const auto& [low, high] : neighbours) {
                const auto& ours = crossings(low, axis, guess.second, true);
                const auto& theirs = crossings(high, axis, guess.first, false);
                const int same = count_matches(ours, theirs);
                good += same;
                all += static_cast<int>(ours.size() + theirs.size()) - 2 * same;
            }
            // Level lines go on wherever the borders are: marks that meet decide, then the widest cell.
            constexpr double kMeeting = 0.4, kWide = 1e-6;
            const double score = score_of(good, all) + (do_marks_meet(axis, guess) ? kMeeting : 0) +
                                 kWide * (guess.second - guess.first);
            if (score <= most) continue;
            most = score;
            best = guess;
            matched = good;
            unmatched = all;
        }
        if (fit.cell.isEmpty()) fit.cell = Eigen::AlignedBox2d(Vec2d::Zero(), pages_.front()->size);
        fit.cell.min()[axis] = best.first;
        fit.cell.max()[axis] = best.second;
        fit.matched += matched;
        fit.unmatched += unmatched;
        return true;
    }

    const std::vector<const TilePage*>& pages_;
    const std::vector<std::vector<bool>>& is_furniture_;
    std::vector<std::vector<std::vector<Vec2d>>> lines_;  // per page
    std::map<std::tuple<std::size_t, Eigen::Index, double, bool>, std::vector<BorderCrossing>> crossings_;
    std::array<std::vector<CellGuess>, 2> guesses_;
};

}  // namespace

std::optional<GridFit> fit_page_grid(const std::vector<const TilePage*>& pages,
                                     const std::vector<std::vector<bool>>& is_furniture) {
    constexpr std::size_t kMostPages = 200;
    if (pages.size() < 2 || pages.size() > kMostPages) return std::nullopt;
    return GridFitter(pages, is_furniture).fit();
}

}  // namespace selvedge::sim
