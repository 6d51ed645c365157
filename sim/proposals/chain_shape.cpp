#include "sim/proposals/chain_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "sim/pattern/polyline.h"

namespace selvedge::sim {
namespace {

// The parts of a view that lie on one atom each.
std::vector<std::pair<Vec2d, Vec2d>> chords_of(const OpenBoundary& boundary, const ChainView& view) {
    std::vector<double> stops = joints_of(boundary, view);
    stops.insert(stops.begin(), 0);
    stops.push_back(1);
    std::vector<std::pair<Vec2d, Vec2d>> chords;
    constexpr double kInside = 1e-7;  // so that a joint's place is on the atom that is meant
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const ChainPlace from = place_on(boundary, view, stops[i] + kInside);
        const ChainPlace to = place_on(boundary, view, stops[i + 1] - kInside);
        chords.emplace_back(boundary.point(from.atom, from.t), boundary.point(to.atom, to.t));
    }
    return chords;
}

// Where each atom of the view lies when the darts that it runs over are closed: in the frame of the panel's first atom.
// Loops stay as they are drawn, so that what is up in the panel is up.
std::vector<std::pair<int, Eigen::Affine2d>> developed(const OpenBoundary& boundary, const ChainView& view) {
    constexpr double kStep = 0.01;  // of an atom, for its direction
    std::vector<std::pair<int, Eigen::Affine2d>> places;
    const std::size_t count = view.chain.atoms.size();
    for (std::size_t k = 0; k < count; ++k) {
        const int atom = view.chain.atoms[(static_cast<std::size_t>(view.first) + k) % count];
        Eigen::Affine2d place = Eigen::Affine2d::Identity();
        if (!places.empty() && boundary.atom(places.back().first).span.panel == boundary.atom(atom).span.panel) {
            const auto& [last, before] = places.back();
            const Vec2d end = before * boundary.point(last, 1), start = boundary.point(atom, 0);
            const OpenBoundary::Step step = boundary.next(last);
            place = before;
            if (step.atom == atom && step.seams > 0 && !view.chain.is_loop) {
                const Vec2d out = end - before * boundary.point(last, 1 - kStep);
                const Vec2d in = boundary.point(atom, kStep) - start;
                const double turn = std::numbers::pi - step.angle + std::atan2(cross2(in, out), in.dot(out));
                place = Eigen::Translation2d(end) * Eigen::Rotation2Dd(turn) * Eigen::Translation2d(-start);
            }
        }
        places.emplace_back(atom, place);
    }
    return places;
}

}  // namespace

std::vector<Vec2d> sampled(const OpenBoundary& boundary, const ChainView& view) {
    const std::vector<std::pair<int, Eigen::Affine2d>> places = developed(boundary, view);
    std::vector<Vec2d> points;
    for (int i = 0; i <= kChainSamples; ++i) {
        const ChainPlace place = place_on(boundary, view, static_cast<double>(i) / kChainSamples);
        const auto found = std::ranges::find(places, place.atom, &std::pair<int, Eigen::Affine2d>::first);
        points.push_back(found->second * boundary.point(place.atom, place.t));
    }
    return points;
}

double shape_difference(std::vector<Vec2d> a, std::vector<Vec2d> b, bool is_mirrored) {
    const auto centre = [](std::vector<Vec2d>& points) {
        Vec2d mean = Vec2d::Zero();
        for (const Vec2d& p : points) mean += p;
        mean /= static_cast<double>(points.size());
        const double length = polyline_length(points);
        for (Vec2d& p : points) p = (p - mean) / std::max(length, 1e-12);
    };
    centre(a);
    centre(b);
    if (is_mirrored) {
        for (Vec2d& p : b) p.x() = -p.x();
    }
    double cosine = 0, sine = 0, squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        cosine += a[i].dot(b[i]);
        sine += cross2(b[i], a[i]);
        squares += a[i].squaredNorm() + b[i].squaredNorm();
    }
    return std::sqrt(std::max(0.0, squares - 2 * std::hypot(cosine, sine)) / static_cast<double>(a.size()));
}

double straightness(const std::vector<Vec2d>& points) {
    return (points.back() - points.front()).norm() / std::max(polyline_length(points), 1e-12);
}

double rise(const std::vector<Vec2d>& points) {
    return (points.back().y() - points.front().y()) / std::max(polyline_length(points), 1e-12);
}

std::vector<double> heights_along(const OpenBoundary& boundary, const ChainView& view) {
    std::vector<double> heights;
    int last = -1;
    double shift = 0;  // m
    for (int i = 0; i <= kChainSamples; ++i) {
        const ChainPlace at = place_on(boundary, view, static_cast<double>(i) / kChainSamples);
        const double y = boundary.point(at.atom, at.t).y();
        const int panel = boundary.atom(at.atom).span.panel;
        if (i > 0 && panel != last) shift = heights.back() - y;
        heights.push_back(y + shift);
        last = panel;
    }
    return heights;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const auto count = static_cast<double>(a.size());
    const double mean_a = std::accumulate(a.begin(), a.end(), 0.0) / count;
    const double mean_b = std::accumulate(b.begin(), b.end(), 0.0) / count;
    double both = 0, squares_a = 0, squares_b = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += (a[i] - mean_a) * (b[i] - mean_b);
        squares_a += (a[i] - mean_a) * (a[i] - mean_a);
        squares_b += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return squares_a > 0 && squares_b > 0 ? both / std::sqrt(squares_a * squares_b) : 0;
}

double facing_up(const OpenBoundary& boundary, const ChainView& view) {
    double up = 0;
    for (const auto& [from, to] : chords_of(boundary, view)) up -= to.x() - from.x();
    return up / length_of(view);
}

double rise_along(const OpenBoundary& boundary, const ChainView& view) {
    double up = 0;
    for (const auto& [from, to] : chords_of(boundary, view)) up += to.y() - from.y();
    return up / length_of(view);
}

double bulge(const std::vector<Vec2d>& points) {
    double area = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        area += cross2(points[i - 1] - points[0], points[i] - points[0]) / 2;
    const double length = polyline_length(points);
    return area / std::max(1e-12, length * length);
}

}  // namespace selvedge::sim
