#include "python/sessions.h"

#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "python/bodies.h"
#include "python/errors.h"
#include "python/meshes.h"
#include "python/patterns.h"
#include "python/results.h"
#include "python/views.h"
#include "sim/core/parallel.h"
#include "sim/session/session.h"

namespace selvedge::python {
namespace {

using FramePointer = std::shared_ptr<const sim::SessionFrame>;
using Three = std::array<double, 3>;

struct Frame {
    FramePointer frame;
};

constexpr app::Limits<int> kFrames{0, 1'000'000};

std::string name_of(sim::SessionStage stage) {
    constexpr std::array<const char*, 7> names{"empty", "placed", "sewing", "draping", "moving", "settled", "failed"};
    return names[static_cast<std::size_t>(stage)];
}

Vec3f vector_of(const Three& numbers, const char* place) {
    for (const double number : numbers) within(number, {-sim::kMaxCoordinate, sim::kMaxCoordinate}, place);
    return Vec3d(numbers[0], numbers[1], numbers[2]).cast<float>();
}

class CallerSession {
 public:
    CallerSession(const DocumentPointer& pattern, const BodyPointer& body, const DressArguments& arguments,
                  std::optional<int> threads)
        : threads_(within(threads, sim::kThreadCounts, "threads")) {
        const py::gil_scoped_release release;
        sim::SessionOptions options;
        const sim::DressOptions asked = dress_options(arguments);
        options.fabric = asked.fabric;
        options.edge_length = asked.edge_length;
        options.max_level = asked.max_level;
        options.shortest_edge = asked.shortest_edge;
        options.triangle_budget = asked.triangle_budget;
        options.self_collision = asked.self_collision;
        body_ = body ? body : default_body(pattern->content.pattern.body);
        session_.set_options(options);
        session_.set_body(body_);
        session_.set_pattern(pattern->content.pattern);
        session_.advance(0);
    }

    void set_pattern(const DocumentPointer& pattern) { session_.set_pattern(pattern->content.pattern); }
    void set_body(const BodyPointer& body) {
        body_ = body;
        session_.set_body(body);
    }
    void start() { session_.start(); }
    void pause() { session_.pause(); }
    void reset() { session_.reset(); }
    void let_go() { session_.let_go(); }
    void unpin_all() { session_.unpin_all(); }
    void pull_to(const Three& to) { session_.pull_to(vector_of(to, "to")); }
    void pin(int triangle, const Three& weights) { session_.pin(point(triangle, weights)); }
    void pull(int triangle, const Three& to, const Three& weights) {
        const Vec3f target = vector_of(to, "to");
        session_.pull(point(triangle, weights), target);
    }

    Frame advance(int frames) {
        within(frames, kFrames, "frames");
        const py::gil_scoped_release release;
        const std::scoped_lock lock(stepping_);
        std::optional<sim::ThreadLimit> limit;
        if (threads_) limit.emplace(*threads_);
        session_.advance(0);
        for (int i = 0; i < frames; ++i) {
            session_.advance(1);
            look_for_signals();
        }
        return {session_.frame()};
    }

    Frame frame() const { return {session_.frame()}; }
    BodyPointer body() const { return body_; }

 private:
    // A point of the newest frame.
    sim::ClothPoint point(int triangle, const Three& weights) const {
        const FramePointer frame = session_.frame();
        const std::size_t count = frame->mesh.triangles.size();
        if (triangle < 0 || static_cast<std::size_t>(triangle) >= count)
            throw sim::InputError("", "triangle",
                                  "no triangle " + std::to_string(triangle) + ": there are " + std::to_string(count));
        double sum = 0;
        for (const double weight : weights) sum += within(weight, {0.0, 1.0}, "weights");
        if (std::abs(sum - 1) > 1e-6) throw sim::InputError("", "weights", "must sum to 1");
        return {.frame = frame->number,
                .triangle = static_cast<std::uint32_t>(triangle),
                .weights = vector_of(weights, "weights")};
    }

    std::optional<int> threads_;
    BodyPointer body_;
    std::mutex stepping_;  // one thread advances at a time
    sim::Session session_{sim::SessionDrive::Caller};
};

const sim::SessionFrame& frame_of(const py::object& self) {
    return *self.cast<const Frame&>().frame;
}

void add_frames(py::module_& module) {
    py::class_<Frame>(
        module, "Frame",
        "The state of a session at one time. It does not change, and its arrays are read-only views without "
        "a copy, which keep it alive.")
        .def_property_readonly(
            "number", [](const Frame& self) { return self.frame->number; }, "Grows with each frame.")
        .def_property_readonly(
            "stage", [](const Frame& self) { return name_of(self.frame->stage); },
            "'empty', 'placed' (unsewn), 'sewing', 'draping', 'moving', 'settled' or 'failed'.")
        .def_property_readonly(
            "is_running", [](const Frame& self) { return self.frame->is_running; }, "Whether advance() simulates.")
        .def_property_readonly(
            "mesh",
            [](const Frame& self) {
                return GarmentMeshView{std::shared_ptr<const sim::DrawMesh>(self.frame, &self.frame->mesh)};
            },
            "The cloth; panels are separate while they are unsewn.")
        .def_property_readonly(
            "seam_lines", [](const py::object& self) { return view_of(frame_of(self).seam_lines, self); },
            "Both ends of each link of a seam that is not closed yet, float32 of shape (links, 2, 3), m.")
        .def_property_readonly(
            "seam_line_seams", [](const py::object& self) { return view_of(frame_of(self).seam_line_seams, self); },
            "The seam of each of these, int32 of shape (links,): index into the pattern's seams.")
        .def_property_readonly(
            "pins", [](const py::object& self) { return view_of(frame_of(self).pins, self); },
            "Positions of what is pinned, float32 of shape (pins, 3), m.")
        .def_property_readonly(
            "simulated_seconds", [](const Frame& self) { return self.frame->statistics.simulated_seconds; },
            "Simulated time since sewing began, s.")
        .def_property_readonly(
            "rms_speed", [](const Frame& self) { return self.frame->statistics.rms_speed; },
            "Speed of the cloth, m/s: root of the mass-weighted mean square.")
        .def_property_readonly(
            "problem", [](const Frame& self) { return self.frame->problem; },
            "Why the stage is 'empty' or 'failed'; else empty.")
        .def_property_readonly(
            "messages", [](const Frame& self) { return self.frame->messages; },
            "What the user should know, the newest last.")
        .def("__repr__", [](const Frame& self) {
            return "<selvedge.Frame " + std::to_string(self.frame->number) + ", " + name_of(self.frame->stage) + ">";
        });
}

}  // namespace

void add_sessions(py::module_& module) {
    add_frames(module);
    constexpr Three kMiddle{1.0 / 3, 1.0 / 3, 1.0 / 3};
    py::class_<CallerSession>(module, "_Session", "A session over a document.")
        .def(py::init<const DocumentPointer&, const BodyPointer&, const DressArguments&, std::optional<int>>(),
             py::arg("pattern"), py::arg("body").none(true), py::arg("arguments"), py::arg("threads").none(true),
             "A session whose panels are placed.")
        .def("_set_document", &CallerSession::set_pattern, py::arg("pattern"), "Changes the pattern.")
        .def("set_body", &CallerSession::set_body, py::arg("body").none(false),
             "Changes the body; the garment starts again.")
        .def("start", &CallerSession::start, "Lets advance() simulate; closes the seams first.")
        .def("pause", &CallerSession::pause, "Lets advance() simulate nothing until start().")
        .def("reset", &CallerSession::reset, "Puts the panels back to where they were placed, unsewn, without pins.")
        .def("advance", &CallerSession::advance, py::arg("frames") = 1,
             "Carries out what was asked for, simulates up to so many frames, each an adaptation and its steps (1/30 "
             "s),\n"
             "and returns the newest Frame. The interpreter's lock is released meanwhile. Raises what a signal raises.")
        .def("pin", &CallerSession::pin, py::arg("triangle"), py::arg("weights") = kMiddle,
             "Pins a point of the newest frame's mesh: a triangle, and barycentric weights that sum to 1.\n"
             "Works once the garment is sewn. Raises InputError if there is no such point.")
        .def("unpin_all", &CallerSession::unpin_all, "Removes all pins.")
        .def("pull", &CallerSession::pull, py::arg("triangle"), py::arg("to"), py::arg("weights") = kMiddle,
             "Takes hold of a point of the newest frame's mesh and moves it towards `to`, (3,), m.")
        .def("pull_to", &CallerSession::pull_to, py::arg("to"), "Moves what is held towards another place, (3,), m.")
        .def("let_go", &CallerSession::let_go, "Lets go of what is held.")
        .def_property_readonly("frame", &CallerSession::frame, "The newest Frame.")
        .def_property_readonly(
            "stage", [](const CallerSession& self) { return name_of(self.frame().frame->stage); },
            "The stage of the newest frame, see Frame.stage.")
        .def_property_readonly("body", &CallerSession::body, "The body that wears it.");
}

}  // namespace selvedge::python
