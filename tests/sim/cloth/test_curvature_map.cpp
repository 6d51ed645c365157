// Curvature from hinge angles: exact on lattices, exact on average on every mesh.
#include "sim/cloth/curvature_map.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <map>
#include <random>
#include <vector>

namespace selvedge::sim::test {
namespace {

// A sheet of n x n quads, all cut along the same diagonal, with vertices displaced at random by up to `rough` of a
// quad. Each triangle has its own frame, rotated against the sheet's.
struct Sheet {
    std::vector<Vec2d> points;
    std::vector<std::array<int, 3>> triangles;
    std::vector<double> turns;  // rad
    std::vector<RestTriangle> rest;
    std::vector<std::array<std::pair<int, std::size_t>, 3>> beside;  // neighbour or -1, and the edge's index in it
    std::vector<CurvatureFit> fits;

    explicit Sheet(int n, double rough = 0) {
        std::mt19937 random(3);
        const auto draw = [&] { return rough * (double(random()) / 4294967296.0 - 0.5) * 2; };
        for (int r = 0; r <= n; ++r) {
            for (int c = 0; c <= n; ++c) points.push_back(Vec2d(c + 0.3 * r + draw(), 0.8 * r + draw()) * 0.01);
        }
        for (int r = 0; r < n; ++r) {
            for (int c = 0; c < n; ++c) {
                const int a = r * (n + 1) + c, b = a + 1, d = a + n + 1, e = d + 1;
                triangles.push_back({a, b, d});
                triangles.push_back({b, e, d});
            }
        }
        for (const auto& t : triangles) {
            turns.push_back(rough > 0 ? 3 * draw() : 0.4);
            RestTriangle one;
            for (std::size_t i = 0; i < 3; ++i) one.x[i] = Eigen::Rotation2Dd(turns.back()) * points[std::size_t(t[i])];
            rest.push_back(one);
        }
        join();
        for (const RestTriangle& one : rest) fits.push_back(fit_curvature(one));
    }
    void join() {
        std::map<std::pair<int, int>, std::pair<int, std::size_t>> side_of;
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                side_of[{triangles[t][(i + 1) % 3], triangles[t][(i + 2) % 3]}] = {int(t), i};
            }
        }
        beside.resize(triangles.size());
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                const auto found = side_of.find({triangles[t][(i + 2) % 3], triangles[t][(i + 1) % 3]});
                beside[t][i] = found == side_of.end() ? std::pair(-1, std::size_t{0}) : found->second;
                const auto [other, edge] = beside[t][i];
                if (other >= 0) rest[t].beyond[i] = rest[std::size_t(other)].side_for_neighbour(edge);
            }
        }
    }
    bool is_inner(std::size_t t) const {
        return rest[t].beyond[0].has_value() && rest[t].beyond[1].has_value() && rest[t].beyond[2].has_value();
    }
    Mat3d map(std::size_t t) const {
        std::array<FitBeside, 3> around;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [other, edge] = beside[t][i];
            if (other >= 0) around[i] = {&fits[std::size_t(other)], edge};
        }
        return curvature_map(fits[t], around);
    }
    // The hinge angles of a triangle on a surface with these curvatures in the sheet's frame.
    Vec3d angles(std::size_t t, const Vec3d& curvature) const {
        const auto height = [&](const Vec2d& p) {
            return 0.5 * (curvature[0] * p.x() * p.x() + curvature[1] * p.y() * p.y() + curvature[2] * p.x() * p.y());
        };
        std::array<double, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) corners[i] = height(points[std::size_t(triangles[t][i])]);
        Vec3d angles = Vec3d::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [other, edge] = beside[t][i];
            if (other < 0) continue;
            const double apex = height(points[std::size_t(triangles[std::size_t(other)][edge])]);
            const HingeSide own = rest[t].own_side(i), beyond = *rest[t].beyond[i];
            const double start = corners[(i + 1) % 3], end = corners[(i + 2) % 3];
            angles[Eigen::Index(i)] = (corners[i] - std::lerp(start, end, own.foot)) / own.height +
                                      (apex - std::lerp(start, end, beyond.foot)) / beyond.height;
        }
        return angles;
    }
};

// Curvatures in a frame in which the old x axis lies at the angle `turn`.
Vec3d turned(const Vec3d& k, double turn) {
    const double c = std::cos(turn), s = std::sin(turn);
    return {c * c * k[0] + s * s * k[1] - c * s * k[2], s * s * k[0] + c * c * k[1] + c * s * k[2],
            2 * c * s * (k[0] - k[1]) + (c * c - s * s) * k[2]};
}

const std::vector<Vec3d> kQuadratics{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, -1, 3}};

TEST(CurvatureMap, meets_quadratic_surfaces_exactly_on_a_lattice) {
    const Sheet sheet(6);
    int inner = 0;
    for (std::size_t t = 0; t < sheet.rest.size(); ++t) {
        // A map depends on the errors of its neighbours, so these must be inner triangles too.
        bool is_deep = sheet.is_inner(t);
        for (const auto& [other, edge] : sheet.beside[t]) is_deep = is_deep && sheet.is_inner(std::size_t(other));
        if (!is_deep) continue;
        ++inner;
        for (const Vec3d& k : kQuadratics) {
            EXPECT_LT((sheet.map(t) * sheet.angles(t, k) - turned(k, sheet.turns[t])).norm(), 1e-9);
        }
    }
    EXPECT_GT(inner, 20);
}

TEST(CurvatureMap, gives_what_both_sides_of_a_hinge_see_the_length_of_its_edge_whatever_the_mesh_and_its_frames) {
    const Sheet sheet(8, 0.3);
    for (std::size_t t = 0; t < sheet.rest.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [other, edge] = sheet.beside[t][i];
            if (other < 0) continue;
            const auto column = [&](std::size_t of, std::size_t at) {
                const Vec3d c = sheet.map(of).col(Eigen::Index(at)) * sheet.fits[of].area;
                return turned(c, -sheet.turns[of]);
            };
            const Vec2d edge_vector = sheet.points[std::size_t(sheet.triangles[t][(i + 2) % 3])] -
                                      sheet.points[std::size_t(sheet.triangles[t][(i + 1) % 3])];
            const double length = edge_vector.norm();
            const Vec2d n(edge_vector.y() / length, -edge_vector.x() / length);
            const Vec3d expected = length * Vec3d(n.x() * n.x(), n.y() * n.y(), 2 * n.x() * n.y());
            EXPECT_LT((column(t, i) + column(std::size_t(other), edge) - expected).norm(), 1e-9 * length);
        }
    }
}

TEST(CurvatureMap, comes_nearer_to_quadratics_on_rough_meshes_by_the_exchange_of_neighbours) {
    const Sheet sheet(12, 0.3);
    double before = 0, after = 0;
    for (std::size_t t = 0; t < sheet.rest.size(); ++t) {
        if (!sheet.is_inner(t)) continue;
        const CurvatureFit& fit = sheet.fits[t];
        before += fit.area * (fit.map * fit.angles - Mat3d::Identity()).squaredNorm();
        after += fit.area * (sheet.map(t) * fit.angles - Mat3d::Identity()).squaredNorm();
    }
    EXPECT_LT(after, 0.7 * before);
}

TEST(CurvatureMap, leaves_no_moment_across_free_edges_and_no_rigidity_where_all_are_free) {
    RestTriangle triangle;
    triangle.x = {Vec2d(0, 0), Vec2d(0.02, 0.003), Vec2d(0.005, 0.017)};
    const Vec3d rigidity(3e-5, 1e-5, 0.8e-5);
    const HingeSide some{.length = 0.02, .height = 0.01, .foot = 0.5};
    triangle.beyond = {some, some, some};
    EXPECT_EQ(free_edge_rigidity(rigidity, triangle), Mat3d(rigidity.asDiagonal()));
    for (const std::size_t first_free : {2U, 1U}) {
        for (std::size_t i = first_free; i < 3; ++i) triangle.beyond[i].reset();
        const Mat3d left = free_edge_rigidity(rigidity, triangle);
        for (std::size_t i = first_free; i < 3; ++i) {
            const Vec2d along = (triangle.x[(i + 2) % 3] - triangle.x[(i + 1) % 3]).normalized();
            const Vec3d across(along.y() * along.y(), along.x() * along.x(), -2 * along.x() * along.y());
            EXPECT_LT((left * across).norm(), 1e-15);
        }
        const Vec3d modes = Eigen::SelfAdjointEigenSolver<Mat3d>(left).eigenvalues();
        EXPECT_GT(modes[0], -1e-15);
        EXPECT_GT(modes[2], 1e-6);
    }
    triangle.beyond[0].reset();
    EXPECT_EQ(free_edge_rigidity(rigidity, triangle), Mat3d(Mat3d::Zero()));
}

}  // namespace
}  // namespace selvedge::sim::test
