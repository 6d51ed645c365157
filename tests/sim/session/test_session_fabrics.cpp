// Sessions whose fabric is a file that is written while the garment hangs.
#include <gtest/gtest.h>
#include <string>

#include "sim/core/file.h"
#include "sim/motion/motion_file.h"
#include "sim/pattern/fabric_file.h"
#include "sim/session/session.h"
#include "tests/sim/session/session_support.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim::test {
namespace {

class SessionOfAFabricFile : public testing::Test {
 protected:
    SessionOfAFabricFile() {
        pattern_.fabric = (folder_ / "mine.json").string();
        write_file_atomically(pattern_.fabric, file_.text);
        session_.set_body(session_body());
        session_.set_options(coarse_options());
        session_.set_pattern(pattern_);
        settle(session_);
    }
    void write() { write_file_atomically(pattern_.fabric, write_fabric(file_.fabric, pattern_.fabric, file_.text)); }
    std::shared_ptr<const SessionFrame> after(int frames) {
        session_.advance(frames);
        return session_.frame();
    }
    TemporaryFolder folder_;
    FabricFile file_ = read_fabric_file("silk");
    Pattern pattern_ = session_pattern("two_squares");
    Session session_{SessionDrive::Caller};
};

TEST_F(SessionOfAFabricFile, takes_its_values_from_where_it_hangs_when_it_was_written) {
    const auto before = session_.frame();
    session_.reread_fabrics();
    EXPECT_EQ(after(0)->stage, SessionStage::Settled) << "the file is as it was";
    file_.fabric.bending_warp *= 30;
    file_.fabric.bending_weft *= 30;
    write();
    session_.set_pattern(pattern_);
    EXPECT_EQ(after(0)->stage, SessionStage::Settled) << "the pattern is the same";
    session_.reread_fabrics();
    EXPECT_EQ(after(0)->stage, SessionStage::Draping);
    EXPECT_EQ(after(0)->mesh.x, before->mesh.x);
    EXPECT_GT(mean_move(*before, *after(400)), 1e-4);
}

TEST_F(SessionOfAFabricFile, says_that_it_is_broken_and_hangs_on_with_what_it_had) {
    const auto before = session_.frame();
    write_file_atomically(pattern_.fabric, "{");
    session_.reread_fabrics();
    EXPECT_NE(after(0)->problem.find("mine.json"), std::string::npos) << session_.frame()->problem;
    EXPECT_EQ(session_.frame()->mesh.x, before->mesh.x);
    write();
    session_.set_pattern(pattern_);
    EXPECT_EQ(after(0)->problem, "");
}

TEST_F(SessionOfAFabricFile, is_dressed_again_on_a_body_that_moves_when_it_was_written) {
    session_.go_to(session_body(), find_pose("stride", *session_body()));
    EXPECT_NE(after(100)->motion.x, nullptr);
    session_.reread_fabrics();
    EXPECT_NE(after(0)->motion.x, nullptr) << "the file is as it was";
    file_.fabric.area_density *= 2;
    write();
    session_.reread_fabrics();
    EXPECT_EQ(after(0)->motion.x, nullptr);
    EXPECT_TRUE(session_.frame()->motion.is_waiting);
}

}  // namespace
}  // namespace selvedge::sim::test
