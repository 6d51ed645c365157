#pragma once
// A font whose letters are outlines, from a TrueType or OpenType file: it is drawn at any size, with smooth edges.
// Letters stand beside each other without kerning, and digits have one width, as in the editor's interface.
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/image/image.h"

namespace selvedge::render {

// Where a line of text stands in a picture, and how large.
struct TextLine {
    float left_px = 0;
    int baseline_px = 0;  // the row below the feet of capital letters
    float size_px = 0;    // the font's em
    Rgba8 colour{0x2C, 0x2C, 0x30, 255};
};

class OutlineFont {
 public:
    // From the bytes of a font file. Null: they are not one, or it has no question mark, which stands for the letters
    // that a font lacks and for what is no UTF-8.
    static std::shared_ptr<const OutlineFont> read(std::string bytes);

    ~OutlineFont();
    OutlineFont(const OutlineFont&) = delete;
    OutlineFont& operator=(const OutlineFont&) = delete;

    // Of UTF-8 text, em.
    float text_width(std::string_view text) const;

    float capital_height() const { return capital_height_; }  // em

    // Blends the text over the picture. Parts outside the picture are clipped.
    void draw(Image& image, std::string_view text, const TextLine& line) const;

 private:
    struct File;
    struct Letter {
        int glyph = 0;
        float advance = 0;  // em
        float shift = 0;    // em, of the outline to the right
    };

    explicit OutlineFont(std::unique_ptr<File> file);
    Letter letter(char32_t code) const;

    std::unique_ptr<File> file_;
    float em_ = 1;              // of one of the font's units
    float capital_height_ = 0;  // em
    float digit_width_ = 0;     // em
};

}  // namespace selvedge::render
