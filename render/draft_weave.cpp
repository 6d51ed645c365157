#include "render/draft_weave.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "render/gl/gl.h"

namespace selvedge {
namespace {

constexpr unsigned kMostTexels = 512;  // each way

int texels_for(const SettSums& sums) {
    return static_cast<int>(std::bit_ceil(std::min(static_cast<unsigned>(sums.threads()), kMostTexels)));
}

Vec3f sum_at(const SettSums& sums, double thread) {
    const auto below = std::min(static_cast<std::size_t>(thread), sums.sums.size() - 2);
    const auto share = static_cast<float>(thread - static_cast<double>(below));
    return (1 - share) * sums.sums[below] + share * sums.sums[below + 1];
}

// Linear light, of `count` equal parts of the repeat.
std::vector<Vec3f> mean_colours(const SettSums& sums, int count) {
    std::vector<Vec3f> colours;
    const double width = double(sums.threads()) / double(count);
    for (int i = 0; i < count; ++i) {
        const Vec3f change = sum_at(sums, width * (i + 1)) - sum_at(sums, width * i);
        colours.emplace_back((sums.mean + change / float(width)).cwiseMax(0));
    }
    return colours;
}

// Linear light to sRGB bytes, by a table: a picture has many texels.
class ByteEncoder {
 public:
    ByteEncoder() {
        for (std::size_t i = 0; i < table_.size(); ++i) {
            const double light = double(i) / double(table_.size() - 1);
            const double encoded = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
            table_[i] = static_cast<std::uint8_t>(std::lround(255 * encoded));
        }
    }
    std::uint8_t operator()(float light) const {
        const float at = std::clamp(light, 0.0F, 1.0F) * float(table_.size() - 1);
        return table_[static_cast<std::size_t>(at + 0.5F)];
    }

 private:
    std::array<std::uint8_t, 4096> table_{};
};

Image weave_of_size(const std::vector<Vec3f>& warp, const std::vector<Vec3f>& weft, float warp_share,
                    const ByteEncoder& encode) {
    Image image(static_cast<int>(warp.size()), static_cast<int>(weft.size()));
    for (std::size_t y = 0; y < weft.size(); ++y) {
        for (std::size_t x = 0; x < warp.size(); ++x) {
            const Vec3f mixed = warp_share * warp[x] + (1 - warp_share) * weft[y];
            image.pixels[y * warp.size() + x] = {encode(mixed.x()), encode(mixed.y()), encode(mixed.z()), 255};
        }
    }
    return image;
}

}  // namespace

std::vector<Image> draft_weave(const Sett& sett) {
    const SettSums warp = sum_warp(sett), weft = sum_weft(sett);
    const float warp_share = sett.weave == Weave::Twill31 ? 0.75F : 0.5F;
    const ByteEncoder encode;
    std::vector<Image> sizes;
    for (int width = texels_for(warp), height = texels_for(weft);; width = (width + 1) / 2, height = (height + 1) / 2) {
        sizes.push_back(weave_of_size(mean_colours(warp, width), mean_colours(weft, height), warp_share, encode));
        if (width == 1 && height == 1) return sizes;
    }
}

Texture upload_draft_weave(const GladGLContext& gl, const std::vector<Image>& sizes) {
    Texture texture(gl);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    for (std::size_t level = 0; level < sizes.size(); ++level) {
        gl.TexImage2D(GL_TEXTURE_2D, static_cast<GLint>(level), GL_RGBA8, sizes[level].width_px, sizes[level].height_px,
                      0, GL_RGBA, GL_UNSIGNED_BYTE, sizes[level].pixels.data());
    }
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(sizes.size()) - 1);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, sizes.size() > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

}  // namespace selvedge
