#pragma once
// What a picture shows, as plain data. The caller fills it in from a garment and the renderer draws it, so that neither
// depends on the other.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "render/image/image.h"
#include "render/scene/camera.h"
#include "sim/body/body.h"
#include "sim/core/math.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/pattern/fabric.h"
#include "sim/tartan/sett.h"

namespace selvedge::render {

enum class ShowMode {
    Tartan,  // woven from the sett, by material coordinates; plain if the mesh has none
    Level,   // triangles coloured by their level
    Edges,   // plain cloth with the triangles' edges
    Plain,
    // The data of the following modes is in ClothItem::paint and Scene::solids (render/marks/show.h):
    Vertices,    // spheres whose radius halves with each level
    Hierarchy,   // the levels' triangles stacked beside the flat panels
    StrainWarp,  // along the warp
    StrainWeft,
    Strain,     // the larger of the two
    Clearance,  // distance of the cloth from the body
    Panels,
    Seams,
};

std::optional<ShowMode> parse_show_mode(std::string_view name);
std::string show_mode_names();  // that parse_show_mode() knows, separated by commas

// Colours of triangles' corners, given as positions along a colour map. The shader interpolates the position, not the
// colour, so that colours between two corners follow the map.
struct ClothPaint {
    std::vector<sim::Rgb8> map;                // at least two colours
    std::vector<std::array<float, 3>> places;  // per triangle: its corners' positions along the map, 0..1

    bool operator==(const ClothPaint&) const = default;
};

// How a surface reflects light, apart from its colour.
struct Material {
    float gloss = 0.008F;     // fraction of light reflected specularly, 0..1: wool 0.005, cotton 0.008, silk 0.05
    float roughness = 0.35F;  // 0..1, width of the highlight: silk 0.25, wool 0.5
    float sheen = 0.045F;     // fraction of light that surface fibres scatter at grazing angles: wool 0.06, silk 0.02

    bool operator==(const Material&) const = default;
};

// How a fabric takes light.
Material material_of(const sim::Fabric& fabric);

// A picture that is printed on cloth, by its material coordinates.
struct ClothPicture {
    std::shared_ptr<const Image> image{};  // opaque
    Vec2f size{0.2F, 0.2F};                // m, of the whole picture
    Vec2f position{0, 0};                  // m, (weft, warp): its lower left corner
    float rotation = 0;                    // rad, counter-clockwise about the position
    bool is_repeated = true;               // false: placed once
    sim::Rgb8 ground{0xF4, 0xF1, 0xEA};    // around one that is placed once, and the tint of its wrong side

    bool operator==(const ClothPicture&) const = default;
};

// From a place on the cloth (m, weft and warp) to texture coordinates (u, v): u = rows[0] . (weft, warp, 1). Row 0 of
// the image is at v = 0.
std::array<Vec3f, 2> picture_rows(const ClothPicture& picture);

struct ClothItem {
    sim::DrawMesh mesh;
    sim::Sett sett;
    Vec2f sett_position{0, 0};              // m, in the fabric's (weft, warp) directions: start of the first stripe
    float sett_scale = 1;                   // factor on the sett's own repeat
    std::optional<ClothPicture> picture{};  // in the mode Tartan, instead of the sett
    ShowMode show = ShowMode::Tartan;
    sim::Rgb8 colour{0xE4, 0xDF, 0xD3};  // if no tartan is woven
    Material material{};
    std::optional<ClothPaint> paint{};  // in the modes after Plain
    float ink = 0;                      // 0..1, darkness of the triangles' edges in those modes

    bool operator==(const ClothItem&) const = default;
};

struct BodyItem {
    std::vector<Vec3f> x;        // m
    std::vector<Vec3f> normals;  // unit
    std::vector<std::array<std::uint32_t, 3>> triangles;
    sim::Rgb8 colour{0xD0, 0xBF, 0xB0};  // between clay and skin
    Material material{.gloss = 0.017F, .roughness = 0.29F, .sheen = 0.05F};

    bool operator==(const BodyItem&) const = default;
};

// A surface with a colour per vertex, such as marks on the cloth. It casts no shadow.
struct SolidItem {
    std::vector<Vec3f> x;            // m
    std::vector<Vec3f> normals;      // unit
    std::vector<sim::Rgb8> colours;  // per vertex
    std::vector<std::array<std::uint32_t, 3>> triangles;

    bool operator==(const SolidItem&) const = default;
};

// One key light with shadows, a fill light from the other side without shadows, and ambient light.
struct Light {
    Vec3f to_key{-0.5F, 0.7F, 0.6F};  // direction towards the light; need not be unit
    Vec3f to_fill{0.7F, 0.2F, 0.7F};
    float key = 0.90F;  // irradiance; at 1, a white surface that faces the light is drawn white
    float fill = 0.12F;
    float sky = 0.36F;     // ambient light from above
    float bounce = 0.19F;  // ambient light from below
};

struct Background {
    sim::Rgb8 centre{0xF1, 0xEF, 0xEB};
    sim::Rgb8 edge{0xCC, 0xCA, 0xC6};
    bool is_transparent = false;  // alpha is 0 except for the ground's shadow
};

struct Scene {
    std::vector<ClothItem> cloths;
    std::vector<BodyItem> bodies;
    std::vector<SolidItem> solids{};
    Camera camera;
    Light light;
    Background background;
    bool has_ground = true;  // it catches shadows and fades out without a horizon
    float ground_y = 0;      // m
};

// A scene with a camera and light other than its own. A shared scene must not be changed any more: the same pointer
// means the same content, and nothing is compared.
struct SceneView {
    std::shared_ptr<const Scene> scene;
    Camera camera;
    Light light;
};

// The surface of a body, with vertex normals.
BodyItem make_body_item(const sim::Body& body);

// All cloth and body vertices.
std::vector<Vec3f> scene_points(const Scene& scene);

// The camera that sees the whole scene. Pre: the scene is not empty.
Camera frame_scene(const Scene& scene, View view, float aspect);

// Lights that move with the camera, as in a studio: key from the upper left, fill from the right.
Light studio_light(const Camera& camera);

// The same directions but softer, for colours that stand for values: a colour in shade must not look like another one.
Light even_light(const Camera& camera);

}  // namespace selvedge::render
