#include "editor/ui/elide.h"

#include <imgui.h>

#include "editor/ui/widgets.h"

namespace selvedge {
namespace {

constexpr std::string_view kDots = "...";

bool begins_letter(std::string_view text, std::size_t at) {
    return at >= text.size() || (static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U;
}

// With `kept` bytes of it or a few less.
std::string with_dots(std::string_view text, std::size_t kept, Elide what) {
    std::size_t head = what == Elide::End ? kept : (kept + 1) / 2;
    std::size_t tail = text.size() - (kept - head);
    while (!begins_letter(text, head)) --head;
    while (!begins_letter(text, tail)) ++tail;
    return std::string(text.substr(0, head)).append(kDots).append(text.substr(tail));
}

}  // namespace

std::string elided(std::string_view text, float width, Elide what,
                   const std::function<float(std::string_view)>& width_of) {
    if (width_of(text) <= width) return std::string(text);
    std::size_t fits = 0, too_many = text.size();
    while (too_many - fits > 1) {
        const std::size_t kept = (fits + too_many) / 2;
        (width_of(with_dots(text, kept, what)) <= width ? fits : too_many) = kept;
    }
    return with_dots(text, fits, what);
}

std::string elided(std::string_view text, float width, Elide what) {
    return elided(text, width, what,
                  [](std::string_view part) { return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x; });
}

void tip_of_whole(const std::string& text, const std::string& shown) {
    if (text != shown) tip(text);
}

}  // namespace selvedge
