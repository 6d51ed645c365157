// Sewing one run of edges to another, 1:N.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "editor/drafting/draft.h"
#include "editor/drafting/follow.h"
#include "editor/drafting/seam_edit.h"
#include "sim/pattern/outline.h"

namespace selvedge {
namespace {

constexpr double kSnap = 1e-4;  // m, joints nearer than this are one
constexpr double kSame = 1e-9;  // fractions nearer than this are one

// A run, walked from its start: where each span ends, as share of the run's length.
struct Run {
    std::vector<EdgeSpan> spans;
    std::vector<double> reached;  // 0, then after each span
    double length = 0;            // m
};

Run measured(const Pattern& pattern, const std::vector<EdgeSpan>& spans) {
    if (spans.empty()) throw DraftError("There is nothing to sew on one side.");
    Run run{spans, {0}, 0};
    for (EdgeSpan& span : run.spans) {
        const SeamSide side{span.panel, span.edge};
        const double length = outline_length(panel_of(pattern, span.panel), edge_of(pattern, side));
        if (!(span.from >= 0 && span.from < span.to && span.to <= 1)) {
            throw DraftError("The part of the edge that is to be sewn has no length.", {place_of(pattern, side)});
        }
        if (span.from * length < kSnap) span.from = 0;
        if ((1 - span.to) * length < kSnap) span.to = 1;
        if (seam_at(pattern, side)) {
            throw DraftError("This edge of panel " + panel_of(pattern, span.panel).name + " is sewn already.",
                             {place_of(pattern, side)});
        }
        run.length += length * (span.to - span.from);
        run.reached.push_back(run.length);
    }
    for (double& reached : run.reached) reached /= run.length;
    return run;
}

// Where the runs are joined across, as shares of each, from the start of the first.
struct Joint {
    double first = 0;
    double second = 0;
};

std::vector<Joint> joints_of(const Run& first, const Run& second, bool is_reversed) {
    const auto across = [&](double share) { return is_reversed ? 1 - share : share; };
    const double snap = kSnap / std::min(first.length, second.length);
    std::vector<Joint> joints;
    for (const double share : first.reached) joints.push_back({share, across(share)});
    for (const double share : second.reached) {
        const auto near = std::find_if(joints.begin(), joints.end(), [&](const Joint& joint) {
            return std::abs(joint.first - across(share)) < snap;
        });
        if (near != joints.end()) {
            near->second = share;
        } else {
            joints.push_back({across(share), share});
        }
    }
    std::sort(joints.begin(), joints.end(), [](const Joint& a, const Joint& b) { return a.first < b.first; });
    return joints;
}

// The part of one span between two shares of its run.
EdgeSpan piece_of(const Run& run, double low, double high) {
    const double middle = (low + high) / 2;
    const auto above = std::upper_bound(run.reached.begin() + 1, run.reached.end() - 1, middle);
    const auto i = static_cast<std::size_t>(above - run.reached.begin() - 1);
    EdgeSpan piece = run.spans[i];
    const double begin = run.reached[i];
    const double width = run.reached[i + 1] - begin;
    const double size = piece.to - piece.from;
    if (high < run.reached[i + 1] - kSame) piece.to = piece.from + size * (high - begin) / width;
    if (low > begin + kSame) piece.from += size * (low - begin) / width;
    return piece;
}

// Splits edges at the ends of pieces, and says which edge each piece has become.
class PieceCutter {
 public:
    explicit PieceCutter(const std::vector<EdgeSpan>& pieces) {
        for (const EdgeSpan& piece : pieces) {
            std::vector<double>& cuts = cuts_[{piece.panel, piece.edge}];
            for (const double t : {piece.from, piece.to}) {
                const bool is_known =
                    std::any_of(cuts.begin(), cuts.end(), [&](double cut) { return std::abs(cut - t) < kSame; });
                if (t > 0 && t < 1 && !is_known) cuts.push_back(t);
            }
            std::sort(cuts.begin(), cuts.end());
        }
    }

    // From the last to the first, so that what is still to be split keeps its index.
    void cut(Pattern& draft) const {
        for (auto entry = cuts_.rbegin(); entry != cuts_.rend(); ++entry) {
            double whole = 1;
            for (auto t = entry->second.rbegin(); t != entry->second.rend(); ++t) {
                split_alone(draft, entry->first, *t / whole);
                whole = *t;
            }
        }
    }

    SeamSide edge_of_piece(const EdgeSpan& piece) const {
        int edge = piece.edge;
        for (const auto& [side, cuts] : cuts_) {
            if (side.panel != piece.panel || side.edge > piece.edge) continue;
            const double until = side.edge < piece.edge ? 1 : piece.from + kSame;
            edge += static_cast<int>(std::count_if(cuts.begin(), cuts.end(), [&](double t) { return t <= until; }));
        }
        return {piece.panel, edge};
    }

 private:
    std::map<SeamSide, std::vector<double>> cuts_;  // ascending
};

void expect_apart(const Pattern& pattern, std::vector<EdgeSpan> pieces) {
    std::sort(pieces.begin(), pieces.end(), [](const EdgeSpan& a, const EdgeSpan& b) {
        return std::tie(a.panel, a.edge, a.from) < std::tie(b.panel, b.edge, b.from);
    });
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const EdgeSpan& one = pieces[i - 1];
        const EdgeSpan& next = pieces[i];
        if (one.panel != next.panel || one.edge != next.edge || next.from >= one.to - kSame) continue;
        throw DraftError("A part of an edge would be sewn twice.", {place_of(pattern, {next.panel, next.edge})});
    }
}

}  // namespace

std::vector<int> sew_runs(Pattern& pattern, const std::vector<EdgeSpan>& first, const std::vector<EdgeSpan>& second,
                          bool is_reversed) {
    const Run run = measured(pattern, first);
    const Run other = measured(pattern, second);
    const std::vector<Joint> joints = joints_of(run, other, is_reversed);
    std::vector<EdgeSpan> pieces;
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const auto [low, high] = std::minmax(joints[i].second, joints[i + 1].second);
        pieces.push_back(piece_of(run, joints[i].first, joints[i + 1].first));
        pieces.push_back(piece_of(other, low, high));
    }
    expect_apart(pattern, pieces);
    const PieceCutter cutter(pieces);
    return edit_draft(pattern, [&](Pattern& draft) {
        cutter.cut(draft);
        std::vector<int> seams;
        for (std::size_t i = 0; i < pieces.size(); i += 2) {
            seams.push_back(static_cast<int>(draft.seams.size()));
            draft.seams.push_back({cutter.edge_of_piece(pieces[i]), cutter.edge_of_piece(pieces[i + 1]), is_reversed});
        }
        return seams;
    });
}

}  // namespace selvedge
