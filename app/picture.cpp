#include "app/picture.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

#include "app/layout.h"
#include "render/draw/renderer.h"
#include "render/gl/context.h"
#include "render/image/image.h"
#include "sim/core/error.h"
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
    const bool is_drawable = width >= 1 && height >= 1 && width <= render::kMaxImageSide &&
                             height <= render::kMaxImageSide &&
                             static_cast<long>(width) * height <= render::kMaxImagePixels;
    if (!is_drawable) {
        throw sim::InputError("", "--size",
                              "'" + text + "': sides are from 1 to " + std::to_string(render::kMaxImageSide) +
                                  ", with at most " + std::to_string(render::kMaxImagePixels / 1000000) +
                                  " million pixels");
    }
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
    if (size_cm < 0.1 || size_cm > 500) throw sim::InputError("", "--sett-size", "must be from 0.1 to 500 cm");
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
T known(const std::optional<T>& value, const std::string& option, const std::string& text, const char* names) {
    if (!value) throw sim::InputError("", option, "'" + text + "' is none of " + names);
    return *value;
}

int parse_samples(const std::string& text) {
    for (const int samples : {1, 2, 4, 8}) {
        if (text == std::to_string(samples)) return samples;
    }
    throw sim::InputError("", "--samples", "'" + text + "' is none of 1, 2, 4, 8");
}

Framing parse_framing(const std::string& text) {
    if (text == "all") return Framing::All;
    if (text == "garment") return Framing::Garment;
    throw sim::InputError("", "--frame", "'" + text + "' is none of all, garment");
}

struct Limits {
    int least;
    int most;
};

int parse_count(const std::string& option, const std::string& text, Limits limits) {
    int value = 0;
    if (!parse_int(text, value) || value < limits.least || value > limits.most) {
        throw sim::InputError(
            "", option,
            "'" + text + "' is not from " + std::to_string(limits.least) + " to " + std::to_string(limits.most));
    }
    return value;
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
    add("--samples", "Samples per pixel of edges: 1, 2, 4 or, where the renderer can, 8 (default 4)", [&](Text text) {
        options.samples = parse_samples(text);
    })->type_name("N");
    add("--supersample", "Draws so many times as large and averages, 1 to 4 (default 1)", [&](Text text) {
        options.supersample = parse_count("--supersample", text, {.least = 1, .most = 4});
    })->type_name("N");
    CLI::Option* view =
        add("--view", std::string("From where: ") + render::kViewNames + " (default front)", [&](Text text) {
            options.view = known(render::parse_view(text), "--view", text, render::kViewNames);
        })->type_name("VIEW");
    add("--camera", "From where, in numbers: AZIMUTH,ELEVATION[,ZOOM] in degrees, or the eye and its target in m",
        [&](Text text) { options.camera = parse_camera(text); })
        ->type_name("NUMBERS")
        ->excludes(view);
    add("--frame", "What fills the picture: all, garment (default all)", [&](Text text) {
        options.framing = parse_framing(text);
    })->type_name("WHAT");
    add("--show", std::string("How the cloth is drawn: ") + render::kShowModeNames + " (default tartan)",
        [&](Text text) { options.show = known(render::parse_show_mode(text), "--show", text, render::kShowModeNames); })
        ->type_name("MODE");
    add("--tartan",
        std::string("A shipped tartan or a threadcount, such as 'B/24 W4 B24 R/2' (default the pattern's, or ") +
            sim::kDefaultTartan + ")",
        [&](Text text) { options.sett = sim::find_tartan(text); })
        ->type_name("NAME");
    add("--sett-size", "Size of the tartan's repeat in cm (default its own)", [&](Text text) {
        options.sett_size = parse_sett_size(text);
    })->type_name("CM");
    add("--sett-position", "Where the sett begins, across and along the grain in cm (default 0,0)", [&](Text text) {
        options.sett_position = parse_sett_position(text);
    })->type_name("X,Y");
    add_surface_options(command, options.surface);
    command.add_flag("--transparent", options.is_transparent, "No backdrop: only garment, body and shadow")
        ->group("Picture");
}

sim::Sett chosen_sett(const PictureOptions& options) {
    const sim::Sett sett = options.sett ? *options.sett : sim::find_tartan(sim::kDefaultTartan);
    return options.sett_size ? with_repeat_size(sett, *options.sett_size) : sett;
}

void check_can_draw(const PictureOptions& options) {
    const auto context = render::make_context();
    const int most = context->max_samples();
    if (options.samples <= most) return;
    throw sim::InputError("", "--samples",
                          std::string(render::name(context->maker())) + " takes at most " + std::to_string(most) +
                              " per pixel here, not " + std::to_string(options.samples) +
                              ": --supersample smooths edges as well");
}

void check_can_show(render::ShowMode show, bool has_body, bool has_hierarchy) {
    if (show == render::ShowMode::Clearance && !has_body)
        throw sim::InputError("", "--show", "'clearance' is measured from a body: name one with --body");
    if (show == render::ShowMode::Hierarchy && !has_hierarchy) {
        throw sim::InputError("", "--show",
                              "'hierarchy' shows refined triangles, and a mesh file holds only the last ones: "
                              "use selvedge dress --show hierarchy");
    }
}

render::Image draw_picture(const RenderSubject& subject, const PictureOptions& options) {
    const Layout layout = compose(subject, options);
    render::Image image = render::Renderer().draw(layout.scene, render_options(options));
    if (layout.legend) draw_legend(image, *layout.legend, layout.corner);
    return image;
}

}  // namespace selvedge::app
