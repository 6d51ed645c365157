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

struct LineEnd {
    Vec2d at = Vec2d::Zero(), along = Vec2d::Zero();
};

// The lower and the upper border, mm.
struct CellGuess {
    double first = 0, second = 0;
    bool is_overlapped = false;  // beyond the upper border, the page shows a strip of its neighbour
    bool do_marks_meet = false;
};
using Borders = std::pair<std::vector<double>, std::vector<double>>;  // lower and upper ones

double angle_between(double a, double b) {
    const double off = std::abs(a - b);
    return std::min(off, std::numbers::pi - off);
}

// Lines that go on across a border, and how far their parts lie apart there, as a share of what is allowed.
struct BorderMatches {
    int count = 0;
    double off = 0;
};
BorderMatches match_crossings(std::vector<BorderCrossing> ours, const std::vector<BorderCrossing>& theirs) {
    constexpr double kNear = 1.2;    // mm: a pen's width, and what paper and print give
    constexpr double kAngle = 0.35;  // rad
    BorderMatches matches;
    for (const BorderCrossing& one : theirs) {
        const auto fits = [&](const BorderCrossing& other) {
            return std::abs(other.at - one.at) < kNear && angle_between(other.angle, one.angle) < kAngle;
        };
        const auto found = std::ranges::find_if(ours, fits);
        if (found == ours.end()) continue;
        matches.off += std::abs(found->at - one.at) / kNear;
        ours.erase(found);
        ++matches.count;
    }
    return matches;
}

class GridFitter {
 public:
    GridFitter(const std::vector<const TilePage*>& pages, const std::vector<std::vector<bool>>& is_furniture)
        : pages_(pages), is_furniture_(is_furniture) {
        for (std::size_t p = 0; p < pages.size(); ++p) add_lines(p);
        borders_ = {find_borders(0), find_borders(1)};
        strips_ = find_strips();
    }

    std::optional<GridFit> fit() {
        std::optional<GridFit> best;
        double most = 0;
        for (const std::vector<std::pair<int, int>>& places : arrangements()) {
            if (work_ > kMostWork) break;
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
    static constexpr std::size_t kMostWork = 60'000'000;  // pairs of lines: some tenths of a second

    static double score_of(int matched, int unmatched) { return matched - 0.5 * unmatched; }

    // ---- What crosses a border.

    void add_lines(std::size_t p) {
        std::vector<std::vector<Vec2d>>& lines = lines_.emplace_back();
        std::vector<LineEnd>& ends = ends_.emplace_back();
        const TilePage& page = *pages_[p];
        for (std::size_t s = 0; s < page.shapes.size(); ++s) {
            if (is_furniture_[p][s] || page.shapes[s].plain.is_filled_only) continue;
            const DrawnPath& path = page.shapes[s].plain.path;
            const std::vector<CurvePiece> pieces = pieces_of(path);
            constexpr std::size_t kMostEnds = 200;  // more are a hatching, or letters
            if (!path.is_closed && ends.size() < kMostEnds) {
                ends.push_back({path.vertices.front(), pieces.front().leaves()});
                ends.push_back({path.vertices.back(), pieces.back().arrives()});
            }
            for (const CurvePiece& piece : pieces) {
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
        constexpr std::size_t kMostCrossings = 200;  // more are a hatching
        if (found.size() > kMostCrossings) found.clear();
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

    // Of one axis: what recurring lines, rectangles and marks tell, the clipping, where many lines end, and the edges
    // of the page; and those borders with neighbours that overlap.
    Borders find_borders(Eigen::Index axis) const {
        std::map<double, int> low, high;  // how often
        const double size = pages_.front()->size[axis];
        const auto add = [&](double value) {
            constexpr double kSide = 0.35, kStep = 0.02;  // of the page: borders lie near its edges; mm
            const double rounded = kStep * std::round(value / kStep);
            if (value < kSide * size) ++low[rounded];
            if (value > (1 - kSide) * size) ++high[rounded];
        };
        for (std::size_t p = 0; p < pages_.size(); ++p) {
            add(0), add(size);
            for (std::size_t s = 0; s < pages_[p]->shapes.size(); ++s) {
                const TileShape& shape = pages_[p]->shapes[s];
                if (shape.seen.sizes()[axis] < size - 0.5) add(shape.seen.min()[axis]), add(shape.seen.max()[axis]);
                if (is_furniture_[p][s]) add_print(shape, axis, add);
            }
            for (const LineEnd& end : ends_[p]) add(end.at[axis]);
        }
        return {most_frequent(low), most_frequent(high)};
    }

    // All borders of an axis with each other, and with each strip that pages may share.
    std::vector<CellGuess> guesses(Eigen::Index axis) {
        const auto& [low, high] = borders_[static_cast<std::size_t>(axis)];
        std::vector<CellGuess> all;
        for (const double a : low) {
            for (const double b : high) {
                all.push_back({a, b, false, do_marks_meet(axis, b - a)});
                for (const double strip : strips_) {
                    if (b - strip > a) all.push_back({a, b - strip, true, do_marks_meet(axis, b - strip - a)});
                }
            }
        }
        return all;
    }

    template <class Add>
    void add_print(const TileShape& shape, Eigen::Index axis, Add add) const {
        constexpr double kLong = 0.5, kMark = 30;  // of the page; mm
        const Vec2d extent = shape.box.sizes();
        const bool is_long = extent[1 - axis] > kLong * pages_.front()->size[1 - axis];
        if (!is_long && extent.maxCoeff() > kMark) return;
        add(shape.box.min()[axis]), add(shape.box.max()[axis]);
        if (!is_long) add(shape.box.center()[axis]);
    }

    static std::vector<double> most_frequent(const std::map<double, int>& counts) {
        constexpr std::size_t kMost = 5;
        constexpr double kShare = 0.3;  // of the most frequent one's
        int most = 0;
        for (const auto& [value, count] : counts) most = std::max(most, count);
        std::vector<std::pair<int, double>> order;
        for (const auto& [value, count] : counts) {
            if (count > kShare * most) order.emplace_back(-count, value);
        }
        std::ranges::sort(order);
        std::vector<double> values;
        for (std::size_t i = 0; i < std::min(kMost, order.size()); ++i) values.push_back(order[i].second);
        return values;
    }

    // Where pages show a strip of their neighbours, a line that ends at the border of one lies within the other: at the
    // same height, as far from the end as the pages lie apart. The widths of such strips that most ends have, mm.
    std::vector<double> find_strips() {
        constexpr double kStep = 0.1, kLeast = 0.7, kMost = 40;  // mm
        std::map<long, std::vector<double>> votes;
        for (const Eigen::Index axis : {Eigen::Index(0), Eigen::Index(1)}) {
            const auto& [low, high] = borders_[static_cast<std::size_t>(axis)];
            for (const double a : low) {
                for (const double b : high) {
                    for (const double pitch : pitches_by_ends(axis, a, b)) {
                        const double strip = b - a - pitch;
                        if (strip > kLeast && strip < kMost) votes[std::lround(strip / kStep)].push_back(strip);
                    }
                }
            }
        }
        std::vector<std::pair<long, double>> order;  // the more votes the first; the middle one of them
        for (const auto& [step, list] : votes) {
            std::vector<double> all = list;
            for (const long beside : {step - 1, step + 1}) {
                if (const auto found = votes.find(beside); found != votes.end())
                    all.insert(all.end(), found->second.begin(), found->second.end());
            }
            std::ranges::sort(all);
            constexpr std::size_t kEnough = 4;
            if (all.size() >= kEnough) order.emplace_back(-static_cast<long>(all.size()), all[all.size() / 2]);
        }
        std::ranges::sort(order);
        constexpr std::size_t kMostStrips = 3;
        std::vector<double> strips;
        for (const auto& one : order) {
            constexpr double kOther = 0.35;  // mm
            const double strip = one.second;
            const bool is_known =
                std::ranges::any_of(strips, [&](double known) { return std::abs(known - strip) < kOther; });
            if (!is_known && strips.size() < kMostStrips) strips.push_back(strip);
        }
        return strips;
    }

    std::vector<double> pitches_by_ends(Eigen::Index axis, double low, double high) {
        std::vector<double> pitches;
        for (std::size_t p = 0; p < pages_.size(); ++p) {
            for (const LineEnd& end : ends_[p]) {
                constexpr double kNear = 0.3;  // mm
                const bool is_low = std::abs(end.at[axis] - low) < kNear;
                if (!is_low && std::abs(end.at[axis] - high) > kNear) continue;
                for (std::size_t q = 0; q < pages_.size() && work_ < kMostWork / 2; ++q) {
                    if (q == p) continue;
                    work_ += lines_[q].size();
                    for (const double at : places_at_height(q, axis, end))
                        pitches.push_back(is_low ? at - end.at[axis] : end.at[axis] - at);
                }
            }
        }
        return pitches;
    }

    // Where lines that run as the end does have its height. Level ones, of the axis, tell no place.
    std::vector<double> places_at_height(std::size_t p, Eigen::Index axis, const LineEnd& end) const {
        constexpr double kSteep = 0.2, kSame = 0.1;  // of the length; rad
        const double height = end.at[1 - axis];
        std::vector<double> places;
        constexpr std::size_t kMostLines = 20'000;
        for (std::size_t l = 0; l < std::min(kMostLines, lines_[p].size()); ++l) {
            const std::vector<Vec2d>& line = lines_[p][l];
            for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                const Vec2d &a = line[i], &b = line[i + 1];
                if ((a[1 - axis] < height) == (b[1 - axis] < height)) continue;
                const Vec2d along = (b - a).normalized();
                if (std::abs(along[1 - axis]) < kSteep || std::abs(cross2(along, end.along)) > kSame) continue;
                places.push_back(a[axis] + (b[axis] - a[axis]) * (height - a[1 - axis]) / (b[1 - axis] - a[1 - axis]));
            }
        }
        return places;
    }

    // Whether a small shape of the print that is near the upper border lies on an equal one near the lower border of
    // the next page.
    bool do_marks_meet(Eigen::Index axis, double cell) const {
        constexpr double kMark = 30, kSame = 0.5;  // mm
        Vec2d pitch = Vec2d::Zero();
        pitch[axis] = cell;
        std::vector<const TileShape*> marks;
        for (std::size_t p = 0; p < pages_.size() && marks.size() < 200; ++p) {
            for (std::size_t s = 0; s < pages_[p]->shapes.size(); ++s) {
                const TileShape& shape = pages_[p]->shapes[s];
                if (is_furniture_[p][s] && shape.box.sizes().maxCoeff() < kMark) marks.push_back(&shape);
            }
        }
        return std::ranges::any_of(marks, [&](const TileShape* low) {
            return std::ranges::any_of(marks, [&](const TileShape* high) {
                const std::vector<Vec2d>&a = low->plain.path.vertices, &b = high->plain.path.vertices;
                if (a.size() != b.size() || (low->box.min() + pitch - high->box.min()).norm() > kSame) return false;
                return std::ranges::equal(
                    a, b, [&](const Vec2d& p, const Vec2d& q) { return (p + pitch - q).norm() < kSame; });
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
        CellGuess best = {.second = pages_.front()->size[axis]};
        for (const CellGuess& guess : guesses_[static_cast<std::size_t>(axis)]) {
            int good = 0, all = 0;
            double off = 0;
            for (const auto& [low, high] : neighbours) {
                const auto& ours = crossings(low, axis, guess.second, true);
                const auto& theirs = crossings(high, axis, guess.first, false);
                const BorderMatches same = match_crossings(ours, theirs);
                work_ += 1 + ours.size() * theirs.size();
                good += same.count;
                off += same.off;
                all += static_cast<int>(ours.size() + theirs.size()) - 2 * same.count;
            }
            // Level lines go on wherever the borders are: marks that meet decide, then strips that pages share, then
            // the widest cell.
            constexpr double kMeeting = 0.4, kOverlapping = 0.2, kWide = 1e-6, kOff = 0.5;
            const double score = score_of(good, all) - kOff * off + (guess.do_marks_meet ? kMeeting : 0) +
                                 (guess.is_overlapped ? kOverlapping : 0) + kWide * (guess.second - guess.first);
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
    std::vector<std::vector<LineEnd>> ends_;              // of open lines, per page
    std::map<std::tuple<std::size_t, Eigen::Index, double, bool>, std::vector<BorderCrossing>> crossings_;
    std::array<Borders, 2> borders_;
    std::vector<double> strips_;
    std::size_t work_ = 0;  // pairs of lines that were compared
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
