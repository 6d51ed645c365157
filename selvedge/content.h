#pragma once
// What the library's classes hold, and how errors reach its callers. Not installed.
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "selvedge/body.h"
#include "selvedge/dress.h"
#include "selvedge/pattern.h"
#include "sim/dress/prepared_body.h"
#include "sim/inspection/report.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge {

inline constexpr double kCm = 0.01;  // m

struct Pattern::Content {
    sim::PatternDocument document;
    std::string file;  // its name in messages; empty: none
};

struct Body::Content {
    explicit Content(sim::MadeBody made) : prepared(std::make_shared<const sim::PreparedBody>(std::move(made))) {}

    const sim::Body& body() const { return prepared->body(); }

    std::shared_ptr<const sim::PreparedBody> prepared;
};

// A value that is computed when it is first asked for, by one thread. If computing throws, the next one tries again.
template <class T>
class Deferred {
 public:
    template <class Compute>
    const T& get(const Compute& compute) {
        std::call_once(once_, [&] { value_ = compute(); });
        return value_;
    }

 private:
    std::once_flag once_;
    T value_;
};

struct Result::Content {
    Content(Pattern its_pattern, Body its_body) : pattern(std::move(its_pattern)), body(std::move(its_body)) {}

    Pattern pattern;  // with the garments that are worn over it
    Body body;
    std::string fabric;  // that replaces the pattern's; empty: none does
    sim::DrawMesh garment;
    sim::TriangleHierarchy hierarchy;
    sim::MeshOptions meshing;
    sim::DressReport report;

    std::string report_text;
    std::vector<DrapeFault> faults;
    Mesh mesh;
    std::vector<Strain> strain;
    Deferred<std::vector<float>> clearance;
    Deferred<std::vector<std::vector<int>>> seams;
};

// Throws, for the exception that is being handled, the one that the library's callers get.
[[noreturn]] void throw_for_caller();

// What `run` returns; its exceptions are those of the library.
template <class Run>
decltype(auto) for_caller(const Run& run) {
    try {
        return run();
    } catch (...) {
        throw_for_caller();
    }
}

}  // namespace selvedge
