#include "editor/sheet/panel_faces.h"

#include <gtest/gtest.h>

#include "sim/pattern/outline.h"
#include "tests/editor/sheet/sheet_stage.h"

namespace selvedge {
namespace {

double area_of(const PanelFace& face) {
    double area = 0;
    for (const auto& [a, b, c] : face.triangles) {
        const Vec2d &p = face.points[std::size_t(a)], &q = face.points[std::size_t(b)],
                    &r = face.points[std::size_t(c)];
        area += cross2(q - p, r - p) / 2;
    }
    return area;
}

TEST(PanelFaces, triangles_fill_the_outline_of_every_shipped_panel) {
    for (const char* name : {"tshirt", "skirt", "poncho"}) {
        for (const Panel& panel : shipped_pattern(name).pattern.panels) {
            const PanelFace face = make_face(panel, 1e-4);
            EXPECT_NEAR(area_of(face), outline_area(panel), 1e-3 * outline_area(panel)) << panel.name;
        }
    }
}

TEST(PanelFaces, edges_of_a_face_end_where_the_next_begin) {
    const Panel panel = shipped_pattern("tshirt").pattern.panels.at(0);
    const PanelFace face = make_face(panel, 1e-3);
    for (std::size_t i = 0; i < panel.edges.size(); ++i) {
        EXPECT_EQ(edge_points(face, i).back(), edge_points(face, (i + 1) % panel.edges.size()).front());
    }
}

TEST(PanelFaces, an_outline_that_crosses_itself_has_no_triangles) {
    Panel panel;
    panel.vertices = {{0, 0}, {0.1, 0.1}, {0.1, 0}, {0, 0.1}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    EXPECT_TRUE(make_face(panel, 1e-3).triangles.empty());
}

TEST(PanelFaces, come_finer_as_one_comes_near) {
    const PatternDocument source = shipped_pattern("tshirt");
    SheetGeometry geometry;
    geometry.update(source.pattern, 1);
    PanelFaces faces;
    faces.begin_frame(geometry);
    const std::size_t far = faces.face(geometry.panels()[0], 200).points.size();
    EXPECT_GT(faces.face(geometry.panels()[0], 20000).points.size(), far);
}

}  // namespace
}  // namespace selvedge
