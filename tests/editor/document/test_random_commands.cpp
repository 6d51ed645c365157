#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/journal.h"
#include "editor/drafting/draft_error.h"
#include "tests/editor/document/random_commands.h"

namespace selvedge {
namespace {

PatternDocument shipped(const std::string& name) {
    return load_pattern(std::string(SELVEDGE_SOURCE_DIR) + "/patterns/" + name);
}

// Runs so many commands, with undo, redo and drags between them. Returns how many were carried out.
int run_commands(Document& document, unsigned seed, int count) {
    RandomCommands commands(seed);
    int done = 0;
    for (int i = 0; i < count; ++i) {
        const int what = commands.pick(10);
        if (what == 0) document.undo();
        if (what == 1) document.redo();
        if (what == 2)
            document.go_to(document.position() - static_cast<std::size_t>(commands.pick(document.position())) / 8);
        const Command command = commands.next(document.pattern());
        const bool is_dragged = what == 3 && !std::holds_alternative<RenamePanel>(command);
        try {
            is_dragged ? document.attempt(command) : document.run(command);
            ++done;
        } catch (const DraftError&) {
        }
        if (is_dragged && commands.pick(3) > 0) document.keep();
    }
    return done;
}

TEST(RandomCommands, undone_give_the_first_document_byte_for_byte) {
    int done = 0;
    for (const char* name : {"tshirt.json", "skirt.json", "poncho.json", "two_squares.json", "tshirt_thesis.json"}) {
        Document document(shipped(name));
        const std::string first = document.text();
        for (int round = 0; round < 20; ++round) {  // each begins with the last one's garment, a wreck by then
            done +=
                run_commands(document, 100 * static_cast<unsigned>(round) + static_cast<unsigned>(first.size()), 1000);
            document.keep();  // a drag that was under way
            const std::string last = document.text();
            EXPECT_FALSE(has_error(check_pattern_text(last, name))) << describe(check_pattern_text(last, name).front());
            const std::size_t position = document.position();
            document.go_to(0);
            ASSERT_TRUE(document.text() == first) << name << ", round " << round;
            document.go_to(position);
            ASSERT_TRUE(document.text() == last) << name << ", round " << round;
            if (round % 4 == 3) document.go_to(0);
        }
    }
    EXPECT_GT(done, 30000);
}

TEST(RandomCommands, are_given_back_by_the_journal) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        Document document(shipped("tshirt.json"));
        std::string journal = journal_head("tshirt.json", document.text()) + "\n";
        document.set_journal([&](std::string_view line) { journal += std::string(line) + "\n"; });
        run_commands(document, seed, 300);
        const auto recovery = recover(journal);
        ASSERT_TRUE(recovery);
        EXPECT_EQ(recovery->text, document.text()) << seed;
    }
}

}  // namespace
}  // namespace selvedge
