#include "sim/repair/gltf_skins.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/json.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kMostBytes = std::size_t(256) << 20;  // of a file of buffers

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    if (at + sizeof word <= bytes.size()) std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

struct Chunks {
    std::string_view json;
    std::string_view binary;  // of a .glb
};

Chunks split(std::string_view content) {
    constexpr std::size_t kHeader = 12, kChunkHeader = 8;
    constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
    if (!content.starts_with("glTF")) return {.json = content, .binary = {}};
    Chunks chunks;
    for (std::size_t at = kHeader; at + kChunkHeader <= content.size();) {
        const std::size_t length = word_at(content, at);
        const std::string_view chunk = content.substr(at + kChunkHeader, length);
        const std::uint32_t type = word_at(content, at + 4);
        if (type == kJson && chunks.json.empty()) chunks.json = chunk;
        if (type == kBinary && chunks.binary.empty()) chunks.binary = chunk;
        at += kChunkHeader + length;
    }
    return chunks;
}

std::string from_base64(std::string_view text) {
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        int digit = 63;
        if (c >= 'A' && c <= 'Z') {
            digit = c - 'A';
        } else if (c >= 'a' && c <= 'z') {
            digit = c - 'a' + 26;
        } else if (c >= '0' && c <= '9') {
            digit = c - '0' + 52;
        } else if (c == '+') {
            digit = 62;
        } else if (c != '/') {
            break;
        }
        bits = bits << 6 | std::uint32_t(digit);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += char(bits >> count & 0xFF);
    }
    return bytes;
}

// Members of a JSON value, which may be anything.
const Json* member(const Json* value, std::string_view key) {
    return value ? value->find(key) : nullptr;
}

const Json* element(const Json* value, std::optional<std::size_t> index) {
    if (!value || !value->is_array() || !index || *index >= value->elements().size()) return nullptr;
    return &value->elements()[*index];
}

std::optional<std::size_t> index_of(const Json* value) {
    constexpr double kMost = 4e9;
    if (!value || !value->is_number() || !(value->number() >= 0 && value->number() <= kMost)) return std::nullopt;
    return std::size_t(value->number());
}

// Four numbers for each of `count` vertices.
struct Fours {
    std::string_view bytes;
    std::size_t count = 0;
    std::size_t stride = 0;
    std::size_t type = 0;  // of glTF: 5121 and 5123 unsigned integers of 8 and 16 bits, 5126 float

    // As stored: what is not a float is not scaled.
    double at(std::size_t vertex, std::size_t k) const {
        const char* from = bytes.data() + vertex * stride + k * size();
        if (type == 5121) return double(std::uint8_t(*from));
        if (type == 5123) {
            std::uint16_t value = 0;
            std::memcpy(&value, from, sizeof value);
            return value;
        }
        float value = 0;
        std::memcpy(&value, from, sizeof value);
        return double(value);
    }
    std::size_t size() const { return type == 5121 ? 1 : type == 5123 ? 2 : 4; }
};

class SkinCheck {
 public:
    SkinCheck(const std::filesystem::path& path, const Chunks& chunks, const Json& root)
        : path_(path), binary_(chunks.binary), root_(root) {}

    void check() {
        const Json* nodes = root_.find("nodes");
        if (!nodes || !nodes->is_array()) return;
        for (const Json& node : nodes->elements()) {
            const Json* joints = member(element(root_.find("skins"), index_of(member(&node, "skin"))), "joints");
            const std::optional<std::size_t> mesh = index_of(member(&node, "mesh"));
            const Json* primitives = member(element(root_.find("meshes"), mesh), "primitives");
            if (!joints || !joints->is_array() || !primitives || !primitives->is_array()) continue;
            for (std::size_t p = 0; p < primitives->elements().size(); ++p)
                check_primitive(*mesh, p, primitives->elements()[p], joints->elements().size());
        }
    }

 private:
    void check_primitive(std::size_t mesh, std::size_t index, const Json& primitive, std::size_t joint_count) {
        const Json* attributes = primitive.find("attributes");
        const std::optional<Fours> joints = fours_of(member(attributes, "JOINTS_0"));
        const std::optional<Fours> weights = fours_of(member(attributes, "WEIGHTS_0"));
        if (!joints || joints->type == 5126 || !weights || weights->count < joints->count) return;
        for (std::size_t v = 0; v < joints->count; ++v)
            for (std::size_t k = 0; k < 4; ++k)
                if (weights->at(v, k) > 0 && !(joints->at(v, k) < double(joint_count)))
                    throw InputError(path_.string(),
                                     "meshes[" + std::to_string(mesh) + "].primitives[" + std::to_string(index) +
                                         "].attributes.JOINTS_0",
                                     "vertex " + std::to_string(v) + " hangs on joint " +
                                         std::to_string(int(joints->at(v, k))) + " of a skin that has " +
                                         std::to_string(joint_count));
    }

    // nullopt if the accessor is broken, sparse, or does not lie in its buffer.
    std::optional<Fours> fours_of(const Json* accessor_index) {
        const Json* accessor = element(root_.find("accessors"), index_of(accessor_index));
        const Json* view = element(root_.find("bufferViews"), index_of(member(accessor, "bufferView")));
        const Json* type = member(accessor, "type");
        const std::optional<std::size_t> count = index_of(member(accessor, "count"));
        const std::optional<std::size_t> component = index_of(member(accessor, "componentType"));
        const std::optional<std::size_t> buffer = index_of(member(view, "buffer"));
        if (!type || !type->is_string() || type->string() != "VEC4" || !count || *count == 0 || !component || !buffer ||
            (*component != 5121 && *component != 5123 && *component != 5126))
            return std::nullopt;
        Fours fours{.bytes = buffer_of(*buffer), .count = *count, .stride = 0, .type = *component};
        fours.stride = index_of(member(view, "byteStride")).value_or(4 * fours.size());
        const std::size_t start =
            index_of(member(view, "byteOffset")).value_or(0) + index_of(member(accessor, "byteOffset")).value_or(0);
        if (fours.stride < 4 * fours.size() || start > fours.bytes.size()) return std::nullopt;
        fours.bytes.remove_prefix(start);
        if (fours.bytes.size() < 4 * fours.size() ||
            (fours.bytes.size() - 4 * fours.size()) / fours.stride < fours.count - 1)
            return std::nullopt;
        return fours;
    }

    std::string_view buffer_of(std::size_t index) {
        const auto [found, is_new] = buffers_.try_emplace(index);
        if (is_new) found->second = read_buffer(element(root_.find("buffers"), index), index);
        return index == 0 && found->second.empty() ? binary_ : found->second;
    }

    std::string read_buffer(const Json* buffer, std::size_t index) const {
        const Json* uri = member(buffer, "uri");
        if (!uri || !uri->is_string() || (index == 0 && !binary_.empty())) return "";
        const std::string& text = uri->string();
        const std::size_t data = text.find(";base64,");
        if (text.starts_with("data:"))
            return data == std::string::npos ? "" : from_base64(std::string_view(text).substr(data + 8));
        try {
            return read_file(path_.parent_path() / text, kMostBytes);
        } catch (const InputError&) {
            return "";
        }
    }

    const std::filesystem::path& path_;
    std::string_view binary_;
    const Json& root_;
    std::map<std::size_t, std::string> buffers_;
};

}  // namespace

void check_gltf_skins(const std::filesystem::path& path, std::string_view content) {
    const Chunks chunks = split(content);
    Json root;
    try {
        root = parse_json(chunks.json, path.string());
    } catch (const InputError&) {
        return;
    }
    SkinCheck(path, chunks, root).check();
}

}  // namespace selvedge::sim
