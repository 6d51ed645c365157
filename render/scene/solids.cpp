#include "render/scene/solids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "sim/core/assert.h"

namespace selvedge::render {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

struct UnitBall {
    std::vector<Vec3f> x;
    Triangles triangles;
};

UnitBall icosahedron() {
    const float a = 0.52573111F, b = 0.85065081F;
    return {.x = {{-a, b, 0},
                  {a, b, 0},
                  {-a, -b, 0},
                  {a, -b, 0},
                  {0, -a, b},
                  {0, a, b},
                  {0, -a, -b},
                  {0, a, -b},
                  {b, 0, -a},
                  {b, 0, a},
                  {-b, 0, -a},
                  {-b, 0, a}},
            .triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                          {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                          {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

UnitBall cut_in_four(const UnitBall& ball) {
    UnitBall finer{.x = ball.x, .triangles = {}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t i, std::uint32_t j) {
        const auto [found, is_new] = middles.try_emplace(std::minmax(i, j), static_cast<std::uint32_t>(finer.x.size()));
        if (is_new) finer.x.push_back((ball.x[i] + ball.x[j]).normalized());
        return found->second;
    };
    for (const auto& [i, j, k] : ball.triangles) {
        const std::uint32_t ij = middle(i, j), jk = middle(j, k), ki = middle(k, i);
        finer.triangles.insert(finer.triangles.end(), {{i, ij, ki}, {j, jk, ij}, {k, ki, jk}, {ij, jk, ki}});
    }
    return finer;
}

const UnitBall& unit_ball(BallDetail detail) {
    static const UnitBall coarse = cut_in_four(icosahedron());
    static const UnitBall fine = cut_in_four(coarse);
    return detail == BallDetail::Coarse ? coarse : fine;
}

constexpr std::uint32_t kSides = 8;

// A cross-section of a tube: kSides points around the path.
struct Ring {
    Vec3f centre;
    Vec3f along;   // unit, direction of the path
    Vec3f across;  // unit, towards the first point
};

Vec3f any_across(const Vec3f& along) {
    const Vec3f axis = std::abs(along.y()) < 0.9F ? Vec3f::UnitY() : Vec3f::UnitX();
    return along.cross(axis).normalized();
}

// Continues the previous ring's first direction without a twist.
Vec3f transported_across(const Vec3f& across, const Vec3f& along) {
    const Vec3f flat = across - across.dot(along) * along;
    return flat.norm() > 1e-3F ? flat.normalized() : any_across(along);
}

std::vector<Vec3f> without_repeats(const std::vector<Vec3f>& path) {
    std::vector<Vec3f> points;
    for (const Vec3f& x : path) {
        if (points.empty() || (x - points.back()).norm() > 1e-7F) points.push_back(x);
    }
    return points;
}

std::vector<Ring> make_rings(const std::vector<Vec3f>& points) {
    std::vector<Ring> rings;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3f before = i > 0 ? (points[i] - points[i - 1]).normalized() : Vec3f::Zero();
        const Vec3f after = i + 1 < points.size() ? (points[i + 1] - points[i]).normalized() : Vec3f::Zero();
        const Vec3f sum = before + after;
        const Vec3f along = sum.norm() > 1e-3F ? sum.normalized() : (i > 0 ? before : after);
        const Vec3f across = rings.empty() ? any_across(along) : transported_across(rings.back().across, along);
        rings.push_back({points[i], along, across});
    }
    return rings;
}

void add_ring(SolidItem& solid, const Ring& ring, float radius, const sim::Rgb8& colour) {
    const Vec3f other = ring.along.cross(ring.across);
    for (std::uint32_t side = 0; side < kSides; ++side) {
        const float angle = 6.2831853F * float(side) / float(kSides);
        const Vec3f normal = std::cos(angle) * ring.across + std::sin(angle) * other;
        solid.x.push_back(ring.centre + radius * normal);
        solid.normals.push_back(normal);
        solid.colours.push_back(colour);
    }
}

void join_rings(SolidItem& solid, std::uint32_t first, std::uint32_t second) {
    for (std::uint32_t side = 0; side < kSides; ++side) {
        const std::uint32_t next = (side + 1) % kSides;
        solid.triangles.push_back({first + side, first + next, second + side});
        solid.triangles.push_back({first + next, second + next, second + side});
    }
}

// Without end caps, which are invisible on thin lines.
void add_pipe(SolidItem& solid, const std::vector<Vec3f>& points, float radius, const sim::Rgb8& colour) {
    const auto first = static_cast<std::uint32_t>(solid.x.size());
    const std::vector<Ring> rings = make_rings(points);
    for (const Ring& ring : rings) add_ring(solid, ring, radius, colour);
    for (std::uint32_t i = 1; i < rings.size(); ++i) join_rings(solid, first + (i - 1) * kSides, first + i * kSides);
}

}  // namespace

void add_ball(SolidItem& solid, const Vec3f& centre, float radius, const sim::Rgb8& colour, BallDetail detail) {
    const UnitBall& ball = unit_ball(detail);
    const auto first = static_cast<std::uint32_t>(solid.x.size());
    for (const Vec3f& normal : ball.x) {
        solid.x.push_back(centre + radius * normal);
        solid.normals.push_back(normal);
        solid.colours.push_back(colour);
    }
    for (const auto& [i, j, k] : ball.triangles) solid.triangles.push_back({first + i, first + j, first + k});
}

void add_tube(SolidItem& solid, const std::vector<Vec3f>& path, float radius, const sim::Rgb8& colour) {
    const std::vector<Vec3f> points = without_repeats(path);
    if (points.size() < 2) return;
    add_pipe(solid, points, radius, colour);
    add_ball(solid, points.front(), radius, colour, BallDetail::Coarse);
    add_ball(solid, points.back(), radius, colour, BallDetail::Coarse);
}

void add_rod(SolidItem& solid, const Vec3f& from, const Vec3f& to, float radius, const sim::Rgb8& colour) {
    if ((to - from).norm() > 1e-7F) add_pipe(solid, {from, to}, radius, colour);
}

void add_outline(SolidItem& solid, const std::array<Vec3f, 3>& triangle, float radius, const sim::Rgb8& colour) {
    for (std::size_t i = 0; i < 3; ++i) add_rod(solid, triangle[i], triangle[(i + 1) % 3], radius, colour);
}

namespace {

constexpr float kPanelGap = 0.05F;  // fraction of the largest panel's larger side
constexpr float kModelGap = 0.14F;  // fraction of the layout's larger side
constexpr float kStep = 0.17F;      // between two levels; fraction of the layout's larger side

std::vector<Eigen::AlignedBox2f> panel_boxes(const sim::TriangleHierarchy& hierarchy) {
    std::vector<Eigen::AlignedBox2f> boxes;
    for (const sim::HierarchyTriangle& t : hierarchy) {
        if (t.panel >= boxes.size()) boxes.resize(t.panel + std::size_t{1});
        for (const Vec2f& u : t.u) boxes[t.panel].extend(u);
    }
    for (Eigen::AlignedBox2f& box : boxes) {
        if (box.isEmpty()) box = {Vec2f::Zero(), Vec2f::Zero()};
    }
    return boxes;
}

// Position of each panel's lower left corner, and the size of the whole layout.
struct Layout {
    std::vector<Vec2f> places;
    Vec2f size = Vec2f::Zero();
};

// Rows of at most `width`, the highest panels first.
Layout in_rows(const std::vector<Eigen::AlignedBox2f>& boxes, float width, float gap) {
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return boxes[a].sizes().y() > boxes[b].sizes().y(); });
    Layout layout{.places = std::vector<Vec2f>(boxes.size(), Vec2f::Zero())};
    Vec2f at = Vec2f::Zero();
    float row_height = 0;
    for (const std::size_t panel : order) {
        const Vec2f size = boxes[panel].sizes();
        if (at.x() > 0 && at.x() + size.x() > width * 1.0001F) at = {0, at.y() + row_height + gap}, row_height = 0;
        layout.places[panel] = at;
        row_height = std::max(row_height, size.y());
        layout.size = layout.size.cwiseMax(at + size);
        at.x() += size.x() + gap;
    }
    return layout;
}

// Tries row widths and takes the layout that fits into the smallest box of the wanted aspect ratio.
Layout lay_out(const std::vector<Eigen::AlignedBox2f>& boxes, float width_over_height) {
    float widest = 0, all = 0, greatest = 0;
    for (const Eigen::AlignedBox2f& box : boxes) {
        widest = std::max(widest, box.sizes().x());
        greatest = std::max(greatest, box.sizes().maxCoeff());
        all += box.sizes().x();
    }
    const float gap = kPanelGap * greatest;
    all += gap * static_cast<float>(boxes.size());
    Layout best;
    float least = std::numeric_limits<float>::infinity();
    constexpr int tries = 24;
    for (int i = 0; i <= tries; ++i) {
        const Layout layout = in_rows(boxes, widest + (all - widest) * float(i) / tries, gap);
        const float needed = std::max(layout.size.x(), layout.size.y() * width_over_height);
        if (needed < least) least = needed, best = layout;
    }
    return best;
}

// Adds triangles to the mesh. In each copy, corners of one panel with equal material coordinates share a vertex.
class Modeller {
 public:
    Modeller(sim::DrawMesh& mesh, const std::vector<Eigen::AlignedBox2f>& boxes, const Layout& layout)
        : mesh_(mesh), boxes_(boxes), layout_(layout) {}

    Vec3f place(const sim::HierarchyTriangle& t, std::size_t corner, const Vec3f& shift) const {
        const Vec2f at = t.u[corner] - boxes_[t.panel].min() + layout_.places[t.panel];
        return shift + Vec3f(at.x(), 0, -at.y());
    }

    void add(const sim::HierarchyTriangle& t, const Vec3f& shift, int copy) {
        std::array<std::uint32_t, 3> v{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Vec2f& u = t.u[corner];
            const auto [found, is_new] =
                known_.try_emplace({copy, t.panel, u.x(), u.y()}, static_cast<std::uint32_t>(mesh_.x.size()));
            if (is_new) mesh_.x.push_back(place(t, corner, shift));
            v[corner] = found->second;
        }
        mesh_.triangles.push_back(v);
        mesh_.u.push_back(t.u);
        mesh_.panel.push_back(t.panel);
        mesh_.level.push_back(t.level);
    }

 private:
    sim::DrawMesh& mesh_;
    const std::vector<Eigen::AlignedBox2f>& boxes_;
    const Layout& layout_;
    std::map<std::tuple<int, std::uint16_t, float, float>, std::uint32_t> known_;
};

}  // namespace

HierarchyModel model_hierarchy(const sim::TriangleHierarchy& hierarchy, StackSide side) {
    SELVEDGE_ASSERT(!hierarchy.empty());
    const std::vector<Eigen::AlignedBox2f> boxes = panel_boxes(hierarchy);
    const Layout layout = lay_out(boxes, side == StackSide::Right ? 0.9F : 2.2F);
    HierarchyModel model;
    model.panel_size = layout.size.maxCoeff();
    const float gap = kModelGap * model.panel_size;
    const Vec3f to_stack =
        side == StackSide::Right ? Vec3f(layout.size.x() + gap, 0, 0) : Vec3f(0, 0, -(layout.size.y() + gap));
    Modeller modeller(model.mesh, boxes, layout);
    for (const sim::HierarchyTriangle& t : hierarchy) {
        const Vec3f shift = to_stack + Vec3f(0, kStep * model.panel_size * float(t.level), 0);
        if (t.is_leaf) {
            modeller.add(t, Vec3f::Zero(), 0);
            modeller.add(t, shift, 1 + t.level);
        } else {
            model.refined.push_back(
                {.x = {modeller.place(t, 0, shift), modeller.place(t, 1, shift), modeller.place(t, 2, shift)},
                 .level = t.level});
        }
    }
    model.mesh.normals = sim::vertex_normals(model.mesh.x, model.mesh.triangles);
    return model;
}

}  // namespace selvedge::render
