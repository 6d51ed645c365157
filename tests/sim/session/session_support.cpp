#include "tests/sim/session/session_support.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "sim/core/math.h"
#include "sim/mannequin/mannequin.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_file.h"
#include "sim/place/fit.h"
#include "tests/support/checkout.h"

namespace selvedge::sim::test {
namespace {

Vec3f middle_of(const DrawMesh& mesh, std::size_t t) {
    return (mesh.x[mesh.triangles[t][0]] + mesh.x[mesh.triangles[t][1]] + mesh.x[mesh.triangles[t][2]]) / 3;
}

Vec2f middle_u(const DrawMesh& mesh, std::size_t t) {
    return (mesh.u[t][0] + mesh.u[t][1] + mesh.u[t][2]) / 3;
}

}  // namespace

std::shared_ptr<const Body> session_body() {
    static const auto body = std::make_shared<const Body>(make_mannequin({.subdivisions = 1}).body);
    return body;
}

Pattern session_pattern(const std::string& name) {
    return load_pattern(std::filesystem::path(source_folder()) / "patterns" / (name + ".json")).pattern;
}

SessionOptions coarse_options() {
    SessionOptions options;
    options.max_level = 1;
    options.keeps_real_time = false;
    return options;
}

void settle(Session& session) {
    session.start();
    session.advance(600);
}

void split_edge(Pattern& pattern, int panel, int edge) {
    Panel& one = pattern.panels[static_cast<std::size_t>(panel)];
    selvedge::sim::split_edge(one, edge, 0.5);
    for (Seam& seam : pattern.seams) {
        for (SeamSide* side : {&seam.first, &seam.second}) {
            if (side->panel == panel && side->edge > edge) ++side->edge;
        }
    }
}

double stretch_p99(const DrawMesh& mesh) {
    std::vector<double> yarn_strains;
    for (const MeshStrain& strain : measure_strain(mesh)) {
        yarn_strains.push_back(static_cast<double>(strain.warp));
        yarn_strains.push_back(static_cast<double>(strain.weft));
    }
    return quantile(yarn_strains, 0.99);
}

float min_clearance(const DrawMesh& mesh) {
    const std::vector<float> all = measure_clearance(mesh.x, *session_body());
    return *std::ranges::min_element(all);
}

double mean_move(const SessionFrame& from, const SessionFrame& to) {
    double sum = 0;
    for (std::size_t t = 0; t < from.mesh.triangles.size(); ++t) {
        float least = std::numeric_limits<float>::max();
        std::size_t nearest = 0;
        for (std::size_t i = 0; i < to.mesh.triangles.size(); ++i) {
            if (to.mesh.panel[i] != from.mesh.panel[t]) continue;
            const float distance = (middle_u(to.mesh, i) - middle_u(from.mesh, t)).squaredNorm();
            if (distance >= least) continue;
            least = distance;
            nearest = i;
        }
        sum += static_cast<double>((middle_of(from.mesh, t) - middle_of(to.mesh, nearest)).norm());
    }
    return sum / static_cast<double>(from.mesh.triangles.size());
}

ClothPoint furthest_point(const SessionFrame& frame, int panel, const Vec3f& direction) {
    ClothPoint best{.frame = frame.number};
    float most = std::numeric_limits<float>::lowest();
    for (std::size_t t = 0; t < frame.mesh.triangles.size(); ++t) {
        if (frame.mesh.panel[t] != panel) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const float far = frame.mesh.x[frame.mesh.triangles[t][k]].dot(direction);
            if (far <= most) continue;
            most = far;
            best.triangle = static_cast<std::uint32_t>(t);
            best.weights = Vec3f::Unit(static_cast<int>(k));
        }
    }
    return best;
}

Vec3f position_of(const SessionFrame& frame, const ClothPoint& point) {
    Vec3f x = Vec3f::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        x += point.weights[static_cast<int>(k)] * frame.mesh.x[frame.mesh.triangles[point.triangle][k]];
    return x;
}

}  // namespace selvedge::sim::test
