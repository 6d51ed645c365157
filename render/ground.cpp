#include "render/ground.h"

#include "sim/core/assert.h"

namespace selvedge {
namespace {

constexpr std::uint32_t kCells = 96;  // each way, that the room's light is worked out for
constexpr std::uint32_t kDrawn = 2;   // so many each way are drawn as one: softened, that is fine enough

// One step of [1 2 1]/4 along the ground's rows or columns.
void soften(std::vector<Openness>& openness, std::size_t step) {
    constexpr std::size_t side = kCells + 1;
    const std::vector<Openness> before = openness;
    for (std::size_t i = 0; i < openness.size(); ++i) {
        const std::size_t place = step == 1 ? i % side : i / side;
        if (place == 0 || place + 1 == side) continue;
        openness[i].front = 0.25F * (before[i - step].front + 2 * before[i].front + before[i + step].front);
    }
}

BodyItem make_sheet(const Vec3f& centre, float radius) {
    BodyItem sheet;
    for (std::uint32_t j = 0; j <= kCells; ++j) {
        for (std::uint32_t i = 0; i <= kCells; ++i) {
            const Vec2f at = Vec2f(float(i), float(j)) * (2 * radius / float(kCells)) - Vec2f(radius, radius);
            sheet.x.emplace_back(centre.x() + at.x(), centre.y(), centre.z() - at.y());
        }
    }
    sheet.normals.assign(sheet.x.size(), Vec3f::UnitY());
    for (std::uint32_t j = 0; j < kCells; j += kDrawn) {
        for (std::uint32_t i = 0; i < kCells; i += kDrawn) {
            const std::uint32_t a = j * (kCells + 1) + i, b = a + kDrawn, c = a + kDrawn * (kCells + 1), d = c + kDrawn;
            sheet.triangles.push_back({a, b, d});
            sheet.triangles.push_back({a, d, c});
        }
    }
    return sheet;
}

}  // namespace

Ground make_ground(const Scene& scene, const Bounds& bounds) {
    Ground ground{
        .centre = {bounds.centre.x(), scene.ground_y, bounds.centre.z()}, .radius = 1.8F * bounds.radius, .sheet = {}};
    if (scene.has_ground) ground.sheet = make_sheet(ground.centre, ground.radius);
    return ground;
}

std::vector<Openness> softened_ground(std::vector<Openness> openness) {
    SELVEDGE_ASSERT(openness.size() == (kCells + 1) * (kCells + 1));
    constexpr int rounds = 6;  // spreads by the square root of half of it, in cells
    for (int round = 0; round < rounds; ++round) {
        soften(openness, 1);
        soften(openness, kCells + 1);
    }
    return openness;
}

}  // namespace selvedge
