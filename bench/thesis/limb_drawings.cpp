// Explanatory drawings of chapter 5: figures 5.1 to 5.3, the bounding cylinder of a bone. Frames, stacks and circles
// are those that LimbBounds computes for the mannequin.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

#include "bench/support/svg.h"
#include "bench/thesis/character_run.h"
#include "bench/thesis/inks.h"
#include "bench/thesis/limb_cylinders.h"
#include "bench/thesis/thesis.h"

namespace selvedge::bench {
namespace {

struct Posed {
    std::vector<Vec3f> x;  // by vertex of the body, m
    LimbBounds limbs;
};

Posed pose_at(const Character& character, const BlendedMotion& motion, double seconds) {
    Posed posed{.x = {}, .limbs = LimbBounds(*character.body, {.margin = 0, .slack = 0})};
    sim::SkinnedSurface(*character.body).positions(*character.body, motion.pose(seconds), posed.x);
    posed.limbs.move_to(*character.body, motion.pose(seconds), posed.x);
    return posed;
}

// The cylinder with the most stacks of those that bend most between two poses: a limb, not the trunk.
std::size_t swinging(const Posed& a, const Posed& b) {
    std::size_t best = 0;
    float most = -1;
    for (std::size_t i = 0; i < a.limbs.cylinders().size(); ++i) {
        const auto &one = a.limbs.cylinders()[i], &other = b.limbs.cylinders()[i];
        const float turn = 1 - one.axes.row(2).dot(other.axes.row(2));
        const float score = turn * static_cast<float>(std::min<std::size_t>(one.stacks.size(), 12));
        if (score > most) most = score, best = i;
    }
    return best;
}

void draw_axes(SvgDrawing& svg, const Vec2d& origin, const std::array<Vec2d, 3>& axes, const std::string& prefix) {
    constexpr std::array<std::string_view, 3> kInks{kGoldInk, kGreenInk, kBlueInk};
    constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
    for (std::size_t k = 0; k < 3; ++k) {
        if (axes[k].norm() < 2) continue;
        svg.arrow(origin, origin + axes[k], {.stroke = kInks[k], .width_px = 2});
        const Vec2d along = axes[k].normalized();
        const Vec2d beyond = origin + axes[k] + (k == 2 ? Vec2d(16 * along.y(), -16 * along.x()) : Vec2d(13 * along));
        svg.text(beyond + Vec2d(0, 5), prefix + kNames[k], {.size_px = 12, .fill = kInks[k], .anchor = "middle"});
    }
}

// Seen from the character's right front, so that all axes have a length.
Vec2d seen(const Vec3f& p) {
    const double x = static_cast<double>(p.x()), y = static_cast<double>(p.y()), z = static_cast<double>(p.z());
    return {0.45 * x + 0.89 * z, -y + 0.22 * x - 0.11 * z};
}

std::vector<std::uint32_t> rigid_vertices(const sim::Body& body, const std::vector<int>& bone_map, int bone) {
    std::vector<std::uint32_t> vertices;
    for (std::size_t t = 0; t < bone_map.size(); ++t) {
        if (bone_map[t] != bone) continue;
        for (const int v : body.triangles[t]) vertices.push_back(static_cast<std::uint32_t>(v));
    }
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

// The convex hull, in order.  (Andrew 1979)
std::vector<Vec2d> hull_of(std::vector<Vec2d> points) {
    std::ranges::sort(points,
                      [](const Vec2d& a, const Vec2d& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
    std::vector<Vec2d> hull;
    const auto add_side = [&](std::size_t first) {
        for (const Vec2d& p : points) {
            const auto turns_right = [&](const Vec2d& a, const Vec2d& b) {
                return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x()) <= 0;
            };
            while (hull.size() >= first + 2 && turns_right(hull[hull.size() - 2], hull.back())) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();  // the other side starts there
    };
    add_side(0);
    std::ranges::reverse(points);
    add_side(hull.size());
    return hull;
}

// Figure 5.1.
std::string frames_svg(const Character& character, const std::array<Posed, 2>& poses, std::size_t index) {
    constexpr double kScale = 850;  // px/m
    SvgDrawing svg(960, 470);
    const auto& bind = poses[0].limbs.cylinders()[index];
    const Vec3f middle = bind.origin + 0.5F * (bind.high + bind.low) * Vec3f(bind.axes.row(2));
    for (std::size_t pose = 0; pose < 2; ++pose) {
        const auto& cylinder = poses[pose].limbs.cylinders()[index];
        const Vec2d corner(150 + 260.0 * static_cast<double>(pose), 245);
        const Vec3f shift =
            pose == 0 ? middle
                      : Vec3f(cylinder.origin + 0.5F * (cylinder.high + cylinder.low) * Vec3f(cylinder.axes.row(2)));
        const auto at = [&](const Vec3f& p) { return Vec2d(corner + kScale * seen(p - shift)); };
        std::vector<Vec2d> points;
        for (const std::uint32_t v : rigid_vertices(*character.body, poses[pose].limbs.bone_map(), cylinder.bone))
            points.push_back(at(poses[pose].x[v]));
        svg.line(hull_of(points), {.stroke = kSoftInk, .width_px = 0.8, .fill = kPaleFill, .is_closed = true});
        const Vec3f tip = cylinder.origin + cylinder.high * Vec3f(cylinder.axes.row(2));
        svg.line({at(cylinder.origin), at(tip)}, {.stroke = kRedInk, .width_px = 4});
        svg.dot(at(poses[pose].x[cylinder.vertex]), 6, kBlueInk);
        std::array<Vec2d, 3> axes;
        for (int k = 0; k < 3; ++k) axes[static_cast<std::size_t>(k)] = 75 * seen(Vec3f(cylinder.axes.row(k)));
        draw_axes(svg, at(cylinder.origin), axes, "l");
        svg.text({corner.x() - 110, 26}, pose == 0 ? "Bind pose, in the world" : "Another pose",
                 {.size_px = 14, .is_bold = true});
    }
    std::array<Vec2d, 3> world;
    for (int k = 0; k < 3; ++k) world[static_cast<std::size_t>(k)] = 45 * seen(Vec3f(Vec3f::Unit(k)));
    draw_axes(svg, {60, 395}, world, "W");
    // In its own frame the bone starts at the origin and lies along Z.
    svg.text({640, 26}, "In the bone's frame", {.size_px = 14, .is_bold = true});
    const Vec2d origin(720, 360);
    const auto local = [&](const Vec3f& p) {
        return Vec2d(origin + kScale * Vec2d(static_cast<double>(p.x()) + 0.35 * static_cast<double>(p.y()),
                                             -static_cast<double>(p.z()) + 0.3 * static_cast<double>(p.y())));
    };
    svg.line({local(Vec3f::Zero()), local({0, 0, bind.high})}, {.stroke = kRedInk, .width_px = 4});
    const Vec3f vertex = bind.axes * (poses[0].x[bind.vertex] - bind.origin);
    svg.dot(local(vertex), 6, kBlueInk);
    draw_axes(svg, origin, {Vec2d(75, 0), Vec2d(0.35 * 75, 0.3 * 75), Vec2d(0, -75)}, "");
    svg.text({20, 458}, "Red: the bone. Blue dot: the rigid vertex that fixes the turn about it.",
             {.size_px = 12, .fill = kSoftInk});
    return svg.to_text();
}

std::vector<Vec2d> corners_of(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

// Figure 5.2: along the bone, and across it.
std::string stacks_svg(const LimbBounds& limbs, std::size_t index) {
    constexpr double kScale = 1500;  // px/m
    const auto& cylinder = limbs.cylinders()[index];
    const double stack_length = limbs.options().stack_length;
    SvgDrawing svg(1000, 420);
    const auto d = [](float value) { return static_cast<double>(value); };
    const double length = d(cylinder.high - cylinder.low), scale = std::min(kScale, 560 / length);
    const Vec2d left(30, 210);
    svg.line(corners_of(left.x(), left.y() - scale * d(cylinder.centre.x() + cylinder.radius),
                        left.x() + scale * length, left.y() - scale * d(cylinder.centre.x() - cylinder.radius)),
             {.stroke = kSoftInk, .fill = "#e4e4e1", .is_closed = true});
    for (std::size_t i = 0; i < cylinder.stacks.size(); ++i) {
        const LimbBounds::Stack& stack = cylinder.stacks[i];
        if (stack.radius < 0) continue;
        const double z0 = stack_length * static_cast<double>(i), z1 = std::min(length, z0 + stack_length);
        svg.line(corners_of(left.x() + scale * z0, left.y() - scale * d(stack.centre.x() + stack.radius),
                            left.x() + scale * z1, left.y() - scale * d(stack.centre.x() - stack.radius)),
                 {.stroke = kInk, .width_px = 1.2, .fill = kPaleFill, .is_closed = true});
    }
    svg.line({{left.x() - 12, left.y()}, {left.x() + scale * length + 16, left.y()}},
             {.stroke = kRedInk, .width_px = 1.5, .is_dashed = true});
    svg.text({left.x() + scale * length + 20, left.y() + 4}, "Z", {.fill = kRedInk});
    svg.text({20, 26}, "Stacks along the bone, each with its own offset and radius", {.size_px = 14, .is_bold = true});
    const Vec2d right(810, 220);
    const double across = 150 / d(cylinder.radius);
    const auto at = [&](const Vec2f& p) {
        const Vec2f off = p - cylinder.centre;
        return Vec2d(right + across * Vec2d(d(off.x()), -d(off.y())));
    };
    const std::size_t shown = cylinder.stacks.size() / 2;
    const LimbBounds::Stack& stack = cylinder.stacks[shown];
    svg.circle(at(cylinder.centre), 150, {.stroke = kSoftInk, .fill = "#e4e4e1"});
    svg.circle(at(stack.centre), across * d(stack.radius), {.stroke = kInk, .fill = kPaleFill});
    const int slices = limbs.options().slices;
    const auto rim = [&](double slice) {
        const double turn = 2 * std::numbers::pi * slice / slices;
        return Vec2d(at(stack.centre) + across * d(stack.radius) * Vec2d(std::cos(turn), -std::sin(turn)));
    };
    svg.line({at(stack.centre), rim(4), rim(4.5), rim(5)},
             {.stroke = kGreenInk, .width_px = 2, .fill = "#cfe3cf", .is_closed = true});
    for (int i = 0; i < slices; ++i) svg.line({at(stack.centre), rim(i)}, {.stroke = kSoftInk, .width_px = 0.7});
    svg.dot(at(Vec2f::Zero()), 5, kRedInk);
    svg.text({650, 26}, "One stack across it, in " + std::to_string(slices) + " slices",
             {.size_px = 14, .is_bold = true});
    svg.text({20, 405}, "Grey: the bounds of the whole cylinder. Red: the bone. Green: one slice.",
             {.size_px = 12, .fill = kSoftInk});
    return svg.to_text();
}

// Figure 5.3: the rigid vertices of the bone across its axis, the circle about one pair of them that is too small, and
// the smallest circle that encloses all.
std::string pairs_svg(const Character& character, const Posed& posed, std::size_t index) {
    const auto& cylinder = posed.limbs.cylinders()[index];
    std::vector<Vec2d> points;
    for (const std::uint32_t v : rigid_vertices(*character.body, posed.limbs.bone_map(), cylinder.bone)) {
        const Vec3f local = cylinder.axes * (posed.x[v] - cylinder.origin);
        points.emplace_back(static_cast<double>(local.x()), static_cast<double>(local.y()));
    }
    const Circle smallest = smallest_circle(points);
    // Those nearest to the circle decide it.
    const auto off = [&](const Vec2d& p) { return smallest.radius - (p - smallest.centre).norm(); };
    std::vector<Vec2d> on = points;
    std::ranges::sort(on, {}, off);
    SvgDrawing svg(760, 470);
    const double scale = 180 / smallest.radius;
    const auto at = [&](const Vec2d& p) {
        return Vec2d(Vec2d(300, 230) +
                     scale * (Vec2d(p.x(), -p.y()) - Vec2d(smallest.centre.x(), -smallest.centre.y())));
    };
    svg.circle(at(smallest.centre), 180, {.stroke = kGreenInk, .width_px = 2.5, .fill = "#f3f7f2"});
    for (const Vec2d& p : points) svg.dot(at(p), 1.6, kSoftInk);
    const Vec2d &i = on.front(), &j = on[on.size() / 2];
    svg.circle((at(i) + at(j)) / 2, (at(i) - at(j)).norm() / 2,
               {.stroke = kGoldInk, .width_px = 1.5, .is_dashed = true});
    for (const auto& [p, name] : {std::pair(i, "i"), std::pair(j, "j")}) {
        svg.dot(at(p), 5, kInk);
        svg.text(at(p) + Vec2d(9, -7), name, {.size_px = 15, .is_bold = true});
    }
    svg.arrow(at(Vec2d::Zero()), at(smallest.centre), {.stroke = kBlueInk, .width_px = 2.5});
    svg.dot(at(Vec2d::Zero()), 6, kRedInk);
    const auto key = [&](double y, std::string_view ink, const char* text) {
        svg.dot({510, y - 4}, 5, ink);
        svg.text({524, y}, text, {.size_px = 12});
    };
    key(120, kRedInk, "the bone, seen along it");
    key(145, kBlueInk, "the offset of the cylinder");
    key(170, kSoftInk, "rigid vertices");
    key(195, kGoldInk, "a pair that does not enclose all");
    key(220, kGreenInk, "the smallest that does");
    return svg.to_text();
}

}  // namespace

ThesisResult draw_limb_frames(const ThesisOptions& options) {
    const Character character = make_character(options);
    const BlendedMotion motion(*character.body, character.walk, kWalkStart + 1);
    const std::array<Posed, 2> poses{pose_at(character, motion, 0), pose_at(character, motion, kWalkStart + 0.35)};
    const std::size_t index = swinging(poses[0], poses[1]);
    return {.drawings = {{"5.1", "A bone in two poses, and its frame from its direction and a rigid vertex",
                          frames_svg(character, poses, index)},
                         {"5.2", "The bounding cylinder of that bone", stacks_svg(poses[0].limbs, index)},
                         {"5.3", "The smallest offset cylinder round the rigid vertices, across the bone",
                          pairs_svg(character, poses[0], index)}}};
}

}  // namespace selvedge::bench
