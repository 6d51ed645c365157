#include "sim/exchange/glb_cache.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <utility>

#include "sim/body/pose.h"
#include "sim/core/assert.h"
#include "sim/core/atomic_file.h"
#include "sim/core/error.h"
#include "sim/core/glb_container.h"
#include "sim/exchange/glb_document.h"

namespace selvedge::sim {

using namespace glb;

namespace {

constexpr std::size_t kJsonAt = 20;        // behind the file's header and that of the JSON chunk
constexpr std::size_t kMostFrames = 8192;  // whose frames^2 weights are 256 MiB where they are unpacked
constexpr std::size_t kChunkHeader = 8;    // length and kind

// One mesh of the file: in JSON its primitives, one per panel, and their morph targets.
struct Animated {
    const char* name = "";
    DrawMesh mesh;  // of the first frame; where bones move it, so that they bring it there
    std::vector<PanelPart> parts;
    std::vector<SkinWeights> skin{};  // by vertex of the mesh; empty: no bones move it
    bool has_normals = true;          // morph targets have
    std::vector<Json> primitives{};
    std::vector<Json> targets{};  // one array per primitive
};

std::size_t vertex_count(const Animated& animated) {
    std::size_t count = 0;
    for (const PanelPart& part : animated.parts) count += part.vertices.size();
    return count;
}

// What a viewer does not see is left out of morph targets.
constexpr float kSeenWay = 5e-5F;           // m
constexpr float kSeenTilt = 5e-3F;          // of a unit normal
constexpr std::size_t kLongestNumber = 20;  // with its comma

// The parts of a vector for each vertex of a part.
template <class Value>
std::vector<Value> values_of(const PanelPart& part, const std::vector<Value>& all) {
    std::vector<Value> values;
    for (const std::uint32_t v : part.vertices) values.push_back(all[v]);
    return values;
}

void add_skin(const Animated& animated, const PanelPart& part, Json& primitive, Document& document) {
    std::vector<std::array<std::uint16_t, 4>> bones;
    std::vector<std::array<float, 4>> weights;
    for (const SkinWeights& skin : values_of(part, animated.skin)) {
        bones.push_back(skin.bones);
        weights.push_back(skin.weights);
    }
    primitive["attributes"]["JOINTS_0"] = document.add(std::span<const std::array<std::uint16_t, 4>>(bones),
                                                       Component::UnsignedShort, "VEC4", Target::Vertices);
    primitive["attributes"]["WEIGHTS_0"] =
        document.add(std::span<const std::array<float, 4>>(weights), Component::Float, "VEC4", Target::Vertices);
}

// normals: of x where bones move the mesh; empty: they are computed.
void add_first(Animated& animated, const std::vector<Vec3f>& x, const std::vector<Vec3f>& normals,
               std::size_t first_material, Document& document) {
    DrawMesh& mesh = animated.mesh;
    mesh.x = x;
    mesh.normals = normals.empty() ? vertex_normals(mesh.x, mesh.triangles, mesh.turned_corners) : normals;
    for (const PanelPart& part : animated.parts) {
        const std::size_t material = first_material + animated.primitives.size();
        Json primitive = panel_primitive(part, material, mesh.x, mesh.normals, document);
        if (part.u.empty()) primitive.erase("extras");  // of a panel
        if (!animated.skin.empty()) add_skin(animated, part, primitive, document);
        animated.primitives.push_back(std::move(primitive));
        animated.targets.push_back(Json::array());
    }
}

// Differences, 0 where they are shorter than `seen`.
struct SparseWay {
    std::vector<Vec3f> values;
    std::vector<bool> is_kept;
};

SparseWay differences(std::vector<Vec3f> values, const std::vector<Vec3f>& first, float seen) {
    std::vector<bool> is_kept;
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] -= first[i];
        is_kept.push_back(values[i].norm() > seen);
        if (!is_kept[i]) values[i].setZero();
    }
    return {std::move(values), std::move(is_kept)};
}

Json target_json(std::size_t positions, const std::size_t* normals) {
    Json target = Json::object();
    target["POSITION"] = positions;
    if (normals != nullptr) target["NORMAL"] = *normals;
    return target;
}

void add_target(Animated& animated, const std::vector<Vec3f>& x, const std::vector<Vec3f>& normals,
                Document& document) {
    for (std::size_t i = 0; i < animated.parts.size(); ++i) {
        const PanelPart& part = animated.parts[i];
        const SparseWay ways = differences(positions_of(part, x), positions_of(part, animated.mesh.x), kSeenWay);
        const std::size_t positions = document.add_sparse(ways.values, ways.is_kept, Document::Bounds::Given);
        std::size_t tilted = 0;
        if (animated.has_normals) {
            const SparseWay tilts =
                differences(normals_of(part, normals), normals_of(part, animated.mesh.normals), kSeenTilt);
            tilted = document.add_sparse(tilts.values, tilts.is_kept, Document::Bounds::None);
        }
        animated.targets[i].push_back(target_json(positions, animated.has_normals ? &tilted : nullptr));
    }
}

void plan_target(Animated& animated, Document& plan) {
    for (std::size_t i = 0; i < animated.parts.size(); ++i) {
        const std::size_t count = animated.parts[i].vertices.size();
        const std::size_t positions = plan.plan_sparse_vectors(count, Document::Bounds::Given);
        const std::size_t normals = animated.has_normals ? plan.plan_sparse_vectors(count, Document::Bounds::None) : 0;
        animated.targets[i].push_back(target_json(positions, animated.has_normals ? &normals : nullptr));
    }
}

// Where the bones must find a mesh to bring it to x: positions and normals. A vertex whose bones cancel out stays where
// it was before.
void undo_bones(const Animated& animated, const std::vector<Eigen::Affine3d>& transforms, std::vector<Vec3f>& x,
                std::vector<Vec3f>& normals) {
    constexpr double kLeast = 1e-3;  // of the volume: below, rounding becomes visible
    for (std::size_t v = 0; v < x.size(); ++v) {
        Eigen::Matrix<double, 3, 4> sum = Eigen::Matrix<double, 3, 4>::Zero();
        const SkinWeights& skin = animated.skin[v];
        for (std::size_t k = 0; k < 4; ++k)
            sum += static_cast<double>(skin.weights[k]) * transforms[skin.bones[k]].affine().topRows<3>();
        const Eigen::Matrix3d turn = sum.leftCols<3>();
        const double size = turn.colwise().norm().prod();
        if (!(std::abs(turn.determinant()) > kLeast * size)) {
            x[v] = animated.mesh.x[v];
            normals[v] = animated.mesh.normals[v];
            continue;
        }
        const Eigen::Matrix3d back = turn.inverse();
        x[v] = (back * (x[v].cast<double>() - sum.col(3))).cast<float>();
        normals[v] = (back * normals[v].cast<double>()).normalized().cast<float>();
    }
}

// Each vertex of the garment goes with the bones of the vertex of the body that is nearest to it in the first frame.
std::vector<SkinWeights> nearest_skin(const std::vector<Vec3f>& garment, const std::vector<Vec3f>& body,
                                      const std::vector<SkinWeights>& skin) {
    std::vector<SkinWeights> nearest;
    for (const Vec3f& p : garment) {
        const auto found = std::ranges::min_element(body, {}, [&](const Vec3f& x) { return (x - p).squaredNorm(); });
        nearest.push_back(skin[static_cast<std::size_t>(found - body.begin())]);
    }
    return nearest;
}

// Moves the primitives and targets.
Json mesh_json(Animated& animated, std::size_t frames, int first_frame) {
    Json primitives = Json::array(std::move(animated.primitives));
    for (std::size_t i = 0; frames > 1 && i < animated.targets.size(); ++i)
        primitives.elements()[i]["targets"] = std::move(animated.targets[i]);
    Json mesh = Json::object();
    mesh["name"] = animated.name;
    mesh["primitives"] = std::move(primitives);
    if (frames == 1) return mesh;
    Json names = Json::array();  // most programs show them
    for (std::size_t i = 1; i < frames; ++i)
        names.push_back("frame " + std::to_string(first_frame + static_cast<int>(i)));
    mesh["extras"]["targetNames"] = std::move(names);
    return mesh;
}

Json channel_json(std::size_t sampler, std::size_t node, const char* path) {
    Json channel = Json::object();
    channel["sampler"] = sampler;
    channel["target"]["node"] = node;
    channel["target"]["path"] = path;
    return channel;
}

Json sampler_json(std::size_t times, std::size_t values, CacheInterpolation interpolation) {
    Json sampler = Json::object();
    sampler["input"] = times;
    sampler["output"] = values;
    sampler["interpolation"] = interpolation == CacheInterpolation::Step ? "STEP" : "LINEAR";
    return sampler;
}

// The bones of a body over all frames, as nodes of the file.
struct BoneTracks {
    std::vector<std::vector<Transform>> frames{};  // by frame and bone

    static std::size_t numbers_each() { return 3 + 4 + 3; }  // per frame
};

// Indices of accessors of one bone: translation, rotation, scale.
using BoneAccessors = std::array<std::size_t, 3>;
constexpr std::array<const char*, 3> kBonePaths{"translation", "rotation", "scale"};

BoneAccessors add_bone(const BoneTracks& tracks, std::size_t bone, Document& document) {
    std::vector<Vec3f> places, scales;
    std::vector<std::array<float, 4>> turns;
    Eigen::Quaternionf before = Eigen::Quaternionf::Identity();
    for (const std::vector<Transform>& frame : tracks.frames) {
        const Transform& at = frame[bone];
        Eigen::Quaternionf turn = at.rotation.cast<float>();
        if (turn.dot(before) < 0) turn.coeffs() *= -1;  // the shorter way
        before = turn;
        places.push_back(at.translation.cast<float>());
        turns.push_back({turn.x(), turn.y(), turn.z(), turn.w()});
        scales.push_back(at.scale.cast<float>());
    }
    const auto add = [&](std::span<const Vec3f> values) {
        return document.add(values, Component::Float, "VEC3", Target::None);
    };
    const std::size_t place = add(places);
    const std::size_t turn =
        document.add(std::span<const std::array<float, 4>>(turns), Component::Float, "VEC4", Target::None);
    return {place, turn, add(scales)};
}

BoneAccessors plan_bone(std::size_t frames, Document& plan) {
    const std::size_t place = plan.plan(frames, sizeof(Vec3f), Component::Float, "VEC3");
    const std::size_t turn = plan.plan(frames, 4 * sizeof(float), Component::Float, "VEC4");
    return {place, turn, plan.plan(frames, sizeof(Vec3f), Component::Float, "VEC3")};
}

std::vector<std::array<float, 16>> inverse_binds(const Body& body) {
    std::vector<std::array<float, 16>> all;
    for (const Bone& bone : body.bones) {
        const Eigen::Matrix4f matrix = bone.inverse_bind.matrix().cast<float>();
        std::ranges::copy_n(matrix.data(), 16, all.emplace_back().begin());
    }
    return all;
}

// Nodes from `first` on: the frame of the file, which holds the roots, then the bones.
std::vector<Json> bone_nodes(const Body& body, const std::vector<Transform>& pose, std::size_t first) {
    std::vector<Json> nodes(1 + body.bones.size(), Json::object());
    nodes[0]["name"] = "skeleton";
    const Eigen::Matrix4f frame = body.frame.matrix().cast<float>();
    nodes[0]["matrix"] = numbers(frame.reshaped());
    for (std::size_t i = 0; i < body.bones.size(); ++i) {
        Json& node = nodes[1 + i];
        node["name"] = body.bones[i].name;
        node["translation"] = numbers(Vec3f(pose[i].translation.cast<float>()));
        node["rotation"] = numbers(Eigen::Vector4f(pose[i].rotation.coeffs().cast<float>()));
        node["scale"] = numbers(Vec3f(pose[i].scale.cast<float>()));
        Json& parent = nodes[static_cast<std::size_t>(1 + body.bones[i].parent)];
        if (!parent.find("children")) parent["children"] = Json::array();
        parent["children"].push_back(Json(first + 1 + i));
    }
    return nodes;
}

std::size_t rest_numbers(const Body& body) {
    return 16 + body.bones.size() * BoneTracks::numbers_each();
}

class GlbCache final : public MeshCache {
 public:
    GlbCache(const std::filesystem::path& path, const DrawMesh& garment, const CacheOptions& options,
             const DrawMesh* body)
        : path_(path), options_(options) {
        SELVEDGE_ASSERT(options.bones == nullptr || (body != nullptr && !options.bones->skin.empty()));
        meshes_.push_back({.name = "garment", .mesh = garment, .parts = split_by_panel(garment)});
        pack_panels(meshes_.back().parts, options.atlas);
        meshes_.back().has_normals = options.has_normals;
        if (binds_garment()) meshes_.back().skin.assign(garment.x.size(), {});  // known with the first frame
        if (body != nullptr) {
            meshes_.push_back({.name = "body", .mesh = *body, .parts = split_by_panel(*body)});
            meshes_.back().has_normals = options.has_normals && options.bones == nullptr;
            if (options.bones != nullptr) meshes_.back().skin = options.bones->skin;
        }
        if (options.frames > kMostFrames)
            throw InputError(path.string(), "",
                             std::to_string(options.frames) + " frames: a .glb file has at most " +
                                 std::to_string(kMostFrames) + "; use fewer frames or .pc2");
        require_size(binary_bytes());  // before a plan is made of it
        json_bytes_ = plan_json();
        const std::uint64_t bytes = kJsonAt + json_bytes_ + kChunkHeader + binary_bytes();
        require_size(bytes);
        require_free_space(path, bytes);
        file_ = std::make_unique<AtomicFile>(path);
        file_->append(std::string(kJsonAt + json_bytes_ + kChunkHeader, ' '));  // until finish()
    }

    void add(const std::vector<Vec3f>& garment, const std::vector<Vec3f>& body, const Pose* pose) override {
        SELVEDGE_ASSERT(frames_ < options_.frames && body.empty() == (meshes_.size() == 1));
        SELVEDGE_ASSERT((pose != nullptr) == (options_.bones != nullptr));
        const int frame = options_.first_frame + static_cast<int>(frames_);
        if (binds_garment() && frames_ == 0) meshes_[0].skin = nearest_skin(garment, body, options_.bones->skin);
        std::vector<Eigen::Affine3d> transforms;
        if (pose != nullptr) {
            transforms = skin_transforms(*options_.bones, *pose);
            bones_.frames.push_back(pose->bones);
        }
        std::size_t first_material = 0;
        for (std::size_t i = 0; i < meshes_.size(); ++i) {
            const std::vector<Vec3f>& x = i == 0 ? garment : body;
            SELVEDGE_ASSERT(x.size() == meshes_[i].mesh.x.size());
            require_finite(path_, frame, x);
            add_frame(meshes_[i], x, transforms, first_material);
            first_material += meshes_[i].parts.size();
        }
        ++frames_;
        flush();
    }

    void finish() override {
        SELVEDGE_ASSERT(frames_ > 0);
        std::size_t times = 0, weights = 0;
        if (frames_ > 1) {
            times = add_times();
            weights = add_weights();
        }
        Json content = root(meshes_, frames_, times, weights, document_);
        flush();
        bones_.frames.clear();
        std::string json = document_.finish(std::move(content));
        SELVEDGE_ASSERT(json.size() <= json_bytes_);
        json.resize(json_bytes_, ' ');
        file_->overwrite(0, head(std::move(json), document_.size()));
        file_->commit();
    }

 private:
    bool binds_garment() const { return options_.bones != nullptr && options_.binds_garment; }

    void add_frame(Animated& animated, std::vector<Vec3f> x, const std::vector<Eigen::Affine3d>& transforms,
                   std::size_t first_material) {
        std::vector<Vec3f> normals;
        if (frames_ == 0 || animated.has_normals || !animated.skin.empty())
            normals = vertex_normals(x, animated.mesh.triangles, animated.mesh.turned_corners);
        if (!animated.skin.empty()) undo_bones(animated, transforms, x, normals);
        if (frames_ == 0)
            add_first(animated, x, normals, first_material, document_);
        else
            add_target(animated, x, normals, document_);
    }

    // The most that the planned frames need.
    std::uint64_t binary_bytes() const {
        const std::uint64_t frames = options_.frames, targets = frames - 1;
        std::uint64_t bytes = 0;
        if (targets > 0) {
            const std::uint64_t weights = sizeof(float) * frames * targets;
            bytes += sizeof(float) * frames + std::min(weights, frames * (sizeof(std::uint32_t) + sizeof(float)));
        }
        if (options_.bones != nullptr) {
            const std::uint64_t bones = options_.bones->bones.size();
            bytes += bones * sizeof(float) * (16 + (targets > 0 ? frames * BoneTracks::numbers_each() : 0));
        }
        for (const Animated& animated : meshes_) {
            const std::uint64_t vertices = vertex_count(animated);
            bytes += vertices * sizeof(Vec3f) * (2 + targets * (animated.has_normals ? 2 : 1));
            if (!animated.skin.empty()) bytes += vertices * 4 * (sizeof(std::uint16_t) + sizeof(float));
            bytes += animated.mesh.triangles.size() * 3 * sizeof(std::uint32_t);
            if (!animated.mesh.u.empty()) bytes += vertices * 2 * sizeof(Vec2f);  // packed and metric
        }
        for (const std::string* png : {&options_.textures.base_colour, &options_.textures.normal})
            bytes += (png->size() + 3) / 4 * 4;
        return bytes;
    }

    void require_size(std::uint64_t bytes) const {
        if (bytes <= UINT32_MAX) return;
        std::size_t vertices = 0;
        for (const Animated& animated : meshes_) vertices += vertex_count(animated);
        throw InputError(path_.string(), "",
                         std::to_string(options_.frames) + " frames of " + std::to_string(vertices) +
                             " vertices need " + bytes_text(bytes) + ", and a .glb file holds " +
                             bytes_text(UINT32_MAX) + ": use fewer frames, a coarser mesh or .pc2");
    }

    // The room for the JSON of the planned frames, and of any fewer.
    std::size_t plan_json() const {
        Document plan(Document::Kind::Plan);
        std::vector<Animated> meshes = meshes_;
        for (Animated& animated : meshes) add_first(animated, animated.mesh.x, {}, meshes_.front().parts.size(), plan);
        for (std::size_t target = 1; target < options_.frames; ++target)
            for (Animated& animated : meshes) plan_target(animated, plan);
        std::size_t times = 0, weights = 0;
        if (options_.frames > 1) {
            times = plan.plan_numbers(options_.frames);
            weights = plan.plan_sparse_numbers(options_.frames * (options_.frames - 1), options_.frames - 1);
        }
        Json content = root(meshes, options_.frames, times, weights, plan);
        SELVEDGE_ASSERT(plan.size() == binary_bytes());
        std::size_t bytes = plan.finish(std::move(content)).size();
        if (options_.bones != nullptr) bytes += rest_numbers(*options_.bones) * kLongestNumber;
        return (bytes + 3) / 4 * 4;
    }

    // Moves what the meshes hold in JSON, and adds the textures and the bones to the document.
    Json root(std::vector<Animated>& meshes, std::size_t frames, std::size_t times, std::size_t weights,
              Document& document) const {
        Json json = root_object();
        std::vector<Json> scene_nodes;
        Json nodes = Json::array(), all = Json::array(), materials = Json::array();
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            Json node = Json::object();
            node["name"] = meshes[i].name;
            node["mesh"] = i;
            if (!meshes[i].skin.empty()) node["skin"] = 0;
            nodes.push_back(std::move(node));
            scene_nodes.emplace_back(i);
            add_panel_materials(meshes[i].parts, materials);
            if (i == 0) add_textures(options_.textures, materials, json, document);  // not of the body
            all.push_back(mesh_json(meshes[i], frames, options_.first_frame));
        }
        Json samplers = Json::array(), channels = Json::array();
        if (frames > 1) {
            samplers.push_back(sampler_json(times, weights, options_.interpolation));
            for (std::size_t node = 0; node < meshes.size(); ++node)
                channels.push_back(channel_json(0, node, "weights"));
        }
        if (options_.bones != nullptr) {
            scene_nodes.emplace_back(meshes.size());
            add_bones(meshes.size(), frames, times, json, nodes, samplers, channels, document);
        }
        json["scenes"] = scene_of(std::move(scene_nodes));
        json["nodes"] = std::move(nodes);
        json["meshes"] = std::move(all);
        json["materials"] = std::move(materials);
        if (frames == 1) return json;
        Json animation = Json::object();
        animation["name"] = "cache";
        animation["samplers"] = std::move(samplers);
        animation["channels"] = std::move(channels);
        json["animations"] = Json::array({std::move(animation)});
        return json;
    }

    // The skeleton from node `first` on, the skin that it is, and its motion.
    void add_bones(std::size_t first, std::size_t frames, std::size_t times, Json& root, Json& nodes, Json& samplers,
                   Json& channels, Document& document) const {
        const Body& body = *options_.bones;
        const bool is_plan = bones_.frames.empty();
        Json joints = Json::array();
        for (Json& node : bone_nodes(body, is_plan ? rest_pose(body).bones : bones_.frames.front(), first))
            nodes.push_back(std::move(node));
        const std::vector<std::array<float, 16>> binds = inverse_binds(body);
        Json skin = Json::object();
        skin["inverseBindMatrices"] =
            document.add(std::span<const std::array<float, 16>>(binds), Component::Float, "MAT4", Target::None);
        for (std::size_t i = 0; i < body.bones.size(); ++i) {
            const std::size_t node = first + 1 + i;
            joints.push_back(Json(node));
            if (frames == 1) continue;
            const BoneAccessors values = is_plan ? plan_bone(frames, document) : add_bone(bones_, i, document);
            for (std::size_t k = 0; k < values.size(); ++k) {
                channels.push_back(channel_json(samplers.elements().size(), node, kBonePaths[k]));
                samplers.push_back(sampler_json(times, values[k], options_.interpolation));
            }
        }
        skin["joints"] = std::move(joints);
        root["skins"] = Json::array({std::move(skin)});
    }

    std::size_t add_times() {
        std::vector<float> times;
        for (std::size_t i = 0; i < frames_; ++i)
            times.push_back(static_cast<float>(static_cast<double>(i) / options_.frames_per_second));
        const std::size_t index = document_.add_times(times);
        flush();
        return index;
    }

    std::size_t add_weights() {
        std::vector<float> weights(frames_ * (frames_ - 1), 0.0F);
        for (std::size_t i = 1; i < frames_; ++i) weights[i * (frames_ - 1) + i - 1] = 1;
        std::vector<bool> is_kept;
        for (const float weight : weights) is_kept.push_back(weight != 0);
        const std::size_t index = document_.add_sparse(weights, is_kept);
        flush();
        return index;
    }

    void flush() {
        file_->append(document_.buffer());
        document_.clear_buffer();
    }

    std::filesystem::path path_;
    CacheOptions options_;
    std::vector<Animated> meshes_;
    Document document_;
    BoneTracks bones_;
    std::size_t frames_ = 0;
    std::size_t json_bytes_ = 0;  // reserved, a multiple of 4
    std::unique_ptr<AtomicFile> file_;
};

}  // namespace

std::unique_ptr<MeshCache> open_glb_cache(const std::filesystem::path& path, const DrawMesh& garment,
                                          const CacheOptions& options, const DrawMesh* body) {
    return std::make_unique<GlbCache>(path, garment, options, body);
}

}  // namespace selvedge::sim
