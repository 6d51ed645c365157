#include "sim/proposals/seam_proposals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "sim/core/math.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/proposals/chain_evidence.h"

namespace selvedge::sim {
namespace {

constexpr double kCorner = 28 * std::numbers::pi / 180;  // rad: turns by less are no corners

double confidence_of(double odds) {
    return 1 / (1 + std::exp(-odds));
}

struct Candidate {
    ChainView first, second;
    Evidence evidence;
};

// ---- Which pairs are compared.

bool share_atoms(const Chain& a, const Chain& b) {
    return std::ranges::any_of(a.atoms, [&](int atom) { return std::ranges::find(b.atoms, atom) != b.atoms.end(); });
}

// How far the middle of an atom lies from the line between its ends, over its length.
double bend_of(const OpenBoundary& boundary, int atom) {
    const Vec2d middle = (boundary.point(atom, 0) + boundary.point(atom, 1)) / 2;
    return (boundary.point(atom, 0.5) - middle).norm() / boundary.atom(atom).length;
}

// Whether a straight stretch goes on in a curve, as a shoulder in a wide neckline, or the other way round.
bool begins_to_curve(const OpenBoundary& boundary, int atom, int next) {
    constexpr double kStraight = 0.002, kCurved = 0.02;
    const auto [less, more] = std::minmax({bend_of(boundary, atom), bend_of(boundary, next)});
    return less < kStraight && more > kCurved;
}

// Whether the level top of a whole panel is divided by a vertex at which it does not turn, as the shoulder from the
// neckline that goes on in one line with it, at one edge's length from a side.
bool divides_a_level_line(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, int atom, int next) {
    constexpr double kStraight = 0.002;  // bend
    constexpr double kLevel = 0.97;      // least run of a level line over its length
    const auto is_level = [&](int one) {
        const double run = boundary.point(one, 0).x() - boundary.point(one, 1).x();  // at the top: to the left
        return bend_of(boundary, one) < kStraight && run > kLevel * boundary.atom(one).length;
    };
    const EdgeSpan &before = boundary.atom(atom).span, &after = boundary.atom(next).span;
    const PanelFacts& panel = facts[as_size(after.panel)];
    const bool begins_at_side = is_at_side(panel, boundary.point(atom, 0).x());
    const bool ends_at_side = is_at_side(panel, boundary.point(next, 1).x());
    return before.panel == after.panel && before.edge != after.edge && panel.is_symmetric && is_level(atom) &&
           is_level(next) && begins_at_side != ends_at_side;
}

// Whether a seam may also end where another one begins within a chain.
enum class SeamEnds { AtCorners, AlsoAtSeams };

// Places on a chain at which a seam may begin or end: where the outline turns a little, as from the back seam of an
// upper sleeve to its cap, or a torso's begins to curve, or a vertex divides its level top; and notches of strips, as
// on a waistband with an overlap.
std::vector<double> stops_of(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const Chain& chain,
                             SeamEnds ends) {
    constexpr double kTurn = 8 * std::numbers::pi / 180;  // rad
    constexpr std::size_t kMostTurns = 6;
    std::vector<double> stops{0, 1};
    if (chain.is_loop) return stops;
    const std::vector<double> shares = boundary.starts(chain);
    const GarmentPart part = facts[as_size(boundary.atom(chain.atoms[0]).span.panel)].role.part;
    for (std::size_t k = 0; k + 1 < chain.atoms.size() && stops.size() < 2 + kMostTurns; ++k) {
        const OpenBoundary::Step step = boundary.next(chain.atoms[k]);
        if (step.seams > 0) {
            // Where the side begins, a sleeve may have a corner that the armhole has not.
            const auto panel = [&](int atom) { return boundary.atom(atom).span.panel; };
            const bool leaves_panel = panel(chain.atoms[k]) != panel(chain.atoms[k + 1]);
            if (ends == SeamEnds::AlsoAtSeams && part == GarmentPart::Torso && leaves_panel)
                stops.push_back(shares[k + 1]);
            continue;
        }
        const bool turns = std::abs(step.angle - std::numbers::pi) > kTurn;
        const bool curves = part == GarmentPart::Torso && begins_to_curve(boundary, chain.atoms[k], chain.atoms[k + 1]);
        const bool divides =
            part == GarmentPart::Torso && divides_a_level_line(boundary, facts, chain.atoms[k], chain.atoms[k + 1]);
        if (turns || curves || divides) stops.push_back(shares[k + 1]);
    }
    const bool is_strip = part == GarmentPart::Waistband || part == GarmentPart::Cuff || part == GarmentPart::Collar ||
                          part == GarmentPart::CollarStand;
    std::ranges::sort(stops);
    if (!is_strip) return stops;
    for (const AtomNotch& notch : notches_of(boundary, chain)) {
        const double at = shares[notch.atom] + notch.t * boundary.atom(chain.atoms[notch.atom]).length / chain.length;
        // A notch beside a vertex marks the vertex.
        constexpr double kBeside = 0.003;  // m
        const auto vertex =
            std::ranges::find_if(shares, [&](double share) { return std::abs(share - at) * chain.length < kBeside; });
        const double stop = vertex == shares.end() ? at : *vertex;
        if (stop > 0.01 && stop < 0.99) stops.push_back(stop);
    }
    std::ranges::sort(stops);
    return stops;
}

// All ways in which a chain can be one side of a seam: a loop from each of its joints on, a strip also in part.
std::vector<ChainView> views_of(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const Chain& chain,
                                SeamEnds ends) {
    std::vector<ChainView> views;
    if (chain.is_loop) {
        for (std::size_t i = 0; i < chain.atoms.size(); ++i) views.push_back({chain, static_cast<int>(i), 0, 1});
        return views;
    }
    constexpr double kLeastPart = 0.25;      // of a chain
    constexpr double kLeastShoulder = 0.04;  // m: a wide neckline may go on from a short shoulder without a corner
    const bool is_torso = facts[as_size(boundary.atom(chain.atoms[0]).span.panel)].role.part == GarmentPart::Torso;
    const double least = is_torso ? std::min(kLeastPart, kLeastShoulder / chain.length) : kLeastPart;
    const std::vector<double> stops = stops_of(boundary, facts, chain, ends);
    for (std::size_t i = 0; i < stops.size(); ++i) {
        for (std::size_t j = i + 1; j < stops.size(); ++j) {
            if (stops[j] - stops[i] > least) views.push_back({chain, 0, stops[i], stops[j]});
        }
    }
    return views;
}

class Search {
 public:
    Search(const Pattern& pattern, const ProposalOptions& options)
        : boundary_(pattern), facts_(facts_of(pattern, options.hints)), options_(options) {}

    std::vector<SeamProposal> run() {
        constexpr int kMostSeams = 400;
        for (int i = 0; i < kMostSeams; ++i) {
            std::vector<Candidate> candidates = compare_all();
            if (candidates.empty() || confidence_of(candidates[0].evidence.odds) < options_.accepted) {
                // Whole chains first: what they leave may be sewn in part.
                if (std::exchange(ends_, SeamEnds::AlsoAtSeams) == SeamEnds::AtCorners) continue;
                add_unaccepted(candidates);
                break;
            }
            out_.push_back(take(candidates[0]));
        }
        return std::move(out_);
    }

 private:
    // For the reader to choose from.
    void add_unaccepted(const std::vector<Candidate>& candidates) {
        constexpr std::size_t kMost = 60;
        const OpenBoundary as_found = boundary_;
        for (std::size_t i = 0; i < std::min(kMost, candidates.size()); ++i) {
            out_.push_back(take(candidates[i]));
            boundary_ = as_found;  // each by itself: they exclude each other
        }
    }

    // From the most to the least likely. Darts come first: the seams beside them are whole when they are closed.
    std::vector<Candidate> compare_all() const {
        const std::vector<Chain> chains = boundary_.chains(kCorner);
        std::vector<std::vector<ChainView>> views;
        for (const Chain& chain : chains) views.push_back(views_of(boundary_, facts_, chain, ends_));
        std::vector<Candidate> candidates;
        for (std::size_t i = 0; i < chains.size(); ++i) {
            if (auto best = best_within(views[i])) candidates.push_back(std::move(*best));
            for (std::size_t j = i + 1; j < chains.size(); ++j) {
                if (share_atoms(chains[i], chains[j])) continue;
                if (auto best = best_of(views[i], views[j])) candidates.push_back(std::move(*best));
            }
        }
        std::ranges::stable_sort(candidates, std::greater<>(), [&](const Candidate& one) {
            const bool comes_first = one.evidence.is_dart && confidence_of(one.evidence.odds) >= options_.accepted;
            return std::pair(comes_first, one.evidence.odds);
        });
        return candidates;
    }

    // The likeliest way to sew two whole edges of one chain, as the second shoulders at the ends of a cowl and the
    // neckline behind it; none if none is likely at all.
    std::optional<Candidate> best_within(const std::vector<ChainView>& views) const {
        std::vector<ChainView> edges;
        for (const ChainView& view : views) {
            const int panel = boundary_.atom(view.chain.atoms[0]).span.panel;
            const bool is_torso = facts_[as_size(panel)].role.part == GarmentPart::Torso;  // its stops are edges' ends
            const bool is_part = !view.chain.is_loop && (view.from > 0 || view.to < 1);
            if (is_torso && is_part && joints_of(boundary_, view).empty()) edges.push_back(view);
        }
        std::optional<Candidate> best;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (std::size_t j = i + 1; j < edges.size(); ++j) {
                if (edges[j].from < edges[i].to || edges[i].from == edges[j].from) continue;
                auto found = best_of({edges[i]}, {edges[j]});
                if (found && (!best || found->evidence.odds > best->evidence.odds)) best = std::move(found);
            }
        }
        return best;
    }

    // The likeliest way to sew two chains; none if none is likely at all.
    std::optional<Candidate> best_of(const std::vector<ChainView>& a, const std::vector<ChainView>& b) const {
        std::optional<Candidate> best;
        for (const ChainView& first : a) {
            // One loop may begin anywhere if it is sewn to another loop: all that counts is how both lie together.
            for (const ChainView& second : b) {
                Evidence evidence = weigh(boundary_, facts_, first, second);
                if (!evidence.is_possible || confidence_of(evidence.odds) < options_.least_confidence) continue;
                if (!best || evidence.odds > best->evidence.odds + 1e-9) best = Candidate{first, second, evidence};
            }
        }
        return best;
    }

    // Fractions of both sides at which the seam is divided into pairs of stretches. Joints of both sides that nearly
    // meet are one; between two of these the seam is divided in proportion.
    struct Joint {
        double first = 0;                              // fraction of the first side
        double second = 0;                             // of the second, from its own start
        bool is_on_first = true, is_on_second = true;  // whether an edge ends there
    };
    std::vector<Joint> joints(const Candidate& candidate) const {
        const double one = length_of(candidate.first), other = length_of(candidate.second);
        const double ease = 1.5 * std::abs(one - other) / std::max(one, other);
        const double near = std::max(0.004 / one, 0.006), snap = std::max(near, std::min(0.08, ease));
        const std::vector<double> a = joints_of(boundary_, candidate.first);
        std::vector<double> b;
        for (const double t : joints_of(boundary_, candidate.second)) b.push_back(1 - t);
        std::ranges::sort(b);
        std::vector<std::pair<double, double>> met = joints_that_meet(a, b, snap);
        even_out(met, near);
        std::vector<Joint> joints;
        for (std::size_t k = 1; k + 1 < met.size(); ++k)
            joints.push_back({met[k].first, 1 - met[k].second, true, true});
        for (std::size_t k = 0; k + 1 < met.size(); ++k) {
            const auto [low_a, low_b] = met[k];
            const auto [high_a, high_b] = met[k + 1];
            const double slope = (high_b - low_b) / (high_a - low_a);
            for (const double t : a) {
                if (t > low_a && t < high_a) joints.push_back({t, 1 - (low_b + slope * (t - low_a)), true, false});
            }
            for (const double t : b) {
                if (t > low_b && t < high_b) joints.push_back({low_a + (t - low_b) / slope, 1 - t, false, true});
            }
        }
        std::ranges::sort(joints, {}, &Joint::first);
        keep_apart(joints, one, other);
        return joints;
    }

    // Pairs of fractions, ascending, of which each is the nearest of the other.
    static std::vector<std::pair<double, double>> joints_that_meet(const std::vector<double>& a,
                                                                   const std::vector<double>& b, double snap) {
        const auto nearest = [](const std::vector<double>& all, double t) {
            return std::ranges::min_element(all, {}, [&](double s) { return std::abs(s - t); });
        };
        std::vector<std::pair<double, double>> pairs{{0, 0}};
        for (const double t : a) {
            const auto near = nearest(b, t);
            if (near != b.end() && std::abs(*near - t) < snap && *nearest(a, *near) == t) pairs.emplace_back(t, *near);
        }
        pairs.emplace_back(1, 1);
        return pairs;
    }

    // Between two pairs neither side may be much longer than the other: of the two, the pair that meets worse is left
    // out.
    static void even_out(std::vector<std::pair<double, double>>& pairs, double least) {
        constexpr double kMostUneven = 1.25;  // ratio, where that of the whole sides is 1
        const auto gap = [&](std::size_t k) { return std::abs(pairs[k].first - pairs[k].second); };
        for (std::size_t k = 1; k < pairs.size();) {
            const double one = pairs[k].first - pairs[k - 1].first, other = pairs[k].second - pairs[k - 1].second;
            const bool is_even =
                std::max(one, other) < kMostUneven * std::min(one, other) || std::abs(one - other) < least;
            if (is_even || pairs.size() == 2) {
                ++k;
                continue;
            }
            const std::size_t worse = gap(k - 1) > gap(k) ? k - 1 : k;
            pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(worse));
            k = std::max<std::size_t>(1, worse);
        }
    }

    // Moves joints along the side where no edge ends, so that no stretch is too short to be meshed.
    static void keep_apart(std::vector<Joint>& joints, double one, double other) {
        constexpr double kShortest = 0.0005;  // m
        const double first = std::min(0.2, kShortest / one), second = std::min(0.2, kShortest / other);
        double low = 0, high = 1;
        for (Joint& joint : joints) {
            if (!joint.is_on_first) joint.first = std::max(joint.first, low + first);
            if (!joint.is_on_second) joint.second = std::min(joint.second, high - second);
            low = joint.first;
            high = joint.second;
        }
        low = 0, high = 1;
        for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint) {
            if (!joint->is_on_first) joint->first = std::min(joint->first, high - first);
            if (!joint->is_on_second) joint->second = std::max(joint->second, low + second);
            high = joint->first;
            low = joint->second;
        }
    }

    // Divides the atoms so that each stretch between joints is one atom; returns them in order.
    std::vector<int> divide(const ChainView& view, std::vector<double> stops) {
        std::ranges::sort(stops);
        stops.insert(stops.begin(), 0);
        stops.push_back(1);
        std::vector<int> atoms;  // of the whole chain in order from view.first, as divided
        for (std::size_t k = 0; k < view.chain.atoms.size(); ++k)
            atoms.push_back(view.chain.atoms[(as_size(view.first) + k) % view.chain.atoms.size()]);
        for (const double stop : stops) {
            const double along = view.from + stop * (view.to - view.from);
            double reached = 0;
            for (std::size_t k = 0; k < atoms.size(); ++k) {
                const double share = boundary_.atom(atoms[k]).length / view.chain.length;
                const double t = (along - reached) / share;
                if (t > 1e-6 && t < 1 - 1e-6) {
                    atoms.insert(atoms.begin() + static_cast<std::ptrdiff_t>(k) + 1, boundary_.split(atoms[k], t));
                    break;
                }
                reached += share;
            }
        }
        std::vector<int> sewn;
        double reached = 0;
        for (const int a : atoms) {
            const double middle = reached + boundary_.atom(a).length / view.chain.length / 2;
            if (middle > view.from && middle < view.to) sewn.push_back(a);
            reached += boundary_.atom(a).length / view.chain.length;
        }
        return sewn;
    }

    // What sewing the candidate joins is its parts.
    SeamProposal take(const Candidate& candidate) {
        SeamProposal proposal;
        proposal.confidence = confidence_of(candidate.evidence.odds);
        proposal.reason = candidate.evidence.reason;
        proposal.is_eased = std::abs(length_of(candidate.first) - length_of(candidate.second)) > 0.001;
        proposal.parts = sew(candidate);
        return proposal;
    }

    std::vector<std::pair<EdgeSpan, EdgeSpan>> sew(const Candidate& candidate) {
        std::vector<double> a, b;
        for (const Joint& joint : joints(candidate)) {
            a.push_back(joint.first);
            b.push_back(joint.second);
        }
        const std::vector<int> first = divide(candidate.first, a);
        std::vector<int> second = divide(candidate.second, b);
        std::ranges::reverse(second);
        std::vector<std::pair<EdgeSpan, EdgeSpan>> parts;
        for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
            parts.emplace_back(boundary_.atom(first[i]).span, boundary_.atom(second[i]).span);
            boundary_.sew(first[i], second[i]);
        }
        return parts;
    }

    OpenBoundary boundary_;
    std::vector<PanelFacts> facts_;
    ProposalOptions options_;
    SeamEnds ends_ = SeamEnds::AtCorners;
    std::vector<SeamProposal> out_;
};

// The edges that a panel's proposals need, and where each stretch comes to lie.
class SpanCutter {
 public:
    explicit SpanCutter(const std::vector<SeamProposal>& proposals) {
        for (const SeamProposal& proposal : proposals) {
            for (const auto& [first, second] : proposal.parts) {
                add(first);
                add(second);
            }
        }
    }

    // Edges of higher index are cut first, so that those of lower index keep theirs.
    void cut(Pattern& pattern) const {
        for (auto at = stops_.rbegin(); at != stops_.rend(); ++at) {
            Panel& panel = pattern.panels[as_size(at->first.first)];
            double end = 1;
            for (auto stop = at->second.rbegin(); stop != at->second.rend(); ++stop) {
                split_edge(panel, at->first.second, *stop / end);
                end = *stop;
            }
        }
        for (Seam& seam : pattern.seams) {
            for (SeamSide* side : {&seam.first, &seam.second}) side->edge += shift(side->panel, side->edge);
        }
    }

    // The stretch as one of the edge that it lies on when all are cut.
    EdgeSpan after_cut(const EdgeSpan& span) const {
        EdgeSpan out{span.panel, span.edge + shift(span.panel, span.edge)};
        double low = 0, high = 1;
        if (const auto found = stops_.find({span.panel, span.edge}); found != stops_.end()) {
            for (const double t : found->second) {
                out.edge += t <= span.from + kSame ? 1 : 0;
                if (t <= span.from + kSame) low = t;
                if (t >= span.to - kSame) high = std::min(high, t);
            }
        }
        out.from = std::clamp((span.from - low) / (high - low), 0.0, 1.0);
        out.to = std::clamp((span.to - low) / (high - low), 0.0, 1.0);
        return out;
    }

    SeamSide side(const EdgeSpan& span) const { return {span.panel, after_cut(span).edge}; }

 private:
    static constexpr double kSame = 1e-9;  // of an edge's length

    void add(const EdgeSpan& span) {
        std::set<double>& stops = stops_[{span.panel, span.edge}];
        for (const double t : {span.from, span.to}) {
            if (t > kSame && t < 1 - kSame) stops.insert(t);
        }
    }

    // How many edges are new before this one.
    int shift(int panel, int edge) const {
        int count = 0;
        for (const auto& [at, stops] : stops_) {
            if (at.first == panel && at.second < edge) count += static_cast<int>(stops.size());
        }
        return count;
    }

    std::map<std::pair<int, int>, std::set<double>> stops_;  // per panel and edge
};

}  // namespace

std::vector<SeamProposal> propose_seams(const Pattern& pattern, const ProposalOptions& options) {
    return Search(pattern, options).run();
}

void accept_proposals(Pattern& pattern, const std::vector<SeamProposal>& proposals) {
    const SpanCutter cutter(proposals);
    cutter.cut(pattern);
    for (const SeamProposal& proposal : proposals) {
        const std::string sewing = proposal.parts.size() > 1 ? free_sewing_name(pattern) : std::string();
        for (const auto& [first, second] : proposal.parts) {
            Seam seam{.first = cutter.side(first), .second = cutter.side(second)};
            seam.is_eased = proposal.is_eased;
            seam.sewing = sewing;
            pattern.seams.push_back(seam);
        }
    }
}

std::vector<SeamProposal> after_acceptance(std::vector<SeamProposal> proposals,
                                           const std::vector<SeamProposal>& accepted) {
    const SpanCutter cutter(accepted);
    for (SeamProposal& proposal : proposals) {
        for (auto& [first, second] : proposal.parts) {
            first = cutter.after_cut(first);
            second = cutter.after_cut(second);
        }
    }
    return proposals;
}

std::string describe(const Pattern& pattern, const SeamProposal& proposal) {
    std::string sides;
    for (const bool is_first : {true, false}) {
        std::string side;
        std::pair<int, int> last{-1, -1};
        for (const auto& [first, second] : proposal.parts) {
            const EdgeSpan& span = is_first ? first : second;
            if (last == std::pair(span.panel, span.edge)) continue;
            last = {span.panel, span.edge};
            const std::string name = pattern.panels[as_size(span.panel)].name + "." + std::to_string(span.edge);
            side += (side.empty() ? "" : ", ") + name;
        }
        sides += (is_first ? "" : " to ") + side;
    }
    std::array<char, 16> percent{};
    std::snprintf(percent.data(), percent.size(), " (%.0f %%): ", 100 * proposal.confidence);
    return sides + percent.data() + proposal.reason;
}

}  // namespace selvedge::sim
