#include "sim/paper/dart_cap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/paper/polyline_crossing.h"

namespace selvedge::sim {
namespace {

using Polyline = std::vector<Vec2d>;

struct Ray {
    Vec2d from = Vec2d::Zero();
    Vec2d along = Vec2d::UnitX();  // unit
};

Vec2d reflected(const Vec2d& p, const Ray& axis) {
    const Vec2d off = p - axis.from;
    return axis.from + 2 * off.dot(axis.along) * axis.along - off;
}

Polyline reflected(Polyline line, const Ray& axis) {
    for (Vec2d& p : line) p = reflected(p, axis);
    return line;
}

// The first line goes on straight beyond its end, by `by` in m.
Polyline carried_on(Polyline line, double by) {
    for (std::size_t i = line.size() - 1; i-- > 0;) {
        const Vec2d along = line.back() - line[i];
        if (along.norm() < 1e-6) continue;
        line.push_back(line.back() + by * along.normalized());
        return line;
    }
    return line;
}

Polyline backwards(Polyline line) {
    std::ranges::reverse(line);
    return line;
}

// The line of the dart's fold: the legs, carried on, are mirror images of each other in it.
Ray fold_of(const DartMouth& mouth) {
    constexpr double kParallel = 0.02;  // sine of the angle between the legs
    const double area = cross2(mouth.begin_outward, mouth.end_outward);
    const Vec2d along = (mouth.begin_outward + mouth.end_outward).normalized();
    if (std::abs(area) < kParallel) return {(mouth.begin + mouth.end) / 2, along};
    const double s = cross2(mouth.end - mouth.begin, mouth.end_outward) / area;
    return {mouth.begin + s * mouth.begin_outward, along};
}

// The cut line at the dart's mouth when it is closed, in the frame of the side before it, in two parts: up to the leg,
// carried on, and from there on.
struct ClosedLine {
    Polyline before, after;
};

std::optional<ClosedLine> closed_line(const DartMouth& mouth, const Polyline& before, const Polyline& after) {
    const Polyline a = carried_on(before, mouth.mitre), b = backwards(carried_on(backwards(after), mouth.mitre));
    Polyline line;
    if (const auto crossing = find_crossing(a, b)) {
        line = part_before(a, *crossing);
        const Polyline rest = part_after(b, *crossing);
        line.insert(line.end(), rest.begin() + 1, rest.end());
    } else {
        line = before;
        line.insert(line.end(), after.begin(), after.end());
    }
    const Vec2d &from = mouth.begin, &along = mouth.begin_outward;
    double least = std::numeric_limits<double>::infinity();
    std::optional<PolylineCrossing> at;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double left = cross2(along, line[i] - from), right = cross2(along, line[i + 1] - from);
        if ((left > 0) == (right > 0) || left == right) continue;
        const Vec2d place = line[i] + (line[i + 1] - line[i]) * left / (left - right);
        const double out = (place - from).dot(along);
        if (out < -1e-6 || out >= least) continue;
        least = out;
        at = {i, i, place};
    }
    if (!at) return std::nullopt;
    return ClosedLine{part_before(line, *at), part_after(line, *at)};
}

// The edge of the half of the folded cloth that continues from the leg to the fold; none if it does not come to the
// fold within `reach`, m.
std::optional<Polyline> edge_to_fold(const Polyline& under, const Ray& fold, double reach) {
    const Polyline line = carried_on(under, reach);
    Polyline part{line.front()};
    const double side = cross2(fold.along, line.front() - fold.from);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double next = cross2(fold.along, line[i + 1] - fold.from);
        if ((next > 0) == (side > 0)) {
            part.push_back(line[i + 1]);
            continue;
        }
        const double here = cross2(fold.along, line[i] - fold.from);
        part.push_back(line[i] + (line[i + 1] - line[i]) * here / (here - next));
        if ((part.back() - part.front()).norm() > reach) return std::nullopt;
        return part;
    }
    return std::nullopt;
}

}  // namespace

std::optional<DartCap> cap_dart(const DartMouth& mouth, const Polyline& before, const Polyline& after) {
    const Ray leg{mouth.begin, mouth.begin_outward}, fold = fold_of(mouth);
    const auto to_before = [&](Polyline line) { return reflected(reflected(std::move(line), fold), leg); };
    const auto to_after = [&](Polyline line) { return reflected(reflected(std::move(line), leg), fold); };
    const std::optional<ClosedLine> closed = closed_line(mouth, before, to_before(after));
    if (!closed) return std::nullopt;
    const double reach = 1.5 * (mouth.end - mouth.begin).norm() + mouth.mitre;
    const std::optional<Polyline> of_before = edge_to_fold(reflected(backwards(closed->before), leg), fold, reach);
    const std::optional<Polyline> of_after = edge_to_fold(closed->after, fold, reach);
    const bool takes_before = mouth.pressed_to == DartSide::Before ? of_before.has_value() : !of_after;
    const std::optional<Polyline>& edge = takes_before ? of_before : of_after;
    if (!edge) return std::nullopt;
    DartCap cap{.before = closed->before, .cap = {edge->begin() + 1, edge->end()}, .after = to_after(closed->after)};
    cap.fold = edge->back();
    cap.pressed_to = takes_before ? DartSide::Before : DartSide::After;
    const Polyline back = reflected(backwards(*edge), fold);
    cap.cap.insert(cap.cap.end(), back.begin() + 1, back.end() - 1);
    return cap;
}

}  // namespace selvedge::sim
