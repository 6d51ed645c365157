// A libFuzzer target. The input is a batch's manifest: its first byte says whether CSV or JSON. The fuzzer stops at a
// sanitizer error, an exception other than InputError, and a job whose name cannot be that of a folder.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "batch/manifest.h"
#include "sim/core/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    try {
        const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
        std::vector<selvedge::batch::Job> jobs =
            selvedge::batch::parse_manifest(text, data[0] == 'c' ? "lists/input.csv" : "lists/input.json");
        name_jobs(jobs);
        for (const selvedge::batch::Job& job : jobs) {
            if (!selvedge::batch::is_job_name(job.name)) std::abort();
            if (replay_command(job).empty()) std::abort();
        }
    } catch (const selvedge::sim::InputError&) {
    }
    return 0;
}
