#pragma once
// What a picture of a dressed body costs: the first, those of a turning camera and those of moving cloth.
#include <string>
#include <vector>

#include "bench/support/table.h"
#include "render/draw/renderer.h"

namespace selvedge::bench {

struct PictureExperiment {
    render::RenderOptions render{};
    int triangles = 20000;  // of the cloth, at least: it is split where it has fewer
    int pictures = 12;      // of each kind
    render::View view = render::View::ThreeQuarter;
    float turn = 0.06F;      // rad from one picture to the next
    float ripple = 0.0025F;  // m that the moving cloth moves by
};

struct PictureFigure {
    std::string kind;
    double total = 0;      // ms by wall clock, median over the pictures
    double processor = 0;  // ms of processor time of all threads
    render::PictureTimes parts;
};

struct PictureReport {
    std::size_t cloth_triangles = 0;
    std::size_t body_triangles = 0;
    int width_px = 0;
    int height_px = 0;
    std::vector<PictureFigure> figures;
};

// Cloths and bodies of the scene; its camera and light are the experiment's.
PictureReport measure_pictures(const render::Scene& scene, const PictureExperiment& experiment);

Table table_of(const PictureReport& report);

}  // namespace selvedge::bench
