#include "app/find_font.h"

#include <array>
#include <system_error>

namespace selvedge {
namespace {

struct Family {
    const char* regular;
    const char* medium;
};

// As the packages fonts-inter, fonts-noto-core and fonts-dejavu-core lay them down.
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

FontFiles find_fonts(const std::vector<std::filesystem::path>& folders) {
    for (const Family& family : kFamilies) {
        for (const std::filesystem::path& folder : folders) {
            const std::filesystem::path regular = folder / family.regular, medium = folder / family.medium;
            if (is_file(regular)) return {.regular = regular, .medium = is_file(medium) ? medium : regular};
        }
    }
    return {};
}

}  // namespace selvedge
