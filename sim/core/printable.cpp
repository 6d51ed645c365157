#include "sim/core/printable.h"

#include <array>
#include <cstdint>
#include <cstdio>

#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

// One character at the start of a text: its bytes, and its code point if they are UTF-8.
struct Character {
    std::size_t bytes = 1;
    std::uint32_t code = 0;
    bool is_valid = false;
};

// (RFC 3629: no overlong forms, no surrogates, at most U+10FFFF)
Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
    const std::uint32_t lead = byte(0);
    if (lead < 0x80) return {1, lead, true};
    const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
    std::uint32_t code = lead & (0x7FU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return {};
        code = code << 6U | (byte(i) & 0x3FU);
    }
    constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
    if (code < kLeast[bytes] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return {};
    return {bytes, code, true};
}

bool is_control(std::uint32_t code) {
    const auto is_between = [code](std::uint32_t least, std::uint32_t most) { return code >= least && code <= most; };
    return code < 0x20 || is_between(0x7F, 0x9F) || is_between(0x2028, 0x202E) ||  // separators of lines, embeddings
           is_between(0x2066, 0x2069) || code == 0xFEFF;                           // isolates, the byte-order mark
}

std::string escaped(const Character& character, unsigned char first_byte) {
    if (character.code == '\n' && character.is_valid) return "\\n";
    if (character.code == '\t' && character.is_valid) return "\\t";
    std::array<char, 16> text{};
    if (character.is_valid && character.code >= 0x80) {
        std::snprintf(text.data(), text.size(), "\\u{%x}", static_cast<unsigned>(character.code));
    } else {
        std::snprintf(text.data(), text.size(), "\\x%02x", static_cast<unsigned>(first_byte));
    }
    return text.data();
}

std::size_t count_characters(std::string_view text) {
    std::size_t count = 0;
    for (; !text.empty(); ++count) text.remove_prefix(first_character(text).bytes);
    return count;
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
    constexpr std::string_view kMiddle = "...";
    SELVEDGE_ASSERT(most >= kMiddle.size() + 2);
    std::string all;
    for (std::string_view left = text; !left.empty();) {
        const Character character = first_character(left);
        const bool is_shown = character.is_valid && !is_control(character.code);
        all += is_shown ? std::string(left.substr(0, character.bytes))
                        : escaped(character, static_cast<unsigned char>(left.front()));
        left.remove_prefix(character.bytes);
    }
    const std::size_t count = count_characters(all);
    if (count <= most) return all;
    const std::size_t tail = (most - kMiddle.size()) / 2;
    const std::size_t head = most - kMiddle.size() - tail;
    std::size_t head_end = 0, tail_begin = 0, at = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (i == head) head_end = at;
        if (i == count - tail) tail_begin = at;
        at += first_character(std::string_view(all).substr(at)).bytes;
    }
    return all.substr(0, head_end) + std::string(kMiddle) + all.substr(tail_begin);
}

std::string fault_line(std::string_view file, std::string_view place, std::string_view problem) {
    std::string line;
    for (const std::string_view part : {file, place}) {
        if (!part.empty()) line += printable(part) + ": ";
    }
    return line + printable(problem);
}

std::string count_text(std::size_t count, std::string_view noun) {
    return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace selvedge::sim
