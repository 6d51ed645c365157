#pragma once
// Square sheets of triangles as contact surfaces, with their positions as the kernels take them.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "sim/core/math.h"
#include "sim/selfcontact/moving_points.h"
#include "sim/selfcontact/pairs.h"
#include "sim/selfcontact/surface.h"

namespace selvedge::sim::test {

inline constexpr float kMargin = 0.004F;  // m, of searches; the sheets are 1 mm thick

struct Sheets {
    ContactSurface surface;
    std::vector<Vec4f> now, before;  // w: inverse mass, 1/kg; the last one is the dummy vertex

    std::uint32_t vertices() const { return static_cast<std::uint32_t>(now.size()) - 1; }
    MovingPoints points() { return {now.front().data(), before.front().data(), vertices()}; }
};

// Adds a sheet of quads x quads squares of that edge (m); place: position of a material point, m.
inline void add_sheet(Sheets& sheets, int quads, float edge, int layer,
                      const std::function<Vec3f(const Vec2f&)>& place) {
    constexpr float kInverseMass = 1000;  // 1/kg
    ContactSurface& surface = sheets.surface;
    if (!sheets.now.empty()) {
        sheets.now.pop_back();
        sheets.before.pop_back();
    }
    const auto first = static_cast<std::uint32_t>(sheets.now.size());
    const auto sheet = static_cast<std::uint32_t>(surface.sheets.size());
    surface.sheets.push_back({.thickness = 0.001F, .friction = 0.3F, .layer = layer});
    const auto material = [&](int i, int j) {
        return Vec2f(static_cast<float>(i) * edge, static_cast<float>(j) * edge);
    };
    for (int j = 0; j <= quads; ++j) {
        for (int i = 0; i <= quads; ++i) {
            const Vec3f x = place(material(i, j));
            sheets.now.emplace_back(x.x(), x.y(), x.z(), kInverseMass);
        }
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edges;
    const auto add = [&](const std::array<std::array<int, 2>, 3>& corners) {
        ContactTriangle triangle{.vertices = {}, .edges = {}, .sheet = sheet};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [i, j] = corners[k];
            triangle.vertices[k] = first + static_cast<std::uint32_t>(j * (quads + 1) + i);
            triangle.middle += material(i, j) / 3;
        }
        const auto index = static_cast<std::uint32_t>(surface.triangles.size());
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangle.vertices[k], b = triangle.vertices[(k + 1) % 3];
            const auto [found, is_new] =
                edges.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(surface.edges.size()));
            if (is_new) {
                const float length = (sheets.now[a] - sheets.now[b]).head<3>().norm();
                surface.edges.push_back({.ends = {a, b}, .triangles = {index, kNoElement}, .rest_length = length});
            } else {
                surface.edges[found->second].triangles[1] = index;
            }
            triangle.edges[k] = found->second;
        }
        surface.triangles.push_back(triangle);
    };
    for (int j = 0; j < quads; ++j) {
        for (int i = 0; i < quads; ++i) {
            add({{{i, j}, {i + 1, j}, {i + 1, j + 1}}});
            add({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
        }
    }
    while (sheets.now.size() % 16 != 0) sheets.now.emplace_back(0.0F, 1000.0F, 0.0F, 0.0F);  // unused vertices
    sheets.now.emplace_back(0.0F, 1e4F, 0.0F, 0.0F);
    sheets.before = sheets.now;
}

// A horizontal sheet at that height, m; its material x runs along x and y along -z, so that its front faces up.
inline void add_flat_sheet(Sheets& sheets, int quads, float edge, int layer, float height) {
    add_sheet(sheets, quads, edge, layer, [&](const Vec2f& u) { return Vec3f(u.x(), height, -u.y()); });
}

// Small sheets at random in a cube of that size (m), so that nothing between two of them is left out as flat cloth.
inline Sheets random_sheets(int count, float cube, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(0, cube), size(-0.03F, 0.03F);
    Sheets sheets;
    for (int i = 0; i < count; ++i) {
        const Vec3f middle(place(random), place(random), place(random));
        std::vector<Vec3f> corners;
        for (int k = 0; k < 4; ++k) corners.push_back(middle + Vec3f(size(random), size(random), size(random)));
        std::size_t next = 0;
        add_sheet(sheets, 1, 0.02F, 0, [&](const Vec2f&) { return corners[next++]; });
    }
    return sheets;
}

// The vertices of each pair, first side and second side sorted.
using Key = std::array<std::uint32_t, 4>;

inline Key key_of(Key v, PairKind kind) {
    const auto second = v.begin() + static_cast<std::ptrdiff_t>(first_side(kind));
    std::sort(v.begin(), second);
    std::sort(second, v.end());
    if (kind == PairKind::EdgeEdge && v[2] < v[0]) v = {v[2], v[3], v[0], v[1]};
    return v;
}

inline std::multiset<Key> keys_of(const PairList& pairs) {
    std::multiset<Key> keys;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        Key v{};
        for (std::size_t k = 0; k < 4; ++k) v[k] = pairs.blocks()[i / kBlock].vertices[k][i % kBlock] / 4;
        keys.insert(key_of(v, pairs.kind()));
    }
    return keys;
}

}  // namespace selvedge::sim::test
