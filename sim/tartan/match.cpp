#include "sim/tartan/match.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include "sim/core/assert.h"
#include "sim/core/error.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern.h"
#include "sim/tartan/offset_graph.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::sim {
namespace {

constexpr double kCrossing = 0.25881904510252074;  // sin 15 degrees
constexpr double kOpposed = -3e-4;                 // mean product of directions: -sin(1 degree)^2
constexpr double kMet = 5e-4;                      // m, mismatch of a seam that meets
constexpr double kNearlyMet = 2e-3;                // m, mismatch that is invisible at arm's length
constexpr double kMatchable = 6e-3;                // m, a seam with a larger best mismatch has lower priority
constexpr double kOffsetStep = 1e-6;               // m, resolution of offsets in files
constexpr double kSameSample = 1e-5;               // m, samples this close are merged
constexpr double kMaxSamples = 2e5;                // per garment, limits the time for thousands of seams

using Family = Eigen::Index;  // 0: the warp's stripes, 1: the weft's

double as_written(double offset, double repeat) {
    return std::round(wrapped(offset, repeat) / kOffsetStep) * kOffsetStep;
}

struct Lines {
    StripeRepeat repeat;
    bool is_mirrored = false;  // matched with the mirror image of the sett
    bool is_crossing = false;

    // The mismatch for zero offsets; the seam meets if it is 0 modulo the repeat.
    double value(const CoursePoint& point, Family f) const {
        return is_mirrored ? point.first[f] + point.second[f] - 2 * *repeat.mirror : point.first[f] - point.second[f];
    }
    double moved(double value, const Vec2d& first, const Vec2d& second, Family f) const {
        return wrapped(value + first[f] + (is_mirrored ? second[f] : -second[f]), repeat.size);
    }
};

struct SeamLines {
    const Seam* seam = nullptr;
    std::string name;
    SeamCourse course;
    std::array<Lines, 2> lines;

    double length() const { return 0.5 * (course.first_length + course.second_length); }
    bool counts(const CoursePoint& point, Family f) const {
        return lines[static_cast<std::size_t>(f)].repeat.size > 0 && point.crossing[f] >= kCrossing;
    }
};

using Offsets = std::vector<Vec2d>;

const Vec2d& offset_of(const Offsets& offsets, const SeamSide& side) {
    return offsets[static_cast<std::size_t>(side.panel)];
}

SeamLines find_lines(const Pattern& pattern, const Seam& seam, const std::array<StripeRepeat, 2>& repeats) {
    SeamLines found{.seam = &seam, .name = seam_name(pattern, seam), .course = find_course(pattern, seam), .lines = {}};
    for (Family f = 0; f < 2; ++f) {
        Lines& lines = found.lines[static_cast<std::size_t>(f)];
        lines.repeat = repeats[static_cast<std::size_t>(f)];
        lines.is_mirrored = lines.repeat.mirror && found.course.agreement[f] < kOpposed;
        lines.is_crossing = std::any_of(found.course.points.begin(), found.course.points.end(),
                                        [&](const CoursePoint& point) { return found.counts(point, f); });
    }
    return found;
}

// Merges samples whose values differ by at most 0.01 mm, so that a seam that is straight on both sides has a single
// sample. most: approximate limit of the number of samples that remain; it applies to seams that cannot meet anyway.
std::vector<OffsetSample> merge_samples(std::vector<OffsetSample> samples, double repeat, double most) {
    const double about = samples.front().value;
    for (OffsetSample& sample : samples) sample.value = about + wrapped(sample.value - about, repeat);
    std::sort(samples.begin(), samples.end(),
              [](const OffsetSample& a, const OffsetSample& b) { return a.value < b.value; });
    const double same = std::max(kSameSample, (samples.back().value - samples.front().value) / most);
    std::vector<OffsetSample> merged;
    double from = 0;
    for (const OffsetSample& sample : samples) {
        if (merged.empty() || sample.value - from > same) {
            from = sample.value;
            merged.push_back(sample);
            continue;
        }
        OffsetSample& last = merged.back();
        const double sum = last.weight + sample.weight;
        if (sum > 0) last.value += (sample.value - last.value) * sample.weight / sum;
        last.weight = sum;
    }
    return merged;
}

// The samples of a seam for the solver. Weight: length of seam per sample, times the squared sine of the crossing angle
// if stripes of this family cross the seam at all. An eased seam has a single sample, at its anchor.
std::vector<OffsetSample> samples_of(const SeamLines& seam, Family f, double most = 1024) {
    const Lines& lines = seam.lines[static_cast<std::size_t>(f)];
    const double step = seam.length() / static_cast<double>(seam.course.points.size());
    std::vector<OffsetSample> samples;
    double sum = 0;
    for (const CoursePoint& point : seam.course.points) {
        const double crossing = point.crossing[f];
        samples.push_back({lines.value(point, f), step * (lines.is_crossing ? crossing * crossing : 1)});
        sum += samples.back().weight;
    }
    if (seam.course.is_eased) return {{samples[seam.course.anchor].value, sum}};
    return merge_samples(std::move(samples), lines.repeat.size, most);
}

double weight_of(const OffsetTerm& term) {
    double sum = 0;
    for (const OffsetSample& sample : term.samples) sum += sample.weight;
    return sum;
}

// The larger mismatch of the two families at a point, m; nullopt if no stripe crosses the seam there.
std::optional<double> mismatch_at(const SeamLines& seam, const CoursePoint& point, const Vec2d& first,
                                  const Vec2d& second) {
    std::optional<double> worse;
    for (Family f = 0; f < 2; ++f) {
        if (!seam.counts(point, f)) continue;
        const Lines& lines = seam.lines[static_cast<std::size_t>(f)];
        worse = std::max(worse.value_or(0), std::abs(lines.moved(lines.value(point, f), first, second, f)));
    }
    return worse;
}

struct Mismatch {
    double largest = 0;
    double rms = 0;
    double met = 1;
    bool is_anchored = false;  // the mismatch at the anchor is at most kMet
};

Mismatch measure(const SeamLines& seam, const Vec2d& first, const Vec2d& second) {
    Mismatch mismatch;
    double squares = 0;
    int count = 0, met = 0;
    for (const CoursePoint& point : seam.course.points) {
        const std::optional<double> worse = mismatch_at(seam, point, first, second);
        if (!worse) continue;
        mismatch.largest = std::max(mismatch.largest, *worse);
        squares += *worse * *worse;
        ++count;
        met += *worse <= kNearlyMet ? 1 : 0;
    }
    mismatch.is_anchored = mismatch_at(seam, seam.course.points[seam.course.anchor], first, second) <= kMet;
    if (count == 0) return mismatch;
    mismatch.rms = std::sqrt(squares / count);
    mismatch.met = double(met) / count;
    return mismatch;
}

// The largest mismatch, m, that remains if only this seam is matched, with the solver's cost function. 0 for a seam
// within one panel.
double mismatch_alone(const SeamLines& seam) {
    if (seam.seam->first.panel == seam.seam->second.panel) return 0;
    Vec2d shift = Vec2d::Zero();
    for (Family f = 0; f < 2; ++f) {
        if (!seam.lines[static_cast<std::size_t>(f)].is_crossing) continue;
        std::vector<ShiftTerm> terms;
        for (const OffsetSample& sample : samples_of(seam, f)) terms.push_back({sample.value, sample.weight, 1});
        shift[f] = best_shift(terms, seam.lines[static_cast<std::size_t>(f)].repeat.size);
    }
    return measure(seam, shift, Vec2d::Zero()).largest;
}

bool is_opposed_without_mirror(const SeamLines& seam) {
    for (Family f = 0; f < 2; ++f) {
        const Lines& lines = seam.lines[static_cast<std::size_t>(f)];
        if (lines.is_crossing && !lines.repeat.mirror && seam.course.agreement[f] < kOpposed) return true;
    }
    return false;
}

std::string reason(const SeamLines& seam, const Mismatch& after) {
    const SeamCourse& course = seam.course;
    if (after.largest <= kMet) return "";
    std::array<char, 96> text{};
    if (course.is_eased) {
        const char* place = course.is_upright ? "matched from its lower end" : "matched in its middle";
        std::snprintf(text.data(), text.size(), "its sides differ by %.1f mm: %s",
                      1e3 * std::abs(course.first_length - course.second_length),
                      after.is_anchored ? place : "other seams determine the offsets of its panels");
        return text.data();
    }
    if (seam.seam->first.panel == seam.seam->second.panel) return "both sides belong to one panel";
    if (is_opposed_without_mirror(seam)) return "its sides run in opposite directions, and the sett has no mirror";
    if (mismatch_alone(seam) > kMet) return "its sides meet the stripes at different angles";
    return "other seams determine the offsets of its panels";
}

// Priority level per seam, lower first: first_seams in their order; other seams that can meet; seams that cannot; then,
// in the same order, seams that no stripe of this family crosses.
std::vector<int> levels_of(const std::vector<SeamLines>& seams, const std::vector<int>& first_seams, Family f) {
    const int named = static_cast<int>(first_seams.size());
    std::vector<int> levels;
    levels.reserve(seams.size());
    for (const SeamLines& seam : seams) levels.push_back(mismatch_alone(seam) <= kMatchable ? named : named + 1);
    for (int i = named; i-- > 0;) {
        levels[static_cast<std::size_t>(first_seams[static_cast<std::size_t>(i)])] = i;
    }
    for (std::size_t s = 0; s < seams.size(); ++s) {
        if (!seams[s].lines[static_cast<std::size_t>(f)].is_crossing) levels[s] += named + 2;
    }
    return levels;
}

// The weft offset nearest to `offset` that moves a mirror line of the warp's stripes midway between the panel's
// outermost points along the weft.
double centred_offset(const Panel& panel, const StripeRepeat& repeat, double offset) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const OutlineEdge& edge : panel.edges) {
        for (const Vec2d& u : outline_polyline(panel, edge, kMet)) {
            const double across = std::cos(panel.grain_angle) * u.x() + std::sin(panel.grain_angle) * u.y();
            low = std::min(low, across);
            high = std::max(high, across);
        }
    }
    const double centred = *repeat.mirror - (low + high) / 2;
    return offset + wrapped(centred - offset, repeat.size / 2);  // mirror lines are half a repeat apart
}

// The offset problem of one family. Its nodes are the panels sorted by name, so that the order in the file affects only
// which panel keeps its offset.
class FamilyMatch {
 public:
    FamilyMatch(const Pattern& pattern, const std::vector<SeamLines>& seams, const MatchOptions& options, Family f)
        : seams_(seams), family_(f), panels_(pattern.panels.size()), node_(pattern.panels.size()) {
        std::iota(panels_.begin(), panels_.end(), 0U);
        std::sort(panels_.begin(), panels_.end(),
                  [&](std::size_t a, std::size_t b) { return pattern.panels[a].name < pattern.panels[b].name; });
        for (std::size_t n = 0; n < panels_.size(); ++n) node_[panels_[n]] = static_cast<int>(n);
        problem_.nodes = static_cast<int>(panels_.size());
        for (const std::size_t panel : panels_) problem_.rank.push_back(static_cast<int>(panel));
        if (options.centred_panel) {
            problem_.rank[static_cast<std::size_t>(node_[static_cast<std::size_t>(*options.centred_panel)])] = -1;
        }
        add_terms(levels_of(seams, options.first_seams, f));
    }

    void solve(Offsets& offsets) {
        if (problem_.terms.empty()) return;
        std::vector<double> start;
        for (const std::size_t panel : panels_) start.push_back(offsets[panel][family_]);
        const std::vector<double> found = solve_offsets(problem_, start);
        for (std::size_t n = 0; n < panels_.size(); ++n) {
            if (std::abs(wrapped(found[n] - start[n], problem_.repeat)) < kOffsetStep) continue;
            offsets[panels_[n]][family_] = as_written(found[n], problem_.repeat);
        }
    }

 private:
    void add_terms(const std::vector<int>& levels) {
        struct Ordered {
            OffsetTerm term;
            double weight = 0;
            const std::string* name = nullptr;
        };
        const double most = std::clamp(kMaxSamples / static_cast<double>(seams_.size() + 1), 32.0, 1024.0);
        std::vector<Ordered> ordered;
        for (std::size_t s = 0; s < seams_.size(); ++s) {
            const SeamLines& seam = seams_[s];
            const Lines& lines = seam.lines[static_cast<std::size_t>(family_)];
            if (lines.repeat.size <= 0 || seam.length() <= 0) continue;
            problem_.repeat = lines.repeat.size;
            OffsetTerm term{.a = node_[static_cast<std::size_t>(seam.seam->first.panel)],
                            .b = node_[static_cast<std::size_t>(seam.seam->second.panel)],
                            .is_mirrored = lines.is_mirrored,
                            .level = levels[s],
                            .samples = samples_of(seam, family_, most)};
            const double weight = weight_of(term);
            ordered.push_back({std::move(term), weight, &seam.name});
        }
        std::sort(ordered.begin(), ordered.end(), [](const Ordered& a, const Ordered& b) {
            return a.weight != b.weight ? a.weight > b.weight : *a.name < *b.name;
        });
        for (Ordered& entry : ordered) problem_.terms.push_back(std::move(entry.term));
    }

    const std::vector<SeamLines>& seams_;
    Family family_;
    std::vector<std::size_t> panels_;  // panel index per node
    std::vector<int> node_;            // node per panel
    OffsetProblem problem_;
};

}  // namespace

bool is_sett_of(const MatchedSett& matched, const Sett& sett) {
    const auto is_near = [](double a, double b) { return std::abs(a - b) < 1e-4; };
    if (!is_near(matched.repeat.x(), repeat_size(sett)) || !is_near(matched.repeat.y(), weft_repeat_size(sett))) {
        return false;
    }
    try {
        const Sett same = with_repeat_size(find_tartan(matched.tartan), matched.repeat.x());
        return thread_colours(same) == thread_colours(sett) && weft_thread_colours(same) == weft_thread_colours(sett);
    } catch (const InputError&) {
        return false;  // the tartan is not shipped
    }
}

SettMatch match_sett(const Pattern& pattern, const Sett& sett, const MatchOptions& options) {
    const std::array<StripeRepeat, 2> repeats{warp_repeat(sett), weft_repeat(sett)};
    std::vector<SeamLines> seams;
    for (const Seam& seam : pattern.seams) seams.push_back(find_lines(pattern, seam, repeats));
    for (const int seam : options.first_seams) {
        SELVEDGE_ASSERT(seam >= 0 && seam < static_cast<int>(pattern.seams.size()));
    }
    Offsets before;
    for (const Panel& panel : pattern.panels) {
        before.push_back(panel.sett_offset.allFinite() ? panel.sett_offset : Vec2d(0, 0));
    }
    SettMatch match{.offsets = before, .seams = {}};
    if (options.centred_panel && repeats[0].mirror) {
        const auto panel = static_cast<std::size_t>(*options.centred_panel);
        SELVEDGE_ASSERT(panel < pattern.panels.size());
        const double offset = centred_offset(pattern.panels[panel], repeats[0], before[panel].x());
        match.offsets[panel].x() = as_written(offset, repeats[0].size);
    }
    for (Family f = 0; f < 2; ++f) FamilyMatch(pattern, seams, options, f).solve(match.offsets);

    for (std::size_t s = 0; s < seams.size(); ++s) {
        const SeamLines& seam = seams[s];
        const auto at = [&](const Offsets& offsets) {
            return measure(seam, offset_of(offsets, seam.seam->first), offset_of(offsets, seam.seam->second));
        };
        const Mismatch was = at(before);
        const Mismatch is = at(match.offsets);
        match.seams.push_back({.seam = static_cast<int>(s),
                               .name = seam.name,
                               .length = seam.length(),
                               .before = was.largest,
                               .after = is.largest,
                               .rms_before = was.rms,
                               .rms_after = is.rms,
                               .met = is.met,
                               .why = reason(seam, is)});
    }
    return match;
}

namespace {

constexpr double kEase = 1e-3;          // m; same tolerance as in the check of a pattern
constexpr double kPointSpacing = 1e-3;  // m; the finest lines of a tartan are about 2 mm wide
constexpr double kChordError = 1e-6;    // m

// An outline edge as a polyline with points by arc length.
class Walk {
 public:
    Walk(const Panel& panel, const OutlineEdge& edge) : points_(outline_polyline(panel, edge, kChordError)) {
        reached_.push_back(0);
        for (std::size_t i = 1; i < points_.size(); ++i) {
            reached_.push_back(reached_.back() + (points_[i] - points_[i - 1]).norm());
        }
    }

    double length() const { return reached_.back(); }

    Vec2d at(double fraction) const {
        const double wanted = fraction * length();
        const auto above = std::upper_bound(reached_.begin() + 1, reached_.end() - 1, wanted);
        const auto i = static_cast<std::size_t>(above - reached_.begin());
        const double span = reached_[i] - reached_[i - 1];
        const double t = span > 0 ? std::clamp((wanted - reached_[i - 1]) / span, 0.0, 1.0) : 0.0;
        return points_[i - 1] + t * (points_[i] - points_[i - 1]);
    }

 private:
    std::vector<Vec2d> points_;
    std::vector<double> reached_;  // m, arc length per point
};

const OutlineEdge& edge_of(const Pattern& pattern, const SeamSide& side) {
    return panel_of(pattern, side).edges[static_cast<std::size_t>(side.edge)];
}

Vec2d turned_to_grain(const Vec2d& u, double grain) {
    const double c = std::cos(grain), s = std::sin(grain);
    return {c * u.x() + s * u.y(), -s * u.x() + c * u.y()};
}

Vec2d direction(const Vec2d& from, const Vec2d& to) {
    const double length = (to - from).norm();
    return length > 0 ? Vec2d((to - from) / length) : Vec2d(0, 0);
}

void find_directions(SeamCourse& course) {
    std::vector<CoursePoint>& points = course.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const CoursePoint& before = points[i == 0 ? 0 : i - 1];
        const CoursePoint& after = points[std::min(i + 1, points.size() - 1)];
        const Vec2d first = direction(before.first, after.first);
        const Vec2d second = direction(before.second, after.second);
        points[i].crossing = 0.5 * (first.cwiseAbs() + second.cwiseAbs());
        course.agreement += first.cwiseProduct(second) / static_cast<double>(points.size());
    }
}

void find_anchor(const Panel& panel, const Vec2d& start, const Vec2d& end, SeamCourse& course) {
    const double rise = panel.place(end).y() - panel.place(start).y();
    course.is_eased = std::abs(course.first_length - course.second_length) > kEase;
    course.is_upright = std::abs(rise) >= 0.5 * course.first_length;
    const std::size_t last = course.points.size() - 1;
    course.anchor = !course.is_upright ? last / 2 : rise > 0 ? 0 : last;
}

}  // namespace

SeamCourse find_course(const Pattern& pattern, const Seam& seam) {
    const Panel& first_panel = panel_of(pattern, seam.first);
    const Panel& second_panel = panel_of(pattern, seam.second);
    const Walk first(first_panel, edge_of(pattern, seam.first));
    const Walk second(second_panel, edge_of(pattern, seam.second));
    SeamCourse course;
    course.first_length = first.length();
    course.second_length = second.length();
    const double longer = std::max(first.length(), second.length());
    const int steps = static_cast<int>(std::clamp(std::ceil(longer / kPointSpacing), 64.0, 1024.0));
    for (int i = 0; i <= steps; ++i) {
        const double t = double(i) / steps;
        course.points.push_back(
            {.first = turned_to_grain(first.at(t), first_panel.grain_angle),
             .second = turned_to_grain(second.at(seam.is_reversed ? 1 - t : t), second_panel.grain_angle)});
    }
    find_directions(course);
    find_anchor(first_panel, first.at(0), first.at(1), course);
    return course;
}

}  // namespace selvedge::sim
