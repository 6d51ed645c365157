#include "editor/sheet/cloth_textures.h"

#include <algorithm>

#include "editor/sheet/panel_faces.h"

namespace selvedge::editor {
namespace {

std::array<Vec3f, 2> rows_of_sett(const sim::Sett& sett, const Vec2d& position) {
    const Vec2d repeat(repeat_size(sett), weft_repeat_size(sett));
    return {Vec3d(1 / repeat.x(), 0, -position.x() / repeat.x()).cast<float>(),
            Vec3d(0, 1 / repeat.y(), -position.y() / repeat.y()).cast<float>()};
}

}  // namespace

void ClothTextures::begin_frame(std::uint64_t fabric_version) {
    ++frame_;
    if (fabric_version != fabric_version_) looks_.forget_fabrics();
    fabric_version_ = fabric_version;
}

ClothTexture ClothTextures::find(FrameOutput& output, UiTexture first, const sim::Pattern& pattern,
                                 const sim::Panel& panel, double scale) {
    const sim::SurfaceDesign design = looks_.design_of(pattern, panel);
    if (design == render::plain_design()) return {};
    const render::ClothLook& look = looks_.look(design);
    if (!look.picture && look.sett.stripes.empty()) return {};
    const int side = look.picture ? 0 : sett_tile_side(repeat_size(look.sett) * scale);
    auto held =
        std::ranges::find_if(held_, [&](const Held& one) { return one.design == design && one.side_px == side; });
    if (held == held_.end()) {
        if (held_.size() < kSheetTextures) {
            held = held_.insert(held_.end(), Held{});
        } else {
            held = std::ranges::min_element(held_, {}, &Held::frame);
            if (held->frame == frame_) return {};
        }
        *held = {.design = design, .side_px = side};
        TextureUpload upload{.texture = first + static_cast<UiTexture>(held - held_.begin())};
        upload.picture = look.picture ? *look.picture->image : sett_tile(look.sett, side);
        upload.has_levels = look.picture.has_value();
        if (look.picture && !look.picture->is_repeated) upload.around = look.picture->ground;
        output.pictures.push_back(std::move(upload));
    }
    held->frame = frame_;
    return {.texture = first + static_cast<UiTexture>(held - held_.begin()),
            .rows = look.picture ? picture_rows(*look.picture) : rows_of_sett(look.sett, design.position)};
}

}  // namespace selvedge::editor
