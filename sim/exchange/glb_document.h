#pragma once
// The parts of a binary glTF 2.0 file under construction (Khronos, "glTF 2.0 Specification"): accessors with the buffer
// that they refer to, and the pieces of JSON that garments, bodies and animation caches share. Private to sim/exchange.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/json.h"
#include "sim/core/math.h"
#include "sim/exchange/mesh_file.h"

namespace selvedge::sim::glb {

enum class Component : int { UnsignedShort = 5123, UnsignedInt = 5125, Float = 5126 };
enum class Target : int { None = 0, Vertices = 34962, Indices = 34963 };

// The shortest text that reads back as the same float, so that bounds in the JSON equal the floats in the buffer.
Json number(float value);

template <class Vector>
Json numbers(const Vector& v) {
    Json array = Json::array();
    for (const float value : v) array.push_back(number(value));
    return array;
}

// JSON arrays of accessors and buffer views, and the bytes that they refer to. The bytes may be written to a file and
// cleared at any time: offsets continue.
class Document {
 public:
    enum class Kind { Real, Plan };
    // A plan holds no bytes. Its JSON is at least as long as that of a real document with the same accessors, whatever
    // their contents.
    explicit Document(Kind kind = Kind::Real) : is_plan_(kind == Kind::Plan) {}

    // All return the accessor's index.
    // Element: a plain struct of components whose size is a multiple of 4 bytes.
    template <class Element>
    std::size_t add(std::span<const Element> elements, Component component, const char* type, Target target) {
        static_assert(sizeof(Element) % 4 == 0);
        append({reinterpret_cast<const char*>(elements.data()), elements.size_bytes()});
        return describe(elements.size(), sizeof(Element), component, type, target);
    }
    std::size_t add_vectors(std::span<const Vec3f> v) { return add(v, Component::Float, "VEC3", Target::Vertices); }
    std::size_t add_positions(std::span<const Vec3f> x);  // with bounds
    std::size_t add_indices(std::span<const std::array<std::uint32_t, 3>> triangles);
    std::size_t add_numbers(std::span<const float> values, Target target = Target::None);
    std::size_t add_times(std::span<const float> ascending);  // s, with bounds

    // Values of which most are zero: those that `is_kept`, in their order, if that takes less room; else as
    // add_vectors() and add_numbers(). Bounds: of positions.
    enum class Bounds { None, Given };
    std::size_t add_sparse(std::span<const Vec3f> values, const std::vector<bool>& is_kept, Bounds bounds);
    std::size_t add_sparse(std::span<const float> values, const std::vector<bool>& is_kept);

    // A view without an accessor, for a file within the file. Returns the view's index.
    std::size_t add_file(std::string_view bytes);

    // In a plan only: the most that add_sparse() adds for so many, of which no more are kept than that takes less room.
    std::size_t plan_sparse_vectors(std::size_t count, Bounds bounds);
    std::size_t plan_sparse_numbers(std::size_t count, std::size_t kept);
    std::size_t plan_numbers(std::size_t count);
    std::size_t plan(std::size_t count, std::size_t bytes_each, Component component, const char* type);
    static Json longest_number();

    std::uint64_t size() const { return size_; }           // of all bytes so far
    const std::string& buffer() const { return buffer_; }  // bytes since the last clear_buffer()
    void clear_buffer() { buffer_.clear(); }

    // Moves accessors, views and the buffer's length into the root, and returns its text.
    std::string finish(Json root);

 private:
    void append(std::string_view bytes) {
        if (!is_plan_) buffer_ += bytes;
    }
    // The index of a new view.
    std::size_t add_view(std::uint64_t bytes, Target target);
    std::size_t describe_sparse(std::size_t count, std::size_t kept, std::size_t indices, std::size_t values,
                                const char* type);
    template <class Element>
    std::size_t add_kept(std::span<const Element> values, const std::vector<bool>& is_kept, std::size_t kept,
                         const char* type);
    std::size_t describe(std::size_t count, std::size_t bytes_each, Component component, const char* type,
                         Target target);
    void set_bounds(std::size_t accessor, Json low, Json high);
    Json longest_bounds() const;

    Json accessors_ = Json::array();
    Json views_ = Json::array();
    std::string buffer_;
    std::uint64_t size_ = 0;
    bool is_plan_;
};

// The bytes of a file. Pre: no bytes of the document were cleared.
std::string container(Json root, Document document);

Json root_object();
Json scene_of(std::vector<Json> nodes);

// Each panel has a material with its name, because most programs show no other name for a primitive.
void add_panel_materials(const std::vector<PanelPart>& parts, Json& materials);

// Puts the pictures into the file, and has all these materials show them over TEXCOORD_0.
void add_textures(const GarmentTextures& textures, Json& materials, Json& root, Document& document);

// The rows of `values` that belong to the vertices of the part; normals are turned to the part's right side.
std::vector<Vec3f> positions_of(const PanelPart& part, const std::vector<Vec3f>& x);
std::vector<Vec3f> normals_of(const PanelPart& part, const std::vector<Vec3f>& normals);

// TEXCOORD_0: the packed texture coordinates, if the part has a chart; then the material coordinates, if it has any.
Json panel_primitive(const PanelPart& part, std::size_t material, const std::vector<Vec3f>& x,
                     const std::vector<Vec3f>& normals, Document& document);

}  // namespace selvedge::sim::glb
