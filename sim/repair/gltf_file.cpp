#include "sim/repair/gltf_file.h"

#include <cmath>
#include <cstring>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/glb_container.h"
#include "sim/core/percent_decoded.h"

namespace selvedge::sim::gltf {
namespace {

constexpr std::size_t kMostBytes = std::size_t(256) << 20;  // of a file of buffers

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

std::optional<std::size_t> width_of(const Json* type) {
    if (!type || !type->is_string()) return std::nullopt;
    if (type->string() == "SCALAR") return 1;
    if (type->string() == "VEC2") return 2;
    if (type->string() == "VEC3") return 3;
    if (type->string() == "VEC4") return 4;
    return std::nullopt;
}

template <class Number>
double number_at(const char* from) {
    Number value = 0;
    std::memcpy(&value, from, sizeof value);
    return double(value);
}

}  // namespace

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
    if (std::floor(value->number()) != value->number()) return std::nullopt;
    return std::size_t(value->number());
}

std::optional<std::size_t> index_or(const Json* value, std::size_t absent) {
    return value ? index_of(value) : absent;
}

std::optional<std::size_t> component_bytes(std::size_t type) {
    switch (type) {
        case Numbers::kByte:
        case Numbers::kUnsignedByte:
            return 1;
        case Numbers::kShort:
        case Numbers::kUnsignedShort:
            return 2;
        case Numbers::kUnsignedInt:
        case Numbers::kFloat:
            return 4;
        default:
            return std::nullopt;
    }
}

double Numbers::at(std::size_t element, std::size_t k) const {
    const char* from = bytes.data() + element * stride + k * component_bytes(type).value_or(0);
    switch (type) {
        case kByte:
            return number_at<std::int8_t>(from);
        case kUnsignedByte:
            return number_at<std::uint8_t>(from);
        case kShort:
            return number_at<std::int16_t>(from);
        case kUnsignedShort:
            return number_at<std::uint16_t>(from);
        case kUnsignedInt:
            return number_at<std::uint32_t>(from);
        default:
            return number_at<float>(from);
    }
}

File::File(Json root, std::string_view buffer) : binary_(buffer), root_(std::move(root)) {}

File::File(const std::filesystem::path& path, std::string_view content) : folder_(path.parent_path()) {
    const glb::Chunks chunks = glb::split(content);
    binary_ = chunks.binary;
    root_ = parse_json(chunks.json, path.string());
}

std::string_view File::buffer(std::size_t index) {
    const auto [found, is_new] = buffers_.try_emplace(index);
    if (is_new) found->second = read_buffer(element(root_.find("buffers"), index), index);
    return index == 0 && found->second.empty() ? binary_ : found->second;
}

std::string File::read_buffer(const Json* buffer, std::size_t index) const {
    const Json* uri = member(buffer, "uri");
    if (!uri || !uri->is_string() || (index == 0 && !binary_.empty())) return "";
    const std::string& text = uri->string();
    const std::size_t data = text.find(";base64,");
    if (text.starts_with("data:"))
        return data == std::string::npos ? "" : from_base64(std::string_view(text).substr(data + 8));
    for (const std::string& name : {text, percent_decoded(text)}) {
        try {
            return read_file(folder_ / name, kMostBytes);
        } catch (const InputError&) {  // the other name, or none
        }
    }
    return "";
}

std::optional<std::string_view> File::view_bytes(const Json* view) {
    const std::optional<std::size_t> index = index_of(member(view, "buffer"));
    const std::optional<std::size_t> length = index_of(member(view, "byteLength"));
    if (!index || !length) return std::nullopt;
    const std::string_view bytes = buffer(*index);
    const std::optional<std::size_t> offset = index_or(member(view, "byteOffset"), 0);
    if (!offset) return std::nullopt;
    const std::size_t start = *offset;
    if (start > bytes.size() || *length > bytes.size() - start) return std::nullopt;
    return bytes.substr(start, *length);
}

std::optional<Numbers> File::numbers(const Json* accessor) {
    const Json* view = element(root_.find("bufferViews"), index_of(member(accessor, "bufferView")));
    const std::optional<std::size_t> width = width_of(member(accessor, "type"));
    const std::optional<std::size_t> count = index_of(member(accessor, "count"));
    const std::optional<std::size_t> type = index_of(member(accessor, "componentType"));
    const std::optional<std::size_t> offset = index_or(member(accessor, "byteOffset"), 0);
    const std::optional<std::size_t> stride = index_or(member(view, "byteStride"), 0);
    const std::optional<std::string_view> bytes = view_bytes(view);
    const std::optional<std::size_t> size = type ? component_bytes(*type) : std::nullopt;
    if (!width || !count || *count == 0 || !size || !offset || !stride || !bytes || member(accessor, "sparse"))
        return std::nullopt;
    Numbers numbers{.bytes = *bytes, .count = *count, .width = *width, .stride = 0, .type = *type};
    const std::size_t bytes_each = *width * *size;
    numbers.stride = *stride == 0 ? bytes_each : *stride;  // 0: old exporters mean that there is none
    if (numbers.stride < bytes_each || *offset > numbers.bytes.size()) return std::nullopt;
    numbers.bytes.remove_prefix(*offset);
    if (numbers.bytes.size() < bytes_each || (numbers.bytes.size() - bytes_each) / numbers.stride < numbers.count - 1)
        return std::nullopt;
    return numbers;
}

}  // namespace selvedge::sim::gltf
