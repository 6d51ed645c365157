// A libFuzzer target. The input is an OBJ file: it is read as a garment's panel data, then the whole way that a body
// comes in, with assimp, but in this process. The fuzzer stops at a sanitizer error, an exception other than
// InputError, and a body that is not finite or not closed.
#include <unistd.h>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "sim/core/error.h"
#include "sim/exchange/mesh_file.h"
#include "sim/repair/guarded_import.h"
#include "sim/repair/load_body.h"

namespace selvedge::sim {
namespace {

const std::string& file() {
    static const std::string path =
        (std::filesystem::temp_directory_path() / ("fuzz_body_" + std::to_string(::getpid()) + ".obj")).string();
    return path;
}

// Each edge of a closed surface has two triangles, one on each side.
bool is_closed(const Body& body) {
    std::map<std::pair<int, int>, int> sides;
    for (const auto& triangle : body.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = int(triangle[k]), to = int(triangle[(k + 1) % 3]);
            ++sides[{from, to}];
        }
    }
    for (const auto& [side, count] : sides) {
        const auto other = sides.find({side.second, side.first});
        if (count != 1 || other == sides.end()) return false;
    }
    return true;
}

void run(std::string_view text) {
    std::ofstream(file(), std::ios::binary) << text;
    try {
        mesh_format_of("garment.obj").panel_data(text, "input");
        const Body body = body_of(unguarded_import(file()), file()).body;
        for (const Vec3d& x : body.x) {
            if (!x.allFinite()) std::abort();
        }
        if (!is_closed(body)) std::abort();
    } catch (const InputError&) {
    }
}

}  // namespace
}  // namespace selvedge::sim

// Assimp 5.2 fills a buffer of 16 MB for each OBJ file. To ask the system for its pages each time took five sixths of
// the time, so that buffer is kept. Everything else is still what the address sanitizer makes of malloc() and free().
namespace {

constexpr std::size_t kKeptBytes = (std::size_t(16) << 20) + 64;
void* kept = nullptr;
bool is_kept_in_use = false;

void* allocate(std::size_t size) noexcept {
    if (size < kKeptBytes / 2 || size > kKeptBytes || is_kept_in_use) return std::malloc(size);
    if (kept == nullptr) kept = std::malloc(kKeptBytes);
    is_kept_in_use = kept != nullptr;
    return kept;
}

void release(void* pointer) noexcept {
    if (pointer != nullptr && pointer == kept) {
        is_kept_in_use = false;
    } else {
        std::free(pointer);
    }
}

}  // namespace

void* operator new(std::size_t size) {
    if (void* const made = allocate(size)) return made;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size);
}
void operator delete(void* pointer) noexcept {
    release(pointer);
}
void operator delete(void* pointer, std::size_t) noexcept {
    release(pointer);
}
void operator delete(void* pointer, const std::nothrow_t&) noexcept {
    release(pointer);
}

// It also loses the mesh of an OBJ file that it gives up halfway. The program reads bodies in a child process, which
// ends.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libassimp.so";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    selvedge::sim::run({reinterpret_cast<const char*>(data), size});
    return 0;
}
