#include "sim/body/guarded_import.h"

#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/file.h"

namespace selvedge::sim {
namespace {

constexpr float kLargest = 1e6F;  // admits a body of 1,800 mm, rejects a corrupted exponent

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

// The file extension by which assimp identifies the importer.
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
        limits.child);
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
    if (!answer) return fail("the reader returned invalid data");
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
    // Only one importer is enabled, so "no suitable reader" means that it found the content broken.
    if (answer.failure.starts_with("No suitable reader")) answer.failure = "its content is broken";
    if (!answer.failure.empty()) throw InputError(path.string(), "", "cannot be read: " + one_line(answer.failure));
    check_scene(answer.scene, path.string(), limits);
    return std::move(answer.scene);
}

namespace {

// The scene's nodes that are bones, and the global transform of every node.
struct Skeleton {
    std::map<std::string, int> bone_of_node;
    std::map<std::string, aiMatrix4x4> transform_of_node;
    std::vector<Bone> bones;
};

void keep_only_importer(Assimp::Importer& importer, const std::string& extension) {
    std::vector<Assimp::BaseImporter*> others;
    for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
        const aiImporterDesc* description = importer.GetImporterInfo(i);
        std::istringstream extensions(description ? description->mFileExtensions : "");
        bool is_wanted = false;
        for (std::string word; extensions >> word;) is_wanted = is_wanted || word == extension;
        if (!is_wanted) others.push_back(importer.GetImporter(i));
    }
    for (Assimp::BaseImporter* other : others) importer.UnregisterLoader(other);
}

void transform_nodes(const aiNode& node, const aiMatrix4x4& parent, int parent_bone, Skeleton& skeleton) {
    const aiMatrix4x4 place = parent * node.mTransformation;
    const std::string name = node.mName.C_Str();
    skeleton.transform_of_node[name] = place;
    const auto bone = skeleton.bone_of_node.find(name);
    if (bone != skeleton.bone_of_node.end() && bone->second < 0) {
        bone->second = int(skeleton.bones.size());
        skeleton.bones.push_back({name, parent_bone, Vec3d(place.a4, place.b4, place.c4)});
        parent_bone = bone->second;
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) transform_nodes(*node.mChildren[i], place, parent_bone, skeleton);
}

Skeleton find_skeleton(const aiScene& scene) {
    constexpr int kNotYetMet = -1;
    Skeleton skeleton;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        for (unsigned b = 0; b < scene.mMeshes[m]->mNumBones; ++b)
            skeleton.bone_of_node[scene.mMeshes[m]->mBones[b]->mName.C_Str()] = kNotYetMet;
    transform_nodes(*scene.mRootNode, aiMatrix4x4(), -1, skeleton);
    return skeleton;
}

struct Pull {
    float weight;
    int bone;
};

// The four largest weights, scaled to sum 1; equal weights in the order of the bones.
SkinWeights strongest(std::vector<Pull> pulls) {
    std::sort(pulls.begin(), pulls.end(), [](const Pull& a, const Pull& b) {
        return a.weight != b.weight ? a.weight > b.weight : a.bone < b.bone;
    });
    pulls.resize(std::min<std::size_t>(pulls.size(), 4));
    float sum = 0;
    for (const Pull& pull : pulls) sum += pull.weight;
    SkinWeights skin;
    for (std::size_t k = 0; k < pulls.size() && sum > 0; ++k) {
        skin.bones[k] = std::uint16_t(pulls[k].bone);
        skin.weights[k] = pulls[k].weight / sum;
    }
    return skin;
}

// Moves the vertices to their skinned positions in the rest pose.
void apply_skin(const aiMesh& mesh, const Skeleton& skeleton, ImportedMesh& out) {
    std::vector<std::vector<Pull>> pulls(mesh.mNumVertices);
    std::vector<aiVector3D> sums(mesh.mNumVertices);
    std::vector<float> weights(mesh.mNumVertices, 0.0F);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone& bone = *mesh.mBones[b];
        const std::string name = bone.mName.C_Str();
        const int index = skeleton.bone_of_node.at(name);
        if (index < 0) continue;
        const aiMatrix4x4 move = skeleton.transform_of_node.at(name) * bone.mOffsetMatrix;
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
            const unsigned vertex = bone.mWeights[w].mVertexId;
            const float weight = bone.mWeights[w].mWeight;
            if (vertex >= mesh.mNumVertices || !(weight > 0)) continue;
            sums[vertex] += (move * mesh.mVertices[vertex]) * weight;
            weights[vertex] += weight;
            pulls[vertex].push_back({weight, index});
        }
    }
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        if (weights[v] > 0) out.x[v] = Vec3f(sums[v].x, sums[v].y, sums[v].z) / weights[v];
        out.skin.push_back(strongest(std::move(pulls[v])));
    }
}

void add_triangles(const aiMesh& mesh, bool is_mirrored, ImportedMesh& out) {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        if (face.mNumIndices != 3) continue;  // points and lines
        out.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
        if (is_mirrored) std::swap(out.triangles.back()[1], out.triangles.back()[2]);
    }
}

ImportedMesh placed_mesh(const aiScene& scene, const aiMesh& mesh, const aiMatrix4x4& place, const Skeleton& skeleton) {
    ImportedMesh out;
    out.name = mesh.mName.C_Str();
    if (mesh.mMaterialIndex < scene.mNumMaterials)
        out.material = scene.mMaterials[mesh.mMaterialIndex]->GetName().C_Str();
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const aiVector3D p = place * mesh.mVertices[v];
        out.x.emplace_back(p.x, p.y, p.z);
        if (mesh.HasTextureCoords(0)) out.u.emplace_back(mesh.mTextureCoords[0][v].x, mesh.mTextureCoords[0][v].y);
    }
    add_triangles(mesh, place.Determinant() < 0, out);
    if (mesh.HasBones()) apply_skin(mesh, skeleton, out);
    return out;
}

// Transforms are passed down the tree and not looked up by name, because two nodes may have the same name.
void add_meshes(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, const Skeleton& skeleton,
                ImportedScene& out) {
    const aiMatrix4x4 place = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        if (node.mMeshes[i] >= scene.mNumMeshes) throw std::runtime_error("a node names a mesh that is not there");
        out.meshes.push_back(placed_mesh(scene, *scene.mMeshes[node.mMeshes[i]], place, skeleton));
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) add_meshes(scene, *node.mChildren[i], place, skeleton, out);
}

}  // namespace

ImportAnswer read_with_assimp(const std::string& path, const std::string& extension) {
    Assimp::Importer importer;
    keep_only_importer(importer, extension);
    const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate);
    if (!scene || !scene->mRootNode) return {importer.GetErrorString(), {}};
    ImportAnswer answer;
    Skeleton skeleton = find_skeleton(*scene);
    add_meshes(*scene, *scene->mRootNode, aiMatrix4x4(), skeleton, answer.scene);
    answer.scene.bones = std::move(skeleton.bones);
    return answer;
}

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

namespace {

using Clock = std::chrono::steady_clock;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kLimitMemory = false;  // its shadow memory reserves terabytes of address space
#else
constexpr bool kLimitMemory = true;
#endif

void limit(decltype(RLIMIT_CPU) resource, rlim_t most) {
    const rlimit values{most, most};
    ::setrlimit(resource, &values);
}

// Address space in use, bytes. The limit is relative to it, because threads and drivers reserve much that they never
// use.
std::size_t address_space_in_use() {
    std::FILE* file = std::fopen("/proc/self/statm", "r");
    unsigned long pages = 0;
    if (file) {
        if (std::fscanf(file, "%lu", &pages) != 1) pages = 0;
        std::fclose(file);
    }
    return std::size_t(pages) * std::size_t(::sysconf(_SC_PAGESIZE));
}

void confine(const ChildLimits& limits) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CPU, rlim_t(limits.processor_seconds));
    if (kLimitMemory) limit(RLIMIT_AS, address_space_in_use() + limits.memory_bytes);
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, standard);
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT, SIGPIPE})
        ::signal(signal, SIG_DFL);
}

// Exits without running the parent's destructors and exit handlers.
[[noreturn]] void run_and_exit(const std::function<std::string()>& work, const ChildLimits& limits, int pipe_end) {
    constexpr int kFailed = 1;
    try {
        confine(limits);
        const std::string answer = work();
        for (std::size_t done = 0; done < answer.size();) {
            const ssize_t written = ::write(pipe_end, answer.data() + done, answer.size() - done);
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) ::_exit(kFailed);
            done += std::size_t(written);
        }
        ::_exit(0);
    } catch (...) {
        ::_exit(kFailed);
    }
}

// Reads until the child closes its end of the pipe. Done: it did so before the deadline and within answer_bytes.
ChildResult collect(int pipe_end, const ChildLimits& limits) {
    const Clock::time_point deadline = Clock::now() + std::chrono::seconds(limits.wall_seconds);
    ChildResult result;
    std::array<char, 1 << 16> part{};
    while (true) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) return {ChildEnd::TimedOut, {}};
        pollfd waiting{pipe_end, POLLIN, 0};
        const int ready = ::poll(&waiting, 1, int(std::min<long>(left, 60'000)));
        if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
        const ssize_t got = ready < 0 ? -1 : ::read(pipe_end, part.data(), part.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return {ChildEnd::Crashed, {}};
        if (got == 0) return result;
        if (result.answer.size() + std::size_t(got) > limits.answer_bytes) return {ChildEnd::TooMuch, {}};
        result.answer.append(part.data(), std::size_t(got));
    }
}

// The child's exit status as waitpid() gives it.
int reap(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return -1;
    return status;
}

}  // namespace

ChildResult run_in_child(const std::function<std::string()>& work, const ChildLimits& limits) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return {ChildEnd::NotStarted, {}};
    const pid_t child = ::fork();
    if (child < 0) {
        for (const int end : ends) ::close(end);
        return {ChildEnd::NotStarted, {}};
    }
    if (child == 0) {
        ::close(ends[0]);
        run_and_exit(work, limits, ends[1]);
    }
    ::close(ends[1]);
    ChildResult result = collect(ends[0], limits);
    ::close(ends[0]);
    if (result.end != ChildEnd::Done) ::kill(child, SIGKILL);
    const int status = reap(child);
    if (result.end != ChildEnd::Done) return result;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return {ChildEnd::TimedOut, {}};
    // SIGKILL comes from the hard CPU limit: run_in_child() itself has not killed this child.
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) return {ChildEnd::TimedOut, {}};
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return {ChildEnd::Crashed, {}};
    return result;
}

}  // namespace selvedge::sim
