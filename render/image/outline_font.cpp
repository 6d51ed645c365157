#include "render/image/outline_font.h"

#define STBTT_STATIC
#define STBTT_assert(condition) ((void)(condition))  // a bad file is no fault of the program
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb_truetype.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "render/image/text.h"
#include "sim/core/assert.h"

namespace selvedge::render {
namespace {

// Removes the first character of a text that is not empty. What is no UTF-8 is a question mark for each byte.
char32_t take_code(std::string_view& text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const auto length = static_cast<std::size_t>(std::countl_one(byte(0)));
    bool is_valid = length != 1 && length <= 4 && length <= text.size();
    char32_t code = length == 0 ? byte(0) : byte(0) & (0x7FU >> length);
    for (std::size_t i = 1; is_valid && i < length; ++i) {
        is_valid = (byte(i) & 0xC0U) == 0x80U;
        code = code << 6U | (byte(i) & 0x3FU);
    }
    text.remove_prefix(is_valid ? std::max<std::size_t>(length, 1) : 1);
    return is_valid ? code : U'?';
}

bool is_digit(char32_t code) {
    return code >= U'0' && code <= U'9';
}

// Whether the tables of the font, or of the first one of a collection, lie within the file: stb_truetype does not look.
bool has_whole_tables(const std::string& bytes) {
    constexpr std::size_t kHead = 12, kEntry = 16;  // bytes, of an offset table and of a table's entry (OpenType 1.9)
    const auto number = [&](std::size_t at, std::size_t size) {
        std::size_t value = 0;
        for (std::size_t i = 0; i < size; ++i) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
        return value;
    };
    if (bytes.size() < kHead) return false;
    std::size_t start = 0;
    if (bytes.starts_with("ttcf")) {
        if (bytes.size() < kHead + 4) return false;
        start = number(kHead, 4);
    }
    if (start > bytes.size() - kHead) return false;
    const std::size_t tables = number(start + 4, 2);
    if (tables * kEntry > bytes.size() - start - kHead) return false;
    for (std::size_t i = 0; i < tables; ++i) {
        const std::size_t entry = start + kHead + i * kEntry;
        const std::size_t offset = number(entry + 8, 4), length = number(entry + 12, 4);
        if (offset > bytes.size() || length > bytes.size() - offset) return false;
    }
    return true;
}

}  // namespace

struct OutlineFont::File {
    std::string bytes;
    stbtt_fontinfo info{};

    int glyph(char32_t code) const { return stbtt_FindGlyphIndex(&info, static_cast<int>(code)); }
    int advance(int glyph) const {  // in the font's units
        int width = 0, bearing = 0;
        stbtt_GetGlyphHMetrics(&info, glyph, &width, &bearing);
        return width;
    }
};

std::shared_ptr<const OutlineFont> OutlineFont::read(std::string bytes) {
    if (!has_whole_tables(bytes)) return nullptr;
    auto file = std::make_unique<File>();
    file->bytes = std::move(bytes);
    const auto* data = reinterpret_cast<const unsigned char*>(file->bytes.data());
    const int offset = stbtt_GetFontOffsetForIndex(data, 0);
    if (offset < 0 || stbtt_InitFont(&file->info, data, offset) == 0 || file->glyph(U'?') == 0) return nullptr;
    return std::shared_ptr<const OutlineFont>(new OutlineFont(std::move(file)));
}

OutlineFont::OutlineFont(std::unique_ptr<File> file)
    : file_(std::move(file)), em_(stbtt_ScaleForMappingEmToPixels(&file_->info, 1)) {
    int left = 0, low = 0, right = 0, high = 0;
    stbtt_GetGlyphBox(&file_->info, letter(U'H').glyph, &left, &low, &right, &high);
    capital_height_ = float(high) * em_;
    for (char32_t digit = U'0'; digit <= U'9'; ++digit)
        digit_width_ = std::max(digit_width_, float(file_->advance(file_->glyph(digit))) * em_);
}

OutlineFont::~OutlineFont() = default;

OutlineFont::Letter OutlineFont::letter(char32_t code) const {
    const int found = file_->glyph(code), glyph = found != 0 ? found : file_->glyph(U'?');
    const float advance = float(file_->advance(glyph)) * em_;
    if (!is_digit(code)) return {.glyph = glyph, .advance = advance};
    return {.glyph = glyph, .advance = digit_width_, .shift = 0.5F * (digit_width_ - advance)};
}

float OutlineFont::text_width(std::string_view text) const {
    float width = 0;
    while (!text.empty()) width += letter(take_code(text)).advance;
    return width;
}

void OutlineFont::draw(Image& image, std::string_view text, const TextLine& line) const {
    SELVEDGE_ASSERT(line.size_px > 0);
    const float scale = em_ * line.size_px;  // px of one of the font's units
    std::vector<unsigned char> ink;
    float pen = line.left_px;
    while (!text.empty()) {
        const Letter next = letter(take_code(text));
        const float left = pen + next.shift * line.size_px, whole = std::floor(left), part = left - whole;
        pen += next.advance * line.size_px;
        int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
        stbtt_GetGlyphBitmapBoxSubpixel(&file_->info, next.glyph, scale, scale, part, 0, &x0, &y0, &x1, &y1);
        if (x1 <= x0 || y1 <= y0) continue;  // a space
        const int width = x1 - x0, height = y1 - y0;
        ink.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
        stbtt_MakeGlyphBitmapSubpixel(&file_->info, ink.data(), width, height, width, scale, scale, part, 0,
                                      next.glyph);
        blend_ink(
            image,
            {.left = static_cast<int>(whole) + x0, .top = line.baseline_px + y0, .width = width, .height = height}, ink,
            line.colour);
    }
}

}  // namespace selvedge::render
