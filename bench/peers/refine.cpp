// Compares the adaptive mesh with OpenMesh: one-to-four refinement by OpenMesh's uniform Loop subdivider (topology
// only, no smoothing of points) and by the adaptive mesh. The adaptive mesh also keeps the hierarchy, levels and
// material coordinates, can coarsen again, and updates flat lists of leaves, which OpenMesh does not have. A square of
// 32 x 32 quads is refined from 2,048 to 131,072 triangles. Times are per triangle made: 172,032 on three levels.
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

#include "bench/support/measured_mesh.h"
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/file.h"
#include "sim/core/json.h"
#include "sim/core/math.h"
#include "sim/mesh/square.h"

namespace {

using namespace selvedge;
using Peer = OpenMesh::TriMesh_ArrayKernelT<>;

constexpr int kLevels = 3;
constexpr int kQuads = 32;

struct Options {
    int runs = 15;
    std::string json_file;
};

struct Times {  // ns per triangle created, or removed
    std::vector<double> peer;
    std::vector<double> grown;    // a new mesh, whose pools grow
    std::vector<double> refined;  // a mesh whose pools have their full size
    std::vector<double> coarsened;
    std::vector<double> refined_lists;  // update of the flat leaf lists afterwards
    std::vector<double> coarsened_lists;
};

std::size_t triangles_made(const sim::AdaptiveMesh& mesh) {
    return mesh.triangles().size() - mesh.base_triangle_count();
}

// CPU time of this process; other processes do not count.
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

Peer make_peer(const sim::GarmentMesh& base) {
    Peer mesh;
    std::vector<Peer::VertexHandle> vertices;
    for (const Vec3d& x : base.x) vertices.push_back(mesh.add_vertex(Peer::Point(x.cast<float>().eval().data())));
    const auto at = [&](int v) { return vertices[static_cast<std::size_t>(v)]; };
    for (const sim::GarmentTriangle& t : base.triangles) {
        mesh.add_face(at(t.vertices[0]), at(t.vertices[1]), at(t.vertices[2]));
    }
    return mesh;
}

double refine_peer(const sim::GarmentMesh& base, std::size_t made) {
    Peer mesh = make_peer(base);
    OpenMesh::Subdivider::Uniform::LoopT<Peer> loop;
    loop.attach(mesh);
    const double time = time_ns([&] { loop(kLevels, false); });
    loop.detach();
    SELVEDGE_ASSERT(mesh.n_faces() == base.triangles.size() << 2 * kLevels);
    return time / static_cast<double>(made);
}

void refine(sim::AdaptiveMesh& mesh) {
    for (int level = 0; level < mesh.max_level(); ++level) {
        for (const sim::EdgeId e : mesh.unsplit_edges(level)) {
            if (mesh.may_split(e)) mesh.split(e);
        }
        mesh.retriangulate(level);
    }
}

void coarsen(sim::AdaptiveMesh& mesh) {
    for (int level = mesh.max_level() - 1; level >= 0; --level) {
        for (const sim::EdgeId e : mesh.split_edges(level)) {
            if (mesh.may_rejoin(e)) mesh.rejoin(e);
        }
        mesh.retriangulate(level);
    }
}

Times measure(const Options& options) {
    const sim::GarmentMesh base = sim::make_square({.columns = kQuads, .rows = kQuads});
    sim::AdaptiveMesh steady(base, {.max_level = kLevels});
    refine(steady);
    const std::size_t made = triangles_made(steady);
    steady.refresh_lists();
    coarsen(steady);
    steady.refresh_lists();
    const auto time_per_triangle = [&](auto&& work) { return time_ns(work) / static_cast<double>(made); };
    Times times;
    for (int run = 0; run < options.runs; ++run) {
        sim::AdaptiveMesh fresh(base, {.max_level = kLevels});
        times.peer.push_back(refine_peer(base, made));
        times.grown.push_back(time_per_triangle([&] { refine(fresh); }));
        times.refined.push_back(time_per_triangle([&] { refine(steady); }));
        times.refined_lists.push_back(time_per_triangle([&] { steady.refresh_lists(); }));
        SELVEDGE_ASSERT(steady.leaf_triangles().size() == base.triangles.size() << 2 * kLevels);
        times.coarsened.push_back(time_per_triangle([&] { coarsen(steady); }));
        times.coarsened_lists.push_back(time_per_triangle([&] { steady.refresh_lists(); }));
    }
    return times;
}

double median(const std::vector<double>& times) {
    return quantile(times, 0.5);
}

void print(const Times& times) {
    const double peer = median(times.peer);
    const auto row = [&](const char* what, double own) {
        std::printf("| %s | %.1f | %.2f |\n", what, own, peer / own);
    };
    std::printf("| uniform refinement to level 3 and back | ns per triangle made | times faster |\n|---|---|---|\n");
    row("OpenMesh 9, LoopT, topology alone", peer);
    row("Selvedge, the mesh, steady state", median(times.refined));
    row("Selvedge, the mesh, back to level 0", median(times.coarsened));
    row("Selvedge, a fresh mesh that grows", median(times.grown));
    row("Selvedge, the mesh and its leaf lists", median(times.refined) + median(times.refined_lists));
    row("Selvedge, the same back to level 0", median(times.coarsened) + median(times.coarsened_lists));
}

void save(const Times& times, const std::string& file) {
    sim::Json json = sim::Json::object();
    json["openmesh_ns_per_triangle"] = median(times.peer);
    json["refine_ns_per_triangle"] = median(times.refined);
    json["coarsen_ns_per_triangle"] = median(times.coarsened);
    json["fresh_ns_per_triangle"] = median(times.grown);
    json["refine_lists_ns_per_triangle"] = median(times.refined_lists);
    json["coarsen_lists_ns_per_triangle"] = median(times.coarsened_lists);
    json["times_faster"] = median(times.peer) / median(times.refined);
    write_file_atomically(file, write_json(json));
}

// Returns nullopt if the arguments do not match the usage at the top of this file.
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
