#include "app/filming.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "render/marks/legend.h"
#include "sim/cloth/cloth.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::app {
namespace {

// Where some of the garment hangs: it goes with a vertex of its body.
struct Hanging {
    std::size_t vertex;  // of the body
    float aside;         // m, over the floor
    float up;            // m

    // Around that vertex at x, because the body may turn.
    void add_points(const Vec3f& x, std::vector<Vec3f>& points) const {
        for (const float way : {-aside, aside}) {
            points.emplace_back(x + Vec3f(way, up, 0));
            points.emplace_back(x + Vec3f(0, up, way));
        }
    }
};

std::size_t nearest(std::span<const Vec3f> body, const Vec3f& place) {
    const auto found = std::ranges::min_element(body, {}, [&](const Vec3f& x) { return (x - place).squaredNorm(); });
    return static_cast<std::size_t>(found - body.begin());
}

// For each vertex of a garment the highest of its panel.
std::vector<std::size_t> tops_of_panels(const sim::DrawMesh& garment) {
    std::vector<std::size_t> tops(garment.panel_names.size(), garment.x.size()), of_vertex(garment.x.size(), 0);
    for (std::size_t t = 0; t < garment.triangles.size(); ++t)
        for (const std::size_t v : garment.triangles[t]) {
            std::size_t& top = tops[panel_of(garment, t)];
            if (top == garment.x.size() || garment.x[v].y() > garment.x[top].y()) top = v;
        }
    for (std::size_t t = 0; t < garment.triangles.size(); ++t)
        for (const std::size_t v : garment.triangles[t]) of_vertex[v] = tops[panel_of(garment, t)];
    return of_vertex;
}

// Cloth goes with what it lies on; where that moves away from under it, as thighs do from a skirt, it hangs down from
// the top of its panel.
std::vector<Hanging> find_hanging(const sim::DrawMesh& garment, std::span<const Vec3f> body) {
    constexpr std::size_t kEvery = 8;  // the frame is as large with an eighth of the vertices
    const std::vector<std::size_t> tops = tops_of_panels(garment);
    std::vector<Hanging> hanging;
    for (std::size_t v = 0; v < garment.x.size(); v += kEvery) {
        const std::size_t on = nearest(body, garment.x[v]);
        const Vec3f away = garment.x[v] - body[on];
        hanging.push_back({on, std::hypot(away.x(), away.z()), away.y()});
        const std::size_t holder = nearest(body, garment.x[tops[v]]);
        hanging.push_back({holder, 0, garment.x[v].y() - body[holder].y()});
    }
    return hanging;
}

}  // namespace

Filming::Filming(const Options& options, const PictureOptions& picture, const sim::Animation& animation)
    : picture_(picture), writer_(options.file, options.format) {
    if (!options.camera_stays) path_.emplace(animation);
    const sim::DrawMesh mesh = draw_mesh(animation.cloth(), animation.panel_names());
    layout_ = compose({.garment = mesh, .body = &animation.body()}, picture, {0}, framed(animation, mesh));
}

void Filming::add(const sim::Animation& animation) {
    const sim::DrawMesh mesh = draw_mesh(animation.cloth(), animation.panel_names());
    const render::Layout now =
        moved(layout_, {.garment = mesh, .body = &animation.body()}, picture_, camera_way(animation.seconds()));
    render::Image image = renderer_.draw(now.scene, render_options(picture_));
    if (now.legend) draw_legend(image, *now.legend, now.corner);
    writer_.add(image);
}

// By which the camera is moved then, m.
Vec3f Filming::camera_way(double seconds) const {
    return path_ ? Vec3f(path_->at(seconds) - path_->at(0)) : Vec3f(Vec3f::Zero());
}

// Where what fills the picture will be, as seen by the camera.
std::vector<Vec3f> Filming::framed(const sim::Animation& animation, const sim::DrawMesh& garment) const {
    constexpr int kMoments = 96;
    constexpr std::size_t kEvery = 16;  // vertices of a body
    std::vector<Hanging> hanging = find_hanging(garment, animation.body_points());
    if (picture_.framing != render::Framing::Garment)
        for (std::size_t v = 0; v < animation.body_points().size(); v += kEvery) hanging.push_back({v, 0, 0});
    const sim::BodyTimeline& timeline = animation.timeline();
    const sim::SkinnedSurface surface(animation.body());
    std::vector<Vec3f> points, x;
    for (int i = 0; i < kMoments; ++i) {
        const double seconds = timeline.seconds() * i / (kMoments - 1);
        surface.positions(animation.body(), timeline.pose(seconds), x);
        const Vec3f way = camera_way(seconds);
        for (const Hanging& hung : hanging) hung.add_points(x[hung.vertex] - way, points);
    }
    return points;
}

}  // namespace selvedge::app
