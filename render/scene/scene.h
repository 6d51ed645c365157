#pragma once
// What a picture shows, as plain data: whoever has a garment fills it, the renderer draws it, and neither knows the
// other.  (SPEC 6)
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "render/scene/camera.h"
#include "sim/body/body.h"
#include "sim/core/math.h"
#include "sim/mesh/plain_mesh.h"
#include "sim/pattern/fabric.h"
#include "sim/tartan/sett.h"

namespace selvedge::render {

enum class ShowMode {
    Tartan,  // woven from the sett, by material coordinates; plain where the mesh has none
    Level,   // triangles coloured by their level
    Edges,   // plain cloth with the triangles' edges
    Plain,
    // What these show is in ClothItem::paint and Scene::solids (render/marks/show.h):
    Vertices,    // spheres that halve with each level
    Hierarchy,   // the levels' triangles stacked beside the flat panels
    StrainWarp,  // along the warp
    StrainWeft,
    Strain,     // the greater of the two
    Clearance,  // how far the cloth stands off the body
    Panels,
    Seams,
};

inline constexpr const char* kShowModeNames =
    "tartan, level, edges, plain, vertices, hierarchy, strain-warp, strain-weft, strain, clearance, panels, seams";
std::optional<ShowMode> parse_show_mode(std::string_view name);

// Colours that belong to triangles and their corners, by way of a map: between corners the map is followed, where
// colours themselves would be mixed.
struct ClothPaint {
    std::vector<sim::Rgb8> map;                // at least two
    std::vector<std::array<float, 3>> places;  // per triangle, of its corners along the map, 0..1

    bool operator==(const ClothPaint&) const = default;
};

// How a surface takes light beyond its colour.
struct Material {
    float gloss = 0.008F;     // share of light that is mirrored, 0..1: wool 0.005, cotton 0.008, silk 0.05
    float roughness = 0.35F;  // 0..1, of the highlight: silk 0.25, wool 0.5
    float sheen = 0.045F;     // share of light that fibres on the surface catch at the rim: wool 0.06, silk 0.02

    bool operator==(const Material&) const = default;
};

// How a fabric takes light.
Material material_of(const sim::Fabric& fabric);

struct ClothItem {
    sim::PlainMesh mesh;
    sim::Sett sett;
    Vec2f sett_position{0, 0};  // m, in the fabric's (weft, warp) directions: where the first stripe begins
    float sett_scale = 1;       // of the sett's own repeat
    ShowMode show = ShowMode::Tartan;
    sim::Rgb8 colour{0xE4, 0xDF, 0xD3};  // where no tartan is woven
    Material material{};
    std::optional<ClothPaint> paint{};  // in the modes that follow Plain
    float ink = 0;                      // 0..1, of the triangles' edges in them

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

// A surface with colours of its own: marks on the cloth. It casts no shadow.
struct SolidItem {
    std::vector<Vec3f> x;            // m
    std::vector<Vec3f> normals;      // unit
    std::vector<sim::Rgb8> colours;  // per vertex
    std::vector<std::array<std::uint32_t, 3>> triangles;

    bool operator==(const SolidItem&) const = default;
};

// One key light with shadows, a fill from the other side without, and the light of the room from all round.
struct Light {
    Vec3f to_key{-0.5F, 0.7F, 0.6F};  // towards the light, unit or not
    Vec3f to_fill{0.7F, 0.2F, 0.7F};
    float key = 0.90F;  // irradiance, 1 makes white white
    float fill = 0.12F;
    float sky = 0.36F;     // from above
    float bounce = 0.19F;  // from below
};

struct Background {
    sim::Rgb8 centre{0xF1, 0xEF, 0xEB};
    sim::Rgb8 edge{0xCC, 0xCA, 0xC6};
    bool is_transparent = false;  // only the ground's shadow remains of it
};

struct Scene {
    std::vector<ClothItem> cloths;
    std::vector<BodyItem> bodies;
    std::vector<SolidItem> solids{};
    Camera camera;
    Light light;
    Background background;
    bool has_ground = true;  // catches shadows; has no horizon
    float ground_y = 0;      // m
};

// A scene seen otherwise than by the camera and light in it. Whoever shares a scene does not change it any more: the
// same pointer is the same matter, and nothing is compared.
struct SceneView {
    std::shared_ptr<const Scene> scene;
    Camera camera;
    Light light;
};

// The surface of a body with its normals.
BodyItem make_body_item(const sim::Body& body);

// All cloth and body vertices.
std::vector<Vec3f> scene_points(const Scene& scene);

// The camera that holds the whole scene. Pre: the scene is not empty.
Camera frame_scene(const Scene& scene, View view, float aspect);

// Lights that stand with the camera, as in a studio: key from the upper left, fill from the right.
Light studio_light(const Camera& camera);

// The same, softer: colours that stand for figures must not be taken for others in shade.
Light even_light(const Camera& camera);

}  // namespace selvedge::render
