#include "sim/body/scene_bytes.h"

#include "sim/body/flat_buffer.h"

namespace selvedge {

std::string to_bytes(const ImportAnswer& answer) {
    FlatWriter writer;
    writer.text(answer.failure);
    writer.value(std::uint64_t(answer.scene.meshes.size()));
    for (const ImportedMesh& mesh : answer.scene.meshes) {
        writer.text(mesh.name);
        writer.text(mesh.material);
        writer.list(mesh.x);
        writer.list(mesh.u);
        writer.list(mesh.triangles);
        writer.list(mesh.skin);
    }
    writer.value(std::uint64_t(answer.scene.bones.size()));
    for (const Bone& bone : answer.scene.bones) {
        writer.text(bone.name);
        writer.value(bone.parent);
        for (const double coordinate : bone.joint) writer.value(coordinate);
    }
    return writer.bytes();
}

std::optional<ImportAnswer> from_bytes(std::string_view bytes) {
    FlatReader reader(bytes);
    ImportAnswer answer;
    answer.failure = reader.text();
    const std::uint64_t meshes = reader.value<std::uint64_t>();
    for (std::uint64_t i = 0; i < meshes && reader.is_sound(); ++i) {
        ImportedMesh& mesh = answer.scene.meshes.emplace_back();
        mesh.name = reader.text();
        mesh.material = reader.text();
        mesh.x = reader.list<Vec3f>();
        mesh.u = reader.list<Vec2f>();
        mesh.triangles = reader.list<std::array<std::uint32_t, 3>>();
        mesh.skin = reader.list<SkinWeights>();
    }
    const std::uint64_t bones = reader.value<std::uint64_t>();
    for (std::uint64_t i = 0; i < bones && reader.is_sound(); ++i) {
        Bone& bone = answer.scene.bones.emplace_back();
        bone.name = reader.text();
        bone.parent = reader.value<int>();
        for (double& coordinate : bone.joint) coordinate = reader.value<double>();
    }
    if (!reader.is_sound() || !reader.is_at_end()) return std::nullopt;
    return answer;
}

}  // namespace selvedge
