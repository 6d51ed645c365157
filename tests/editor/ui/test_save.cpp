// The garment's file is written with what the user wants there, whatever another program did to it meanwhile.
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>

#include "editor/document/journal.h"
#include "editor/ui/editor.h"
#include "editor/ui/files.h"
#include "editor/ui/script.h"
#include "sim/core/file.h"
#include "sim/core/sha256.h"
#include "sim/pattern/pattern_file.h"
#include "tests/editor/ui/played_script.h"
#include "tests/editor/ui/services_without_files.h"
#include "tests/support/checkout.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::editor {
namespace {

class SavedGarment : public testing::Test {
 protected:
    SavedGarment() {
        const auto source = std::filesystem::path(source_folder()) / "patterns" / "two_squares.json";
        std::filesystem::copy_file(source, file_);
        load_and_open(state(), file_);
        change("linen");
    }
    Services services() {
        Services services = services_without_files();
        services.load = [](const std::string& name) { return sim::load_pattern(name); };
        services.exists = [](const std::string& name) { return std::filesystem::exists(name); };
        services.hash_of = [](const std::string& name) -> std::optional<std::string> {
            if (!std::filesystem::exists(name)) return std::nullopt;
            return sim::sha256_of_file(name);
        };
        services.save = [](const std::string& name, const std::string& text) {
            sim::write_file_atomically(name, text);
        };
        services.begin_journal = [this](const std::string& text) { journal_ = text + "\n"; };
        services.note_in_journal = [this](std::string_view line) { journal_ += std::string(line) + "\n"; };
        return services;
    }
    void play(const std::string& script) { play_script(editor_, script, "save.txt"); }
    AppState& state() { return editor_.state(); }
    Document& document() { return *state().workspace.document; }
    void change(const std::string& fabric) { state().workspace.run(SetFabric{.fabric = fabric}); }
    void change_outside(const std::string& fabric = "denim") {
        sim::PatternDocument other = sim::load_pattern(file_);
        other.pattern.fabric = fabric;
        save_pattern(other, file_);
    }
    std::string fabric_on_disk() const { return sim::load_pattern(file_).pattern.fabric; }
    bool has_question() { return !state().questions.empty(); }
    void answer(const std::string& label) { play("frames 2\nclick widget \"answer." + label + "\"\nframes 2\n"); }

    sim::TemporaryFolder folder_;
    std::string file_ = (folder_ / "garment.json").string();
    std::string journal_;
    Editor editor_{services(), {.drive = sim::SessionDrive::Caller, .is_steady = true}};
};

TEST_F(SavedGarment, is_written_without_a_question_while_nobody_else_writes_its_file) {
    save(state());
    EXPECT_EQ(fabric_on_disk(), "linen");
    change("silk");
    save(state());
    EXPECT_EQ(fabric_on_disk(), "silk");
    EXPECT_FALSE(has_question());
}

TEST_F(SavedGarment, does_not_replace_what_another_program_wrote_before_it_is_asked) {
    change_outside();
    save(state());
    ASSERT_TRUE(has_question());
    EXPECT_EQ(fabric_on_disk(), "denim");
    EXPECT_TRUE(document().has_unsaved_changes());
    answer("Cancel");
    EXPECT_EQ(fabric_on_disk(), "denim");
    save(state());
    answer("Replace");
    EXPECT_EQ(fabric_on_disk(), "linen");
    EXPECT_FALSE(document().has_unsaved_changes());
}

TEST_F(SavedGarment, can_be_dropped_for_what_another_program_wrote) {
    change_outside();
    save(state());
    answer("Take theirs");
    EXPECT_EQ(document().pattern().fabric, "denim");
    EXPECT_FALSE(document().has_unsaved_changes());
    change("silk");
    save(state());
    EXPECT_FALSE(has_question());
    EXPECT_EQ(fabric_on_disk(), "silk");
}

TEST_F(SavedGarment, can_be_saved_beside_what_another_program_wrote) {
    change_outside();
    save(state());
    answer("Save as...");
    play("key ctrl+a\ntype mine.json\n");
    EXPECT_TRUE(state().browser.is_open());
    const std::string beside = (folder_ / "mine.json").string();
    save_as(state(), beside);
    EXPECT_EQ(sim::load_pattern(beside).pattern.fabric, "linen");
    EXPECT_EQ(fabric_on_disk(), "denim");
}

TEST_F(SavedGarment, asks_too_where_save_as_names_its_own_file) {
    change_outside();
    save_as(state(), file_);
    EXPECT_TRUE(has_question());
    EXPECT_EQ(fabric_on_disk(), "denim");
}

TEST_F(SavedGarment, asks_each_time_that_another_program_writes) {
    save(state());
    change("silk");
    change_outside();
    save(state());
    answer("Replace");
    change_outside("felt");
    change("linen");
    save(state());
    EXPECT_TRUE(has_question());
    EXPECT_EQ(fabric_on_disk(), "felt");
}

TEST_F(SavedGarment, is_saved_before_the_editor_closes_once_the_question_is_answered) {
    change_outside();
    close(state());
    answer("Save");
    EXPECT_FALSE(state().wants_to_close);
    ASSERT_TRUE(has_question());
    answer("Replace");
    EXPECT_TRUE(state().wants_to_close);
    EXPECT_EQ(fabric_on_disk(), "linen");
}

TEST_F(SavedGarment, is_written_anew_where_its_file_was_removed) {
    std::filesystem::remove(file_);
    save(state());
    EXPECT_FALSE(has_question());
    EXPECT_EQ(fabric_on_disk(), "linen");
}

TEST_F(SavedGarment, that_is_recovered_does_not_replace_what_was_written_since_the_crash) {
    const std::string left = journal_;
    change_outside();
    recover_journal(state(), {.id = "1", .recovery = recover(left), .age = "now"});
    answer("Discard");  // what this editor has itself
    ASSERT_EQ(document().pattern().fabric, "linen");
    save(state());
    EXPECT_TRUE(has_question());
    EXPECT_EQ(fabric_on_disk(), "denim");
}

TEST_F(SavedGarment, that_is_recovered_is_saved_at_once_where_its_file_is_as_it_was) {
    const std::string left = journal_;
    recover_journal(state(), {.id = "1", .recovery = recover(left), .age = "now"});
    answer("Discard");
    save(state());
    EXPECT_FALSE(has_question());
    EXPECT_EQ(fabric_on_disk(), "linen");
}

TEST_F(SavedGarment, is_not_exported_over_a_file_before_the_editor_asked) {
    const std::string export_file = (folder_ / "garment.obj").string();
    sim::write_file_atomically(export_file, "somebody's");
    int writes = 0;
    state().services.write_export = [&](const ExportRequest&) { ++writes; };
    play("frames 3\n");
    export_to(state(), export_file);
    EXPECT_EQ(writes, 0);
    answer("Replace");
    EXPECT_EQ(writes, 1);
}

}  // namespace
}  // namespace selvedge::editor
