// The sheet as a person sees it, in the states that matter. With SELVEDGE_SHEET_PICTURES naming a folder the pictures
// are written there, to be looked at.
#include <gtest/gtest.h>

#include <cstdlib>

#include "render/image/image.h"
#include "tests/editor/sheet/sheet_support.h"

namespace selvedge::editor {
namespace {

void keep(SheetStage& stage, const std::string& name) {
    const render::Image picture = stage.picture();
    if (const char* folder = std::getenv("SELVEDGE_SHEET_PICTURES")) {
        write_png(std::filesystem::path(folder) / (name + ".png"), picture);
    }
}

TEST(SheetPictures, the_tshirt_framed) {
    SheetStage stage(shipped_pattern("tshirt"), {1280, 800, 1});
    stage.move({0.1, 0.1});
    keep(stage, "tshirt");
}

TEST(SheetPictures, an_armhole_with_selection_and_handles) {
    SheetStage stage(shipped_pattern("tshirt"));
    SheetCamera camera = stage.view.camera();
    camera.centre = stage.on_edge("front", 2, 0.5);
    camera.scale = 2600;
    stage.view.set_camera(camera);
    stage.key(key_of('Z'));
    stage.click(stage.on_edge("front", 2, 0.5));
    stage.move(stage.vertex("front", 2));
    keep(stage, "armhole");
}

TEST(SheetPictures, sewing_in_progress) {
    sim::PatternDocument source = shipped_pattern("tshirt");
    source.pattern.seams.erase(source.pattern.seams.begin(), source.pattern.seams.begin() + 2);
    SheetStage stage(source, {1280, 800, 1});
    stage.key(key_of('N'));
    stage.click(stage.on_edge("front", 3, 0.2));
    stage.move(stage.on_edge("back", 5, 0.8));
    keep(stage, "sewing");
}

TEST(SheetPictures, an_uneven_seam) {
    SheetStage stage(shipped_pattern("tshirt"), {1280, 800, 1});
    stage.tools.run({stage.document, stage.hover, stage.messages}, MoveVertices{{{"front", 1}}, Vec2d(0.0, 0.008)});
    stage.key(key_of('N'));
    stage.click(stage.on_edge("front", 1, 0.2));
    keep(stage, "uneven");
}

TEST(SheetPictures, a_polygon_with_a_typed_number) {
    SheetStage stage(sim::PatternDocument{});
    stage.key(key_of('H'));
    stage.click({0.20, 0.15});
    stage.click({0.75, 0.15});
    stage.click({0.85, 0.45}, {.ctrl = true});
    stage.click({0.70, 0.65});
    stage.move({0.35, 0.65});
    stage.type("92/4+1");
    keep(stage, "polygon");
}

}  // namespace
}  // namespace selvedge::editor
