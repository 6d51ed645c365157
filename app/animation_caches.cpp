#include "app/animation_caches.h"

#include <algorithm>
#include <cstddef>

#include "render/output/baked_textures.h"
#include "sim/core/error.h"
#include "sim/exchange/pc2_file.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::app {
namespace {

bool is_glb(const std::filesystem::path& path) {
    return path.extension() == ".glb";
}

}  // namespace

AnimationCaches::AnimationCaches(const CacheChoice& choice, int frames_per_second, const PictureOptions& picture,
                                 const sim::Animation& animation) {
    if (choice.files.empty()) return;
    const int level = sim::fixed_level_for(animation.cloth(), static_cast<std::size_t>(choice.most_triangles));
    fixed_ = sim::make_fixed_mesh(animation.cloth(), animation.panel_names(), level);
    const sim::DrawMesh body = sim::body_mesh(animation.body());
    sim::CacheOptions options{.frames = static_cast<std::size_t>(animation.frame_count()),
                              .frames_per_second = static_cast<double>(frames_per_second),
                              .binds_garment = choice.binds_garment,
                              .atlas = choice.atlas};
    if (choice.has_textures && std::ranges::any_of(choice.files, is_glb)) {
        const std::vector<render::ClothItem> cloths =
            picture.looks->parts({.mesh = fixed_.mesh, .sett = {}}, *picture.pattern);
        options.textures = render::bake_pngs(fixed_.mesh, cloths, choice.atlas);
    }
    for (const std::filesystem::path& path : choice.files) {
        has_body_.push_back(is_glb(path));
        options.bones = is_glb(path) ? &animation.body() : nullptr;
        caches_.push_back(sim::open_mesh_cache(path, fixed_.mesh, options, is_glb(path) ? &body : nullptr));
    }
}

void AnimationCaches::add(const sim::Animation& animation) {
    if (caches_.empty()) return;
    sample(fixed_, animation.cloth(), x_);
    const std::vector<Vec3f> body(animation.body_points().begin(), animation.body_points().end());
    const sim::Pose pose = animation.timeline().pose(animation.seconds());
    for (std::size_t i = 0; i < caches_.size(); ++i)
        caches_[i]->add(x_, has_body_[i] ? body : std::vector<Vec3f>{}, has_body_[i] ? &pose : nullptr);
}

void AnimationCaches::finish() {
    for (const auto& cache : caches_) cache->finish();
}

void check_caches(const std::vector<std::filesystem::path>& files) {
    for (const std::filesystem::path& path : files) {
        if (!sim::is_mesh_cache(path))
            throw sim::InputError(
                path.string(), "",
                "cannot write: a cache's name ends in .pc2 or .glb, or is that of a folder, frames/, for "
                "one .obj file per frame");
    }
}

}  // namespace selvedge::app
