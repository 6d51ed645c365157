#include "sim/paper/pdf_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "sim/core/disjoint_sets.h"
#include "sim/core/printable.h"
#include "sim/paper/curve_pieces.h"
#include "sim/paper/page_grid_fit.h"
#include "sim/paper/page_labels.h"
#include "sim/paper/path_builder.h"
#include "sim/paper/path_index.h"

namespace selvedge::sim {
namespace {

using SheetBox = Eigen::AlignedBox2d;

constexpr double kLargeShape = 20;  // mm: smaller ones are marks and letters, which repeat

SheetBox moved(const SheetBox& box, const Vec2d& by) {
    return {Vec2d(box.min() + by), Vec2d(box.max() + by)};
}

// A part of a path that a page shows, in the frame of the sheet.
struct TileRun {
    std::vector<CurvePiece> pieces;
    const TileShape* of = nullptr;
    std::size_t page = 0;
    bool is_used = false;
};

class TileJoiner {
 public:
    explicit TileJoiner(const std::vector<TilePage>& pages)
        : pages_(pages), at_(pages.size(), Vec2d::Zero()), cell_(pages.size()), sets_(pages.size()) {
        for (const TilePage& page : pages) is_furniture_.emplace_back(page.shapes.size(), false);
    }

    JoinedTiles join() {
        if (pages_.size() > 1) {
            mark_repeated();
            join_by_shared_paths();
            if (groups_of_several() == 0) join_by_borders();
        }
        choose_pages();
        mark_at_borders();
        lay_out_groups();
        add_shapes();
        add_texts();
        tell();
        return std::move(out_);
    }

 private:
    // ---- What belongs to the print: it is at the same place on several pages.

    void mark_repeated() {
        PathIndex index(PathIndex::Match::AtOnePlace);
        for (std::size_t p = 0; p < pages_.size(); ++p) {
            for (std::size_t s = 0; s < pages_[p].shapes.size(); ++s) index.add(path(p, s), p, s);
        }
        std::vector<std::vector<std::size_t>> times;  // per page and shape: on how many other pages it is
        std::size_t most_pages = 0;
        for (std::size_t p = 0; p < pages_.size(); ++p) {
            times.emplace_back(pages_[p].shapes.size(), 0);
            for (std::size_t s = 0; s < pages_[p].shapes.size(); ++s) {
                std::set<std::size_t> others;
                index.for_each_alike(path(p, s), [&](std::size_t q, std::size_t, const Vec2d& shift) {
                    if (q != p && shift.norm() < kSamePathPlace && pages_[p].size == pages_[q].size) others.insert(q);
                });
                times[p][s] = others.size();
                if (!others.empty() && !is_long_line(p, s)) most_pages = std::max(most_pages, others.size());
            }
        }
        for (std::size_t p = 0; p < pages_.size(); ++p) {
            for (std::size_t s = 0; s < pages_[p].shapes.size(); ++s)
                is_furniture_[p][s] = times[p][s] > 0 && !is_long_line(p, s);
            for (std::size_t s = 0; s < pages_[p].shapes.size(); ++s) {
                if (times[p][s] == 0 || !is_long_line(p, s)) continue;
                is_furniture_[p][s] =
                    (times[p][s] > 1 && 2 * times[p][s] > most_pages) || is_side_of_frame(p, s, times[p]);
            }
        }
    }

    // A level or upright line across much of a page. A hem may run so across two pages.
    bool is_long_line(std::size_t p, std::size_t s) const {
        constexpr double kThin = 0.1, kLong = 0.4;  // mm; of the page
        const Vec2d extent = pages_[p].shapes[s].box.sizes();
        return !path(p, s).is_closed && ((extent.y() < kThin && extent.x() > kLong * pages_[p].size.x()) ||
                                         (extent.x() < kThin && extent.y() > kLong * pages_[p].size.y()));
    }

    // Whether both ends of such a line meet ends of others that are repeated, as the sides of a frame do.
    bool is_side_of_frame(std::size_t p, std::size_t s, const std::vector<std::size_t>& times) const {
        const auto meets = [&](const Vec2d& end) {
            for (std::size_t r = 0; r < pages_[p].shapes.size(); ++r) {
                if (r == s || times[r] == 0 || !is_long_line(p, r)) continue;
                for (const Vec2d& other : {path(p, r).vertices.front(), path(p, r).vertices.back()}) {
                    if ((other - end).norm() < 2 * kSamePathPlace) return true;
                }
            }
            return false;
        };
        return meets(path(p, s).vertices.front()) && meets(path(p, s).vertices.back());
    }

    const DrawnPath& path(std::size_t p, std::size_t s) const { return pages_[p].shapes[s].plain.path; }

    bool is_clipped(const TileShape& shape) const {
        constexpr double kBeyond = 1;  // mm
        return !SheetBox(Vec2d(shape.seen.min() - Vec2d::Constant(kBeyond)),
                         Vec2d(shape.seen.max() + Vec2d::Constant(kBeyond)))
                    .contains(shape.box);
    }

    // ---- Pages that draw whole outlines.

    // A page and where another lies from it, with the length of the outlines that say so.
    struct PageVote {
        Vec2d shift = Vec2d::Zero();
        double weight = 0;
    };

    void join_by_shared_paths() {
        PathIndex index(PathIndex::Match::Anywhere);
        const auto may_tell = [&](std::size_t p, std::size_t s) {
            return !is_furniture_[p][s] && pages_[p].shapes[s].box.sizes().maxCoeff() > kLargeShape;
        };
        for (std::size_t p = 0; p < pages_.size(); ++p) {
            for (std::size_t s = 0; s < pages_[p].shapes.size(); ++s) {
                if (may_tell(p, s)) index.add(path(p, s), p, s);
            }
        }
        std::map<std::pair<std::size_t, std::size_t>, std::vector<PageVote>> votes;
        for (std::size_t p = 0; p < pages_.size(); ++p) {
            for (std::size_t s = 0; s < pages_[p].shapes.size(); ++s) {
                if (!may_tell(p, s)) continue;
                const double weight = pages_[p].shapes[s].box.sizes().sum();
                index.for_each_alike(path(p, s), [&](std::size_t q, std::size_t r, const Vec2d& shift) {
                    if (q <= p || (!is_clipped(pages_[p].shapes[s]) && !is_clipped(pages_[q].shapes[r]))) return;
                    add_vote(votes[{p, q}], shift, weight);
                });
            }
        }
        take_votes(votes);
    }

    static void add_vote(std::vector<PageVote>& votes, const Vec2d& shift, double weight) {
        for (PageVote& vote : votes) {
            if ((vote.shift - shift).norm() > 2 * kSamePathPlace) continue;
            vote.weight += weight;
            return;
        }
        constexpr std::size_t kMostVotes = 100;
        if (votes.size() < kMostVotes) votes.push_back({shift, weight});
    }

    // The pairs of pages with the longest outlines in common first.
    void take_votes(const std::map<std::pair<std::size_t, std::size_t>, std::vector<PageVote>>& votes) {
        std::vector<std::tuple<double, std::size_t, std::size_t, Vec2d>> best;
        for (const auto& [pair, list] : votes) {
            const auto most = std::ranges::max_element(list, {}, &PageVote::weight);
            best.emplace_back(-most->weight, pair.first, pair.second, most->shift);
        }
        std::ranges::stable_sort(best, {}, [](const auto& one) { return std::get<0>(one); });
        for (const auto& [weight, p, q, shift] : best) {
            // What lies at x on page q lies at x - shift on page p.
            if (sets_.find(static_cast<int>(p)) == sets_.find(static_cast<int>(q))) continue;
            const Vec2d by = at_[p] - shift - at_[q];
            const int moving = sets_.find(static_cast<int>(q));
            for (std::size_t r = 0; r < pages_.size(); ++r) {
                if (sets_.find(static_cast<int>(r)) == moving) at_[r] += by;
            }
            sets_.join(static_cast<int>(p), static_cast<int>(q));
        }
        for (std::size_t p = 0; p < pages_.size(); ++p) cell_[p] = seen_on(p);
    }

    // What the clipping leaves of a page, or all of it.
    SheetBox seen_on(std::size_t p) const {
        SheetBox box;
        for (const TileShape& shape : pages_[p].shapes) {
            if (is_clipped(shape)) box.extend(shape.seen);
        }
        return box.isEmpty() ? SheetBox(Vec2d(Vec2d::Zero()), pages_[p].size) : box;
    }

    std::map<int, std::vector<std::size_t>> groups() {
        std::map<int, std::vector<std::size_t>> all;
        for (std::size_t p = 0; p < pages_.size(); ++p) all[sets_.find(static_cast<int>(p))].push_back(p);
        return all;
    }

    std::size_t groups_of_several() {
        std::size_t count = 0;
        for (const auto& [root, group] : groups()) count += group.size() > 1 ? 1 : 0;
        return count;
    }

    // ---- Pages whose outlines end at their borders.

    // Of the pages with frames and marks, or of all that are as large as most, without the first few.
    void join_by_borders() {
        std::vector<std::size_t> tiles = pages_of_main_size();
        std::vector<std::size_t> marked;
        for (const std::size_t p : tiles) {
            if (std::ranges::find(is_furniture_[p], true) != is_furniture_[p].end()) marked.push_back(p);
        }
        std::optional<GridFit> best;
        std::vector<std::size_t> chosen;
        const auto attempt = [&](const std::vector<std::size_t>& candidates) {
            std::vector<const TilePage*> pages;
            std::vector<std::vector<bool>> furniture;
            for (const std::size_t p : candidates) {
                pages.push_back(&pages_[p]);
                furniture.push_back(is_furniture_[p]);
            }
            std::optional<GridFit> fit = fit_page_grid(pages, furniture);
            if (!fit || (best && fit->matched - fit->unmatched <= best->matched - best->unmatched)) return;
            best = std::move(fit);
            chosen = candidates;
        };
        if (marked.size() > 1) attempt(marked);
        constexpr std::size_t kMostCovers = 3;
        for (std::size_t covers = 0; covers <= kMostCovers && tiles.size() > 1; ++covers) {
            attempt(tiles);
            tiles.erase(tiles.begin());
        }
        if (best) take_grid(*best, chosen);
    }

    std::vector<std::size_t> pages_of_main_size() const {
        std::map<std::pair<double, double>, std::vector<std::size_t>> sizes;
        for (std::size_t p = 0; p < pages_.size(); ++p)
            sizes[{std::round(pages_[p].size.x()), std::round(pages_[p].size.y())}].push_back(p);
        std::vector<std::size_t> most;
        for (const auto& [size, pages] : sizes) {
            if (pages.size() > most.size()) most = pages;
        }
        return most;
    }

    void take_grid(const GridFit& fit, const std::vector<std::size_t>& chosen) {
        is_cut_ = true;
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            const std::size_t p = chosen[i];
            const Vec2d pitch = fit.cell.sizes();
            at_[p] = Vec2d(fit.places[i].first * pitch.x(), fit.places[i].second * pitch.y());
            cell_[p] = fit.cell;
            if (i > 0) sets_.join(static_cast<int>(chosen.front()), static_cast<int>(p));
        }
        // Beyond the outer borders nothing is cut off.
        for (const std::size_t p : chosen) {
            for (const Eigen::Index axis : {Eigen::Index(0), Eigen::Index(1)}) {
                const auto has_neighbour = [&](double side) {
                    Vec2d there = at_[p];
                    there[axis] += side * fit.cell.sizes()[axis];
                    return std::ranges::any_of(chosen, [&](std::size_t q) { return (at_[q] - there).norm() < 1; });
                };
                if (!has_neighbour(-1)) cell_[p].min()[axis] = std::min(cell_[p].min()[axis], 0.0);
                if (!has_neighbour(1)) cell_[p].max()[axis] = std::max(cell_[p].max()[axis], pages_[p].size[axis]);
            }
        }
        grid_cell_ = fit.cell;
    }

    // ---- Which pages are the pattern.

    void choose_pages() {
        const bool has_group = groups_of_several() > 0;
        std::vector<bool> is_joined(pages_.size(), false);
        for (const auto& [root, group] : groups()) {
            if (group.size() < 2) continue;
            for (const std::size_t p : group) is_joined[p] = true;
        }
        const PathIndex print = print_of(is_joined);
        std::vector<double> largest(pages_.size(), 0);
        for (std::size_t p = 0; p < pages_.size(); ++p) largest[p] = largest_on(p);
        const bool has_large = std::ranges::any_of(largest, [](double size) { return size >= kSmallestPart; });
        for (std::size_t p = 0; p < pages_.size(); ++p) {
            if (is_joined[p]) {
                out_.joined.push_back(p);
            } else if (has_group ? shares_print_with(p, print) : !has_large || largest[p] >= kSmallestPart) {
                out_.single.push_back(p);
            } else {
                out_.left.push_back(p);
            }
        }
    }

    static constexpr double kSmallestPart = 120;  // mm: of a garment's largest; maps and sketches are smaller

    // The size of the largest shape that is no frame.
    double largest_on(std::size_t p) const {
        double largest = 0;
        for (std::size_t s = 0; s < pages_[p].shapes.size(); ++s) {
            const TileShape& shape = pages_[p].shapes[s];
            const bool is_frame =
                shape.box.sizes().x() > 0.8 * pages_[p].size.x() && shape.box.sizes().y() > 0.8 * pages_[p].size.y();
            if (!is_furniture_[p][s] && !is_frame) largest = std::max(largest, shape.box.sizes().maxCoeff());
        }
        return largest;
    }

    // Whether a page has frame or marks where pages that were joined have them.
    bool shares_print_with(std::size_t p, const PathIndex& print) const {
        for (std::size_t s = 0; s < pages_[p].shapes.size(); ++s) {
            bool is_shared = false;
            if (!is_furniture_[p][s]) continue;
            print.for_each_alike(path(p, s), [&](std::size_t q, std::size_t, const Vec2d& shift) {
                is_shared = is_shared || (shift.norm() < kSamePathPlace && pages_[q].size == pages_[p].size);
            });
            if (is_shared) return true;
        }
        return false;
    }

    PathIndex print_of(const std::vector<bool>& is_joined) const {
        PathIndex print(PathIndex::Match::AtOnePlace);
        for (std::size_t p = 0; p < pages_.size(); ++p) {
            for (std::size_t s = 0; s < pages_[p].shapes.size() && is_joined[p]; ++s) {
                if (is_furniture_[p][s]) print.add(path(p, s), p, s);
            }
        }
        return print;
    }

    // ---- Glue lines and marks that are on one page only.

    void mark_at_borders() {
        for (const std::size_t p : out_.joined) {
            mark_glue_lines(p);
            for (const std::size_t q : out_.joined) {
                if (p != q && sets_.find(static_cast<int>(p)) == sets_.find(static_cast<int>(q))) mark_between(p, q);
            }
        }
    }

    // Lines along a border, from one side of the frame to the other, drawn as other lines of the print.
    void mark_glue_lines(std::size_t p) {
        const SheetBox frame = is_cut_ ? grid_cell_ : cell_[p];
        std::set<std::string> styles;
        for (std::size_t s = 0; s < pages_[p].shapes.size(); ++s) {
            if (is_furniture_[p][s]) styles.insert(colour_and_width(pages_[p].shapes[s].plain.style));
        }
        for (std::size_t s = 0; s < pages_[p].shapes.size(); ++s) {
            const TileShape& shape = pages_[p].shapes[s];
            constexpr double kThin = 0.1, kFull = 0.97;  // mm; of the frame
            const Vec2d extent = shape.box.sizes();
            const bool is_level = extent.y() < kThin && extent.x() > kFull * frame.sizes().x();
            const bool is_upright = extent.x() < kThin && extent.y() > kFull * frame.sizes().y();
            if ((is_level || is_upright) && styles.contains(colour_and_width(shape.plain.style)))
                is_furniture_[p][s] = true;
        }
    }

    // Without dashes.
    static std::string colour_and_width(const std::string& style) { return style.substr(0, style.find(',')); }

    // Small shapes in the middle of the strip that two pages share, or of the border between them.
    void mark_between(std::size_t p, std::size_t q) {
        constexpr double kTouch = 0.5, kMark = 30, kMiddle = 1.5;  // mm
        SheetBox strip = moved(visible(p), at_[p]).intersection(moved(visible(q), at_[q]));
        strip.extend(strip.center());
        if (strip.sizes().minCoeff() < -kTouch || strip.sizes().maxCoeff() < kMark) return;
        for (std::size_t s = 0; s < pages_[p].shapes.size(); ++s) {
            const TileShape& shape = pages_[p].shapes[s];
            if (shape.box.sizes().maxCoeff() > kMark) continue;
            const SheetBox box = moved(shape.box, at_[p]);
            const bool is_mark = (box.center() - strip.center()).norm() < kMiddle;
            if (is_mark || is_half_mark(path(p, s), at_[p], strip)) is_furniture_[p][s] = true;
        }
    }

    SheetBox visible(std::size_t p) const { return is_cut_ ? grid_cell_ : cell_[p]; }

    // A closed shape with an edge on the border, in its middle: half a diamond or circle.
    static bool is_half_mark(const DrawnPath& path, const Vec2d& at, const SheetBox& strip) {
        constexpr double kOn = 0.4, kShortest = 2, kMiddle = 1.5;  // mm
        if (!path.is_closed) return false;
        return std::ranges::any_of(pieces_of(path), [&](const CurvePiece& piece) {
            const Vec2d a = piece.p[0] + at, b = piece.p[3] + at;
            if (!piece.is_line || (b - a).norm() < kShortest) return false;
            const Vec2d off = (a + b) / 2 - strip.center();
            return off.norm() < kMiddle && std::min(std::abs(a.x() - b.x()), std::abs(a.y() - b.y())) < kOn;
        });
    }

    // ---- The sheet.

    // Groups and single pages side by side.
    void lay_out_groups() {
        constexpr double kGap = 100;  // mm
        double x = 0;
        std::vector<std::vector<std::size_t>> all;
        for (auto& [root, group] : groups()) {
            if (group.size() > 1) all.push_back(group);
        }
        for (const std::size_t p : out_.single) all.push_back({p});
        std::ranges::sort(all);
        for (const std::vector<std::size_t>& group : all) {
            SheetBox box;
            for (const std::size_t p : group) {
                box.extend(moved(SheetBox(Vec2d(Vec2d::Zero()), pages_[p].size), at_[p]));
                for (const TileShape& shape : pages_[p].shapes) box.extend(moved(shape.box, at_[p]));
            }
            for (const std::size_t p : group) at_[p] += Vec2d(x, 0) - box.min();
            x += box.sizes().x() + kGap;
        }
    }

    std::vector<std::size_t> pages_on_sheet() const {
        std::vector<std::size_t> all = out_.joined;
        all.insert(all.end(), out_.single.begin(), out_.single.end());
        std::ranges::sort(all);
        return all;
    }

    void add_shapes() {
        for (const std::size_t p : pages_on_sheet()) {
            const bool is_joined = std::ranges::find(out_.joined, p) != out_.joined.end();
            for (std::size_t s = 0; s < pages_[p].shapes.size(); ++s) {
                if (is_furniture_[p][s] && (is_joined || out_.joined.size() + out_.single.size() > 1)) continue;
                const TileShape& shape = pages_[p].shapes[s];
                DrawnPath placed = shape.plain.path;
                transform(placed, Eigen::Affine2d(Eigen::Translation2d(at_[p])));
                if (is_cut_ && is_joined) {
                    add_runs(shape, placed, p);
                } else {
                    add_once(shape, std::move(placed));
                }
            }
        }
        join_runs();
    }

    void add_once(const TileShape& shape, DrawnPath placed) {
        PlainShape plain = shape.plain;
        plain.path = std::move(placed);
        out_.plain.shapes.push_back(std::move(plain));
    }

    void add_runs(const TileShape& shape, const DrawnPath& placed, std::size_t p) {
        CutRuns cut = cut_to_box(placed, moved(cell_[p], at_[p]));
        if (cut.is_whole) {
            if (placed.is_closed || !ends_at_border(placed, p)) return add_once(shape, placed);
        }
        for (std::vector<CurvePiece>& run : cut.runs) runs_.push_back({std::move(run), &shape, p});
    }

    // Whether one end of a line lies at its page's border, so that it may go on.
    bool ends_at_border(const DrawnPath& placed, std::size_t p) const {
        const SheetBox cell = moved(cell_[p], at_[p]);
        return is_at_border(placed.vertices.front(), cell) || is_at_border(placed.vertices.back(), cell);
    }

    static bool is_at_border(const Vec2d& end, const SheetBox& cell) {
        constexpr double kNear = 0.8;  // mm
        return (end - cell.min()).cwiseAbs().minCoeff() < kNear || (end - cell.max()).cwiseAbs().minCoeff() < kNear;
    }

    // ---- Lines that go on on the next page.

    struct RunEnd {
        std::size_t run = 0;
        bool is_last = false;
        Vec2d at = Vec2d::Zero(), outward = Vec2d::Zero();
    };

    std::vector<RunEnd> run_ends() const {
        std::vector<RunEnd> ends;
        for (std::size_t r = 0; r < runs_.size(); ++r) {
            const SheetBox cell = moved(cell_[runs_[r].page], at_[runs_[r].page]);
            const CurvePiece &first = runs_[r].pieces.front(), &last = runs_[r].pieces.back();
            if (is_at_border(first.p[0], cell)) ends.push_back({r, false, first.p[0], -first.leaves()});
            if (is_at_border(last.p[3], cell)) ends.push_back({r, true, last.p[3], last.arrives()});
        }
        return ends;
    }

    void join_runs() {
        const std::vector<RunEnd> ends = run_ends();
        constexpr std::size_t kMostEnds = 20'000;
        if (ends.size() > kMostEnds) {
            out_.notes.push_back("more than 20,000 lines end at borders of pages: they are not joined");
            return follow(ends, std::vector<std::optional<std::size_t>>(ends.size()));
        }
        struct Match {
            double cost = 0;
            std::size_t a = 0, b = 0;
        };
        std::vector<Match> matches;
        constexpr double kNear = 1.2, kAhead = -0.9, kOtherStyle = 5;  // mm; cosine; added to the distance
        std::vector<std::size_t> order(ends.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return ends[i].at.x(); });
        for (std::size_t i = 0; i < order.size(); ++i) {
            for (std::size_t j = i + 1; j < order.size(); ++j) {
                const RunEnd &a = ends[order[i]], &b = ends[order[j]];
                if (b.at.x() - a.at.x() > kNear) break;
                const double distance = (a.at - b.at).norm();
                if (runs_[a.run].page == runs_[b.run].page || distance > kNear || a.outward.dot(b.outward) > kAhead)
                    continue;
                const bool is_alike = runs_[a.run].of->plain.style == runs_[b.run].of->plain.style;
                matches.push_back({distance + (is_alike ? 0 : kOtherStyle), order[i], order[j]});
            }
        }
        std::ranges::stable_sort(matches, {}, &Match::cost);
        std::vector<std::optional<std::size_t>> partner(ends.size());
        for (const Match& match : matches) {
            if (partner[match.a] || partner[match.b]) continue;
            partner[match.a] = match.b;
            partner[match.b] = match.a;
        }
        follow(ends, partner);
    }

    void follow(const std::vector<RunEnd>& ends, const std::vector<std::optional<std::size_t>>& partner) {
        // Per run, its ends that have a partner: 0 the first, 1 the last.
        std::map<std::pair<std::size_t, bool>, std::pair<std::size_t, bool>> next;
        for (std::size_t e = 0; e < ends.size(); ++e) {
            if (partner[e]) next[{ends[e].run, ends[e].is_last}] = {ends[*partner[e]].run, ends[*partner[e]].is_last};
        }
        for (const bool begins_open : {true, false}) {
            for (std::size_t r = 0; r < runs_.size(); ++r) {
                if (runs_[r].is_used) continue;
                const bool has_before = next.contains({r, false}), has_after = next.contains({r, true});
                if (begins_open && has_before && has_after) continue;  // in the middle of a chain
                walk(r, begins_open && has_before, next);
            }
        }
    }

    // From a run on, in its own direction or against it.
    void walk(std::size_t start, bool is_reversed,
              const std::map<std::pair<std::size_t, bool>, std::pair<std::size_t, bool>>& next) {
        std::vector<CurvePiece> line;
        std::size_t run = start;
        bool is_closed = false;
        while (true) {
            runs_[run].is_used = true;
            std::vector<CurvePiece> pieces = runs_[run].pieces;
            if (is_reversed) {
                std::ranges::reverse(pieces);
                for (CurvePiece& piece : pieces) piece = piece.reversed();
            }
            append_pieces(line, pieces);
            const auto after = next.find({run, !is_reversed});
            if (after == next.end()) break;
            ++joints_;
            if (runs_[after->second.first].is_used) {
                is_closed = after->second.first == start;
                break;
            }
            run = after->second.first;
            is_reversed = after->second.second;
        }
        if (is_closed) close_pieces(line);
        PlainShape plain = runs_[start].of->plain;
        plain.path = path_of(line, is_closed, plain.path);
        out_.plain.shapes.push_back(std::move(plain));
    }

    // ---- Texts.

    void add_texts() {
        TextIndex on_pages, on_sheet;
        for (const std::size_t p : pages_on_sheet()) {
            for (const PdfText& text : pages_[p].texts) on_pages.add(text.text, text.middle(), p);
        }
        const bool is_print = out_.joined.size() + out_.single.size() > 1;
        for (const std::size_t p : pages_on_sheet()) {
            for (const PdfText& text : pages_[p].texts) {
                if (is_print && (is_page_text(text.text) || on_pages.has_on_other(text.text, text.middle(), p)))
                    continue;
                const Vec2d at = text.middle() + at_[p];
                if (on_sheet.has_on_other(text.text, at, pages_.size())) continue;
                on_sheet.add(text.text, at, p);
                out_.plain.texts.push_back({at, text.text});
            }
        }
    }

    void drop_repeated_shapes() {
        PathIndex index(PathIndex::Match::AtOnePlace);
        std::vector<PlainShape>& shapes = out_.plain.shapes;
        for (std::size_t s = 0; s < shapes.size(); ++s) index.add(shapes[s].path, 0, s);
        std::vector<bool> is_repeated(shapes.size(), false);
        for (std::size_t s = 0; s < shapes.size(); ++s) {
            index.for_each_alike(shapes[s].path, [&](std::size_t, std::size_t other, const Vec2d& shift) {
                if (other < s && shift.norm() < 2 * kSamePathPlace && shapes[other].style == shapes[s].style)
                    is_repeated[s] = true;
            });
        }
        std::vector<PlainShape> kept;
        for (std::size_t s = 0; s < shapes.size(); ++s) {
            if (!is_repeated[s]) kept.push_back(std::move(shapes[s]));
        }
        shapes = std::move(kept);
    }

    void tell() {
        if (out_.joined.empty()) return drop_repeated_shapes();
        drop_repeated_shapes();
        out_.notes.push_back(count_text(out_.joined.size(), "page") + " put together " +
                             (is_cut_ ? "in a grid: " + count_text(joints_, "line") + " that go on across their borders"
                                      : std::string("by the outlines that they share")));
    }

    const std::vector<TilePage>& pages_;
    std::vector<std::vector<bool>> is_furniture_;
    std::vector<Vec2d> at_;       // of each page's lower left corner on the sheet
    std::vector<SheetBox> cell_;  // of each page's frame: what is taken of it
    SheetBox grid_cell_;
    DisjointSets sets_;
    bool is_cut_ = false;
    std::vector<TileRun> runs_;
    std::size_t joints_ = 0;
    JoinedTiles out_;
};

}  // namespace

JoinedTiles join_tiles(const std::vector<TilePage>& pages) {
    return TileJoiner(pages).join();
}

}  // namespace selvedge::sim
