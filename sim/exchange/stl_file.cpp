#include "sim/exchange/stl_file.h"

#include <cstddef>
#include <cstdint>

#include "sim/exchange/little_endian.h"
#include "sim/exchange/mesh_cache.h"

namespace selvedge::sim {

std::string garment_stl(const DrawMesh& mesh, const GarmentExport&) {
    constexpr std::size_t kText = 80;
    constexpr float kMillimetres = 1000;
    std::string bytes = "Selvedge: millimetres, y up";  // "solid" would announce a text file
    bytes.resize(kText, ' ');
    append_value(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& [a, b, c] : mesh.triangles) {
        // Zero for a triangle without area, as the format has it.
        const Vec3f normal = (mesh.x[b] - mesh.x[a]).cross(mesh.x[c] - mesh.x[a]).stableNormalized();
        append_values(bytes, normal.data(), 3);
        for (const std::uint32_t v : {a, b, c}) append_values(bytes, Vec3f(kMillimetres * mesh.x[v]).data(), 3);
        append_value(bytes, std::uint16_t{0});  // no attributes
    }
    return bytes;
}

std::string body_stl(const Body& body) {
    return garment_stl(body_mesh(body));
}

}  // namespace selvedge::sim
