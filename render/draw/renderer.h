#pragma once
// Draws a Scene to a picture: Phong shading per pixel in linear light, a key light with soft shadows, ambient light
// with ambient occlusion, woven tartan, 4x multisampling. The same scene gives the same pixels. Also
// PictureTimes: how long each stage took.  (thesis 3.7)
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "render/gl/context.h"
#include "render/gl/target.h"
#include "render/image/image.h"
#include "render/scene/scene.h"

// Wall-clock time of each stage of drawing a picture, in milliseconds, for benchmarks.

struct GladGLContext;

namespace selvedge::render {

struct PictureTimes {
    double compare = 0;            // detecting what has changed since the last picture
    double ambient_occlusion = 0;  // baking it
    double upload = 0;
    double shadow = 0;  // the key light's depth map
    double mask = 0;    // how much of the key light each pixel receives
    double draw = 0;
    double finish = 0;  // averaging the samples, encoding as sRGB
    double read_back = 0;
};

// Waits for GL, then adds the time since the last lap to a stage. If `times` is null, it does nothing and does not
// wait.
class PartClock {
 public:
    PartClock(const GladGLContext& gl, PictureTimes* times);
    void lap(double PictureTimes::*part);

 private:
    const GladGLContext& gl_;
    PictureTimes* times_;
    std::chrono::steady_clock::time_point last_;
};

struct RenderOptions {
    int width_px = 1024;
    int height_px = 1024;
    int samples = 4;                // per pixel, for multisampling
    int tile_px = 1024;             // largest side of a tile; larger pictures are drawn in several tiles
    int supersample = 1;            // 2: draws at twice the width and height and averages
    PictureTimes* times = nullptr;  // filled if given; GL is then synchronised after each stage
};

// A level's colour in ShowMode::Level; levels above kLevelColours - 1 share the last colour.
inline constexpr int kLevelColours = 8;
sim::Rgb8 level_colour(int level);

// Used by one CPU thread at a time, as all renderers together. It reuses GPU data of the previous scene where the
// content is equal; the result is byte-identical, whatever was drawn before.
class Renderer {
 public:
    // Throws InputError if no GL context can be created (render/gl/context.h).
    explicit Renderer(std::optional<ContextKind> maker = {});
    explicit Renderer(GlContext& shared);  // `shared` must outlive the renderer
    ~Renderer();

    // Draws a picture of any size, in tiles. Throws InputError if the size exceeds the limits of render/image/image.h,
    // or if the context does not support so many samples. Pre: the scene has a triangle; its numbers are finite.
    Image draw(const Scene& scene, const RenderOptions& options = {});

    // Draws the same picture into a texture, at the texture's size; row 0 of the texture is the top row of the picture.
    // Does not restore the GL state. Pre: the texture belongs to this renderer's context.
    void draw(const SceneView& view, PictureTexture& to, const RenderOptions& requested = {});

    const GlContext& context() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace selvedge::render
