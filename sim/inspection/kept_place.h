#pragma once
// Whether the pieces of a garment stay on the part of a moving body that holds them: a skirt on its waist, a shirt on
// its shoulders. Each piece is watched by the vertices of its upper edge that lie on the body when it is dressed.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/joint_names.h"
#include "sim/core/math.h"

namespace selvedge::sim {

class SurfaceBvh;
struct Cloth;

class KeptPlace {
 public:
    // The garment as it is dressed. The body is not kept. Pre: the surface is the body's; the cloth's positions are
    // finite.
    KeptPlace(const Cloth& cloth, const Body& body, const SurfaceBvh& surface);

    // Later: `seconds` since it was dressed, with the surface where it is then.
    void note(const Cloth& cloth, const SurfaceBvh& surface, double seconds);

    // "left the waist at 1.20 s and hangs on the left hand", of each piece that did. panels: names of the cloth's
    // panels.
    std::vector<std::string> faults(std::span<const std::string> panels = {}) const;

    // m, by which half of the vertices that are watched of a piece, or more, have moved away from all the places on the
    // body where these were: a skirt that turns round the waist has not. The most of a piece at any time.
    double farthest() const { return farthest_; }

 private:
    // A vertex and the point of the body that it lies on.
    struct Anchor {
        std::uint32_t vertex = 0;
        std::uint32_t triangle = 0;
        std::array<float, 3> shares{};  // barycentric, of the triangle's vertices
        float away = 0;                 // m, when it is dressed
    };
    struct Piece {
        std::vector<std::uint32_t> vertices;  // of the base mesh
        std::vector<Anchor> anchors;
        std::uint16_t panel = 0;        // the first
        std::string_view part;          // of the body, which holds it
        std::optional<double> left_at;  // s
        std::string where;              // "hangs on the left hand", as noted last
    };

    void find_anchors(const Cloth& cloth, const SurfaceBvh& surface, Piece& piece) const;
    std::string_view part_of(std::uint32_t triangle) const;
    std::string where_is(const Cloth& cloth, const SurfaceBvh& surface, const Piece& piece) const;

    std::vector<std::array<int, 3>> triangles_;   // of the body
    std::vector<std::optional<Joint>> joint_of_;  // by vertex of the body: that moves it most
    std::vector<Piece> pieces_;
    double farthest_ = 0;
};

}  // namespace selvedge::sim
