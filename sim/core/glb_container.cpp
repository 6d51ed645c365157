#include "sim/core/glb_container.h"

#include <cstdint>
#include <cstring>
#include <utility>

#include "sim/core/assert.h"

namespace selvedge::sim::glb {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2;                   // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;  // "JSON", "BIN"
constexpr std::size_t kHeader = 12, kChunkHeader = 8, kAlignment = 4;        // bytes

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    if (at + sizeof word <= bytes.size()) std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

void append_word(std::string& bytes, std::size_t word) {
    SELVEDGE_ASSERT(word <= UINT32_MAX);
    const auto value = static_cast<std::uint32_t>(word);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::size_t padding_of(std::size_t size) {
    return (kAlignment - size % kAlignment) % kAlignment;
}

}  // namespace

Chunks split(std::string_view content) {
    if (!content.starts_with("glTF")) return {.json = content, .binary = {}};
    Chunks chunks;
    for (std::size_t at = kHeader; at + kChunkHeader <= content.size();) {
        const std::size_t length = word_at(content, at);
        const std::string_view chunk = content.substr(at + kChunkHeader, length);
        const std::uint32_t type = word_at(content, at + 4);
        if (type == kJsonChunk && chunks.json.empty()) chunks.json = chunk;
        if (type == kBinaryChunk && chunks.binary.empty()) chunks.binary = chunk;
        at += kChunkHeader + length;
    }
    return chunks;
}

std::string head(std::string json, std::size_t buffer_bytes) {
    SELVEDGE_ASSERT(padding_of(buffer_bytes) == 0);
    json.append(padding_of(json.size()), ' ');
    std::string bytes;
    append_word(bytes, kMagic);
    append_word(bytes, kVersion);
    append_word(bytes, kHeader + kChunkHeader + json.size() + kChunkHeader + buffer_bytes);
    append_word(bytes, json.size());
    append_word(bytes, kJsonChunk);
    bytes += json;
    append_word(bytes, buffer_bytes);
    append_word(bytes, kBinaryChunk);
    return bytes;
}

std::string container(std::string json, std::string_view buffer) {
    const std::size_t padding = padding_of(buffer.size());
    std::string bytes = head(std::move(json), buffer.size() + padding);
    bytes += buffer;
    bytes.append(padding, '\0');
    return bytes;
}

}  // namespace selvedge::sim::glb
