#include "sim/exchange/garmentcode_element.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/mesh/sew.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

// Two squares of 40 cm, sewn along both sides; the front's dart is stitch 2.
constexpr const char* kPattern = R"({"pattern": {"panels": {
  "front": {"translation": [0, 100, 10], "rotation": [0, 0, 0],
    "vertices": [[0, 0], [18, 0], [20, 10], [22, 0], [40, 0], [40, 40], [0, 40]],
    "edges": [{"endpoints": [0, 1], "label": "hem"}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]},
      {"endpoints": [3, 4], "label": "hem"}, {"endpoints": [4, 5], "label": "right side"},
      {"endpoints": [5, 6], "curvature": [0.5, 0.1]}, {"endpoints": [6, 0]}]},
  "back": {"translation": [0, 100, -10], "rotation": [0, 0, 0],
    "vertices": [[0, 0], [0, 40], [40, 40], [40, 0]],
    "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2], "label": "neck"}, {"endpoints": [2, 3]},
      {"endpoints": [3, 0]}]}},
  "stitches": [[{"panel": "front", "edge": 4}, {"panel": "back", "edge": 2}],
    [{"panel": "front", "edge": 6}, {"panel": "back", "edge": 0}],
    [{"panel": "front", "edge": 1}, {"panel": "front", "edge": 2}]]},
  "properties": {"curvature_coords": "relative", "units_in_meter": 100}})";

PatternDocument sewn_squares() {
    return parse_pattern(kPattern, "squares.json");
}

// The sewn mesh, each triangle divided into four as adaptation does: edges are halved.
DrawMesh refined_cloth(const Pattern& pattern, const MeshOptions& meshing) {
    GarmentMesh sewn = assemble(pattern, meshing);
    merge_seams(sewn);
    DrawMesh mesh;
    mesh.panel_names = sewn.panel_names;
    for (const Vec3d& x : sewn.x) mesh.x.emplace_back(x.cast<float>());
    std::map<std::pair<int, int>, std::uint32_t> centres;
    for (const GarmentTriangle& triangle : sewn.triangles) {
        std::array<std::uint32_t, 6> v{};
        std::array<Vec2f, 6> u{};
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = triangle.vertices[k], b = triangle.vertices[(k + 1) % 3];
            const auto [centre, is_new] = centres.try_emplace(std::minmax({a, b}), mesh.x.size());
            if (is_new) mesh.x.emplace_back((mesh.x[std::size_t(a)] + mesh.x[std::size_t(b)]) / 2);
            v[k] = static_cast<std::uint32_t>(a);
            v[3 + k] = centre->second;
            u[k] = triangle.u[k].cast<float>();
            u[3 + k] = (0.5 * (triangle.u[k] + triangle.u[(k + 1) % 3])).cast<float>();
        }
        constexpr std::size_t kParts[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
        for (const auto& [a, b, c] : kParts) {
            mesh.triangles.push_back({v[a], v[b], v[c]});
            mesh.u.push_back({u[a], u[b], u[c]});
            mesh.panel.push_back(static_cast<std::uint16_t>(triangle.panel));
        }
    }
    return mesh;
}

// The material coordinates of a vertex in that panel.
std::vector<Vec2f> places_in(const DrawMesh& mesh, std::uint16_t panel, std::uint32_t vertex) {
    std::vector<Vec2f> places;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (mesh.panel[t] == panel && mesh.triangles[t][k] == vertex) places.push_back(mesh.u[t][k]);
    return places;
}

class GarmentCodeElement : public testing::Test {
 protected:
    const PatternDocument document_ = sewn_squares();
    const MeshOptions meshing_{.target_edge = 0.08};
    const DrawMesh mesh_ = refined_cloth(document_.pattern, meshing_);
    const GarmentSegmentation found_ = segment_garment(mesh_, document_.pattern, meshing_);

    const std::vector<std::uint32_t>& label(const std::string& name) const {
        const auto at = std::ranges::find(found_.labels, name, &GarmentSegmentation::Label::name);
        EXPECT_NE(at, found_.labels.end()) << name;
        return at->vertices;
    }
};

TEST_F(GarmentCodeElement, has_each_vertex_once_stitches_first_then_panel_by_panel) {
    std::vector<std::uint32_t> vertices = found_.order;
    ASSERT_EQ(vertices.size(), mesh_.x.size());
    std::ranges::sort(vertices);
    for (std::size_t v = 0; v < vertices.size(); ++v) EXPECT_EQ(vertices[v], v);
    std::vector<int> kinds;  // -3, -2, -1: stitches 0 to 2; 0, 1: front and back
    for (std::size_t i = 0; i < vertices.size(); ++i)
        kinds.push_back(found_.stitches[i].empty() ? (found_.panels[i] == "front" ? 0 : 1)
                                                   : found_.stitches[i].front() - 3);
    EXPECT_TRUE(std::ranges::is_sorted(kinds));
    for (const int kind : {-3, -2, -1, 0, 1}) EXPECT_GT(std::ranges::count(kinds, kind), 0) << kind;
}

TEST_F(GarmentCodeElement, has_a_stitch_at_the_vertices_of_both_sides_of_a_seam_and_nowhere_else) {
    for (std::size_t i = 0; i < found_.order.size(); ++i) {
        const std::vector<Vec2f> front = places_in(mesh_, 0, found_.order[i]);
        const std::vector<Vec2f> back = places_in(mesh_, 1, found_.order[i]);
        const bool is_right = std::ranges::any_of(front, [](const Vec2f& u) { return u.x() > 0.39999F; });
        const bool is_left = std::ranges::any_of(front, [](const Vec2f& u) { return u.x() < 0.00001F; });
        EXPECT_EQ(is_right || is_left, !front.empty() && !back.empty());
        EXPECT_EQ(std::ranges::count(found_.stitches[i], 0), is_right ? 1 : 0);
        EXPECT_EQ(std::ranges::count(found_.stitches[i], 1), is_left ? 1 : 0);
        const bool is_dart = std::ranges::any_of(front, [](const Vec2f& u) {
            return std::abs(std::abs(u.x() - 0.2F) - (0.1F - u.y()) / 5) < 1e-6F && u.y() > -1e-6F;
        });
        EXPECT_EQ(std::ranges::count(found_.stitches[i], 2), is_dart ? 1 : 0);
    }
}

TEST_F(GarmentCodeElement, has_labels_between_the_ends_of_open_edges_and_all_along_sewn_ones) {
    ASSERT_EQ(found_.labels.size(), 3U);
    std::size_t hem = 0, side = 0, neck = 0;
    for (std::uint32_t i = 0; i < found_.order.size(); ++i) {
        const std::vector<Vec2f> front = places_in(mesh_, 0, found_.order[i]);
        const std::vector<Vec2f> back = places_in(mesh_, 1, found_.order[i]);
        const auto is_between = [](float x, float low, float high) { return x > low + 1e-5F && x < high - 1e-5F; };
        const bool is_hem = std::ranges::any_of(front, [&](const Vec2f& u) {
            return std::abs(u.y()) < 1e-6F && (is_between(u.x(), 0, 0.18F) || is_between(u.x(), 0.22F, 0.4F));
        });
        const bool is_neck = std::ranges::any_of(
            back, [&](const Vec2f& u) { return u.y() > 0.39999F && is_between(std::abs(u.x()), 0, 0.4F); });
        const bool is_side = std::ranges::count(found_.stitches[i], 0) == 1;
        EXPECT_EQ(std::ranges::count(label("hem"), i), is_hem ? 1 : 0);
        EXPECT_EQ(std::ranges::count(label("neck"), i), is_neck ? 1 : 0);
        EXPECT_EQ(std::ranges::count(label("right side"), i), is_side ? 1 : 0);
        hem += is_hem ? 1 : 0;
        neck += is_neck ? 1 : 0;
        side += is_side ? 1 : 0;
    }
    EXPECT_GT(std::min({hem, neck, side}), 5U);
}

TEST_F(GarmentCodeElement, is_written_in_centimetres_with_a_line_per_vertex_and_the_pattern) {
    const TemporaryFolder folder;
    write_garmentcode_element(mesh_, document_, meshing_, folder / "element", "squares");
    const auto text = [&](const std::string& ending) {
        return read_file(folder / "element" / ("squares_" + ending), 1000000);
    };
    const std::string obj = text("sim.obj"), rows = text("sim_segmentation.txt"), labels = text("vertex_labels.yaml");
    const auto count = [](const std::string& in, const std::string& what) {
        std::size_t found = 0;
        for (std::size_t at = in.find(what); at != std::string::npos; at = in.find(what, at + 1)) ++found;
        return found;
    };
    EXPECT_EQ(count(rows, "\n"), mesh_.x.size());
    EXPECT_EQ(count(obj, "\nv "), mesh_.x.size());
    EXPECT_EQ(count(obj, "\nf "), mesh_.triangles.size());
    EXPECT_TRUE(rows.starts_with("stitch_0\n")) << rows.substr(0, 100);
    EXPECT_NE(rows.find("\nfront\n"), std::string::npos);
    EXPECT_TRUE(rows.ends_with("\nback\n"));
    EXPECT_TRUE(labels.starts_with("hem:\n- ")) << labels;
    EXPECT_NE(labels.find("\n\"right side\":\n- 0\n- 1\n"), std::string::npos) << labels;
    const Vec3f first = 100 * mesh_.x[found_.order[0]];
    EXPECT_NEAR(std::stod(obj.substr(obj.find("\nv ") + 3)), first.x(), 1e-3);
    EXPECT_EQ(load_pattern(folder / "element" / "squares_specification.json").pattern, document_.pattern);
}

TEST_F(GarmentCodeElement, is_refused_where_a_position_is_not_finite) {
    const TemporaryFolder folder;
    DrawMesh sick = mesh_;
    sick.x[3].y() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(write_garmentcode_element(sick, document_, meshing_, folder / "element", "squares"), InputError);
    EXPECT_FALSE(std::filesystem::exists(folder / "element"));
}

}  // namespace
}  // namespace selvedge::sim
