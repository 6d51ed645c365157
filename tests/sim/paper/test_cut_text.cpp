// What labels say of how a part is cut, in the words of several programs and languages.
#include "sim/paper/cut_text.h"

#include <gtest/gtest.h>

#include "sim/paper/drawing_file.h"
#include "sim/paper/make_panels.h"
#include "tests/sim/paper/drawings.h"

namespace selvedge::sim {
namespace {

CutInstructions read(std::string_view text) {
    CutInstructions cut;
    read_cut_text(text, cut);
    return cut;
}

TEST(CutText, of_freesewing_in_keys_and_in_english) {
    EXPECT_EQ(read("plugin-annotations:cut,2,plugin-annotations:mirrored,plugin-annotations:from,"
                   "plugin-annotations:lining,"),
              (CutInstructions{2, true, false, "lining"}));
    EXPECT_EQ(read("Cut 1 on the fold from main fabric"), (CutInstructions{1, false, true, "fabric"}));
    EXPECT_EQ(read(",plugin-annotations:cut,6,plugin-annotations:mirrored,plugin-annotations:onFold,"
                   "plugin-annotations:from,plugin-annotations:specialty,"),
              (CutInstructions{6, true, true, "specialty"}));
}

TEST(CutText, of_valentina_names_the_material_first) {
    EXPECT_EQ(read("Fabric, Cut 2"), (CutInstructions{2, {}, false, "fabric"}));
    EXPECT_EQ(read("Interfacing, Cut 1 on fold"), (CutInstructions{1, {}, true, "interfacing"}));
}

TEST(CutText, in_german_french_spanish_and_dutch) {
    EXPECT_EQ(read("Schneiden 2 gespiegelt aus Hauptstoff"), (CutInstructions{2, true, false, "fabric"}));
    EXPECT_EQ(read("2x zuschneiden im Stoffbruch, Futter"), (CutInstructions{2, {}, true, "lining"}));
    EXPECT_EQ(read("1 x Zuschneiden"), (CutInstructions{1, {}, false, ""}));
    EXPECT_EQ(read("Couper 2 en miroir dans doublure"), (CutInstructions{2, true, false, "lining"}));
    EXPECT_EQ(read("Tissu, Couper 1 au pli"), (CutInstructions{1, {}, true, "fabric"}));
    EXPECT_EQ(read("Cortar 2 en espejo de entretela"), (CutInstructions{2, true, false, "interfacing"}));
    EXPECT_EQ(read("Tela, Cortar 1 en el doblez"), (CutInstructions{1, {}, true, "fabric"}));
    EXPECT_EQ(read("Knip 2 gespiegeld uit voering"), (CutInstructions{2, true, false, "lining"}));
    EXPECT_EQ(read("Stof, 4 keer knippen aan de stofvouw").pieces, 4);
}

TEST(CutText, of_dxf_has_a_key_and_a_value) {
    EXPECT_EQ(read("Quantity: 1,1"), (CutInstructions{2, true, {}, ""}));
    EXPECT_EQ(read("QUANTITY: 3").pieces, 3);
    EXPECT_EQ(read("Anzahl: 2").pieces, 2);
    EXPECT_EQ(read("Quantité: 2").pieces, 2);
    EXPECT_EQ(read("Material: Shell No. 2").material, "Shell No. 2");
    EXPECT_EQ(read("Material: Futter").material, "lining");
    EXPECT_EQ(read("Annotation: cut on fold").is_on_fold, true);
}

TEST(CutText, of_accumark_goes_before_a_quantity_of_one) {
    EXPECT_EQ(read("ANNOTATION: 2XFABRIC"), (CutInstructions{2, {}, {}, "fabric"}));
    EXPECT_EQ(read("1X RIB"), (CutInstructions{1, {}, {}, "ribbing"}));
    for (const auto& [first, second] : {std::pair("Quantity: 1", "2XFABRIC"), std::pair("2XFABRIC", "Quantity: 0")}) {
        CutInstructions cut;
        read_cut_text(first, cut);
        read_cut_text(second, cut);
        EXPECT_EQ(cut.pieces, 2) << first;
    }
}

TEST(CutText, on_the_fold_counts_on_a_line_of_its_own_before_or_behind_the_number) {
    for (const auto& [first, second] : {std::pair("Cut 1", "ON FOLD"), std::pair("place on the fold", "Cut 1")}) {
        CutInstructions cut;
        read_cut_text(first, cut);
        read_cut_text(second, cut);
        EXPECT_EQ(cut, (CutInstructions{1, {}, true, ""})) << first;
    }
}

TEST(CutText, about_other_things_changes_nothing) {
    for (const char* text :
         {"Cut here", "cut 1 cm away", "undercut 2", "Size: 40", "Piece Name: cut", "2", "", "cut", "Quantity: many",
          "fold line", "cut 2000000000", "lining", "2XL", "2x", "Size 12 cut out", "Sleeve 5 cut along grain"}) {
        CutInstructions cut;
        EXPECT_FALSE(read_cut_text(text, cut)) << text;
        EXPECT_EQ(cut, CutInstructions()) << text;
    }
}

TEST(CutText, of_the_main_fabric_goes_before_that_of_other_materials) {
    CutInstructions cut;
    for (const char* text : {"Interfacing, Cut 1", "Fabric, Cut 2", "Lining, Cut 4"}) read_cut_text(text, cut);
    EXPECT_EQ(cut, (CutInstructions{2, {}, false, "fabric"}));
}

// A corset is cut twice from interfacing and twice from fabric, both on one label.
TEST(CutText, reads_all_instructions_of_a_label) {
    CutInstructions cut;
    read_cut_text(
        "annotations:cut,2,annotations:mirrored,annotations:from,annotations:interfacing, "
        ",annotations:cut,4,annotations:mirrored,annotations:from,annotations:fabric,",
        cut);
    EXPECT_EQ(cut.material, "fabric");
    EXPECT_EQ(cut.pieces, 4);
    EXPECT_EQ(cut.are_mirrored, true);
}

}  // namespace
}  // namespace selvedge::sim
