#include "editor/sheet/panel_faces.h"

#include "sim/mesh/delaunay.h"
#include "sim/mesh/planar.h"
#include "sim/pattern/outline.h"

namespace selvedge {
namespace {

constexpr std::array<double, 4> kChordErrors{1e-3, 2e-4, 3e-5, 6e-6};  // m
constexpr double kAllowedPx = 0.3;
constexpr int kFacesPerFrame = 2;
constexpr std::size_t kMostToCheck = 600;  // points; finding crossings takes their square

std::size_t level_for(double scale) {
    std::size_t level = 0;
    while (level + 1 < kChordErrors.size() && kChordErrors[level] * scale > kAllowedPx) ++level;
    return level;
}

}  // namespace

PanelFace make_face(const Panel& panel, double chord_error) {
    PanelFace face;
    for (const OutlineEdge& edge : panel.edges) {
        face.edge_starts.push_back(face.points.size());
        const std::vector<Vec2d> line = outline_polyline(panel, edge, chord_error);
        face.points.insert(face.points.end(), line.begin(), line.end() - 1);
    }
    face.edge_starts.push_back(face.points.size());
    if (face.points.size() < 3 || face.points.size() > kMostToCheck) return face;
    std::vector<Vec2d> welded = face.points;
    weld(welded);
    if (find_crossing(welded)) return face;
    if (auto triangles = delaunay_inside(welded, {})) face.triangles = std::move(*triangles);
    return face;
}

std::vector<Vec2d> edge_points(const PanelFace& face, std::size_t edge) {
    std::vector<Vec2d> points(face.points.begin() + static_cast<std::ptrdiff_t>(face.edge_starts[edge]),
                              face.points.begin() + static_cast<std::ptrdiff_t>(face.edge_starts[edge + 1]));
    points.push_back(face.points[face.edge_starts[edge + 1] % face.points.size()]);
    return points;
}

void PanelFaces::begin_frame(const SheetGeometry& geometry) {
    left_ = kFacesPerFrame;
    std::erase_if(kept_, [&](const auto& entry) { return geometry.find(entry.first) == nullptr; });
}

const PanelFace& PanelFaces::face(const PanelShape& shape, double scale) {
    Kept& kept = kept_[shape.panel.name];
    if (kept.outline_version != shape.outline_version) kept = {.outline_version = shape.outline_version, .levels = {}};
    const std::size_t level = level_for(scale);
    if (kept.levels[level]) return *kept.levels[level];
    if (left_ <= 0) {
        for (std::size_t other = kLevels; other-- > 0;) {
            if (kept.levels[other]) return *kept.levels[other];
        }
    }
    --left_;
    return kept.levels[level].emplace(make_face(shape.panel, kChordErrors[level]));
}

}  // namespace selvedge
