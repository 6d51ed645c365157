#include "editor/fitting/seen_garment.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace selvedge {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// A vertex of one panel that came from one of the mesh, and the next that came from the same.
struct Part {
    std::uint16_t panel = 0;
    Vec2f u = Vec2f::Zero();
    std::uint32_t next = kNone;
};

std::vector<const Panel*> panels_by_mesh(const PlainMesh& mesh, const Pattern& pattern) {
    std::vector<const Panel*> panels;
    for (const std::string& name : mesh.panel_names) {
        const auto found = std::find_if(pattern.panels.begin(), pattern.panels.end(),
                                        [&](const Panel& panel) { return panel.name == name; });
        panels.push_back(found == pattern.panels.end() ? nullptr : &*found);
    }
    return panels;
}

}  // namespace

PlainMesh placed_mesh(const PlainMesh& mesh, const Pattern& pattern) {
    const std::vector<const Panel*> panels = panels_by_mesh(mesh, pattern);
    PlainMesh placed = mesh;
    placed.x.clear();
    placed.vertex_level.clear();
    std::vector<std::uint32_t> first(mesh.x.size(), kNone);
    std::vector<Part> parts;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint16_t panel = mesh.panel.empty() ? std::uint16_t{0} : mesh.panel[t];
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t vertex = mesh.triangles[t][c];
            const Vec2f& u = mesh.u[t][c];
            std::uint32_t part = first[vertex];
            while (part != kNone && !(parts[part].panel == panel && parts[part].u == u)) part = parts[part].next;
            if (part == kNone) {
                part = static_cast<std::uint32_t>(parts.size());
                parts.push_back({.panel = panel, .u = u, .next = std::exchange(first[vertex], part)});
                const Panel* from = panel < panels.size() ? panels[panel] : nullptr;
                placed.x.push_back(from ? Vec3f(from->place(u.cast<double>()).cast<float>()) : mesh.x[vertex]);
            }
            placed.triangles[t][c] = part;
        }
    }
    placed.normals = vertex_normals(placed.x, placed.triangles);
    return placed;
}

std::optional<Vec3f> place_of(const PlainMesh& mesh, std::uint16_t panel, const Vec2f& u) {
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

void SeenGarment::follow(const Pattern& pattern, std::uint64_t revision, std::shared_ptr<const SessionFrame> frame,
                         GarmentState wanted) {
    const bool has_material = frame->mesh.u.size() == frame->mesh.triangles.size();
    const bool is_placed = has_material && (wanted == GarmentState::AsPlaced || frame->stage == SessionStage::Placed);
    const bool is_pattern_new = revision != revision_ || version_ == 0;
    if (!is_pattern_new && frame == frame_ && is_placed == is_placed_) return;
    ++version_;
    revision_ = revision;
    frame_ = std::move(frame);
    is_placed_ = is_placed;
    if (is_placed_) placed_ = placed_mesh(frame_->mesh, pattern);
    find_outlines_again(pattern, is_pattern_new);
}

// Between adaptions a moving cloth has the same triangles, and so the same outlines.
void SeenGarment::find_outlines_again(const Pattern& pattern, bool is_pattern_new) {
    const PlainMesh& seen = mesh();
    if (!is_pattern_new && seen.triangles == outlined_ && seen.u == outlined_u_) return;
    outlined_ = seen.triangles;
    outlined_u_ = seen.u;
    outlines_ = find_outlines(seen, pattern);
}

}  // namespace selvedge
