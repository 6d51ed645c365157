#include "sim/repair/plain_gltf.h"

#include <meshoptimizer.h>
#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>

#include "sim/core/error.h"
#include "sim/repair/gltf_file.h"

namespace selvedge::sim {
namespace {

using gltf::element;
using gltf::index_of;
using gltf::member;

constexpr std::string_view kMeshopt = "EXT_meshopt_compression", kQuantization = "KHR_mesh_quantization",
                           kDraco = "KHR_draco_mesh_compression";
constexpr std::size_t kMostBytes = std::size_t(256) << 20;  // of all buffers together

// Draco is assimp's to read. Materials, textures and lights change no shape, nor do the avatars' extensions of VRM.
bool is_read_or_harmless(std::string_view extension) {
    constexpr std::array<std::string_view, 3> kRead{kMeshopt, kQuantization, kDraco};
    constexpr std::array<std::string_view, 8> kHarmless{"KHR_materials_", "KHR_texture_", "EXT_texture_",
                                                        "MSFT_texture_",  "KHR_lights_",  "EXT_lights_",
                                                        "KHR_xmp",        "VRM"};
    return std::ranges::find(kRead, extension) != kRead.end() ||
           std::ranges::any_of(kHarmless, [&](std::string_view start) { return extension.starts_with(start); });
}

std::string place_of(std::string_view list, std::size_t index) {
    return std::string(list) + "[" + std::to_string(index) + "]";
}

std::size_t length_of(const Json* list) {
    return list && list->is_array() ? list->elements().size() : 0;
}

// What a whole number of the type stands for where it is normalized (glTF 2.0, 3.6.2.2).
double largest_of(std::size_t type) {
    switch (type) {
        case gltf::Numbers::kByte:
            return 127;
        case gltf::Numbers::kUnsignedByte:
            return 255;
        case gltf::Numbers::kShort:
            return 32767;
        case gltf::Numbers::kUnsignedShort:
            return 65535;
        default:
            return 4294967295.0;
    }
}

struct Packed {
    std::string mode, filter;
    std::size_t count = 0, stride = 0;
    std::string_view bytes;
};

// Whether the view's elements are such that meshoptimizer may be asked for them.
bool is_possible(const Packed& packed) {
    constexpr std::size_t kLongest = 256;
    const bool is_vector = packed.stride > 0 && packed.stride % 4 == 0 && packed.stride <= kLongest;
    const bool is_index = packed.stride == 2 || packed.stride == 4;
    if (packed.mode == "ATTRIBUTES") {
        if (packed.filter == "OCTAHEDRAL") return packed.stride == 4 || packed.stride == 8;
        if (packed.filter == "QUATERNION") return packed.stride == 8;
        return is_vector && (packed.filter == "NONE" || packed.filter == "EXPONENTIAL");
    }
    if (packed.filter != "NONE" || !is_index) return false;
    return packed.mode == "INDICES" || (packed.mode == "TRIANGLES" && packed.count % 3 == 0);
}

// Pre: is_possible(). nullopt: the bytes are broken.
std::optional<std::string> unpacked(const Packed& packed) {
    std::string bytes(packed.count * packed.stride, '\0');
    const auto* from = reinterpret_cast<const unsigned char*>(packed.bytes.data());
    const std::size_t count = packed.count, stride = packed.stride, size = packed.bytes.size();
    int problem = 0;
    if (packed.mode == "ATTRIBUTES") problem = meshopt_decodeVertexBuffer(bytes.data(), count, stride, from, size);
    if (packed.mode == "TRIANGLES") problem = meshopt_decodeIndexBuffer(bytes.data(), count, stride, from, size);
    if (packed.mode == "INDICES") problem = meshopt_decodeIndexSequence(bytes.data(), count, stride, from, size);
    if (problem != 0) return std::nullopt;
    if (packed.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(bytes.data(), count, stride);
    if (packed.filter == "QUATERNION") meshopt_decodeFilterQuat(bytes.data(), count, stride);
    if (packed.filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), count, stride);
    return bytes;
}

class PlainGltf {
 public:
    PlainGltf(const std::filesystem::path& path, std::string_view content) : path_(path), file_(path, content) {}

    std::optional<std::string> write() {
        check_extensions();
        if (!is_packed() && whole_accessors(file_.root()).empty()) return std::nullopt;
        const std::string with_plain_views = unpack_views();
        if (whole_accessors(file_.root()).empty()) return with_plain_views;
        gltf::File plain(path_, with_plain_views);
        return with_floats(plain);
    }

 private:
    [[noreturn]] void fail(const std::string& place, const std::string& problem) const {
        throw InputError(path_.string(), place, problem);
    }

    void check_extensions() const {
        const Json* required = file_.root().find("extensionsRequired");
        for (std::size_t i = 0; i < length_of(required); ++i) {
            const Json& name = required->elements()[i];
            if (name.is_string() && !is_read_or_harmless(name.string()))
                fail(place_of("extensionsRequired", i),
                     "the extension '" + name.string() + "' is not read: save the file without it");
        }
    }

    static const Json* packing_of(const Json& view) { return member(member(&view, "extensions"), kMeshopt); }

    bool is_packed() const {
        const Json* views = file_.root().find("bufferViews");
        for (std::size_t i = 0; i < length_of(views); ++i)
            if (packing_of(views->elements()[i])) return true;
        return false;
    }

    // The accessors that assimp takes for floats, and that are whole numbers.
    static std::set<std::size_t> whole_accessors(const Json& root) {
        std::set<std::size_t> found;
        const auto add = [&](const Json* index) {
            const Json* accessor = element(root.find("accessors"), index_of(index));
            const auto type = index_of(member(accessor, "componentType"));
            if (type && *type != gltf::Numbers::kFloat && member(accessor, "bufferView"))
                found.insert(*index_of(index));
        };
        const auto add_attributes = [&](const Json* attributes) {
            if (!attributes || !attributes->is_object()) return;
            for (const Json::Member& one : attributes->members())
                if (one.key == "POSITION" || one.key == "NORMAL" || one.key == "TANGENT" ||
                    one.key.starts_with("TEXCOORD_"))
                    add(&one.value);
        };
        const Json* meshes = root.find("meshes");
        for (std::size_t m = 0; m < length_of(meshes); ++m) {
            const Json* primitives = member(&meshes->elements()[m], "primitives");
            for (std::size_t p = 0; p < length_of(primitives); ++p) {
                const Json& primitive = primitives->elements()[p];
                add_attributes(member(&primitive, "attributes"));
                const Json* targets = member(&primitive, "targets");
                for (std::size_t t = 0; t < length_of(targets); ++t) add_attributes(&targets->elements()[t]);
            }
        }
        const Json* animations = root.find("animations");
        for (std::size_t a = 0; a < length_of(animations); ++a) {
            const Json* samplers = member(&animations->elements()[a], "samplers");
            for (std::size_t s = 0; s < length_of(samplers); ++s) add(member(&samplers->elements()[s], "output"));
        }
        return found;
    }

    Packed packed_of(const Json& packing, std::size_t index) {
        const Json *mode = member(&packing, "mode"), *filter = member(&packing, "filter");
        Packed packed{.mode = mode && mode->is_string() ? mode->string() : "",
                      .filter = filter && filter->is_string() ? filter->string() : "NONE",
                      .count = index_of(member(&packing, "count")).value_or(0),
                      .stride = index_of(member(&packing, "byteStride")).value_or(0),
                      .bytes = {}};
        const auto bytes = file_.view_bytes(&packing);
        if (!bytes) fail(place_of("bufferViews", index), "it does not lie in its buffer");
        packed.bytes = *bytes;
        if (!is_possible(packed)) fail(place_of("bufferViews", index), "such compressed elements are not read");
        return packed;
    }

    // Appends a view's bytes to a buffer, and returns the view of them.
    Json appended(Json view, std::string_view bytes, std::string& buffer, std::size_t index) const {
        if (bytes.size() > kMostBytes - buffer.size())
            fail(place_of("bufferViews", index), "its buffers are larger than 256 MB");
        buffer.append((4 - buffer.size() % 4) % 4, '\0');
        view["buffer"] = 0;
        view["byteOffset"] = buffer.size();
        view["byteLength"] = bytes.size();
        buffer += bytes;
        return view;
    }

    static std::string in_one_buffer(Json root, std::string buffer) {
        Json only = Json::object();
        only["byteLength"] = buffer.size();
        root["buffers"] = Json::array({std::move(only)});
        for (const char* list : {"extensionsRequired", "extensionsUsed"}) {
            Json* names = root.find(list);
            if (!names || !names->is_array()) continue;
            std::erase_if(names->elements(), [](const Json& name) {
                return name.is_string() && (name.string() == kMeshopt || name.string() == kQuantization);
            });
            if (names->elements().empty()) root.erase(list);
        }
        return gltf::glb_of(root, std::move(buffer));
    }

    // The file as a .glb whose buffer views are not compressed.
    std::string unpack_views() {
        Json root = file_.root();
        std::string buffer;
        Json* views = root.find("bufferViews");
        for (std::size_t i = 0; i < length_of(views); ++i) {
            Json& view = views->elements()[i];
            if (const Json* packing = packing_of(view)) {
                const Packed packed = packed_of(*packing, i);
                if (packed.count > kMostBytes / packed.stride)
                    fail(place_of("bufferViews", i), "its buffers are larger than 256 MB");
                const std::optional<std::string> bytes = unpacked(packed);
                if (!bytes) fail(place_of("bufferViews", i), "its compressed bytes are broken");
                if (packed.mode == "ATTRIBUTES") view["byteStride"] = packed.stride;
                view.erase("extensions");
                view = appended(std::move(view), *bytes, buffer, i);
            } else if (const auto bytes = file_.view_bytes(&view)) {
                view = appended(std::move(view), *bytes, buffer, i);
            } else {
                fail(place_of("bufferViews", i), "it does not lie in its buffer");
            }
        }
        return in_one_buffer(std::move(root), std::move(buffer));
    }

    // Pre: a file as unpack_views() writes it.
    std::string with_floats(gltf::File& plain) const {
        Json root = plain.root();
        std::string buffer(plain.buffer(0));
        for (const std::size_t index : whole_accessors(root)) {
            Json& accessor = root.find("accessors")->elements()[index];
            const auto numbers = plain.numbers(&accessor);
            if (!numbers) fail(place_of("accessors", index), "it is sparse, or does not lie in its buffer");
            const Json* flag = accessor.find("normalized");
            const bool is_normalized = flag && flag->is_bool() && flag->boolean();
            const double unit = is_normalized ? 1 / largest_of(numbers->type) : 1;
            std::string bytes;
            if (numbers->count > kMostBytes / (numbers->width * sizeof(float)))
                fail(place_of("accessors", index), "its buffers are larger than 256 MB");
            bytes.reserve(numbers->count * numbers->width * sizeof(float));
            for (std::size_t i = 0; i < numbers->count; ++i) {
                for (std::size_t k = 0; k < numbers->width; ++k) {
                    const double value = numbers->at(i, k) * unit;
                    const auto number = float(is_normalized ? std::max(value, -1.0) : value);
                    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
                }
            }
            Json& views = *root.find("bufferViews");
            accessor["bufferView"] = views.elements().size();
            accessor["componentType"] = gltf::Numbers::kFloat;
            for (const char* key : {"byteOffset", "normalized", "min", "max"}) accessor.erase(key);
            views.push_back(appended(Json::object(), bytes, buffer, views.elements().size()));
        }
        return in_one_buffer(std::move(root), std::move(buffer));
    }

    std::filesystem::path path_;
    gltf::File file_;
};

}  // namespace

std::optional<std::string> plain_gltf(const std::filesystem::path& path, std::string_view content) {
    return PlainGltf(path, content).write();
}

}  // namespace selvedge::sim
