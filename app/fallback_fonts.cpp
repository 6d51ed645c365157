#include "app/fallback_fonts.h"

#include <fontconfig/fontconfig.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file.h"

namespace selvedge::app {
namespace {

template <auto Destroy>
struct Destroyer {
    template <class T>
    void operator()(T* object) const {
        Destroy(object);
    }
};
using FontPattern = std::unique_ptr<FcPattern, Destroyer<FcPatternDestroy>>;
using CharSet = std::unique_ptr<FcCharSet, Destroyer<FcCharSetDestroy>>;
using FontSet = std::unique_ptr<FcFontSet, Destroyer<FcFontSetSortDestroy>>;

// All installed fonts, beginning with those that look most like plain sans serif and have these letters.
FontSet sorted_fonts(const editor::Letters& letters) {
    const CharSet wanted(FcCharSetCreate());
    for (const char32_t letter : letters) FcCharSetAddChar(wanted.get(), letter);
    const FontPattern pattern(FcPatternCreate());
    FcPatternAddCharSet(pattern.get(), FC_CHARSET, wanted.get());
    FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
    FcConfigSubstitute(nullptr, pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    FcResult result = FcResultNoMatch;
    return FontSet(FcFontSort(nullptr, pattern.get(), FcFalse, nullptr, &result));
}

std::string text_of(const FcPattern& font, const char* property) {
    FcChar8* text = nullptr;
    if (FcPatternGetString(&font, property, 0, &text) != FcResultMatch) return {};
    return reinterpret_cast<const char*>(text);
}

bool is_set(const FcPattern& font, const char* property) {
    FcBool value = FcFalse;
    return FcPatternGetBool(&font, property, 0, &value) == FcResultMatch && value != FcFalse;
}

// Whether ImGui can draw it: outlines of one weight.
bool is_drawable(const FcPattern& font) {
    const std::string format = text_of(font, FC_FONTFORMAT);
    return is_set(font, FC_OUTLINE) && !is_set(font, FC_COLOR) && !is_set(font, FC_VARIABLE) &&
           (format == "TrueType" || format == "CFF");
}

// Whether these bytes begin a TrueType or OpenType file, or a collection of them, and not one that is compressed, as
// WOFF is.
bool is_sfnt(std::string_view bytes) {
    using namespace std::string_view_literals;
    return bytes.starts_with("\0\1\0\0"sv) || bytes.starts_with("OTTO") || bytes.starts_with("ttcf") ||
           bytes.starts_with("true");
}

editor::Letters letters_in(const FcPattern& font, const editor::Letters& letters) {
    FcCharSet* held = nullptr;
    editor::Letters found;
    if (FcPatternGetCharSet(&font, FC_CHARSET, 0, &held) != FcResultMatch) return found;
    for (const char32_t letter : letters) {
        if (FcCharSetHasChar(held, letter) != FcFalse) found.insert(letter);
    }
    return found;
}

std::optional<editor::FallbackFont> read_font(const FcPattern& font) {
    constexpr std::size_t kLargestFont = 64U << 20U;
    constexpr int kFaceBits = 0xFFFF;  // the bits above are the instance of a variable font
    int index = 0;
    FcPatternGetInteger(&font, FC_INDEX, 0, &index);
    try {
        std::string bytes = sim::read_file(text_of(font, FC_FILE), kLargestFont);
        if (!is_sfnt(bytes)) return std::nullopt;
        return editor::FallbackFont{.bytes = std::move(bytes), .face = index & kFaceBits};
    } catch (const sim::InputError&) {
        return std::nullopt;
    }
}

}  // namespace

std::vector<editor::FallbackFont> find_fallback_fonts(const editor::Letters& letters) {
    std::vector<editor::FallbackFont> fonts;
    const FontSet sorted = FcInit() == FcFalse ? nullptr : sorted_fonts(letters);
    editor::Letters missing = letters;
    for (int i = 0; sorted && i < sorted->nfont && !missing.empty(); ++i) {
        const FcPattern& candidate = *sorted->fonts[i];
        const editor::Letters found = is_drawable(candidate) ? letters_in(candidate, missing) : editor::Letters{};
        if (found.empty()) continue;
        std::optional<editor::FallbackFont> font = read_font(candidate);
        if (!font) continue;
        fonts.push_back(std::move(*font));
        for (const char32_t letter : found) missing.erase(letter);
    }
    return fonts;
}

}  // namespace selvedge::app
