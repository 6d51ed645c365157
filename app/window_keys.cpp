#include "app/window_keys.h"

namespace selvedge {
namespace {

bool is_between(int code, Key first, Key last) {
    return code >= static_cast<int>(first) && code <= static_cast<int>(last);
}

}  // namespace

// The editor's numbers are GLFW's.
Key key_of_code(int code, const std::string& printed) {
    if (printed.size() == 1) {
        const char c = printed[0];
        if (c >= 'a' && c <= 'z') return key_of(static_cast<char>(c - 'a' + 'A'));
        if (c >= 'A' && c <= 'Z') return key_of(c);
    }
    const bool is_known = (code >= 32 && code <= 96) || is_between(code, Key::Escape, Key::End) ||
                          is_between(code, Key::F1, Key::F12) || is_between(code, Key::Keypad0, Key::KeypadEnter);
    return is_known ? static_cast<Key>(code) : Key::None;
}

std::string utf8_of(std::uint32_t code_point) {
    std::string text;
    const auto add = [&](std::uint32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (code_point < 0x80) {
        add(code_point);
    } else if (code_point < 0x800) {
        add(0xC0 | code_point >> 6);
    } else if (code_point < 0x10000) {
        add(0xE0 | code_point >> 12);
        add(0x80 | (code_point >> 6 & 0x3F));
    } else {
        add(0xF0 | code_point >> 18);
        add(0x80 | (code_point >> 12 & 0x3F));
        add(0x80 | (code_point >> 6 & 0x3F));
    }
    if (code_point >= 0x80) add(0x80 | (code_point & 0x3F));
    return text;
}

}  // namespace selvedge
