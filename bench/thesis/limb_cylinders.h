#pragma once
// The thesis' way to find the triangles of an animated character that cloth may touch, as a baseline for our hierarchy.
// (thesis 5.3.1-5.3.4, figs. 5.1-5.5)
//
// A bone map parts the surface: a triangle whose corners all follow one bone is rigid, the others, at joints, are
// deformable. The rigid triangles of each bone lie in a cylinder along it, which is fixed to the bone:
//
//      start ___________________ tip     stacks of 2 cm along the axis, each with its own offset from it and radius;
//        |   |   |   |   |   |   |       in each stack, 32 slices round its own centre list the triangles that a
//        '---'---'---'---'---'---'       point in them may be nearest to
//
// Deformable triangles lie in spheres that are fitted again to each pose.
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/pose.h"
#include "sim/core/math.h"

namespace selvedge::bench {

struct Circle {
    Vec2d centre = Vec2d::Zero();
    double radius = 0;
};

// The smallest circle that encloses the points.  (Welzl 1991, with the points in a fixed pseudo-random order)
// Pre: at least one point.
Circle smallest_circle(std::vector<Vec2d> points);

// By triangle: the bone that all its corners follow with at least this weight, or kDeformable.
inline constexpr int kDeformable = -1;
std::vector<int> map_bones(const sim::Body& body, float rigid_weight);

struct LimbOptions {
    double stack_length = 0.02;  // m
    int slices = 32;
    // m: a point that is at most this far from the surface finds the triangle nearest to it. 0 lists only the triangles
    // that overlap a slice.
    double margin = 0.006;
    // Corners with a smaller weight are deformable. Smooth skins have few with a weight of 1.
    float rigid_weight = 0.95F;
    double slack = 0.004;  // m, that rigid triangles may leave their bone by, as their weights are below 1
    int triangles_per_sphere = 16;
};

// Of one pose or more, s of the calling thread's CPU time.
struct LimbTimes {
    double structures = 0;  // the frames of the cylinders, and the spheres
    double planes = 0;      // of the triangles: normals and distances from the origin
};

struct LimbContact {
    Vec3f point = Vec3f::Zero();                              // on the nearest of the triangles that were collected, m
    float distance = std::numeric_limits<float>::infinity();  // m, negative behind that triangle
    std::uint32_t triangle = 0;
};

class LimbBounds {
 public:
    struct Stack {
        Vec2f centre = Vec2f::Zero();  // m, offset from the bone's axis
        float radius = 0;              // m, that encloses the rigid triangles of the stack
    };
    // In the frame of its bone: z along the bone, from `low` to `high`.
    struct Cylinder {
        int bone = 0;
        Vec3d tip = Vec3d::Zero();     // end of the bone, in the bone's own frame, m
        std::uint32_t vertex = 0;      // the rigid vertex that, with the bone's direction, fixes the frame
        Vec2f centre = Vec2f::Zero();  // m, offset from the bone's axis
        float radius = 0;              // m
        float low = 0, high = 0;       // m
        std::vector<Stack> stacks;
        std::vector<std::uint32_t> slice_start;  // slice j of stack i: listed[slice_start[i * slices + j]] and on
        std::vector<std::uint32_t> listed;       // triangles
        Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();  // lx, ly, lz in the present pose, one per row
        Vec3f origin = Vec3f::Zero();                        // the bone's start in the present pose, m
    };
    struct Sphere {
        Vec3f centre = Vec3f::Zero();      // m, in the present pose
        float radius = 0;                  // m
        std::uint32_t first = 0, end = 0;  // its triangles in deformable(), or the spheres of a region
    };

    // Starts in the body's rest pose. Pre: the body has a skin.
    explicit LimbBounds(const sim::Body& body, const LimbOptions& options = {});

    // Puts the structures where the surface is in a pose. x: by vertex, m, the skinned positions. Adds to `times`.
    // Pre: the poses have the bones' lengths; the body is that of the constructor.
    void move_to(const sim::Body& body, const sim::Pose& pose, std::span<const Vec3f> x, LimbTimes* times = nullptr);

    // Adds the triangles that p may collide with, each once; and what the cylinders add is none of the spheres'.
    void collect_from_cylinders(const Vec3f& p, std::vector<std::uint32_t>& triangles) const;
    void collect_from_spheres(const Vec3f& p, std::vector<std::uint32_t>& triangles) const;

    // The nearest of the triangles; nullopt if there are none. Of those that share the nearest point, an edge's or a
    // corner's, the one whose plane p is farthest from tells on which side of the surface p is: a rule of thumb, which
    // holds at edges and at corners that are not saddles.
    std::optional<LimbContact> nearest(const Vec3f& p, std::span<const std::uint32_t> triangles) const;

    // Collects from all and finds the nearest. If p is within the margin, it is that of the whole surface, as long as
    // rigid triangles stay within the slack.
    std::optional<LimbContact> contact(const Vec3f& p) const;
    // The same with a list to use.
    std::optional<LimbContact> contact(const Vec3f& p, std::vector<std::uint32_t>& triangles) const;

    // Unit normal of a triangle, and its distance from the origin, m, in the present pose.
    const Vec4f& plane(std::uint32_t triangle) const { return planes_[triangle]; }
    // As crossing_fraction() (sim/collide/surface_bvh.h).
    std::optional<float> crossing(std::uint32_t triangle, const std::array<Vec3f, 2>& segment) const;

    const LimbOptions& options() const { return options_; }
    const std::vector<int>& bone_map() const { return bone_map_; }
    const std::vector<Cylinder>& cylinders() const { return cylinders_; }
    std::span<const Sphere> regions() const { return regions_; }  // of one bone's deformable triangles each
    std::span<const Sphere> spheres() const { return spheres_; }
    std::span<const std::uint32_t> deformable() const { return deformable_; }

    // From the cylinder's frame to the present pose, m.
    static Vec3f to_world(const Cylinder& cylinder, const Vec3f& local) {
        return cylinder.origin + cylinder.axes.transpose() * local;
    }

 private:
    void make_cylinders(const sim::Body& body);
    void make_spheres(const sim::Body& body);
    void move_cylinders(const sim::Body& body, const sim::Pose& pose);
    void fit_spheres();
    void find_planes();

    LimbOptions options_;
    std::vector<int> bone_map_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<Vec3f> x_;
    std::vector<Vec4f> planes_;  // by triangle: unit normal and distance from the origin
    std::vector<Cylinder> cylinders_;
    std::vector<std::uint32_t> deformable_;
    std::vector<Sphere> spheres_, regions_;
};

}  // namespace selvedge::bench
