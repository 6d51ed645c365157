// Figures 4.7 and 4.8: the collision grid of 32 x 32 x 32 cells round a cylinder and round a character, with one cell
// and the triangles that overlap it.  (thesis 4.4.1)
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "bench/thesis/labels.h"
#include "bench/thesis/thesis.h"
#include "bench/thesis/thesis_drop.h"
#include "render/draw/renderer.h"
#include "render/scene/solids.h"
#include "sim/mannequin/mannequin.h"

namespace selvedge::bench {
namespace {

constexpr int kCells = 32;  // along each axis
constexpr sim::Rgb8 kGridGrey{0x8B, 0x90, 0x97};
constexpr sim::Rgb8 kCellGreen{0x1F, 0x9A, 0x3C};
constexpr sim::Rgb8 kTriangleRed{0xD2, 0x4B, 0x2A};

struct Box {
    Vec3f low = Vec3f::Constant(1e9F), high = Vec3f::Constant(-1e9F);  // m

    void add(const Vec3f& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    bool overlaps(const Box& other) const {
        return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
    }
    Vec3f centre() const { return 0.5F * (low + high); }
    Vec3f corner(unsigned i) const {
        return {(i & 1U) != 0 ? high.x() : low.x(), (i & 2U) != 0 ? high.y() : low.y(),
                (i & 4U) != 0 ? high.z() : low.z()};
    }
};

Box bounds_of(const std::vector<Vec3f>& points) {
    Box box;
    for (const Vec3f& p : points) box.add(p);
    return box;
}

// The cell that contains p.
Box cell_at(const Box& grid, const Vec3f& p) {
    const Vec3f size = (grid.high - grid.low) / static_cast<float>(kCells);
    Box cell;
    for (int axis = 0; axis < 3; ++axis) {
        const float at = std::clamp((p[axis] - grid.low[axis]) / size[axis], 0.0F, kCells - 1.0F);
        cell.low[axis] = grid.low[axis] + std::floor(at) * size[axis];
        cell.high[axis] = cell.low[axis] + size[axis];
    }
    return cell;
}

void add_box(render::SolidItem& solid, const Box& box, float radius, const sim::Rgb8& colour) {
    for (unsigned i = 0; i < 8; ++i) {
        for (const unsigned bit : {1U, 2U, 4U}) {
            if ((i & bit) == 0) add_rod(solid, box.corner(i), box.corner(i | bit), radius, colour);
        }
    }
}

// The lines of the grid on its back and bottom faces.
void add_grid(render::SolidItem& solid, const Box& grid, float radius) {
    const Vec3f size = (grid.high - grid.low) / static_cast<float>(kCells);
    for (int i = 1; i < kCells; ++i) {
        const Vec3f at = grid.low + static_cast<float>(i) * size;
        const Vec3f &low = grid.low, &high = grid.high;
        add_rod(solid, {at.x(), low.y(), low.z()}, {at.x(), low.y(), high.z()}, radius, kGridGrey);
        add_rod(solid, {low.x(), low.y(), at.z()}, {high.x(), low.y(), at.z()}, radius, kGridGrey);
        add_rod(solid, {at.x(), low.y(), low.z()}, {at.x(), high.y(), low.z()}, radius, kGridGrey);
        add_rod(solid, {low.x(), at.y(), low.z()}, {high.x(), at.y(), low.z()}, radius, kGridGrey);
    }
}

struct CellTriangles {
    render::SolidItem solid;
    std::size_t count = 0;
};

// The triangles whose bounding boxes overlap the cell, lifted a little off the surface.
CellTriangles triangles_in(const render::BodyItem& body, const Box& cell, float lift) {
    CellTriangles found;
    for (const auto& triangle : body.triangles) {
        Box box;
        for (const std::uint32_t v : triangle) box.add(body.x[v]);
        if (!box.overlaps(cell)) continue;
        ++found.count;
        const auto first = static_cast<std::uint32_t>(found.solid.x.size());
        std::array<Vec3f, 3> lifted;
        for (std::size_t k = 0; k < 3; ++k) {
            lifted[k] = body.x[triangle[k]] + lift * body.normals[triangle[k]];
            found.solid.x.push_back(lifted[k]);
            found.solid.normals.push_back(body.normals[triangle[k]]);
            found.solid.colours.push_back(kTriangleRed);
        }
        found.solid.triangles.push_back({first, first + 1, first + 2});
        add_outline(found.solid, lifted, 0.3F * lift, {0x5A, 0x1B, 0x0C});
    }
    return found;
}

struct GridSubject {
    const char* figure;
    render::BodyItem body;
    Vec3f point = Vec3f::Zero();  // in the highlighted cell
    Vec3f to_eye = Vec3f::UnitZ();
};

Capture picture_of(const GridSubject& subject, const ThesisOptions& options) {
    const Box grid = bounds_of(subject.body.x), cell = cell_at(grid, subject.point);
    const float size = (cell.high - cell.low).norm(), whole = (grid.high - grid.low).norm();
    const CellTriangles inside = triangles_in(subject.body, cell, 0.02F * size);
    render::Renderer renderer;
    const auto draw = [&](const Vec3f& target, float distance, float line, bool has_grid) {
        render::Scene scene;
        scene.bodies.push_back(subject.body);
        scene.solids.push_back(inside.solid);
        render::SolidItem lines;
        add_box(lines, cell, 2 * line, kCellGreen);
        add_box(lines, grid, line, kGridGrey);
        if (has_grid) add_grid(lines, grid, 0.35F * line);
        scene.solids.push_back(std::move(lines));
        scene.camera =
            render::camera_at(target + distance * subject.to_eye.normalized(), target, {grid.low, grid.high});
        scene.light = studio_light(scene.camera);
        scene.has_ground = false;
        const int side = options.is_quick ? 96 : 800;
        return renderer.draw(scene, {.width_px = side, .height_px = side});
    };
    return {subject.figure, "grid",
            labelled_sheet({{"grid of 32 x 32 x 32 cells", draw(grid.centre(), 2.9F * whole, 0.001F * whole, true)},
                            {"one cell and its " + std::to_string(inside.count) + " triangles",
                             draw(cell.centre(), 7 * size, 0.006F * size, false)}},
                           2)};
}

// A cylinder of quads that are nearly square, each of two triangles, with caps.
render::BodyItem make_cylinder() {
    constexpr int kSegments = 48, kRings = 36;
    render::BodyItem item;
    for (int ring = 0; ring <= kRings; ++ring) {
        for (int i = 0; i < kSegments; ++i) {
            const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kSegments;
            item.x.emplace_back(kDropHalfLength * (2 * static_cast<float>(ring) / kRings - 1),
                                kDropRadius * std::cos(turn), kDropRadius * std::sin(turn));
        }
    }
    for (int ring = 0; ring < kRings; ++ring) {
        for (int i = 0; i < kSegments; ++i) {
            const auto a = static_cast<std::uint32_t>(ring * kSegments + i);
            const auto b = static_cast<std::uint32_t>(ring * kSegments + (i + 1) % kSegments);
            item.triangles.push_back({a, b, b + kSegments});
            item.triangles.push_back({a, b + kSegments, a + kSegments});
        }
    }
    for (const int ring : {0, kRings}) {
        const auto first = static_cast<std::uint32_t>(item.x.size());
        const std::size_t rim = static_cast<std::size_t>(ring) * kSegments;
        for (std::size_t i = 0; i < kSegments; ++i) item.x.emplace_back(item.x[rim + i]);
        item.x.emplace_back(item.x[rim].x(), 0, 0);
        for (std::uint32_t i = 0; i < kSegments; ++i) {
            const std::uint32_t a = first + i, b = first + (i + 1) % kSegments, centre = first + kSegments;
            item.triangles.push_back(ring == 0 ? std::array{b, a, centre} : std::array{a, b, centre});
        }
    }
    item.normals = sim::vertex_normals(item.x, item.triangles);
    return item;
}

// The highest point of the left shoulder: halfway between neck and arm.
Vec3f left_shoulder(const render::BodyItem& body) {
    constexpr float kFrom = 0.13F, kTo = 0.16F;  // m, to the body's left
    Vec3f highest(0, -1, 0);
    for (const Vec3f& x : body.x) {
        if (x.x() > kFrom && x.x() < kTo && x.y() > highest.y()) highest = x;
    }
    return highest;
}

}  // namespace

ThesisResult draw_collision_grids(const ThesisOptions& options) {
    GridSubject cylinder{.figure = "4.7",
                         .body = make_cylinder(),
                         .point = Vec3f(0.2F, 0.8F * kDropRadius, 0.6F * kDropRadius),
                         .to_eye = Vec3f(0.7F, 0.6F, 1)};
    GridSubject character{
        .figure = "4.8", .body = render::make_body_item(sim::make_mannequin().body), .to_eye = Vec3f(0.6F, 0.45F, 1)};
    character.point = left_shoulder(character.body);
    return {.captures = {picture_of(cylinder, options), picture_of(character, options)}};
}

}  // namespace selvedge::bench
