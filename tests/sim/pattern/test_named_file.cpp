// Fabrics, pictures and bodies that a garment file names lie beside it: they are moved and sent together.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/file.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/named_file.h"
#include "sim/pattern/pattern_file.h"
#include "tests/sim/pattern/sample.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

namespace fs = std::filesystem;

class NamedFile : public testing::Test {
 protected:
    NamedFile() {
        for (const char* name : {"work/fabrics", "elsewhere"}) fs::create_directories(folder_ / name);
    }
    std::string at(const std::string& name) const { return (fs::canonical(folder_ / "") / name).string(); }

    // The sample with every kind of file that it can name, `name_of(FILE)` each.
    template <class NameOf>
    PatternDocument sample(const NameOf& name_of) const {
        PatternDocument document = parse_pattern(sample_text(), at("work/shirt.json"));
        Pattern& pattern = document.pattern;
        pattern.fabric = name_of("my_silk.json");
        pattern.body = name_of("bodies/anna.obj");
        pattern.surface = SurfaceDesign{.kind = DesignKind::Picture, .source = name_of("roses.png")};
        pattern.underlays = {{.file = name_of("photos/front.jpg")}};
        pattern.panels[0].fabric = name_of("fabrics/denim.json");
        pattern.panels[0].interlinings = {"linen", name_of("fabrics/canvas.json"), name_of("fabrics/canvas.json")};
        pattern.panels[1].surface = SurfaceDesign{.kind = DesignKind::Picture, .source = name_of("lace.png")};
        return document;
    }
    PatternDocument sample() const {
        return sample([this](const std::string& name) { return at("work/" + name); });
    }

    TemporaryFolder folder_;
};

// The names of all files, in the order of their places in the text.
std::vector<std::string> names_in(const std::string& text) {
    std::vector<std::string> names;
    for (std::size_t end = 0; (end = text.find('"', end)) != std::string::npos;) {
        const std::size_t begin = end + 1;
        end = text.find('"', begin);
        const std::string word = text.substr(begin, end - begin);
        ++end;
        for (const char* ending : {".json", ".png", ".jpg", ".obj"})
            if (word.ends_with(ending)) names.push_back(word);
    }
    return names;
}

TEST_F(NamedFile, of_every_kind_is_named_from_the_garments_folder_and_found_again) {
    const PatternDocument document = sample();
    save_pattern(document, at("work/shirt.json"));
    const PatternDocument again = load_pattern(at("work/shirt.json"));
    EXPECT_EQ(again.pattern, document.pattern);
    std::vector<std::string> names = names_in(write_pattern(document, at("work/shirt.json")));
    std::ranges::sort(names);
    EXPECT_EQ(names, (std::vector<std::string>{"bodies/anna.obj", "fabrics/canvas.json", "fabrics/canvas.json",
                                               "fabrics/denim.json", "lace.png", "my_silk.json", "photos/front.jpg",
                                               "roses.png"}));
    EXPECT_EQ(write_pattern(again, at("work/shirt.json")), write_pattern(document, at("work/shirt.json")));
}

TEST_F(NamedFile, goes_with_the_garment_when_their_folder_moves) {
    save_pattern(sample(), at("work/shirt.json"));
    write_file_atomically(at("work/fabrics/denim.json"), read_fabric_file("denim").text);
    fs::rename(at("work"), at("sent"));
    const Pattern moved = load_pattern(at("sent/shirt.json")).pattern;
    Pattern expected = sample([this](const std::string& name) { return at("sent/" + name); }).pattern;
    EXPECT_EQ(moved, expected);
    EXPECT_EQ(find_fabric(moved.panels[0].fabric).name, "denim");
}

TEST_F(NamedFile, is_named_anew_in_a_garment_that_is_saved_elsewhere) {
    save_pattern(sample(), at("work/shirt.json"));
    const PatternDocument document = load_pattern(at("work/shirt.json"));
    for (const char* place : {"elsewhere/shirt.json", "shirt.json", "work/fabrics/shirt.json"}) {
        save_pattern(document, at(place));
        const PatternDocument copy = load_pattern(at(place));
        EXPECT_EQ(copy.pattern, document.pattern) << place;
    }
    const auto has = [&](const std::string& file, const std::string& name) {
        return std::ranges::count(names_in(write_pattern(document, at(file))), name) == 1;
    };
    EXPECT_TRUE(has("shirt.json", "work/fabrics/denim.json"));
    EXPECT_TRUE(has("work/fabrics/shirt.json", "denim.json"));
    EXPECT_TRUE(has("work/fabrics/shirt.json", at("work/my_silk.json"))) << "not below the garment";
    EXPECT_TRUE(has("elsewhere/shirt.json", at("work/fabrics/denim.json")));
}

TEST_F(NamedFile, keeps_its_name_while_that_leads_to_it) {
    const std::string file = at("work/shirt.json");
    PatternDocument document = parse_pattern(
        replaced(sample_text(), R"("pattern": {)", R"("selvedge": {"fabric": "../work/./my_silk.json"}, "pattern": {)"),
        file);
    EXPECT_EQ(document.pattern.fabric, at("work/my_silk.json"));
    EXPECT_EQ(names_in(write_pattern(document, file)), std::vector<std::string>{"../work/./my_silk.json"});
    document.pattern.fabric = at("work/..my_silk.json");
    EXPECT_EQ(names_in(write_pattern(document, file)), std::vector<std::string>{"..my_silk.json"});
    document.pattern.fabric = "wool_twill";
    EXPECT_EQ(names_in(write_pattern(document, file)), std::vector<std::string>{});
    EXPECT_EQ(parse_pattern(write_pattern(document, file), file).pattern.fabric, "wool_twill");
}

TEST_F(NamedFile, is_found_through_a_folder_that_is_a_link) {
    fs::create_directory_symlink(at("work"), at("link"));
    PatternDocument document = sample([this](const std::string& name) { return at("link/" + name); });
    save_pattern(document, at("link/shirt.json"));
    EXPECT_EQ(load_pattern(at("link/shirt.json")).pattern, sample().pattern);
    EXPECT_EQ(names_in(write_pattern(document, at("link/shirt.json"))),
              names_in(write_pattern(sample(), at("work/shirt.json"))));
}

TEST_F(NamedFile, of_a_garment_without_a_file_has_its_whole_path) {
    const PatternDocument document = sample();
    const std::string text = write_pattern(document);
    for (const std::string& name : names_in(text)) EXPECT_EQ(name.front(), '/') << name;
    PatternDocument again = parse_pattern(text, "");
    again.pattern.name = document.pattern.name;
    EXPECT_EQ(again.pattern, document.pattern);
    again.pattern.fabric = "mine.json";
    EXPECT_EQ(parse_pattern(write_pattern(again, at("work/a.json")), at("work/a.json")).pattern.fabric,
              (fs::current_path() / "mine.json").string())
        << "a path that was typed is one from the working directory";
}

TEST_F(NamedFile, of_a_fabrics_picture_is_named_from_the_fabrics_folder) {
    Fabric fabric = find_fabric("silk");
    fabric.surface = SurfaceDesign{.kind = DesignKind::Picture, .source = at("work/fabrics/roses.png")};
    const std::string text = write_fabric(fabric, at("work/fabrics/roses.json"));
    EXPECT_EQ(names_in(text), std::vector<std::string>{"roses.png"});
    EXPECT_EQ(parse_fabric(text, at("work/fabrics/roses.json")), fabric);
    const std::string moved = write_fabric(fabric, at("work/roses.json"), text);
    EXPECT_EQ(names_in(moved), std::vector<std::string>{"fabrics/roses.png"});
    EXPECT_EQ(parse_fabric(moved, at("work/roses.json")), fabric);
}

TEST_F(NamedFile, is_listed_for_every_field_of_a_pattern_that_has_one) {
    Fabric fabric = find_fabric("silk");
    fabric.surface = SurfaceDesign{.kind = DesignKind::Picture, .source = at("work/tulips.png")};
    write_file_atomically(at("work/my_silk.json"), write_fabric(fabric, at("work/my_silk.json")));
    std::vector<std::string> files = named_files(sample().pattern);
    std::ranges::sort(files);
    files.erase(std::unique(files.begin(), files.end()), files.end());
    std::vector<std::string> expected;
    for (const char* name : {"bodies/anna.obj", "fabrics/canvas.json", "fabrics/denim.json", "lace.png", "my_silk.json",
                             "photos/front.jpg", "roses.png", "tulips.png"})
        expected.push_back(at(std::string("work/") + name));
    EXPECT_EQ(files, expected);
    for (const NamedFileUse& named : named_file_uses(sample().pattern)) {
        const FileUse expected_use = named.file.ends_with(".json")  ? FileUse::Fabric
                                     : named.file.ends_with(".png") ? FileUse::Picture
                                     : named.file.ends_with(".jpg") ? FileUse::Underlay
                                                                    : FileUse::Body;
        EXPECT_EQ(named.use, expected_use) << named.file;
    }
    EXPECT_TRUE(named_files(parse_pattern(sample_text(), "").pattern).empty());
}

TEST(FabricTitle, is_the_name_without_folder_and_ending) {
    EXPECT_EQ(fabric_title("wool_twill"), "wool_twill");
    EXPECT_EQ(fabric_title("/fabrics/my_silk.json"), "my_silk");
    EXPECT_EQ(fabric_title(""), "");
}

}  // namespace
}  // namespace selvedge::sim
