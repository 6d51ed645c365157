#include "editor/inspectors/fabric_text.h"

#include <cctype>
#include <cstdio>

namespace selvedge {
namespace {

// Three figures, no exponent: 8000, 56, 0.35.
std::string figures(double value) {
    char buffer[64];
    const double size = value < 0 ? -value : value;
    const int decimals = size >= 100 || size == 0 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
    std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
    std::string text = buffer;
    if (text.find('.') == std::string::npos) return text;
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string both(double warp, double weft, const char* unit) {
    const std::string a = figures(warp), b = figures(weft);
    return (a == b ? a : a + " \u00D7 " + b) + unit;
}

}  // namespace

std::vector<FabricRow> fabric_rows(const Fabric& fabric) {
    return {
        {"Weight", figures(fabric.area_density * 1e3) + " g/m\u00B2", "What a square metre weighs."},
        {"Stretch", both(fabric.stretch_warp, fabric.stretch_weft, " N/m"),
         "Force per width that would double its length: along the warp \u00D7 along the weft."},
        {"Shear", figures(fabric.shear) + " N/m", "Force per width and radian that makes squares of it oblique."},
        {"Bending", both(fabric.bending_warp * 1e6, fabric.bending_weft * 1e6, " \u00B5N\u00B7m"),
         "How stiffly it bends: along the warp \u00D7 along the weft. Silk about 5, denim about 40."},
        {"Thickness", figures(fabric.thickness * 1e3) + " mm", "Of one layer."},
        {"Friction", figures(fabric.friction), "Against the body: 0 slides like oil, 1 hardly slides."},
        {"Damping", figures(fabric.damping) + " /s", "How fast its motion dies away by itself."},
        {"Gives up to", figures(fabric.strain_limit * 100) + " %", "Beyond this strain it no longer gives."},
    };
}

std::string readable_name(const std::string& name) {
    const std::size_t slash = name.find_last_of('/');
    if (name.ends_with(".json")) return slash == std::string::npos ? name : name.substr(slash + 1);
    std::string words = name;
    for (char& c : words) c = c == '_' ? ' ' : c;
    if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words;
}

}  // namespace selvedge
