#include "editor/viewport3d/viewport_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "editor/geometry/sewing.h"
#include "render/scene/colour.h"
#include "render/scene/solids.h"

namespace selvedge::editor {
namespace {

// Radii, px of the view.
constexpr float kOutline = 1.7F, kHoveredOutline = 1.3F, kEdge = 2.3F, kVertex = 4.6F, kThread = 0.45F, kNeedle = 0.6F,
                kPinHead = 4, kPoint = 4, kHoveredPoint = 5.5F, kPullBall = 4;
constexpr float kNeedleLength = 9;  // px

class Marker {
 public:
    Marker(const sim::Pattern& pattern, const DisplayedGarment& garment, const ViewportMarks& marks,
           render::SolidItem& solid)
        : pattern_(pattern), garment_(garment), undrawn_(marks.undrawn), size_(marks.size), solid_(solid) {}

    void outline(const std::string& panel, float radius, const sim::Rgb8& colour) {
        if (const std::optional<std::size_t> p = seen_panel(panel))
            add_tube(solid_, whole_path(garment_.outlines()[*p], garment_.mesh().x), radius * size_, colour);
    }

    void edge(const PartRef& part, float radius, const sim::Rgb8& colour) {
        const std::optional<std::size_t> p = seen_panel(part.panel);
        if (!p || part.index < 0) return;
        const std::vector<Vec3f> path =
            edge_path(garment_.outlines()[*p], static_cast<std::size_t>(part.index), garment_.mesh().x);
        add_tube(solid_, path, radius * size_, colour);
    }

    void vertex(const PartRef& part, float radius, const sim::Rgb8& colour) {
        if (const std::optional<Vec3f> x = place_of_vertex(part))
            add_ball(solid_, *x, radius * size_, colour, render::BallDetail::Coarse);
    }

    void seam(int index, float radius, const sim::Rgb8& colour) {
        if (index < 0 || static_cast<std::size_t>(index) >= pattern_.seams.size()) return;
        const sim::Seam& seam = pattern_.seams[static_cast<std::size_t>(index)];
        for (const sim::SeamSide& side : {seam.first, seam.second})
            edge({pattern_.panels[static_cast<std::size_t>(side.panel)].name, side.edge}, radius, colour);
    }

    std::optional<Vec3f> place_of_vertex(const PartRef& part) const {
        const std::optional<std::size_t> p = seen_panel(part.panel);
        if (!p) return std::nullopt;
        const std::vector<sim::OutlineEdge>& edges = pattern_.panels[*p].edges;
        const auto leaving = std::find_if(edges.begin(), edges.end(),
                                          [&](const sim::OutlineEdge& edge) { return edge.start == part.index; });
        if (leaving == edges.end()) return std::nullopt;
        const auto edge = static_cast<std::size_t>(leaving - edges.begin());
        return start_of(garment_.outlines()[*p], edge, garment_.mesh().x);
    }

    // Whether the cloth at a vertex of the mesh is drawn: at a seam, of one of its panels.
    bool is_drawn(const Vec3f& at) const {
        const sim::DrawMesh& mesh = garment_.mesh();
        if (undrawn_.empty() || mesh.x.empty()) return true;
        const std::size_t vertex = vertex_near(at);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const std::size_t panel = sim::panel_of(mesh, t);
            if (panel < mesh.panel_names.size() && undrawn_.contains(mesh.panel_names[panel])) continue;
            if (std::ranges::find(mesh.triangles[t], vertex) != mesh.triangles[t].end()) return true;
        }
        return false;
    }

    void pin(const Vec3f& at, const ViewportColours& colours) {
        const Vec3f head = at + kNeedleLength * size_ * normal_near(at);
        add_rod(solid_, at, head, kNeedle * size_, colours.needle);
        add_ball(solid_, head, kPinHead * size_, colours.pin, render::BallDetail::Coarse);
    }

 private:
    std::optional<std::size_t> seen_panel(const std::string& name) const {
        if (undrawn_.contains(name)) return std::nullopt;
        for (std::size_t p = 0; p < pattern_.panels.size() && p < garment_.outlines().size(); ++p) {
            if (pattern_.panels[p].name == name && !garment_.outlines()[p].is_empty()) return p;
        }
        return std::nullopt;
    }

    // Pre: the mesh has vertices.
    std::size_t vertex_near(const Vec3f& at) const {
        const std::vector<Vec3f>& x = garment_.mesh().x;
        const auto nearer = [&](const Vec3f& a, const Vec3f& b) {
            return (a - at).squaredNorm() < (b - at).squaredNorm();
        };
        return static_cast<std::size_t>(std::min_element(x.begin(), x.end(), nearer) - x.begin());
    }

    Vec3f normal_near(const Vec3f& at) const {
        const sim::DrawMesh& mesh = garment_.mesh();
        if (mesh.x.empty() || mesh.normals.size() != mesh.x.size()) return Vec3f::UnitY();
        return mesh.normals[vertex_near(at)];
    }

    const sim::Pattern& pattern_;
    const DisplayedGarment& garment_;
    const std::set<std::string>& undrawn_;
    float size_;
    render::SolidItem& solid_;
};

void mark_selection(Marker& marker, const Selection& selection, const sim::Rgb8& colour) {
    for (const std::string& panel : selection.panels) marker.outline(panel, kOutline, colour);
    for (const PartRef& edge : selection.edges) marker.edge(edge, kEdge, colour);
    for (const int seam : selection.seams) marker.seam(seam, kEdge, colour);
    for (const PartRef& vertex : selection.vertices) marker.vertex(vertex, kVertex, colour);
}

void mark_hover(Marker& marker, const ViewportMarks& marks, const sim::Rgb8& colour) {
    const Hover& hover = marks.hover;
    if (hover.vertex) marker.vertex(*hover.vertex, kVertex, colour);
    if (hover.edge) marker.edge(*hover.edge, kEdge, colour);
    if (hover.seam) marker.seam(*hover.seam, kEdge, colour);
    const bool is_part = hover.vertex || hover.edge || hover.seam;
    if (!is_part && !hover.panel.empty() && !marks.selection.panels.contains(hover.panel))
        marker.outline(hover.panel, kHoveredOutline, colour);
}

void mark_wrong(Marker& marker, const std::vector<PartLocation>& places, const sim::Rgb8& colour) {
    for (const PartLocation& place : places) {
        if (place.edge >= 0) marker.edge({place.panel, place.edge}, kEdge, colour);
        if (place.vertex >= 0) marker.vertex({place.panel, place.vertex}, kVertex, colour);
        if (place.edge < 0 && place.vertex < 0) marker.outline(place.panel, kOutline, colour);
    }
}

using Thread = std::array<Vec3f, 2>;

// Points at equal spacing along the path, ends included. Pre: the path is not empty, count > 1.
std::vector<Vec3f> even_points(const std::vector<Vec3f>& path, std::size_t count) {
    std::vector<float> way{0};
    for (std::size_t i = 1; i < path.size(); ++i) way.push_back(way.back() + (path[i] - path[i - 1]).norm());
    std::vector<Vec3f> points;
    std::size_t i = 1;
    for (std::size_t k = 0; k < count; ++k) {
        const float at = way.back() * float(k) / float(count - 1);
        while (i + 1 < path.size() && way[i] < at) ++i;
        const float part = i < path.size() ? way[i] - way[i - 1] : 0;
        const float t = part > 0 ? std::clamp((at - way[i - 1]) / part, 0.0F, 1.0F) : 0;
        points.push_back(part > 0 ? Vec3f(path[i - 1] + t * (path[i] - path[i - 1])) : path[i - 1]);
    }
    return points;
}

// Lines between the two sides of a seam, for panels shown as placed. The session's own lines may date from before the
// panels were moved.
std::vector<Thread> seam_lines_of(const sim::Seam& seam, const DisplayedGarment& garment) {
    constexpr float kApart = 0.025F;  // m
    std::array<std::vector<Vec3f>, 2> sides;
    const std::array<sim::SeamSide, 2> ends{seam.first, seam.second};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto panel = static_cast<std::size_t>(ends[i].panel);
        if (panel >= garment.outlines().size()) return {};
        const ClothOutline& outline = garment.outlines()[panel];
        if (!outline.is_empty())
            sides[i] = edge_path(outline, static_cast<std::size_t>(ends[i].edge), garment.mesh().x);
        if (sides[i].size() < 2) return {};
    }
    float length = 0;
    for (std::size_t i = 1; i < sides[0].size(); ++i) length += (sides[0][i] - sides[0][i - 1]).norm();
    const auto count = static_cast<std::size_t>(std::clamp(length / kApart, 2.0F, 100.0F)) + 1;
    const std::vector<Vec3f> first = even_points(sides[0], count), second = even_points(sides[1], count);
    std::vector<Thread> seam_lines;
    for (std::size_t k = 0; k < count; ++k)
        seam_lines.push_back({first[k], second[seam.is_reversed ? count - 1 - k : k]});
    return seam_lines;
}

bool is_undrawn(const sim::Pattern& pattern, std::size_t seam, const std::set<std::string>& undrawn) {
    if (seam >= pattern.seams.size()) return false;
    const auto has = [&](const sim::SeamSide& side) { return undrawn.contains(panel_of(pattern, side).name); };
    return has(pattern.seams[seam].first) || has(pattern.seams[seam].second);
}

void mark_seam_lines(render::SolidItem& solid, const sim::Pattern& pattern, const DisplayedGarment& garment,
                     const ViewportMarks& marks) {
    const auto draw = [&](const Thread& thread, std::size_t seam) {
        if (!marks.undrawn.empty() && is_undrawn(pattern, seam, marks.undrawn)) return;
        const int first = seam < pattern.seams.size() ? first_of_sewing(pattern, static_cast<int>(seam)) : 0;
        add_rod(solid, thread[0], thread[1], kThread * marks.size,
                render::line_colour(static_cast<std::size_t>(first)));
    };
    if (garment.is_placed()) {
        for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
            for (const Thread& thread : seam_lines_of(pattern.seams[s], garment)) draw(thread, s);
        }
        return;
    }
    const sim::SessionFrame& frame = garment.frame();
    for (std::size_t i = 0; i < frame.seam_lines.size(); ++i) {
        const int seam = i < frame.seam_line_seams.size() ? std::max(0, frame.seam_line_seams[i]) : 0;
        draw(frame.seam_lines[i], static_cast<std::size_t>(seam));
    }
}

void mark_pins(Marker& marker, const sim::Pattern& pattern, const DisplayedGarment& garment,
               const ViewportColours& colours) {
    if (!garment.is_placed()) {
        for (const Vec3f& pin : garment.frame().pins) {
            if (marker.is_drawn(pin)) marker.pin(pin, colours);
        }
    }
    for (const sim::Panel& panel : pattern.panels) {
        for (const int vertex : panel.pins) {
            if (const std::optional<Vec3f> x = marker.place_of_vertex({panel.name, vertex})) marker.pin(*x, colours);
        }
    }
}

}  // namespace

float coarse_size(float metres_per_px) {
    return std::exp2(std::round(2 * std::log2(std::max(metres_per_px, 1e-5F))) / 2);
}

render::SolidItem make_marks(const sim::Pattern& pattern, const DisplayedGarment& garment,
                             const std::vector<sim::ArrangementPoint>& points, const ViewportMarks& marks,
                             const ViewportColours& colours) {
    render::SolidItem solid;
    Marker marker(pattern, garment, marks, solid);
    if (marks.has_seam_lines) mark_seam_lines(solid, pattern, garment, marks);
    mark_selection(marker, marks.selection, colours.selected);
    mark_hover(marker, marks, colours.hovered);
    mark_wrong(marker, marks.wrong, colours.error);
    mark_pins(marker, pattern, garment, colours);
    if (marks.has_points) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool is_hovered = marks.hovered_point == i;
            add_ball(solid, points[i].position.cast<float>(), (is_hovered ? kHoveredPoint : kPoint) * marks.size,
                     is_hovered ? colours.hovered_point : colours.point, render::BallDetail::Coarse);
        }
    }
    if (marks.pulled_to)
        add_ball(solid, *marks.pulled_to, kPullBall * marks.size, colours.pull, render::BallDetail::Coarse);
    return solid;
}

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// One copy of a mesh vertex: its panel and material coordinates, and the next copy of the same vertex.
struct Part {
    std::uint16_t panel = 0;
    Vec2f u = Vec2f::Zero();
    std::uint32_t next = kNone;
};

std::vector<const sim::Panel*> panels_by_mesh(const sim::DrawMesh& mesh, const sim::Pattern& pattern) {
    std::vector<const sim::Panel*> panels;
    for (const std::string& name : mesh.panel_names) {
        const auto found = std::find_if(pattern.panels.begin(), pattern.panels.end(),
                                        [&](const sim::Panel& panel) { return panel.name == name; });
        panels.push_back(found == pattern.panels.end() ? nullptr : &*found);
    }
    return panels;
}

}  // namespace

ViewportColours dark_viewport_colours() {
    ViewportColours dark;
    dark.background = {.centre = {0x4A, 0x4D, 0x52}, .edge = {0x2C, 0x2E, 0x32}};
    dark.ink = {0xEC, 0xEA, 0xE5};
    dark.faint = {0xA2, 0xA4, 0xA8};
    dark.badge = {0x2A, 0x2C, 0x30};
    dark.badge_line = {0x4A, 0x4D, 0x53};
    dark.good = {0x63, 0xB8, 0x86};
    dark.error = {0xF0, 0x72, 0x68};
    return dark;
}

sim::DrawMesh placed_mesh(const sim::DrawMesh& mesh, const sim::Pattern& pattern) {
    const std::vector<const sim::Panel*> panels = panels_by_mesh(mesh, pattern);
    sim::DrawMesh placed = mesh;
    placed.x.clear();
    placed.vertex_level.clear();
    std::vector<std::uint32_t> first(mesh.x.size(), kNone);
    std::vector<Part> parts;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint16_t panel = sim::panel_of(mesh, t);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t vertex = mesh.triangles[t][c];
            const Vec2f& u = mesh.u[t][c];
            std::uint32_t part = first[vertex];
            while (part != kNone && !(parts[part].panel == panel && parts[part].u == u)) part = parts[part].next;
            if (part == kNone) {
                part = static_cast<std::uint32_t>(parts.size());
                parts.push_back({.panel = panel, .u = u, .next = std::exchange(first[vertex], part)});
                const sim::Panel* from = panel < panels.size() ? panels[panel] : nullptr;
                placed.x.push_back(from ? Vec3f(from->place(u.cast<double>()).cast<float>()) : mesh.x[vertex]);
            }
            placed.triangles[t][c] = part;
        }
    }
    placed.normals = sim::vertex_normals(placed.x, placed.triangles);
    return placed;
}

std::optional<Vec3f> place_of(const sim::DrawMesh& mesh, std::uint16_t panel, const Vec2f& u) {
    constexpr float kBeside = -1e-3F;
    for (std::size_t t = 0; t < mesh.u.size(); ++t) {
        if (!mesh.panel.empty() && mesh.panel[t] != panel) continue;
        const auto& [a, b, c] = mesh.u[t];
        const Vec2f ab = b - a, ac = c - a, to = u - a;
        const float area = ab.x() * ac.y() - ab.y() * ac.x();
        if (area == 0) continue;
        const float v = (to.x() * ac.y() - to.y() * ac.x()) / area, w = (ab.x() * to.y() - ab.y() * to.x()) / area;
        if (!(v >= kBeside && w >= kBeside && v + w <= 1 - kBeside)) continue;
        const auto& [i, j, k] = mesh.triangles[t];
        return Vec3f((1 - v - w) * mesh.x[i] + v * mesh.x[j] + w * mesh.x[k]);
    }
    return std::nullopt;
}

void DisplayedGarment::update(const sim::Pattern& pattern, std::uint64_t revision,
                              std::shared_ptr<const sim::SessionFrame> frame, GarmentState wanted) {
    const bool has_material = frame->mesh.u.size() == frame->mesh.triangles.size();
    const bool is_placed =
        has_material && (wanted == GarmentState::AsPlaced || frame->stage == sim::SessionStage::Placed);
    const bool is_pattern_new = revision != revision_ || version_ == 0;
    if (!is_pattern_new && frame == frame_ && is_placed == is_placed_) return;
    ++version_;
    revision_ = revision;
    frame_ = std::move(frame);
    is_placed_ = is_placed;
    if (is_placed_) placed_ = placed_mesh(frame_->mesh, pattern);
    find_outlines_again(pattern, is_pattern_new);
}

// Between adaptations a moving cloth has the same triangles, and so the same outlines.
void DisplayedGarment::find_outlines_again(const sim::Pattern& pattern, bool is_pattern_new) {
    const sim::DrawMesh& seen = mesh();
    if (!is_pattern_new && seen.triangles == outlined_ && seen.u == outlined_u_) return;
    outlined_ = seen.triangles;
    outlined_u_ = seen.u;
    outlines_ = find_outlines(seen, pattern);
}

}  // namespace selvedge::editor
