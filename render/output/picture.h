#pragma once
// Draws a picture of a garment and a body: what is in it, how the cloth looks, from where it is seen, and where the
// legend stands. The program's commands, the Python module and the library draw so.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/draw/renderer.h"
#include "render/image/image.h"
#include "render/looks/cloth_looks.h"
#include "render/marks/legend.h"
#include "render/marks/show.h"
#include "render/output/view_choice.h"
#include "render/scene/scene.h"
#include "sim/body/body.h"
#include "sim/core/numbers.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern.h"
#include "sim/tartan/sett.h"

namespace selvedge::render {

enum class Framing { All, Garment };

struct PictureOptions {
    int width_px = 1024;
    int height_px = 1024;
    int samples = 4;
    int supersample = 1;
    std::optional<View> view;            // none: from the front; a hierarchy from above
    std::optional<CameraChoice> camera;  // replaces the view
    Framing framing = Framing::All;
    ShowMode show = ShowMode::Tartan;
    std::optional<sim::Sett> sett;       // none: kDefaultTartan
    std::optional<double> sett_size;     // m, of one repeat; none: the tartan's own size
    std::optional<Vec2d> sett_position;  // m, (weft, warp); none: zero
    bool is_transparent = false;
    Material material{};                         // light response of the cloth
    std::optional<sim::SurfaceDesign> design{};  // of all panels, by --tartan or --design; none: the pattern's
    // What each panel looks like: fabrics and surface designs of this pattern; null: the sett and the material above.
    std::shared_ptr<const sim::Pattern> pattern{};
    std::shared_ptr<ClothLooks> looks{};               // keeps what was read for it; set if `pattern` is
    SurfaceChoice surface{};                           // the simulated triangles, or a curved surface over them
    std::shared_ptr<const OutlineFont> legend_font{};  // null: the built-in bitmap font
};

// Values of the options. Throw InputError, whose place is the option of the command line.
inline constexpr sim::Limits<double> kSettSizesCm{0.1, 500};
inline constexpr sim::Limits<int> kSupersamples{1, 4};
bool is_sample_count(int samples);  // 1, 2, 4, 8
void check_size(const PictureSize& size);
Framing parse_framing(const std::string& text);            // "all", "garment"
sim::SurfaceDesign parse_design(const std::string& text);  // "#RRGGBB", "test", or a picture's file

// Takes from the pattern what the options do not say, as if its garment were made of this fabric (empty: the pattern's
// own): which fabrics and designs the panels show. Reads no file.
void name_looks(PictureOptions& picture, const sim::Pattern& pattern, const std::string& fabric);

// Reads the fabrics and designs that name_looks() has named, and takes from the pattern how the cloth is drawn where
// the options do not say. file: the pattern's name in messages. Pre: name_looks(). Throws InputError.
void read_looks(PictureOptions& picture, const sim::Pattern& pattern, const std::string& fabric,
                const std::string& file);

// A mesh has no pattern: with a design, it is drawn as if its pattern had no more than that and this fabric (empty: the
// default). Throws InputError if the design's picture cannot be read.
void show_design(PictureOptions& options, const std::string& fabric);

// The sett for the cloth: the requested tartan at the requested size.
sim::Sett chosen_sett(const PictureOptions& options);

// Throws InputError if no GL context is available (render/gl/context.h), or none with this many samples. Call it before
// long work.
void check_can_draw(const PictureOptions& options = {});

// The objects in a picture; a null pointer means that there is none.
struct RenderSubject {
    const sim::DrawMesh& garment;
    const sim::Body* body = nullptr;
    const sim::TriangleHierarchy* hierarchy = nullptr;
};

// Throws InputError if the mode requires a body or a hierarchy and there will be none. Call it before long work.
void check_can_show(ShowMode show, bool has_body, bool has_hierarchy);

// Several threads may call it: one draws at a time, because only one renderer may exist (render/draw/renderer.h).
// Leaves out triangles with non-finite coordinates. Throws InputError if nothing is left to draw, no GL context is
// available (render/gl/context.h), or the mode requires data that is missing.
Image draw_picture(const RenderSubject& subject, const PictureOptions& options);

// The layout of a picture: builds the scene, and chooses camera and legend corner so that the subject is framed and the
// legend does not cover it.

struct Layout {
    Scene scene;
    std::optional<Legend> legend;
    Corner corner = Corner::LowerLeft;  // the legend's corner
    Vec3f axis = Vec3f::Zero();         // a point on the vertical axis that the subject rotates about
};

// Unit, from the subject to the camera that the options ask for.
Vec3f seen_from(const PictureOptions& options);

// Frames a subject that rotates by these angles (rad): at each angle it stays in the picture and clear of the legend.
// also_framed: points that are to be in the picture too, for example where the subject will be.
// Throws InputError if nothing is left to draw or the mode requires data that is missing.
Layout compose(const RenderSubject& subject, const PictureOptions& options, const std::vector<float>& turns = {0},
               const std::vector<Vec3f>& also_framed = {});

// A later moment of a subject that moves: the camera of the first layout, moved by `by` (m), with the same floor and
// the legend in the same corner. Pre: options.show is not Hierarchy. Throws as compose().
Layout moved(const Layout& first, const RenderSubject& subject, const PictureOptions& options, const Vec3f& by);

// The scene after a turn by `angle` (rad); the lights keep their direction relative to the camera.
Scene turned(const Layout& layout, const PictureOptions& options, float angle);

// Render options for one picture of the scene.
RenderOptions render_options(const PictureOptions& options);

}  // namespace selvedge::render
