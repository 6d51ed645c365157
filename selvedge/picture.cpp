#include "selvedge/picture.h"

#include <cmath>
#include <memory>
#include <string_view>
#include <utility>

#include "render/image/image.h"
#include "render/marks/show.h"
#include "render/output/garment_files.h"
#include "render/output/interface_fonts.h"
#include "render/output/picture.h"
#include "render/output/view_choice.h"
#include "render/scene/camera.h"
#include "selvedge/content.h"
#include "sim/core/error.h"
#include "sim/core/file_extension.h"
#include "sim/core/numbers.h"
#include "sim/exchange/mesh_file.h"
#include "sim/pattern/fault.h"
#include "sim/tartan/named_tartan.h"

namespace selvedge {
namespace {

constexpr double kMm = 0.001;  // m

// Returns the value, or throws an error that lists the known ones.
template <class T>
T known(const std::optional<T>& value, const char* place, const std::string& text, const std::string& names) {
    if (!value) throw sim::InputError("", place, "'" + text + "' is none of " + names);
    return *value;
}

// How the result's cloth looks, as the commands' options say it.
render::PictureOptions picture_of(const Result::Content& result, const Looks& looks, const std::string& surface) {
    render::PictureOptions picture;
    if (!looks.tartan.empty() && !looks.design.empty())
        throw sim::InputError("", "design", "the cloth shows either a tartan or a design");
    if (!looks.tartan.empty()) {
        picture.sett = sim::named_tartan(looks.tartan, "", "tartan");
        picture.design = sim::SurfaceDesign{.source = looks.tartan};
    }
    if (!looks.design.empty()) picture.design = render::parse_design(looks.design);
    picture.sett_size = sim::within(looks.sett_size, render::kSettSizesCm, "sett_size", kCm);
    if (looks.sett_position) {
        const auto [weft, warp] = *looks.sett_position;
        for (const double one : {weft, warp})
            sim::within(one, {-sim::kMaxCoordinate, sim::kMaxCoordinate}, "sett_position");
        picture.sett_position = Vec2d(weft, warp);
    }
    if (!surface.empty()) picture.surface.modifier = render::parse_modifier(surface);
    const auto& [document, file] = result.pattern.content();
    name_looks(picture, document.pattern, result.fabric);
    read_looks(picture, document.pattern, result.fabric, file);
    return picture;
}

render::PictureOptions picture_of(const Result::Content& result, const PictureOptions& options) {
    check_size(render::PictureSize{.width_px = options.width_px, .height_px = options.height_px});
    if (!render::is_sample_count(options.samples)) throw sim::InputError("", "samples", "must be 1, 2, 4 or 8");
    render::PictureOptions picture = picture_of(result, options.looks, options.surface);
    picture.width_px = options.width_px;
    picture.height_px = options.height_px;
    picture.samples = options.samples;
    picture.supersample = sim::within(options.supersample, render::kSupersamples, "supersample");
    if (options.camera.empty()) {
        picture.view = known(render::parse_view(options.view), "view", options.view, render::kViewNames);
    } else {
        picture.camera = render::parse_camera(options.camera);
    }
    picture.framing = render::parse_framing(options.frame);
    picture.show = known(render::parse_show_mode(options.show), "show", options.show, render::show_mode_names());
    picture.is_transparent = options.is_transparent;
    picture.legend_font = render::read_legend_font();
    return picture;
}

render::GarmentFileOptions file_options(const ExportOptions& options) {
    render::GarmentFileOptions files{.files = {}, .content = {}};
    files.has_textures = options.has_textures;
    files.content.atlas.size_px = sim::within(options.texture_size_px, render::kTextureSizesPx, "texture_size_px");
    files.has_body = options.has_body;
    files.has_curved_surface = !options.surface.empty();
    if (options.thickness && options.has_fabric_thickness)
        throw sim::InputError("", "thickness", "is either a number or the fabrics' own");
    if (options.thickness || options.has_fabric_thickness)
        files.thickness =
            render::ClothThickness{.metres = sim::within(options.thickness, render::kThicknessesMm, "thickness", kMm)};
    return files;
}

// The library's pixels as the program's. Throws InputError if there is none, or another number than the size says.
render::Image checked(const Image& image) {
    render::check_image_size(image.width_px, image.height_px, "");
    const bool is_whole =
        image.width_px > 0 && image.height_px > 0 &&
        image.pixels.size() == static_cast<std::size_t>(image.width_px) * static_cast<std::size_t>(image.height_px);
    if (!is_whole) throw sim::InputError("", "image", "must have width_px * height_px pixels, and at least one");
    render::Image inner;
    inner.width_px = image.width_px;
    inner.height_px = image.height_px;
    inner.pixels = image.pixels;
    return inner;
}

}  // namespace

Image draw(const Result& result, const PictureOptions& options) {
    return for_caller([&] {
        const Result::Content& content = result.content();
        render::Image image = draw_picture(
            {.garment = content.garment, .body = &content.body.content().body(), .hierarchy = &content.hierarchy},
            picture_of(content, options));
        return Image{.width_px = image.width_px, .height_px = image.height_px, .pixels = std::move(image.pixels)};
    });
}

void write_garment(const Result& result, const std::filesystem::path& file, const ExportOptions& options) {
    for_caller([&] {
        const render::GarmentFileOptions files = file_options(options);
        static_cast<void>(sim::mesh_format_of(file));
        check_format(file, files);
        const Result::Content& content = result.content();
        const render::PictureOptions picture = picture_of(content, options.looks, options.surface);
        render::GarmentFiles(files, picture, content.garment, content.body.content().body()).write(file);
    });
}

void write_png(const Image& image, const std::filesystem::path& file) {
    for_caller([&] {
        if (sim::lower_extension(file) != ".png")
            throw sim::InputError(file.string(), "", "cannot write: the name should end in .png");
        render::write_png(file, checked(image));
    });
}

std::string encode_png(const Image& image) {
    return for_caller([&] { return render::encode_png(checked(image)); });
}

}  // namespace selvedge
