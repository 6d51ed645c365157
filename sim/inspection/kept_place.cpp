#include "sim/inspection/kept_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include "sim/cloth/cloth.h"
#include "sim/collide/surface_bvh.h"
#include "sim/core/disjoint_sets.h"

namespace selvedge::sim {
namespace {

constexpr float kBand = 0.1F;       // m, below the highest point of a piece: its upper edge
constexpr float kOnBody = 0.03F;    // m: cloth that is held; a loose waistband stands off by as much
constexpr float kOnFloor = 0.15F;   // m, over it
constexpr std::size_t kMany = 200;  // anchors: more say no more
constexpr std::size_t kFew = 3;     // anchors, which say nothing
constexpr double kLeftPlace = 0.2;  // m: from the waist to the crotch it is 0.25; a waistband that settles on the hips
                                    // slides by 0.1

std::string_view name_of_part(Joint joint) {
    constexpr std::array<std::string_view, kJointCount> kNames{
        "hips",           "waist",          "chest",           "neck",          "head",       "left shoulder",
        "left upper arm", "left forearm",   "left hand",       "left thigh",    "left shin",  "left foot",
        "left foot",      "right shoulder", "right upper arm", "right forearm", "right hand", "right thigh",
        "right shin",     "right foot",     "right foot"};
    return kNames[static_cast<std::size_t>(joint)];
}

// By vertex, the joint that moves it most; none where no bone above is a joint's.
std::vector<std::optional<Joint>> joints_by_vertex(const Body& body) {
    std::vector<std::optional<Joint>> of_bone(body.bones.size());
    const JointBones joints = find_joints(body.bones);
    for (std::size_t i = 0; i < kJointCount; ++i)
        if (joints.has(Joint(i))) of_bone[static_cast<std::size_t>(joints.bone[i])] = Joint(i);
    for (std::size_t b = 0; b < of_bone.size(); ++b)
        if (const int parent = body.bones[b].parent; !of_bone[b] && parent >= 0)
            of_bone[b] = of_bone[static_cast<std::size_t>(parent)];
    std::vector<std::optional<Joint>> of_vertex(body.x.size());
    for (std::size_t v = 0; v < body.skin.size(); ++v) {
        const auto strongest = std::ranges::max_element(body.skin[v].weights) - body.skin[v].weights.begin();
        of_vertex[v] = of_bone[body.skin[v].bones[static_cast<std::size_t>(strongest)]];
    }
    return of_vertex;
}

template <class Part>
Part most_frequent(const std::vector<Part>& parts) {
    std::map<Part, int> counts;
    for (const Part& part : parts) ++counts[part];
    Part best{};
    int most = 0;
    for (const auto& [part, count] : counts) {
        if (count <= most) continue;
        most = count;
        best = part;
    }
    return best;
}

}  // namespace

KeptPlace::KeptPlace(const Cloth& cloth, const Body& body, const SurfaceBvh& surface)
    : triangles_(body.triangles), joint_of_(joints_by_vertex(body)) {
    const std::size_t count = cloth.mesh.base_vertex_count();
    DisjointSets sets(cloth.x.size());
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles())
        for (std::size_t k = 1; k < 3; ++k)
            sets.join(static_cast<int>(leaf.v[0].value), static_cast<int>(leaf.v[k].value));
    std::map<int, Piece> pieces;
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        const auto [piece, is_new] = pieces.try_emplace(sets.find(static_cast<int>(leaf.v[0].value)));
        piece->second.panel = is_new ? leaf.panel : std::min(piece->second.panel, leaf.panel);
    }
    for (std::uint32_t v = 0; v < count; ++v)
        if (const auto piece = pieces.find(sets.find(static_cast<int>(v))); piece != pieces.end())
            piece->second.vertices.push_back(v);
    for (auto& [root, piece] : pieces) {
        find_anchors(cloth, surface, piece);
        if (piece.anchors.size() >= kFew && !piece.part.empty()) pieces_.push_back(std::move(piece));
    }
}

void KeptPlace::find_anchors(const Cloth& cloth, const SurfaceBvh& surface, Piece& piece) const {
    float top = -std::numeric_limits<float>::infinity();
    for (const std::uint32_t v : piece.vertices) top = std::max(top, cloth.x[v].y());
    for (const float low : {top - kBand, -std::numeric_limits<float>::infinity()}) {
        piece.anchors.clear();
        for (const std::uint32_t v : piece.vertices) {
            const Vec3f x = cloth.x[v].head<3>();
            if (x.y() < low) continue;
            const auto closest = surface.closest(x, kOnBody);
            if (!closest) continue;
            const auto& t = triangles_[closest->triangle];
            const auto at = [&](std::size_t k) { return surface.points()[static_cast<std::size_t>(t[k])]; };
            piece.anchors.push_back(
                {v, closest->triangle, barycentric(closest->point, at(0), at(1), at(2)), (x - closest->point).norm()});
        }
        if (piece.anchors.size() >= kFew) break;
    }
    const std::size_t every = 1 + piece.anchors.size() / kMany;
    for (std::size_t i = 0; i * every < piece.anchors.size(); ++i) piece.anchors[i] = piece.anchors[i * every];
    piece.anchors.resize((piece.anchors.size() + every - 1) / every);
    std::vector<std::string_view> parts;
    for (const Anchor& anchor : piece.anchors) parts.push_back(part_of(anchor.triangle));
    piece.part = most_frequent(parts);
    if (piece.part == "hips") piece.part = "waist";  // what is held there has a waist
}

std::string_view KeptPlace::part_of(std::uint32_t triangle) const {
    const std::optional<Joint> joint = joint_of_[static_cast<std::size_t>(triangles_[triangle][0])];
    return joint ? name_of_part(*joint) : std::string_view();
}

void KeptPlace::note(const Cloth& cloth, const SurfaceBvh& surface, double seconds) {
    for (Piece& piece : pieces_) {
        std::vector<Vec3f> places;
        for (const Anchor& anchor : piece.anchors) {
            Vec3f& place = places.emplace_back(Vec3f::Zero());
            for (std::size_t k = 0; k < 3; ++k)
                place += anchor.shares[k] * surface.points()[static_cast<std::size_t>(triangles_[anchor.triangle][k])];
        }
        std::vector<float> ways;
        for (const Anchor& anchor : piece.anchors) {
            const Vec3f x = cloth.x[anchor.vertex].head<3>();
            float nearest = std::numeric_limits<float>::infinity();
            for (const Vec3f& place : places) nearest = std::min(nearest, (x - place).squaredNorm());
            ways.push_back(std::sqrt(nearest) - anchor.away);
        }
        const auto middle = ways.begin() + static_cast<std::ptrdiff_t>(ways.size() / 2);
        std::ranges::nth_element(ways, middle);
        farthest_ = std::max(farthest_, static_cast<double>(*middle));
        if (static_cast<double>(*middle) > kLeftPlace && !piece.left_at) piece.left_at = seconds;
        if (piece.left_at) piece.where = where_is(cloth, surface, piece);
    }
}

std::string KeptPlace::where_is(const Cloth& cloth, const SurfaceBvh& surface, const Piece& piece) const {
    float top = -std::numeric_limits<float>::infinity();
    for (const std::uint32_t v : piece.vertices) top = std::max(top, cloth.x[v].y());
    if (top < kOnFloor) return "lies on the floor";
    for (const float low : {top - kBand, -std::numeric_limits<float>::infinity()}) {
        std::vector<std::string_view> parts;
        for (const std::uint32_t v : piece.vertices) {
            const Vec3f x = cloth.x[v].head<3>();
            if (x.y() < low) continue;
            if (const auto closest = surface.closest(x, kOnBody)) parts.push_back(part_of(closest->triangle));
        }
        if (const std::string_view part = most_frequent(parts); !part.empty())
            return "hangs on the " + std::string(part);
    }
    return "hangs on nothing";
}

std::vector<std::string> KeptPlace::faults(std::span<const std::string> panels) const {
    std::vector<std::string> faults;
    for (const Piece& piece : pieces_) {
        if (!piece.left_at) continue;
        std::array<char, 32> when{};
        std::snprintf(when.data(), when.size(), " at %.2f s", *piece.left_at);
        const std::string what =
            piece.panel < panels.size() ? "the garment of '" + panels[piece.panel] + "'" : "a garment";
        faults.push_back(what + " left the " + std::string(piece.part) + when.data() + " and " + piece.where);
    }
    return faults;
}

}  // namespace selvedge::sim
