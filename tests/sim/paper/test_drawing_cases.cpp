// Small drawings as people's programs wrote them come in at their true size. They lie outside of the project.
#include <gtest/gtest.h>

#include "sim/paper/drawing_file.h"
#include "sim/paper/make_panels.h"
#include "sim/pattern/edge_shape.h"
#include "tests/sim/paper/drawings.h"

namespace selvedge::sim {
namespace {

struct Case {
    const char* file;
    std::size_t panels;
    double width, height;  // of the first, mm
};
class DrawingCase : public ::testing::TestWithParam<Case> {};

TEST_P(DrawingCase, has_the_panels_that_it_draws) {
    const std::filesystem::path folder = real_patterns("cases");
    if (folder.empty()) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    const std::string file = (folder / GetParam().file).string();
    const PanelsOfDrawing made = make_panels(read_drawing(file), file);
    ASSERT_EQ(made.pattern.panels.size(), GetParam().panels);
    const Vec2d size = 1000 * outline_box(made.pattern.panels[0], 1e-5).sizes();
    EXPECT_NEAR(size.x(), GetParam().width, 0.5);
    EXPECT_NEAR(size.y(), GetParam().height, 0.5);
}

INSTANTIATE_TEST_SUITE_P(, DrawingCase,
                         ::testing::Values(Case{"dxf-insert-scale/d_insert_scale10.dxf", 6, 2450, 6550},
                                           Case{"dxf-insert-scale/d_insert_rot90.dxf", 6, 245, 655},
                                           Case{"dxf-loose-lines/d_loose_edges_cm.dxf", 2, 520, 579},
                                           Case{"dxf-loose-lines/d_loose_lines_cm.dxf", 2, 520, 579},
                                           Case{"dxf-loose-lines/d_loose_lines_mm_units.dxf", 2, 520, 579},
                                           Case{"dxf-metric-cm/d_metric_cm.dxf", 4, 490, 655},
                                           Case{"dxf-outline-in-pieces/d_split_nofold.dxf", 2, 520, 579},
                                           Case{"dxf-outline-in-pieces/d_split_sew14.dxf", 4, 490, 655},
                                           Case{"dxf-size-name/d_sizename.dxf", 4, 490, 655},
                                           Case{"svg-fold-by-text/s_fold_text.svg", 4, 490, 655},
                                           Case{"svg-hidden-by-class/s_hidden_class.svg", 2, 520, 579},
                                           Case{"svg-illustrator-points/s_illustrator_nowidth.svg", 2, 520, 579},
                                           Case{"svg-illustrator-points/s_illustrator_px.svg", 2, 520, 579},
                                           Case{"svg-inkscape-90dpi/s_inkscape048_px.svg", 2, 520, 579},
                                           Case{"svg-outline-in-strokes/s_separate_strokes.svg", 2, 520, 579},
                                           Case{"svg-page-frame/s_page_rect.svg", 2, 520, 579}),
                         [](const auto& one) {
                             std::string name = std::filesystem::path(one.param.file).stem().string();
                             return name;
                         });

}  // namespace
}  // namespace selvedge::sim
