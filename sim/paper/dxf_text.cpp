#include "sim/paper/dxf_text.h"

#include <iconv.h>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "sim/core/error.h"
#include "sim/core/trimmed.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kLargestFile = 64U << 20U;  // bytes
constexpr std::size_t kMostGroups = 4000000;

// Takes a line off the text; CR, LF and both end one.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = text.find_first_of("\r\n");
    const std::string_view line = text.substr(0, end);
    if (end == std::string_view::npos) {
        text = {};
        return line;
    }
    const bool is_pair = text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n';
    text.remove_prefix(end + (is_pair ? 2 : 1));
    return line;
}

void append_utf8(std::string& out, unsigned code) {
    const auto byte = [&](unsigned value) { out += static_cast<char>(value); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) {
        byte(0xC0 | (code >> 6U));
    } else {
        byte(0xE0 | (code >> 12U));
        byte(0x80 | ((code >> 6U) & 0x3FU));
    }
    byte(0x80 | (code & 0x3FU));
}

bool is_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const int more = c < 0x80                ? 0
                         : c >= 0xC2 && c < 0xE0 ? 1
                         : c >= 0xE0 && c < 0xF0 ? 2
                         : c >= 0xF0 && c < 0xF5 ? 3
                                                 : -1;
        if (more < 0 || i + static_cast<std::size_t>(more) >= text.size()) return false;
        for (int k = 0; k < more; ++k) {
            if ((static_cast<unsigned char>(text[++i]) & 0xC0U) != 0x80U) return false;
        }
    }
    return true;
}

// "ANSI_1251" is CP1251. Empty: not one of Windows, or Latin-1's.
std::string charset_of(std::string_view code_page) {
    constexpr std::string_view kAnsi = "ANSI_";
    std::string name;
    for (const char c : code_page) name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (!name.starts_with(kAnsi) || name.size() == kAnsi.size() || name.size() > kAnsi.size() + 4) return {};
    const std::string number = name.substr(kAnsi.size());
    const bool is_number = std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; });
    return is_number ? "CP" + number : std::string();
}

// None: a byte that the character set has not.
std::optional<std::string> utf8_from(const std::string& charset, std::string_view text) {
    const iconv_t converter = iconv_open("UTF-8", charset.c_str());
    if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
    std::string in(text), out(4 * text.size(), '\0');
    char *from = in.data(), *to = out.data();
    std::size_t left = in.size(), room = out.size();
    const bool is_good = iconv(converter, &from, &left, &to, &room) != static_cast<std::size_t>(-1) && left == 0;
    iconv_close(converter);
    if (!is_good) return std::nullopt;
    out.resize(out.size() - room);
    return out;
}

}  // namespace

std::optional<std::string> decoded_dxf(std::string_view text) {
    constexpr std::size_t kHeader = 1U << 16U;  // bytes: the variable is one of the first
    constexpr std::string_view kVariable = "$DWGCODEPAGE";
    const std::size_t at = text.substr(0, kHeader).find(kVariable);
    if (at == std::string_view::npos || text.size() > kLargestFile || is_utf8(text)) return std::nullopt;
    std::string_view rest = text.substr(at);
    take_line(rest);
    take_line(rest);
    const std::string charset = charset_of(trimmed(take_line(rest)));
    return charset.empty() ? std::nullopt : utf8_from(charset, text);
}

bool looks_like_dxf(std::string_view text) {
    if (text.starts_with("AutoCAD Binary DXF")) return true;
    // Comments (999) may come before the first section.
    std::string_view rest = text.substr(0, 65536);
    for (int i = 0; i < 200 && !rest.empty(); ++i) {
        const std::string_view code = trimmed(take_line(rest));
        const std::string_view value = trimmed(take_line(rest));
        if (code == "0") return value == "SECTION";
        if (code != "999") return false;
    }
    return false;
}

std::vector<DxfGroup> parse_dxf(std::string_view text, const std::string& file) {
    if (text.size() > kLargestFile) throw InputError(file, "", "larger than 64 MB");
    if (text.starts_with("AutoCAD Binary DXF")) throw InputError(file, "", "a binary DXF: save it as text (ASCII)");
    std::vector<DxfGroup> groups;
    int line = 1;
    while (!text.empty()) {
        const std::string_view code_text = trimmed(take_line(text));
        if (code_text.empty() && text.empty()) break;
        int code = 0;
        const auto [stop, error] = std::from_chars(code_text.data(), code_text.data() + code_text.size(), code);
        if (error != std::errc() || stop != code_text.data() + code_text.size()) {
            throw InputError(file, "line " + std::to_string(line),
                             "'" + std::string(code_text.substr(0, 40)) + "' where a group code should be");
        }
        if (groups.size() == kMostGroups) throw InputError(file, "", "more than 4 million groups");
        groups.push_back({code, trimmed(take_line(text)), line});
        line += 2;
        if (code == 0 && groups.back().value == "EOF") break;
    }
    return groups;
}

std::optional<std::string_view> DxfEntity::text(int code) const {
    const auto found = std::ranges::find(groups, code, &DxfGroup::code);
    return found == groups.end() ? std::nullopt : std::optional(found->value);
}

std::optional<double> DxfEntity::number(int code) const {
    const auto value = text(code);
    return value ? dxf_number(*value) : std::nullopt;
}

std::optional<double> dxf_number(std::string_view value) {
    if (!value.empty() && value.front() == '+') value.remove_prefix(1);
    double number = 0;
    const auto [stop, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc() || stop != value.data() + value.size() || !std::isfinite(number)) return std::nullopt;
    return number;
}

std::string dxf_string(std::string_view value) {
    std::string text;
    if (is_utf8(value)) {
        text = value;
    } else {
        for (const char c : value) append_utf8(text, static_cast<unsigned char>(c));
    }
    for (std::size_t at = text.find("\\U+"); at != std::string::npos; at = text.find("\\U+", at + 1)) {
        unsigned code = 0;
        const char* begin = text.data() + at + 3;
        const char* end = text.data() + std::min(text.size(), at + 7);
        const auto [stop, error] = std::from_chars(begin, end, code, 16);
        if (error != std::errc() || stop != begin + 4 || code < 0x20) continue;
        std::string character;
        append_utf8(character, code);
        text.replace(at, 7, character);
    }
    return text;
}

}  // namespace selvedge::sim
