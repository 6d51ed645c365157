// Figure 5.4: a cross-section of the body and of the cloth on it, which the body has moved into, before and after the
// cloth's vertices are projected to the offset surface.  (thesis 5.3.4)
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "bench/support/svg.h"
#include "bench/thesis/character_run.h"
#include "bench/thesis/limb_cylinders.h"
#include "bench/thesis/thesis.h"

namespace selvedge::bench {
namespace {

constexpr float kDrawnOffset = 0.003F;  // m, from the body to the offset surface
constexpr double kMoves = 0.01;         // s, that the body goes on while the cloth stays
constexpr double kWindow = 0.09;        // m, width of the drawing
constexpr double kWidthPx = 1000, kHeightPx = 640;

using Segment = std::array<Vec2d, 2>;

// The meeting of a triangle with the plane of that height, seen from above: x to the right, z downward.
std::optional<Segment> cut(const std::array<Vec3f, 3>& corners, float height) {
    std::vector<Vec2d> ends;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3f &a = corners[k], &b = corners[(k + 1) % 3];
        if ((a.y() < height) == (b.y() < height)) continue;
        const Vec3f p = a + (b - a) * ((height - a.y()) / (b.y() - a.y()));
        ends.emplace_back(static_cast<double>(p.x()), static_cast<double>(p.z()));
    }
    if (ends.size() != 2) return std::nullopt;
    return Segment{ends[0], ends[1]};
}

// A part of the section, enlarged.
class Section {
 public:
    Section(const Vec3f& centre)
        : height_(centre.y()), centre_(static_cast<double>(centre.x()), static_cast<double>(centre.z())) {}

    template <class Corners>  // of triangle i, positions in m
    void triangles(std::size_t count, const Corners& corners, const SvgStroke& stroke) {
        for (std::size_t i = 0; i < count; ++i) {
            const auto segment = cut(corners(i), height_);
            if (segment && is_inside((*segment)[0], (*segment)[1]))
                drawing_.line({at((*segment)[0]), at((*segment)[1])}, stroke);
        }
    }

    void cross(const Vec3f& p, std::string_view colour) {
        const Vec2d x = at({static_cast<double>(p.x()), static_cast<double>(p.z())});
        constexpr double kArm = 6;  // px
        drawing_.line({x - Vec2d(kArm, kArm), x + Vec2d(kArm, kArm)}, {.stroke = colour, .width_px = 2});
        drawing_.line({x - Vec2d(kArm, -kArm), x + Vec2d(kArm, -kArm)}, {.stroke = colour, .width_px = 2});
    }

    bool is_near(const Vec3f& p, float above) const {
        const Vec2d x(static_cast<double>(p.x()), static_cast<double>(p.z()));
        return std::abs(p.y() - height_) < above && is_inside(x, x);
    }

    SvgDrawing& drawing() { return drawing_; }

 private:
    bool is_inside(const Vec2d& a, const Vec2d& b) const {
        const Eigen::AlignedBox2d window(centre_ - Vec2d(kWindow, kWindow) * 0.6,
                                         centre_ + Vec2d(kWindow, kWindow) * 0.6);
        return window.contains(a) || window.contains(b);
    }
    Vec2d at(const Vec2d& p) const { return Vec2d(kWidthPx / 2, kHeightPx / 2) + (p - centre_) * (kWidthPx / kWindow); }

    float height_;
    Vec2d centre_;
    SvgDrawing drawing_{kWidthPx, kHeightPx};
};

// The cloth of a run after the body has moved on, and where its vertices are projected to.
struct Projection {
    std::vector<Vec3f> body, offset;            // by vertex of the body, m
    std::vector<Vec3f> before, after;           // by vertex of the cloth, m
    std::vector<std::optional<Vec3f>> closest;  // by vertex of the cloth: on the body, of those that are too near
    std::uint32_t deepest = 0;                  // vertex of the cloth
};

Projection project(const CharacterRun& run, const DressedCharacter& character) {
    Projection made;
    const sim::Pose pose = run.motion().pose(run.seconds() + kMoves);
    sim::SkinnedSurface(*character.body).positions(*character.body, pose, made.body);
    LimbBounds limbs(*character.body);
    limbs.move_to(*character.body, pose, made.body);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto& [a, b, c] : character.body->triangles)
        triangles.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    const std::vector<Vec3f> normals = sim::vertex_normals(made.body, triangles);
    for (std::size_t v = 0; v < made.body.size(); ++v)
        made.offset.emplace_back(made.body[v] + kDrawnOffset * normals[v]);
    for (const Vec4f& x : run.cloth().x) made.before.emplace_back(x.head<3>());
    made.after = made.before;
    made.closest.resize(made.before.size());
    float least = kDrawnOffset;
    for (const sim::VertexId v : run.cloth().mesh.leaf_vertices()) {
        const auto contact = limbs.contact(made.before[v.value]);
        if (!contact || contact->distance >= kDrawnOffset || contact->distance == 0) continue;
        const Vec3f out = (made.before[v.value] - contact->point) / contact->distance;
        made.closest[v.value] = contact->point;
        made.after[v.value] = contact->point + kDrawnOffset * out;
        if (contact->distance < least && !run.cloth().is_pinned[v.value]) {
            least = contact->distance;
            made.deepest = v.value;
        }
    }
    return made;
}

std::string section_svg(const CharacterRun& run, const DressedCharacter& character) {
    constexpr std::string_view kBlack = "#222222", kGrey = "#A0A0A0", kRed = "#C62828", kGreen = "#2E8B3A";
    constexpr float kNear = 0.006F;  // m from the plane: closest points that are drawn
    const Projection made = project(run, character);
    Section section(made.before[made.deepest]);
    const auto body = [&](const std::vector<Vec3f>& x) {
        return [&](std::size_t i) {
            std::array<Vec3f, 3> corners;
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] = x[static_cast<std::size_t>(character.body->triangles[i][k])];
            return corners;
        };
    };
    const auto cloth = [&](const std::vector<Vec3f>& x) {
        return [&](std::size_t i) {
            const sim::LeafTriangle& leaf = run.cloth().mesh.leaf_triangles()[i];
            return std::array<Vec3f, 3>{x[leaf.v[0].value], x[leaf.v[1].value], x[leaf.v[2].value]};
        };
    };
    const std::size_t faces = character.body->triangles.size(), leaves = run.cloth().mesh.leaf_triangles().size();
    section.triangles(faces, body(made.offset), {.stroke = kGrey, .width_px = 2});
    section.triangles(faces, body(made.body), {.stroke = kBlack, .width_px = 2.5});
    section.triangles(leaves, cloth(made.before), {.stroke = kRed, .width_px = 2});
    section.triangles(leaves, cloth(made.after), {.stroke = kGreen, .width_px = 2});
    for (std::size_t v = 0; v < made.closest.size(); ++v) {
        if (made.closest[v] && section.is_near(*made.closest[v], kNear)) section.cross(*made.closest[v], kRed);
    }
    section.drawing().line({{0, 0}, {430, 0}, {430, 116}, {0, 116}},
                           {.stroke = "none", .fill = "#ffffff", .is_closed = true});
    double y = 24;
    for (const auto& [text, colour] : {std::pair<std::string_view, std::string_view>{"body", kBlack},
                                       {"offset surface, 3 mm", kGrey},
                                       {"cloth, after the body has moved on by 10 ms", kRed},
                                       {"cloth, its vertices projected to the offset surface", kGreen}}) {
        section.drawing().text({16, y}, text, {.fill = colour, .is_bold = true});
        y += 20;
    }
    section.drawing().text({16, y}, "crosses: closest points, within 6 mm of the plane", {.fill = kRed});
    return section.drawing().to_text();
}

}  // namespace

ThesisResult draw_collision_section(const ThesisOptions& options) {
    const DressedCharacter character = make_dressed_character(options);
    CharacterRun run(character, {.level = options.is_quick ? 1 : 3});
    CharacterTimes ignored;
    const double end = options.is_quick ? 0.1 : kWalkStart + 0.6;
    while (run.seconds() < end) run.frame(ignored);
    return {.drawings = {
                {"5.4", "Cloth projected to the closest points of the offset surface", section_svg(run, character)}}};
}

}  // namespace selvedge::bench
