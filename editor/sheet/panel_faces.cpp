#include "editor/sheet/panel_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "render/scene/colour.h"
#include "sim/core/math.h"
#include "sim/mesh/delaunay.h"
#include "sim/mesh/sample_outline.h"
#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

constexpr std::array<double, 4> kChordErrors{1e-3, 2e-4, 3e-5, 6e-6};  // m, per level of detail
constexpr double kAllowedPx = 0.3;
constexpr int kFacesPerFrame = 2;
constexpr std::size_t kMaxToCheck = 600;  // points; the test for self-intersection takes quadratic time

std::size_t level_for(double scale) {
    std::size_t level = 0;
    while (level + 1 < kChordErrors.size() && kChordErrors[level] * scale > kAllowedPx) ++level;
    return level;
}

}  // namespace

PanelFace make_face(const sim::Panel& panel, double chord_error) {
    PanelFace face;
    for (const sim::OutlineEdge& edge : panel.edges) {
        face.edge_starts.push_back(face.points.size());
        const std::vector<Vec2d> line = outline_polyline(panel, edge, chord_error);
        face.points.insert(face.points.end(), line.begin(), line.end() - 1);
    }
    face.edge_starts.push_back(face.points.size());
    if (face.points.size() < 3 || face.points.size() > kMaxToCheck) return face;
    std::vector<Vec2d> welded = face.points;
    sim::weld(welded);
    if (sim::find_crossing(welded)) return face;
    if (auto triangles = sim::delaunay_inside(welded, {})) face.triangles = std::move(*triangles);
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

namespace {

;

// Divides the repeat into `count` equal parts; returns the mean colour of each in linear light.
std::vector<Vec3d> sampled(const std::vector<sim::Rgb8>& threads, int count) {
    std::vector<Vec3d> sums(threads.size() + 1, Vec3d::Zero());
    for (std::size_t i = 0; i < threads.size(); ++i) {
        sums[i + 1] = sums[i] + Vec3d(render::to_linear(threads[i][0]), render::to_linear(threads[i][1]),
                                      render::to_linear(threads[i][2]));
    }
    const auto sum_to = [&](double at) {
        const auto whole = std::min(static_cast<std::size_t>(at), threads.size() - 1);
        return Vec3d(sums[whole] + (at - double(whole)) * (sums[whole + 1] - sums[whole]));
    };
    std::vector<Vec3d> parts;
    parts.reserve(static_cast<std::size_t>(count));
    const double width = double(threads.size()) / count;
    for (int i = 0; i < count; ++i) parts.push_back((sum_to((i + 1) * width) - sum_to(i * width)) / width);
    return parts;
}

bool is_warp_seen(sim::Weave weave, int end, int pick) {
    const int period = weave == sim::Weave::Plain ? 2 : 4;
    const int over = weave == sim::Weave::Plain ? 1 : weave == sim::Weave::Twill22 ? 2 : 3;
    return ((end - pick) % period + period) % period < over;
}

}  // namespace

int sett_tile_side(double repeat_px) {
    int side = 32;
    while (side < 1024 && side < repeat_px) side *= 2;
    return side;
}

render::Image sett_tile(const sim::Sett& sett, int side_px) {
    const int ends = thread_count(sett), picks = weft_thread_count(sett);
    const double proportion = double(picks) / ends;
    const int height = std::clamp(static_cast<int>(std::lround(side_px * proportion)), 1, 2048);
    const std::vector<Vec3d> warp = sampled(thread_colours(sett), side_px);
    const std::vector<Vec3d> weft = sampled(weft_thread_colours(sett), height);
    // Single threads fade in from 1 to 2 px per thread.
    const double shows_threads = std::clamp(double(side_px) / ends - 1, 0.0, 1.0);
    const double share = sett.weave == sim::Weave::Twill31 ? 0.75 : 0.5;
    const render::SrgbTable<double, 8193> srgb;
    render::Image picture(side_px, height);
    for (int y = 0; y < height; ++y) {
        const int pick = static_cast<int>(double(y) * picks / height);
        for (int x = 0; x < side_px; ++x) {
            const int end = static_cast<int>(double(x) * ends / side_px);
            const double seen = is_warp_seen(sett.weave, end, pick) ? 1 : 0;
            const double part = share + shows_threads * (seen - share);
            const Vec3d colour = part * warp[std::size_t(x)] + (1 - part) * weft[std::size_t(y)];
            picture.at(x, y) = {srgb.at(colour[0]), srgb.at(colour[1]), srgb.at(colour[2]), 255};
        }
    }
    return picture;
}

}  // namespace selvedge::editor
