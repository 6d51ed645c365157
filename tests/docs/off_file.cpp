#include "tests/docs/off_file.h"

#include <charconv>
#include <cstddef>
#include <cstdint>

#include "sim/exchange/mesh_cache.h"

namespace selvedge::sim {

// [bytes]
namespace {

// The shortest text that reads back as the same number, in any locale.
template <class Number>
void append(std::string& text, Number number, char separator) {
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
    static_cast<void>(error);  // 32 characters hold any float
    text.append(digits, end) += separator;
}

}  // namespace

std::string garment_off(const DrawMesh& mesh, const GarmentExport&) {
    std::string text = "OFF\n# Selvedge: metres, y up\n";
    append(text, mesh.x.size(), ' ');
    append(text, mesh.triangles.size(), ' ');
    text += "0\n";  // edges: not counted
    for (const Vec3f& x : mesh.x)
        for (std::ptrdiff_t axis = 0; axis < 3; ++axis) append(text, x[axis], axis < 2 ? ' ' : '\n');
    for (const auto& triangle : mesh.triangles) {
        text += "3 ";
        for (std::size_t k = 0; k < 3; ++k) append(text, triangle[k], k < 2 ? ' ' : '\n');
    }
    return text;
}

std::string body_off(const Body& body) {
    return garment_off(body_mesh(body));
}

// [/bytes]

// [row]
const MeshFormat kOff{.extension = ".off", .garment = garment_off, .body = body_off};
// [/row]

}  // namespace selvedge::sim
