// The kinds of GL context, and that all of them give the same picture.
#include <gtest/gtest.h>

#include <cstdlib>

#include "render/draw/renderer.h"
#include "render/image/image.h"
#include "sim/core/error.h"
#include "tests/golden/frozen_scene.h"

namespace selvedge::test {
namespace {

std::optional<std::string> why_absent(render::ContextKind maker) {
    try {
        make_context(maker);
        return std::nullopt;
    } catch (const sim::InputError& error) {
        return error.problem();
    }
}

class WithEnvironment {
 public:
    explicit WithEnvironment(const char* value) {
        if (const char* before = std::getenv(kName)) before_ = before;
        setenv(kName, value, 1);
    }
    ~WithEnvironment() { before_ ? setenv(kName, before_->c_str(), 1) : unsetenv(kName); }

 private:
    static constexpr const char* kName = "SELVEDGE_GL";
    std::optional<std::string> before_;
};

TEST(Contexts, both_makers_draw_the_same_picture) {
    for (const render::ContextKind maker : {render::ContextKind::OSMesa, render::ContextKind::Egl}) {
        if (const auto reason = why_absent(maker)) GTEST_SKIP() << name(maker) << " is absent: " << *reason;
    }
    const render::Scene scene = make_frozen_scene();
    const render::RenderOptions options{.width_px = 200, .height_px = 160};
    const render::Image osmesa = render::Renderer(render::ContextKind::OSMesa).draw(scene, options);
    const render::Image egl = render::Renderer(render::ContextKind::Egl).draw(scene, options);
    const render::Comparison comparison = compare(osmesa, egl);
    EXPECT_TRUE(is_alike(comparison)) << describe(comparison);
}

TEST(Contexts, the_environment_chooses_the_maker) {
    for (const render::ContextKind maker : {render::ContextKind::OSMesa, render::ContextKind::Egl}) {
        if (const auto reason = why_absent(maker)) GTEST_SKIP() << name(maker) << " is absent: " << *reason;
        const WithEnvironment environment(name(maker));
        EXPECT_EQ(render::make_context()->maker(), maker);
    }
}

TEST(Contexts, a_maker_that_is_not_known_is_an_input_error) {
    const WithEnvironment environment("voodoo");
    try {
        render::make_context();
        FAIL() << "no error";
    } catch (const sim::InputError& error) {
        EXPECT_STREQ(error.what(), "SELVEDGE_GL: 'voodoo' is neither osmesa nor egl");
    }
}

TEST(Contexts, say_what_they_are) {
    EXPECT_NE(render::make_context()->description().find("OpenGL"), std::string::npos);
}

}  // namespace
}  // namespace selvedge::test
