#pragma once
// Dressed garments in Python: selvedge.dress() and its result.
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "app/garment_options.h"
#include "app/picture.h"
#include "python/bodies.h"
#include "python/patterns.h"
#include "sim/cloth/cloth.h"
#include "sim/core/parallel.h"
#include "sim/inspection/contact_pressure.h"
#include "sim/session/dress.h"

namespace selvedge::python {

// A value that is computed when it is first needed, by one thread.
template <class T>
class Lazy {
 public:
    // The interpreter's lock is released meanwhile.
    template <class Compute>
    const T& get(const Compute& compute) {
        const py::gil_scoped_release release;
        std::call_once(once_, [&] { value_ = compute(); });
        return value_;
    }

    // Pre: it was not needed yet.
    void set(T value) {
        std::call_once(once_, [&] { value_ = std::move(value); });
    }

 private:
    std::once_flag once_;
    T value_;
};

struct Result {
    sim::Pattern pattern;  // with the garments that are worn over it
    BodyPointer body;
    app::GarmentOptions garment;
    sim::DressedGarment dressed;              // of an unpickled one without a simulation, and with a part of the report
    std::string report;                       // to_json() of the whole report
    std::vector<sim::TriangleStrain> strain;  // per leaf triangle
    Lazy<std::vector<float>> clearance;       // m, per leaf vertex
    Lazy<sim::ContactPressure> contact;
    Lazy<std::vector<std::vector<int>>> seams;  // per leaf vertex, ascending
};

using ResultPointer = std::shared_ptr<Result>;

// What is computed when it is first needed. The second throws InputError if a position is not finite.
const std::vector<float>& clearance_of(Result& result);
const sim::ContactPressure& contact_of(Result& result);
const std::vector<std::vector<int>>& seams_of(Result& result);

// The keyword arguments that dress() and Session have in common, checked.
struct DressArguments {
    std::string fabric;
    std::optional<double> edge_length;
    int max_level = 3;
    double shortest_edge = 0.02;
    std::optional<int> triangles;
    bool self_collision = true;
};
// Throws InputError.
sim::DressOptions dress_options(const DressArguments& arguments);

// Reports to a Python function, which may be None, and looks for signals. What the function raises, and an interrupt,
// propagate as exceptions. Pre: `function` outlives it; it is called without the interpreter's lock.
sim::Progress progress_to(py::handle function);
void look_for_signals();

// How the result is drawn, as `selvedge dress --render` does.
app::PictureOptions picture_of(const Result& result, app::PictureOptions picture);

void add_results(py::module_& module);

}  // namespace selvedge::python
