#include "sim/body/guarded_import.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <string_view>

#include "sim/body/assimp_scene.h"
#include "sim/body/child_process.h"
#include "sim/body/scene_bytes.h"
#include "sim/core/error.h"
#include "sim/core/file.h"

namespace selvedge {

namespace {

constexpr float kLargest = 1e6F;  // a body of 1,800 mm fits, and a garbled exponent does not

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

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
    constexpr std::size_t kHeader = 12;
    if (content.size() < kHeader || !content.starts_with("glTF")) return false;
    std::uint32_t version = 0;
    std::uint32_t length = 0;
    std::memcpy(&version, content.data() + 4, sizeof version);
    std::memcpy(&length, content.data() + 8, sizeof length);
    return version == 2 && length <= content.size();
}

// The word by which assimp knows the importer.
std::string importer_for(const std::filesystem::path& path, std::string_view content) {
    const std::string extension = lower_extension(path);
    const auto require = [&](bool is_so, const char* format) {
        if (!is_so) throw InputError(path.string(), "", std::string("its content is not ") + format);
    };
    if (extension == ".obj") {
        require(looks_like_obj(content), "Wavefront OBJ");
        return "obj";
    }
    if (extension == ".gltf") {
        require(looks_like_gltf(content), "glTF 2.0");
        return "gltf";
    }
    if (extension == ".glb") {
        require(looks_like_glb(content), "binary glTF 2.0");
        return "glb";
    }
    throw InputError(path.string(), "",
                     "the format '" + extension + "' is not on the list of those that are read: .obj, .gltf, .glb");
}

ImportAnswer run_guarded(const std::filesystem::path& path, const std::string& importer, const ImportLimits& limits) {
    const ChildResult result = run_in_child(
        [&] {
            ImportAnswer answer;
            try {
                answer = read_with_assimp(path.string(), importer);
            } catch (const std::exception& error) {
                answer = {error.what(), {}};
            }
            return to_bytes(answer);
        },
        {.memory_bytes = limits.memory_bytes,
         .processor_seconds = limits.processor_seconds,
         .wall_seconds = limits.wall_seconds});
    const auto fail = [&](const char* problem) -> ImportAnswer { throw InputError(path.string(), "", problem); };
    switch (result.end) {
        case ChildEnd::NotStarted:
            return fail("no process could be started to read it");
        case ChildEnd::Crashed:
            return fail("the file crashes its reader");
        case ChildEnd::TimedOut:
            return fail("the file takes its reader too long");
        case ChildEnd::TooMuch:
            return fail("the file holds too much");
        case ChildEnd::Done:
            break;
    }
    std::optional<ImportAnswer> answer = from_bytes(result.answer);
    if (!answer) return fail("the file leads its reader astray");
    return std::move(*answer);
}

// One line, and no longer than a message should be.
std::string tidy(std::string text) {
    constexpr std::size_t kLongest = 200;
    text.resize(std::min(text.size(), kLongest));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }, ' ');
    return text;
}

template <class Vector>
bool is_reasonable(const Vector& v) {
    return v.allFinite() && v.cwiseAbs().maxCoeff() <= kLargest;
}

void check_skin(const ImportedScene& scene, const ImportedMesh& mesh, const InputError& broken) {
    if (!mesh.skin.empty() && mesh.skin.size() != mesh.x.size()) throw broken;
    for (const SkinWeights& skin : mesh.skin)
        for (std::size_t k = 0; k < 4; ++k)
            if (!(skin.weights[k] >= 0 && skin.weights[k] <= 1.001F) ||
                (skin.weights[k] > 0 && skin.bones[k] >= scene.bones.size()))
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

void check_scene(const ImportedScene& scene, const std::string& file, const ImportLimits& limits) {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        vertices += scene.meshes[i].x.size();
        triangles += scene.meshes[i].triangles.size();
        if (vertices > limits.vertices || triangles > limits.triangles)
            throw InputError(file, "", "more than " + std::to_string(limits.triangles) + " triangles");
        check_mesh(scene, scene.meshes[i], file, i);
    }
    if (triangles == 0) throw InputError(file, "", "it holds no triangles");
    for (std::size_t i = 0; i < scene.bones.size(); ++i)
        if (scene.bones[i].parent < -1 || scene.bones[i].parent >= int(i) || !is_reasonable(scene.bones[i].joint))
            throw InputError(file, "bone " + std::to_string(i), "it is broken");
}

}  // namespace

ImportedScene guarded_import(const std::filesystem::path& path, const ImportLimits& limits) {
    const std::string importer = importer_for(path, read_file(path, limits.file_bytes));
    ImportAnswer answer = run_guarded(path, importer, limits);
    // With one importer left to assimp, "no suitable reader" means that this one found the content broken.
    if (answer.failure.starts_with("No suitable reader")) answer.failure = "its content is broken";
    if (!answer.failure.empty()) throw InputError(path.string(), "", "cannot be read: " + tidy(answer.failure));
    check_scene(answer.scene, path.string(), limits);
    return std::move(answer.scene);
}

}  // namespace selvedge
