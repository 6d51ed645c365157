#include "render/scene/hierarchy.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include "sim/core/assert.h"

namespace selvedge {
namespace {

constexpr float kPanelGap = 0.05F;  // of the greatest panel's greater side
constexpr float kModelGap = 0.14F;  // of the layout's greater side
constexpr float kStep = 0.17F;      // from one level to the next, the same

struct Box {
    Vec2f low = Vec2f::Constant(std::numeric_limits<float>::infinity());
    Vec2f high = -low;

    Vec2f size() const { return high - low; }
};

std::vector<Box> panel_boxes(const TriangleHierarchy& hierarchy) {
    std::vector<Box> boxes;
    for (const HierarchyTriangle& t : hierarchy) {
        if (t.panel >= boxes.size()) boxes.resize(t.panel + std::size_t{1});
        for (const Vec2f& u : t.u) {
            boxes[t.panel].low = boxes[t.panel].low.cwiseMin(u);
            boxes[t.panel].high = boxes[t.panel].high.cwiseMax(u);
        }
    }
    for (Box& box : boxes) {
        if (box.low.x() > box.high.x()) box = {Vec2f::Zero(), Vec2f::Zero()};
    }
    return boxes;
}

// Where each panel's lower left comes to lie, and how much room all take.
struct Layout {
    std::vector<Vec2f> places;
    Vec2f size = Vec2f::Zero();
};

// Rows no wider than `width`, the highest panels first.
Layout in_rows(const std::vector<Box>& boxes, float width, float gap) {
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return boxes[a].size().y() > boxes[b].size().y(); });
    Layout layout{.places = std::vector<Vec2f>(boxes.size(), Vec2f::Zero())};
    Vec2f at = Vec2f::Zero();
    float row_height = 0;
    for (const std::size_t panel : order) {
        const Vec2f size = boxes[panel].size();
        if (at.x() > 0 && at.x() + size.x() > width * 1.0001F) at = {0, at.y() + row_height + gap}, row_height = 0;
        layout.places[panel] = at;
        row_height = std::max(row_height, size.y());
        layout.size = layout.size.cwiseMax(at + size);
        at.x() += size.x() + gap;
    }
    return layout;
}

// The width at which the rows come nearest to the shape that is wanted.
Layout lay_out(const std::vector<Box>& boxes, float width_over_height) {
    float widest = 0, all = 0, greatest = 0;
    for (const Box& box : boxes) {
        widest = std::max(widest, box.size().x());
        greatest = std::max(greatest, box.size().maxCoeff());
        all += box.size().x();
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

// Puts corners into the mesh; those of one panel at one place are one vertex.
class Modeller {
 public:
    Modeller(PlainMesh& mesh, const std::vector<Box>& boxes, const Layout& layout)
        : mesh_(mesh), boxes_(boxes), layout_(layout) {}

    Vec3f place(const HierarchyTriangle& t, std::size_t corner, const Vec3f& shift) const {
        const Vec2f at = t.u[corner] - boxes_[t.panel].low + layout_.places[t.panel];
        return shift + Vec3f(at.x(), 0, -at.y());
    }

    void add(const HierarchyTriangle& t, const Vec3f& shift, int copy) {
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
    PlainMesh& mesh_;
    const std::vector<Box>& boxes_;
    const Layout& layout_;
    std::map<std::tuple<int, std::uint16_t, float, float>, std::uint32_t> known_;
};

}  // namespace

HierarchyModel model_hierarchy(const TriangleHierarchy& hierarchy, StackSide side) {
    SELVEDGE_ASSERT(!hierarchy.empty());
    const std::vector<Box> boxes = panel_boxes(hierarchy);
    const Layout layout = lay_out(boxes, side == StackSide::Right ? 0.9F : 2.2F);
    HierarchyModel model;
    model.panel_size = layout.size.maxCoeff();
    const float gap = kModelGap * model.panel_size;
    const Vec3f to_stack =
        side == StackSide::Right ? Vec3f(layout.size.x() + gap, 0, 0) : Vec3f(0, 0, -(layout.size.y() + gap));
    Modeller modeller(model.mesh, boxes, layout);
    for (const HierarchyTriangle& t : hierarchy) {
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
    model.mesh.normals = vertex_normals(model.mesh.x, model.mesh.triangles);
    return model;
}

}  // namespace selvedge
