#include "sim/tartan/offset_graph.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

constexpr int kMaxSweeps = 40;
constexpr double kSame = 1e-9;  // relative to the largest possible cost: smaller differences count as equal

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// The offsets, and the pieces (sets of nodes that move together): moving a piece by d moves its node n by sign[n] * d.
struct State {
    std::vector<double> offset;
    std::vector<int> sign;
    std::vector<int> piece;
    std::vector<std::vector<int>> members;  // nodes per piece
    std::vector<bool> is_fixed;             // per piece: a mirrored cycle determines its position
};

struct Block {
    std::vector<int> nodes;  // nodes that move together
    int tried = 0;           // number of the last move in which it was tried
};

class Solver {
 public:
    Solver(const OffsetProblem& problem, const std::vector<double>& start)
        : problem_(problem), terms_of_(at(problem.nodes)), stamp_(at(problem.nodes), 0), moved_(at(problem.nodes), 0) {
        state_.offset = start;
        state_.sign.assign(at(problem.nodes), 1);
        state_.is_fixed.assign(at(problem.nodes), false);
        for (int n = 0; n < problem.nodes; ++n) {
            state_.piece.push_back(n);
            state_.members.push_back({n});
        }
        for (std::size_t t = 0; t < problem.terms.size(); ++t) {
            const OffsetTerm& term = problem.terms[t];
            terms_of_[at(term.a)].push_back(t);
            if (term.b != term.a) terms_of_[at(term.b)].push_back(t);
        }
    }

    std::vector<double> solve(const std::vector<double>& start) {
        std::vector<int> levels;
        for (const OffsetTerm& term : problem_.terms) levels.push_back(term.level);
        std::sort(levels.begin(), levels.end());
        levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
        std::vector<std::vector<std::size_t>> terms(levels.size());
        for (std::size_t t = 0; t < problem_.terms.size(); ++t) {
            const auto found = std::lower_bound(levels.begin(), levels.end(), problem_.terms[t].level);
            terms[static_cast<std::size_t>(found - levels.begin())].push_back(t);
        }
        for (std::size_t i = 0; i < levels.size(); ++i) solve_level(levels[i], terms[i]);
        for (std::size_t p = 0; p < state_.members.size(); ++p) settle(p, start);
        return state_.offset;
    }

 private:
    enum class Join { AsItStands, InOrder, InReverse };

    // Solves a level from three initial states (see Join) and keeps the result of lowest cost, the first of equal ones.
    void solve_level(int level, std::vector<std::size_t> terms) {
        level_ = level;
        if (terms.size() == 1) {  // the usual case for seams in first_seams
            blocks_.clear();
            join(problem_.terms[terms.front()], Join::InOrder);
            add_whole_pieces(terms);
            sweep();
            return hold(terms);
        }
        const State before = state_;
        State best;
        double least = 0;
        for (const Join how : {Join::AsItStands, Join::InOrder, Join::InReverse}) {
            state_ = before;
            blocks_.clear();
            add_whole_pieces(terms);  // the pieces before joining
            if (how == Join::InReverse) std::reverse(terms.begin(), terms.end());
            for (const std::size_t t : terms) join(problem_.terms[t], how);
            add_whole_pieces(terms);
            sweep();
            const double reached = cost(terms);
            if (how != Join::AsItStands && reached >= least - kSame * scale(terms)) continue;
            least = reached;
            best = std::move(state_);
        }
        state_ = std::move(best);
        hold(terms);
    }

    double value(const OffsetTerm& term) const {
        const double other = state_.offset[at(term.b)];
        return state_.offset[at(term.a)] + (term.is_mirrored ? other : -other);
    }

    double cost(const std::vector<std::size_t>& terms) const {
        double sum = 0;
        for (const std::size_t t : terms) {
            const OffsetTerm& term = problem_.terms[t];
            for (const OffsetSample& sample : term.samples) {
                sum += sample.weight * std::abs(wrapped(value(term) + sample.value, problem_.repeat));
            }
        }
        return sum;
    }

    double scale(const std::vector<std::size_t>& terms) const {
        double sum = 0;
        for (const std::size_t t : terms) {
            for (const OffsetSample& sample : problem_.terms[t].samples) sum += sample.weight * problem_.repeat;
        }
        return sum;
    }

    // The change of the term's value when the nodes stamped with now_ move by 1.
    int factor(const OffsetTerm& term) const {
        const int of_a = stamp_[at(term.a)] == now_ ? state_.sign[at(term.a)] : 0;
        const int of_b = stamp_[at(term.b)] == now_ ? state_.sign[at(term.b)] : 0;
        return of_a + (term.is_mirrored ? of_b : -of_b);
    }

    // Moves a block to the minimum cost of this level's seams at the block; `within`: only of seams between these two
    // pieces. Returns whether it moved.
    bool move(Block& block, const std::pair<int, int>* within = nullptr) {
        ++now_;
        for (const int n : block.nodes) stamp_[at(n)] = now_;
        std::vector<const OffsetTerm*> terms;
        int news = 0;  // number of the last move of a node of these terms
        for (const int n : block.nodes) {
            for (const std::size_t t : terms_of_[at(n)]) {
                const OffsetTerm& term = problem_.terms[t];
                if (term.level != level_ || factor(term) == 0) continue;
                if (n != term.a && stamp_[at(term.a)] == now_) continue;  // is visited at its node a
                if (within != nullptr && !is_within(term, *within)) continue;
                terms.push_back(&term);
                news = std::max({news, moved_[at(term.a)], moved_[at(term.b)]});
            }
        }
        const bool is_settled = block.tried > news;
        block.tried = now_;
        if (is_settled || terms.empty()) return false;
        std::vector<ShiftTerm> shifts;
        for (const OffsetTerm* term : terms) {
            for (const OffsetSample& sample : term->samples) {
                shifts.push_back({value(*term) + sample.value, sample.weight, factor(*term)});
            }
        }
        const double shift = best_shift(shifts, problem_.repeat);
        if (shift == 0) return false;
        for (const int n : block.nodes) {
            state_.offset[at(n)] += state_.sign[at(n)] * shift;
            moved_[at(n)] = now_;
        }
        return true;
    }

    bool is_within(const OffsetTerm& term, const std::pair<int, int>& pieces) const {
        const auto is_one = [&](int n) {
            const int piece = state_.piece[at(n)];
            return piece == pieces.first || piece == pieces.second;
        };
        return is_one(term.a) && is_one(term.b);
    }

    // Joins the pieces at the two ends of a term, with signs such that the term does not change when they move
    // together.
    void join(const OffsetTerm& term, Join how) {
        int large = state_.piece[at(term.a)];
        int small = state_.piece[at(term.b)];
        if (large == small) return;
        const auto size = [&](int piece) { return state_.members[at(piece)].size(); };
        const bool can_move_both = !state_.is_fixed[at(large)] && !state_.is_fixed[at(small)];
        if (can_move_both ? size(small) > size(large) : !state_.is_fixed[at(large)]) std::swap(large, small);
        if (state_.is_fixed[at(small)]) return;  // both are fixed
        const int product = state_.sign[at(term.a)] * state_.sign[at(term.b)];
        std::vector<int>& moving = state_.members[at(small)];
        if (product != (term.is_mirrored ? -1 : 1)) {
            for (const int n : moving) state_.sign[at(n)] *= -1;
        }
        const std::pair<int, int> pieces(large, small);
        blocks_.push_back({.nodes = moving});
        if (how != Join::AsItStands) move(blocks_.back(), &pieces);
        blocks_.back().tried = 0;  // it has not been tried with all seams yet
        for (const int n : moving) state_.piece[at(n)] = large;
        std::vector<int>& all = state_.members[at(large)];
        all.insert(all.end(), moving.begin(), moving.end());
        moving.clear();
    }

    void add_whole_pieces(const std::vector<std::size_t>& terms) {
        std::vector<bool> is_added(state_.members.size(), false);
        for (const std::size_t t : terms) {
            for (const int n : {problem_.terms[t].a, problem_.terms[t].b}) {
                const int piece = state_.piece[at(n)];
                if (is_added[at(piece)] || state_.is_fixed[at(piece)]) continue;
                is_added[at(piece)] = true;
                blocks_.push_back({.nodes = state_.members[at(piece)]});
            }
        }
    }

    void sweep() {
        for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
            bool has_moved = false;
            for (Block& block : blocks_) has_moved = move(block) || has_moved;
            if (!has_moved) return;
        }
    }

    // Fixes each piece that has an internal term whose value changes when the piece moves.
    void hold(const std::vector<std::size_t>& terms) {
        for (const std::size_t t : terms) {
            const OffsetTerm& term = problem_.terms[t];
            const int piece = state_.piece[at(term.a)];
            if (piece != state_.piece[at(term.b)]) continue;
            const int product = state_.sign[at(term.a)] * state_.sign[at(term.b)];
            if (product != (term.is_mirrored ? -1 : 1)) state_.is_fixed[at(piece)] = true;
        }
    }

    // Moves a piece that is not fixed so that its node of lowest rank has its offset from `start` again.
    void settle(std::size_t piece, const std::vector<double>& start) {
        const std::vector<int>& members = state_.members[piece];
        if (members.empty() || state_.is_fixed[piece]) return;
        const int keeps = *std::min_element(members.begin(), members.end(),
                                            [&](int a, int b) { return problem_.rank[at(a)] < problem_.rank[at(b)]; });
        const double shift = state_.sign[at(keeps)] * (start[at(keeps)] - state_.offset[at(keeps)]);
        for (const int n : members) state_.offset[at(n)] += state_.sign[at(n)] * shift;
    }

    const OffsetProblem& problem_;
    std::vector<std::vector<std::size_t>> terms_of_;
    State state_;
    std::vector<Block> blocks_;  // sets of nodes that are moved in this level
    int level_ = 0;
    std::vector<int> stamp_;  // per node: number of the last move that tried it
    std::vector<int> moved_;  // per node: number of the last move that moved it
    int now_ = 0;
};

}  // namespace

std::vector<double> solve_offsets(const OffsetProblem& problem, const std::vector<double>& start) {
    SELVEDGE_ASSERT(problem.repeat > 0 && start.size() == at(problem.nodes) && problem.rank.size() == start.size());
    return Solver(problem, start).solve(start);
}

namespace {

struct Breakpoint {
    double at = 0;       // m, in [0, repeat]
    double steeper = 0;  // increase of the slope there
};

// `value` modulo `repeat`, in [0, repeat).
double phase_of(double value, double repeat) {
    const double phase = value - std::floor(value / repeat) * repeat;
    return phase < repeat ? phase : 0;
}

// Adds the shifts in one repeat at which factor * shift has this phase: one for a factor of 1, two for 2.
void add_breakpoints(double phase, int factor, double steeper, double repeat, std::vector<Breakpoint>& breakpoints) {
    for (int turn = 0; turn < factor; ++turn) breakpoints.push_back({(phase + turn * repeat) / factor, steeper});
}

}  // namespace

double wrapped(double value, double repeat) {
    return value - std::round(value / repeat) * repeat;
}

double best_shift(const std::vector<ShiftTerm>& terms, double repeat) {
    std::vector<Breakpoint> breakpoints;
    double cost = 0;
    double slope = 0;  // just below shift 0
    double scale = 0;
    for (const ShiftTerm& term : terms) {
        const int factor = std::abs(term.factor);
        const double phase = phase_of(term.factor < 0 ? -term.value : term.value, repeat);
        const double weight = term.weight;
        cost += weight * std::min(phase, repeat - phase);
        slope += weight * factor * (phase > 0 && phase <= repeat / 2 ? 1 : -1);
        // Not by phase_of(): a breakpoint that rounds to a whole repeat must stay there and not move to 0, because the
        // initial slope does not include it.
        const double zero = phase > 0 ? repeat - phase : 0;
        const double farthest = phase <= repeat / 2 ? repeat / 2 - phase : repeat + (repeat / 2 - phase);
        add_breakpoints(zero, factor, 2 * weight * factor, repeat, breakpoints);
        add_breakpoints(farthest, factor, -2 * weight * factor, repeat, breakpoints);
        scale += weight * repeat;
    }
    std::sort(breakpoints.begin(), breakpoints.end(),
              [](const Breakpoint& a, const Breakpoint& b) { return a.at < b.at; });
    const double now = cost;
    double least = cost;
    std::vector<double> costs;  // at the breakpoints
    double at = 0;
    for (const Breakpoint& breakpoint : breakpoints) {
        cost += slope * (breakpoint.at - at);
        at = breakpoint.at;
        slope += breakpoint.steeper;
        costs.push_back(cost);
        least = std::min(least, cost);
    }
    if (now <= least + kSame * scale) return 0;
    double best = repeat;
    for (std::size_t i = 0; i < breakpoints.size(); ++i) {
        if (costs[i] > least + kSame * scale) continue;
        const double shift = breakpoints[i].at > repeat / 2 ? breakpoints[i].at - repeat : breakpoints[i].at;
        if (std::abs(shift) < std::abs(best) - kSame * repeat) best = shift;
    }
    return best;
}

namespace {

// The stripes of a repeat, with neighbouring stripes of the same colour merged, also the last with the first.
struct Runs {
    std::vector<SettStripe> runs;
    int start = 0;  // position of the first run, threads; negative if it begins before the repeat
};

Runs merge_runs(const std::vector<SettStripe>& stripes) {
    Runs merged;
    for (const SettStripe& stripe : stripes) {
        if (!merged.runs.empty() && merged.runs.back().colour == stripe.colour) {
            merged.runs.back().threads += stripe.threads;
        } else {
            merged.runs.push_back(stripe);
        }
    }
    if (merged.runs.size() > 1 && merged.runs.back().colour == merged.runs.front().colour) {
        merged.start = -merged.runs.back().threads;
        merged.runs.front().threads += merged.runs.back().threads;
        merged.runs.pop_back();
    }
    return merged;
}

bool is_same(const SettStripe& a, const SettStripe& b) {
    return a.colour == b.colour && a.threads == b.threads;
}

bool repeats_after(const std::vector<SettStripe>& runs, std::size_t count) {
    for (std::size_t i = count; i < runs.size(); ++i) {
        if (!is_same(runs[i], runs[i - count])) return false;
    }
    return true;
}

bool mirrors_about(const std::vector<SettStripe>& runs, std::size_t middle) {
    const std::size_t count = runs.size();
    for (std::size_t k = 1; 2 * k <= count; ++k) {
        if (!is_same(runs[(middle + k) % count], runs[(middle + count - k) % count])) return false;
    }
    return true;
}

StripeRepeat repeat_of(const std::vector<SettStripe>& stripes, double spacing) {
    Runs merged = merge_runs(stripes);
    StripeRepeat repeat;
    if (merged.runs.size() < 2) return repeat;
    for (std::size_t count = 2; count < merged.runs.size(); ++count) {
        if (merged.runs.size() % count != 0 || !repeats_after(merged.runs, count)) continue;
        merged.runs.resize(count);
        break;
    }
    int threads = 0;
    for (std::size_t i = 0; i < merged.runs.size(); ++i) {
        if (!repeat.mirror && mirrors_about(merged.runs, i)) {
            repeat.mirror = (merged.start + threads + 0.5 * merged.runs[i].threads) * spacing;
        }
        threads += merged.runs[i].threads;
    }
    repeat.size = threads * spacing;
    return repeat;
}

}  // namespace

StripeRepeat warp_repeat(const Sett& sett) {
    return repeat_of(sett.stripes, sett.thread_spacing);
}

StripeRepeat weft_repeat(const Sett& sett) {
    return repeat_of(weft_stripes(sett), sett.thread_spacing);
}

}  // namespace selvedge::sim
