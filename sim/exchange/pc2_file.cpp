#include "sim/exchange/pc2_file.h"

#include <array>
#include <bit>
#include <cstdint>
#include <string>

#include "sim/core/assert.h"
#include "sim/core/atomic_file.h"
#include "sim/core/error.h"
#include "sim/exchange/mesh_file.h"

namespace selvedge::sim {
namespace {

static_assert(std::endian::native == std::endian::little, "PC2 is little-endian");
static_assert(sizeof(Vec3f) == 3 * sizeof(float));

constexpr std::size_t kSamplesAt = 28;
constexpr std::size_t kHeader = 32;

template <class T>
std::string_view bytes_of(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string header(std::size_t points, const CacheOptions& options) {
    std::string bytes("POINTCACHE2\0", 12);
    bytes += bytes_of(std::int32_t{1});
    bytes += bytes_of(static_cast<std::int32_t>(points));
    bytes += bytes_of(static_cast<float>(options.first_frame));
    bytes += bytes_of(1.0F);
    bytes += bytes_of(std::int32_t{0});
    SELVEDGE_ASSERT(bytes.size() == kHeader);
    return bytes;
}

const std::filesystem::path& checked(const std::filesystem::path& path, const DrawMesh& mesh,
                                     const CacheOptions& options) {
    if (mesh.x.size() > INT32_MAX || options.frames > INT32_MAX)
        throw InputError(path.string(), "",
                         std::to_string(options.frames) + " frames of " + std::to_string(mesh.x.size()) +
                             " vertices: a .pc2 file counts to 2147483647");
    require_free_space(path, kHeader + std::uint64_t{options.frames} * mesh.x.size() * sizeof(Vec3f));
    return path;
}

class Pc2Cache final : public MeshCache {
 public:
    Pc2Cache(const std::filesystem::path& path, const DrawMesh& mesh, const CacheOptions& options)
        : mesh_(mesh), options_(options), file_(checked(path, mesh, options), TemporaryName::Random) {
        file_.append(header(mesh.x.size(), options));
    }

    void add(const std::vector<Vec3f>& garment, const std::vector<Vec3f>& body, const Pose*) override {
        SELVEDGE_ASSERT(garment.size() == mesh_.x.size() && body.empty() && samples_ < options_.frames);
        require_finite(file_.path(), options_.first_frame + static_cast<int>(samples_), garment);
        if (samples_ == 0) {
            mesh_.x = garment;
            mesh_.normals = vertex_normals(mesh_.x, mesh_.triangles, mesh_.turned_corners);
        }
        file_.append({reinterpret_cast<const char*>(garment.data()), garment.size() * sizeof(Vec3f)});
        file_.overwrite(kSamplesAt, bytes_of(static_cast<std::int32_t>(++samples_)));
    }

    void finish() override {
        SELVEDGE_ASSERT(samples_ > 0);
        write_garment(mesh_, mesh_beside(file_.path()));
        file_.commit();
    }

 private:
    DrawMesh mesh_;  // of the first frame
    CacheOptions options_;
    std::size_t samples_ = 0;
    AtomicFile file_;
};

}  // namespace

std::unique_ptr<MeshCache> open_pc2_cache(const std::filesystem::path& path, const DrawMesh& mesh,
                                          const CacheOptions& options) {
    return std::make_unique<Pc2Cache>(path, mesh, options);
}

std::filesystem::path mesh_beside(const std::filesystem::path& cache) {
    return std::filesystem::path(cache).replace_extension(".obj");
}

}  // namespace selvedge::sim
