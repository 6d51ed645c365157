#include "render/output/interface_fonts.h"

#include <array>
#include <system_error>

#include "render/output/shipped_files.h"
#include "sim/core/error.h"
#include "sim/core/file.h"

namespace selvedge::render {
namespace {

struct Family {
    const char* regular;
    const char* medium;
};

// Paths in the packages fonts-inter, fonts-noto-core and fonts-dejavu-core.
constexpr std::array<Family, 4> kFamilies{{
    {"opentype/inter/Inter-Regular.otf", "opentype/inter/Inter-Medium.otf"},
    {"truetype/inter/Inter-Regular.ttf", "truetype/inter/Inter-Medium.ttf"},
    {"truetype/noto/NotoSans-Regular.ttf", "truetype/noto/NotoSans-Medium.ttf"},
    {"truetype/dejavu/DejaVuSans.ttf", "truetype/dejavu/DejaVuSans.ttf"},
}};

bool is_file(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
}

}  // namespace

std::vector<std::filesystem::path> font_folders() {
    std::vector<std::filesystem::path> folders{"/usr/share/fonts", "/usr/local/share/fonts"};
    const std::filesystem::path shipped = shipped_folder();
    if (!shipped.empty()) folders.insert(folders.begin(), shipped / "fonts");
    return folders;
}

FontFiles find_fonts(const std::vector<std::filesystem::path>& folders) {
    for (const Family& family : kFamilies) {
        for (const std::filesystem::path& folder : folders) {
            const std::filesystem::path regular = folder / family.regular, medium = folder / family.medium;
            if (is_file(regular)) return {.regular = regular, .medium = is_file(medium) ? medium : regular};
        }
    }
    return {};
}

std::shared_ptr<const OutlineFont> read_legend_font(const FontFiles& files) {
    constexpr std::size_t kLargestFont = 64U << 20U;
    if (files.regular.empty()) return nullptr;
    try {
        return OutlineFont::read(sim::read_file(files.regular, kLargestFont));
    } catch (const sim::InputError&) {  // the bitmap font will do
        return nullptr;
    }
}

}  // namespace selvedge::render
