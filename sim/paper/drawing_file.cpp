#include "sim/paper/drawing_file.h"

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"
#include "sim/paper/dxf_drawing.h"
#include "sim/paper/dxf_text.h"
#include "sim/paper/freesewing_json.h"
#include "sim/paper/grade_rules.h"
#include "sim/paper/pdf_drawing.h"
#include "sim/paper/svg_drawing.h"

namespace selvedge::sim {
namespace {

// Of Selvedge or GarmentCode.
bool is_garment(const Json& root) {
    const Json* pattern = root.find("pattern");
    return pattern != nullptr && pattern->find("panels") != nullptr;
}

}  // namespace

Drawing parse_drawing(std::string_view text, const std::string& file) {
    if (looks_like_pdf(text)) return read_pdf(text, file);
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (first == std::string_view::npos) throw InputError(file, "", "the file is empty");
    if (text[first] == '{') {
        const Json root = parse_json(text, file);
        if (is_garment(root)) {
            throw InputError(file, "",
                             "a garment file already, not a drawing: open it with selvedge dress or selvedge edit");
        }
        if (!looks_like_freesewing(root)) throw InputError(file, "parts", "missing: no draft of FreeSewing");
        return read_freesewing(root, file);
    }
    if (looks_like_dxf(text)) return read_dxf(text, file);
    if (looks_like_svg(text)) return read_svg(text, file);
    if (text.starts_with("AC10")) throw InputError(file, "", "a DWG: save it as DXF (ASCII)");
    if (text.starts_with("\x1F\x8B")) throw InputError(file, "", "a compressed file: unpack it");
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw InputError(file, "", "text in UTF-16: save it as UTF-8");
    throw InputError(file, "", "neither SVG, DXF, PDF nor a draft of FreeSewing");
}

Drawing read_drawing(const std::filesystem::path& path) {
    constexpr std::size_t kLargestFile = 64U << 20U;  // bytes
    const std::string text = read_file(path, kLargestFile);
    if (!looks_like_dxf(text)) return parse_drawing(text, path.string());
    for (const char* extension : {".rul", ".RUL", ".Rul"}) {
        std::filesystem::path table = path;
        table.replace_extension(extension);
        if (!is_file(table)) continue;
        const GradeRules rules = parse_grade_rules(read_file(table, kLargestFile), table.string());
        return read_dxf(text, path.string(), &rules);
    }
    return read_dxf(text, path.string());
}

}  // namespace selvedge::sim
