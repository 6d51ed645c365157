#include "sim/repair/guarded_import.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_extension.h"
#include "sim/core/file_path.h"
#include "sim/core/flat_bytes.h"
#include "sim/repair/body_bytes.h"
#include "sim/repair/bvh_text.h"
#include "sim/repair/gltf_skins.h"

namespace selvedge::sim {
namespace {

constexpr float kLargestCoordinate = 1e6F;  // admits a body of 1,800 mm, rejects a corrupted exponent

bool looks_like_obj(std::string_view content) {
    if (content.find('\0') != std::string_view::npos) return false;
    return content.starts_with("v ") || content.find("\nv ") != std::string_view::npos ||
           content.find("\nv\t") != std::string_view::npos;
}

bool looks_like_gltf(std::string_view content) {
    const std::size_t first = content.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && content[first] == '{' &&
           content.find("\"asset\"") != std::string_view::npos;
}

bool looks_like_glb(std::string_view content) {
    constexpr std::size_t kVersionEnd = 8;
    if (content.size() < kVersionEnd || !content.starts_with("glTF")) return false;
    std::uint32_t version = 0;
    std::memcpy(&version, content.data() + 4, sizeof version);
    return version == 2;
}

// Whether a binary glTF file ends before its header says.
bool is_cut_glb(std::string_view content) {
    constexpr std::size_t kHeader = 12;
    std::uint32_t length = 0;
    if (content.size() < kHeader) return true;
    std::memcpy(&length, content.data() + 8, sizeof length);
    return length > content.size();
}

bool looks_like_fbx(std::string_view content) {
    if (content.starts_with("Kaydara FBX Binary")) return true;
    constexpr std::size_t kHead = 4096;  // comments come first in the text format
    const std::string_view head = content.substr(0, kHead);
    return head.find("FBXHeaderExtension") != std::string_view::npos;
}

bool looks_like_bvh(std::string_view content) {
    const std::size_t first = content.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && content.substr(first).starts_with("HIERARCHY");
}

struct Format {
    const char* extension;
    const char* name;
    bool (*is_so)(std::string_view content);
    bool has_surface;
    bool has_motion;
};
constexpr std::array<Format, 5> kFormats{{{".obj", "Wavefront OBJ", looks_like_obj, true, false},
                                          {".gltf", "glTF 2.0", looks_like_gltf, true, true},
                                          {".glb", "binary glTF 2.0", looks_like_glb, true, true},
                                          {".fbx", "FBX", looks_like_fbx, true, true},
                                          {".bvh", "BVH", looks_like_bvh, false, true}}};

// The file extension by which assimp identifies the importer.
std::string importer_for(const std::filesystem::path& path, std::string_view content, ImportKind kind) {
    const std::string extension = lower_extension(path);
    std::string accepted = kind == ImportKind::Motion ? ".json" : "";  // of our own motions, which come another way
    for (const Format& format : kFormats) {
        if (!(kind == ImportKind::Motion ? format.has_motion : format.has_surface)) continue;
        accepted += (accepted.empty() ? "" : ", ") + std::string(format.extension);
        if (extension != format.extension) continue;
        if (!format.is_so(content)) {
            const bool has_mark = format.extension == std::string_view(".bvh") && content.starts_with("\xEF\xBB\xBF");
            throw InputError(path.string(), "",
                             has_mark ? "it starts with a byte-order mark: save it as UTF-8 without one"
                                      : std::string("its content is not ") + format.name);
        }
        if (format.extension == std::string_view(".glb") && is_cut_glb(content))
            throw InputError(path.string(), "", "it is cut off: it ends before the length that its header gives");
        return extension.substr(1);
    }
    const std::string problem = extension.empty() ? "its name has no extension that tells its format"
                                                  : "the format '" + extension + "' is not read";
    throw InputError(path.string(), "", problem + "; those that are: " + accepted);
}

ImportAnswer run_guarded(const std::filesystem::path& path, const std::string& importer, ImportKind kind,
                         const ImportLimits& limits) {
    const std::string bytes = answer_of_child(
        [&] {
            ImportAnswer answer;
            try {
                answer = read_with_assimp(path.string(), importer, kind, limits.motion);
            } catch (const InputError& error) {
                answer = {(error.place().empty() ? "" : error.place() + ": ") + error.problem(), {}};
            } catch (const std::exception& error) {
                answer = {error.what(), {}};
            }
            return to_bytes(answer);
        },
        path.string(), limits.child);
    std::optional<ImportAnswer> answer = from_bytes(bytes);
    if (!answer) throw InputError(path.string(), "", "the reader returned invalid data");
    check_memory_of_child(answer->failure, path.string());
    return std::move(*answer);
}

// One line of at most 200 characters.
std::string one_line(std::string text) {
    constexpr std::size_t kLongest = 200;
    text.resize(std::min(text.size(), kLongest));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }, ' ');
    return text;
}

template <class Vector>
bool is_reasonable(const Vector& v) {
    return v.allFinite() && v.cwiseAbs().maxCoeff() <= kLargestCoordinate;
}

void check_skin(const ImportedScene& scene, const ImportedMesh& mesh, const InputError& broken) {
    if (!mesh.skin.empty() && mesh.skin.size() != mesh.x.size()) throw broken;
    for (const SkinWeights& skin : mesh.skin)
        for (std::size_t k = 0; k < 4; ++k)
            if (!(skin.weights[k] >= 0 && skin.weights[k] <= 1.001F) || skin.bones[k] >= scene.bones.size())
                throw broken;
}

void check_mesh(const ImportedScene& scene, const ImportedMesh& mesh, const std::string& file, std::size_t index) {
    const std::string place = "mesh " + std::to_string(index);
    for (std::size_t v = 0; v < mesh.x.size(); ++v)
        if (!is_reasonable(mesh.x[v]))
            throw InputError(file, place + ", vertex " + std::to_string(v), "its position is not a reasonable number");
    if (!mesh.u.empty() && mesh.u.size() != mesh.x.size())
        throw InputError(file, place, "texture coordinates and vertices differ in number");
    for (std::size_t v = 0; v < mesh.u.size(); ++v)
        if (!is_reasonable(mesh.u[v]))
            throw InputError(file, place + ", vertex " + std::to_string(v), "its texture coordinate is not finite");
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::uint32_t v : mesh.triangles[t])
            if (v >= mesh.x.size())
                throw InputError(file, place + ", triangle " + std::to_string(t),
                                 "it names a vertex that is not there");
    check_skin(scene, mesh, InputError(file, place, "its skin weights are broken"));
}

bool is_sound(const Transform& transform) {
    return transform.rotation.coeffs().allFinite() && std::abs(transform.rotation.norm() - 1) < 1e-3 &&
           is_reasonable(transform.translation) && is_reasonable(transform.scale);
}

void check_bones(const ImportedScene& scene, const std::string& file, const MotionLimits& limits) {
    if (scene.bones.size() > 2 * limits.joints) throw InputError(file, "", "it has too many bones");
    for (std::size_t i = 0; i < scene.bones.size(); ++i) {
        const Bone& bone = scene.bones[i];
        const std::string place = "bone " + std::to_string(i) + " '" + one_line(bone.name) + "'";
        if (bone.parent < -1 || bone.parent >= int(i)) throw InputError(file, place, "its parent is not there");
        if (!is_reasonable(bone.joint) || !is_sound(bone.rest) || !bone.inverse_bind.matrix().allFinite())
            throw InputError(file, place, "its transform is not one of reasonable numbers");
    }
}

void check_scene(const ImportedScene& scene, const std::string& file, ImportKind kind, const ImportLimits& limits) {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        vertices += scene.meshes[i].x.size();
        triangles += scene.meshes[i].triangles.size();
        if (vertices > limits.vertices || triangles > limits.triangles)
            throw InputError(file, "", "more than " + std::to_string(limits.triangles) + " triangles");
        check_mesh(scene, scene.meshes[i], file, i);
    }
    if (triangles == 0 && kind == ImportKind::Surface) throw InputError(file, "", "it holds no triangles");
    check_bones(scene, file, limits.motion);
    for (const Clip& clip : scene.clips) check_clip(clip, scene.bones, file, limits.motion.clip);
}

// Checks the content as far as it can be without reading it. Returns assimp's extension for the importer.
std::string check_content(const std::filesystem::path& path, ImportKind kind, const ImportLimits& limits) {
    const std::string content = read_file(path, limits.file_bytes);
    const std::string importer = importer_for(path, content, kind);
    if (kind == ImportKind::Surface && (importer == "gltf" || importer == "glb")) check_gltf_skins(path, content);
    if (importer == "bvh") check_bvh(content, path.string(), limits.motion);
    return importer;
}

}  // namespace

ImportedScene guarded_import(const std::filesystem::path& path, ImportKind kind, const ImportLimits& limits) {
    const std::string importer = check_content(path, kind, limits);
    return scene_of(run_guarded(path, importer, kind, limits), path, kind, limits);
}

ImportedScene unguarded_import(const std::filesystem::path& path, ImportKind kind, const ImportLimits& limits) {
    const std::string importer = check_content(path, kind, limits);
    try {
        return scene_of(read_with_assimp(path.string(), importer, kind, limits.motion), path, kind, limits);
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(path.string(), "", "cannot be read: " + one_line(error.what()));
    }
}

ImportedScene scene_of(ImportAnswer answer, const std::filesystem::path& path, ImportKind kind,
                       const ImportLimits& limits) {
    // Only one importer is enabled, so "no suitable reader" means that it found the content broken.
    if (answer.failure.starts_with("No suitable reader")) answer.failure = "its content is broken";
    if (!answer.failure.empty()) throw InputError(path.string(), "", "cannot be read: " + one_line(answer.failure));
    check_scene(answer.scene, path.string(), kind, limits);
    return std::move(answer.scene);
}

std::string to_bytes(const ImportAnswer& answer) {
    FlatWriter writer;
    writer.text(answer.failure);
    writer.each(answer.scene.meshes, [&](const ImportedMesh& mesh) {
        writer.text(mesh.name);
        writer.text(mesh.material);
        writer.list(mesh.x);
        writer.list(mesh.u);
        writer.list(mesh.triangles);
        writer.list(mesh.skin);
    });
    writer.each(answer.scene.bones, [&](const Bone& bone) { write(writer, bone); });
    writer.each(answer.scene.clips, [&](const Clip& clip) { write(writer, clip); });
    writer.text(answer.scene.is_y_up ? "y" : "");
    return writer.bytes();
}

std::optional<ImportAnswer> from_bytes(std::string_view bytes) {
    FlatReader reader(bytes);
    ImportAnswer answer;
    answer.failure = reader.text();
    answer.scene.meshes = reader.each<ImportedMesh>([&](ImportedMesh& mesh) {
        mesh.name = reader.text();
        mesh.material = reader.text();
        mesh.x = reader.list<Vec3f>();
        mesh.u = reader.list<Vec2f>();
        mesh.triangles = reader.list<std::array<std::uint32_t, 3>>();
        mesh.skin = reader.list<SkinWeights>();
    });
    answer.scene.bones = reader.each<Bone>([&](Bone& bone) { read(reader, bone); });
    answer.scene.clips = reader.each<Clip>([&](Clip& clip) { read(reader, clip); });
    answer.scene.is_y_up = reader.text() == "y";
    if (!reader.is_sound() || !reader.is_at_end()) return std::nullopt;
    return answer;
}

}  // namespace selvedge::sim
