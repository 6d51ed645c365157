#include "sim/exchange/stl_file.h"

#include <cstddef>
#include <cstdint>
#include <string>

#include "sim/exchange/little_endian.h"
#include "sim/exchange/mesh_cache.h"

namespace selvedge::sim {

namespace {

void append_triangles(std::string& bytes, const DrawMesh& mesh) {
    constexpr float kMillimetres = 1000;
    for (const auto& [a, b, c] : mesh.triangles) {
        // Zero for a triangle without area, as the format has it.
        const Vec3f normal = (mesh.x[b] - mesh.x[a]).cross(mesh.x[c] - mesh.x[a]).stableNormalized();
        append_values(bytes, normal.data(), 3);
        for (const std::uint32_t v : {a, b, c}) append_values(bytes, Vec3f(kMillimetres * mesh.x[v]).data(), 3);
        append_value(bytes, std::uint16_t{0});  // no attributes
    }
}

}  // namespace

std::string garment_stl(const DrawMesh& mesh, const GarmentExport& content) {
    constexpr std::size_t kText = 80;
    const DrawMesh body = content.body != nullptr ? body_mesh(*content.body) : DrawMesh{};
    const std::string cloth = std::to_string(mesh.triangles.size());
    std::string bytes = "Selvedge: millimetres, y up";  // "solid" would announce a text file
    if (content.body != nullptr) bytes += "; cloth: first " + cloth + " triangles, then the body";
    bytes.resize(kText, ' ');
    append_value(bytes, static_cast<std::uint32_t>(mesh.triangles.size() + body.triangles.size()));
    append_triangles(bytes, mesh);
    append_triangles(bytes, body);
    return bytes;
}

std::string body_stl(const Body& body) {
    return garment_stl(body_mesh(body));
}

}  // namespace selvedge::sim
