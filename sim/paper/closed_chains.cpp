#include "sim/paper/closed_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "sim/core/disjoint_sets.h"
#include "sim/core/printable.h"
#include "sim/pattern/polyline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

using PointLine = std::vector<Vec2d>;

Vec2d point_along(const PointLine& line, double length) {
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double step = (line[i] - line[i - 1]).norm();
        if (length <= step) return step > 0 ? Vec2d(line[i - 1] + length / step * (line[i] - line[i - 1])) : line[i];
        length -= step;
    }
    return line.back();
}

// ---- Ends that lie within the gap of each other are one node.

class Nodes {
 public:
    Nodes(const std::vector<PointLine>& lines, double gap) : sets_(2 * lines.size()) {
        struct Place {
            Vec2d at = Vec2d::Zero();
            double reach = 0;  // the widest of the ends that lie there
            int end = 0;       // the first of them
        };
        std::vector<Place> places;
        std::map<std::pair<double, double>, std::size_t> known;
        std::map<std::pair<long, long>, std::vector<std::size_t>> cells;
        const double cell = std::max(gap, std::numeric_limits<double>::min());
        const auto cell_of = [&](const Vec2d& p) {
            constexpr double kFar = 1e15;  // cells: coordinates have no finer digits there
            return std::pair(std::lround(std::clamp(p.x() / cell, -kFar, kFar)),
                             std::lround(std::clamp(p.y() / cell, -kFar, kFar)));
        };
        constexpr double kShare = 0.3;  // of the shorter line: the ends of one never meet
        for (std::size_t end = 0; end < 2 * lines.size(); ++end) {
            const Vec2d p = place(lines, end);
            const double reach = std::min(gap, kShare * polyline_length(lines[end / 2]));
            const auto [found, is_new] = known.emplace(std::pair(p.x(), p.y()), places.size());
            if (is_new) {
                places.push_back({p, reach, static_cast<int>(end)});
            } else {
                Place& same = places[found->second];
                sets_.join(same.end, static_cast<int>(end));
                if (reach <= same.reach) continue;
                same.reach = reach;
            }
            if (!(gap > 0)) continue;
            const auto [x, y] = cell_of(p);
            for (long dx = -1; dx <= 1; ++dx) {
                for (long dy = -1; dy <= 1; ++dy) {
                    const auto near = cells.find({x + dx, y + dy});
                    if (near == cells.end()) continue;
                    for (const std::size_t other : near->second) {
                        if ((places[other].at - p).norm() <= std::min(reach, places[other].reach))
                            sets_.join(places[other].end, static_cast<int>(end));
                    }
                }
            }
            if (is_new) cells[{x, y}].push_back(found->second);
        }
    }

    void join_ends_of(std::size_t line) { sets_.join(static_cast<int>(2 * line), static_cast<int>(2 * line + 1)); }

    int of_start(std::size_t line) { return sets_.find(static_cast<int>(2 * line)); }
    int of_end(std::size_t line) { return sets_.find(static_cast<int>(2 * line + 1)); }

 private:
    static const Vec2d& place(const std::vector<PointLine>& lines, std::size_t end) {
        return end % 2 == 0 ? lines[end / 2].front() : lines[end / 2].back();
    }

    DisjointSets sets_;
};

// ---- The lines as a plane graph. A line has two sides, which are numbered 2 line and 2 line + 1: run through as it is
// drawn, and reversed.

class LineGraph {
 public:
    LineGraph(const std::vector<PointLine>& lines, double gap) : lines_(lines), gap_(gap), nodes_(lines, gap) {
        is_used_.assign(lines.size(), false);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (lines[i].size() > 3 && (lines[i].front() - lines[i].back()).norm() <= gap) nodes_.join_ends_of(i);
        }
        for (std::size_t i = 0; i < lines.size(); ++i) {
            ends_.emplace_back(nodes_.of_start(i), nodes_.of_end(i));
            is_used_[i] = polyline_length(lines[i]) > 0;
        }
        drop_repeated();
        prune();
    }

    const std::vector<std::size_t>& repeated() const { return repeated_; }

    // The lines that hang together, each list in order; lines that are part of no ring are left out.
    std::vector<std::vector<std::size_t>> components() const {
        DisjointSets sets(2 * lines_.size());
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (is_used_[i]) sets.join(ends_[i].first, ends_[i].second);
        }
        std::map<int, std::vector<std::size_t>> lists;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (is_used_[i]) lists[sets.find(ends_[i].first)].push_back(i);
        }
        std::vector<std::vector<std::size_t>> all;
        for (auto& [root, list] : lists) all.push_back(std::move(list));
        return all;
    }

    struct Face {
        std::vector<std::size_t> sides;
        double area = 0;  // negative: seen from outside
    };

    // Rings that meet no node twice. Lines with the same face on both sides join two rings: they are taken out.
    std::vector<Face> faces(std::vector<std::size_t>& component) const {
        while (true) {
            const std::vector<std::vector<std::size_t>> rings = trace(component);
            std::map<std::size_t, std::size_t> face_of;
            for (std::size_t f = 0; f < rings.size(); ++f) {
                for (const std::size_t side : rings[f]) face_of[side] = f;
            }
            const auto is_bridge = [&](std::size_t line) { return face_of[2 * line] == face_of[2 * line + 1]; };
            if (std::erase_if(component, is_bridge) > 0) continue;
            std::vector<Face> faces;
            for (const std::vector<std::size_t>& ring : rings) {
                for (std::vector<std::size_t>& simple : simple_rings(ring)) {
                    const double area = area_of(simple);
                    faces.push_back({std::move(simple), area});
                }
            }
            return faces;
        }
    }

    double length(std::size_t line) const { return polyline_length(lines_[line]); }

    // Between the ends of neighbours.
    double widest_gap(const ClosedChain& chain) const {
        double widest = 0;
        for (std::size_t i = 0; i < chain.size(); ++i) {
            const ChainLink& one = chain[i];
            const ChainLink& next = chain[(i + 1) % chain.size()];
            const Vec2d& from = one.is_reversed ? lines_[one.line].front() : lines_[one.line].back();
            const Vec2d& to = next.is_reversed ? lines_[next.line].back() : lines_[next.line].front();
            widest = std::max(widest, (to - from).norm());
        }
        return widest;
    }

 private:
    int start(std::size_t side) const { return side % 2 == 0 ? ends_[side / 2].first : ends_[side / 2].second; }
    int end(std::size_t side) const { return start(side ^ 1U); }

    PointLine points(std::size_t side) const {
        PointLine line = lines_[side / 2];
        if (side % 2 != 0) std::ranges::reverse(line);
        return line;
    }

    void drop_repeated() {
        std::map<std::pair<int, int>, std::vector<std::size_t>> by_ends;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (!is_used_[i]) continue;
            std::vector<std::size_t>& same_ends = by_ends[std::minmax(ends_[i].first, ends_[i].second)];
            if (std::ranges::any_of(same_ends, [&](std::size_t other) { return lies_on(i, other); })) {
                is_used_[i] = false;
                repeated_.push_back(i);
            } else {
                same_ends.push_back(i);
            }
        }
    }

    bool lies_on(std::size_t line, std::size_t other) const {
        const double length = polyline_length(lines_[line]);
        if (std::abs(length - polyline_length(lines_[other])) > 2 * gap_ + 0.01 * length) return false;
        constexpr int kSamples = 8;
        for (int i = 1; i < kSamples; ++i) {
            const Vec2d p = point_along(lines_[line], length * i / kSamples);
            if (distance_to_polyline(p, lines_[other]) > gap_) return false;
        }
        return true;
    }

    // Takes out lines that end at nothing, again and again.
    void prune() {
        std::vector<int> degree(2 * lines_.size(), 0);
        std::map<int, std::vector<std::size_t>> at_node;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (!is_used_[i]) continue;
            for (const int node : {ends_[i].first, ends_[i].second}) {
                ++degree[as_size(node)];
                at_node[node].push_back(i);
            }
        }
        std::vector<int> loose;
        for (const auto& [node, list] : at_node) {
            if (degree[as_size(node)] == 1) loose.push_back(node);
        }
        while (!loose.empty()) {
            const int node = loose.back();
            loose.pop_back();
            for (const std::size_t line : at_node[node]) {
                if (!is_used_[line]) continue;
                is_used_[line] = false;
                for (const int other : {ends_[line].first, ends_[line].second}) {
                    if (--degree[as_size(other)] == 1) loose.push_back(other);
                }
            }
        }
    }

    // The direction in which a side leaves its node, rad: a little way along it, for the ends of a node differ.
    double direction(std::size_t side) const {
        constexpr double kAway = 8;  // gaps
        const PointLine line = points(side);
        const double length = polyline_length(line);
        const Vec2d along = point_along(line, std::min(length / 3, std::max(kAway * gap_, 1e-6 * length))) - line[0];
        return std::atan2(along.y(), along.x());
    }

    std::vector<std::vector<std::size_t>> trace(const std::vector<std::size_t>& component) const {
        std::map<int, std::vector<std::pair<double, std::size_t>>> leaving;  // by node, counter-clockwise
        for (const std::size_t line : component) {
            for (const std::size_t side : {2 * line, 2 * line + 1})
                leaving[start(side)].emplace_back(direction(side), side);
        }
        for (auto& [node, sides] : leaving) std::ranges::sort(sides);
        std::unordered_map<std::size_t, std::size_t> next;
        for (const auto& [node, sides] : leaving) {
            for (std::size_t i = 0; i < sides.size(); ++i)
                next[sides[i].second ^ 1U] = (i == 0 ? sides.back() : sides[i - 1]).second;
        }
        std::vector<std::vector<std::size_t>> rings;
        std::map<std::size_t, bool> is_done;
        for (const std::size_t line : component) {
            for (const std::size_t first : {2 * line, 2 * line + 1}) {
                if (is_done[first]) continue;
                std::vector<std::size_t> ring;
                for (std::size_t side = first; !is_done[side]; side = next.at(side)) {
                    is_done[side] = true;
                    ring.push_back(side);
                }
                rings.push_back(std::move(ring));
            }
        }
        return rings;
    }

    std::vector<std::vector<std::size_t>> simple_rings(const std::vector<std::size_t>& ring) const {
        std::vector<std::vector<std::size_t>> simple;
        std::vector<std::size_t> path;
        std::unordered_map<int, std::size_t> index_of;  // of the side of the path that starts at a node
        for (const std::size_t side : ring) {
            index_of[start(side)] = path.size();
            path.push_back(side);
            const auto met = index_of.find(end(side));
            if (met == index_of.end()) continue;
            const auto first = path.begin() + static_cast<std::ptrdiff_t>(met->second);
            simple.emplace_back(first, path.end());
            for (auto one = first; one != path.end(); ++one) index_of.erase(start(*one));
            path.erase(first, path.end());
        }
        return simple;
    }

    double area_of(const std::vector<std::size_t>& ring) const {
        PointLine all;
        for (const std::size_t side : ring) {
            const PointLine line = points(side);
            all.insert(all.end(), line.begin(), line.end());
        }
        double twice = 0;
        for (std::size_t i = 0; i < all.size(); ++i)
            twice += cross2(all[i] - all[0], all[(i + 1) % all.size()] - all[0]);
        return twice / 2;
    }

    const std::vector<PointLine>& lines_;
    double gap_;
    Nodes nodes_;
    std::vector<std::pair<int, int>> ends_;  // nodes of each line
    std::vector<bool> is_used_;
    std::vector<std::size_t> repeated_;
};

// ---- From faces to chains.

using Face = LineGraph::Face;

// The ring that is seen from outside, from within; none: nothing is enclosed.
std::vector<Face> outer_faces(std::vector<Face> faces) {
    std::erase_if(faces, [](const Face& face) { return face.area >= 0; });
    for (Face& face : faces) {
        std::ranges::reverse(face.sides);
        for (std::size_t& side : face.sides) side ^= 1U;
        face.area = -face.area;
    }
    return faces;
}

// The lines that a face has in common with its neighbour of the longest common border; none: it has no neighbour.
std::vector<std::size_t> longest_border(const LineGraph& graph, const std::vector<Face>& faces,
                                        const std::unordered_map<std::size_t, std::size_t>& face_of, std::size_t of) {
    std::map<std::size_t, std::pair<double, std::vector<std::size_t>>> borders;
    for (const std::size_t side : faces[of].sides) {
        const auto other = face_of.find(side ^ 1U);
        if (other == face_of.end() || other->second == of || faces[other->second].area <= 0) continue;
        auto& [length, lines] = borders[other->second];
        length += graph.length(side / 2);
        lines.push_back(side / 2);
    }
    std::pair<double, std::vector<std::size_t>> longest;
    for (auto& [face, border] : borders) {
        if (border.first > longest.first) longest = std::move(border);
    }
    return longest.second;
}

std::vector<Face> inner_faces(const LineGraph& graph, std::vector<std::size_t> component, double least_share) {
    while (true) {
        std::vector<Face> faces = graph.faces(component);
        double largest = 0;
        std::unordered_map<std::size_t, std::size_t> face_of;  // by side
        for (std::size_t f = 0; f < faces.size(); ++f) {
            largest = std::max(largest, faces[f].area);
            for (const std::size_t side : faces[f].sides) face_of[side] = f;
        }
        std::vector<std::size_t> border;
        double least = least_share * largest;
        for (std::size_t f = 0; f < faces.size(); ++f) {
            if (faces[f].area <= 0 || faces[f].area >= least) continue;
            std::vector<std::size_t> lines = longest_border(graph, faces, face_of, f);
            if (lines.empty()) continue;
            least = faces[f].area;
            border = std::move(lines);
        }
        if (border.empty()) {
            std::erase_if(faces, [](const Face& face) { return face.area <= 0; });
            return faces;
        }
        const std::set<std::size_t> gone(border.begin(), border.end());
        std::erase_if(component, [&](std::size_t line) { return gone.contains(line); });
    }
}

}  // namespace

ClosedChains find_closed_chains(const std::vector<std::vector<Vec2d>>& lines, const ChainOptions& options) {
    constexpr std::size_t kMostFaces = 300;
    const LineGraph graph(lines, options.gap);
    ClosedChains found{.chains = {}, .repeated = graph.repeated()};
    std::vector<Face> all;
    for (std::vector<std::size_t>& component : graph.components()) {
        std::vector<Face> faces = graph.faces(component);
        if (faces.size() > kMostFaces) continue;
        faces = options.branches == Branches::Outer ? outer_faces(std::move(faces))
                                                    : inner_faces(graph, component, options.least_share);
        std::ranges::move(faces, std::back_inserter(all));
    }
    std::ranges::stable_sort(all, std::greater<>(), &Face::area);
    std::map<std::size_t, int> times;
    for (const Face& face : all) {
        ClosedChain chain;
        for (const std::size_t side : face.sides) {
            chain.push_back({side / 2, side % 2 != 0});
            found.shared += ++times[side / 2] == 2 ? 1 : 0;
        }
        found.widest_gap = std::max(found.widest_gap, graph.widest_gap(chain));
        found.chains.push_back(std::move(chain));
    }
    return found;
}

ClosedChains join_in_passes(const std::vector<KeyedLine>& lines, double gap, const std::vector<Branches>& branches) {
    ClosedChains all;
    std::vector<bool> is_used(lines.size(), false);
    for (std::size_t pass = 0; pass < branches.size(); ++pass) {
        std::map<std::string, std::vector<std::size_t>> groups;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (!is_used[i]) groups[pass < lines[i].keys.size() ? lines[i].keys[pass] : std::string()].push_back(i);
        }
        for (const auto& [key, members] : groups) {
            std::vector<PointLine> points;
            for (const std::size_t i : members) points.push_back(lines[i].points);
            ClosedChains found = find_closed_chains(points, {.gap = gap, .branches = branches[pass]});
            for (ClosedChain& chain : found.chains) {
                for (ChainLink& link : chain) {
                    link.line = members[link.line];
                    is_used[link.line] = true;
                }
                all.chains.push_back(std::move(chain));
            }
            for (const std::size_t i : found.repeated) {
                all.repeated.push_back(members[i]);
                is_used[members[i]] = true;
            }
            all.widest_gap = std::max(all.widest_gap, found.widest_gap);
            all.shared += found.shared;
        }
    }
    return all;
}

double join_gap(const std::optional<double>& metres_per_unit, double size) {
    constexpr double kShare = 2e-4;
    return metres_per_unit ? kJoinGap / *metres_per_unit : kShare * size;
}

std::string joined_note(std::size_t outlines, double widest_gap, const std::optional<double>& metres_per_unit) {
    constexpr double kToldGap = 1e-5;  // m: narrower ones are rounding
    std::string note = count_text(outlines, "outline") + " drawn in pieces: joined where lines meet";
    if (!metres_per_unit || widest_gap * *metres_per_unit <= kToldGap) return note;
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), ", up to %.2g mm apart", 1000 * *metres_per_unit * widest_gap);
    return note + text.data();
}

namespace {

struct Cut {
    std::size_t segment = 0;
    double fraction = 0;
    Vec2d place = Vec2d::Zero();
};
using Cuts = std::vector<std::vector<Cut>>;  // per line

void cut_at_ends(const std::vector<PointLine>& lines, double gap, Cuts& cuts) {
    struct End {
        Vec2d at = Vec2d::Zero();
        std::size_t line = 0;
    };
    std::vector<End> ends;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        ends.push_back({lines[i].front(), i});
        ends.push_back({lines[i].back(), i});
    }
    const auto x_of = [](const End& end) { return end.at.x(); };
    std::ranges::stable_sort(ends, {}, x_of);
    std::vector<std::size_t> cut_line(ends.size(), lines.size());  // the last one that each end cut
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const PointLine& line = lines[i];
        for (std::size_t s = 0; s + 1 < line.size(); ++s) {
            const Vec2d low = line[s].cwiseMin(line[s + 1]).array() - gap;
            const Vec2d high = line[s].cwiseMax(line[s + 1]).array() + gap;
            const auto first = std::ranges::lower_bound(ends, low.x(), {}, x_of);
            for (auto end = first; end != ends.end() && end->at.x() <= high.x(); ++end) {
                const Vec2d& p = end->at;
                std::size_t& last_cut = cut_line[static_cast<std::size_t>(end - ends.begin())];
                if (p.y() < low.y() || p.y() > high.y() || end->line == i || last_cut == i) continue;
                if ((p - line.front()).norm() <= gap || (p - line.back()).norm() <= gap) continue;
                if (distance_to_segment(p, line[s], line[s + 1]) > gap) continue;
                cuts[i].push_back({s, nearest_fraction(p, line[s], line[s + 1]), p});
                last_cut = i;
            }
        }
    }
}

// Both lines where their segments cross, unless the end of one lies there. No more than kMostPairs of segments that lie
// above each other are looked at: what a drawing of garments never has, and half a second.
void cut_at_crossings(const std::vector<PointLine>& lines, double gap, Cuts& cuts) {
    constexpr std::size_t kMostPairs = 100'000'000;
    struct Segment {
        std::size_t line = 0, index = 0;
        double low = 0, high = 0;  // along x
    };
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (std::size_t s = 0; s + 1 < lines[i].size(); ++s) {
            const auto [low, high] = std::minmax(lines[i][s].x(), lines[i][s + 1].x());
            segments.push_back({i, s, low, high});
        }
    }
    std::ranges::stable_sort(segments, {}, &Segment::low);
    const auto is_at_end = [&](const Vec2d& p, const PointLine& line) {
        return (p - line.front()).norm() <= gap || (p - line.back()).norm() <= gap;
    };
    std::size_t pairs = 0;
    for (auto one = segments.begin(); one != segments.end(); ++one) {
        const PointLine& line = lines[one->line];
        const Vec2d &a = line[one->index], along = line[one->index + 1] - a;
        for (auto two = one + 1; two != segments.end() && two->low <= one->high; ++two) {
            if (++pairs > kMostPairs) return;
            if (two->line == one->line) continue;
            const PointLine& other = lines[two->line];
            const Vec2d &b = other[two->index], across = other[two->index + 1] - b;
            const double turn = cross2(along, across);
            if (turn == 0) continue;
            const double t = cross2(b - a, across) / turn, u = cross2(b - a, along) / turn;
            if (!(t >= 0 && t <= 1 && u >= 0 && u <= 1)) continue;
            const Vec2d p = a + t * along;
            if (is_at_end(p, line) || is_at_end(p, other)) continue;
            cuts[one->line].push_back({one->index, t, p});
            cuts[two->line].push_back({two->index, u, p});
        }
    }
}

}  // namespace

CutLines cut_where_they_meet(const std::vector<std::vector<Vec2d>>& lines, double gap) {
    Cuts all(lines.size());
    cut_at_ends(lines, gap, all);
    cut_at_crossings(lines, gap, all);
    CutLines out;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const PointLine& line = lines[i];
        std::vector<Cut>& cuts = all[i];
        std::ranges::stable_sort(cuts, {}, [](const Cut& cut) { return std::pair(cut.segment, cut.fraction); });
        PointLine rest;
        std::size_t next = 0;
        for (std::size_t s = 0; s < line.size(); ++s) {
            rest.push_back(line[s]);
            for (; next < cuts.size() && cuts[next].segment == s; ++next) {
                if ((cuts[next].place - rest.front()).norm() <= gap) continue;
                rest.push_back(cuts[next].place);
                out.lines.push_back(std::exchange(rest, {cuts[next].place}));
                out.origin.push_back(i);
            }
        }
        out.lines.push_back(std::move(rest));
        out.origin.push_back(i);
    }
    return out;
}

}  // namespace selvedge::sim
