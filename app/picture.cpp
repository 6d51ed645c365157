#include "app/picture.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "render/gl/context.h"
#include "render/image/png.h"
#include "render/level_legend.h"
#include "render/renderer.h"
#include "sim/core/error.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge {
namespace {

bool parse_int(std::string_view text, int& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

void parse_size(const std::string& text, PictureOptions& options) {
    const std::size_t cross = text.find('x');
    int width = 0, height = 0;
    const bool is_read = cross != std::string::npos && parse_int(std::string_view(text).substr(0, cross), width) &&
                         parse_int(std::string_view(text).substr(cross + 1), height);
    if (!is_read) throw InputError("", "--size", "'" + text + "' is not WIDTHxHEIGHT in pixels, such as 1024x1024");
    const bool is_drawable = width >= 1 && height >= 1 && width <= kMaxImageSide && height <= kMaxImageSide &&
                             static_cast<long>(width) * height <= kMaxImagePixels;
    if (!is_drawable) {
        throw InputError("", "--size",
                         "'" + text + "': sides are from 1 to " + std::to_string(kMaxImageSide) + ", with at most " +
                             std::to_string(kMaxImagePixels / 1000000) + " million pixels");
    }
    options.width_px = width;
    options.height_px = height;
}

double parse_number(const std::string& option, std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
        throw InputError("", option, "'" + std::string(text) + "' is not a number");
    }
    return value;
}

double parse_sett_size(const std::string& text) {
    const double size_cm = parse_number("--sett-size", text);
    if (size_cm < 0.1 || size_cm > 500) throw InputError("", "--sett-size", "must be from 0.1 to 500 cm");
    return size_cm / 100;
}

Vec2d parse_sett_position(const std::string& text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) throw InputError("", "--sett-position", "'" + text + "' is not X,Y in cm");
    return Vec2d(parse_number("--sett-position", std::string_view(text).substr(0, comma)),
                 parse_number("--sett-position", std::string_view(text).substr(comma + 1))) /
           100;
}

// The value, or an error that lists those there are.
template <class T>
T known(const std::optional<T>& value, const std::string& option, const std::string& text, const char* names) {
    if (!value) throw InputError("", option, "'" + text + "' is none of " + names);
    return *value;
}

Framing parse_framing(const std::string& text) {
    if (text == "all") return Framing::All;
    if (text == "garment") return Framing::Garment;
    throw InputError("", "--frame", "'" + text + "' is none of all, garment");
}

bool is_finite(const PlainMesh& mesh, std::size_t triangle) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
        if (!mesh.x[mesh.triangles[triangle][corner]].allFinite()) return false;
        if (!mesh.u.empty() && !mesh.u[triangle][corner].allFinite()) return false;
    }
    return true;
}

template <class T>
void keep(std::vector<T>& values, const std::vector<std::size_t>& kept) {
    if (values.empty()) return;
    for (std::size_t i = 0; i < kept.size(); ++i) values[i] = values[kept[i]];
    values.resize(kept.size());
}

// A garment that burst must still have its picture. Vertices that are left without a triangle move to one that is not.
PlainMesh without_bad_numbers(PlainMesh mesh) {
    std::vector<std::size_t> kept;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (is_finite(mesh, t)) kept.push_back(t);
    }
    if (kept.empty()) throw InputError("", "picture", "the garment has no triangle that can be drawn");
    keep(mesh.triangles, kept);
    keep(mesh.u, kept);
    keep(mesh.panel, kept);
    keep(mesh.level, kept);
    const Vec3f somewhere = mesh.x[mesh.triangles.front().front()];
    for (Vec3f& x : mesh.x) x = x.allFinite() ? x : somewhere;
    const bool has_normals =
        std::all_of(mesh.normals.begin(), mesh.normals.end(), [](const Vec3f& normal) { return normal.allFinite(); });
    if (!has_normals) mesh.normals.clear();
    return mesh;
}

ClothItem make_cloth_item(const PlainMesh& garment, const PictureOptions& options) {
    ClothItem item;
    item.mesh = without_bad_numbers(garment);
    item.sett = sett_of(options);
    item.sett_position = options.sett_position.cast<float>();
    item.show = options.show;
    return item;
}

float lowest(const std::vector<Vec3f>& points) {
    float low = points.front().y();
    for (const Vec3f& point : points) low = std::min(low, point.y());
    return low;
}

Scene make_scene(const PlainMesh& garment, const Body* body, const PictureOptions& options) {
    Scene scene;
    scene.cloths.push_back(make_cloth_item(garment, options));
    if (body != nullptr) scene.bodies.push_back(make_body_item(*body));
    const float aspect = float(options.width_px) / float(options.height_px);
    const bool frames_garment = options.framing == Framing::Garment || body == nullptr;
    scene.camera = frame_points(frames_garment ? scene.cloths.front().mesh.x : scene_points(scene), options.view,
                                {.aspect = aspect, .margin = frames_garment ? 0.12F : 0.07F});
    scene.light = studio_light(scene.camera);
    scene.background.is_transparent = options.is_transparent;
    // A garment alone that hangs high has no floor to stand on.
    const float low = lowest(scene_points(scene));
    scene.has_ground = low < 0.3F;
    scene.ground_y = std::min(0.0F, low);
    return scene;
}

}  // namespace

void add_picture_options(CLI::App& command, PictureOptions& options) {
    using Text = const std::string&;
    const auto add = [&](const char* name, const std::string& help, const std::function<void(Text)>& read) {
        return command.add_option_function<std::string>(name, read, help)->group("Picture");
    };
    add("--size", "Size of the picture in pixels (default 1024x1024)", [&](Text text) {
        parse_size(text, options);
    })->type_name("WxH");
    add("--view", std::string("From where: ") + kViewNames + " (default front)", [&](Text text) {
        options.view = known(parse_view(text), "--view", text, kViewNames);
    })->type_name("VIEW");
    add("--frame", "What fills the picture: all, garment (default all)", [&](Text text) {
        options.framing = parse_framing(text);
    })->type_name("WHAT");
    add("--show", std::string("How the cloth is drawn: ") + kShowModeNames + " (default tartan)", [&](Text text) {
        options.show = known(parse_show_mode(text), "--show", text, kShowModeNames);
    })->type_name("MODE");
    add("--tartan", "A shipped tartan or a threadcount, such as 'B/24 W4 B24 R/2'", [&](Text text) {
        options.sett = find_tartan(text);
    })->type_name("NAME");
    add("--sett-size", "Size of the tartan's repeat in cm (default its own)", [&](Text text) {
        options.sett_size = parse_sett_size(text);
    })->type_name("CM");
    add("--sett-position", "Where the sett begins, across and along the grain in cm (default 0,0)", [&](Text text) {
        options.sett_position = parse_sett_position(text);
    })->type_name("X,Y");
    command.add_flag("--transparent", options.is_transparent, "No backdrop: only garment, body and shadow")
        ->group("Picture");
}

Sett sett_of(const PictureOptions& options) {
    const Sett sett = options.sett ? *options.sett : find_tartan(kDefaultTartan);
    return options.sett_size ? with_repeat_size(sett, *options.sett_size) : sett;
}

void check_can_draw() {
    make_context();
}

Image draw_picture(const PlainMesh& garment, const Body* body, const PictureOptions& options) {
    const Scene scene = make_scene(garment, body, options);
    Renderer renderer;
    Image image = renderer.draw(scene, {.width_px = options.width_px, .height_px = options.height_px});
    if (options.show == ShowMode::Level) draw_level_legend(image, scene.cloths.front().mesh);
    return image;
}

}  // namespace selvedge
