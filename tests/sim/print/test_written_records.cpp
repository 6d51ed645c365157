// What files in SVG and DXF say of a pattern beyond what they draw stays the same from one version to the next.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "sim/core/file.h"
#include "sim/pattern/pattern_file.h"
#include "sim/print/dxf_file.h"
#include "sim/print/svg_file.h"
#include "tests/sim/print/sample_pattern.h"
#include "tests/support/reference_text.h"

namespace selvedge::sim {
namespace {

// The lines with the word, without what is drawn, each between bars: some end with a space.
std::string lines_with(const std::string& word, const std::string& text) {
    const std::regex drawn(" d=\"[^\"]*\"");
    std::string lines, line;
    for (std::stringstream all(text); std::getline(all, line);) {
        if (line.find(word) != std::string::npos) lines += "|" + std::regex_replace(line, drawn, "") + "|\n";
    }
    return lines;
}

TEST(WrittenRecords, of_a_pattern_with_every_field_equal_the_reference) {
    const std::string path = source_folder() + "/tests/reference/all_fields.json";
    const Pattern all = parse_pattern(read_file(path, 1 << 20), "").pattern;
    std::string text;
    for (const Pattern& pattern : {sample_pattern(), all}) {
        text += lines_with("selvedge", svg_of(pattern, paper_sheet(pattern, paper_pieces(pattern), 1.5)));
        for (const DxfStandard standard : {DxfStandard::Aama, DxfStandard::Astm})
            text += lines_with("SELVEDGE", dxf_of(pattern, standard));
    }
    expect_reference("records.txt", text);
}

}  // namespace
}  // namespace selvedge::sim
