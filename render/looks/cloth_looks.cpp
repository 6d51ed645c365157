#include "render/looks/cloth_looks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/image/photo.h"
#include "render/scene/colour.h"
#include "sim/core/error.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::render {
namespace {

constexpr int kLargestPicture = 4096;  // px, of a side: larger ones are reduced

sim::Rgb8 ground_of(const sim::SurfaceDesign& design) {
    return sim::parse_colour(design.ground.empty() ? sim::kUsualGround : design.ground, "", "ground");
}

void make_opaque(Image& image, const sim::Rgb8& ground) {
    for (Rgba8& pixel : image.pixels) {
        const double share = pixel[3] / 255.0;
        for (std::size_t i = 0; i < 3; ++i) {
            pixel[i] = static_cast<std::uint8_t>(std::lround(share * pixel[i] + (1 - share) * ground[i]));
        }
        pixel[3] = 255;
    }
}

constexpr int kTestSide = 1000, kTestSquare = 100;  // px

Rgba8 test_square_colour(int column, int row) {
    constexpr double kTurn = 2 * 3.14159265358979323846;
    const bool is_dark = (column + row) % 2 == 1;
    const double hue = kTurn * row / 10, lightness = (is_dark ? 0.52 : 0.80) + 0.012 * column;
    const sim::Rgb8 colour = from_oklab(Vec3d(lightness, 0.09 * std::cos(hue), 0.09 * std::sin(hue)).cast<float>());
    return {colour[0], colour[1], colour[2], 255};
}

// x and y from the lower left corner.
void fill_rectangle(Image& image, int left, int low, int width, int height, const Rgba8& colour) {
    for (int y = low; y < low + height; ++y) {
        for (int x = left; x < left + width; ++x) {
            if (image.contains(x, image.height_px - 1 - y)) image.at(x, image.height_px - 1 - y) = colour;
        }
    }
}

}  // namespace

Image test_pattern() {
    constexpr Rgba8 kInk{0x26, 0x29, 0x2E, 255}, kMark{0x1E, 0x8A, 0x3C, 255};
    Image image(kTestSide, kTestSide);
    for (int row = 0; row < 10; ++row) {
        for (int column = 0; column < 10; ++column) {
            fill_rectangle(image, column * kTestSquare, row * kTestSquare, kTestSquare, kTestSquare,
                           test_square_colour(column, row));
        }
    }
    // The mark of the position, with its axes; then an arrow along the warp.
    fill_rectangle(image, 0, 0, 3 * kTestSquare, 16, kMark);
    fill_rectangle(image, 0, 0, 16, 3 * kTestSquare, kMark);
    fill_rectangle(image, 0, 0, 60, 60, kMark);
    fill_rectangle(image, 485, 250, 30, 420, kInk);
    for (int y = 0; y < 140; ++y) fill_rectangle(image, 500 - (140 - y) / 2, 640 + y, 140 - y, 1, kInk);
    return image;
}

ClothPicture picture_of(const sim::SurfaceDesign& design) {
    ClothPicture picture{.position = design.position.cast<float>(),
                         .rotation = static_cast<float>(design.rotation),
                         .is_repeated = design.is_repeated,
                         .ground = ground_of(design)};
    Image image = design.kind == sim::DesignKind::Test ? test_pattern()
                                                       : reduced(read_photo(design.source).image, kLargestPicture);
    make_opaque(image, picture.ground);
    const auto width = static_cast<float>(design.size.value_or(sim::kUsualDesignSize));
    picture.size = {width, width * float(image.height_px) / float(image.width_px)};
    picture.image = std::make_shared<const Image>(std::move(image));
    return picture;
}

sim::Sett sett_of(const sim::SurfaceDesign& design) {
    if (design.kind == sim::DesignKind::Tartan) return sim::find_sett(design.source, design.size);
    constexpr int kLeastThreads = 2;  // of a repeat
    sim::Sett sett{.name = design.source, .stripes = {}, .weave = sim::Weave::Plain};
    sett.stripes.push_back({"C", sim::parse_colour(design.source, "", "colour"), kLeastThreads});
    return sett;
}

sim::SurfaceDesign plain_design() {
    return {.kind = sim::DesignKind::Colour, .source = kPlainCloth};
}

const sim::Fabric& ClothLooks::fabric(const std::string& name) {
    const auto known = fabrics_.find(name);
    if (known != fabrics_.end()) return known->second;
    sim::Fabric fabric;
    try {
        fabric = sim::find_fabric(name);
    } catch (const sim::InputError&) {
        if (unknown_ == Unknown::Fail) throw;
        fabric.name = name;
    }
    return fabrics_.emplace(name, std::move(fabric)).first->second;
}

const ClothLook& ClothLooks::look(const sim::SurfaceDesign& design) {
    const auto known = std::ranges::find(looks_, design, &std::pair<sim::SurfaceDesign, ClothLook>::first);
    if (known != looks_.end()) return known->second;
    ClothLook look;
    try {
        const bool is_picture = design.kind == sim::DesignKind::Picture || design.kind == sim::DesignKind::Test;
        if (is_picture) look.picture = picture_of(design);
        if (!is_picture) look.sett = sett_of(design);
    } catch (const sim::InputError&) {
        if (unknown_ == Unknown::Fail) throw;
        look = {.sett = sett_of(plain_design())};
    }
    constexpr std::size_t kMostKept = 64;  // a colour that is dragged makes a new one in each frame
    if (looks_.size() >= kMostKept) looks_.erase(looks_.begin());
    return looks_.emplace_back(design, std::move(look)).second;
}

sim::SurfaceDesign ClothLooks::design_of(const sim::Pattern& pattern) {
    if (pattern.surface) return *pattern.surface;
    if (!pattern.tartan.empty())
        return {.source = pattern.tartan, .size = pattern.sett_size, .position = pattern.sett_position};
    return fabric(pattern.fabric).surface.value_or(plain_design());
}

sim::SurfaceDesign ClothLooks::design_of(const sim::Pattern& pattern, const sim::Panel& panel) {
    if (panel.surface) return *panel.surface;
    if (!panel.fabric.empty() && fabric(panel.fabric).surface) return *fabric(panel.fabric).surface;
    return design_of(pattern);
}

void ClothLooks::read(const sim::Pattern& pattern) {
    look(design_of(pattern));
    for (const sim::Panel& panel : pattern.panels) look(design_of(pattern, panel));
}

std::vector<ClothItem> ClothLooks::parts(ClothItem cloth, const sim::Pattern& pattern) {
    using Key = std::pair<sim::SurfaceDesign, std::string>;
    std::vector<Key> keys;
    std::vector<std::size_t> part_of(std::max<std::size_t>(1, cloth.mesh.panel_names.size()));
    for (std::size_t p = 0; p < part_of.size(); ++p) {
        const bool has_name = p < cloth.mesh.panel_names.size();
        const auto panel = has_name ? std::ranges::find(pattern.panels, cloth.mesh.panel_names[p], &sim::Panel::name)
                                    : pattern.panels.end();
        const bool is_known = panel != pattern.panels.end();
        const std::string made_of = is_known && !panel->fabric.empty() ? panel->fabric : pattern.fabric;
        const Key key{is_known ? design_of(pattern, *panel) : design_of(pattern), made_of};
        const auto found = std::ranges::find(keys, key);
        part_of[p] = static_cast<std::size_t>(found - keys.begin());
        if (found == keys.end()) keys.push_back(key);
    }
    std::vector<std::vector<std::size_t>> triangles(keys.size());
    for (std::size_t t = 0; t < cloth.mesh.triangles.size(); ++t) {
        const std::size_t panel = panel_of(cloth.mesh, t);
        triangles[part_of[panel < part_of.size() ? panel : 0]].push_back(t);
    }
    std::vector<ClothItem> items;
    for (std::size_t k = 0; k < keys.size(); ++k) {
        if (triangles[k].empty()) continue;
        ClothItem item = k + 1 < keys.size() ? cloth : std::move(cloth);
        if (keys.size() > 1) item.mesh = with_triangles(std::move(item.mesh), triangles[k]);
        const ClothLook& shown = look(keys[k].first);
        item.sett = shown.sett;
        item.picture = shown.picture;
        item.sett_position = keys[k].first.position.cast<float>();
        item.sett_scale = 1;
        item.material = material_of(fabric(keys[k].second));
        items.push_back(std::move(item));
    }
    return items;
}

}  // namespace selvedge::render
