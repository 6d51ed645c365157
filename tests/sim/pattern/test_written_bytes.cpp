// What is written of a garment, and what is said of wrong values, stays the same from one version to the next.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/core/file.h"
#include "sim/core/json.h"
#include "sim/pattern/pattern_fields.h"
#include "sim/pattern/pattern_file.h"
#include "tests/support/reference_text.h"

namespace selvedge::sim {
namespace {

std::string text_of_all_fields() {
    return read_file(source_folder() + "/tests/reference/all_fields.json", 1 << 20);
}

TEST(WrittenBytes, are_unchanged_when_a_file_with_every_key_is_read_and_written) {
    const std::string text = text_of_all_fields();
    EXPECT_EQ(write_pattern(parse_pattern(text, "")), write_json(parse_json(text, "")));
}

TEST(WrittenBytes, are_unchanged_when_shipped_files_are_read_and_written) {
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/patterns")) {
        if (entry.path().extension() != ".json") continue;
        EXPECT_EQ(write_pattern(load_pattern(entry.path()), entry.path()), write_json(read_json(entry.path())));
    }
}

TEST(WrittenBytes, of_a_new_garment_equal_the_reference) {
    PatternDocument document = parse_pattern(text_of_all_fields(), "");
    document.json = Json();
    expect_reference("written_from_nothing.json", write_pattern(document));
}

// Gives all other fields their defaults.
template <Described Part>
void reset_all_but(const std::set<std::string_view>& names, Part& part) {
    const Part usual{};
    visit_fields(part, [&](const auto& field, auto& value) {
        if (!names.contains(field.name)) value = usual.*field.member;
    });
}

TEST(WrittenBytes, of_a_garment_with_all_defaults_equal_the_reference) {
    PatternDocument document = parse_pattern(text_of_all_fields(), "");
    Pattern& pattern = document.pattern;
    for (Panel& panel : pattern.panels) {
        reset_all_but({"name", "vertices", "edges", "is_mirrored"}, panel);
        for (OutlineEdge& edge : panel.edges) reset_all_but({"start", "end"}, edge);
    }
    for (Seam& seam : pattern.seams) reset_all_but({"first", "second"}, seam);
    reset_all_but({"panels", "seams"}, pattern);
    expect_reference("written_of_defaults.json", write_pattern(document));
}

// Puts wrong values in place of each value below a key "selvedge", one at a time, and lists the faults of each, but for
// those that are there before, such as unknown keys.
class FaultLister {
 public:
    explicit FaultLister(Json root) : root_(std::move(root)), usual_(faults()) {}

    std::string list() {
        visit(root_, "", false);
        return std::move(lines_);
    }

 private:
    void visit(Json& value, const std::string& path, bool is_ours) {
        if (value.is_object()) {
            for (Json::Member& member : value.members())
                visit_replaced(member.value, json_path(path, member.key), is_ours || member.key == "selvedge");
        } else if (value.is_array()) {
            for (std::size_t i = 0; i < value.elements().size(); ++i)
                visit_replaced(value.elements()[i], json_path(path, i), is_ours);
        }
    }

    void visit_replaced(Json& value, const std::string& path, bool is_ours) {
        for (const char* wrong : {"\"x\"", "-7.5", "1e6"}) {
            if (!is_ours) break;
            const Json kept = std::exchange(value, parse_json(wrong, ""));
            for (const std::string& fault : faults()) {
                if (std::ranges::find(usual_, fault) == usual_.end())
                    lines_ += path + " = " + wrong + ": " + fault + "\n";
            }
            value = kept;
        }
        visit(value, path, is_ours);
    }

    std::vector<std::string> faults() const {
        std::vector<std::string> found;
        for (const Fault& fault : check_pattern_text(write_json(root_), "f")) found.push_back(describe(fault));
        return found;
    }

    Json root_;
    std::vector<std::string> usual_;
    std::string lines_;
};

TEST(WrittenBytes, of_the_faults_of_wrong_values_equal_the_reference) {
    expect_reference("faults.txt", FaultLister(parse_json(text_of_all_fields(), "f.json")).list());
}

}  // namespace
}  // namespace selvedge::sim
