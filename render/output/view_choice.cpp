#include "render/output/view_choice.h"

#include <algorithm>
#include <cmath>

#include "sim/collide/body_collider.h"
#include "sim/core/error.h"
#include "sim/core/math.h"
#include "sim/core/numbers.h"

namespace selvedge::render {
namespace {

[[noreturn]] void refuse_camera(const std::string& problem) {
    throw sim::InputError("", "--camera", problem);
}

CameraChoice by_direction(const std::vector<double>& numbers) {
    if (std::abs(numbers[0]) > 3600) refuse_camera("the azimuth must be within 3600 degrees");
    if (std::abs(numbers[1]) > 89) refuse_camera("the elevation must be from -89 to 89 degrees");
    CameraChoice choice;
    choice.direction = {.azimuth = static_cast<float>(numbers[0] * sim::kDegree),
                        .elevation = static_cast<float>(numbers[1] * sim::kDegree)};
    if (numbers.size() < 3) return choice;
    if (numbers[2] < 0.1 || numbers[2] > 100) refuse_camera("the zoom must be from 0.1 to 100");
    choice.zoom = static_cast<float>(numbers[2]);
    return choice;
}

CameraChoice by_points(const std::vector<double>& numbers) {
    const Vec3d eye(numbers[0], numbers[1], numbers[2]), target(numbers[3], numbers[4], numbers[5]);
    if (std::max(eye.cwiseAbs().maxCoeff(), target.cwiseAbs().maxCoeff()) > 1000)
        refuse_camera("must be within 1000 m");
    if ((eye - target).norm() < 0.01) refuse_camera("the eye must be at least 1 cm from what it looks at");
    CameraChoice choice;
    choice.eye_and_target = {eye.cast<float>(), target.cast<float>()};
    return choice;
}

}  // namespace

CameraChoice parse_camera(const std::string& text) {
    const auto numbers = sim::parse_number_list(text);
    if (numbers && (numbers->size() == 2 || numbers->size() == 3)) return by_direction(*numbers);
    if (numbers && numbers->size() == 6) return by_points(*numbers);
    refuse_camera("'" + text + "' is neither AZIMUTH,ELEVATION[,ZOOM] in degrees nor EYE_X,Y,Z,TARGET_X,Y,Z in metres");
}

CurveModifier parse_modifier(const std::string& text) {
    if (const auto kind = parse_surface_kind(text)) return curve_modifier(*kind);
    const auto numbers = sim::parse_number_list(text);
    if (!numbers || numbers->size() != 4) {
        throw sim::InputError("", "--surface",
                              "'" + text + "' is none of " + kSurfaceKindNames + ", nor four numbers K0,K1,K2,K3");
    }
    CurveModifier modifier;
    for (std::size_t i = 0; i < 4; ++i) {
        const double k = (*numbers)[i];
        if (std::abs(k) > kMaxCoefficient)
            throw sim::InputError("", "--surface", "'" + text + "': each of K0 to K3 must be from -100 to 100");
        modifier.k[i] = static_cast<float>(k);
    }
    return modifier;
}

sim::DrawMesh drawn_mesh(const sim::DrawMesh& garment, const sim::Body* body, const SurfaceChoice& choice,
                         const std::optional<sim::ViewPoint>& view) {
    if (!choice.modifier) return garment;
    CurveModifier modifier = *choice.modifier;
    if (choice.soft_cap) modifier.soft_cap = *choice.soft_cap;
    CurvedMeshOptions options{.curve = {.modifier = modifier, .level = choice.level},
                              .light_normals = choice.light_normals};
    if (choice.coarsens_back_faces) options.curve.view = view;
    std::optional<sim::BodyCollider> collider;
    if (body != nullptr) options.curve.move.body = &collider.emplace(*body);
    try {
        return curved_mesh(garment, options);
    } catch (const sim::InputError& error) {
        throw sim::InputError("", "--surface", error.place() + ": " + error.problem());
    }
}

}  // namespace selvedge::render
