#include "sim/exchange/mesh_cache.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <system_error>

#include "sim/core/assert.h"
#include "sim/core/atomic_file.h"
#include "sim/core/error.h"
#include "sim/core/lower_case.h"
#include "sim/exchange/glb_cache.h"
#include "sim/exchange/mesh_file.h"
#include "sim/exchange/pc2_file.h"

namespace selvedge::sim {
namespace {

enum class CacheFormat { None, Pc2, Glb, ObjFrames };

bool is_folder(const std::filesystem::path& path) {
    std::error_code error;
    return !path.empty() && (path.filename().empty() || std::filesystem::is_directory(path, error));
}

// "frames" and "frames/" as "frames/*.obj".
std::filesystem::path pattern_of(const std::filesystem::path& path) {
    return is_folder(path) ? path / "*.obj" : path;
}

CacheFormat format_of(const std::filesystem::path& given) {
    const std::filesystem::path path = pattern_of(given);
    const std::string name = lower_case(path.filename().string());
    if (name.ends_with(".pc2")) return CacheFormat::Pc2;
    if (name.ends_with(".glb")) return CacheFormat::Glb;
    if (name.ends_with(".obj") && std::ranges::count(name, '*') == 1) return CacheFormat::ObjFrames;
    return CacheFormat::None;
}

// OBJ is text, whose size is known only when the first frame has been written.
class ObjFrames final : public MeshCache {
 public:
    ObjFrames(const std::filesystem::path& pattern, const DrawMesh& mesh, const CacheOptions& options)
        : pattern_(pattern_of(pattern)), options_(options), mesh_(mesh) {
        const std::filesystem::path folder = pattern_.parent_path();
        std::error_code error;
        if (!folder.empty()) std::filesystem::create_directories(folder, error);
        if (error) throw InputError(folder.string(), "", "cannot make the folder: " + error.message());
    }

    void add(const std::vector<Vec3f>& garment, const std::vector<Vec3f>& body, const Pose*) override {
        SELVEDGE_ASSERT(garment.size() == mesh_.x.size() && body.empty() && frames_ < options_.frames);
        const int frame = options_.first_frame + static_cast<int>(frames_);
        require_finite(pattern_, frame, garment);
        mesh_.x = garment;
        mesh_.normals = vertex_normals(mesh_.x, mesh_.triangles, mesh_.turned_corners);
        const std::filesystem::path path = frame_path(pattern_, frame);
        write_garment(mesh_, path);
        if (++frames_ > 1) return;
        std::error_code error;
        const std::uintmax_t bytes = std::filesystem::file_size(path, error);
        if (!error) require_free_space(pattern_, bytes * (options_.frames - 1));
    }

    void finish() override { SELVEDGE_ASSERT(frames_ > 0); }

 private:
    std::filesystem::path pattern_;
    CacheOptions options_;
    DrawMesh mesh_;
    std::size_t frames_ = 0;
};

}  // namespace

std::unique_ptr<MeshCache> open_mesh_cache(const std::filesystem::path& path, const DrawMesh& garment,
                                           const CacheOptions& options, const DrawMesh* body) {
    SELVEDGE_ASSERT(options.frames > 0 && options.frames_per_second > 0);
    const CacheFormat format = format_of(path);
    if (format == CacheFormat::None)
        throw InputError(path.string(), "", "not an animation cache: use .pc2, .glb or a folder, frames/");
    if (body != nullptr && format != CacheFormat::Glb)
        throw InputError(path.string(), "", "holds one mesh: a body goes with a garment only into .glb");
    if (garment.triangles.empty() || (body != nullptr && body->triangles.empty()))
        throw InputError(path.string(), "", "not written: there are no triangles");
    if (format == CacheFormat::Glb) return open_glb_cache(path, garment, options, body);
    if (format == CacheFormat::Pc2) return open_pc2_cache(path, garment, options);
    return std::make_unique<ObjFrames>(path, garment, options);
}

bool is_mesh_cache(const std::filesystem::path& path) {
    return format_of(path) != CacheFormat::None;
}

std::filesystem::path frame_path(const std::filesystem::path& path, int frame) {
    const std::filesystem::path pattern = pattern_of(path);
    std::string name = pattern.filename().string(), number = std::to_string(std::abs(frame));
    if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
    if (frame < 0) number.insert(0, 1, '-');
    const std::size_t at = name.find('*');
    SELVEDGE_ASSERT(at != std::string::npos);
    return pattern.parent_path() / name.replace(at, 1, number);
}

DrawMesh body_mesh(const Body& body) {
    DrawMesh mesh;
    for (const Vec3d& p : body.x) mesh.x.push_back(p.cast<float>());
    for (const auto& [a, b, c] : body.triangles)
        mesh.triangles.push_back({std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)});
    mesh.panel_names = {"body"};
    mesh.normals = vertex_normals(mesh.x, mesh.triangles);
    return mesh;
}

void require_finite(const std::filesystem::path& path, int frame, const std::vector<Vec3f>& x) {
    const auto bad = std::ranges::find_if(x, [](const Vec3f& p) { return !p.allFinite(); });
    if (bad == x.end()) return;
    throw InputError(path.string(), "frame " + std::to_string(frame) + ", vertex " + std::to_string(bad - x.begin()),
                     "not written: it is not finite");
}

}  // namespace selvedge::sim
