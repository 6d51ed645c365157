// Figures 3.16-3.18: an adaptive cloth that was dropped on a sphere. Figure 3.19: a test pattern by position and size.
// Figure 3.20: a hanging cloth in three tartans.
#include <array>
#include <optional>
#include <utility>

#include "bench/support/measured_mesh.h"
#include "bench/thesis/labels.h"
#include "bench/thesis/surface_tables.h"
#include "bench/thesis/thesis.h"
#include "bench/thesis/thesis_drop.h"
#include "render/marks/show.h"
#include "render/scene/solids.h"
#include "sim/cloth/cloth.h"
#include "sim/mesh/square.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::bench {
namespace {

int side_px(const ThesisOptions& options) {
    return options.is_quick ? 96 : 640;
}

sim::Cloth cloth_on_sphere(const ThesisOptions& options) {
    std::optional<sim::Cloth> last;
    run_thesis_drop({.object = ThesisDropObject::Sphere,
                     .criteria = {.collision = true, .curvature = true, .length = false},
                     .seconds = options.is_quick ? 0.3 : 2.0,
                     .watch = [&](const sim::Cloth& cloth, double) { last = cloth; }});
    return std::move(*last);
}

// The leaf edges as rods in the colours of their levels.
render::SolidItem coloured_edges(const sim::Cloth& cloth) {
    constexpr float kRadius = 0.0016F;  // m
    render::SolidItem solid;
    for (const sim::LeafEdge& e : cloth.mesh.leaf_edges()) {
        const auto end = [&](sim::VertexId v) {
            return Vec3f(cloth.x[v.value].head<3>() + kRadius * cloth.normals[v.value]);
        };
        add_rod(solid, end(e.a), end(e.b), kRadius, render::level_colour(cloth.mesh.level(e.edge)));
    }
    return solid;
}

class SpherePictures {
 public:
    explicit SpherePictures(const ThesisOptions& options)
        : cloth_(cloth_on_sphere(options)), mesh_(draw_mesh(cloth_, {"cloth"})), side_px_(side_px(options)) {}

    Capture levels() {
        render::Scene with_edges = scene(render::ShowMode::Level);
        with_edges.cloths.front().colour = {0xEC, 0xE9, 0xE3};
        with_edges.solids.push_back(coloured_edges(cloth_));
        render::Scene vertices = scene(render::ShowMode::Vertices);
        fill_show(vertices);
        return {"3.16", "level",
                labelled_sheet({{"triangles by level", draw(scene(render::ShowMode::Level))},
                                {"with coloured edges", draw(with_edges)},
                                {"vertices by level", draw(vertices)}},
                               3)};
    }

    Capture hierarchy() {
        render::Scene above = scene(render::ShowMode::Level);
        above.camera = frame_scene(above, render::View::Top, 1);
        above.light = studio_light(above.camera);
        render::Scene model;
        model.has_ground = false;
        const render::Legend legend = fill_hierarchy(model, triangle_hierarchy(cloth_), render::StackSide::Behind);
        model.camera = render::frame_points(scene_points(model), {.azimuth = 0.30F, .elevation = 0.62F}, {});
        model.light = even_light(model.camera);
        render::Image stack = draw(model);
        draw_legend(stack, legend, render::Corner::LowerLeft);
        return {"3.17", "hierarchy", labelled_sheet({{"from above", draw(above)}, {"its hierarchy", stack}}, 2)};
    }

    Capture materials() {
        struct Look {
            const char* name;
            sim::Rgb8 colour;
            render::Material material;
        };
        constexpr std::array<Look, 6> kLooks{
            {{"wool, red", {0xA8, 0x32, 0x2A}, {.gloss = 0.005F, .roughness = 0.5F, .sheen = 0.06F}},
             {"cotton, blue", {0x2F, 0x5D, 0x9B}, {.gloss = 0.008F, .roughness = 0.35F, .sheen = 0.045F}},
             {"silk, green", {0x2E, 0x7D, 0x4F}, {.gloss = 0.05F, .roughness = 0.25F, .sheen = 0.02F}},
             {"silk, gold", {0xC9, 0x9A, 0x2E}, {.gloss = 0.06F, .roughness = 0.2F, .sheen = 0.02F}},
             {"cotton, violet", {0x6B, 0x48, 0x8F}, {.gloss = 0.008F, .roughness = 0.35F, .sheen = 0.045F}},
             {"wool, grey", {0x6E, 0x71, 0x75}, {.gloss = 0.005F, .roughness = 0.5F, .sheen = 0.06F}}}};
        std::vector<Tile> tiles;
        for (const Look& look : kLooks) {
            render::Scene coloured = scene(render::ShowMode::Plain);
            coloured.cloths.front().colour = look.colour;
            coloured.cloths.front().material = look.material;
            tiles.push_back({look.name, draw(coloured)});
        }
        return {"3.18", "colours", labelled_sheet(tiles, 3)};
    }

 private:
    render::Scene scene(render::ShowMode show) const {
        render::Scene scene;
        scene.cloths.push_back({.mesh = mesh_, .sett = {}, .show = show});
        scene.bodies.push_back(drop_object_item(ThesisDropObject::Sphere));
        scene.camera = render::frame_points(mesh_.x, {.azimuth = 0.4F, .elevation = 0.5F}, {.margin = 0.12F});
        scene.light = is_painted(show) ? even_light(scene.camera) : studio_light(scene.camera);
        scene.has_ground = false;
        return scene;
    }
    render::Image draw(const render::Scene& scene) {
        return renderer_.draw(scene, {.width_px = side_px_, .height_px = side_px_});
    }

    sim::Cloth cloth_;
    sim::DrawMesh mesh_;
    int side_px_;
    render::Renderer renderer_;
};

}  // namespace

ThesisResult draw_mesh_pictures(const ThesisOptions& options) {
    SpherePictures pictures(options);
    return {.captures = {pictures.levels(), pictures.hierarchy(), pictures.materials()}};
}

// Figure 3.19.

namespace {

constexpr double kPatternSide = 0.4;  // m, of the cloth
constexpr float kFaceUp = 0.0F;       // m, height of the flat cloth

sim::Cloth flat_cloth() {
    return make_cloth(sim::make_square({.columns = 4, .rows = 4, .width = kPatternSide, .depth = kPatternSide}),
                      {sim::find_fabric("cotton_shirting")});
}

// The world position of a material point of the flat cloth.
Vec3f world_of(const sim::DrawMesh& mesh, const Vec2f& u) {
    const Vec3f x = mesh.x[mesh.triangles.front().front()];
    const Vec2f u0 = mesh.u.front().front();
    return {x.x() + u.x() - u0.x(), kFaceUp, x.z() - (u.y() - u0.y())};
}

// The pattern's axes: from position p, one size s along the weft and along the warp.
render::SolidItem pattern_axes(const sim::DrawMesh& mesh, const Vec2f& p, float s) {
    constexpr float kRadius = 0.0025F;  // m
    constexpr sim::Rgb8 kGreen{0x1F, 0x9A, 0x3C};
    const Vec3f lift(0, 2 * kRadius, 0);
    render::SolidItem solid;
    for (const Vec2f& along : {Vec2f(s, 0), Vec2f(0, s)})
        add_tube(solid, {world_of(mesh, p) + lift, world_of(mesh, p + along) + lift}, kRadius, kGreen);
    add_ball(solid, world_of(mesh, p) + lift, 2 * kRadius, kGreen, render::BallDetail::Fine);
    return solid;
}

std::string centimetres(double m) {
    return Cell(100 * m, 0).to_text();
}

}  // namespace

ThesisResult draw_test_pattern(const ThesisOptions& options) {
    const sim::Sett sett = sim::find_tartan("R8 W40 B8 W40 weft: K8 W40 G8 W40 weave: plain");
    struct Laid {
        Vec2f p;   // m
        double s;  // m, of one repeat
    };
    const sim::Cloth cloth = flat_cloth();
    const sim::DrawMesh mesh = draw_mesh(cloth, {"cloth"});
    Vec2f low = mesh.u.front().front();
    for (const auto& corners : mesh.u)
        for (const Vec2f& u : corners) low = low.cwiseMin(u);
    render::Renderer renderer;
    const auto picture = [&](const std::optional<Laid>& laid) {
        render::Scene scene;
        render::ClothItem item{.mesh = mesh, .sett = {}, .show = render::ShowMode::Edges};
        if (laid) {
            item.show = render::ShowMode::Tartan;
            item.sett = with_repeat_size(sett, laid->s);
            item.sett_position = low + laid->p;
            scene.solids.push_back(pattern_axes(mesh, low + laid->p, static_cast<float>(laid->s)));
        }
        scene.cloths.push_back(std::move(item));
        scene.camera = frame_scene(scene, render::View::Top, 1);
        scene.light = even_light(scene.camera);
        scene.has_ground = false;
        return renderer.draw(scene, {.width_px = side_px(options), .height_px = side_px(options)});
    };
    std::vector<Tile> tiles{{"mesh, 40 x 40 cm", picture({})}};
    for (const Laid& laid :
         {Laid{{0, 0}, 0.2}, Laid{{0.1F, 0.1F}, 0.2}, Laid{{0, 0}, 0.1}, Laid{{0.2F, 0.1F}, 0.1}, Laid{{0, 0}, 0.4}}) {
        tiles.push_back({"p " + centimetres(static_cast<double>(laid.p.x())) + ", " +
                             centimetres(static_cast<double>(laid.p.y())) + " cm  s " + centimetres(laid.s) + " cm",
                         picture(laid)});
    }
    return {.captures = {{"3.19", "pattern", labelled_sheet(tiles, 3)}}};
}

ThesisResult draw_hanging_tartans(const ThesisOptions& options) {
    SurfaceScene hanging = make_surface_scene(SurfaceExperiment::PinnedSquare, options.is_quick ? 0 : 2);
    run_for(hanging, options.is_quick ? 0.1 : 3);
    render::Renderer renderer;
    std::vector<Tile> tiles;
    for (const char* name : {"black_watch", "royal_stewart", "gordon"}) {
        render::Scene scene;
        scene.cloths.push_back({.mesh = draw_mesh(hanging.cloth, {"cloth"}),
                                .sett = with_repeat_size(sim::find_tartan(name), 0.12),
                                .show = render::ShowMode::Tartan});
        scene.camera = surface_camera(hanging.experiment);
        scene.light = studio_light(scene.camera);
        scene.has_ground = false;
        std::string label = name;
        for (char& c : label) c = c == '_' ? ' ' : c;
        tiles.push_back({label, renderer.draw(scene, {.width_px = side_px(options), .height_px = side_px(options)})});
    }
    return {.captures = {{"3.20", "tartans", labelled_sheet(tiles, 3)}}};
}

}  // namespace selvedge::bench
