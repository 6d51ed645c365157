#include "app/picture.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <string_view>

#include "app/arguments.h"
#include "render/image/image.h"
#include "render/marks/show.h"
#include "render/scene/camera.h"
#include "sim/core/error.h"
#include "sim/tartan/named_tartan.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::app {
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
    if (!is_read)
        throw sim::InputError("", "--size", "'" + text + "' is not WIDTHxHEIGHT in pixels, such as 1024x1024");
    render::check_size({.width_px = width, .height_px = height});
    options.width_px = width;
    options.height_px = height;
}

double parse_number(const std::string& option, std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
        throw sim::InputError("", option, "'" + std::string(text) + "' is not a number");
    }
    return value;
}

double parse_sett_size(const std::string& text) {
    const double size_cm = parse_number("--sett-size", text);
    constexpr Limits<double> limits = render::kSettSizesCm;
    if (size_cm < limits.least || size_cm > limits.most)
        throw sim::InputError("", "--sett-size", "must be from 0.1 to 500 cm");
    return size_cm / 100;
}

Vec2d parse_sett_position(const std::string& text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) throw sim::InputError("", "--sett-position", "'" + text + "' is not X,Y in cm");
    return Vec2d(parse_number("--sett-position", std::string_view(text).substr(0, comma)),
                 parse_number("--sett-position", std::string_view(text).substr(comma + 1))) /
           100;
}

// Returns the value, or throws an error that lists the known ones.
template <class T>
T known(const std::optional<T>& value, const std::string& option, const std::string& text, const std::string& names) {
    if (!value) throw sim::InputError("", option, "'" + text + "' is none of " + names);
    return *value;
}

int parse_samples(const std::string& text) {
    int samples = 0;
    if (parse_int(text, samples) && render::is_sample_count(samples)) return samples;
    throw sim::InputError("", "--samples", "'" + text + "' is none of 1, 2, 4, 8");
}

int parse_count(const std::string& option, const std::string& text, Limits<int> limits) {
    int value = 0;
    if (!parse_int(text, value) || value < limits.least || value > limits.most) {
        throw sim::InputError(
            "", option,
            "'" + text + "' is not from " + std::to_string(limits.least) + " to " + std::to_string(limits.most));
    }
    return value;
}

}  // namespace

void add_picture_options(Command& command, PictureOptions& options) {
    using Text = const std::string&;
    const auto add = [&](const char* name, const std::string& help, const OptionDetails& details,
                         const std::function<void(Text)>& read) {
        OptionDetails of_picture = details;
        of_picture.group = "Picture";
        add_text_option(command, name, help, of_picture, read);
    };
    add("--size", "Size of the picture in pixels (default 1024x1024)", {.type = "WxH"},
        [&](Text text) { parse_size(text, options); });
    add("--samples", "Samples per pixel of edges: 1, 2, 4 or, where the renderer can, 8 (default 4)", {.type = "N"},
        [&](Text text) { options.samples = parse_samples(text); });
    add("--supersample", "Draws so many times as large and averages, 1 to 4 (default 1)", {.type = "N"},
        [&](Text text) { options.supersample = parse_count("--supersample", text, render::kSupersamples); });
    add("--view", std::string("From where: ") + render::kViewNames + " (default front)", {.type = "VIEW"},
        [&](Text text) { options.view = known(render::parse_view(text), "--view", text, render::kViewNames); });
    add("--camera", "From where, in numbers: AZIMUTH,ELEVATION[,ZOOM] in degrees, or the eye and its target in m",
        {.type = "NUMBERS", .excludes = {"--view"}}, [&](Text text) { options.camera = render::parse_camera(text); });
    add("--frame", "What fills the picture: all, garment (default all)", {.type = "WHAT"},
        [&](Text text) { options.framing = render::parse_framing(text); });
    add("--show", "How the cloth is drawn: " + render::show_mode_names() + " (default tartan)", {.type = "MODE"},
        [&](Text text) {
            options.show = known(render::parse_show_mode(text), "--show", text, render::show_mode_names());
        });
    add("--tartan",
        std::string("A shipped tartan or a threadcount, such as 'B/24 W4 B24 R/2' (default the garment's; of a mesh ") +
            sim::kDefaultTartan + ")",
        {.type = "NAME"}, [&](Text text) {
            options.sett = sim::named_tartan(text, "", "--tartan");
            options.design = sim::SurfaceDesign{.source = text};
        });
    add("--design", "What the cloth shows instead of a tartan: a colour #RRGGBB, a PNG or JPEG file, or test",
        {.type = "COLOUR|FILE|test", .excludes = {"--tartan"}},
        [&](Text text) { options.design = render::parse_design(text); });
    add("--sett-size", "Size of a repeat of the tartan or design in cm (default its own)", {.type = "CM"},
        [&](Text text) { options.sett_size = parse_sett_size(text); });
    add("--sett-position", "Where the sett begins, across and along the grain in cm (default 0,0)", {.type = "X,Y"},
        [&](Text text) { options.sett_position = parse_sett_position(text); });
    add_surface_options(command, options.surface);
    add_flag(command, "--transparent", options.is_transparent, "No backdrop: only garment, body and shadow",
             {.group = "Picture"});
}

}  // namespace selvedge::app
