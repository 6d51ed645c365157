#include "sim/repair/gltf_skins.h"

#include <optional>
#include <string>

#include "sim/core/error.h"
#include "sim/repair/gltf_file.h"

namespace selvedge::sim {
namespace {

class SkinCheck {
 public:
    SkinCheck(const std::filesystem::path& path, gltf::File& file) : path_(path), file_(file), root_(file.root()) {}

    void check() {
        const Json* nodes = root_.find("nodes");
        if (!nodes || !nodes->is_array()) return;
        for (const Json& node : nodes->elements()) {
            const Json* joints =
                gltf::member(gltf::element(root_.find("skins"), gltf::index_of(gltf::member(&node, "skin"))), "joints");
            const std::optional<std::size_t> mesh = gltf::index_of(gltf::member(&node, "mesh"));
            const Json* primitives = gltf::member(gltf::element(root_.find("meshes"), mesh), "primitives");
            if (!joints || !joints->is_array() || !primitives || !primitives->is_array()) continue;
            for (std::size_t p = 0; p < primitives->elements().size(); ++p)
                check_primitive(*mesh, p, primitives->elements()[p], joints->elements().size());
        }
    }

 private:
    void check_primitive(std::size_t mesh, std::size_t index, const Json& primitive, std::size_t joint_count) {
        const Json* attributes = primitive.find("attributes");
        const std::optional<gltf::Numbers> joints = fours_of(gltf::member(attributes, "JOINTS_0"));
        const std::optional<gltf::Numbers> weights = fours_of(gltf::member(attributes, "WEIGHTS_0"));
        const bool are_joints =
            joints && (joints->type == gltf::Numbers::kUnsignedByte || joints->type == gltf::Numbers::kUnsignedShort);
        if (!are_joints || !weights || weights->count < joints->count) return;
        for (std::size_t v = 0; v < joints->count; ++v)
            for (std::size_t k = 0; k < 4; ++k)
                if (weights->at(v, k) > 0 && !(joints->at(v, k) < double(joint_count)))
                    throw InputError(path_.string(),
                                     "meshes[" + std::to_string(mesh) + "].primitives[" + std::to_string(index) +
                                         "].attributes.JOINTS_0",
                                     "vertex " + std::to_string(v) + " hangs on joint " +
                                         std::to_string(int(joints->at(v, k))) + " of a skin that has " +
                                         std::to_string(joint_count));
    }

    // Four numbers for each vertex.
    std::optional<gltf::Numbers> fours_of(const Json* accessor_index) {
        const auto numbers = file_.numbers(gltf::element(root_.find("accessors"), gltf::index_of(accessor_index)));
        if (!numbers || numbers->width != 4) return std::nullopt;
        return numbers;
    }

    const std::filesystem::path& path_;
    gltf::File& file_;
    const Json& root_;
};

}  // namespace

void check_gltf_skins(const std::filesystem::path& path, std::string_view content) {
    std::optional<gltf::File> file;
    try {
        file.emplace(path, content);
    } catch (const InputError&) {
        return;
    }
    SkinCheck(path, *file).check();
}

}  // namespace selvedge::sim
