// The example of docs/adding-a-tool.md works.
#include <gtest/gtest.h>

#include "editor/ui/script.h"
#include "sim/core/file.h"
#include "tests/docs/pocket_tool.h"
#include "tests/editor/tools/tool_support.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
namespace {

// [test]
TEST(PocketTool, puts_a_panel_of_the_typed_size_where_the_user_clicks) {
    SheetUser user;
    user.tools.choose(user.host(), kPocket);
    user.type("10x12");
    user.click({0.6, 0.4});
    ASSERT_EQ(user.pattern().panels.size(), 3U);
    EXPECT_TRUE(user.vertex("pocket", 0).isApprox(Vec2d(0.55, 0.34), 1e-6));
    user.document.undo();
    EXPECT_EQ(user.pattern().panels.size(), 2U) << "one entry of the history";
}
// [/test]

TEST(PocketTool, drops_its_preview_on_escape) {
    SheetUser user;
    user.tools.choose(user.host(), kPocket);
    user.press({0.6, 0.4});
    user.move({0.7, 0.5});
    EXPECT_EQ(user.pattern().panels.size(), 3U);
    user.key(Key::Escape);
    user.release({0.7, 0.5});
    EXPECT_EQ(user.pattern().panels.size(), 2U);
}

TEST(PocketTool, says_what_is_too_small_and_changes_nothing) {
    SheetUser user;
    user.tools.choose(user.host(), kPocket);
    user.type("0x12");
    user.click({0.6, 0.4});
    EXPECT_EQ(user.message(), "A pocket is at least 1 cm wide and high");
    EXPECT_EQ(user.pattern().panels.size(), 2U);
}

TEST(PocketTool, has_a_key_and_an_id_that_no_tool_has) {
    EXPECT_EQ(tool_of_key(kPocket.key), nullptr);
    for (const ToolInfo& tool : all_tools()) EXPECT_NE(tool.id, kPocket.id);
}

TEST(PocketTool, has_a_script_whose_steps_exist) {
    const std::string file = source_folder() + "/tests/docs/pocket.txt";
    EXPECT_EQ(parse_script(sim::read_file(file, 10000), file).size(), 7U);
}

}  // namespace
}  // namespace selvedge::editor
