#pragma once
// Scene -> picture. Shading in linear light per pixel (Phong), a key light with soft shadows, the room's light dimmed
// in folds and hollows, woven tartan; 4x multisampled. The same scene gives the same pixels.  (SPEC 6)
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "render/gl/context.h"
#include "render/gl/handle.h"
#include "render/image/image.h"
#include "render/scene/scene.h"

// Where a picture's time goes, for benchmarks: wall clock, in milliseconds.

struct GladGLContext;

namespace selvedge::render {

struct PictureTimes {
    double compare = 0;            // what has changed since the last picture
    double ambient_occlusion = 0;  // baking
    double upload = 0;
    double shadow = 0;  // the key light's depth map
    double mask = 0;    // which pixels see the key light
    double draw = 0;
    double finish = 0;  // resolving samples, encoding
    double read_back = 0;
};

// Charges the time since the last lap to a part, after waiting for GL. Does nothing, and waits for nothing, without
// times to charge.
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
    int samples = 4;                // per pixel, of triangles' edges
    int tile_px = 1024;             // greatest side of what is drawn at once
    int supersample = 1;            // 2: everything is drawn at twice the size and averaged
    PictureTimes* times = nullptr;  // filled when given; the parts then wait for each other
};

// The level's colour in ShowMode::Level; levels beyond the last share it.
inline constexpr int kLevelColours = 8;
sim::Rgb8 level_colour(int level);

// Belongs to one thread; with a context of its own, only one lives at a time. Keeps what a scene has in common with the
// one drawn before, and asks nothing else of it: the same scene has the same bits whatever was drawn before.
class Renderer {
 public:
    // Throws InputError when there is no way to draw (render/gl/context.h).
    explicit Renderer(std::optional<ContextMaker> maker = {});
    explicit Renderer(GlContext& shared);  // which must outlive it
    ~Renderer();

    // Any size: a picture is drawn in tiles. Throws InputError when it is over render/image/image.h's limits, or wants
    // more samples than the context can take. Pre: the scene has a triangle, its numbers are finite.
    Image draw(const Scene& scene, const RenderOptions& options = {});

    // The same picture, of the texture's size, left with GL; the texture's first row is the picture's uppermost. Leaves
    // GL's state as it pleases. Pre: the texture belongs to this renderer's context.
    void draw(const SceneView& view, PictureTexture& to, const RenderOptions& options = {});

    const GlContext& context() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace selvedge::render
