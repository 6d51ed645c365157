#include <gtest/gtest.h>

#include "sim/pattern/field_moves.h"
#include "sim/pattern/pattern_file.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge::sim {
namespace {

PatternDocument with_elastic() {
    PatternDocument document = parse_pattern(sample_text(), "");
    document.pattern.panels[0].edges[2].elastic = Elastic{.share = 0.65, .stiffness = 12.5};
    return document;
}

TEST(Elastic, comes_back_from_a_file) {
    const PatternDocument document = with_elastic();
    const std::string text = write_pattern(document);
    const PatternDocument again = parse_pattern(text, "");
    EXPECT_EQ(again.pattern.panels[0].edges[2].elastic, document.pattern.panels[0].edges[2].elastic);
    EXPECT_EQ(again.pattern.panels[0].edges[1].elastic, std::nullopt);
    EXPECT_EQ(write_pattern(again), text);
}

TEST(Elastic, that_is_longer_than_its_edge_or_pushes_is_refused_with_its_place) {
    const std::string text = write_pattern(with_elastic()),
                      place = "f.json: pattern.panels.front.edges[2].selvedge.elastic.";
    EXPECT_EQ(faults_of(replaced(text, "\"share\": 0.65", "\"share\": 1.5")),
              (std::vector<std::string>{place + "share: an elastic is 0.2 to 1 times as long as its edge"}));
    EXPECT_EQ(faults_of(replaced(text, "\"stiffness\": 12.5", "\"stiffness\": -1")),
              (std::vector<std::string>{place + "stiffness: an elastic pulls with 0.1 to 1000 N per unit of strain"}));
}

TEST(Elastic, stays_on_its_edge_where_a_panel_is_mirrored) {
    const Panel panel = with_elastic().pattern.panels[0];
    const Eigen::Affine2d mirror(Eigen::Scaling(-1.0, 1.0));
    EXPECT_EQ(mapped_panel(mapped_panel(panel, mirror), mirror), panel);
    int elastics = 0;
    for (const OutlineEdge& edge : mapped_panel(panel, mirror).edges) elastics += edge.elastic ? 1 : 0;
    EXPECT_EQ(elastics, 1);
}

}  // namespace
}  // namespace selvedge::sim
