// Converts assimp's scene to an ImportedScene; runs in the guarded child process.
#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/core/file.h"
#include "sim/repair/gltf_skins.h"
#include "sim/repair/guarded_import.h"
#include "sim/repair/plain_gltf.h"

namespace selvedge::sim {
namespace {

void keep_only_importer(Assimp::Importer& importer, const std::string& extension) {
    std::vector<Assimp::BaseImporter*> others;
    for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
        const aiImporterDesc* description = importer.GetImporterInfo(i);
        std::istringstream extensions(description ? description->mFileExtensions : "");
        bool is_wanted = false;
        for (std::string word; extensions >> word;) is_wanted = is_wanted || word == extension;
        if (!is_wanted) others.push_back(importer.GetImporter(i));
    }
    for (Assimp::BaseImporter* other : others) {
        importer.UnregisterLoader(other);
        const std::unique_ptr<Assimp::BaseImporter> released(other);  // unregistered: ours
    }
}

Eigen::Affine3d affine(const aiMatrix4x4& m) {
    Eigen::Affine3d all = Eigen::Affine3d::Identity();
    all.matrix().topRows<3>() << double(m.a1), double(m.a2), double(m.a3), double(m.a4), double(m.b1), double(m.b2),
        double(m.b3), double(m.b4), double(m.c1), double(m.c2), double(m.c3), double(m.c4);
    return all;
}

// Scale and rotation of a matrix whose columns are orthogonal. A mirrored one gets a negative scale in x.
Transform transform_of(const aiMatrix4x4& m) {
    const Eigen::Affine3d all = affine(m);
    Transform transform{.translation = all.translation(), .scale = all.linear().colwise().norm()};
    if (all.linear().determinant() < 0) transform.scale.x() *= -1;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    for (int k = 0; k < 3; ++k)
        if (transform.scale[k] != 0) turn.col(k) = all.linear().col(k) / transform.scale[k];
    transform.rotation = Eigen::Quaterniond(turn).normalized();
    return transform;
}

// The nodes as bones, and the global transform of each.
struct Skeleton {
    std::map<std::string, int> bone_of_node;  // of several nodes with one name, the first
    std::map<const aiNode*, int> index_of_node;
    std::vector<aiMatrix4x4> transforms;  // by node
    std::vector<bool> is_bound;           // by node: a mesh gave the inverse bind transform
    std::vector<Bone> bones;              // the nodes, then those that bone_for() adds; empty if nothing moves
};

void add_node(const aiNode& node, const aiMatrix4x4& parent, int parent_bone, const MotionLimits& limits,
              Skeleton& skeleton) {
    if (skeleton.bones.size() >= limits.joints)
        throw std::runtime_error("it has more than " + std::to_string(limits.joints) + " joints");
    const aiMatrix4x4 place = parent * node.mTransformation;
    const int index = int(skeleton.bones.size());
    const std::string name = node.mName.C_Str();
    skeleton.bone_of_node.try_emplace(name, index);
    skeleton.index_of_node[&node] = index;
    skeleton.transforms.push_back(place);
    Bone bone{.name = name, .parent = parent_bone, .joint = Vec3d(place.a4, place.b4, place.c4)};
    bone.rest = transform_of(node.mTransformation);
    bone.inverse_bind = affine(aiMatrix4x4(place).Inverse());
    if (!bone.inverse_bind.matrix().allFinite()) bone.inverse_bind.setIdentity();  // scale 0, of a node without skin
    skeleton.bones.push_back(std::move(bone));
    for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(*node.mChildren[i], place, index, limits, skeleton);
}

bool is_moving(const aiScene& scene) {
    if (scene.mNumAnimations > 0) return true;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        if (scene.mMeshes[m]->mNumBones > 0) return true;
    return false;
}

Skeleton find_skeleton(const aiScene& scene, ImportKind kind, const MotionLimits& limits) {
    Skeleton skeleton;
    if (kind == ImportKind::Motion || is_moving(scene)) add_node(*scene.mRootNode, {}, -1, limits, skeleton);
    skeleton.is_bound.assign(skeleton.bones.size(), false);
    return skeleton;
}

bool is_same(const Eigen::Affine3d& a, const Eigen::Affine3d& b) {
    constexpr double kRounding = 1e-5;  // of floats
    return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() <= kRounding * (1 + a.matrix().cwiseAbs().maxCoeff());
}

// The bone of a node with that offset matrix. Several meshes may be bound to one node in different frames: the first
// frame is the node's, and each other one gets a bone of its own, which rests at the node.
int bone_for(Skeleton& skeleton, int node, const aiMatrix4x4& offset, const MotionLimits& limits) {
    const Eigen::Affine3d inverse_bind = affine(offset);
    Bone& bone = skeleton.bones[std::size_t(node)];
    if (!skeleton.is_bound[std::size_t(node)]) {
        skeleton.is_bound[std::size_t(node)] = true;
        bone.inverse_bind = inverse_bind;
        return node;
    }
    if (is_same(bone.inverse_bind, inverse_bind)) return node;
    for (std::size_t i = skeleton.is_bound.size(); i < skeleton.bones.size(); ++i)
        if (skeleton.bones[i].parent == node && is_same(skeleton.bones[i].inverse_bind, inverse_bind)) return int(i);
    if (skeleton.bones.size() >= 2 * limits.joints) throw std::runtime_error("its skin is bound in too many frames");
    Bone other{.name = bone.name + " (bound again)", .parent = node, .joint = bone.joint};
    other.inverse_bind = inverse_bind;
    skeleton.bones.push_back(std::move(other));
    return int(skeleton.bones.size()) - 1;
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

// Moves the vertices to their skinned positions in the rest pose. Vertices without weights follow the mesh's node.
void apply_skin(const aiMesh& mesh, int node, const MotionLimits& limits, Skeleton& skeleton, ImportedMesh& out) {
    std::vector<std::vector<Pull>> pulls(mesh.mNumVertices);
    std::vector<aiVector3D> sums(mesh.mNumVertices);
    std::vector<float> weights(mesh.mNumVertices, 0.0F);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone& bone = *mesh.mBones[b];
        const auto found = skeleton.bone_of_node.find(bone.mName.C_Str());
        if (found == skeleton.bone_of_node.end() || bone.mNumWeights == 0) continue;
        const int index = bone_for(skeleton, found->second, bone.mOffsetMatrix, limits);
        const aiMatrix4x4 move = skeleton.transforms[std::size_t(found->second)] * bone.mOffsetMatrix;
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
            const unsigned vertex = bone.mWeights[w].mVertexId;
            const float weight = bone.mWeights[w].mWeight;
            if (vertex >= mesh.mNumVertices) throw std::runtime_error("a skin weight names a vertex that is not there");
            if (!std::isfinite(weight)) throw std::runtime_error("a skin weight is not a number");
            if (!(weight > 0)) continue;
            sums[vertex] += (move * mesh.mVertices[vertex]) * weight;
            weights[vertex] += weight;
            pulls[vertex].push_back({weight, index});
        }
    }
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        if (weights[v] > 0)
            out.x[v] = Vec3f(sums[v].x, sums[v].y, sums[v].z) / weights[v];
        else
            pulls[v].push_back({1.0F, node});
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

ImportedMesh placed_mesh(const aiScene& scene, const aiMesh& mesh, const aiMatrix4x4& place) {
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
    return out;
}

// Transforms are passed down the tree and not looked up by name, because two nodes may have the same name.
void add_meshes(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, const MotionLimits& limits,
                Skeleton& skeleton, ImportedScene& out) {
    const aiMatrix4x4 place = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        if (node.mMeshes[i] >= scene.mNumMeshes) throw std::runtime_error("a node names a mesh that is not there");
        const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
        out.meshes.push_back(placed_mesh(scene, mesh, place));
        if (!skeleton.bones.empty())
            apply_skin(mesh, skeleton.index_of_node.at(&node), limits, skeleton, out.meshes.back());
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i)
        add_meshes(scene, *node.mChildren[i], place, limits, skeleton, out);
}

Vec3d value_of(const aiVector3D& v) {
    return Vec3d(double(v.x), double(v.y), double(v.z));
}

// Unit length, as files round; a rotation without length stays, and is refused later.
Eigen::Quaterniond value_of(const aiQuaternion& q) {
    const Eigen::Quaterniond value(double(q.w), double(q.x), double(q.y), double(q.z));
    return value.norm() > 1e-3 ? value.normalized() : value;
}

template <class Value, class Key>
Keys<Value> keys_of(const Key* keys, unsigned count, double ticks_per_second) {
    Keys<Value> out;
    for (unsigned k = 0; k < count; ++k) {
        out.times.push_back(keys[k].mTime / ticks_per_second);
        out.values.push_back(value_of(keys[k].mValue));
    }
    return out;
}

// Curves that start before time 0, as of FBX scenes, are moved to start there.
void start_at_zero(Clip& clip) {
    double first = 0;
    const auto each = [&](const auto& change) {
        for (Track& track : clip.tracks) {
            for (std::vector<double>* times : {&track.rotation.times, &track.translation.times, &track.scale.times})
                for (double& t : *times) change(t);
        }
    };
    each([&](double& t) { first = std::min(first, t); });
    if (first < 0 && std::isfinite(first)) each([&](double& t) { t -= first; });
    if (first < 0 && std::isfinite(first)) clip.seconds -= first;
}

// Where assimp divides a node of FBX into pivots and the node itself, it animates either the pivots, or the node alone
// with its whole transform: then the pivots, which keep theirs at rest, must not act a second time.
void hold_pivots_of_whole_transforms(const Skeleton& skeleton, Clip& clip) {
    constexpr std::string_view kMark = "_$AssimpFbx$_";
    std::vector<bool> is_animated(skeleton.bones.size(), false);
    for (const Track& track : clip.tracks) is_animated[std::size_t(track.bone)] = true;
    std::map<std::string, std::vector<int>> pivots_of;  // by the name of the node
    for (std::size_t i = 0; i < skeleton.bones.size(); ++i)
        if (const std::size_t mark = skeleton.bones[i].name.find(kMark); mark != std::string::npos)
            pivots_of[skeleton.bones[i].name.substr(0, mark)].push_back(int(i));
    for (const auto& [name, pivots] : pivots_of) {
        const auto node = skeleton.bone_of_node.find(name);
        if (node == skeleton.bone_of_node.end() || !is_animated[std::size_t(node->second)]) continue;
        if (std::ranges::any_of(pivots, [&](int pivot) { return is_animated[std::size_t(pivot)]; })) continue;
        for (const int pivot : pivots)
            clip.tracks.push_back({.bone = pivot,
                                   .rotation = {{0.0}, {Eigen::Quaterniond::Identity()}},
                                   .translation = {{0.0}, {Vec3d::Zero()}},
                                   .scale = {{0.0}, {Vec3d::Ones()}}});
    }
}

Clip clip_of(const aiAnimation& animation, const Skeleton& skeleton, const std::string& extension) {
    constexpr double kUsualRate = 25;  // 1/s, where a file gives none: assimp's default
    const bool is_rate_given = animation.mTicksPerSecond != 0 || extension == "bvh";
    const double rate = is_rate_given ? animation.mTicksPerSecond : kUsualRate;
    if (!(rate > 0) || !std::isfinite(rate)) throw std::runtime_error("the time of its frames is not a positive time");
    constexpr double kNoFrames = std::numeric_limits<unsigned>::max();  // assimp: frames - 1, of a BVH file without any
    if (animation.mDuration == kNoFrames) throw std::runtime_error("its motion has no frames");
    Clip clip{.name = animation.mName.C_Str(), .seconds = animation.mDuration / rate};
    std::map<int, bool> is_animated;
    for (unsigned c = 0; c < animation.mNumChannels; ++c) {
        const aiNodeAnim& channel = *animation.mChannels[c];
        const auto bone = skeleton.bone_of_node.find(channel.mNodeName.C_Str());
        if (bone == skeleton.bone_of_node.end() || !is_animated.emplace(bone->second, true).second) continue;
        Track& track = clip.tracks.emplace_back();
        track.bone = bone->second;
        track.rotation = keys_of<Eigen::Quaterniond>(channel.mRotationKeys, channel.mNumRotationKeys, rate);
        track.translation = keys_of<Vec3d>(channel.mPositionKeys, channel.mNumPositionKeys, rate);
        track.scale = keys_of<Vec3d>(channel.mScalingKeys, channel.mNumScalingKeys, rate);
    }
    if (extension == "fbx") {
        hold_pivots_of_whole_transforms(skeleton, clip);
        start_at_zero(clip);
    }
    for (const Track& track : clip.tracks)
        for (const std::vector<double>* times : {&track.rotation.times, &track.translation.times, &track.scale.times})
            if (!times->empty()) clip.seconds = std::max(clip.seconds, times->back());
    return clip;
}

// Which bones move something, or hold one that does.
std::vector<bool> find_used_bones(const ImportedScene& scene) {
    std::vector<bool> is_used(scene.bones.size(), false);
    for (const ImportedMesh& mesh : scene.meshes) {
        for (const SkinWeights& skin : mesh.skin)
            for (std::size_t k = 0; k < 4; ++k)
                if (skin.weights[k] > 0) is_used[skin.bones[k]] = true;
    }
    for (const Clip& clip : scene.clips)
        for (const Track& track : clip.tracks) is_used[std::size_t(track.bone)] = true;
    return is_used;
}

// A body's file has nodes that are no joints: those that carry its meshes, and those that only gather others. They are
// dropped where that changes no transform.
void drop_idle_bones(ImportedScene& scene, const std::vector<bool>& carries_mesh) {
    const std::vector<bool> is_used = find_used_bones(scene);
    std::vector<bool> has_children(scene.bones.size(), false);
    for (const Bone& bone : scene.bones)
        if (bone.parent >= 0) has_children[std::size_t(bone.parent)] = true;
    const Eigen::Affine3d none = Eigen::Affine3d::Identity();
    std::vector<int> index(scene.bones.size(), -1);  // of the kept bones; of a dropped one, its parent's
    std::vector<Bone> kept;
    for (std::size_t i = 0; i < scene.bones.size(); ++i) {
        Bone bone = scene.bones[i];
        if (bone.parent >= 0) bone.parent = index[std::size_t(bone.parent)];
        const bool is_gathering = bone.parent < 0 && has_children[i] && is_same(bone.rest.matrix(), none);
        if (!is_used[i] && (is_gathering || carries_mesh[i])) {
            index[i] = bone.parent;
            continue;
        }
        index[i] = int(kept.size());
        kept.push_back(std::move(bone));
    }
    for (ImportedMesh& mesh : scene.meshes) {
        for (SkinWeights& skin : mesh.skin)
            for (std::size_t k = 0; k < 4; ++k)
                skin.bones[k] = skin.weights[k] > 0 ? std::uint16_t(index[skin.bones[k]]) : std::uint16_t(0);
    }
    for (Clip& clip : scene.clips)
        for (Track& track : clip.tracks) track.bone = index[std::size_t(track.bone)];
    scene.bones = std::move(kept);
}

// Assimp cuts polygons into triangles in a time that grows with the square of their corners, of some shapes faster.
// Empty: it will not take long.
std::string problem_of_polygons(const aiScene& scene) {
    constexpr unsigned kMostCorners = 1000;  // the ends of a fine cylinder have a hundred
    constexpr double kMostSquares = 1e7;     // of corners, of all polygons
    double squares = 0;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const unsigned corners = mesh.mFaces[f].mNumIndices;
            if (corners > kMostCorners)
                return "a polygon of " + std::to_string(corners) + " corners: at most " + std::to_string(kMostCorners);
            if (corners > 4) squares += double(corners) * double(corners);
        }
    }
    return squares > kMostSquares ? "its polygons have too many corners: save it in triangles" : "";
}

// glTF has no other axis. FBX names one per file, which assimp turns to y in some versions, and tells in others.
bool says_y_up(const aiScene& scene, const std::string& extension) {
    constexpr int kY = 1;
    int axis = -1;
    const bool is_named = scene.mMetaData != nullptr && scene.mMetaData->Get("UpAxis", axis);
    return extension == "gltf" || extension == "glb" || (extension == "fbx" && is_named && axis == kY);
}

// nullptr: it cannot be read.
const aiScene* scene_in(const std::string& path, const std::string& extension, Assimp::Importer& importer) {
    if (extension != "gltf" && extension != "glb") return importer.ReadFile(path, 0);
    constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();  // whoever started this process has looked
    const std::optional<std::string> plain = plain_gltf(path, read_file(path, kAny));
    if (!plain) return importer.ReadFile(path, 0);
    check_gltf_skins(path, *plain);
    return importer.ReadFileFromMemory(plain->data(), plain->size(), 0, "glb");
}

}  // namespace

ImportAnswer read_with_assimp(const std::string& path, const std::string& extension, ImportKind kind,
                              const MotionLimits& limits) {
    Assimp::Importer importer;
    keep_only_importer(importer, extension);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    const aiScene* scene = scene_in(path, extension, importer);
    if (!scene || !scene->mRootNode) return {importer.GetErrorString(), {}};
    if (std::string problem = problem_of_polygons(*scene); !problem.empty()) return {std::move(problem), {}};
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
    if (!scene || !scene->mRootNode) return {importer.GetErrorString(), {}};
    if (scene->mNumAnimations > limits.clips)
        return {"it has more than " + std::to_string(limits.clips) + " animations", {}};
    ImportAnswer answer;
    answer.scene.is_y_up = says_y_up(*scene, extension);
    Skeleton skeleton = find_skeleton(*scene, kind, limits);
    if (kind == ImportKind::Surface)
        add_meshes(*scene, *scene->mRootNode, aiMatrix4x4(), limits, skeleton, answer.scene);
    for (unsigned a = 0; a < scene->mNumAnimations; ++a)
        answer.scene.clips.push_back(clip_of(*scene->mAnimations[a], skeleton, extension));
    answer.scene.bones = std::move(skeleton.bones);
    if (kind == ImportKind::Surface && !answer.scene.bones.empty()) {
        std::vector<bool> carries_mesh(answer.scene.bones.size(), false);
        for (const auto& [node, index] : skeleton.index_of_node)
            carries_mesh[std::size_t(index)] = node->mNumMeshes > 0 && node->mNumChildren == 0;
        drop_idle_bones(answer.scene, carries_mesh);
    }
    return answer;
}

}  // namespace selvedge::sim
