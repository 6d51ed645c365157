#include "tests/golden/weave_sheet.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "render/scene/colour.h"

namespace selvedge::test {
namespace {

constexpr double kFovY = 0.25F;  // rad

int wrapped(double value, int count) {
    const int whole = static_cast<int>(std::floor(value));
    return (whole % count + count) % count;
}

// The sheet's directions in world space.
struct SheetAxes {
    Vec3d weft, warp;
};

SheetAxes axes_of(const SheetView& view) {
    const Vec3d right = Vec3d::UnitX() * (view.is_behind ? -1 : 1);
    const Vec3d up(0, std::cos(view.tilt), -std::sin(view.tilt));
    const double c = std::cos(view.turn), s = std::sin(view.turn);
    return {c * right + s * up, -s * right + c * up};
}

std::vector<Vec3d> linear_threads(const std::vector<sim::Rgb8>& colours) {
    std::vector<Vec3d> linear;
    for (const sim::Rgb8& colour : colours) linear.push_back(render::to_linear(colour).cast<double>());
    return linear;
}

std::vector<Vec3d> weft_threads(const sim::Sett& sett) {
    sim::Sett weft = sett;
    if (!sett.weft_stripes.empty()) {
        weft.stripes = sett.weft_stripes;
        weft.is_mirrored = sett.is_weft_mirrored;
    }
    return linear_threads(thread_colours(weft));
}

bool is_warp_over(sim::Weave weave, double end, double pick) {
    switch (weave) {
        case sim::Weave::Plain:
            return wrapped(end - pick, 2) == 0;
        case sim::Weave::Twill22:
            return wrapped(end - pick, 4) < 2;
        case sim::Weave::Twill31:
            return wrapped(end - pick, 4) < 3;
    }
    return false;
}

// A sheet seen by a camera that looks along -z.
class SeenSheet {
 public:
    SeenSheet(const SheetView& view, const render::Camera& camera, int side_px)
        : eye_(camera.eye.cast<double>()),
          axes_(axes_of(view)),
          normal_(axes_.weft.cross(axes_.warp)),
          height_(normal_.dot(eye_)),
          half_(std::tan(camera.fov_y / 2.0)),
          side_px_(side_px) {}

    // Where the ray through a position in the picture meets the sheet, m along weft and warp.
    Vec2d at(const Vec2d& px) const {
        const Vec2d ndc = px * (2.0 / side_px_) - Vec2d(1, 1);
        const Vec3d way(ndc.x() * half_, ndc.y() * half_, -1);
        const Vec3d hit = eye_ - way * (height_ / normal_.dot(way));
        return {axes_.weft.dot(hit), axes_.warp.dot(hit)};
    }

 private:
    Vec3d eye_;
    SheetAxes axes_;
    Vec3d normal_;
    double height_;  // m, of the eye over the sheet
    double half_;    // of the picture's height at a distance of 1
    int side_px_;
};

struct Threads {
    std::vector<Vec3d> warp, weft;
};

Vec3d dye_at(const SheetView& view, const Threads& threads, const Vec2d& place) {
    const Vec2d t = place / view.sett.thread_spacing;
    const double end = std::floor(t.x()), pick = std::floor(t.y());
    const bool is_warp = is_warp_over(view.sett.weave, end, pick) != view.is_behind;
    const std::vector<Vec3d>& system = is_warp ? threads.warp : threads.weft;
    return system[static_cast<std::size_t>(wrapped(is_warp ? end : pick, static_cast<int>(system.size())))];
}

}  // namespace

render::Scene sheet_scene(const SheetView& view) {
    render::Scene scene;
    scene.has_ground = false;
    scene.camera.fov_y = float(kFovY);
    const auto distance = static_cast<float>(view.field / 2 / std::tan(kFovY / 2));
    scene.camera.eye = Vec3f(0, 0, distance);
    scene.camera.target = Vec3f::Zero();
    scene.camera.near_plane = 0.02F * distance;
    scene.camera.far_plane = 20 * distance;
    scene.light.to_key = scene.light.to_fill = Vec3f::UnitZ();
    scene.light.key = view.key;
    scene.light.fill = 0;
    scene.light.sky = scene.light.bounce = kSheetLight - view.key;

    render::ClothItem cloth;
    cloth.sett = view.sett;
    cloth.material = {.gloss = 0, .roughness = 0.5F, .sheen = 0};
    const SheetAxes axes = axes_of(view);
    const double half = 1.6 * view.field / std::max(std::cos(view.tilt), 0.1);
    for (const Vec2d& corner : {Vec2d(-half, -half), Vec2d(half, -half), Vec2d(half, half), Vec2d(-half, half)}) {
        cloth.mesh.x.push_back((corner.x() * axes.weft + corner.y() * axes.warp).cast<float>());
    }
    cloth.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    for (const auto& triangle : cloth.mesh.triangles) {
        std::array<Vec2f, 3> u;
        for (std::size_t c = 0; c < 3; ++c) {
            const float sign_x = triangle[c] == 1 || triangle[c] == 2 ? 1.0F : -1.0F;
            const float sign_y = triangle[c] >= 2 ? 1.0F : -1.0F;
            u[c] = Vec2f(sign_x, sign_y) * static_cast<float>(half);
        }
        cloth.mesh.u.push_back(u);
    }
    scene.cloths.push_back(std::move(cloth));
    return scene;
}

Vec3d LinearPicture::mean() const {
    Vec3d sum = Vec3d::Zero();
    for (const Vec3d& pixel : pixels) sum += pixel;
    return sum / double(pixels.size());
}

std::vector<double> LinearPicture::channel(int index) const {
    std::vector<double> values;
    for (const Vec3d& pixel : pixels) values.push_back(pixel[index]);
    return values;
}

LinearPicture to_linear(const render::Image& image) {
    LinearPicture picture{.side_px = image.width_px, .pixels = {}};
    for (const render::Rgba8& pixel : image.pixels) {
        picture.pixels.push_back(render::to_linear(sim::Rgb8{pixel[0], pixel[1], pixel[2]}).cast<double>());
    }
    return picture;
}

LinearPicture dyes_seen(const SheetView& view, int side_px, int samples) {
    const Threads threads{linear_threads(thread_colours(view.sett)), weft_threads(view.sett)};
    const SeenSheet sheet(view, sheet_scene(view).camera, side_px);
    LinearPicture picture{.side_px = side_px, .pixels = {}};
    std::minstd_rand random(1);
    const auto within = [&] { return double(random() - 1) / double(std::minstd_rand::max()); };
    for (int y = side_px - 1; y >= 0; --y) {
        for (int x = 0; x < side_px; ++x) {
            Vec3d sum = Vec3d::Zero();
            for (int i = 0; i < samples * samples; ++i) {
                const double right = (i % samples + within()) / samples, up = (i / samples + within()) / samples;
                sum += dye_at(view, threads, sheet.at(Vec2d(x + right, y + up)));
            }
            picture.pixels.push_back(sum / (samples * samples));
        }
    }
    return picture;
}

// As in the shader: no yarn is fully black, and the wrong side is a little darker.
Vec3d lit_dye(const Vec3d& dye, const SheetView& view, const Vec3d& light) {
    const Vec3d albedo = (0.94 * dye + Vec3d::Constant(0.008)) * (view.is_behind ? 0.86 : 1.0);
    return albedo.cwiseProduct(light);
}

}  // namespace selvedge::test
