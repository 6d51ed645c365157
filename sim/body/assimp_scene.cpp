#include "sim/body/assimp_scene.h"

#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace selvedge {

namespace {

// The scene's nodes that are bones, and where every node stands.
struct Skeleton {
    std::map<std::string, int> bone_of_node;
    std::map<std::string, aiMatrix4x4> place_of_node;
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

void place_nodes(const aiNode& node, const aiMatrix4x4& parent, int parent_bone, Skeleton& skeleton) {
    const aiMatrix4x4 place = parent * node.mTransformation;
    const std::string name = node.mName.C_Str();
    skeleton.place_of_node[name] = place;
    const auto bone = skeleton.bone_of_node.find(name);
    if (bone != skeleton.bone_of_node.end() && bone->second < 0) {
        bone->second = int(skeleton.bones.size());
        skeleton.bones.push_back({name, parent_bone, Vec3d(place.a4, place.b4, place.c4)});
        parent_bone = bone->second;
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) place_nodes(*node.mChildren[i], place, parent_bone, skeleton);
}

Skeleton find_skeleton(const aiScene& scene) {
    constexpr int kNotYetMet = -1;
    Skeleton skeleton;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        for (unsigned b = 0; b < scene.mMeshes[m]->mNumBones; ++b)
            skeleton.bone_of_node[scene.mMeshes[m]->mBones[b]->mName.C_Str()] = kNotYetMet;
    place_nodes(*scene.mRootNode, aiMatrix4x4(), -1, skeleton);
    return skeleton;
}

struct Pull {
    float weight;
    int bone;
};

// The four strongest, equal ones in the bones' order; weights scaled to sum 1.
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

// Moves the vertices to where the bones hold them in the rest pose.
void apply_skin(const aiMesh& mesh, const Skeleton& skeleton, ImportedMesh& out) {
    std::vector<std::vector<Pull>> pulls(mesh.mNumVertices);
    std::vector<aiVector3D> sums(mesh.mNumVertices);
    std::vector<float> weights(mesh.mNumVertices, 0.0F);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone& bone = *mesh.mBones[b];
        const std::string name = bone.mName.C_Str();
        const int index = skeleton.bone_of_node.at(name);
        if (index < 0) continue;
        const aiMatrix4x4 move = skeleton.place_of_node.at(name) * bone.mOffsetMatrix;
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

// Places come down the tree, not by name: two nodes may share one.
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

}  // namespace selvedge
