#pragma once
// The caches of an animation for other programs: the garment on a mesh that stays the same, and its body where the
// format has room for it.
#include <filesystem>
#include <memory>
#include <vector>

#include "app/picture.h"
#include "sim/cloth/fixed_mesh.h"
#include "sim/exchange/mesh_cache.h"
#include "sim/session/animation.h"

namespace selvedge::app {

struct CacheChoice {
    std::vector<std::filesystem::path> files;
    int most_triangles = 20'000;
    bool binds_garment = false;  // .glb: the garment goes with the bones
    sim::AtlasOptions atlas;
    bool has_textures = true;
};

class AnimationCaches {
 public:
    // picture: its looks and pattern give the textures of .glb. Throws InputError if a file cannot be written.
    AnimationCaches(const CacheChoice& choice, int frames_per_second, const PictureOptions& picture,
                    const sim::Animation& animation);

    void add(const sim::Animation& animation);
    void finish();

 private:
    sim::FixedMesh fixed_;
    std::vector<std::unique_ptr<sim::MeshCache>> caches_;
    std::vector<bool> has_body_;
    std::vector<Vec3f> x_;
};

// Throws InputError for a file whose name is not one of a cache.
void check_caches(const std::vector<std::filesystem::path>& files);

}  // namespace selvedge::app
