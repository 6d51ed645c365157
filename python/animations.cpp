#include "python/animations.h"

#include <unistd.h>
#include <algorithm>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "app/animation_run.h"
#include "app/option_texts.h"
#include "python/bodies.h"
#include "python/errors.h"
#include "python/meshes.h"
#include "python/patterns.h"
#include "python/pictures.h"
#include "python/results.h"
#include "python/views.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/fixed_mesh.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/parallel.h"
#include "sim/dress/worn_together.h"
#include "sim/session/animation_report.h"

namespace selvedge::python {
namespace {

struct MovedFrame {
    int number = 0;
    double seconds = 0;
    sim::DrawMesh mesh;
    std::vector<Vec3f> body;   // m, of its surface
    std::vector<Vec3f> fixed;  // m, of the vertices of the fixed mesh
};

using MovedFramePointer = std::shared_ptr<const MovedFrame>;

struct AnimationFrame {
    MovedFramePointer frame;
};

// What is dressed by which arguments.
struct Asked {
    const DocumentPointer& pattern;
    const BodyPointer& body;
    const std::vector<DocumentPointer>& over;
    const DressArguments& dress;
};

// One thread at a time, which holds the interpreter's lock when it calls, and not meanwhile.
class PythonAnimation {
 public:
    PythonAnimation(const Asked& asked, const std::vector<std::string>& texts, std::optional<int> threads,
                    const sim::Progress& progress)
        : threads_(threads) {
        app::AnimateArguments arguments = app::read_animation_options(texts);
        arguments.garment.dress = dress_options(asked.dress);
        arguments.garment.fabric = asked.dress.fabric;
        std::vector<sim::Pattern> outer;
        for (const DocumentPointer& one : asked.over) outer.push_back(one->content.pattern);
        app::Worn worn;
        worn.pattern = sim::worn_together(asked.pattern->content.pattern, outer, asked.pattern->file, worn.notes);
        body_ = asked.body ? asked.body : default_body(worn.pattern.body);
        arguments.body.source = body_->made().source.empty() ? body_->body().name : body_->made().source;
        prepare(arguments, worn.pattern);
        app::Actor actor = app::make_actor(body_->made(), arguments.body.source, arguments.motion);
        std::optional<sim::ThreadLimit> limit;
        if (threads_) limit.emplace(*threads_);
        run_ = std::make_unique<app::AnimationRun>(std::move(arguments), worn, std::move(actor), progress);
        open_outputs();
        const sim::Cloth& cloth = run_->animation().cloth();
        const auto most = static_cast<std::size_t>(run_->arguments().caches.most_triangles);
        fixed_ = std::make_shared<sim::FixedMesh>(
            make_fixed_mesh(cloth, run_->animation().panel_names(), fixed_level_for(cloth, most)));
    }

    // In a forked child, what its parent writes and draws by is left alone.
    ~PythonAnimation() {
        const std::scoped_lock draws(drawing());
        if (getpid() == process_) {
            run_.reset();
        } else {
            static_cast<void>(run_.release());
        }
    }
    PythonAnimation(const PythonAnimation&) = delete;
    PythonAnimation& operator=(const PythonAnimation&) = delete;

    // The next frame, which is written to film and caches; null when there is none, or the animation was stopped.
    MovedFramePointer next() {
        const std::scoped_lock lock(moving_);
        check_process();
        if (is_finished_) return nullptr;
        std::optional<sim::ThreadLimit> limit;
        if (threads_) limit.emplace(*threads_);
        if (has_begun_ && !run_->advance()) {
            end();
            return nullptr;
        }
        has_begun_ = true;
        {
            const std::scoped_lock draws(drawing());
            run_->write_frame();
        }
        return frame();
    }

    // Ends it here: film, caches and report have the frames until now, of which there is at least the first.
    void stop() {
        const std::scoped_lock lock(moving_);
        check_process();
        if (is_finished_) return;
        if (!has_begun_) {
            const std::scoped_lock draws(drawing());
            run_->write_frame();
            has_begun_ = true;
        }
        end();
    }

    int frame_count() const { return run_->animation().frame_count(); }
    double frames_per_second() const { return run_->animation().frames_per_second(); }
    bool is_finished() const { return is_finished_; }
    bool has_outputs() const { return !outputs_of(run_->arguments()).empty(); }
    BodyPointer body() const { return body_; }
    GarmentMeshView fixed_mesh() const { return {std::shared_ptr<const sim::DrawMesh>(fixed_, &fixed_->mesh)}; }
    std::string motion() const { return run_->actor().clip.name; }

    std::string report() {
        const std::scoped_lock lock(moving_);
        return to_json(run_->animation(), motion(), {}, run_->actor().notes);
    }

 private:
    // What draws; not while the body is dressed, when Python's functions are called.
    static void prepare(app::AnimateArguments& arguments, const sim::Pattern& pattern) {
        const std::scoped_lock draws(drawing());
        prepare_animation(arguments, pattern);
    }
    void open_outputs() {
        const std::scoped_lock draws(drawing());
        run_->open_outputs();
    }

    // A film's renderer has threads, which a forked child lacks.
    void check_process() const {
        if (getpid() != process_) throw std::runtime_error("an animation belongs to the process that has begun it");
    }

    void end() {
        is_finished_ = true;
        const std::scoped_lock draws(drawing());
        run_->finish();
        const app::AnimateArguments& asked = run_->arguments();
        if (!asked.report_file.empty())
            sim::write_file_atomically(asked.report_file,
                                       to_json(run_->animation(), motion(), {}, run_->actor().notes));
    }

    MovedFramePointer frame() const {
        const sim::Animation& animation = run_->animation();
        auto frame = std::make_shared<MovedFrame>();
        frame->number = animation.frame();
        frame->seconds = animation.seconds();
        frame->mesh = draw_mesh(animation.cloth(), animation.panel_names());
        frame->body.assign(animation.body_points().begin(), animation.body_points().end());
        sample(*fixed_, animation.cloth(), frame->fixed);
        return frame;
    }

    std::optional<int> threads_;
    pid_t process_ = getpid();
    BodyPointer body_;
    std::mutex moving_;
    std::unique_ptr<app::AnimationRun> run_;  // never null
    std::shared_ptr<sim::FixedMesh> fixed_;
    bool has_begun_ = false, is_finished_ = false;
};

std::unique_ptr<PythonAnimation> make_animation(const DocumentPointer& pattern, const BodyPointer& body,
                                                const std::vector<DocumentPointer>& over,
                                                const DressArguments& arguments, const std::vector<std::string>& texts,
                                                std::optional<int> threads, const py::object& progress) {
    within(threads, sim::kThreadCounts, "threads");
    const sim::Progress reports = progress_to(progress);
    const py::gil_scoped_release release;
    return std::make_unique<PythonAnimation>(Asked{pattern, body, over, arguments}, texts, threads, reports);
}

const MovedFrame& moved_frame_of(const py::object& self) {
    return *self.cast<const AnimationFrame&>().frame;
}

void add_animation_frames(py::module_& module) {
    py::class_<AnimationFrame>(
        module, "AnimationFrame",
        "One frame of an animation. It does not change and stays when the animation goes on: its arrays are read-only "
        "views of its own memory, without a further copy, which keep it alive.")
        .def_property_readonly(
            "number", [](const AnimationFrame& self) { return self.frame->number; }, "From 0, the dressed body.")
        .def_property_readonly(
            "seconds", [](const AnimationFrame& self) { return self.frame->seconds; }, "Time since the first frame, s.")
        .def_property_readonly(
            "mesh",
            [](const AnimationFrame& self) {
                return GarmentMeshView{std::shared_ptr<const sim::DrawMesh>(self.frame, &self.frame->mesh)};
            },
            "The cloth as it is simulated: its vertices and triangles differ from frame to frame.")
        .def_property_readonly(
            "positions", [](const py::object& self) { return view_of(moved_frame_of(self).mesh.x, self); },
            "Positions of `mesh`, float32 of shape (vertices, 3), m.")
        .def_property_readonly(
            "triangles", [](const py::object& self) { return view_of(moved_frame_of(self).mesh.triangles, self); },
            "Vertex indices of `mesh`, uint32 of shape (triangles, 3).")
        .def_property_readonly(
            "fixed_positions", [](const py::object& self) { return view_of(moved_frame_of(self).fixed, self); },
            "Positions on Animation.fixed_mesh, whose vertices keep their number and order: float32 of shape "
            "(vertices, 3), m; what .pc2 and .glb hold.")
        .def_property_readonly(
            "body_positions", [](const py::object& self) { return view_of(moved_frame_of(self).body, self); },
            "Positions of the body's vertices, in the order of Body.vertices, float32 of shape (vertices, 3), m.")
        .def("__repr__", [](const AnimationFrame& self) {
            return "<selvedge.AnimationFrame " + std::to_string(self.frame->number) + ">";
        });
}

}  // namespace

void add_animations(py::module_& module) {
    add_animation_frames(module);
    py::class_<PythonAnimation>(module, "_Animation", "An animation over documents.")
        .def(py::init(&make_animation), py::arg("pattern"), py::arg("body").none(true), py::arg("over"),
             py::arg("arguments"), py::arg("options"), py::arg("threads").none(true), py::arg("progress").none(true),
             "Dresses the body.")
        .def(
            "_next",
            [](PythonAnimation& self) -> std::optional<AnimationFrame> {
                look_for_signals();
                const py::gil_scoped_release release;
                MovedFramePointer frame = self.next();
                if (!frame) return std::nullopt;
                return AnimationFrame{std::move(frame)};
            },
            "The next frame; None at the end.")
        .def("stop", &PythonAnimation::stop, py::call_guard<py::gil_scoped_release>(),
             "Ends it: film, caches and report are written with the frames until now. Raises InputError.")
        .def_property_readonly("frame_count", &PythonAnimation::frame_count, "How many frames there will be.")
        .def_property_readonly("frames_per_second", &PythonAnimation::frames_per_second, "Of the animation.")
        .def_property_readonly("motion", &PythonAnimation::motion, "The motion's name.")
        .def_property_readonly("body", &PythonAnimation::body, "The body that moves, as it stands at rest.")
        .def_property_readonly("fixed_mesh", &PythonAnimation::fixed_mesh,
                               "The garment on a mesh whose vertices keep their number and order, as it was dressed.")
        .def_property_readonly("is_finished", &PythonAnimation::is_finished,
                               "Whether its files are written, and no frame follows.")
        .def_property_readonly("_has_outputs", &PythonAnimation::has_outputs, "Whether files are asked for.")
        .def("_report", &PythonAnimation::report, py::call_guard<py::gil_scoped_release>(), "The report as JSON.");
}

}  // namespace selvedge::python
