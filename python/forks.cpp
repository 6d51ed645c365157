#include "python/forks.h"

#include <unistd.h>
#include <cstdio>
#include <cstdlib>

#include <pybind11/pybind11.h>

#include "python/pictures.h"
#include "render/gl/context.h"
#include "sim/core/parallel.h"

namespace selvedge::python {

namespace py = pybind11;

namespace {

// What Mesa does at exit waits for its threads, which a child does not have. Python is finalized by then; what was
// registered in the child was done before.
void leave(int status, void*) {
    std::fflush(nullptr);
    _exit(status);
}

}  // namespace

void survive_forks() {
    const auto before = [] {
        const py::gil_scoped_release release;
        drawing().lock();
        sim::end_worker_threads();
    };
    const auto after = [] { drawing().unlock(); };
    const auto after_in_child = [after] {
        after();
        if (render::was_context_made()) on_exit(&leave, nullptr);
    };
    py::module_::import("os").attr("register_at_fork")(py::arg("before") = py::cpp_function(before),
                                                       py::arg("after_in_parent") = py::cpp_function(after),
                                                       py::arg("after_in_child") = py::cpp_function(after_in_child));
}

}  // namespace selvedge::python
