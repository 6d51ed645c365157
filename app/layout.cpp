#include "app/layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "render/draw/renderer.h"
#include "render/marks/show.h"
#include "render/scene/camera.h"
#include "sim/core/error.h"
#include "sim/place/fit.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::app {
namespace {

bool is_finite(const sim::PlainMesh& mesh, std::size_t triangle) {
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

// A garment with non-finite positions can still be drawn. Non-finite vertices without a triangle move to a finite one.
sim::PlainMesh without_bad_numbers(sim::PlainMesh mesh) {
    std::vector<std::size_t> kept;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (is_finite(mesh, t)) kept.push_back(t);
    }
    if (kept.empty()) throw sim::InputError("", "picture", "the garment has no triangle that can be drawn");
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

render::ClothItem make_cloth_item(const sim::PlainMesh& garment, const PictureOptions& options) {
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

// A point on the vertical line through the centre of the points' bounding box.
Vec3f upright_through(const std::vector<Vec3f>& points) {
    Vec3f low = points.front(), high = points.front();
    for (const Vec3f& x : points) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    const Vec3f middle = (low + high) / 2;
    return {middle.x(), 0, middle.z()};
}

std::vector<Vec3f> at_all_turns(const std::vector<Vec3f>& points, const Vec3f& axis, const std::vector<float>& turns) {
    std::vector<Vec3f> swept;
    swept.reserve(points.size() * turns.size());
    for (const float angle : turns) {
        const float c = std::cos(angle), s = std::sin(angle);
        for (const Vec3f& point : points) {
            const Vec3f v = point - axis;
            swept.push_back(axis + Vec3f(c * v.x() + s * v.z(), v.y(), -s * v.x() + c * v.z()));
        }
    }
    return swept;
}

float aspect_of(const PictureOptions& options) {
    return float(options.width_px) / float(options.height_px);
}

render::Direction direction_wanted(const PictureOptions& options) {
    constexpr render::Direction from_above{.azimuth = 0.30F, .elevation = 0.62F};
    if (options.camera) return options.camera->direction;
    if (options.view) return direction_of(*options.view);
    return options.show == render::ShowMode::Hierarchy ? from_above : direction_of(render::View::Front);
}

// A camera with these eye and target points; near and far plane enclose all points.
render::Camera camera_at(const std::array<Vec3f, 2>& eye_and_target, const std::vector<Vec3f>& points) {
    render::Camera camera{.eye = eye_and_target[0], .target = eye_and_target[1]};
    const Vec3f back = (camera.eye - camera.target).normalized();
    if (std::abs(back.y()) > 0.999F) camera.up = -Vec3f::UnitZ();
    float nearest = std::numeric_limits<float>::infinity(), farthest = 0;
    for (const Vec3f& point : points) {
        const float depth = (camera.eye - point).dot(back);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    camera.near_plane = std::max(0.2F * nearest, 0.01F);
    camera.far_plane = 4 * farthest + 20;
    return camera;
}

// Width factor of lines that are drawn as tubes: scales with pictures larger than 1024 px; 1 for smaller ones.
float line_scale(const PictureOptions& options) {
    return std::max(1.0F, float(std::min(options.width_px, options.height_px)) / 1024);
}

// Size of one pixel in m, at the depth of the camera's target.
float pixel_size(const render::Camera& camera, const PictureOptions& options) {
    return 2 * (camera.eye - camera.target).norm() * std::tan(camera.fov_y / 2) / float(options.height_px);
}

// Screen bounding boxes of the scene's triangles, at every turn.
class Silhouette {
 public:
    Silhouette(const render::Scene& scene, const PictureOptions& options, const Vec3f& axis,
               const std::vector<float>& turns)
        : scene_(scene), options_(options), axis_(axis), turns_(turns) {}

    // Numbers of triangle boxes that overlap the legend's box.
    struct Cover {
        long cloth = 0;
        long body = 0;
    };
    Cover under(const render::PixelBox& legend, const render::Camera& camera) const {
        Cover cover;
        for (const float angle : turns_) {
            const Eigen::Matrix4f matrix =
                projection_matrix(camera, aspect_of(options_)) * view_matrix(turned(camera, angle, axis_));
            for (const render::ClothItem& cloth : scene_.cloths)
                cover.cloth += count_over(matrix, cloth.mesh.x, cloth.mesh.triangles, legend);
            for (const render::BodyItem& body : scene_.bodies)
                cover.body += count_over(matrix, body.x, body.triangles, legend);
        }
        return cover;
    }

 private:
    long count_over(const Eigen::Matrix4f& matrix, const std::vector<Vec3f>& x,
                    const std::vector<std::array<std::uint32_t, 3>>& triangles, const render::PixelBox& legend) const {
        std::vector<Vec2f> at;
        at.reserve(x.size());
        for (const Vec3f& point : x) at.push_back(on_picture(matrix, point));
        const Vec2f low(float(legend.left), float(legend.top));
        const Vec2f high(float(legend.left + legend.width), float(legend.top + legend.height));
        return std::count_if(triangles.begin(), triangles.end(), [&](const auto& t) {
            const Vec2f least = at[t[0]].cwiseMin(at[t[1]]).cwiseMin(at[t[2]]);
            const Vec2f most = at[t[0]].cwiseMax(at[t[1]]).cwiseMax(at[t[2]]);
            return (least.array() < high.array()).all() && (most.array() > low.array()).all();
        });
    }

    // px from the upper left; far outside the picture for points behind the eye.
    Vec2f on_picture(const Eigen::Matrix4f& matrix, const Vec3f& point) const {
        const Eigen::Vector4f clip = matrix * point.homogeneous();
        if (clip.w() <= 0) return {-1e6F, -1e6F};
        return {(0.5F + 0.5F * clip.x() / clip.w()) * float(options_.width_px),
                (0.5F - 0.5F * clip.y() / clip.w()) * float(options_.height_px)};
    }

    const render::Scene& scene_;
    const PictureOptions& options_;
    const Vec3f& axis_;
    const std::vector<float>& turns_;
};

// The points to frame and the framing options.
struct Frame {
    std::vector<Vec3f> points;
    render::Direction direction;
    render::FrameOptions options;
    float zoom = 1;
    bool holds_bodies = false;
    bool is_detail = false;  // the subject is cut off anyway, so the camera is not moved for the legend

    render::Camera camera() const { return zoomed(frame_points(points, direction, options), zoom); }
};

// A camera and the legend's corner.
struct CameraCandidate {
    render::Camera camera;
    render::Corner corner = render::Corner::LowerLeft;
    long hidden = std::numeric_limits<long>::max();  // triangles under the legend that belong to the framed subject
    float pixel_size = 0;                            // m
    long beside = 0;                                 // other triangles under the legend

    auto cost() const { return std::tuple(hidden, pixel_size, beside); }
};

// Frames with a free strip for the legend at the left or at the bottom, and frames with a wider margin.
std::vector<Frame> with_room(const Frame& frame, const render::LegendLayout& legend, const PictureOptions& options) {
    const float edge = 8.0F * float(legend.scale);
    const float right = float(legend.box.left + legend.box.width) + edge;
    const float top = float(options.height_px - legend.box.top) + edge;
    const float margin = frame.options.margin / 2;  // already free on each side
    std::vector<Frame> frames{frame, frame};
    frames[0].options.free_left = std::max(right / float(options.width_px) - margin, 0.0F);
    frames[1].options.free_below = std::max(top / float(options.height_px) - margin, 0.0F);
    for (const float more : {0.08F, 0.16F, 0.24F, 0.32F}) {
        frames.push_back(frame);
        frames.back().options.margin += more;
    }
    return frames;
}

// Enlarged, because marks extend beyond the cloth.
render::PixelBox with_edge(const render::LegendLayout& place) {
    const int edge = 6 * place.scale;
    return {place.box.left - edge, place.box.top - edge, place.box.width + 2 * edge, place.box.height + 2 * edge};
}

// Chooses a legend corner without overlap. If there is none and the camera may move, makes room for the legend while
// keeping the subject as large as possible. Otherwise chooses the corner that hides least.
CameraCandidate clear_of_legend(const render::Camera& camera, bool may_move, const Frame& frame,
                                const render::Legend& legend, const Silhouette& figure, const PictureOptions& options) {
    CameraCandidate best{.camera = camera};
    const auto try_corners = [&](const render::Camera& tried) {
        for (const render::Corner corner : {render::Corner::LowerLeft, render::Corner::LowerRight,
                                            render::Corner::UpperLeft, render::Corner::UpperRight}) {
            const auto place = place_legend(legend, options.width_px, options.height_px, corner);
            if (!place) return;
            const auto [cloth, body] = figure.under(with_edge(*place), tried);
            const CameraCandidate shot{.camera = tried,
                                       .corner = corner,
                                       .hidden = cloth + (frame.holds_bodies ? body : 0),
                                       .pixel_size = pixel_size(tried, options),
                                       .beside = frame.holds_bodies ? 0 : body};
            if (shot.cost() < best.cost()) best = shot;
        }
    };
    try_corners(camera);
    const auto place = place_legend(legend, options.width_px, options.height_px, render::Corner::LowerLeft);
    if (best.hidden == 0 || !place || !may_move) return best;
    for (const Frame& roomy : with_room(frame, *place, options)) try_corners(roomy.camera());
    return best;
}

render::Scene bare_scene(const RenderSubject& subject, const PictureOptions& options) {
    render::Scene scene;
    if (options.show == render::ShowMode::Hierarchy) return scene;
    scene.cloths.push_back(make_cloth_item(subject.garment, options));
    if (subject.body != nullptr) scene.bodies.push_back(render::make_body_item(*subject.body));
    return scene;
}

Frame make_frame(const render::Scene& scene, const PictureOptions& options, const Vec3f& axis,
                 const std::vector<float>& turns) {
    const bool frames_garment = options.framing == Framing::Garment || scene.bodies.empty();
    Frame frame{.points = frames_garment ? scene.cloths.front().mesh.x : scene_points(scene),
                .direction = direction_wanted(options),
                .options = {.aspect = aspect_of(options), .margin = frames_garment ? 0.12F : 0.07F},
                .holds_bodies = !frames_garment};
    if (options.camera) frame.zoom = options.camera->zoom;
    frame.is_detail = frame.zoom > 1 || (options.view && is_detail(*options.view));
    if (options.view && is_detail(*options.view)) {
        frame.points = detail_patch(scene.cloths.front().mesh.x, *options.view);
        frame.options.margin = 0;
    }
    frame.points = at_all_turns(frame.points, axis, turns);
    return frame;
}

// Strain and hierarchy modes show the simulated triangles. A rotating subject has no back faces to coarsen, because it
// is seen from all sides.
void curve(render::Scene& scene, const RenderSubject& subject, const PictureOptions& options,
           const std::vector<float>& turns) {
    if (wants_material(options.show) || options.show == render::ShowMode::Hierarchy) return;
    std::optional<sim::ViewPoint> view;
    if (turns.size() == 1) view = sim::ViewPoint{.eye = scene.camera.eye};
    sim::PlainMesh& mesh = scene.cloths.front().mesh;
    mesh = drawn_mesh(mesh, subject.body, options.surface, view);
}

std::optional<render::Legend> fill(render::Scene& scene, const RenderSubject& subject, const PictureOptions& options,
                                   float line_radius) {
    render::ShowInput facts{.clearance = {}, .line_radius = line_radius};
    if (options.show == render::ShowMode::Clearance)
        facts.clearance = measure_clearance(scene.cloths.front().mesh.x, *subject.body);
    return fill_show(scene, facts);
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
        const Vec3f axis = upright_through(scene_points(candidate));
        const float pixel = pixel_size(make_frame(candidate, options, axis, turns).camera(), options);
        if (pixel >= least) continue;
        least = pixel;
        legend = fill_hierarchy(scene, *subject.hierarchy, side, {.clearance = {}, .line_radius = line_px * pixel});
    }
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

render::RenderOptions render_options(const PictureOptions& options) {
    return {.width_px = options.width_px,
            .height_px = options.height_px,
            .samples = options.samples,
            .supersample = options.supersample};
}

Layout compose(const RenderSubject& subject, const PictureOptions& options, const std::vector<float>& turns) {
    check_can_show(options.show, subject.body != nullptr, subject.hierarchy != nullptr);
    const float line_px = 2.4F * line_scale(options);
    Layout layout;
    render::Scene& scene = layout.scene;
    scene = bare_scene(subject, options);
    if (options.show == render::ShowMode::Hierarchy) layout.legend = fill_model(scene, subject, options, turns);
    layout.axis = upright_through(scene_points(scene));

    const Frame frame = make_frame(scene, options, layout.axis, turns);
    const bool is_placed = options.camera && options.camera->eye_and_target;
    scene.camera =
        is_placed ? camera_at(*options.camera->eye_and_target, at_all_turns(scene_points(scene), layout.axis, turns))
                  : frame.camera();
    curve(scene, subject, options, turns);
    if (options.show != render::ShowMode::Hierarchy)
        layout.legend = fill(scene, subject, options, line_px * pixel_size(scene.camera, options));
    if (layout.legend) {
        const Silhouette figure(scene, options, layout.axis, turns);
        const CameraCandidate shot =
            clear_of_legend(scene.camera, !is_placed && !frame.is_detail, frame, *layout.legend, figure, options);
        scene.camera = shot.camera;
        layout.corner = shot.corner;
    }
    set_light(scene, options);
    scene.background.is_transparent = options.is_transparent;
    set_ground(scene);
    return layout;
}

render::Scene turned(const Layout& layout, const PictureOptions& options, float angle) {
    render::Scene scene = layout.scene;
    scene.camera = turned(scene.camera, angle, layout.axis);
    set_light(scene, options);
    return scene;
}

}  // namespace selvedge::app
