// Names in other scripts: fonts of the system for letters that the interface's own fonts lack.
#include "app/fallback_fonts.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "app/editor_services.h"
#include "editor/ui/app_state.h"
#include "editor/ui/editor.h"
#include "tests/app/run_program.h"

namespace selvedge::app {
namespace {

using editor::add_letters;
using editor::without_glyph;

struct NameInScript {
    const char* script;
    const char* name;
};

class FallbackFonts : public testing::TestWithParam<NameInScript> {
 protected:
    // An editor that shows a garment with this name, after one frame.
    std::unique_ptr<editor::Editor> show(const std::string& name, editor::FontFinder finder) {
        auto services = make_editor_services({.state = folder_.path() / "state", .render_full_quality = {}});
        auto shown = std::make_unique<editor::Editor>(std::move(services),
                                                      editor::EditorOptions{.drive = sim::SessionDrive::Caller,
                                                                            .fonts = read_fonts(),
                                                                            .find_fonts = std::move(finder),
                                                                            .is_steady = true});
        sim::PatternDocument garment = editor::empty_garment();
        garment.pattern.name = name;
        open_loaded(shown->state(), garment, "garment.json");
        shown->frame({}, {}, 0.02);
        return shown;
    }

    ScratchFolder folder_;
};

TEST_P(FallbackFonts, a_name_has_its_letters_when_a_font_for_them_is_installed) {
    editor::Letters letters;
    add_letters(GetParam().name, letters);
    ASSERT_FALSE(letters.empty());
    if (find_fallback_fonts(letters).empty()) GTEST_SKIP() << "no font for " << GetParam().script << " is installed";
    const auto shown = show(GetParam().name, find_fallback_fonts);
    for (const ImFont* font : {shown->state().fonts.regular, shown->state().fonts.bold})
        EXPECT_EQ(without_glyph(letters, *font), editor::Letters{}) << GetParam().script;
}

INSTANTIATE_TEST_SUITE_P(Scripts, FallbackFonts,
                         testing::Values(NameInScript{"Japanese", "\u524d\u8eab\u9803 \u30b8\u30e3\u30b1\u30c3\u30c8"},
                                         NameInScript{"Russian", "\u043f\u0435\u0440\u0435\u0434"},
                                         NameInScript{"Greek", "\u03c0\u03bb\u03ac\u03c4\u03b7"},
                                         NameInScript{"Arabic", "\u0643\u0645"},
                                         NameInScript{"Hindi", "\u092c\u093e\u091c\u0942"}),
                         [](const auto& tried) { return std::string(tried.param.script); });

TEST_F(FallbackFonts, a_letter_without_a_font_is_asked_for_once_and_stays_a_question_mark) {
    int calls = 0;
    const auto find_none = [&](const editor::Letters& letters) {
        ++calls;
        EXPECT_EQ(letters, editor::Letters{0x378});  // not assigned: no font has it
        return std::vector<editor::FallbackFont>();
    };
    const auto shown = show("\u0378", find_none);
    for (int i = 0; i < 3; ++i) shown->frame({}, {}, 0.02);
    EXPECT_EQ(calls, 1);
    const ImFont& font = *shown->state().fonts.regular;
    EXPECT_EQ(font.FindGlyph(0x378), font.FallbackGlyph);
}

TEST_F(FallbackFonts, letters_that_are_typed_or_renamed_later_are_added_between_frames) {
    editor::Letters letters;
    add_letters("\u03c0\u043f", letters);
    if (find_fallback_fonts(letters).empty()) GTEST_SKIP() << "no font for Greek and Russian is installed";
    const auto shown = show("front", find_fallback_fonts);
    EXPECT_EQ(without_glyph(letters, *shown->state().fonts.regular), letters);
    shown->frame({{.kind = editor::InputEvent::Kind::Text, .text = "\u03c0\u043f"}}, {}, 0.02);
    EXPECT_EQ(without_glyph(letters, *shown->state().fonts.regular), editor::Letters{});
}

}  // namespace
}  // namespace selvedge::app
