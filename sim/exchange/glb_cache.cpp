#include "sim/exchange/glb_cache.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/atomic_file.h"
#include "sim/core/error.h"
#include "sim/exchange/glb_document.h"

namespace selvedge::sim {

using namespace glb;

namespace {

constexpr std::size_t kJsonAt = 20;         // behind the file's header and that of the JSON chunk
constexpr std::size_t kMostFrames = 32768;  // whose frames^2 weights are 4 GiB
constexpr std::size_t kChunkHeader = 8;     // length and kind

// One mesh of the file: in JSON its primitives, one per panel, and their morph targets.
struct Animated {
    const char* name = "";
    DrawMesh mesh;  // of the first frame
    std::vector<PanelPart> parts;
    std::vector<Json> primitives{};
    std::vector<Json> targets{};  // one array per primitive
};

std::size_t vertex_count(const Animated& animated) {
    std::size_t count = 0;
    for (const PanelPart& part : animated.parts) count += part.vertices.size();
    return count;
}

void add_first(Animated& animated, const std::vector<Vec3f>& x, std::size_t first_material, Document& document) {
    DrawMesh& mesh = animated.mesh;
    mesh.x = x;
    mesh.normals = vertex_normals(mesh.x, mesh.triangles, mesh.turned_corners);
    for (const PanelPart& part : animated.parts) {
        const std::size_t material = first_material + animated.primitives.size();
        Json primitive = panel_primitive(part, material, mesh.x, mesh.normals, document);
        if (part.u.empty()) primitive.erase("extras");  // of a panel
        animated.primitives.push_back(std::move(primitive));
        animated.targets.push_back(Json::array());
    }
}

std::vector<Vec3f> differences(std::vector<Vec3f> values, const std::vector<Vec3f>& first) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= first[i];
    return values;
}

Json target_json(std::size_t positions, const std::size_t* normals) {
    Json target = Json::object();
    target["POSITION"] = positions;
    if (normals != nullptr) target["NORMAL"] = *normals;
    return target;
}

void add_target(Animated& animated, const std::vector<Vec3f>& x, bool has_normals, Document& document) {
    const DrawMesh& mesh = animated.mesh;
    const std::vector<Vec3f> all =
        has_normals ? vertex_normals(x, mesh.triangles, mesh.turned_corners) : std::vector<Vec3f>();
    for (std::size_t i = 0; i < animated.parts.size(); ++i) {
        const PanelPart& part = animated.parts[i];
        const std::size_t positions =
            document.add_positions(differences(positions_of(part, x), positions_of(part, mesh.x)));
        std::size_t normals = 0;
        if (has_normals)
            normals = document.add_vectors(differences(normals_of(part, all), normals_of(part, mesh.normals)));
        animated.targets[i].push_back(target_json(positions, has_normals ? &normals : nullptr));
    }
}

void plan_target(Animated& animated, bool has_normals, Document& plan) {
    for (std::size_t i = 0; i < animated.parts.size(); ++i) {
        const std::size_t positions = plan.plan_positions(animated.parts[i].vertices.size());
        const std::size_t normals = has_normals ? plan.plan_vectors(animated.parts[i].vertices.size()) : 0;
        animated.targets[i].push_back(target_json(positions, has_normals ? &normals : nullptr));
    }
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

Json animation_json(std::size_t meshes, std::size_t times, std::size_t weights, CacheInterpolation interpolation) {
    Json sampler = Json::object();
    sampler["input"] = times;
    sampler["output"] = weights;
    sampler["interpolation"] = interpolation == CacheInterpolation::Step ? "STEP" : "LINEAR";
    Json channels = Json::array();
    for (std::size_t node = 0; node < meshes; ++node) {
        Json channel = Json::object();
        channel["sampler"] = 0;
        channel["target"]["node"] = node;
        channel["target"]["path"] = "weights";
        channels.push_back(std::move(channel));
    }
    Json animation = Json::object();
    animation["name"] = "cache";
    animation["samplers"] = Json::array({std::move(sampler)});
    animation["channels"] = std::move(channels);
    return animation;
}

class GlbCache final : public MeshCache {
 public:
    GlbCache(const std::filesystem::path& path, const DrawMesh& garment, const CacheOptions& options,
             const DrawMesh* body)
        : path_(path), options_(options) {
        meshes_.push_back({"garment", garment, split_by_panel(garment)});
        pack_panels(meshes_.back().parts, options.atlas);
        if (body != nullptr) meshes_.push_back({"body", *body, split_by_panel(*body)});
        if (options.frames > kMostFrames)
            throw InputError(path.string(), "",
                             std::to_string(options.frames) + " frames: the weights of " + std::to_string(kMostFrames) +
                                 " fill a .glb file; use fewer frames or .pc2");
        require_size(binary_bytes());  // before a plan is made of it
        json_bytes_ = plan_json();
        const std::uint64_t bytes = kJsonAt + json_bytes_ + kChunkHeader + binary_bytes();
        require_size(bytes);
        require_free_space(path, bytes);
        file_ = std::make_unique<AtomicFile>(path);
        file_->append(std::string(kJsonAt + json_bytes_ + kChunkHeader, ' '));  // until finish()
    }

    void add(const std::vector<Vec3f>& garment, const std::vector<Vec3f>& body) override {
        SELVEDGE_ASSERT(frames_ < options_.frames && body.empty() == (meshes_.size() == 1));
        const int frame = options_.first_frame + static_cast<int>(frames_);
        std::size_t first_material = 0;
        for (std::size_t i = 0; i < meshes_.size(); ++i) {
            const std::vector<Vec3f>& x = i == 0 ? garment : body;
            SELVEDGE_ASSERT(x.size() == meshes_[i].mesh.x.size());
            require_finite(path_, frame, x);
            if (frames_ == 0)
                add_first(meshes_[i], x, first_material, document_);
            else
                add_target(meshes_[i], x, options_.has_normals, document_);
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
        std::string json = document_.finish(std::move(content));
        SELVEDGE_ASSERT(json.size() <= json_bytes_);
        json.resize(json_bytes_, ' ');
        std::string head;
        append_word(head, kMagic);
        append_word(head, 2);
        append_word(head, static_cast<std::uint32_t>(file_->size()));
        append_word(head, static_cast<std::uint32_t>(json_bytes_));
        append_word(head, kJsonChunk);
        head += json;
        append_word(head, static_cast<std::uint32_t>(document_.size()));
        append_word(head, kBinChunk);
        file_->overwrite(0, head);
        file_->commit();
    }

 private:
    // Of the planned frames: exact.
    std::uint64_t binary_bytes() const {
        const std::uint64_t frames = options_.frames, targets = frames - 1;
        std::uint64_t bytes = targets > 0 ? sizeof(float) * (frames + frames * targets) : 0;
        for (const Animated& animated : meshes_) {
            const std::uint64_t vertices = vertex_count(animated);
            bytes += vertices * sizeof(Vec3f) * (2 + targets * (options_.has_normals ? 2 : 1));
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
        for (Animated& animated : meshes) add_first(animated, animated.mesh.x, meshes_.front().parts.size(), plan);
        for (std::size_t target = 1; target < options_.frames; ++target)
            for (Animated& animated : meshes) plan_target(animated, options_.has_normals, plan);
        std::size_t times = 0, weights = 0;
        if (options_.frames > 1) {
            times = plan.plan_numbers(options_.frames);
            weights = plan.plan_numbers(options_.frames * (options_.frames - 1));
        }
        Json content = root(meshes, options_.frames, times, weights, plan);
        SELVEDGE_ASSERT(plan.size() == binary_bytes());
        const std::size_t bytes = plan.finish(std::move(content)).size();
        return (bytes + 3) / 4 * 4;
    }

    // Moves what the meshes hold in JSON, and adds the textures to the document.
    Json root(std::vector<Animated>& meshes, std::size_t frames, std::size_t times, std::size_t weights,
              Document& document) const {
        Json json = root_object();
        std::vector<Json> scene_nodes;
        Json nodes = Json::array(), all = Json::array(), materials = Json::array();
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            Json node = Json::object();
            node["name"] = meshes[i].name;
            node["mesh"] = i;
            nodes.push_back(std::move(node));
            scene_nodes.emplace_back(i);
            add_panel_materials(meshes[i].parts, materials);
            if (i == 0) add_textures(options_.textures, materials, json, document);  // not of the body
            all.push_back(mesh_json(meshes[i], frames, options_.first_frame));
        }
        json["scenes"] = scene_of(std::move(scene_nodes));
        json["nodes"] = std::move(nodes);
        json["meshes"] = std::move(all);
        json["materials"] = std::move(materials);
        if (frames > 1)
            json["animations"] = Json::array({animation_json(meshes.size(), times, weights, options_.interpolation)});
        return json;
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
        const std::size_t index = document_.add_numbers(weights);
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
