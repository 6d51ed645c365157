// Drawing ImGui's lists without a window.
#include <gtest/gtest.h>
#include <imgui.h>
#include <fstream>

#include "app/edit_loop.h"
#include "app/ui_draw.h"
#include "app/window.h"
#include "editor/frame/theme.h"
#include "render/gl/context.h"
#include "render/output/interface_fonts.h"
#include "sim/core/error.h"
#include "tests/app/run_program.h"

namespace selvedge::app {
namespace {

constexpr int kSide = 100;  // px
constexpr editor::UiTexture kPicture = 5, kScene = 6;
constexpr render::Rgba8 kRed{255, 0, 0, 255}, kGreen{0, 255, 0, 255}, kBlue{0, 0, 255, 255}, kBlack{0, 0, 0, 255};
constexpr render::Rgba8 kWhite{255, 255, 255, 255};

ImTextureID id_of(editor::UiTexture number) {
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(number));
}

class ImGuiContextOwner {
 public:
    explicit ImGuiContextOwner(float scale) : context_(ImGui::CreateContext()) {
        ImGui::SetCurrentContext(context_);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {kSide, kSide};
        io.DisplayFramebufferScale = {scale, scale};
        io.DeltaTime = 1.0F / 60;
        io.Fonts->AddFontDefault();
        io.Fonts->Build();
    }
    ~ImGuiContextOwner() { ImGui::DestroyContext(context_); }
    ImGuiContextOwner(const ImGuiContextOwner&) = delete;
    ImGuiContextOwner& operator=(const ImGuiContextOwner&) = delete;

 private:
    ImGuiContext* context_;
};

// Half red, half green; two pixels of each, because sampling blends neighbouring pixels.
editor::TextureUpload red_and_green() {
    editor::TextureUpload held{.texture = kPicture, .picture = render::Image(4, 1, kRed)};
    held.picture.at(2, 0) = held.picture.at(3, 0) = kGreen;
    return held;
}

void fill_blue(const GladGLContext& gl, render::PictureTexture& texture) {
    texture.resize(8, 8);
    gl.BindFramebuffer(GL_FRAMEBUFFER, texture.framebuffer());
    gl.ClearColor(0, 0, 1, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
}

// A square clipped to its upper half, a picture drawn twice, a scene's texture, an unknown texture, half-transparent
// white over the background, and text.
void make_lists() {
    ImGui::NewFrame();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({10, 10}, {20, 15});
    list.AddRectFilled({10, 10}, {20, 20}, IM_COL32_WHITE);
    list.PopClipRect();
    list.AddImage(id_of(kPicture), {30, 10}, {70, 20}, {0, 0}, {2, 1});
    list.AddImage(id_of(kScene), {10, 40}, {30, 60});
    list.AddImage(id_of(77), {40, 40}, {60, 60});
    list.AddRectFilled({70, 40}, {90, 60}, IM_COL32(255, 255, 255, 128));
    list.AddText({10, 80}, IM_COL32_WHITE, "Selvedge");
    ImGui::Render();
}

struct DrawnFrames {
    render::Image first, second;
};

DrawnFrames draw_frames(render::ContextKind maker, float scale) {
    const ImGuiContextOwner imgui(scale);
    const std::unique_ptr<render::GlContext> context = make_context(maker);
    UiDraw drawer(*context);
    render::PictureTexture scene(context->gl()), to(context->gl());
    fill_blue(context->gl(), scene);
    drawer.hold(red_and_green());
    drawer.lend(kScene, scene);
    to.resize(static_cast<int>(kSide * scale), static_cast<int>(kSide * scale));
    DrawnFrames frames;
    for (render::Image* frame : {&frames.first, &frames.second}) {
        make_lists();
        drawer.draw(target_of(to));
        *frame = to.read();
    }
    return frames;
}

int lit_pixels(const render::Image& image, int top, int bottom) {
    int count = 0;
    for (int y = top; y < bottom; ++y) {
        for (int x = 0; x < image.width_px; ++x) count += image.at(x, y)[0] > 128 ? 1 : 0;
    }
    return count;
}

TEST(UiDraw, clips_repeats_pictures_and_shows_scenes) {
    const render::Image image = draw_frames(render::ContextKind::OSMesa, 1).first;
    EXPECT_EQ(image.at(12, 12), kWhite);
    EXPECT_EQ(image.at(12, 16), kBlack) << "below the clip rectangle";
    EXPECT_EQ(image.at(35, 15), kRed);
    EXPECT_EQ(image.at(45, 15), kGreen);
    EXPECT_EQ(image.at(55, 15), kRed) << "the picture repeats";
    EXPECT_EQ(image.at(65, 15), kGreen);
    EXPECT_EQ(image.at(20, 50), kBlue);
    EXPECT_EQ(image.at(50, 50), kBlack) << "a number that stands for nothing";
    EXPECT_EQ(image.at(80, 50), (render::Rgba8{128, 128, 128, 255})) << "half a white, and opaque";
}

TEST(UiDraw, writes_text) {
    const render::Image image = draw_frames(render::ContextKind::OSMesa, 1).first;
    EXPECT_GT(lit_pixels(image, 78, 96), 60);
    EXPECT_EQ(lit_pixels(image, 64, 78), 0);
}

TEST(UiDraw, a_larger_scale_draws_the_same_at_more_pixels) {
    const render::Image image = draw_frames(render::ContextKind::OSMesa, 2).first;
    EXPECT_EQ(image.width_px, 2 * kSide);
    EXPECT_EQ(image.at(24, 28), kWhite);
    EXPECT_EQ(image.at(24, 32), kBlack);
    EXPECT_EQ(image.at(110, 30), kRed);
    EXPECT_EQ(image.at(40, 100), kBlue);
}

TEST(UiDraw, the_same_lists_have_the_same_bits) {
    const DrawnFrames frames = draw_frames(render::ContextKind::OSMesa, 1);
    EXPECT_EQ(frames.first, frames.second) << "the font stays when its pixels are gone from memory";
    EXPECT_EQ(frames.first, draw_frames(render::ContextKind::OSMesa, 1).first);
}

TEST(UiDraw, both_makers_draw_the_same) {
    const render::Image osmesa = draw_frames(render::ContextKind::OSMesa, 1).first;
    try {
        make_context(render::ContextKind::Egl);
    } catch (const sim::InputError& error) {
        GTEST_SKIP() << error.problem();
    }
    EXPECT_EQ(osmesa, draw_frames(render::ContextKind::Egl, 1).first);
}

TEST(UiDraw, a_font_atlas_built_anew_takes_the_place_of_the_old) {
    const ImGuiContextOwner imgui(1);
    const std::unique_ptr<render::GlContext> context = make_context(render::ContextKind::OSMesa);
    UiDraw drawer(*context);
    render::PictureTexture to(context->gl());
    to.resize(kSide, kSide);
    make_lists();
    drawer.draw(target_of(to));
    const int before = lit_pixels(to.read(), 78, kSide);
    ImFontConfig large;
    large.SizePixels = 20;
    ImGui::GetIO().Fonts->Clear();
    ImGui::GetIO().Fonts->AddFontDefault(&large);
    ImGui::GetIO().Fonts->Build();
    make_lists();
    drawer.draw(target_of(to));
    EXPECT_GT(lit_pixels(to.read(), 78, kSide), before + before / 4);
}

}  // namespace

namespace {

void lay_down(const std::filesystem::path& file) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << "font";
}

TEST(FindFont, the_first_family_that_is_there_is_taken) {
    const ScratchFolder scratch;
    const std::filesystem::path root = scratch.path();
    EXPECT_TRUE(render::find_fonts({root / "absent", root}).regular.empty());
    lay_down(root / "truetype/dejavu/DejaVuSans.ttf");
    EXPECT_EQ(render::find_fonts({root}).regular, root / "truetype/dejavu/DejaVuSans.ttf");
    EXPECT_EQ(render::find_fonts({root}).medium, root / "truetype/dejavu/DejaVuSans.ttf");
    lay_down(root / "opentype/inter/Inter-Regular.otf");
    EXPECT_EQ(render::find_fonts({root}).regular, root / "opentype/inter/Inter-Regular.otf");
    EXPECT_EQ(render::find_fonts({root}).medium, root / "opentype/inter/Inter-Regular.otf") << "it has no medium here";
    lay_down(root / "opentype/inter/Inter-Medium.otf");
    EXPECT_EQ(render::find_fonts({root}).medium, root / "opentype/inter/Inter-Medium.otf");
}

TEST(TabularDigits, have_one_width_that_is_the_widest_ones) {
    const render::FontFiles files = render::find_fonts();
    if (files.regular.empty()) GTEST_SKIP() << "no font is installed";
    ImFontAtlas atlas;
    ImFont* font = atlas.AddFontFromFileTTF(files.regular.c_str(), 32);
    atlas.Build();
    const auto width = [&](const char* text) { return font->CalcTextSizeA(32, 1e6F, 0, text).x; };
    const float letters = width("seam");
    float widest = 0;
    for (const char* digit : {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"})
        widest = std::max(widest, width(digit));
    editor::make_digits_tabular(*font);
    for (const char* digit : {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"})
        EXPECT_EQ(width(digit), widest) << digit;
    EXPECT_EQ(width("seam"), letters);
}

}  // namespace

namespace {

TEST(WindowKeys, letters_are_those_that_the_layout_writes) {
    EXPECT_EQ(key_of_code('Q', "a"), editor::Key('A')) << "a French keyboard";
    EXPECT_EQ(key_of_code('Q', ""), editor::Key('Q'));
    EXPECT_EQ(key_of_code('1', "&"), editor::Key('1'));
    EXPECT_EQ(key_of_code(';', "\xC3\xB6"), editor::Key(';')) << "a letter that has no key of its own";
}

TEST(WindowKeys, others_are_known_by_their_place) {
    EXPECT_EQ(key_of_code(256, ""), editor::Key::Escape);
    EXPECT_EQ(key_of_code(269, ""), editor::Key::End);
    EXPECT_EQ(key_of_code(335, ""), editor::Key::KeypadEnter);
    EXPECT_EQ(key_of_code(341, ""), editor::Key::None) << "a modifier";
    EXPECT_EQ(key_of_code(-1, ""), editor::Key::None);
    EXPECT_EQ(key_of_code(280, ""), editor::Key::None) << "caps lock";
}

TEST(WindowKeys, text_is_utf8) {
    EXPECT_EQ(utf8_of('a'), "a");
    EXPECT_EQ(utf8_of(0xE9), "\xC3\xA9");
    EXPECT_EQ(utf8_of(0x20AC), "\xE2\x82\xAC");
    EXPECT_EQ(utf8_of(0x1F9F5), "\xF0\x9F\xA7\xB5");
}

}  // namespace

}  // namespace selvedge::app
