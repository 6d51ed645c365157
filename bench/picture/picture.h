#pragma once
// Measures the time to render a picture of a dressed body: the first picture, pictures with a moving camera and
// pictures with moving cloth, by the renderer and by the preview renderer.
#include <string>
#include <vector>

#include "bench/support/table.h"
#include "render/draw/renderer.h"

namespace selvedge::bench {

struct PictureExperiment {
    render::RenderOptions render{};
    int triangles = 20000;  // minimum for the cloth: a mesh with fewer is subdivided
    int pictures = 12;      // of each kind
    render::View view = render::View::ThreeQuarter;
    float turn = 0.06F;      // rad, rotation of the camera from one picture to the next
    float ripple = 0.0025F;  // m, moving cloth is displaced along its normals by 0 to twice this
};

struct PictureTimings {
    std::string kind;
    double total = 0;            // ms of wall-clock time, median over the pictures
    double processor = 0;        // ms of CPU time of all threads, median
    render::PictureTimes parts;  // ms, medians; measured on separate pictures
};

struct PictureReport {
    std::size_t cloth_triangles = 0;
    std::size_t body_triangles = 0;
    int width_px = 0;
    int height_px = 0;
    std::vector<PictureTimings> figures;
};

// Draws the cloths and bodies of the given scene. The experiment sets its own camera and light.
PictureReport measure_pictures(const render::Scene& given, const PictureExperiment& experiment);

Table table_of(const PictureReport& report);

}  // namespace selvedge::bench
