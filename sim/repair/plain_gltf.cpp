#include "sim/repair/plain_gltf.h"

#include <meshoptimizer.h>
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/glb_container.h"
#include "sim/core/printable.h"
#include "sim/repair/gltf_file.h"

namespace selvedge::sim {
namespace {

using gltf::element;
using gltf::index_of;
using gltf::member;

constexpr std::string_view kMeshopt = "EXT_meshopt_compression", kQuantization = "KHR_mesh_quantization";
constexpr std::size_t kMostBytes = std::size_t(256) << 20;  // of all buffers together

// Extensions of glTF that say what the shape is, or that pack it in a way that neither assimp nor we read.
bool changes_shape_unread(std::string_view extension) {
    constexpr std::array<std::string_view, 5> kNames{"EXT_mesh_gpu_instancing", "KHR_meshopt_compression",
                                                     "KHR_gaussian_splatting", "KHR_node_visibility", "MSFT_lod"};
    return std::ranges::find(kNames, extension) != kNames.end();
}

std::string place_of(std::string_view list, std::size_t index) {
    return std::string(list) + "[" + std::to_string(index) + "]";
}

std::size_t length_of(const Json* list) {
    return list && list->is_array() ? list->elements().size() : 0;
}

// The whole number that stands for 1 where it is normalized (glTF 2.0, 3.6.2.2; of 32 bits not allowed there).
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

struct Unpacked {
    std::optional<std::string> bytes{};
    std::size_t stride = 0;  // of vertices; 0: indices
    std::string problem{};   // why there are no bytes
};

std::string text_or(const Json* value, const char* absent) {
    if (!value) return absent;
    return value->is_string() ? value->string() : "";
}

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
        check_skins();
        check_depth();
        const bool are_whole = !whole_accessors(file_.root()).empty();
        if (!is_packed() && !are_whole && skins_without_binds(file_.root()).empty() && !has_escaped_name())
            return std::nullopt;
        check_buffers();
        unpack_views();
        if (are_whole) write_floats();
        write_binds();
        return in_one_buffer();
    }

 private:
    [[noreturn]] void fail(const std::string& place, const std::string& problem) const {
        throw InputError(path_.string(), place, problem);
    }

    void check_extensions() const {
        const Json* required = file_.root().find("extensionsRequired");
        for (std::size_t i = 0; i < length_of(required); ++i) {
            const Json& name = required->elements()[i];
            if (name.is_string() && changes_shape_unread(name.string()))
                fail(place_of("extensionsRequired", i),
                     "the extension '" + name.string() + "' is not read: save the file without it");
        }
    }

    // assimp crashes without joints, and takes room for all that are named.
    void check_skins() const {
        constexpr std::size_t kMostJoints = 65536;  // vertices name them by 16 bits
        const Json* skins = file_.root().find("skins");
        for (std::size_t i = 0; i < length_of(skins); ++i) {
            const Json* joints = member(&skins->elements()[i], "joints");
            if (!joints || !joints->is_array()) fail(place_of("skins", i), "it has no joints");
            if (length_of(joints) > kMostJoints) fail(place_of("skins", i), "it has more than 65536 joints");
        }
    }

    static const Json* packing_of(const Json& view) { return member(member(&view, "extensions"), kMeshopt); }

    bool is_packed() const {
        const Json* views = file_.root().find("bufferViews");
        for (std::size_t i = 0; i < length_of(views); ++i)
            if (packing_of(views->elements()[i])) return true;
        return false;
    }

    // The accessors that assimp takes for floats, and that are whole numbers; true: positions.
    static std::map<std::size_t, bool> whole_accessors(const Json& root) {
        std::map<std::size_t, bool> found;
        const auto add = [&](const Json* index, bool is_position) {
            const Json* accessor = element(root.find("accessors"), index_of(index));
            const auto type = index_of(member(accessor, "componentType"));
            if (type && *type != gltf::Numbers::kFloat && member(accessor, "bufferView"))
                found[*index_of(index)] |= is_position;
        };
        const Json* meshes = root.find("meshes");
        for (std::size_t m = 0; m < length_of(meshes); ++m) {
            const Json* primitives = member(&meshes->elements()[m], "primitives");
            for (std::size_t p = 0; p < length_of(primitives); ++p) {
                const Json* attributes = member(&primitives->elements()[p], "attributes");
                if (!attributes || !attributes->is_object()) continue;
                for (const Json::Member& one : attributes->members()) {
                    if (one.key == "POSITION" || one.key == "NORMAL" || one.key == "TANGENT" ||
                        one.key.starts_with("TEXCOORD_") || one.key.starts_with("WEIGHTS_"))
                        add(&one.value, one.key == "POSITION");
                }
            }
        }
        const Json* animations = root.find("animations");
        for (std::size_t a = 0; a < length_of(animations); ++a) {
            const Json* samplers = member(&animations->elements()[a], "samplers");
            for (std::size_t s = 0; s < length_of(samplers); ++s)
                add(member(&samplers->elements()[s], "output"), false);
        }
        return found;
    }

    // assimp goes down the nodes by recursion, and has no more stack at some depth. Nodes in a circle are not looked
    // at.
    void check_depth() const {
        constexpr std::size_t kDeepest = 4096;
        const Json* nodes = file_.root().find("nodes");
        const std::size_t count = length_of(nodes);
        std::vector<std::vector<std::size_t>> children(count);
        std::vector<bool> is_child(count), is_seen(count);
        for (std::size_t i = 0; i < count; ++i) {
            const Json* list = member(&nodes->elements()[i], "children");
            for (std::size_t k = 0; k < length_of(list); ++k) {
                const auto child = index_of(&list->elements()[k]);
                if (!child || *child >= count) continue;
                children[i].push_back(*child);
                is_child[*child] = true;
            }
        }
        std::vector<std::pair<std::size_t, std::size_t>> open;  // a node, and how many lie above it
        for (std::size_t i = 0; i < count; ++i)
            if (!is_child[i]) open.emplace_back(i, 0);
        while (!open.empty()) {
            const auto [node, depth] = open.back();
            open.pop_back();
            if (depth > kDeepest) fail(place_of("nodes", node), "more than 4096 nodes lie above it");
            if (is_seen[node]) continue;
            is_seen[node] = true;
            for (const std::size_t child : children[node]) open.emplace_back(child, depth + 1);
        }
    }

    // The name of the file of a buffer; null: it is in this file.
    static const Json* name_of(const Json& buffer) {
        const Json* name = member(&buffer, "uri");
        return name && name->is_string() && !name->string().starts_with("data:") ? name : nullptr;
    }

    // assimp opens no file whose name is escaped, as "a%20body.bin".
    bool has_escaped_name() const {
        const Json* buffers = file_.root().find("buffers");
        for (std::size_t i = 0; i < length_of(buffers); ++i) {
            const Json* name = name_of(buffers->elements()[i]);
            if (name && name->string().find('%') != std::string::npos) return true;
        }
        return false;
    }

    // One for readers that cannot unpack the compressed one may be absent.
    void check_buffers() {
        const Json* buffers = file_.root().find("buffers");
        for (std::size_t i = 0; i < length_of(buffers); ++i) {
            const Json* name = name_of(buffers->elements()[i]);
            if (name && !packing_of(buffers->elements()[i]) && file_.buffer(i).empty())
                fail(place_of("buffers", i), "its file '" + printable(name->string()) + "' cannot be read");
        }
    }

    // Skins whose inverse bind matrices are left out, since all are the identity: assimp crashes at them.
    static std::vector<std::size_t> skins_without_binds(const Json& root) {
        std::vector<std::size_t> found;
        const Json* skins = root.find("skins");
        for (std::size_t i = 0; i < length_of(skins); ++i) {
            const Json& skin = skins->elements()[i];
            if (length_of(member(&skin, "joints")) > 0 && !member(&skin, "inverseBindMatrices")) found.push_back(i);
        }
        return found;
    }

    Unpacked unpack(const Json& packing, const Json& view) {
        const auto count = index_of(member(&packing, "count")), stride = index_of(member(&packing, "byteStride"));
        const auto bytes = file_.view_bytes(&packing);
        if (!bytes) return {.problem = "it does not lie in its buffer"};
        const Packed packed{.mode = text_or(member(&packing, "mode"), ""),
                            .filter = text_or(member(&packing, "filter"), "NONE"),
                            .count = count.value_or(0),
                            .stride = stride.value_or(0),
                            .bytes = *bytes};
        if (!count || !is_possible(packed)) return {.problem = "such compressed elements are not read"};
        if (packed.count > kMostBytes / packed.stride) return {.problem = "its buffers are larger than 256 MB"};
        if (index_of(member(&view, "byteLength")) != packed.count * packed.stride)
            return {.problem = "its length is not that of its compressed elements"};
        Unpacked out{.bytes = unpacked(packed), .stride = packed.mode == "ATTRIBUTES" ? packed.stride : 0};
        if (!out.bytes) out.problem = "its compressed bytes are broken";
        return out;
    }

    // Appends a view's bytes to the buffer, and returns the view of them.
    Json appended(Json view, std::string_view bytes, std::size_t index) {
        buffer_.append((4 - buffer_.size() % 4) % 4, '\0');
        if (buffer_.size() > kMostBytes || bytes.size() > kMostBytes - buffer_.size())
            fail(place_of("bufferViews", index), "its buffers are larger than 256 MB");
        view["buffer"] = 0;
        view["byteOffset"] = buffer_.size();
        view["byteLength"] = bytes.size();
        buffer_ += bytes;
        return view;
    }

    std::string in_one_buffer() {
        Json only = Json::object();
        only["byteLength"] = buffer_.size();
        root_["buffers"] = Json::array({std::move(only)});
        for (const char* list : {"extensionsRequired", "extensionsUsed"}) {
            Json* names = root_.find(list);
            if (!names || !names->is_array()) continue;
            std::erase_if(names->elements(), [](const Json& name) {
                return name.is_string() && (name.string() == kMeshopt || name.string() == kQuantization);
            });
            if (names->elements().empty()) root_.erase(list);
        }
        return glb::container(write_json(root_, -1), buffer_);
    }

    // Nothing reads morph targets, and their numbers may be of any kind.
    void drop_targets() {
        Json* meshes = root_.find("meshes");
        for (std::size_t m = 0; m < length_of(meshes); ++m) {
            Json& mesh = meshes->elements()[m];
            if (!mesh.is_object()) continue;
            Json* primitives = mesh.find("primitives");
            for (std::size_t p = 0; p < length_of(primitives); ++p) {
                Json& primitive = primitives->elements()[p];
                if (primitive.is_object()) primitive.erase("targets");
            }
            mesh.erase("weights");
        }
    }

    // All buffer views in one buffer, none compressed. One that lies in no buffer becomes empty.
    void unpack_views() {
        root_ = file_.root();
        drop_targets();
        Json* views = root_.find("bufferViews");
        for (std::size_t i = 0; i < length_of(views); ++i) {
            Json& view = views->elements()[i];
            if (!view.is_object()) fail(place_of("bufferViews", i), "it is no object");
            const Json* packing = packing_of(view);
            const Unpacked out = packing && packing->is_object() ? unpack(*packing, view) : Unpacked{};
            const auto own = file_.view_bytes(&view);  // of what is compressed too: for readers that cannot unpack it
            if (!out.bytes && own.value_or("").empty() && !out.problem.empty())
                fail(place_of("bufferViews", i), out.problem);
            if (out.bytes && out.stride > 0) view["byteStride"] = out.stride;
            view.erase("extensions");
            view = appended(std::move(view), out.bytes ? std::string_view(*out.bytes) : own.value_or(""), i);
        }
    }

    // nullopt: the accessor is broken, sparse, or does not lie in its view.
    static std::optional<std::string> floats_of(gltf::File& plain, const Json& accessor) {
        const auto numbers = plain.numbers(&accessor);
        const Json* flag = accessor.find("normalized");
        const bool is_normalized = flag && flag->is_bool() && flag->boolean();
        if (!numbers || (flag && !flag->is_bool())) return std::nullopt;
        if (numbers->count > kMostBytes / (numbers->width * sizeof(float))) return std::nullopt;
        const double unit = is_normalized ? 1 / largest_of(numbers->type) : 1;
        std::string bytes;
        bytes.reserve(numbers->count * numbers->width * sizeof(float));
        for (std::size_t i = 0; i < numbers->count; ++i) {
            for (std::size_t k = 0; k < numbers->width; ++k) {
                const double value = numbers->at(i, k) * unit;
                const auto number = float(is_normalized ? std::max(value, -1.0) : value);
                bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
            }
        }
        return bytes;
    }

    // Pre: unpack_views().
    void write_floats() {
        const std::string whole_numbers = buffer_;
        gltf::File plain(root_, whole_numbers);
        for (const auto& [index, is_position] : whole_accessors(root_)) {
            Json& accessor = root_.find("accessors")->elements()[index];
            const std::optional<std::string> bytes = floats_of(plain, accessor);
            if (!bytes && is_position)
                fail(place_of("accessors", index), "it is broken, sparse, or does not lie in its view");
            if (!bytes) continue;
            accessor["bufferView"] = add_view(*bytes);
            accessor["componentType"] = gltf::Numbers::kFloat;
            for (const char* key : {"byteOffset", "normalized", "min", "max"}) accessor.erase(key);
        }
    }

    // Pre: unpack_views(). The skins share one list, as long as the longest asks.
    void write_binds() {
        const std::vector<std::size_t> without = skins_without_binds(root_);
        if (without.empty()) return;
        const std::size_t index_of_binds = list_of("accessors").elements().size();
        std::size_t count = 0;
        for (const std::size_t index : without) {
            Json& skin = root_.find("skins")->elements()[index];
            count = std::max(count, length_of(skin.find("joints")));
            skin["inverseBindMatrices"] = index_of_binds;
        }
        constexpr std::array<float, 16> kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        std::string bytes;
        for (std::size_t i = 0; i < count; ++i)
            bytes.append(reinterpret_cast<const char*>(kIdentity.data()), sizeof kIdentity);
        Json accessor = Json::object();
        accessor["bufferView"] = add_view(bytes);
        accessor["componentType"] = gltf::Numbers::kFloat;
        accessor["count"] = count;
        accessor["type"] = "MAT4";
        list_of("accessors").push_back(std::move(accessor));
    }

    // A list of the root, which may be absent.
    Json& list_of(const char* name) {
        Json& list = root_[name];
        if (!list.is_array()) list = Json::array();
        return list;
    }

    // The index of a new view of these bytes.
    std::size_t add_view(std::string_view bytes) {
        Json& views = list_of("bufferViews");
        const std::size_t index = views.elements().size();
        views.push_back(appended(Json::object(), bytes, index));
        return index;
    }

    std::filesystem::path path_;
    gltf::File file_;
    Json root_;           // of the file that is written
    std::string buffer_;  // its only one
};

}  // namespace

std::optional<std::string> plain_gltf(const std::filesystem::path& path, std::string_view content) {
    std::optional<PlainGltf> file;
    try {
        file.emplace(path, content);
    } catch (const InputError&) {
        return std::nullopt;  // what is no JSON to us may be so to assimp, as with names that are not UTF-8
    }
    return file->write();
}

}  // namespace selvedge::sim
