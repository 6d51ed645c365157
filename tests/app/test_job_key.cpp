// A job's key changes with each file that its result follows from, and with nothing else.
#include "app/job_key.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "sim/core/json.h"
#include "sim/core/sha256.h"
#include "sim/core/simd_level.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/fabric_file.h"
#include "tests/app/run_program.h"
#include "tests/support/checkout.h"

namespace selvedge::app {
namespace {

class JobKey : public testing::Test {
 protected:
    static std::string key_of(const batch::Job& job) { return JobKeys(JobOutputs{})(job); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
    // Whether the key is another one after the file has another content.
    bool follows_from(const std::string& name, const batch::Job& job) const {
        const std::string before = key_of(job);
        EXPECT_EQ(key_of(job), before);
        write(name, "other");
        return key_of(job) != before;
    }

    ScratchFolder folder_;
    batch::Job job_{.name = "a",
                    .garment = source_folder() + "/patterns/vest.json",
                    .over = {},
                    .body = {},
                    .fabric = {},
                    .options = {}};
};

TEST_F(JobKey, follows_from_the_simd_level) {
    const std::string before = key_of(job_);
    if (sim::simd_level() == sim::SimdLevel::Plain) GTEST_SKIP() << "this processor has no other level";
    {
        const sim::SimdLimit avx2(sim::SimdLevel::Avx2);
        EXPECT_EQ(key_of(job_), before) << "it has the bits of AVX-512";
    }
    const sim::SimdLimit plain(sim::SimdLevel::Plain);
    EXPECT_NE(key_of(job_), before);
}

TEST_F(JobKey, a_report_on_another_content_of_a_file_says_that_it_was_changed) {
    job_.garment = folder_ / "garment.json";
    write("garment.json", "one");
    JobKeys keys(JobOutputs{});
    keys(job_);
    const auto report_on = [&](const std::string& hash) {
        return sim::parse_json(R"({"inputs": [{"role": "garment", "file": ")" + job_.garment.string() +
                                   R"(", "sha256": ")" + hash + R"("}, {"file": "mannequin:", "sha256": "0"}]})",
                               "report");
    };
    EXPECT_FALSE(keys.have_changed(job_, report_on(sim::sha256("one"))));
    EXPECT_TRUE(keys.have_changed(job_, report_on(sim::sha256("two"))));
    EXPECT_FALSE(keys.have_changed(job_, sim::parse_json("{}", "report")));
}

TEST_F(JobKey, a_refusal_without_inputs_says_that_a_file_was_changed_if_it_is_another_one_now) {
    job_.garment = folder_ / "garment.json";
    write("garment.json", "one");
    JobKeys keys(JobOutputs{});
    keys(job_);
    const sim::Json refused = sim::parse_json(R"({"outcome": "refused", "inputs": []})", "report");
    const sim::Json dressed = sim::parse_json(R"({"outcome": "dressed", "inputs": []})", "report");
    EXPECT_FALSE(keys.have_changed(job_, refused));
    write("garment.json", "");
    EXPECT_TRUE(keys.have_changed(job_, refused));
    EXPECT_FALSE(keys.have_changed(job_, dressed));
}

TEST_F(JobKey, follows_from_the_picture_of_a_design) {
    write("print.png", "one");
    write("beside.png", "one");
    job_.options = {{"design", folder_ / "print.png", false}};
    EXPECT_FALSE(follows_from("beside.png", job_));
    EXPECT_TRUE(follows_from("print.png", job_));
}

TEST_F(JobKey, follows_from_a_fabric_and_its_picture) {
    write("print.png", "one");
    sim::Fabric fabric = sim::find_fabric("denim");
    fabric.surface = sim::SurfaceDesign{.kind = sim::DesignKind::Picture, .source = folder_ / "print.png"};
    job_.fabric = folder_ / "printed.json";
    write("printed.json", write_fabric(fabric, job_.fabric));
    EXPECT_TRUE(follows_from("print.png", job_));
    EXPECT_TRUE(follows_from("printed.json", job_));
}

TEST_F(JobKey, follows_from_the_buffers_of_a_body) {
    write("my body.bin", "one");
    write("plain.bin", "one");
    for (const char* name : {"body.gltf", "BODY.GLTF"}) {
        write(name, R"({"buffers": [{"uri": "my%20body.bin"}, {"uri": "plain.bin"}, {"uri": "data:,x"}, {}]})");
        job_.body = folder_ / name;
        EXPECT_TRUE(follows_from("my body.bin", job_)) << name;
        EXPECT_TRUE(follows_from("plain.bin", job_)) << name;
        write("my body.bin", "one");
        write("plain.bin", "one");
        EXPECT_TRUE(follows_from(name, job_)) << name;
    }
}

TEST_F(JobKey, follows_from_the_outputs) {
    EXPECT_NE(JobKeys(JobOutputs{.has_pictures = false})(job_), key_of(job_));
    EXPECT_NE(JobKeys(JobOutputs{.exports = {"glb"}})(job_), key_of(job_));
}

}  // namespace
}  // namespace selvedge::app
