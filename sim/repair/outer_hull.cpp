#include "sim/repair/outer_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "sim/core/assert.h"
#include "sim/core/disjoint_sets.h"

namespace selvedge::sim {
namespace {

using Node = std::array<int, 3>;

constexpr std::array<std::array<std::size_t, 3>, 3> kAxes{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}};  // along, u, v

Node moved(Node node, std::size_t axis, int by) {
    node[axis] += by;
    return node;
}

// Nodes of a grid of cubes round the surface, with at least one cell beside it on each side.
class Grid {
 public:
    Grid(const Surface& surface, double cell) : cell_(cell) {
        // Off the places that files like, such as x = 0, so that hardly a line passes through an edge.
        constexpr std::array kOff{0.37, 0.41, 0.43};
        Eigen::AlignedBox3d box;
        for (const Vec3d& p : surface.x) box.extend(p);
        for (std::size_t k = 0; k < 3; ++k) {
            low_[int(k)] = (std::floor(box.min()[int(k)] / cell) - 2 + kOff[k]) * cell;
            count_[k] = int(std::ceil((box.max()[int(k)] - low_[int(k)]) / cell)) + 2;
        }
    }

    std::size_t size() const { return std::size_t(count_[0]) * std::size_t(count_[1]) * std::size_t(count_[2]); }
    int count(std::size_t axis) const { return count_[axis]; }
    double cell() const { return cell_; }
    double coordinate(std::size_t axis, int i) const { return low_[int(axis)] + i * cell_; }
    Vec3d place(const Node& node) const {
        return {coordinate(0, node[0]), coordinate(1, node[1]), coordinate(2, node[2])};
    }
    // The first of the coordinates along an axis that is not less, clamped to the grid.
    int first_from(std::size_t axis, double value) const {
        return int(std::clamp(std::ceil((value - low_[int(axis)]) / cell_), 0.0, double(count_[axis])));
    }
    std::size_t index(const Node& node) const {
        return (std::size_t(node[1]) * std::size_t(count_[2]) + std::size_t(node[2])) * std::size_t(count_[0]) +
               std::size_t(node[0]);
    }
    bool holds(const Node& node) const {
        for (std::size_t k = 0; k < 3; ++k)
            if (node[k] < 0 || node[k] >= count_[k]) return false;
        return true;
    }
    template <class Visit>
    void for_each(const Visit& visit) const {
        Node node{};
        for (node[1] = 0; node[1] < count_[1]; ++node[1])
            for (node[2] = 0; node[2] < count_[2]; ++node[2])
                for (node[0] = 0; node[0] < count_[0]; ++node[0]) visit(node);
    }

 private:
    double cell_;
    Vec3d low_ = Vec3d::Zero();
    std::array<int, 3> count_{};
};

// Where a line of the grid passes through a triangle.
struct Crossing {
    std::uint32_t line = 0;
    double at = 0;  // m, along the line
    int triangle = 0;
    int turn = 0;  // by how much the winding number changes there
};

// Whether p, a, b have positive orientation. The result for an edge has opposite values in its two directions, and zero
// is taken alike for both of its triangles, so that a line through an edge passes through just one of them.
bool is_left(const Vec2d& p, const Vec2d& a, const Vec2d& b, bool is_turned) {
    const Vec2d from = (is_turned ? b : a) - p, to = (is_turned ? a : b) - p;
    return (cross2(from, to) >= 0) != is_turned;
}

// Where the lines of a grid along one axis go in and out of what the pieces wind round.
class Lines {
 public:
    Lines(const Surface& surface, const Grid& grid, std::size_t axis) : grid_(grid), axis_(axis) {
        std::vector<Crossing> crossings;
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) cut(surface, int(t), crossings);
        std::ranges::sort(crossings, [](const Crossing& a, const Crossing& b) {
            return std::tuple(a.line, a.at, a.triangle) < std::tuple(b.line, b.at, b.triangle);
        });
        int winding = 0;
        for (std::size_t i = 0; i < crossings.size(); ++i) {
            if (i > 0 && crossings[i].line != crossings[i - 1].line) winding = 0;
            const bool was_inside = winding > 0;
            winding += crossings[i].turn;
            if (was_inside != (winding > 0)) borders_.push_back(crossings[i]);
        }
        first_.assign(std::size_t(lines()) + 1, 0);
        for (const Crossing& border : borders_) ++first_[border.line + 1];
        for (std::size_t i = 0; i + 1 < first_.size(); ++i) first_[i + 1] += first_[i];
    }

    std::span<const Crossing> borders(const Node& node) const {
        const std::size_t line = line_of(node[kAxes[axis_][1]], node[kAxes[axis_][2]]);
        return std::span(borders_).subspan(first_[line], first_[line + 1] - first_[line]);
    }

    // The last border before the node after this one, if it is on this side of it. Null: none.
    const Crossing* border_after(const Node& node) const {
        const double from = grid_.coordinate(axis_, node[axis_]), to = grid_.coordinate(axis_, node[axis_] + 1);
        const Crossing* found = nullptr;
        for (const Crossing& border : borders(node))
            if (border.at >= from && border.at < to) found = &border;
        return found;
    }

 private:
    std::uint32_t lines() const {
        return std::uint32_t(grid_.count(kAxes[axis_][1])) * std::uint32_t(grid_.count(kAxes[axis_][2]));
    }
    std::uint32_t line_of(int u, int v) const {
        return std::uint32_t(u) * std::uint32_t(grid_.count(kAxes[axis_][2])) + std::uint32_t(v);
    }

    void cut(const Surface& surface, int t, std::vector<Crossing>& crossings) const {
        const auto [along, u, v] = kAxes[axis_];
        const std::array<int, 3>& corners = surface.triangles[std::size_t(t)];
        std::array<Vec2d, 3> flat;
        std::array<double, 3> height{};
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d& p = surface.x[std::size_t(corners[k])];
            flat[k] = {p[int(u)], p[int(v)]};
            height[k] = p[int(along)];
        }
        const double area2 = cross2(Vec2d(flat[1] - flat[0]), Vec2d(flat[2] - flat[0]));
        if (area2 == 0) return;
        const Vec2d low = flat[0].cwiseMin(flat[1]).cwiseMin(flat[2]);
        const Vec2d high = flat[0].cwiseMax(flat[1]).cwiseMax(flat[2]);
        for (int i = grid_.first_from(u, low.x()); i < grid_.first_from(u, high.x()); ++i)
            for (int j = grid_.first_from(v, low.y()); j < grid_.first_from(v, high.y()); ++j) {
                const Vec2d p(grid_.coordinate(u, i), grid_.coordinate(v, j));
                const auto is_left_of = [&](std::size_t k) {
                    const std::size_t next = (k + 1) % 3;
                    return is_left(p, flat[k], flat[next], corners[k] > corners[next]);
                };
                if (is_left_of(0) != is_left_of(1) || is_left_of(0) != is_left_of(2)) continue;
                const double b = cross2(Vec2d(p - flat[0]), Vec2d(flat[2] - flat[0])) / area2;
                const double c = cross2(Vec2d(flat[1] - flat[0]), Vec2d(p - flat[0])) / area2;
                const double at = height[0] + b * (height[1] - height[0]) + c * (height[2] - height[0]);
                // A face that looks along the line is where it leaves.
                crossings.push_back({line_of(i, j), at, t, area2 > 0 ? -1 : 1});
            }
    }

    const Grid& grid_;
    std::size_t axis_;
    std::vector<Crossing> borders_;   // by line and place: into what is inside, or out of it
    std::vector<std::size_t> first_;  // per line, and one more
};

// Which nodes are inside: bits of the grid's nodes.
class Solid {
 public:
    Solid(const Grid& grid, const Lines& lines_along_x) : grid_(grid), is_inside_(grid.size(), false) {
        Node node{};
        for (node[1] = 0; node[1] < grid.count(1); ++node[1])
            for (node[2] = 0; node[2] < grid.count(2); ++node[2]) {
                const std::span<const Crossing> borders = lines_along_x.borders(node);
                for (std::size_t i = 0; i + 1 < borders.size(); i += 2)
                    for (node[0] = grid.first_from(0, borders[i].at); node[0] < grid.first_from(0, borders[i + 1].at);
                         ++node[0])
                        is_inside_[grid.index(node)] = true;
            }
    }

    bool at(const Node& node) const { return is_inside_[grid_.index(node)]; }

    // Fills what is lower than that (m) between what is above and below it: a tape, a waistband and a cuff go over the
    // groove between two pieces of a trunk. What is between two legs, or between an arm and the trunk, is higher.
    void fill_grooves(double highest) {
        const int most = int(highest / grid_.cell());
        Node node{};
        for (node[2] = 0; node[2] < grid_.count(2); ++node[2])
            for (node[0] = 0; node[0] < grid_.count(0); ++node[0]) {
                std::optional<int> last;  // that was inside
                for (node[1] = 0; node[1] < grid_.count(1); ++node[1]) {
                    if (!at(node)) continue;
                    const int to = node[1];
                    if (last && to - *last <= most + 1)
                        for (Node between = moved(node, 1, *last + 1 - to); between[1] < to; ++between[1])
                            is_inside_[grid_.index(between)] = true;
                    last = to;
                }
            }
    }

    // What is seen from hardly anywhere outside is inside, though gaps between pieces lead there: a trunk in its
    // armour.
    void fill_hidden() {
        constexpr int kSeen = 3;  // of 26 directions: the groove between two thighs is seen from the front and the back
        std::vector<std::uint8_t> seen(grid_.size(), 0);
        std::vector<bool> is_free(grid_.size());
        Node way{};
        for (way[0] = -1; way[0] <= 1; ++way[0])
            for (way[1] = -1; way[1] <= 1; ++way[1])
                for (way[2] = -1; way[2] <= 1; ++way[2])
                    if (way != Node{}) look_along(way, is_free, seen);
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (seen[i] < kSeen) is_inside_[i] = true;
    }

    // What cannot be reached from outside is inside.
    void fill_hollows() {
        std::vector<bool> is_outside(grid_.size(), false);
        std::vector<Node> waiting{Node{}};
        is_outside[grid_.index(waiting.front())] = true;
        while (!waiting.empty()) {
            const Node node = waiting.back();
            waiting.pop_back();
            for_each_neighbour(node, [&](const Node& next) {
                const std::size_t index = grid_.index(next);
                if (is_outside[index] || is_inside_[index]) return;
                is_outside[index] = true;
                waiting.push_back(next);
            });
        }
        is_inside_ = std::move(is_outside);
        is_inside_.flip();
    }

    // Joins parts that are apart by less than `most` (m), the nearest ones first, by all that is between them where
    // they are nearly as near as anywhere. So a foot is joined to its shin, but not a thigh to the other one.
    void bridge_gaps(double most) {
        Parts parts = find_parts();
        if (parts.count < 2) return;
        const std::vector<Between> all = between_parts(parts, most);
        std::map<std::pair<int, int>, double> gaps;
        for (const Between& node : all) {
            double& gap = gaps.try_emplace({node.first, node.second}, node.gap).first->second;
            gap = std::min(gap, node.gap);
        }
        std::vector<std::pair<double, std::pair<int, int>>> nearest;
        for (const auto& [pair, gap] : gaps) nearest.emplace_back(gap, pair);
        std::ranges::sort(nearest);
        DisjointSets joined(std::size_t(parts.count));
        std::set<std::pair<int, int>> bridged;
        for (const auto& [gap, pair] : nearest) {
            if (joined.find(pair.first) == joined.find(pair.second)) continue;
            joined.join(pair.first, pair.second);
            bridged.insert(pair);
        }
        constexpr double kNearly = 1;  // cell
        for (const Between& node : all) {
            const std::pair<int, int> pair{node.first, node.second};
            if (bridged.contains(pair) && node.gap <= gaps[pair] + kNearly * grid_.cell())
                is_inside_[node.index] = true;
        }
    }

    // Fills nodes until nowhere two parts meet at an edge or a corner of nodes only, so that what is round them is a
    // manifold. (Latecki 1997, 3D well-composed pictures)
    void compose_well() {
        std::vector<Node> waiting;
        grid_.for_each([&](const Node& node) {
            if (at(node)) waiting.push_back(node);
        });
        while (!waiting.empty()) {
            const Node node = waiting.back();
            waiting.pop_back();
            if (const auto filled = first_to_fill(node)) {
                is_inside_[grid_.index(*filled)] = true;
                waiting.push_back(node);
                waiting.push_back(*filled);
            }
        }
    }

 private:
    // Nodes that are inside, by what they hang together with.
    struct Parts {
        std::vector<int> of_node;  // -1 outside
        int count = 0;
    };

    // An outer node between two parts.
    struct Between {
        std::size_t index = 0;
        int first = 0, second = 0;  // parts, in order
        double gap = 0;             // m, the sum of its distances from both
    };

    // Counts the nodes from which a line along that way leaves the grid without meeting what is inside.
    void look_along(const Node& way, std::vector<bool>& is_free, std::vector<std::uint8_t>& seen) const {
        const auto ordered = [&](std::size_t axis, int i) { return way[axis] > 0 ? grid_.count(axis) - 1 - i : i; };
        grid_.for_each([&](const Node& step) {
            // The next node of the line comes first.
            const Node node{ordered(0, step[0]), ordered(1, step[1]), ordered(2, step[2])};
            const Node next{node[0] + way[0], node[1] + way[1], node[2] + way[2]};
            const std::size_t index = grid_.index(node);
            is_free[index] = !is_inside_[index] && (!grid_.holds(next) || is_free[grid_.index(next)]);
            if (is_free[index]) ++seen[index];
        });
    }

    Parts find_parts() const {
        Parts parts{.of_node = std::vector<int>(grid_.size(), -1)};
        grid_.for_each([&](const Node& from) {
            if (!at(from) || parts.of_node[grid_.index(from)] >= 0) return;
            parts.of_node[grid_.index(from)] = parts.count;
            std::vector<Node> waiting{from};
            while (!waiting.empty()) {
                const Node node = waiting.back();
                waiting.pop_back();
                for_each_neighbour(node, [&](const Node& next) {
                    int& part = parts.of_node[grid_.index(next)];
                    if (!at(next) || part >= 0) return;
                    part = parts.count;
                    waiting.push_back(next);
                });
            }
            ++parts.count;
        });
        return parts;
    }

    // The outer nodes that have two parts so near that the sum of the distances is less than `most` (m), with the
    // nearest two of them.
    std::vector<Between> between_parts(const Parts& parts, double most) const {
        struct Nearest {
            int part = -1;
            double distance = 0;
        };
        std::vector<int> place_of(grid_.size(), -1);
        std::vector<std::size_t> nodes;
        std::vector<std::array<Nearest, 2>> nearest;  // parallel to nodes
        const int reach = int(most / grid_.cell());
        std::vector<std::pair<Node, double>> offsets;
        Node offset{};
        for (offset[0] = -reach; offset[0] <= reach; ++offset[0])
            for (offset[1] = -reach; offset[1] <= reach; ++offset[1])
                for (offset[2] = -reach; offset[2] <= reach; ++offset[2]) {
                    const double distance = grid_.cell() * Vec3d(offset[0], offset[1], offset[2]).norm();
                    if (distance > 0 && distance < most) offsets.emplace_back(offset, distance);
                }
        grid_.for_each([&](const Node& node) {
            const int part = parts.of_node[grid_.index(node)];
            if (part < 0 || !is_at_border(node)) return;
            for (const auto& [by, distance] : offsets) {
                const Node other{node[0] + by[0], node[1] + by[1], node[2] + by[2]};
                if (!grid_.holds(other) || at(other)) continue;
                int& place = place_of[grid_.index(other)];
                if (place < 0) {
                    place = int(nodes.size());
                    nodes.push_back(grid_.index(other));
                    nearest.emplace_back();
                }
                std::array<Nearest, 2>& two = nearest[std::size_t(place)];
                Nearest& own = two[0].part == part || two[0].part < 0 ? two[0] : two[1];
                if (own.part == part ? distance < own.distance : own.part < 0 || distance < own.distance)
                    own = {part, distance};
                if (two[1].part >= 0 && two[1].distance < two[0].distance) std::swap(two[0], two[1]);
            }
        });
        std::vector<Between> all;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const std::array<Nearest, 2>& two = nearest[i];
            const double gap = two[0].distance + two[1].distance;
            if (two[1].part < 0 || gap > most) continue;
            all.push_back({nodes[i], std::min(two[0].part, two[1].part), std::max(two[0].part, two[1].part), gap});
        }
        return all;
    }

    bool is_at_border(const Node& node) const {
        bool is_so = false;
        for_each_neighbour(node, [&](const Node& next) { is_so = is_so || !at(next); });
        return is_so;
    }

    template <class Visit>
    void for_each_neighbour(const Node& node, const Visit& visit) const {
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
                const Node next = moved(node, axis, step);
                if (grid_.holds(next)) visit(next);
            }
    }

    // An outer node that must be filled for a node that is inside: on the way to another one that is, at an edge or a
    // corner from it; one of them for the pair, and the same for both of them where there is a choice.
    std::optional<Node> first_to_fill(const Node& node) const {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t other = (axis + 1) % 3;
            for (const int a : {-1, 1})
                for (const int b : {-1, 1}) {
                    const Node side = moved(node, axis, a), up = moved(node, other, b), over = moved(side, other, b);
                    if (at(over) && !at(side) && !at(up)) return std::min(side, up);
                }
        }
        // Two nodes across a cube of eight: both inside and no other, or both outside and no other.
        for (const int a : {-1, 1})
            for (const int b : {-1, 1})
                for (const int c : {-1, 1}) {
                    if (const auto filled = fill_cube(node, {a, b, c})) return filled;
                }
        return std::nullopt;
    }

    std::optional<Node> fill_cube(const Node& node, const Node& step) const {
        std::array<Node, 8> corners;
        unsigned inside = 0;
        for (unsigned i = 0; i < 8; ++i) {
            corners[i] = node;
            for (std::size_t k = 0; k < 3; ++k)
                if ((i >> k & 1U) != 0) corners[i][k] += step[k];
            if (at(corners[i])) inside |= 1U << i;
        }
        for (unsigned i = 0; i < 4; ++i) {
            const unsigned pair = 1U << i | 1U << (7 - i);
            if (inside == pair) return corners[i == 0 ? 1 : 0];
            if (inside == (0xFFU & ~pair)) return corners[i];
        }
        return std::nullopt;
    }

    const Grid& grid_;
    std::vector<bool> is_inside_;
};

// The surface between inner and outer nodes: a vertex in each cell through which it passes.
class Net {
 public:
    Net(const Surface& pieces, const Grid& grid, const Solid& solid, const std::array<Lines, 3>& lines)
        : pieces_(pieces), grid_(grid), solid_(solid), lines_(lines) {}

    Surface make() {
        vertex_.assign(grid_.size(), -1);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            grid_.for_each([&](const Node& node) {
                const Node next = moved(node, axis, 1);
                if (grid_.holds(next) && solid_.at(node) != solid_.at(next)) add_quad(node, axis);
            });
        }
        for (std::size_t v = 0; v < net_.x.size(); ++v) net_.x[v] /= double(places_[v]);
        go_on_between_pieces();
        for (std::size_t v = 0; v < net_.x.size(); ++v) net_.origin.push_back(origin_near(triangle_[v], net_.x[v]));
        for (const std::array<int, 4>& quad : quads_) halve(quad);
        return std::move(net_);
    }

 private:
    // Round the edge of the grid from a node along an axis: facing from inside out.
    void add_quad(const Node& node, std::size_t axis) {
        const auto [along, u, v] = kAxes[axis];
        const Crossing* border = lines_[axis].border_after(node);
        Vec3d place = grid_.place(node);
        place[int(axis)] = border != nullptr ? border->at : place[int(axis)] + grid_.cell() / 2;
        const std::array<Node, 4> cells{node, moved(node, u, -1), moved(moved(node, u, -1), v, -1), moved(node, v, -1)};
        std::array<int, 4> corners{};
        for (std::size_t k = 0; k < 4; ++k) corners[k] = vertex_in(cells[k], place, border);
        if (!solid_.at(node)) std::swap(corners[1], corners[3]);
        quads_.push_back(corners);
    }

    // The cell from that node, which the surface crosses at a place more.
    int vertex_in(const Node& cell, const Vec3d& place, const Crossing* border) {
        int& vertex = vertex_[grid_.index(cell)];
        if (vertex < 0) {
            vertex = int(net_.x.size());
            net_.x.emplace_back(Vec3d::Zero());
            places_.push_back(0);
            triangle_.push_back(-1);
        }
        net_.x[std::size_t(vertex)] += place;
        ++places_[std::size_t(vertex)];
        if (border != nullptr && triangle_[std::size_t(vertex)] < 0) triangle_[std::size_t(vertex)] = border->triangle;
        return vertex;
    }

    // Between pieces the surface follows nodes: it is smoothed there, and belongs to the triangle nearest along it.
    void go_on_between_pieces() {
        constexpr int kSmoothings = 12;
        std::vector<bool> is_between;
        for (const int triangle : triangle_) is_between.push_back(triangle < 0);
        std::vector<Vec3d> sum(net_.x.size());
        std::vector<int> count(net_.x.size());
        for (int i = 0; i < kSmoothings; ++i) {
            std::ranges::fill(sum, Vec3d::Zero());
            std::ranges::fill(count, 0);
            for_each_side([&](std::size_t from, std::size_t to) {
                sum[from] += net_.x[to];
                ++count[from];
            });
            for (std::size_t v = 0; v < sum.size(); ++v)
                if (is_between[v]) net_.x[v] = sum[v] / double(count[v]);
        }
        for (bool is_changed = true; is_changed;) {
            is_changed = false;
            const std::vector<int> before = triangle_;
            for_each_side([&](std::size_t from, std::size_t to) {
                if (triangle_[from] >= 0 || before[to] < 0) return;
                triangle_[from] = before[to];
                is_changed = true;
            });
        }
    }

    // In both directions: each twice, since two quads meet there.
    template <class Visit>
    void for_each_side(const Visit& visit) const {
        for (const std::array<int, 4>& quad : quads_)
            for (std::size_t k = 0; k < 4; ++k) {
                visit(std::size_t(quad[k]), std::size_t(quad[(k + 1) % 4]));
                visit(std::size_t(quad[(k + 1) % 4]), std::size_t(quad[k]));
            }
    }

    // The origin of the triangle's corner nearest to a point; of any, where nothing of a surface is in a triangle.
    int origin_near(int triangle, const Vec3d& p) const {
        if (triangle < 0) return pieces_.origin.front();
        const std::array<int, 3>& corners = pieces_.triangles[std::size_t(triangle)];
        const int nearest = *std::ranges::min_element(
            corners, {}, [&](int v) { return (pieces_.x[std::size_t(v)] - p).squaredNorm(); });
        return pieces_.origin[std::size_t(nearest)];
    }

    // Along its shorter diagonal.
    void halve(const std::array<int, 4>& quad) {
        const auto length = [&](std::size_t a, std::size_t b) {
            return (net_.x[std::size_t(quad[a])] - net_.x[std::size_t(quad[b])]).squaredNorm();
        };
        const std::size_t from = length(0, 2) <= length(1, 3) ? 0 : 1;
        for (const std::size_t k : {from, from + 2})
            net_.triangles.push_back({quad[k], quad[(k + 1) % 4], quad[(k + 2) % 4]});
    }

    const Surface& pieces_;
    const Grid& grid_;
    const Solid& solid_;
    const std::array<Lines, 3>& lines_;
    std::vector<int> vertex_;  // per cell, named by its lowest node
    std::vector<int> places_;  // per vertex: crossings in its cell
    std::vector<int> triangle_;
    std::vector<std::array<int, 4>> quads_;
    Surface net_;
};

// Weights by bone.
using BoneWeights = std::vector<std::pair<std::uint16_t, float>>;

void add_weights(const SkinWeights& skin, BoneWeights& sum) {
    for (std::size_t k = 0; k < 4; ++k) {
        if (!(skin.weights[k] > 0)) continue;
        const auto bone = std::ranges::find(sum, skin.bones[k], &std::pair<std::uint16_t, float>::first);
        if (bone == sum.end())
            sum.emplace_back(skin.bones[k], skin.weights[k]);
        else
            bone->second += skin.weights[k];
    }
}

// The four largest of them, as shares of 1.
SkinWeights largest_weights(BoneWeights& sum) {
    std::ranges::sort(sum, [](const auto& a, const auto& b) {
        return a.second > b.second || (a.second == b.second && a.first < b.first);
    });
    sum.resize(std::min<std::size_t>(sum.size(), 4));
    float all = 0;
    for (const auto& [bone, weight] : sum) all += weight;
    SkinWeights skin;
    for (std::size_t k = 0; k < sum.size(); ++k) {
        skin.bones[k] = sum[k].first;
        skin.weights[k] = sum[k].second / all;
    }
    return skin;
}

}  // namespace

bool is_of_parts(const Surface& pieces) {
    constexpr double kCounts = 0.01;  // of the area of all
    Triangles triangles = pieces.triangles;
    double largest = 0, all = 0;
    for (const SurfacePiece& piece : find_pieces(triangles)) {
        const double own = area(pieces.x, triangles, piece);
        largest = std::max(largest, own);
        all += own;
    }
    return all - largest > kCounts * all;
}

Surface outer_hull(const Surface& pieces, const OuterHullOptions& options) {
    SELVEDGE_ASSERT(options.cell > 0 && !pieces.triangles.empty());
    const Grid grid(pieces, options.cell);
    const std::array<Lines, 3> lines{Lines(pieces, grid, 0), Lines(pieces, grid, 1), Lines(pieces, grid, 2)};
    Solid solid(grid, lines[0]);
    solid.bridge_gaps(options.widest_gap);
    solid.fill_grooves(options.highest_groove);
    solid.fill_hidden();
    solid.fill_hollows();
    solid.compose_well();
    return Net(pieces, grid, solid, lines).make();
}

std::vector<SkinWeights> hull_skin(const Surface& hull, const std::vector<SkinWeights>& of_pieces) {
    constexpr int kSteps = 24;  // each over an edge: together some 25 mm to both sides of a joint
    std::vector<SkinWeights> skin;
    for (const int origin : hull.origin) skin.push_back(of_pieces[std::size_t(origin)]);
    std::vector<BoneWeights> sums(skin.size());
    for (int step = 0; step < kSteps; ++step) {
        for (std::size_t v = 0; v < skin.size(); ++v) {
            sums[v].clear();
            add_weights(skin[v], sums[v]);
        }
        for (const std::array<int, 3>& triangle : hull.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                add_weights(skin[std::size_t(triangle[(k + 1) % 3])], sums[std::size_t(triangle[k])]);
        for (std::size_t v = 0; v < skin.size(); ++v)
            if (!sums[v].empty()) skin[v] = largest_weights(sums[v]);
    }
    return skin;
}

}  // namespace selvedge::sim
