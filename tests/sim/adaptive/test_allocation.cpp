// That an adaption allocates nothing in steady state: this program counts what operator new is asked for.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "sim/adaptive/square.h"
#include "sim/adaptive/uniform.h"

namespace {
std::atomic<std::size_t> allocations{0};
}

void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace selvedge {
namespace {

void refine_and_coarsen(AdaptiveMesh& mesh, NoState& state) {
    for (const int level : {1, 3, 2, 3, 0}) set_uniform_level(mesh, state, level);
}

TEST(Allocation, happens_while_the_mesh_first_grows_and_never_again) {
    AdaptiveMesh mesh(make_square({.columns = 8, .rows = 8}));
    NoState state;
    const std::size_t at_start = allocations;
    refine_and_coarsen(mesh, state);
    const std::size_t after_growth = allocations;
    EXPECT_GT(after_growth, at_start);
    refine_and_coarsen(mesh, state);
    EXPECT_EQ(allocations, after_growth);
}

}  // namespace
}  // namespace selvedge
