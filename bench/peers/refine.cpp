// A peer of the adaptive mesh: one-to-four refinement by OpenMesh's uniform Loop subdivider (its topology alone: no
// points are moved), beside ours, which keeps the hierarchy and the material coordinates and can go back.
// A square of 32 x 32 quads from 2,048 to 131,072 triangles. Times are per triangle made: 172,032 on three levels.
//     refine [--runs N] [--json FILE]
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "sim/adaptive/square.h"
#include "sim/adaptive/uniform.h"
#include "sim/core/file.h"
#include "sim/core/json.h"
#include "sim/core/quantile.h"

namespace {

using namespace selvedge;
using Peer = OpenMesh::TriMesh_ArrayKernelT<>;

constexpr int kLevels = 3;
constexpr int kQuads = 32;

struct Options {
    int runs = 15;
    std::string json_file;
};

struct Times {  // ns per triangle made
    std::vector<double> peer;
    std::vector<double> grown;      // ours, a fresh mesh whose pools grow
    std::vector<double> refined;    // ours, in steady state
    std::vector<double> coarsened;  // ours, in steady state; per triangle unmade
};

std::size_t triangles_made(const AdaptiveMesh& mesh) {
    return mesh.triangles().size() - mesh.base_triangle_count();
}

// Processor time, which does not count the neighbours' work on the machine.
double processor_ns() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

template <class F>
double time_ns(F&& work) {
    const double start = processor_ns();
    work();
    return processor_ns() - start;
}

Peer make_peer(const GarmentMesh& base) {
    Peer mesh;
    std::vector<Peer::VertexHandle> vertices;
    for (const Vec3d& x : base.x) vertices.push_back(mesh.add_vertex(Peer::Point(x.cast<float>().eval().data())));
    const auto at = [&](int v) { return vertices[static_cast<std::size_t>(v)]; };
    for (const GarmentTriangle& t : base.triangles) {
        mesh.add_face(at(t.vertices[0]), at(t.vertices[1]), at(t.vertices[2]));
    }
    return mesh;
}

double refine_peer(const GarmentMesh& base, std::size_t made) {
    Peer mesh = make_peer(base);
    OpenMesh::Subdivider::Uniform::LoopT<Peer> loop;
    loop.attach(mesh);
    const double time = time_ns([&] { loop(kLevels, false); });
    loop.detach();
    SELVEDGE_ASSERT(mesh.n_faces() == base.triangles.size() << 2 * kLevels);
    return time / static_cast<double>(made);
}

Times measure(const Options& options) {
    const GarmentMesh base = make_square({.columns = kQuads, .rows = kQuads});
    NoState state;
    AdaptiveMesh steady(base, {.max_level = kLevels});
    const auto go_to = [&](AdaptiveMesh& mesh, int level) { set_uniform_level(mesh, state, level); };
    go_to(steady, kLevels);
    const std::size_t made = triangles_made(steady);
    go_to(steady, 0);
    Times times;
    for (int run = 0; run < options.runs; ++run) {
        AdaptiveMesh fresh(base, {.max_level = kLevels});
        const auto per_triangle = [&](double ns) { return ns / static_cast<double>(made); };
        times.peer.push_back(refine_peer(base, made));
        times.grown.push_back(per_triangle(time_ns([&] { go_to(fresh, kLevels); })));
        times.refined.push_back(per_triangle(time_ns([&] { go_to(steady, kLevels); })));
        times.coarsened.push_back(per_triangle(time_ns([&] { go_to(steady, 0); })));
    }
    return times;
}

double median(const std::vector<double>& times) {
    return quantile(times, 0.5);
}

void print(const Times& times) {
    const double peer = median(times.peer);
    const auto row = [&](const char* what, const std::vector<double>& own) {
        std::printf("| %s | %.1f | %.2f |\n", what, median(own), peer / median(own));
    };
    std::printf("| refinement to level 3 and back | ns per triangle made | times faster |\n|---|---|---|\n");
    row("OpenMesh 9, LoopT, topology alone", times.peer);
    row("Selvedge, a fresh mesh that grows", times.grown);
    row("Selvedge, steady state", times.refined);
    row("Selvedge, back to level 0", times.coarsened);
}

void save(const Times& times, const std::string& file) {
    Json json = Json::object();
    json["openmesh_ns_per_triangle"] = median(times.peer);
    json["fresh_ns_per_triangle"] = median(times.grown);
    json["refine_ns_per_triangle"] = median(times.refined);
    json["coarsen_ns_per_triangle"] = median(times.coarsened);
    json["refine_ratio"] = median(times.peer) / median(times.refined);
    write_file_atomically(file, write_json(json));
}

// None when the arguments are not as the head of this file says.
std::optional<Options> read_arguments(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; i += 2) {
        if (i + 1 == count) return std::nullopt;
        if (std::strcmp(arguments[i], "--runs") == 0)
            options.runs = std::atoi(arguments[i + 1]);
        else if (std::strcmp(arguments[i], "--json") == 0)
            options.json_file = arguments[i + 1];
        else
            return std::nullopt;
    }
    if (options.runs < 1) return std::nullopt;
    return options;
}

}  // namespace

int main(int count, char** arguments) {
    const std::optional<Options> options = read_arguments(count, arguments);
    if (!options) {
        std::fprintf(stderr, "usage: refine [--runs N] [--json FILE]\n");
        return 2;
    }
    try {
        const Times times = measure(*options);
        print(times);
        if (!options->json_file.empty()) save(times, options->json_file);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
