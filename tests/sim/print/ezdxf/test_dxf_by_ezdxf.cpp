// Another reader of DXF, Debian's python3-ezdxf, finds the same panels in our files. Skipped where it is not installed.
#include <gtest/gtest.h>

#include <sstream>

#include "sim/core/file.h"
#include "sim/pattern/edge_shape.h"
#include "sim/print/dxf_file.h"
#include "tests/app/run_program.h"
#include "tests/sim/print/sample_pattern.h"

namespace selvedge::sim {
namespace {

TEST(DxfByEzdxf, blocks_outlines_and_marks_are_those_of_the_pattern) {
    if (app::run_command("/usr/bin/python3 -c 'import ezdxf'").exit_code != 0)
        GTEST_SKIP() << "python3-ezdxf is not installed";
    const app::ScratchFolder folder;
    const std::string file = folder / "sample.dxf";
    const Pattern pattern = sample_pattern();
    for (const DxfStandard standard : {DxfStandard::Aama, DxfStandard::Astm}) {
        write_file_atomically(file, dxf_of(pattern, standard));
        const app::ProgramResult result = app::run_command("/usr/bin/python3 -B '" + source_folder() +
                                                           "/tests/sim/print/ezdxf/read_dxf.py' '" + file + "'");
        ASSERT_EQ(result.exit_code, 0) << result.err;
        std::istringstream lines(result.out);
        std::string word;
        int errors = -1;
        lines >> word >> errors;
        EXPECT_EQ(errors, 0);
        for (const Panel& panel : pattern.panels) {
            std::size_t vertices = 0, notches = 0, drills = 0, records = 0;
            Vec2d low, high;
            lines >> word >> vertices >> low.x() >> low.y() >> high.x() >> high.y() >> notches >> drills >> records;
            const Eigen::AlignedBox2d box = outline_box(panel, 1e-5);
            EXPECT_LT((low / 1000 - box.min()).norm(), 5e-5) << word;
            EXPECT_LT((high / 1000 - box.max()).norm(), 5e-5) << word;
            EXPECT_EQ(notches, panel.notches.size());
            EXPECT_EQ(drills, panel.drill_points.size());
            EXPECT_EQ(records, panel.edges.size() + panel.notches.size() + panel.internal_lines.size());
        }
    }
}

}  // namespace
}  // namespace selvedge::sim
