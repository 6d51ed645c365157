#include "sim/dress/carry_over.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "sim/adaptive/criteria.h"
#include "sim/cloth/contact.h"
#include "sim/collide/collider.h"
#include "sim/core/assert.h"
#include "sim/core/math.h"
#include "sim/dress/outline_match.h"
#include "sim/mesh/sew.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/garments.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

using OutlineMatches = std::vector<OutlineMatch>;  // by panel

// How outlines correspond, by the keys of their edges. None: the panels are not the same. One may have another name,
// because the user may have renamed it.
std::optional<OutlineMatches> outline_matches(const Pattern& before, const Pattern& after) {
    if (before.panels.size() != after.panels.size()) return {};
    int renamed = 0;
    OutlineMatches matches;
    for (std::size_t p = 0; p < before.panels.size(); ++p) {
        const Panel &one = before.panels[p], &other = after.panels[p];
        if (one.is_mirrored != other.is_mirrored) return {};
        if (matches.emplace_back(one, other).is_empty()) return {};
        if (one.name != other.name) ++renamed;
    }
    if (renamed > 1) return {};
    return matches;
}

constexpr double kSameShare = 1e-5;  // of a stretch's length, closer places of seams are one

// A part of a seam: pieces of stretches that it joins, the lower one first.
struct Join {
    std::array<StretchPiece, 2> sides;
    std::array<int, 2> panels{};
    bool is_reversed = true;

    // Whether `next` goes on where this one ends, at the same ratio of lengths.
    bool goes_on_with(const Join& next) const {
        const auto is_same = [](double one, double other) { return std::abs(one - other) < kSameShare; };
        const StretchPiece &one = sides[0], &other = sides[1], &next_one = next.sides[0], &next_other = next.sides[1];
        return panels == next.panels && is_reversed == next.is_reversed && one.stretch == next_one.stretch &&
               other.stretch == next_other.stretch && is_same(one.to, next_one.from) &&
               (is_reversed ? is_same(other.from, next_other.to) : is_same(other.to, next_other.from)) &&
               is_same((one.to - one.from) * (next_other.to - next_other.from),
                       (other.to - other.from) * (next_one.to - next_one.from));
    }

    void take(const Join& next) {
        sides[0].to = next.sides[0].to;
        if (is_reversed) sides[1].from = next.sides[1].from;
        if (!is_reversed) sides[1].to = next.sides[1].to;
    }

    auto order() const { return std::tuple(panels, sides[0].stretch, sides[0].from); }
};

enum class OutlineState { Before, After };

// What the seams join, as parts of stretches that both states have: the same for a seam as for the parts of it.
std::vector<Join> joins_of(const Pattern& pattern, const OutlineMatches& matches, OutlineState state) {
    std::vector<Join> joins;
    for (const Seam& seam : pattern.seams) {
        Join join{.sides = {}, .panels = {seam.first.panel, seam.second.panel}, .is_reversed = seam.is_reversed};
        const auto piece = [&](const SeamSide& side) {
            const OutlineMatch& match = matches[as_size(side.panel)];
            return state == OutlineState::Before ? match.piece_before(side.edge) : match.piece_after(side.edge);
        };
        join.sides = {piece(seam.first), piece(seam.second)};
        const auto place = [&](std::size_t i) {
            return std::tuple(join.panels[i], join.sides[i].stretch, join.sides[i].from);
        };
        if (place(1) < place(0)) {
            std::swap(join.sides[0], join.sides[1]);
            std::swap(join.panels[0], join.panels[1]);
        }
        joins.push_back(join);
    }
    std::ranges::sort(joins, {}, &Join::order);
    std::vector<Join> merged;
    for (const Join& join : joins) {
        if (!merged.empty() && merged.back().goes_on_with(join)) {
            merged.back().take(join);
        } else {
            merged.push_back(join);
        }
    }
    return merged;
}

bool has_same_joins(const Pattern& a, const Pattern& b, const OutlineMatches& matches) {
    const auto is_same_piece = [](const StretchPiece& one, const StretchPiece& other) {
        return one.stretch == other.stretch && std::abs(one.from - other.from) < kSameShare &&
               std::abs(one.to - other.to) < kSameShare;
    };
    return std::ranges::equal(joins_of(a, matches, OutlineState::Before), joins_of(b, matches, OutlineState::After),
                              [&](const Join& one, const Join& other) {
                                  return one.panels == other.panels && one.is_reversed == other.is_reversed &&
                                         is_same_piece(one.sides[0], other.sides[0]) &&
                                         is_same_piece(one.sides[1], other.sides[1]);
                              });
}

bool is_worn_in_same_order(const Pattern& a, const Pattern& b) {
    return std::ranges::equal(garments_of(a), garments_of(b), {}, &Garment::panels, &Garment::panels);
}

template <class Get>
bool differ(const Pattern& a, const Pattern& b, const Get& get) {
    for (std::size_t p = 0; p < a.panels.size(); ++p) {
        if (get(a.panels[p]) != get(b.panels[p])) return true;
    }
    return false;
}

const Panel* find_panel(const Pattern& pattern, const std::string& name) {
    const auto found = std::ranges::find(pattern.panels, name, &Panel::name);
    return found == pattern.panels.end() ? nullptr : &*found;
}

// The seams that lie where open ones lay.
std::vector<OpenSeam> open_seams_after(const DrapeState& drape, const Pattern& after) {
    const OutlineMatches matches = outline_matches(drape.pattern, after).value();
    std::vector<OpenSeam> found;
    for (std::size_t i = 0; i < after.seams.size(); ++i) {
        const SeamSide& side = after.seams[i].first;
        const StretchPiece piece = matches[as_size(side.panel)].piece_after(side.edge);
        const double middle = (piece.from + piece.to) / 2;
        const auto lies_on = [&](const SeamSide& was) {
            const StretchPiece old = matches[as_size(was.panel)].piece_before(was.edge);
            return was.panel == side.panel && old.stretch == piece.stretch && old.from < middle && middle < old.to;
        };
        for (const OpenSeam& open : drape.open_seams) {
            const Seam& was = drape.pattern.seams[as_size(open.seam)];
            if (!lies_on(was.first) && !lies_on(was.second)) continue;
            found.push_back({static_cast<int>(i), open.gap});
            break;
        }
    }
    return found;
}

std::string count_of(std::size_t before, std::size_t after, const std::string& one) {
    const bool is_more = after > before;
    const std::size_t many = is_more ? after - before : before - after;
    return (many == 1 ? "one " + one : std::to_string(many) + " " + one + "s") + (is_more ? " more" : " fewer");
}

// Moves each unsewn vertex to its position in the drape and merges the seams, except those that were open.
void sew_in_place(GarmentMesh& mesh, const std::vector<OpenSeam>& open, const DrapedPanels& draped,
                  const std::vector<OutlineMap>& maps) {
    std::vector<bool> is_known(mesh.x.size(), false);
    for (const GarmentTriangle& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = static_cast<std::size_t>(triangle.vertices[k]);
            if (is_known[v]) continue;
            is_known[v] = true;
            const Vec2d was = maps[static_cast<std::size_t>(triangle.panel)](triangle.u[k]);
            const MaterialPoint at{static_cast<std::uint16_t>(triangle.panel), was.cast<float>()};
            mesh.x[v] = draped.position(at).cast<double>();
        }
    }
    std::erase_if(mesh.links, [&](const SeamLink& link) {
        return std::ranges::binary_search(open, link.seam, {}, &OpenSeam::seam);
    });
    merge_seams(mesh);
}

// Material points of a vertex, one per distinct position in its panels.
struct Places {
    std::vector<MaterialPoint> points;
};

std::vector<Places> places_of_vertices(const Cloth& cloth) {
    std::vector<Places> places(cloth.x.size());
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        for (std::size_t k = 0; k < 3; ++k) {
            std::vector<MaterialPoint>& points = places[leaf.v[k].value].points;
            const MaterialPoint at{leaf.panel, leaf.u[k]};
            if (std::ranges::find(points, at) == points.end()) points.push_back(at);
        }
    }
    return places;
}

// Moves all leaf vertices to the drape's positions of their material points, outside the body and with zero velocity.
void place_vertices(Cloth& cloth, const DrapedPanels& draped, const std::vector<OutlineMap>& maps,
                    const Collider& body) {
    const std::vector<Places> places = places_of_vertices(cloth);
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        Vec3f sum = Vec3f::Zero();
        for (const MaterialPoint& at : places[v.value].points) {
            const Vec2d was = maps[at.panel](at.u.cast<double>());
            sum += draped.position({at.panel, was.cast<float>()});
        }
        const Vec3f x = sum / static_cast<float>(places[v.value].points.size());
        cloth.x[v.value] = with_zero_w(outside(x, cloth.normals[v.value], body, ContactOptions{}.offset));
    }
    cloth.x_prev = cloth.x;
}

}  // namespace

PatternChange compare(const Pattern& before, const Pattern& after) {
    const std::optional<OutlineMatches> matches = outline_matches(before, after);
    if (!matches || !has_same_joins(before, after, *matches)) return PatternChange::Kind;
    if (!is_worn_in_same_order(before, after)) return PatternChange::Kind;
    const auto has_same_mesh = [](const Panel& one, const Panel& other) {
        return has_same_outline(one, other) && one.pins == other.pins &&
               std::ranges::equal(one.edges, other.edges, {}, &OutlineEdge::elastic, &OutlineEdge::elastic);
    };
    const auto is_same_seam = [](const Seam& one, const Seam& other) {
        return one.first == other.first && one.second == other.second;
    };
    if (before.edge_length != after.edge_length || !std::ranges::equal(before.panels, after.panels, has_same_mesh) ||
        !std::ranges::equal(before.seams, after.seams, is_same_seam)) {
        return PatternChange::Outlines;
    }
    const auto cloth = [](const Panel& panel) {
        return std::tuple(panel.fabric, panel.interlinings, panel.grain_angle);
    };
    if (before.fabric != after.fabric || differ(before, after, cloth)) return PatternChange::Fabrics;
    const auto shown = [](const Panel& panel) { return std::pair(panel.sett_offset, panel.name); };
    return differ(before, after, shown) ? PatternChange::Setts : PatternChange::None;
}

std::size_t count_worn_under(const Pattern& before, Pattern after) {
    const auto first = static_cast<int>(before.panels.size());
    if (after.panels.size() <= before.panels.size() || after.seams.size() < before.seams.size()) return 0;
    const std::vector<Garment> garments = garments_of(after);
    const auto outer = std::ranges::find_if(garments, [&](const Garment& one) { return one.panels.front() >= first; });
    if (std::any_of(garments.begin(), outer, [&](const Garment& one) { return one.panels.back() >= first; })) return 0;
    if (std::any_of(outer, garments.end(), [&](const Garment& one) { return one.panels.front() < first; })) return 0;
    for (std::size_t i = before.seams.size(); i < after.seams.size(); ++i) {
        if (after.seams[i].first.panel < first || after.seams[i].second.panel < first) return 0;
    }
    const auto count = static_cast<std::size_t>(outer - garments.begin());
    after.panels.resize(before.panels.size());
    after.seams.resize(before.seams.size());
    return compare(before, after) < PatternChange::Outlines ? count : 0;
}

std::string restart_reason(const Pattern& before, const Pattern& after) {
    const std::string whole = ": sewn anew from where the panels are placed";
    for (const Panel& panel : after.panels) {
        const Panel* was = find_panel(before, panel.name);
        if (was == nullptr) return "'" + panel.name + "' has come" + whole;
        if (was->is_mirrored != panel.is_mirrored || is_turned_over(*was, panel))
            return "'" + panel.name + "' was turned over" + whole;
        if (!OutlineMatch(*was, panel).is_empty()) continue;
        const std::string what = was->edges.size() == panel.edges.size()
                                     ? "another outline"
                                     : count_of(was->edges.size(), panel.edges.size(), "edge");
        return "'" + panel.name + "' has " + what + ": sewn anew from where it is placed";
    }
    for (const Panel& panel : before.panels) {
        if (find_panel(after, panel.name) == nullptr) return "'" + panel.name + "' is gone" + whole;
    }
    const std::optional<OutlineMatches> matches = outline_matches(before, after);
    if (!matches) return "the panels have another order" + whole;
    if (!has_same_joins(before, after, *matches)) {
        if (before.seams.size() == after.seams.size()) return "seams join other edges" + whole;
        return "there is " + count_of(before.seams.size(), after.seams.size(), "seam") + whole;
    }
    return "garments are worn in another order" + whole;
}

TransferredDrape transfer_drape(const DrapeState& drape, const Pattern& after, GarmentMesh mesh,
                                const std::vector<Fabric>& fabrics, const Collider& body,
                                const SimulationOptions& options, int deepest_level) {
    const DrapedPanels draped(drape.cloth);
    std::vector<OutlineMap> maps;
    for (std::size_t p = 0; p < after.panels.size(); ++p) maps.emplace_back(after.panels[p], drape.pattern.panels[p]);
    std::vector<OpenSeam> open = open_seams_after(drape, after);
    sew_in_place(mesh, open, draped, maps);
    Simulation simulation(make_cloth(mesh, fabrics, {.max_level = deepest_level}), options);
    Cloth& cloth = simulation.cloth();
    refresh_contacts(cloth);
    update_normals(cloth);
    place_vertices(cloth, draped, maps, body);
    for (int level = 0; level < std::min(options.adapt.max_level, deepest_level); ++level) {
        simulation.adapt(body, carried_over());
        place_vertices(cloth, draped, maps, body);
    }
    forget_contacts(cloth);
    return {.simulation = std::move(simulation), .mesh = std::move(mesh), .open = std::move(open)};
}

namespace {

constexpr int kSamples = 8;     // per edge, or part of one between two corners of either outline
constexpr double kNear = 1e-9;  // m: points closer than this are on the outline

// tan of half the angle from a to b. Infinite where they are opposite, that is, u is on the segment between them.
double half_tangent(const Vec2d& a, const Vec2d& b) {
    const double lengths = a.norm() * b.norm();
    return cross2(a, b) / (lengths + a.dot(b));
}

}  // namespace

OutlineMap::OutlineMap(const Panel& from, const Panel& to) : is_identity_(has_same_outline(from, to)) {
    if (is_identity_) return;
    const OutlineMatch match(from, to);
    SELVEDGE_ASSERT(!match.is_empty());
    for (const auto& [here, there] : match.points(from, to, kSamples)) {
        from_.push_back(here);
        to_.push_back(there);
    }
}

Vec2d OutlineMap::operator()(const Vec2d& u) const {
    if (is_identity_) return u;
    const std::size_t count = from_.size();
    std::vector<double> tangents(count);  // of half the angle at u between sample i and the next
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2d a = from_[i] - u;
        const Vec2d b = from_[(i + 1) % count] - u;
        const double along = a.norm() + b.norm();
        if (a.norm() < kNear) return to_[i];
        const double length = (b - a).norm();
        if (along - length < kNear * along) {  // u is on the segment between them
            const double t = a.norm() / along;
            return (1 - t) * to_[i] + t * to_[(i + 1) % count];
        }
        tangents[i] = half_tangent(a, b);
    }
    Vec2d sum = Vec2d::Zero();
    double weights = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double weight = (tangents[(i + count - 1) % count] + tangents[i]) / (from_[i] - u).norm();
        sum += weight * to_[i];
        weights += weight;
    }
    const Vec2d mapped = sum / weights;
    return mapped.allFinite() ? mapped : u;
}

namespace {

constexpr float kCell = 0.03F;  // m, side of the cells in which leaves are looked up

// Barycentric weights of the point in the triangle that is nearest to u (approximate when u is outside).
Vec3f weights_at(const std::array<Vec2f, 3>& triangle, const Vec2f& u) {
    const auto cross = [](const Vec2f& a, const Vec2f& b) { return a.x() * b.y() - a.y() * b.x(); };
    const float area = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    Vec3f weights;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2f& a = triangle[(k + 1) % 3];
        weights[static_cast<int>(k)] = cross(triangle[(k + 2) % 3] - a, u - a) / area;
    }
    if (!weights.allFinite()) return Vec3f::Constant(1.0F / 3);
    weights = weights.cwiseMax(0.0F);  // approximate projection: u is at most slightly outside
    return weights / weights.sum();
}

int cell_of(float u, float low, float size, int count) {
    return std::clamp(static_cast<int>(std::floor((u - low) / size)), 0, count - 1);
}

}  // namespace

DrapedPanels::DrapedPanels(const Cloth& cloth) : cloth_(cloth), panels_(cloth.material.fabrics.size()) {
    std::vector<Eigen::AlignedBox2f> boxes(panels_.size());
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        for (const Vec2f& u : leaf.u) boxes[leaf.panel].extend(u);
    }
    for (std::size_t p = 0; p < panels_.size(); ++p) {
        if (boxes[p].isEmpty()) continue;
        Cells& cells = panels_[p];
        const Vec2f extent = boxes[p].sizes();
        cells.low = boxes[p].min();
        cells.size = std::max(kCell, extent.maxCoeff() / 128);
        cells.columns = static_cast<int>(extent.x() / cells.size) + 1;
        cells.rows = static_cast<int>(extent.y() / cells.size) + 1;
        cells.leaves.resize(static_cast<std::size_t>(cells.columns) * static_cast<std::size_t>(cells.rows));
    }
    for (std::uint32_t i = 0; i < cloth.mesh.leaf_triangles().size(); ++i) {
        const LeafTriangle& leaf = cloth.mesh.leaf_triangles()[i];
        Cells& cells = panels_[leaf.panel];
        cells.all.push_back(i);
        Eigen::AlignedBox2f box;
        for (const Vec2f& u : leaf.u) box.extend(u);
        const int right = cell_of(box.max().x(), cells.low.x(), cells.size, cells.columns);
        const int top = cell_of(box.max().y(), cells.low.y(), cells.size, cells.rows);
        for (int row = cell_of(box.min().y(), cells.low.y(), cells.size, cells.rows); row <= top; ++row) {
            for (int column = cell_of(box.min().x(), cells.low.x(), cells.size, cells.columns); column <= right;
                 ++column)
                cells.leaves[static_cast<std::size_t>(row * cells.columns + column)].push_back(i);
        }
    }
}

const LeafTriangle* DrapedPanels::nearest_leaf(const MaterialPoint& at) const {
    if (at.panel >= panels_.size() || panels_[at.panel].all.empty()) return nullptr;
    const Cells& cells = panels_[at.panel];
    const LeafTriangle* nearest = nullptr;
    float least = std::numeric_limits<float>::max();
    const auto look = [&](const std::vector<std::uint32_t>& leaves) {
        for (const std::uint32_t i : leaves) {
            const LeafTriangle& leaf = cloth_.mesh.leaf_triangles()[i];
            const float distance = distance_to_triangle(at.u, leaf.u);
            if (distance >= least) continue;
            least = distance;
            nearest = &leaf;
            if (distance == 0) return;
        }
    };
    const int column = cell_of(at.u.x(), cells.low.x(), cells.size, cells.columns);
    const int row = cell_of(at.u.y(), cells.low.y(), cells.size, cells.rows);
    look(cells.leaves[static_cast<std::size_t>(row * cells.columns + column)]);
    if (least > 0) look(cells.all);
    return nearest;
}

Vec3f DrapedPanels::position(const MaterialPoint& at) const {
    const LeafTriangle* leaf = nearest_leaf(at);
    if (leaf == nullptr) return Vec3f::Zero();
    const Vec3f weights = weights_at(leaf->u, at.u);
    Vec3f x = Vec3f::Zero();
    for (std::size_t k = 0; k < 3; ++k) x += weights[static_cast<int>(k)] * cloth_.x[leaf->v[k].value].head<3>();
    return x;
}

VertexId DrapedPanels::nearest_vertex(const MaterialPoint& at) const {
    const LeafTriangle* leaf = nearest_leaf(at);
    if (leaf == nullptr) return {};
    const auto distance = [&](std::size_t k) { return (leaf->u[k] - at.u).squaredNorm(); };
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        if (distance(k) < distance(nearest)) nearest = k;
    }
    return leaf->v[nearest];
}

MaterialPoint DrapedPanels::place_of(const Cloth& cloth, VertexId v, std::uint16_t panel) {
    for (const TriangleId t : cloth.mesh.triangles_at(v)) {
        const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
        if (triangle.panel == panel) return {panel, triangle.u[corner_at(triangle, v)]};
    }
    return {panel, Vec2f::Zero()};
}

}  // namespace selvedge::sim
