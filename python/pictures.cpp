#include "python/pictures.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/option_texts.h"
#include "app/picture.h"
#include "python/errors.h"
#include "python/meshes.h"
#include "python/results.h"
#include "python/views.h"
#include "render/image/image.h"
#include "render/output/interface_fonts.h"

namespace selvedge::python {

std::mutex& drawing() {
    static std::mutex mutex;
    return mutex;
}

namespace {

// Shape (height, width, 4), uint8, over the picture's own memory.
py::array picture_array(render::Image image) {
    auto kept = std::make_unique<render::Image>(std::move(image));
    const render::Image& picture = *kept;
    const py::capsule owner(kept.get(), [](void* pointer) { delete static_cast<render::Image*>(pointer); });
    static_cast<void>(kept.release());  // the capsule deletes it
    const std::vector<py::ssize_t> shape{picture.height_px, picture.width_px, 4};
    return py::array(py::dtype::of<std::uint8_t>(), shape, {}, picture.pixels.data(), owner);
}

render::Image draw(const app::RenderSubject& subject, app::PictureOptions options) {
    const std::scoped_lock lock(drawing());
    options.legend_font = render::read_legend_font();
    return draw_picture(subject, options);
}

py::array render_result(const ResultPointer& result, const BodyPointer& body, const std::vector<std::string>& texts) {
    render::Image image;
    {
        const py::gil_scoped_release release;
        const app::PictureOptions options = picture_of(*result, app::read_picture_options(texts));
        image = draw({.garment = result->dressed.mesh,
                      .body = &(body ? body : result->body)->body(),
                      .hierarchy = &result->dressed.hierarchy},
                     options);
    }
    return picture_array(std::move(image));
}

py::array render_mesh(const GarmentMeshView& mesh, const BodyPointer& body, const std::vector<std::string>& texts,
                      const std::string& fabric) {
    render::Image image;
    {
        const py::gil_scoped_release release;
        app::PictureOptions options = app::read_picture_options(texts);
        if (!fabric.empty()) options.material = render::material_of(sim::find_fabric(fabric));
        show_design(options, fabric);
        image = draw({.garment = *mesh.mesh, .body = body ? &body->body() : nullptr}, options);
    }
    return picture_array(std::move(image));
}

// name: of what the picture is for, in messages.
render::Image image_of(const py::object& picture, const std::string& name) {
    const auto array = py::array_t<std::uint8_t, py::array::c_style>::ensure(picture);
    PyErr_Clear();
    if (!array || array.ndim() != 3 || array.shape(0) < 1 || array.shape(1) < 1 || array.shape(2) < 3 ||
        array.shape(2) > 4)
        throw sim::InputError("", "picture", "must be a uint8 array of shape (height, width, 3 or 4)");
    render::check_image_size(array.shape(1), array.shape(0), name);
    render::Image image(static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0)));
    const auto channels = static_cast<std::size_t>(array.shape(2));
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        std::copy_n(array.data() + i * channels, channels, image.pixels[i].begin());
    return image;
}

void write_picture(const py::object& picture, const std::filesystem::path& path) {
    const render::Image image = image_of(picture, path.string());
    const py::gil_scoped_release release;
    app::check_output(path, app::kPictureExtensions);
    write_png(path, image);
}

py::bytes png_of(const py::object& picture) {
    const render::Image image = image_of(picture, "");
    std::string bytes;
    {
        const py::gil_scoped_release release;
        bytes = encode_png(image);
    }
    return bytes;
}

}  // namespace

void add_pictures(py::module_& module) {
    module.def("_render_result", &render_result, py::arg("result"), py::arg("body").none(true), py::arg("options"),
               "A picture of a result.");
    module.def("_render_mesh", &render_mesh, py::arg("mesh"), py::arg("body").none(true), py::arg("options"),
               py::arg("fabric"), "A picture of a mesh.");
    module.def("_png", &png_of, py::arg("picture"), "A picture as the bytes of a PNG file.");
    module.def("write_png", &write_picture, py::arg("picture"), py::arg("path"),
               "Writes a picture, uint8 of shape (height, width, 3 or 4), as a PNG file. Raises InputError.");
}

}  // namespace selvedge::python
