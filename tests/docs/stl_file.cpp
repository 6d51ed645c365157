#include "tests/docs/stl_file.h"

#include <array>
#include <cstdint>

namespace selvedge::sim {

// [bytes]
namespace {

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
    bytes.append(static_cast<const char*>(static_cast<const void*>(values)), count * sizeof(T));  // little-endian
}

std::string header(std::size_t triangles) {
    std::string bytes = "Selvedge: metres, y up";
    bytes.resize(80, ' ');
    const auto count = static_cast<std::uint32_t>(triangles);
    append(bytes, &count, 1);
    return bytes;
}

void append_triangle(std::string& bytes, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const Vec3f normal = (b - a).cross(c - a).normalized();
    for (const Vec3f* v : {&normal, &a, &b, &c}) append(bytes, v->data(), 3);
    bytes.append(2, '\0');  // no attributes
}

}  // namespace

std::string garment_stl(const DrawMesh& mesh) {
    std::string bytes = header(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) append_triangle(bytes, mesh.x[a], mesh.x[b], mesh.x[c]);
    return bytes;
}

std::string body_stl(const Body& body) {
    std::string bytes = header(body.triangles.size());
    const auto corner = [&](int v) -> Vec3f { return body.x[static_cast<std::size_t>(v)].cast<float>(); };
    for (const auto& [a, b, c] : body.triangles) append_triangle(bytes, corner(a), corner(b), corner(c));
    return bytes;
}

// [/bytes]

// [row]
const MeshFormat kStl{.extension = ".stl", .garment = garment_stl, .body = body_stl};
// [/row]

}  // namespace selvedge::sim
