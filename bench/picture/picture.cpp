#include "bench/picture/picture.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <map>

#include "bench/support/cloth_run.h"
#include "render/preview/preview_renderer.h"
#include "sim/core/math.h"

namespace selvedge::bench {
namespace {

// Divides each triangle into four coplanar triangles.
sim::DrawMesh split_in_four(const sim::DrawMesh& mesh) {
    sim::DrawMesh split;
    split.panel_names = mesh.panel_names;
    split.panel_grain_angles = mesh.panel_grain_angles;
    split.x = mesh.x;
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [found, is_new] =
            middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(split.x.size()));
        if (is_new) split.x.push_back((mesh.x[a] + mesh.x[b]) / 2);
        return found->second;
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const std::uint32_t bc = middle(b, c), ca = middle(c, a), ab = middle(a, b);
        for (const auto& triangle : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {bc, ca, ab}}) {
            split.triangles.push_back(triangle);
        }
        if (!mesh.panel.empty()) split.panel.insert(split.panel.end(), 4, mesh.panel[t]);
        if (!mesh.level.empty()) split.level.insert(split.level.end(), 4, mesh.level[t]);
        if (mesh.u.empty()) continue;
        const auto& [ua, ub, uc] = mesh.u[t];
        const Vec2f ubc = (ub + uc) / 2, uca = (uc + ua) / 2, uab = (ua + ub) / 2;
        for (const auto& u : {std::array{ua, uab, uca}, {uab, ub, ubc}, {uca, ubc, uc}, {ubc, uca, uab}}) {
            split.u.push_back(u);
        }
    }
    return split;
}

std::size_t triangles_of(const render::Scene& scene) {
    std::size_t count = 0;
    for (const render::ClothItem& cloth : scene.cloths) count += cloth.mesh.triangles.size();
    return count;
}

void turn_camera(render::Scene& scene, float angle) {
    const Eigen::Matrix3f turn = Eigen::AngleAxisf(angle, Vec3f::UnitY()).toRotationMatrix();
    scene.camera.eye = scene.camera.target + turn * (scene.camera.eye - scene.camera.target);
    scene.camera.up = turn * scene.camera.up;
}

void move_cloth(render::Scene& scene, const render::Scene& rest, float amount, int picture) {
    for (std::size_t i = 0; i < scene.cloths.size(); ++i) {
        sim::DrawMesh& mesh = scene.cloths[i].mesh;
        const sim::DrawMesh& before = rest.cloths[i].mesh;
        const std::vector<Vec3f> normals = sim::vertex_normals(before.x, before.triangles);
        for (std::size_t v = 0; v < mesh.x.size(); ++v) {
            const float phase = 25 * before.x[v].y() + 0.7F * float(picture);
            mesh.x[v] = before.x[v] + amount * (1 + std::sin(phase)) * normals[v];
        }
        mesh.normals = sim::vertex_normals(mesh.x, mesh.triangles);
    }
}

double processor_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double median(const std::vector<double>& values) {
    return values.empty() ? 0 : sim::quantile(values, 0.5);
}

class Stopwatch {
 public:
    Stopwatch(render::Renderer& renderer, render::RenderOptions options) : renderer_(renderer), options_(options) {}

    // Measures either the total time or the times of the parts. Timing the parts waits for GL after each of them, so
    // the two are measured on different pictures.
    void draw(const render::Scene& scene, bool with_parts) {
        render::PictureTimes times;
        options_.times = with_parts ? &times : nullptr;
        const double processor_start = processor_ms();
        const auto start = std::chrono::steady_clock::now();
        keep(renderer_.draw(scene, options_));
        const auto end = std::chrono::steady_clock::now();
        if (with_parts) {
            parts_.push_back(times);
        } else {
            totals_.push_back(std::chrono::duration<double, std::milli>(end - start).count());
            processor_.push_back(processor_ms() - processor_start);
        }
    }

    PictureTimings figure(const std::string& kind) const {
        PictureTimings figure{.kind = kind, .total = median(totals_), .processor = median(processor_), .parts = {}};
        for (const auto part :
             {&render::PictureTimes::compare, &render::PictureTimes::ambient_occlusion, &render::PictureTimes::upload,
              &render::PictureTimes::shadow, &render::PictureTimes::mask, &render::PictureTimes::draw,
              &render::PictureTimes::finish, &render::PictureTimes::read_back}) {
            std::vector<double> values;
            for (const render::PictureTimes& times : parts_) values.push_back(times.*part);
            figure.parts.*part = median(values);
        }
        return figure;
    }

 private:
    render::Renderer& renderer_;
    render::RenderOptions options_;
    std::vector<double> totals_, processor_;
    std::vector<render::PictureTimes> parts_;
};

// Times previews of a shared scene. The picture stays in a GL texture and is not read back.
class PreviewStopwatch {
 public:
    PreviewStopwatch(const render::GlContext& context, render::PreviewRenderer& renderer, render::PictureTexture& to)
        : context_(context), renderer_(renderer), to_(to) {}

    void draw(const render::SceneView& view) {
        const double processor_start = processor_ms();
        const auto start = std::chrono::steady_clock::now();
        renderer_.draw(view, to_);
        context_.finish();
        totals_.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        processor_.push_back(processor_ms() - processor_start);
    }

    PictureTimings figure(const std::string& kind) const {
        return {.kind = kind, .total = median(totals_), .processor = median(processor_), .parts = {}};
    }

 private:
    const render::GlContext& context_;
    render::PreviewRenderer& renderer_;
    render::PictureTexture& to_;
    std::vector<double> totals_, processor_;
};

void measure_previews(render::GlContext& context, const render::Scene& scene, const PictureExperiment& experiment,
                      std::vector<PictureTimings>& figures) {
    render::PreviewRenderer renderer(context);
    render::PictureTexture to(context.gl());
    to.resize(experiment.render.width_px, experiment.render.height_px);
    render::Scene turned = scene;
    render::SceneView view{
        .scene = std::make_shared<const render::Scene>(scene), .camera = scene.camera, .light = scene.light};
    PreviewStopwatch first(context, renderer, to);
    first.draw(view);
    figures.push_back(first.figure("draft: first"));
    PreviewStopwatch turning(context, renderer, to);
    for (int i = 0; i < 4 * experiment.pictures; ++i) {
        turn_camera(turned, experiment.turn);
        view.camera = turned.camera;
        turning.draw(view);
    }
    figures.push_back(turning.figure("draft: camera turns"));
    PreviewStopwatch moving(context, renderer, to);
    for (int i = 0; i < 4 * experiment.pictures; ++i) {
        move_cloth(turned, scene, experiment.ripple, i);
        view.scene = std::make_shared<const render::Scene>(turned);
        moving.draw(view);
    }
    figures.push_back(moving.figure("draft: cloth moves"));
}

}  // namespace

PictureReport measure_pictures(const render::Scene& given, const PictureExperiment& experiment) {
    render::Scene scene = given;
    for (render::ClothItem& cloth : scene.cloths) {
        while (triangles_of(scene) < static_cast<std::size_t>(experiment.triangles)) {
            cloth.mesh = split_in_four(cloth.mesh);
        }
    }
    const float aspect = float(experiment.render.width_px) / float(experiment.render.height_px);
    scene.camera = frame_scene(scene, experiment.view, aspect);
    scene.light = studio_light(scene.camera);
    PictureReport report{.cloth_triangles = triangles_of(scene),
                         .width_px = experiment.render.width_px,
                         .height_px = experiment.render.height_px,
                         .figures = {}};
    for (const render::BodyItem& body : scene.bodies) report.body_triangles += body.triangles.size();

    const std::unique_ptr<render::GlContext> context = render::make_context();
    render::Renderer renderer(*context);
    Stopwatch first(renderer, experiment.render);
    first.draw(scene, false);
    report.figures.push_back(first.figure("first"));
    Stopwatch turning(renderer, experiment.render);
    for (int i = 0; i < 2 * experiment.pictures; ++i) {
        turn_camera(scene, experiment.turn);
        scene.light = studio_light(scene.camera);
        turning.draw(scene, i % 2 == 1);
    }
    report.figures.push_back(turning.figure("camera and its lights turn"));
    Stopwatch looking(renderer, experiment.render);
    for (int i = 0; i < 2 * experiment.pictures; ++i) {
        turn_camera(scene, experiment.turn);
        looking.draw(scene, i % 2 == 1);
    }
    report.figures.push_back(looking.figure("camera turns"));
    Stopwatch moving(renderer, experiment.render);
    const render::Scene rest = scene;
    for (int i = 0; i < 2 * experiment.pictures; ++i) {
        move_cloth(scene, rest, experiment.ripple, i);
        moving.draw(scene, i % 2 == 1);
    }
    report.figures.push_back(moving.figure("cloth moves"));
    measure_previews(*context, rest, experiment, report.figures);
    return report;
}

Table table_of(const PictureReport& report) {
    Table table{.name = "picture",
                .title = "What a picture costs, ms",
                .note = std::to_string(report.width_px) + " x " + std::to_string(report.height_px) + ", cloth of " +
                        std::to_string(report.cloth_triangles) + " triangles on a body of " +
                        std::to_string(report.body_triangles) +
                        ". Medians by wall clock, and processor time of all threads. The parts are taken from other "
                        "pictures than the whole, as they wait "
                        "for each other. Drafts stay with GL.",
                .columns = {"picture", "whole", "processor", "compare", "room light", "upload", "shadow", "mask",
                            "draw", "finish", "read back"}};
    for (const PictureTimings& figure : report.figures) {
        const render::PictureTimes& parts = figure.parts;
        const bool has_parts = parts.draw > 0;
        const auto cell = [&](double value) { return has_parts ? Cell(value, 1) : Cell(); };
        table.add_row({figure.kind, Cell(figure.total, 1), Cell(figure.processor, 1), cell(parts.compare),
                       cell(parts.ambient_occlusion), cell(parts.upload), cell(parts.shadow), cell(parts.mask),
                       cell(parts.draw), cell(parts.finish), cell(parts.read_back)});
    }
    return table;
}

}  // namespace selvedge::bench
