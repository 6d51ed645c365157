#pragma once
// Divides a garment's cloth into parts that look alike: of one fabric, with one surface design (sim::SurfaceDesign).
// Each part is a ClothItem with all vertices of the garment and the triangles of its panels.
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/scene/scene.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern.h"
#include "sim/pattern/surface_design.h"
#include "sim/tartan/sett.h"

namespace selvedge::render {

// The picture of a design, made opaque on its ground; for the test pattern, that. Throws InputError if its file cannot
// be read. Pre: the kind is Picture or Test.
ClothPicture picture_of(const sim::SurfaceDesign& design);

// Squares of a tenth of its side in rows of different hue and columns of different lightness, with an arrow along the
// warp and a mark in the corner that lies at the position.  (thesis fig. 3.19)
Image test_pattern();

// The sett of a tartan; for a colour, plain weave of that colour. Throws InputError for an unknown tartan and a wrong
// threadcount. Pre: the kind is Tartan or Colour.
sim::Sett sett_of(const sim::SurfaceDesign& design);

// What cloth shows that neither panel, garment nor fabric gives a design: plain weave of undyed yarns.
inline constexpr const char* kPlainCloth = "#EFEADF";
sim::SurfaceDesign plain_design();

// What one design looks like: woven, or printed.
struct ClothLook {
    sim::Sett sett{};  // without stripes if a picture is printed
    std::optional<ClothPicture> picture{};
};

// Keeps fabrics, setts and pictures that it has read, so that they are read once.
class ClothLooks {
 public:
    // What cannot be read or is unknown: Fail throws InputError, Replace takes the default in its place.
    enum class Unknown { Fail, Replace };
    explicit ClothLooks(Unknown unknown) : unknown_(unknown) {}

    // The parts of `cloth`, whose mesh is the garment's and which they resemble but for their look. Panels that the
    // pattern does not name look like the pattern. Parts without triangles are left out.
    std::vector<ClothItem> parts(ClothItem cloth, const sim::Pattern& pattern);

    // Reads all that the parts will need: before long work, so that what is missing is told first.
    void read(const sim::Pattern& pattern);

    // The design of a panel, or of the pattern as a whole: of the first of these that has one: the panel, its own
    // fabric, the pattern by its surface or its tartan, the pattern's fabric; else plain cloth.
    sim::SurfaceDesign design_of(const sim::Pattern& pattern, const sim::Panel& panel);
    sim::SurfaceDesign design_of(const sim::Pattern& pattern);

    // Reads fabrics again when they are needed next: the file of one was written.
    void forget_fabrics() { fabrics_.clear(); }

    // Valid until the next call.
    const ClothLook& look(const sim::SurfaceDesign& design);

 private:
    const sim::Fabric& fabric(const std::string& name);
    Unknown unknown_;
    std::map<std::string, sim::Fabric> fabrics_;
    std::vector<std::pair<sim::SurfaceDesign, ClothLook>> looks_;
};

}  // namespace selvedge::render
