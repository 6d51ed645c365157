#include "app/picture.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "app/arguments.h"
#include "app/pattern_faults.h"
#include "render/draw/renderer.h"
#include "render/gl/context.h"
#include "render/image/image.h"
#include "render/marks/legend.h"
#include "render/marks/show.h"
#include "render/scene/camera.h"
#include "sim/core/error.h"
#include "sim/place/fit.h"
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

sim::SurfaceDesign parse_design(const std::string& text) {
    if (text == "test") return {.kind = sim::DesignKind::Test};
    if (sim::is_colour_text(text)) return {.kind = sim::DesignKind::Colour, .source = text};
    if (text.starts_with('#')) throw sim::InputError("", "--design", "'" + text + "' is no colour: #RRGGBB is");
    return {.kind = sim::DesignKind::Picture, .source = text};
}

// Returns the value, or throws an error that lists the known ones.
template <class T>
T known(const std::optional<T>& value, const std::string& option, const std::string& text, const std::string& names) {
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
        [&](Text text) { options.supersample = parse_count("--supersample", text, {.least = 1, .most = 4}); });
    add("--view", std::string("From where: ") + render::kViewNames + " (default front)", {.type = "VIEW"},
        [&](Text text) { options.view = known(render::parse_view(text), "--view", text, render::kViewNames); });
    add("--camera", "From where, in numbers: AZIMUTH,ELEVATION[,ZOOM] in degrees, or the eye and its target in m",
        {.type = "NUMBERS", .excludes = {"--view"}}, [&](Text text) { options.camera = parse_camera(text); });
    add("--frame", "What fills the picture: all, garment (default all)", {.type = "WHAT"},
        [&](Text text) { options.framing = parse_framing(text); });
    add("--show", "How the cloth is drawn: " + render::show_mode_names() + " (default tartan)", {.type = "MODE"},
        [&](Text text) {
            options.show = known(render::parse_show_mode(text), "--show", text, render::show_mode_names());
        });
    add("--tartan",
        std::string("A shipped tartan or a threadcount, such as 'B/24 W4 B24 R/2' (default the garment's; of a mesh ") +
            sim::kDefaultTartan + ")",
        {.type = "NAME"}, [&](Text text) {
            options.sett = named_tartan(text, "", "--tartan");
            options.design = sim::SurfaceDesign{.source = text};
        });
    add("--design", "What the cloth shows instead of a tartan: a colour #RRGGBB, a PNG or JPEG file, or test",
        {.type = "COLOUR|FILE|test", .excludes = {"--tartan"}},
        [&](Text text) { options.design = parse_design(text); });
    add("--sett-size", "Size of a repeat of the tartan or design in cm (default its own)", {.type = "CM"},
        [&](Text text) { options.sett_size = parse_sett_size(text); });
    add("--sett-position", "Where the sett begins, across and along the grain in cm (default 0,0)", {.type = "X,Y"},
        [&](Text text) { options.sett_position = parse_sett_position(text); });
    add_surface_options(command, options.surface);
    add_flag(command, "--transparent", options.is_transparent, "No backdrop: only garment, body and shadow",
             {.group = "Picture"});
}

void show_design(PictureOptions& picture, const std::string& fabric) {
    if (!picture.design) return;
    sim::SurfaceDesign design = *picture.design;
    design.size = picture.sett_size;
    design.position = picture.sett_position.value_or(Vec2d::Zero());
    picture.looks = std::make_shared<render::ClothLooks>(render::ClothLooks::Unknown::Fail);
    sim::Pattern pattern;
    pattern.fabric = fabric;
    pattern.surface = design;
    picture.pattern = std::make_shared<const sim::Pattern>(std::move(pattern));
    picture.looks->read(*picture.pattern);  // a picture that cannot be read is told first
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

namespace {

bool is_finite(const sim::DrawMesh& mesh, std::size_t triangle) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
        if (!mesh.x[mesh.triangles[triangle][corner]].allFinite()) return false;
        if (!mesh.u.empty() && !mesh.u[triangle][corner].allFinite()) return false;
    }
    return true;
}

// A garment with non-finite positions can still be drawn. Non-finite vertices without a triangle move to a finite one.
sim::DrawMesh without_bad_numbers(sim::DrawMesh mesh) {
    std::vector<std::size_t> kept;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (is_finite(mesh, t)) kept.push_back(t);
    }
    if (kept.empty()) throw sim::InputError("", "picture", "the garment has no triangle that can be drawn");
    mesh = with_triangles(std::move(mesh), kept);
    const Vec3f somewhere = mesh.x[mesh.triangles.front().front()];
    for (Vec3f& x : mesh.x) x = x.allFinite() ? x : somewhere;
    const bool has_normals =
        std::all_of(mesh.normals.begin(), mesh.normals.end(), [](const Vec3f& normal) { return normal.allFinite(); });
    if (!has_normals) mesh.normals.clear();
    return mesh;
}

render::ClothItem make_cloth_item(const sim::DrawMesh& garment, const PictureOptions& options) {
    render::ClothItem item;
    item.mesh = without_bad_numbers(garment);
    item.sett = chosen_sett(options);
    item.sett_position = options.sett_position.value_or(Vec2d::Zero()).cast<float>();
    item.show = options.show;
    item.material = options.material;
    if (wants_material(item.show) && item.mesh.u.empty())
        throw sim::InputError("", "--show", "strain is measured from material coordinates, and the mesh has none");
    return item;
}

float lowest(const std::vector<Vec3f>& points) {
    float low = points.front().y();
    for (const Vec3f& point : points) low = std::min(low, point.y());
    return low;
}

render::PictureSize size_of(const PictureOptions& options) {
    return {.width_px = options.width_px, .height_px = options.height_px};
}

render::Direction direction_wanted(const PictureOptions& options) {
    constexpr render::Direction from_above{.azimuth = 0.30F, .elevation = 0.62F};
    if (options.camera) return options.camera->direction;
    if (options.view) return direction_of(*options.view);
    return options.show == render::ShowMode::Hierarchy ? from_above : direction_of(render::View::Front);
}

// Width factor of lines that are drawn as tubes: scales with pictures larger than 1024 px; 1 for smaller ones.
float line_scale(const PictureOptions& options) {
    return std::max(1.0F, float(std::min(options.width_px, options.height_px)) / 1024);
}

render::Scene bare_scene(const RenderSubject& subject, const PictureOptions& options) {
    render::Scene scene;
    if (options.show == render::ShowMode::Hierarchy) return scene;
    scene.cloths.push_back(make_cloth_item(subject.garment, options));
    if (subject.body != nullptr) scene.bodies.push_back(render::make_body_item(*subject.body));
    return scene;
}

render::SubjectFrame make_frame(const render::Scene& scene, const PictureOptions& options, const Vec3f& axis,
                                const std::vector<float>& turns) {
    const bool frames_garment = options.framing == Framing::Garment || scene.bodies.empty();
    render::SubjectFrame frame{
        .points = frames_garment ? scene.cloths.front().mesh.x : scene_points(scene),
        .direction = direction_wanted(options),
        .options = {.aspect = size_of(options).aspect(),
                    .margin = frames_garment ? render::kGarmentMargin : render::FrameOptions{}.margin},
        .holds_bodies = !frames_garment};
    if (options.camera) frame.zoom = options.camera->zoom;
    const bool is_placed = options.camera && options.camera->eye_and_target;
    const bool is_cut_off = frame.zoom > 1 || (options.view && is_detail(*options.view));
    frame.may_move = !is_placed && !is_cut_off;
    if (options.view && is_detail(*options.view)) {
        frame.points = detail_patch(scene.cloths.front().mesh.x, *options.view);
        frame.options.margin = 0;
    }
    frame.points = render::at_all_turns(frame.points, axis, turns);
    return frame;
}

// Divides the cloth into parts that look alike.
void divide(render::Scene& scene, const PictureOptions& options) {
    if (!options.pattern || options.show == render::ShowMode::Hierarchy) return;
    scene.cloths = options.looks->parts(std::move(scene.cloths.front()), *options.pattern);
}

// Strain and hierarchy modes show the simulated triangles. A rotating subject has no back faces to coarsen, because it
// is seen from all sides.
void curve(render::Scene& scene, const RenderSubject& subject, const PictureOptions& options,
           const std::vector<float>& turns) {
    if (wants_material(options.show) || options.show == render::ShowMode::Hierarchy) return;
    std::optional<sim::ViewPoint> view;
    if (turns.size() == 1) view = sim::ViewPoint{.eye = scene.camera.eye};
    sim::DrawMesh& mesh = scene.cloths.front().mesh;
    mesh = drawn_mesh(mesh, subject.body, options.surface, view);
}

// Pre: the scene has its camera, which tells how wide lines are.
std::optional<render::Legend> fill(render::Scene& scene, const RenderSubject& subject, const PictureOptions& options) {
    const float line_px = 2.4F * line_scale(options);
    render::ShowInput facts{.clearance = {}, .line_radius = line_px * pixel_size(scene.camera, options.height_px)};
    if (options.show == render::ShowMode::Clearance)
        facts.clearance = measure_clearance(scene.cloths.front().mesh.x, *subject.body);
    std::optional<render::Legend> legend = fill_show(scene, facts);
    if (legend) legend->font = options.legend_font;
    return legend;
}

// Places the stack of levels to the right of the flat panels or behind them, whichever shows both larger.
render::Legend fill_model(render::Scene& scene, const RenderSubject& subject, const PictureOptions& options,
                          const std::vector<float>& turns) {
    const float line_px = 0.55F * line_scale(options);
    render::Legend legend;
    float least = std::numeric_limits<float>::infinity();
    for (const render::StackSide side : {render::StackSide::Right, render::StackSide::Behind}) {
        render::Scene candidate;
        fill_hierarchy(candidate, *subject.hierarchy, side);
        const Vec3f axis = render::upright_through(scene_points(candidate));
        const float pixel = pixel_size(make_frame(candidate, options, axis, turns).camera(), options.height_px);
        if (pixel >= least) continue;
        least = pixel;
        legend = fill_hierarchy(scene, *subject.hierarchy, side, {.clearance = {}, .line_radius = line_px * pixel});
    }
    legend.font = options.legend_font;
    return legend;
}

void set_ground(render::Scene& scene) {
    // A garment alone, high above the floor, is drawn without a floor.
    const float low = lowest(scene_points(scene));
    scene.ground_y = std::min(0.0F, low);
    // No floor is drawn if the camera is below it.
    scene.has_ground = low < 0.3F && scene.camera.eye.y() > scene.ground_y;
    // Lowers the floor slightly, so that the flat mesh does not coincide with it.
    if (scene.cloths.front().show == render::ShowMode::Hierarchy) scene.ground_y -= 0.01F;
}

void set_light(render::Scene& scene, const PictureOptions& options) {
    scene.light = is_painted(options.show) ? even_light(scene.camera) : studio_light(scene.camera);
}

}  // namespace

Vec3f seen_from(const PictureOptions& options) {
    if (options.camera && options.camera->eye_and_target) {
        const auto& [eye, target] = *options.camera->eye_and_target;
        return (eye - target).stableNormalized();
    }
    return unit_vector(direction_wanted(options));
}

render::RenderOptions render_options(const PictureOptions& options) {
    return {.width_px = options.width_px,
            .height_px = options.height_px,
            .samples = options.samples,
            .supersample = options.supersample};
}

Layout compose(const RenderSubject& subject, const PictureOptions& options, const std::vector<float>& turns,
               const std::vector<Vec3f>& also_framed) {
    check_can_show(options.show, subject.body != nullptr, subject.hierarchy != nullptr);
    Layout layout;
    render::Scene& scene = layout.scene;
    scene = bare_scene(subject, options);
    if (options.show == render::ShowMode::Hierarchy) layout.legend = fill_model(scene, subject, options, turns);
    layout.axis = render::upright_through(scene_points(scene));

    render::SubjectFrame frame = make_frame(scene, options, layout.axis, turns);
    if (frame.may_move || !options.view || !is_detail(*options.view))
        frame.points.insert(frame.points.end(), also_framed.begin(), also_framed.end());
    scene.camera = frame.camera();
    if (options.camera && options.camera->eye_and_target) {
        const auto& [eye, target] = *options.camera->eye_and_target;
        scene.camera = render::camera_at(eye, target, render::at_all_turns(scene_points(scene), layout.axis, turns));
    }
    curve(scene, subject, options, turns);
    divide(scene, options);
    if (options.show != render::ShowMode::Hierarchy) layout.legend = fill(scene, subject, options);
    if (layout.legend) {
        const render::LegendPlace place = find_legend_place(
            *layout.legend, {.scene = scene, .frame = frame, .axis = layout.axis, .turns = turns}, size_of(options));
        scene.camera = place.camera;
        layout.corner = place.corner;
    }
    set_light(scene, options);
    scene.background.is_transparent = options.is_transparent;
    set_ground(scene);
    return layout;
}

Layout moved(const Layout& first, const RenderSubject& subject, const PictureOptions& options, const Vec3f& by) {
    Layout layout;
    layout.corner = first.corner;
    layout.axis = first.axis + by;
    render::Scene& scene = layout.scene;
    scene = bare_scene(subject, options);
    scene.camera = first.scene.camera;
    scene.camera.eye += by;
    scene.camera.target += by;
    curve(scene, subject, options, {0});
    divide(scene, options);
    layout.legend = fill(scene, subject, options);
    set_light(scene, options);
    scene.background = first.scene.background;
    scene.has_ground = first.scene.has_ground;
    scene.ground_y = first.scene.ground_y;
    return layout;
}

render::Scene turned(const Layout& layout, const PictureOptions& options, float angle) {
    render::Scene scene = layout.scene;
    scene.camera = turned(scene.camera, angle, layout.axis);
    set_light(scene, options);
    return scene;
}

}  // namespace selvedge::app
