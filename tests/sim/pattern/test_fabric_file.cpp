// Fabric files are written so that they read back as the same fabric, and keep what the program does not use.
#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>
#include <string>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/json.h"
#include "sim/pattern/fabric_file.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

std::string shipped_text(const std::string& name) {
    return read_fabric_file(name).text;
}

TEST(FabricFile, reads_back_every_shipped_fabric_and_changes_no_letter_of_an_unchanged_one) {
    for (const std::string& name : fabric_names()) {
        const FabricFile file = read_fabric_file(name);
        const std::string written = write_fabric(file.fabric, "f.json", file.text);
        EXPECT_EQ(parse_fabric(written, "f.json"), file.fabric) << name;
        EXPECT_EQ(written, write_json(parse_json(file.text, "f.json"))) << name;
        EXPECT_EQ(parse_fabric(write_fabric(file.fabric, "f.json"), "f.json"), file.fabric) << name << ", alone";
    }
}

TEST(FabricFile, reads_back_any_values_to_the_bit) {
    std::mt19937 random(7);
    for (int i = 0; i < 300; ++i) {
        Fabric fabric{.name = "random \"cloth\""};
        for (const FabricKey& key : fabric_keys()) {
            const double share = std::uniform_real_distribution<double>(0, 1)(random);
            const double low = std::max(key.least, 1e-9 * key.most);
            fabric.*key.value = i == 0 ? key.least : i == 1 ? key.most : low * std::pow(key.most / low, share);
        }
        fabric.surface = SurfaceDesign{.kind = DesignKind::Test, .size = 0.1 / 3, .position = {1.0 / 7, -2e-3 / 3}};
        const auto degrees = static_cast<double>(static_cast<int>(random() % 72000) - 36000) / 100;
        fabric.surface->rotation = degrees * std::numbers::pi / 180;
        const Fabric read = parse_fabric(write_fabric(fabric, "f.json", shipped_text("denim")), "f.json");
        for (const FabricKey& key : fabric_keys()) EXPECT_EQ(read.*key.value, fabric.*key.value) << key.key;
        EXPECT_EQ(read, fabric) << degrees;
    }
}

TEST(FabricFile, keeps_other_keys_and_their_order_and_the_digits_of_what_is_the_same) {
    const std::string before = R"({"title": "Net", "name": "net", "area_density": 0.050, "stretch_warp": 900,
 "stretch_weft": 7e2, "shear": 12, "mill": {"loom": [3, 4]}, "bending_warp": 1e-6, "bending_weft": 0.0,
 "thickness": 2.0e-4, "evidence": [{"quantity": "B", "value": 1.50}]})";
    Fabric fabric = parse_fabric(before, "f.json");
    fabric.shear = 15;
    EXPECT_EQ(write_json(parse_json(write_fabric(fabric, "f.json", before), ""), -1),
              R"({"title":"Net","name":"net","area_density":0.050,"stretch_warp":900,)"
              R"("stretch_weft":7e2,"shear":15,"mill":{"loom":[3,4]},"bending_warp":1e-6,"bending_weft":0.0,)"
              R"("thickness":2.0e-4,"evidence":[{"quantity":"B","value":1.50}]})");
    fabric.friction = 0.5;
    EXPECT_NE(write_fabric(fabric, "f.json", before).find("\"friction\": 0.5"), std::string::npos);
}

TEST(FabricFile, keeps_unknown_keys_of_a_surface_and_removes_one_that_is_gone) {
    std::string before = shipped_text("silk");
    before.replace(before.find('{'), 1,
                   R"({"surface": {"kind": "colour", "colour": "#112233", "dye": "indigo", "position": [0, 0]},)");
    Fabric fabric = parse_fabric(before, "f.json");
    ASSERT_TRUE(fabric.surface);
    fabric.surface->source = "#445566";
    const std::string dyed = write_fabric(fabric, "f.json", before);
    EXPECT_EQ(parse_fabric(dyed, "f.json"), fabric);
    EXPECT_NE(dyed.find("indigo"), std::string::npos);
    fabric.surface->kind = DesignKind::Tartan;
    fabric.surface->source = "B24 W4 R2";
    const std::string woven = write_fabric(fabric, "f.json", before);
    EXPECT_EQ(parse_fabric(woven, "f.json"), fabric);
    EXPECT_EQ(woven.find("#112233"), std::string::npos);
    fabric.surface.reset();
    EXPECT_EQ(parse_fabric(write_fabric(fabric, "f.json", before), "f.json"), fabric);
}

TEST(FabricFile, names_a_picture_from_where_it_is_written) {
    const TemporaryFolder folder;
    const std::string near = (folder / "near.json").string();
    Fabric fabric = find_fabric("silk");
    fabric.surface = SurfaceDesign{.kind = DesignKind::Picture, .source = (folder / "print/roses.png").string()};
    const std::string text = write_fabric(fabric, near);
    EXPECT_EQ(*parse_fabric(text, near).surface, *fabric.surface);
    EXPECT_NE(text.find("\"print/roses.png\""), std::string::npos) << text;
    const std::string far = "/elsewhere/far.json";
    EXPECT_EQ(*parse_fabric(write_fabric(fabric, far, text), far).surface, *fabric.surface);
}

TEST(FabricFile, refuses_values_that_could_not_be_read_and_what_is_no_json) {
    Fabric fabric;
    fabric.shear = 0;
    EXPECT_THROW(write_fabric(fabric, "f.json"), InputError);
    fabric.shear = std::nan("");
    EXPECT_THROW(write_fabric(fabric, "f.json"), InputError);
    EXPECT_THROW(write_fabric({}, "f.json", "{\"name\":"), InputError);
}

TEST(FabricFile, comes_with_the_text_that_it_was_read_from) {
    const TemporaryFolder folder;
    const std::string file = (folder / "mine.json").string(), text = shipped_text("linen");
    write_file_atomically(file, text);
    EXPECT_EQ(read_fabric_file(file).text, text);
    EXPECT_EQ(read_fabric_file(file).fabric, find_fabric("linen"));
    EXPECT_TRUE(is_shipped_fabric("linen"));
    EXPECT_FALSE(is_shipped_fabric(file));
    EXPECT_EQ(fabric_key(&Fabric::shear).key, std::string("shear"));
}

}  // namespace
}  // namespace selvedge::sim
