#pragma once
// The frames of a film of an animation.
#include <filesystem>
#include <optional>
#include <vector>

#include "app/camera_path.h"
#include "app/film.h"
#include "app/picture.h"
#include "render/draw/renderer.h"
#include "sim/session/animation.h"

namespace selvedge::app {

// The camera follows the body over the floor, or stays, and frames the body, or what the garment hangs on, in all its
// poses.
class Filming {
 public:
    struct Options {
        std::filesystem::path file;
        FilmFormat format;
        bool camera_stays = false;
    };

    // picture: outlives this. Throws InputError if the film cannot be written.
    Filming(const Options& options, const PictureOptions& picture, const sim::Animation& animation);

    void add(const sim::Animation& animation);
    void finish() { writer_.finish(); }

 private:
    Vec3f camera_way(double seconds) const;
    std::vector<Vec3f> framed(const sim::Animation& animation, const sim::DrawMesh& garment) const;

    const PictureOptions& picture_;
    render::Renderer renderer_;
    FilmWriter writer_;
    std::optional<CameraPath> path_;  // none: the camera stays
    render::Layout layout_;
};

}  // namespace selvedge::app
