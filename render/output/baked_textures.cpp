#include "render/output/baked_textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "render/draw/cloth_vertices.h"
#include "render/image/image.h"
#include "render/scene/colour.h"
#include "sim/core/assert.h"
#include "sim/core/parallel.h"
#include "sim/exchange/mesh_file.h"

namespace selvedge::render {
namespace {

float smoothstep(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

// The largest whole number up to x. std::floor() is a call into the C library on processors without SSE 4.1.
int floored(float x) {
    const int whole = static_cast<int>(x);
    return whole - (static_cast<float>(whole) > x ? 1 : 0);
}

// One system of parallel threads: prefix sums of its colours (render/draw/cloth_vertices.h).
class Threads {
 public:
    explicit Threads(SettSums sums) : sums_(std::move(sums)) {
        for (std::size_t k = 0; k + 1 < sums_.sums.size(); ++k) {
            steps_.emplace_back(sums_.sums[k + 1] - sums_.sums[k]);
            colours_.emplace_back(sums_.mean + sums_.sums[k + 1] - sums_.sums[k]);
        }
    }

    // t, width: in threads.
    Vec3f mean(float t, float width) const { return sums_.mean + (sum(t + width / 2) - sum(t - width / 2)) / width; }
    const Vec3f& colour(int thread) const { return colours_[index(thread)]; }

 private:
    std::size_t index(int thread) const {
        const int count = sums_.threads(), rest = thread % count;
        return static_cast<std::size_t>(rest < 0 ? rest + count : rest);
    }
    Vec3f sum(float t) const {
        const int thread = floored(t);
        const std::size_t k = index(thread);
        return sums_.sums[k] + (t - static_cast<float>(thread)) * steps_[k];
    }

    SettSums sums_;
    std::vector<Vec3f> steps_, colours_;  // of each thread
};

// Woven cloth seen from its right side: the stripes and single threads of shaders/tartan.glsl, and the relief of the
// yarns as heights.
class WovenCloth {
 public:
    explicit WovenCloth(const sim::Sett& sett) : warp_(sum_warp(sett)), weft_(sum_weft(sett)), weave_(sett.weave) {
        for (int at = 0; at < kPeriod; ++at) seen_[static_cast<std::size_t>(at)] = shows_warp(at);
    }

    // Linear light, mean over a box. t: its middle; width: its sides; both (across the warp, across the weft) in
    // threads.
    Vec3f colour(const Vec2f& t, const Vec2f& width) const {
        const float share = weave_ == sim::Weave::Twill31 ? 0.75F : 0.5F;  // of warp
        Vec3f colour = (1 - share) * weft_.mean(t.y(), width.y()) + share * warp_.mean(t.x(), width.x());
        const float detail = fineness(width.maxCoeff());
        if (detail > 0) colour += detail * crossings(t, width, share);
        return colour.cwiseMax(0.0F);
    }

    // How clearly single threads show in texels of this width, in threads: 1 to 0.
    static float fineness(float width) { return 1 - smoothstep(0.9F, 2.6F, width); }

    // Height of the surface at t, in thread spacings. Yarns are round across, and go down where they end on this side.
    float height(const Vec2f& t) const {
        constexpr float kCrown = 0.25F;  // half of a yarn's diameter when flattened to half of its width
        const int end = floored(t.x()), pick = floored(t.y());
        const Vec2f in(t.x() - float(end), t.y() - float(pick));
        const bool is_warp = is_warp_seen(end, pick);
        const float across = (is_warp ? in.x() : in.y()) - 0.5F, along = is_warp ? in.y() : in.x();
        const int right = is_warp ? 0 : 1, up = is_warp ? 1 : 0;
        const bool dives_before = is_warp_seen(end - right, pick - up) != is_warp;
        const bool dives_after = is_warp_seen(end + right, pick + up) != is_warp;
        const auto cube = [](float x) { return x * x * x; };
        const float down = (dives_before ? cube(1 - along) : 0) + (dives_after ? cube(along) : 0);
        return kCrown * (1 - 4 * across * across) * (1 - down);
    }

 private:
    static constexpr int kPeriod = 4;  // of all weaves, in threads; a power of two

    // at: end minus pick, from 0.
    bool shows_warp(int at) const {
        if (weave_ == sim::Weave::Plain) return at % 2 == 0;
        return at < (weave_ == sim::Weave::Twill22 ? 2 : 3);
    }
    bool is_warp_seen(int end, int pick) const { return seen_[static_cast<std::size_t>((end - pick) & (kPeriod - 1))]; }

    // Difference between the threads that show in the box and the mean mixture of warp and weft.
    Vec3f crossings(const Vec2f& t, const Vec2f& width, float share) const {
        const Vec2f low = t - width / 2, high = t + width / 2;
        const auto covered = [](int thread, float from, float to) {
            return std::max(std::min(float(thread + 1), to) - std::max(float(thread), from), 0.0F) / (to - from);
        };
        const int first = floored(low.x());
        constexpr int kMostEnds = 8;  // threads show in texels of at most 2.6 of them
        std::array<float, kMostEnds> end_shares{};
        int ends = 0;
        for (; float(first + ends) < high.x(); ++ends) {
            SELVEDGE_ASSERT(ends < kMostEnds);
            end_shares[static_cast<std::size_t>(ends)] = covered(first + ends, low.x(), high.x());
        }
        Vec3f detail = Vec3f::Zero();
        for (int pick = floored(low.y()); float(pick) < high.y(); ++pick) {
            const float pick_share = covered(pick, low.y(), high.y());
            const Vec3f& weft = weft_.colour(pick);
            for (int i = 0; i < ends; ++i) {
                const float seen = (is_warp_seen(first + i, pick) ? 1.0F : 0.0F) - share;
                detail +=
                    end_shares[static_cast<std::size_t>(i)] * pick_share * seen * (warp_.colour(first + i) - weft);
            }
        }
        return detail;
    }

    Threads warp_, weft_;
    sim::Weave weave_;
    std::array<bool, kPeriod> seen_{};  // whether the warp shows, by end minus pick
};

class PrintedCloth {
 public:
    explicit PrintedCloth(const ClothPicture& picture)
        : picture_(picture), rows_(picture_rows(picture)), ground_(to_linear(picture.ground)) {}

    // Linear light, mean over the parallelogram about a place on the fabric (m) that these two steps span.
    Vec3f colour(const Vec2f& place, const Vec2f& right, const Vec2f& up) const {
        const float pixel = picture_.size.x() / float(picture_.image->width_px);
        constexpr float kMostSamples = 8;  // along one side
        const int samples =
            static_cast<int>(std::clamp(std::ceil(std::max(right.norm(), up.norm()) / pixel), 1.0F, kMostSamples));
        Vec3f sum = Vec3f::Zero();
        for (int j = 0; j < samples; ++j)
            for (int i = 0; i < samples; ++i)
                sum += at(place + ((float(i) + 0.5F) / float(samples) - 0.5F) * right +
                          ((float(j) + 0.5F) / float(samples) - 0.5F) * up);
        return sum / float(samples * samples);
    }

 private:
    Vec3f pixel(int x, int y) const {
        const Rgba8& colour = picture_.image->at(x, y);
        return to_linear(sim::Rgb8{colour[0], colour[1], colour[2]});
    }

    Vec3f at(const Vec2f& place) const {
        const Vec3f one(place.x(), place.y(), 1);
        Vec2f uv(rows_[0].dot(one), rows_[1].dot(one));
        if (!picture_.is_repeated && (uv.minCoeff() < 0 || uv.maxCoeff() > 1)) return ground_;
        uv -= Vec2f(std::floor(uv.x()), std::floor(uv.y()));
        const int width = picture_.image->width_px, height = picture_.image->height_px;
        const float x = uv.x() * float(width) - 0.5F, y = uv.y() * float(height) - 0.5F;
        const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
        const float right_share = x - float(left), low_share = y - float(top);
        const auto wrap = [&](int i, int count) {
            return picture_.is_repeated ? (i + count) % count : std::clamp(i, 0, count - 1);
        };
        const int x0 = wrap(left, width), x1 = wrap(left + 1, width), y0 = wrap(top, height),
                  y1 = wrap(top + 1, height);
        return (1 - low_share) * ((1 - right_share) * pixel(x0, y0) + right_share * pixel(x1, y0)) +
               low_share * ((1 - right_share) * pixel(x0, y1) + right_share * pixel(x1, y1));
    }

    const ClothPicture& picture_;
    std::array<Vec3f, 2> rows_;
    Vec3f ground_;
};

// The cloth of one panel, by its place on the fabric.
class PanelCloth {
 public:
    explicit PanelCloth(const ClothItem& item)
        : position_(item.sett_position), spacing_(static_cast<float>(item.sett.thread_spacing) * item.sett_scale) {
        if (item.picture) {
            printed_.emplace(*item.picture);
        } else {
            woven_.emplace(item.sett);
        }
    }

    // place: m; right, up: m, from one texel to the next on the fabric.
    Vec3f colour(const Vec2f& place, const Vec2f& right, const Vec2f& up) const {
        if (printed_) return printed_->colour(place, right, up);
        const Vec2f width = (right.cwiseAbs() + up.cwiseAbs()) / spacing_;
        return woven_->colour((place - position_) / spacing_, width);
    }

    bool has_relief(float texel) const { return woven_ && WovenCloth::fineness(texel / spacing_) > 0; }

    // Mean slopes of the surface over the texel, along its sides. Pre: it has relief.
    Vec2f slope(const Vec2f& place, const Vec2f& right, const Vec2f& up) const {
        const Vec2f t = (place - position_) / spacing_, r = right / spacing_, u = up / spacing_;
        const auto rise = [&](const Vec2f& along, const Vec2f& across) {
            constexpr int kSamples = 4;  // of a side
            float sum = 0;
            for (int i = 0; i < kSamples; ++i) {
                const Vec2f aside = ((float(i) + 0.5F) / kSamples - 0.5F) * across;
                sum += woven_->height(t + along / 2 + aside) - woven_->height(t - along / 2 + aside);
            }
            return sum / (kSamples * along.norm());
        };
        return WovenCloth::fineness(r.norm()) * Vec2f(rise(r, u), rise(u, r));
    }

 private:
    Vec2f position_;
    float spacing_;  // m
    std::optional<WovenCloth> woven_;
    std::optional<PrintedCloth> printed_;
};

// A panel's chart in the texture, in texels from the lower left.
struct Rectangle {
    int left, low, right, high;  // right and high are outside
};

Rectangle rectangle_of(const sim::PanelPart& part, const sim::AtlasOptions& atlas) {
    Eigen::AlignedBox2d box;
    for (const Vec2f& u : part.u) box.extend(part.chart->uv(u.cast<double>()));
    const auto texel = [&](double at, int margin) {
        return std::clamp(static_cast<int>(std::lround(at * atlas.size_px)) + margin, 0, atlas.size_px);
    };
    return {texel(box.min().x(), -atlas.margin_px), texel(box.min().y(), -atlas.margin_px),
            texel(box.max().x(), atlas.margin_px), texel(box.max().y(), atlas.margin_px)};
}

std::uint8_t as_byte(float component) {
    return static_cast<std::uint8_t>(std::lround(127.5F + 127.5F * std::clamp(component, -1.0F, 1.0F)));
}

using Srgb = SrgbTable<float, 16384>;  // dark colours too are within half a step of a byte

void bake_panel(const sim::PanelPart& part, const PanelCloth& cloth, const sim::AtlasOptions& atlas, const Srgb& srgb,
                BakedTextures& textures) {
    const Rectangle at = rectangle_of(part, atlas);
    const double texel = 1.0 / atlas.size_px;
    const float c = std::cos(part.grain_angle), s = std::sin(part.grain_angle);
    const auto place_of = [&](double u, double v) -> Vec2f {  // place_on_fabric(), with the grain's sine kept
        const Vec2f material = part.chart->material({u, v}).cast<float>();
        return Vec2f(c * material.x() + s * material.y(), -s * material.x() + c * material.y()) + part.sett_offset;
    };
    const Vec2f origin = place_of(0, 0), right = place_of(texel, 0) - origin, up = place_of(0, texel) - origin;
    const bool has_relief = textures.normal && cloth.has_relief(right.norm());
    constexpr float kReflected = 0.94F, kLeast = 0.008F;  // as the renderer's: even black yarn reflects a little light
    sim::parallel_for(static_cast<std::size_t>(at.high - at.low), 16, [&](std::size_t first, std::size_t last) {
        for (int row = at.low + static_cast<int>(first); row < at.low + static_cast<int>(last); ++row) {
            const int y = atlas.size_px - 1 - row;
            for (int x = at.left; x < at.right; ++x) {
                const Vec2f place = place_of((x + 0.5) * texel, (row + 0.5) * texel);
                const Vec3f colour = kReflected * cloth.colour(place, right, up) + Vec3f::Constant(kLeast);
                textures.base_colour.at(x, y) = {srgb.at(colour.x()), srgb.at(colour.y()), srgb.at(colour.z()), 255};
                if (!has_relief) continue;
                const Vec2f slope = cloth.slope(place, right, up);
                const Vec3f normal = Vec3f(-slope.x(), -slope.y(), 1).normalized();
                textures.normal->at(x, y) = {as_byte(normal.x()), as_byte(normal.y()), as_byte(normal.z()), 255};
            }
        }
    });
}

// The item that holds the panel's triangles.
const ClothItem& cloth_of(const std::string& panel, const std::vector<ClothItem>& cloths) {
    const auto holds = [&](const ClothItem& cloth) {
        for (std::size_t t = 0; t < cloth.mesh.triangles.size(); ++t) {
            const std::size_t p = panel_of(cloth.mesh, t);
            if (p < cloth.mesh.panel_names.size() && cloth.mesh.panel_names[p] == panel) return true;
        }
        return false;
    };
    const auto found = std::ranges::find_if(cloths, holds);
    return found == cloths.end() ? cloths.front() : *found;
}

}  // namespace

BakedTextures bake(const sim::DrawMesh& mesh, const std::vector<ClothItem>& cloths, const sim::AtlasOptions& atlas) {
    SELVEDGE_ASSERT(!cloths.empty() && !mesh.u.empty());
    std::vector<sim::PanelPart> parts = split_by_panel(mesh);
    pack_panels(parts, atlas);
    constexpr Rgba8 kFlat{128, 128, 255, 255};
    BakedTextures textures{.base_colour = Image(atlas.size_px, atlas.size_px, {128, 128, 128, 255}),
                           .normal = Image(atlas.size_px, atlas.size_px, kFlat)};
    const Srgb srgb;
    bool has_relief = false;
    for (const sim::PanelPart& part : parts) {
        const PanelCloth cloth(cloth_of(part.name, cloths));
        has_relief = has_relief || cloth.has_relief(static_cast<float>(1 / (part.chart->scale * atlas.size_px)));
        bake_panel(part, cloth, atlas, srgb, textures);
    }
    if (!has_relief) textures.normal.reset();
    return textures;
}

sim::GarmentTextures bake_pngs(const sim::DrawMesh& mesh, const std::vector<ClothItem>& cloths,
                               const sim::AtlasOptions& atlas) {
    if (mesh.u.empty() || mesh.triangles.empty() || cloths.empty()) return {};
    const BakedTextures textures = bake(mesh, cloths, atlas);
    sim::GarmentTextures pngs;
    sim::parallel_for(2, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (i == 0) pngs.base_colour = encode_texture_png(textures.base_colour);
            if (i == 1 && textures.normal) pngs.normal = encode_texture_png(*textures.normal);
        }
    });
    return pngs;
}

}  // namespace selvedge::render
