#include "sim/exchange/glb_file.h"

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/glb_container.h"
#include "sim/core/json.h"
#include "sim/exchange/glb_document.h"
#include "sim/exchange/mesh_cache.h"
#include "sim/exchange/mesh_file.h"

namespace selvedge::sim {

using namespace glb;

namespace {

Json mesh_node(const char* name, std::size_t mesh = 0) {
    Json node = Json::object();
    node["name"] = name;
    node["mesh"] = mesh;
    return node;
}

Json one_mesh(const char* name, Json primitives) {
    Json mesh = Json::object();
    mesh["name"] = name;
    mesh["primitives"] = std::move(primitives);
    return Json::array({std::move(mesh)});
}

struct FourBones {
    std::array<std::uint16_t, 4> bones;
};
struct FourWeights {
    std::array<float, 4> weights;
};

void add_skin_attributes(const Body& body, Json& attributes, Document& document) {
    std::vector<FourBones> bones;
    std::vector<FourWeights> weights;
    for (const SkinWeights& skin : body.skin) {
        bones.push_back({skin.bones});
        weights.push_back({skin.weights});
        // glTF requires joint index 0 where the weight is 0.
        for (std::size_t k = 0; k < 4; ++k)
            if (skin.weights[k] == 0) bones.back().bones[k] = 0;
    }
    attributes["JOINTS_0"] =
        document.add(std::span<const FourBones>(bones), Component::UnsignedShort, "VEC4", Target::Vertices);
    attributes["WEIGHTS_0"] =
        document.add(std::span<const FourWeights>(weights), Component::Float, "VEC4", Target::Vertices);
}

// Joints have no rotation in the rest pose, so that each inverse bind matrix is a translation.
Json skin_of(const Body& body, std::size_t armature, Document& document) {
    std::vector<std::array<float, 16>> inverse_binds;
    Json joints = Json::array();
    for (std::size_t i = 0; i < body.bones.size(); ++i) {
        const Vec3f shift = -body.bones[i].joint.cast<float>();
        inverse_binds.push_back({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, shift.x(), shift.y(), shift.z(), 1});
        joints.push_back(armature + 1 + i);
    }
    Json skin = Json::object();
    skin["inverseBindMatrices"] =
        document.add(std::span<const std::array<float, 16>>(inverse_binds), Component::Float, "MAT4", Target::None);
    skin["skeleton"] = armature;
    skin["joints"] = std::move(joints);
    return Json::array({std::move(skin)});
}

// Adds the armature (the common root node that a skin requires), then one node per bone.
void add_bone_nodes(const Body& body, Json& nodes) {
    const std::size_t armature = nodes.elements().size();
    std::vector<Json> children(body.bones.size() + 1, Json::array());
    for (std::size_t i = 0; i < body.bones.size(); ++i) {
        SELVEDGE_ASSERT(body.bones[i].parent < int(body.bones.size()));
        children[std::size_t(body.bones[i].parent + 1)].push_back(armature + 1 + i);
    }
    for (std::size_t i = 0; i <= body.bones.size(); ++i) {
        Json node = Json::object();
        node["name"] = i == 0 ? "armature" : body.bones[i - 1].name;
        if (i > 0) {
            const Bone& bone = body.bones[i - 1];
            const Vec3d from = bone.parent < 0 ? Vec3d(Vec3d::Zero()) : body.bones[std::size_t(bone.parent)].joint;
            node["translation"] = numbers(Vec3f((bone.joint - from).cast<float>()));
        }
        if (!children[i].elements().empty()) node["children"] = std::move(children[i]);
        nodes.push_back(std::move(node));
    }
}

Json body_primitive(const Body& body, Document& document) {
    const DrawMesh mesh = body_mesh(body);
    Json attributes = Json::object();
    attributes["POSITION"] = document.add_positions(mesh.x);
    attributes["NORMAL"] = document.add_vectors(mesh.normals);
    if (!body.skin.empty() && !body.bones.empty()) add_skin_attributes(body, attributes, document);
    Json primitive = Json::object();
    primitive["attributes"] = std::move(attributes);
    primitive["indices"] = document.add_indices(mesh.triangles);
    return primitive;
}

}  // namespace

namespace {

// The body stands beside the garment as it is, without its bones.
void add_standing_body(const Body& body, Json& root, Document& document) {
    Body standing;
    standing.x = body.x;
    standing.triangles = body.triangles;
    Json mesh = Json::object();
    mesh["name"] = "body";
    mesh["primitives"] = Json::array({body_primitive(standing, document)});
    root["meshes"].push_back(std::move(mesh));
    root["nodes"].push_back(mesh_node("body", 1));
    root["scenes"] = scene_of({0, 1});
}

}  // namespace

std::string garment_glb(const DrawMesh& mesh, const GarmentExport& content) {
    std::vector<PanelPart> parts = split_by_panel(mesh);
    pack_panels(parts, content.atlas);
    const std::vector<Vec3f> normals = vertex_normals(mesh);
    Document document;
    Json primitives = Json::array();
    for (std::size_t i = 0; i < parts.size(); ++i)
        primitives.push_back(panel_primitive(parts[i], i, mesh.x, normals, document));
    Json root = root_object();
    root["scenes"] = scene_of({0});
    root["nodes"] = Json::array({mesh_node("garment")});
    root["meshes"] = one_mesh("garment", std::move(primitives));
    Json materials = Json::array();
    add_panel_materials(parts, materials);
    add_textures(content.textures, materials, root, document);
    root["materials"] = std::move(materials);
    if (content.body != nullptr) add_standing_body(*content.body, root, document);
    return container(std::move(root), std::move(document));
}

std::string body_glb(const Body& body) {
    Document document;
    Json root = root_object();
    root["meshes"] = one_mesh("body", Json::array({body_primitive(body, document)}));
    Json nodes = Json::array({mesh_node("body")});
    if (body.bones.empty()) {
        root["scenes"] = scene_of({0});
    } else {
        constexpr std::size_t kArmature = 1;
        add_bone_nodes(body, nodes);
        root["scenes"] = scene_of({0, kArmature});
        if (!body.skin.empty()) {
            nodes.elements()[0]["skin"] = 0;
            root["skins"] = skin_of(body, kArmature, document);
        }
    }
    root["nodes"] = std::move(nodes);
    return container(std::move(root), std::move(document));
}

namespace {

// Calls take(panel, value) for each primitive whose extras name a panel and have the key.
template <class Take>
void for_each_extra(std::string_view bytes, const std::string& file, std::string_view key, const Take& take) {
    const std::string_view json = glb::split(bytes).json;
    if (json.empty()) return;
    const Json root = parse_json(json, file);
    const Json* meshes = root.find("meshes");
    if (!meshes || !meshes->is_array()) return;
    for (const Json& mesh : meshes->elements()) {
        const Json* primitives = mesh.find("primitives");
        if (!primitives || !primitives->is_array()) continue;
        for (const Json& primitive : primitives->elements()) {
            const Json* extras = primitive.find("extras");
            const Json* name = extras ? extras->find("panel") : nullptr;
            const Json* value = extras ? extras->find(key) : nullptr;
            if (name && name->is_string() && value) take(name->string(), *value);
        }
    }
}

}  // namespace

std::vector<std::pair<std::string, float>> grain_angles_in_glb(std::string_view bytes, const std::string& file) {
    std::vector<std::pair<std::string, float>> angles;
    for_each_extra(bytes, file, "grain_angle", [&](const std::string& panel, const Json& angle) {
        if (angle.is_number()) angles.emplace_back(panel, float(angle.number()));
    });
    return angles;
}

std::vector<std::pair<std::string, Vec2f>> sett_offsets_in_glb(std::string_view bytes, const std::string& file) {
    std::vector<std::pair<std::string, Vec2f>> offsets;
    for_each_extra(bytes, file, "sett_offset", [&](const std::string& panel, const Json& offset) {
        if (!offset.is_array() || offset.elements().size() != 2) return;
        const Json& weft = offset.elements()[0];
        const Json& warp = offset.elements()[1];
        if (!weft.is_number() || !warp.is_number()) return;
        const Vec2f value(float(weft.number()), float(warp.number()));
        if (value.allFinite()) offsets.emplace_back(panel, value);
    });
    return offsets;
}

std::vector<std::pair<std::string, UvChart>> charts_in_glb(std::string_view bytes, const std::string& file) {
    std::vector<std::pair<std::string, UvChart>> charts;
    for_each_extra(bytes, file, "chart", [&](const std::string& panel, const Json& chart) {
        const Json *scale = chart.find("scale"), *offset = chart.find("offset"), *turned = chart.find("turned");
        if (!scale || !scale->is_number() || !turned || !turned->is_bool()) return;
        if (!offset || !offset->is_array() || offset->elements().size() != 2) return;
        const Json &x = offset->elements()[0], &y = offset->elements()[1];
        if (!x.is_number() || !y.is_number()) return;
        const UvChart read{.scale = scale->number(), .is_turned = turned->boolean(), .offset{x.number(), y.number()}};
        if (is_sound(read)) charts.emplace_back(panel, read);
    });
    return charts;
}

}  // namespace selvedge::sim
