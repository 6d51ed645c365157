#include "render/output/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "render/draw/renderer.h"
#include "render/gl/context.h"
#include "render/image/image.h"
#include "render/marks/legend.h"
#include "render/marks/show.h"
#include "render/scene/camera.h"
#include "sim/core/error.h"
#include "sim/place/fit.h"
#include "sim/tartan/named_tartan.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::render {

bool is_sample_count(int samples) {
    constexpr std::array<int, 4> counts{1, 2, 4, 8};
    return std::ranges::find(counts, samples) != counts.end();
}

void check_size(const PictureSize& size) {
    const auto [width, height] = size;
    const bool is_drawable = width >= 1 && height >= 1 && width <= kMaxImageSide && height <= kMaxImageSide &&
                             static_cast<long>(width) * height <= kMaxImagePixels;
    if (is_drawable) return;
    throw sim::InputError("", "--size",
                          "'" + std::to_string(width) + "x" + std::to_string(height) + "': sides are from 1 to " +
                              std::to_string(kMaxImageSide) + ", with at most " +
                              std::to_string(kMaxImagePixels / 1000000) + " million pixels");
}

Framing parse_framing(const std::string& text) {
    if (text == "all") return Framing::All;
    if (text == "garment") return Framing::Garment;
    throw sim::InputError("", "--frame", "'" + text + "' is none of all, garment");
}

sim::SurfaceDesign parse_design(const std::string& text) {
    if (text == "test") return {.kind = sim::DesignKind::Test};
    if (sim::is_colour_text(text)) return {.kind = sim::DesignKind::Colour, .source = text};
    if (text.starts_with('#')) throw sim::InputError("", "--design", "'" + text + "' is no colour: #RRGGBB is");
    return {.kind = sim::DesignKind::Picture, .source = text};
}

namespace {

// The pattern as the options change its looks: one fabric or one tartan for all panels, or another size and place of
// its tartan.
sim::Pattern shown_pattern(sim::Pattern pattern, const std::string& fabric, const PictureOptions& picture) {
    if (!fabric.empty()) {
        pattern.fabric = fabric;
        for (sim::Panel& panel : pattern.panels) panel.fabric.clear();
    }
    if (picture.design) {
        pattern.surface = picture.design;
        for (sim::Panel& panel : pattern.panels) panel.surface = pattern.surface;
    }
    const auto place = [&](std::optional<sim::SurfaceDesign>& surface) {
        if (!surface) return;
        if (picture.sett_size) surface->size = picture.sett_size;
        if (picture.sett_position) surface->position = *picture.sett_position;
    };
    place(pattern.surface);
    for (sim::Panel& panel : pattern.panels) place(panel.surface);
    if (picture.sett_size) pattern.sett_size = picture.sett_size;
    if (picture.sett_position) pattern.sett_position = *picture.sett_position;
    return pattern;
}

}  // namespace

void name_looks(PictureOptions& picture, const sim::Pattern& pattern, const std::string& fabric) {
    picture.pattern = std::make_shared<const sim::Pattern>(shown_pattern(pattern, fabric, picture));
}

void read_looks(PictureOptions& picture, const sim::Pattern& pattern, const std::string& fabric,
                const std::string& file) {
    if (!picture.sett && !picture.sett_size) picture.sett_size = pattern.sett_size;
    if (!picture.sett && !pattern.tartan.empty())
        picture.sett = sim::named_tartan(pattern.tartan, file, "selvedge.tartan");
    picture.looks = std::make_shared<ClothLooks>(ClothLooks::Unknown::Fail);
    picture.looks->read(*picture.pattern);
    if (!picture.sett_position) picture.sett_position = pattern.sett_position;
    picture.material = material_of(sim::find_fabric(fabric.empty() ? pattern.fabric : fabric));
}

void show_design(PictureOptions& picture, const std::string& fabric) {
    if (!picture.design) return;
    sim::SurfaceDesign design = *picture.design;
    design.size = picture.sett_size;
    design.position = picture.sett_position.value_or(Vec2d::Zero());
    picture.looks = std::make_shared<ClothLooks>(ClothLooks::Unknown::Fail);
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
    const auto context = make_context();
    const int most = context->max_samples();
    if (options.samples <= most) return;
    throw sim::InputError("", "--samples",
                          std::string(name(context->maker())) + " takes at most " + std::to_string(most) +
                              " per pixel here, not " + std::to_string(options.samples) +
                              ": --supersample smooths edges as well");
}

void check_can_show(ShowMode show, bool has_body, bool has_hierarchy) {
    if (show == ShowMode::Clearance && !has_body)
        throw sim::InputError("", "--show", "'clearance' is measured from a body: name one with --body");
    if (show == ShowMode::Hierarchy && !has_hierarchy) {
        throw sim::InputError("", "--show",
                              "'hierarchy' shows refined triangles, and a mesh file holds only the last ones: "
                              "use selvedge dress --show hierarchy");
    }
}

Image draw_picture(const RenderSubject& subject, const PictureOptions& options) {
    static std::mutex drawing;
    const Layout layout = compose(subject, options);
    const std::scoped_lock lock(drawing);
    Image image = Renderer().draw(layout.scene, render_options(options));
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

ClothItem make_cloth_item(const sim::DrawMesh& garment, const PictureOptions& options) {
    ClothItem item;
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

PictureSize size_of(const PictureOptions& options) {
    return {.width_px = options.width_px, .height_px = options.height_px};
}

Direction direction_wanted(const PictureOptions& options) {
    constexpr Direction from_above{.azimuth = 0.30F, .elevation = 0.62F};
    if (options.camera) return options.camera->direction;
    if (options.view) return direction_of(*options.view);
    return options.show == ShowMode::Hierarchy ? from_above : direction_of(View::Front);
}

// Width factor of lines that are drawn as tubes: scales with pictures larger than 1024 px; 1 for smaller ones.
float line_scale(const PictureOptions& options) {
    return std::max(1.0F, float(std::min(options.width_px, options.height_px)) / 1024);
}

Scene bare_scene(const RenderSubject& subject, const PictureOptions& options) {
    Scene scene;
    if (options.show == ShowMode::Hierarchy) return scene;
    scene.cloths.push_back(make_cloth_item(subject.garment, options));
    if (subject.body != nullptr) scene.bodies.push_back(make_body_item(*subject.body));
    return scene;
}

SubjectFrame make_frame(const Scene& scene, const PictureOptions& options, const Vec3f& axis,
                        const std::vector<float>& turns) {
    const bool frames_garment = options.framing == Framing::Garment || scene.bodies.empty();
    SubjectFrame frame{.points = frames_garment ? scene.cloths.front().mesh.x : scene_points(scene),
                       .direction = direction_wanted(options),
                       .options = {.aspect = size_of(options).aspect(),
                                   .margin = frames_garment ? kGarmentMargin : FrameOptions{}.margin},
                       .holds_bodies = !frames_garment};
    if (options.camera) frame.zoom = options.camera->zoom;
    const bool is_placed = options.camera && options.camera->eye_and_target;
    const bool is_cut_off = frame.zoom > 1 || (options.view && is_detail(*options.view));
    frame.may_move = !is_placed && !is_cut_off;
    if (options.view && is_detail(*options.view)) {
        frame.points = detail_patch(scene.cloths.front().mesh.x, *options.view);
        frame.options.margin = 0;
    }
    frame.points = at_all_turns(frame.points, axis, turns);
    return frame;
}

// Divides the cloth into parts that look alike.
void divide(Scene& scene, const PictureOptions& options) {
    if (!options.pattern || options.show == ShowMode::Hierarchy) return;
    scene.cloths = options.looks->parts(std::move(scene.cloths.front()), *options.pattern);
}

// Strain and hierarchy modes show the simulated triangles. A rotating subject has no back faces to coarsen, because it
// is seen from all sides.
void curve(Scene& scene, const RenderSubject& subject, const PictureOptions& options, const std::vector<float>& turns) {
    if (wants_material(options.show) || options.show == ShowMode::Hierarchy) return;
    std::optional<sim::ViewPoint> view;
    if (turns.size() == 1) view = sim::ViewPoint{.eye = scene.camera.eye};
    sim::DrawMesh& mesh = scene.cloths.front().mesh;
    mesh = drawn_mesh(mesh, subject.body, options.surface, view);
}

// Pre: the scene has its camera, which tells how wide lines are.
std::optional<Legend> fill(Scene& scene, const RenderSubject& subject, const PictureOptions& options) {
    const float line_px = 2.4F * line_scale(options);
    ShowInput facts{.clearance = {}, .line_radius = line_px * pixel_size(scene.camera, options.height_px)};
    if (options.show == ShowMode::Clearance)
        facts.clearance = measure_clearance(scene.cloths.front().mesh.x, *subject.body);
    std::optional<Legend> legend = fill_show(scene, facts);
    if (legend) legend->font = options.legend_font;
    return legend;
}

// Places the stack of levels to the right of the flat panels or behind them, whichever shows both larger.
Legend fill_model(Scene& scene, const RenderSubject& subject, const PictureOptions& options,
                  const std::vector<float>& turns) {
    const float line_px = 0.55F * line_scale(options);
    Legend legend;
    float least = std::numeric_limits<float>::infinity();
    for (const StackSide side : {StackSide::Right, StackSide::Behind}) {
        Scene candidate;
        fill_hierarchy(candidate, *subject.hierarchy, side);
        const Vec3f axis = upright_through(scene_points(candidate));
        const float pixel = pixel_size(make_frame(candidate, options, axis, turns).camera(), options.height_px);
        if (pixel >= least) continue;
        least = pixel;
        legend = fill_hierarchy(scene, *subject.hierarchy, side, {.clearance = {}, .line_radius = line_px * pixel});
    }
    legend.font = options.legend_font;
    return legend;
}

void set_ground(Scene& scene) {
    // A garment alone, high above the floor, is drawn without a floor.
    const float low = lowest(scene_points(scene));
    scene.ground_y = std::min(0.0F, low);
    // No floor is drawn if the camera is below it.
    scene.has_ground = low < 0.3F && scene.camera.eye.y() > scene.ground_y;
    // Lowers the floor slightly, so that the flat mesh does not coincide with it.
    if (scene.cloths.front().show == ShowMode::Hierarchy) scene.ground_y -= 0.01F;
}

void set_light(Scene& scene, const PictureOptions& options) {
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

RenderOptions render_options(const PictureOptions& options) {
    return {.width_px = options.width_px,
            .height_px = options.height_px,
            .samples = options.samples,
            .supersample = options.supersample};
}

Layout compose(const RenderSubject& subject, const PictureOptions& options, const std::vector<float>& turns,
               const std::vector<Vec3f>& also_framed) {
    check_can_show(options.show, subject.body != nullptr, subject.hierarchy != nullptr);
    Layout layout;
    Scene& scene = layout.scene;
    scene = bare_scene(subject, options);
    if (options.show == ShowMode::Hierarchy) layout.legend = fill_model(scene, subject, options, turns);
    layout.axis = upright_through(scene_points(scene));

    SubjectFrame frame = make_frame(scene, options, layout.axis, turns);
    if (frame.may_move || !options.view || !is_detail(*options.view))
        frame.points.insert(frame.points.end(), also_framed.begin(), also_framed.end());
    scene.camera = frame.camera();
    if (options.camera && options.camera->eye_and_target) {
        const auto& [eye, target] = *options.camera->eye_and_target;
        scene.camera = camera_at(eye, target, at_all_turns(scene_points(scene), layout.axis, turns));
    }
    curve(scene, subject, options, turns);
    divide(scene, options);
    if (options.show != ShowMode::Hierarchy) layout.legend = fill(scene, subject, options);
    if (layout.legend) {
        const LegendPlace place = find_legend_place(
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
    Scene& scene = layout.scene;
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

Scene turned(const Layout& layout, const PictureOptions& options, float angle) {
    Scene scene = layout.scene;
    scene.camera = turned(scene.camera, angle, layout.axis);
    set_light(scene, options);
    return scene;
}

}  // namespace selvedge::render
