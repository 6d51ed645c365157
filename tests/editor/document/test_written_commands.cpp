// What journals and scripts say of the parts of a pattern stays the same from one version to the next.
#include <gtest/gtest.h>

#include "editor/document/command.h"
#include "sim/core/file.h"
#include "sim/pattern/pattern_file.h"
#include "tests/support/reference_text.h"

namespace selvedge::editor {
namespace {

TEST(WrittenCommands, of_parts_with_every_field_equal_the_reference) {
    const std::string path = source_folder() + "/tests/reference/all_fields.json";
    const sim::Pattern pattern = sim::parse_pattern(sim::read_file(path, 1 << 20), "").pattern;
    std::vector<Command> commands{AddPanels{.panels = pattern.panels, .seams = pattern.seams},
                                  SetUnderlays{.underlays = pattern.underlays}};
    const sim::Panel& panel = pattern.panels[0];
    for (const sim::OutlineEdge& edge : panel.edges) commands.push_back(SetCurve{.panel = panel.name, .curve = edge});
    for (const sim::InternalLine& line : panel.internal_lines) {
        commands.push_back(AddInternalLine{.panel = panel.name, .line = line});
        commands.push_back(SetInternalLine{.panel = panel.name, .index = 1, .line = line});
    }
    for (const sim::Seam& seam : pattern.seams) {
        const auto part = [&](const sim::SeamSide& side) {
            return PartRef{pattern.panels[static_cast<std::size_t>(side.panel)].name, side.edge};
        };
        commands.push_back(
            SewEdges{.first = part(seam.first), .second = part(seam.second), .is_reversed = seam.is_reversed});
    }
    std::string text;
    for (const Command& command : commands) {
        text += write_json(to_json(command), -1) + "\n";
        const sim::Json json = to_json(command);
        EXPECT_EQ(write_json(to_json(parse_command(sim::JsonView(json, "f"))), -1), write_json(json, -1));
    }
    expect_reference("commands.txt", text);
}

}  // namespace
}  // namespace selvedge::editor
