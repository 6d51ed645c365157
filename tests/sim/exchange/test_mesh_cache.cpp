// Animation caches, read back by assimp (.glb, .obj) and by a parser of their specification (.pc2, the JSON of .glb).
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>

#include "sim/body/skin.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/exchange/mesh_cache.h"
#include "sim/exchange/mesh_file.h"
#include "tests/sim/exchange/file_bytes.h"
#include "tests/sim/exchange/glb_container.h"
#include "tests/sim/exchange/two_panels.h"
#include "tests/support/bodies.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

// The panels swing about the vertical axis, and one vertex has a way of its own.
std::vector<Vec3f> frame_of(const DrawMesh& mesh, std::size_t frame) {
    const Eigen::AngleAxisf turn(0.3F * static_cast<float>(frame), Vec3f::UnitY());
    std::vector<Vec3f> x;
    for (const Vec3f& p : mesh.x) x.emplace_back(turn * p);
    x[4].z() -= 0.01F * static_cast<float>(frame);
    return x;
}

void write_frames(const std::filesystem::path& path, const DrawMesh& mesh, std::size_t frames,
                  const CacheOptions& options) {
    const auto cache = open_mesh_cache(path, mesh, options);
    for (std::size_t i = 0; i < frames; ++i) cache->add(frame_of(mesh, i));
    cache->finish();
}

std::string message_of(const std::filesystem::path& path, const DrawMesh& mesh, const CacheOptions& options,
                       const DrawMesh* body = nullptr) {
    try {
        open_mesh_cache(path, mesh, options, body);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
    std::ranges::sort(names);
    return names;
}

// A PC2 file, parsed as its description in sim/exchange/pc2_file.h says.
struct ReadPc2 {
    std::int32_t version = 0, points = 0, samples = 0;
    float start = 0, rate = 0;
    std::vector<float> numbers;
};

ReadPc2 read_pc2(const std::filesystem::path& path) {
    const std::string bytes = read_file(path, kLimit);
    EXPECT_EQ(bytes.substr(0, 12), std::string("POINTCACHE2\0", 12));
    ReadPc2 read{.version = value_at<std::int32_t>(bytes, 12),
                 .points = value_at<std::int32_t>(bytes, 16),
                 .samples = value_at<std::int32_t>(bytes, 28),
                 .start = value_at<float>(bytes, 20),
                 .rate = value_at<float>(bytes, 24),
                 .numbers = {}};
    EXPECT_EQ(bytes.size(), 32 + std::size_t(read.samples) * std::size_t(read.points) * 12);
    for (std::size_t at = 32; at < bytes.size(); at += 4) read.numbers.push_back(value_at<float>(bytes, at));
    return read;
}

void expect_frames(const ReadPc2& read, const DrawMesh& mesh) {
    ASSERT_EQ(read.points, int(mesh.x.size()));
    for (std::size_t frame = 0; frame < std::size_t(read.samples); ++frame) {
        const std::vector<Vec3f> x = frame_of(mesh, frame);
        for (std::size_t i = 0; i < 3 * x.size(); ++i)
            EXPECT_EQ(read.numbers.at(frame * 3 * x.size() + i), x[i / 3][int(i % 3)]);
    }
}

TEST(MeshCache, pc2_holds_every_frame_behind_its_header) {
    const TemporaryFolder folder;
    write_frames(folder / "cache.pc2", two_panels(), 5, {.frames = 5, .first_frame = 12});
    const ReadPc2 read = read_pc2(folder / "cache.pc2");
    EXPECT_EQ(read.version, 1);
    EXPECT_EQ(read.start, 12.0F);
    EXPECT_EQ(read.rate, 1.0F);
    EXPECT_EQ(read.samples, 5);
    expect_frames(read, two_panels());
    EXPECT_EQ(names_in(folder / ""), (std::vector<std::string>{"cache.obj", "cache.pc2"}));
}

TEST(MeshCache, pc2_has_the_mesh_beside_it_in_the_same_order) {
    const TemporaryFolder folder;
    const DrawMesh mesh = two_panels();
    write_frames(folder / "cache.pc2", mesh, 2, {.frames = 2});
    std::istringstream lines(read_file(folder / "cache.obj", kLimit));
    std::size_t vertices = 0;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("v ")) continue;
        Vec3f x;
        std::istringstream(line.substr(2)) >> x.x() >> x.y() >> x.z();
        EXPECT_EQ(x, mesh.x.at(vertices++)) << line;
    }
    EXPECT_EQ(vertices, mesh.x.size());
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile((folder / "cache.obj").string(), 0);
    ASSERT_NE(scene, nullptr) << importer.GetErrorString();
    ASSERT_EQ(scene->mNumMeshes, 2U);
    for (std::size_t panel = 0; panel < 2; ++panel) {
        EXPECT_EQ(scene->mMeshes[panel]->mNumFaces, 2U);
        EXPECT_TRUE(scene->mMeshes[panel]->HasTextureCoords(0));
    }
}

TEST(MeshCache, that_ends_early_holds_the_frames_so_far) {
    const TemporaryFolder folder;
    write_frames(folder / "cache.pc2", two_panels(), 3, {.frames = 100});
    EXPECT_EQ(read_pc2(folder / "cache.pc2").samples, 3);
    write_frames(folder / "cache.glb", two_panels(), 3, {.frames = 100});
    const Container file = open(read_file(folder / "cache.glb", kLimit));
    expect_sound_accessors(file);
    const Json& mesh = file.root.find("meshes")->elements()[0];
    EXPECT_EQ(mesh.find("primitives")->elements()[0].find("targets")->elements().size(), 2U);
}

TEST(MeshCache, that_is_dropped_leaves_the_old_file_and_nothing_else) {
    const TemporaryFolder folder;
    for (const char* name : {"cache.pc2", "cache.glb"}) {
        write_file_atomically(folder / name, "old");
        const auto cache = open_mesh_cache(folder / name, two_panels(), {.frames = 4});
        cache->add(two_panels().x);
    }
    EXPECT_EQ(names_in(folder / ""), (std::vector<std::string>{"cache.glb", "cache.pc2"}));
    EXPECT_EQ(read_file(folder / "cache.pc2", kLimit), "old");
    EXPECT_EQ(read_file(folder / "cache.glb", kLimit), "old");
}

// What is left of a program that was killed.
TEST(MeshCache, pc2_can_be_read_from_the_temporary_file_of_an_unfinished_cache) {
    const TemporaryFolder folder;
    const auto cache = open_mesh_cache(folder / "cache.pc2", two_panels(), {.frames = 9});
    for (std::size_t i = 0; i < 4; ++i) cache->add(frame_of(two_panels(), i));
    const std::vector<std::string> names = names_in(folder / "");
    ASSERT_EQ(names.size(), 1U);
    const ReadPc2 read = read_pc2(folder / names[0].c_str());
    EXPECT_EQ(read.samples, 4);
    expect_frames(read, two_panels());
}

// Reads with assimp and compares every vertex of every frame.
void expect_assimp_reads(const std::filesystem::path& path, const DrawMesh& mesh, std::size_t frames) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path.string(), 0);
    ASSERT_NE(scene, nullptr) << importer.GetErrorString();
    const std::vector<PanelPart> parts = split_by_panel(mesh);
    ASSERT_EQ(scene->mNumMeshes, parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const aiMesh& read = *scene->mMeshes[i];
        ASSERT_EQ(read.mNumVertices, parts[i].vertices.size());
        EXPECT_EQ(read.mNumFaces, parts[i].triangles.size());
        EXPECT_STREQ(scene->mMaterials[read.mMaterialIndex]->GetName().C_Str(), parts[i].name.c_str());
        ASSERT_EQ(read.mNumAnimMeshes, frames - 1);
        ASSERT_TRUE(read.HasTextureCoords(0) && read.HasTextureCoords(1));
        for (std::size_t frame = 0; frame < frames; ++frame) {
            const std::vector<Vec3f> x = frame_of(mesh, frame);
            const std::vector<Vec3f> normals = vertex_normals(x, mesh.triangles, mesh.turned_corners);
            const aiVector3D* positions = frame == 0 ? read.mVertices : read.mAnimMeshes[frame - 1]->mVertices;
            const aiVector3D* directions = frame == 0 ? read.mNormals : read.mAnimMeshes[frame - 1]->mNormals;
            for (std::size_t v = 0; v < parts[i].vertices.size(); ++v) {
                const std::uint32_t at = parts[i].vertices[v];
                const Vec3f right_side = parts[i].is_turned[v] ? Vec3f(-normals[at]) : normals[at];
                EXPECT_LT((Vec3f(positions[v].x, positions[v].y, positions[v].z) - x[at]).norm(), 3e-7F);
                EXPECT_LT((Vec3f(directions[v].x, directions[v].y, directions[v].z) - right_side).norm(), 1e-6F);
                const aiVector3D& u = read.mTextureCoords[1][v];  // the metric ones
                EXPECT_LT((Vec2f(u.x, u.y) - parts[i].u[v]).norm(), 3e-7F);
            }
        }
    }
}

TEST(MeshCache, glb_is_read_by_assimp_frame_by_frame) {
    const TemporaryFolder folder;
    constexpr std::size_t kFrames = 6;
    write_frames(folder / "cache.glb", two_panels(), kFrames, {.frames = kFrames, .frames_per_second = 25});
    expect_assimp_reads(folder / "cache.glb", two_panels(), kFrames);
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile((folder / "cache.glb").string(), 0);
    ASSERT_NE(scene, nullptr);
    ASSERT_EQ(scene->mNumAnimations, 1U);
    const aiAnimation& animation = *scene->mAnimations[0];
    ASSERT_EQ(animation.mNumMorphMeshChannels, 1U);
    const aiMeshMorphAnim& channel = *animation.mMorphMeshChannels[0];
    ASSERT_EQ(channel.mNumKeys, kFrames);
    for (std::size_t key = 0; key < kFrames; ++key) {
        const aiMeshMorphKey& at = channel.mKeys[key];
        EXPECT_NEAR(at.mTime / animation.mTicksPerSecond, double(key) / 25, 1e-6);
        ASSERT_EQ(at.mNumValuesAndWeights, kFrames - 1);
        for (std::size_t target = 0; target + 1 < kFrames; ++target)
            EXPECT_EQ(at.mWeights[target], target + 1 == key ? 1.0 : 0.0);
    }
}

TEST(MeshCache, glb_keeps_the_right_side_of_each_panel_in_every_frame) {
    const TemporaryFolder folder;
    const DrawMesh mesh = sewn_right_to_wrong();
    ASSERT_FALSE(mesh.turned_corners.empty());
    write_frames(folder / "cache.glb", mesh, 4, {.frames = 4});
    expect_assimp_reads(folder / "cache.glb", mesh, 4);
}

TEST(MeshCache, glb_is_sound_and_states_bounds_names_and_interpolation) {
    const TemporaryFolder folder;
    for (const bool is_step : {false, true}) {
        const CacheOptions options{.frames = 3,
                                   .first_frame = 7,
                                   .interpolation = is_step ? CacheInterpolation::Step : CacheInterpolation::Linear,
                                   .has_normals = !is_step};
        write_frames(folder / "cache.glb", two_panels(), 3, options);
        const Container file = open(read_file(folder / "cache.glb", kLimit));
        expect_sound_accessors(file);
        EXPECT_FALSE(file.root.find("extensionsUsed"));
        const Json& sampler = file.root.find("animations")->elements()[0].find("samplers")->elements()[0];
        EXPECT_EQ(sampler.find("interpolation")->string(), is_step ? "STEP" : "LINEAR");
        const Json& mesh = file.root.find("meshes")->elements()[0];
        EXPECT_EQ(mesh.find("extras")->find("targetNames")->elements()[1].string(), "frame 9");
        const Json& target = mesh.find("primitives")->elements()[1].find("targets")->elements()[1];
        EXPECT_EQ(target.find("NORMAL") != nullptr, !is_step);
        const Json& accessor = file.root.find("accessors")->elements()[index_of(target, "POSITION")];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            float low = std::numeric_limits<float>::max(), high = -low;
            for (std::size_t v = 0; v < index_of(accessor, "count"); ++v) {
                low = std::min(low, float_at(file, accessor, 3 * v + axis));
                high = std::max(high, float_at(file, accessor, 3 * v + axis));
            }
            EXPECT_EQ(float(accessor.find("min")->elements()[axis].number()), low);
            EXPECT_EQ(float(accessor.find("max")->elements()[axis].number()), high);
        }
    }
}

TEST(MeshCache, glb_of_one_frame_has_no_animation) {
    const TemporaryFolder folder;
    write_frames(folder / "cache.glb", two_panels(), 1, {.frames = 1});
    const Container file = open(read_file(folder / "cache.glb", kLimit));
    expect_sound_accessors(file);
    EXPECT_FALSE(file.root.find("animations"));
    expect_assimp_reads(folder / "cache.glb", two_panels(), 1);
}

TEST(MeshCache, glb_takes_a_body_that_moves_along) {
    const TemporaryFolder folder;
    Body body = shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 3);
    const DrawMesh surface = body_mesh(body);
    const auto cache = open_mesh_cache(folder / "cache.glb", two_panels(), {.frames = 4}, &surface);
    for (std::size_t i = 0; i < 4; ++i) cache->add(frame_of(two_panels(), i), frame_of(surface, i));
    cache->finish();
    expect_sound_accessors(open(read_file(folder / "cache.glb", kLimit)));
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile((folder / "cache.glb").string(), 0);
    ASSERT_NE(scene, nullptr) << importer.GetErrorString();
    ASSERT_EQ(scene->mNumMeshes, 3U);
    const aiMesh& read = *scene->mMeshes[2];
    EXPECT_STREQ(scene->mMaterials[read.mMaterialIndex]->GetName().C_Str(), "body");
    ASSERT_EQ(read.mNumVertices, body.x.size());
    ASSERT_EQ(read.mNumAnimMeshes, 3U);
    EXPECT_EQ(scene->mAnimations[0]->mNumMorphMeshChannels, 2U);
    const std::vector<Vec3f> last = frame_of(surface, 3);
    const std::vector<PanelPart> parts = split_by_panel(surface);
    for (std::size_t v = 0; v < last.size(); ++v) {
        const aiVector3D& p = read.mAnimMeshes[2]->mVertices[v];
        EXPECT_LT((Vec3f(p.x, p.y, p.z) - last[parts[0].vertices[v]]).norm(), 3e-7F);
    }
}

TEST(MeshCache, glb_holds_no_vertex_that_stays_in_place) {
    const TemporaryFolder folder;
    const DrawMesh surface = body_mesh(shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 8));
    constexpr std::size_t kFrames = 40;
    const auto cache = open_mesh_cache(folder / "cache.glb", surface, {.frames = kFrames});
    for (std::size_t i = 0; i < kFrames; ++i) {
        std::vector<Vec3f> x = surface.x;
        x[7].y() += 0.01F * static_cast<float>(i);
        cache->add(x);
    }
    cache->finish();
    const Container file = open(read_file(folder / "cache.glb", kLimit));
    expect_sound_accessors(file);
    EXPECT_LT(file.buffer.size(), 2 * 24 * surface.x.size() + 12 * surface.triangles.size() + kFrames * 400);
    const Json& primitive = file.root.find("meshes")->elements()[0].find("primitives")->elements()[0];
    for (std::size_t i = 1; i < kFrames; ++i) {
        const std::vector<float> ways =
            floats_of(file, accessor_of(file, primitive.find("targets")->elements()[i - 1], "POSITION"));
        const std::uint32_t moved = 7;
        const auto parts = split_by_panel(surface);
        for (std::size_t v = 0; v < surface.x.size(); ++v)
            EXPECT_NEAR(ways[3 * v + 1], parts[0].vertices[v] == moved ? 0.01 * double(i) : 0, 1e-6);
    }
    const Json& sampler = file.root.find("animations")->elements()[0].find("samplers")->elements()[0];
    const std::vector<float> weights = floats_of(file, accessor_of(file, sampler, "output"));
    ASSERT_EQ(weights.size(), kFrames * (kFrames - 1));
    for (std::size_t k = 0; k < weights.size(); ++k)
        EXPECT_EQ(weights[k], k / (kFrames - 1) == k % (kFrames - 1) + 1 ? 1.0F : 0.0F);
}

// Where a reader that follows chapter 3.7 of the specification has the vertices of a mesh of one panel in a frame.
class SkinReader {
 public:
    explicit SkinReader(const Container& file) : file_(file) {}

    std::vector<Vec3d> positions(std::size_t mesh, std::size_t frame) const {
        const Json& primitive = file_.root.find("meshes")->elements()[mesh].find("primitives")->elements()[0];
        const Json& attributes = *primitive.find("attributes");
        std::vector<float> x = floats_of(file_, accessor_of(file_, attributes, "POSITION"));
        if (frame > 0) {
            const Json& target = primitive.find("targets")->elements()[frame - 1];
            const std::vector<float> ways = floats_of(file_, accessor_of(file_, target, "POSITION"));
            for (std::size_t i = 0; i < x.size(); ++i) x[i] += ways[i];
        }
        const std::vector<float> weights = floats_of(file_, accessor_of(file_, attributes, "WEIGHTS_0"));
        const std::vector<Eigen::Matrix4d> bones = joint_matrices(frame);
        std::vector<Vec3d> result;
        for (std::size_t v = 0; 3 * v < x.size(); ++v) {
            Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
            for (std::size_t k = 0; k < 4; ++k)
                sum += double(weights[4 * v + k]) *
                       bones[number_at<std::uint16_t>(file_, accessor_of(file_, attributes, "JOINTS_0"), 4 * v + k)];
            result.emplace_back(
                (sum * Eigen::Vector4d(double(x[3 * v]), double(x[3 * v + 1]), double(x[3 * v + 2]), 1)).head<3>());
        }
        return result;
    }

 private:
    Eigen::Matrix4d local(std::size_t node, std::size_t frame) const {
        Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
        const Json& json = file_.root.find("nodes")->elements()[node];
        const Json* matrix = json.find("matrix");
        for (int i = 0; matrix != nullptr && i < 16; ++i) m(i % 4, i / 4) = matrix->elements()[std::size_t(i)].number();
        const Json& animation = file_.root.find("animations")->elements()[0];
        for (const Json& channel : animation.find("channels")->elements()) {
            const std::string path = channel.find("target")->find("path")->string();
            if (index_of(*channel.find("target"), "node") != node) continue;
            const std::vector<float> values = floats_of(
                file_,
                accessor_of(file_, animation.find("samplers")->elements()[index_of(channel, "sampler")], "output"));
            const auto at = [&](std::size_t i) { return double(values[(path == "rotation" ? 4 : 3) * frame + i]); };
            if (path == "translation") m.topRightCorner<3, 1>() = Vec3d(at(0), at(1), at(2));
            if (path == "rotation") m.topLeftCorner<3, 3>() = Eigen::Quaterniond(at(3), at(0), at(1), at(2)).matrix();
            if (path != "scale") continue;
            EXPECT_NEAR(at(0) * at(1) * at(2), 1, 1e-6);
        }
        return m;
    }

    std::vector<Eigen::Matrix4d> joint_matrices(std::size_t frame) const {
        const auto& nodes = file_.root.find("nodes")->elements();
        std::vector<Eigen::Matrix4d> global(nodes.size(), Eigen::Matrix4d::Identity());
        std::vector<bool> is_child(nodes.size(), false);
        for (std::size_t i = 0; i < nodes.size(); ++i) {  // parents come first
            global[i] = is_child[i] ? Eigen::Matrix4d(global[i] * local(i, frame)) : local(i, frame);
            const Json* children = nodes[i].find("children");
            if (children == nullptr) continue;
            for (const Json& child : children->elements()) {
                is_child[std::size_t(child.number())] = true;
                global[std::size_t(child.number())] = global[i];
            }
        }
        const Json& skin = file_.root.find("skins")->elements()[0];
        const std::vector<float> binds = floats_of(file_, accessor_of(file_, skin, "inverseBindMatrices"));
        std::vector<Eigen::Matrix4d> matrices;
        for (const Json& joint : skin.find("joints")->elements()) {
            Eigen::Matrix4d bind;
            for (int i = 0; i < 16; ++i) bind(i % 4, i / 4) = double(binds[16 * matrices.size() + std::size_t(i)]);
            matrices.push_back(global[std::size_t(joint.number())] * bind);
        }
        return matrices;
    }

    const Container& file_;
};

// A box on two bones, the upper of which bends; one vertex gives way besides. The garment is a box round it.
TEST(MeshCache, glb_moves_a_body_by_its_bones_and_the_garment_by_choice) {
    const TemporaryFolder folder;
    Body body = shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 6);
    body.frame.linear() = Eigen::AngleAxisd(0.3, Vec3d::UnitX()).toRotationMatrix() * 0.01;  // of a file in cm
    body.bones = {{.name = "low", .parent = -1, .joint = {0, 0, 0}},
                  {.name = "high", .parent = 0, .joint = {0, 80, 0}}};
    set_rest_from_joints(body.bones);
    for (Bone& bone : body.bones) bone.inverse_bind = bone.inverse_bind * body.frame.inverse();
    for (const Vec3d& p : body.x) {
        const float high = float(smoothstep(p.y(), 0.6, 1.0));
        body.skin.push_back({.bones = {0, 1}, .weights = {1 - high, high}});
    }
    const DrawMesh surface = body_mesh(body),
                   garment = body_mesh(shapes::box({-0.22, 0.5, -0.12}, {0.22, 1.2, 0.12}, 6));
    constexpr std::size_t kFrames = 12;
    for (const bool binds_garment : {false, true}) {
        CacheOptions options{.frames = kFrames, .bones = &body, .binds_garment = binds_garment};
        const auto cache = open_mesh_cache(folder / "cache.glb", garment, options, &surface);
        std::vector<std::vector<Vec3f>> bodies, garments;
        for (std::size_t i = 0; i < kFrames; ++i) {
            Pose pose = rest_pose(body);
            turn_joint(pose, 1, Eigen::Quaterniond(Eigen::AngleAxisd(0.12 * double(i), Vec3d::UnitX())));
            pose.bones[0].translation.x() += 5.0 * double(i);
            bodies.emplace_back();
            for (const Vec3d& p : skin(body, pose)) bodies[i].push_back(p.cast<float>());
            bodies[i][5].z() += 0.003F * float(i);
            garments.emplace_back();
            for (const Vec3f& p : garment.x)
                garments[i].push_back(p + Vec3f(0.05F * float(i), 0.02F * float(i * i), 0));
            cache->add(garments[i], bodies[i], &pose);
        }
        cache->finish();
        const Container file = open(read_file(folder / "cache.glb", kLimit));
        expect_sound_accessors(file);
        EXPECT_EQ(file.root.find("nodes")->elements()[0].find("skin") != nullptr, binds_garment);
        const SkinReader reader(file);
        for (std::size_t i = 0; i < kFrames; ++i) {
            for (std::size_t mesh = binds_garment ? 0 : 1; mesh < 2; ++mesh) {
                const std::vector<std::uint32_t> order = split_by_panel(mesh == 0 ? garment : surface)[0].vertices;
                const std::vector<Vec3d> read = reader.positions(mesh, i);
                for (std::size_t v = 0; v < read.size(); ++v)
                    EXPECT_LT((read[v].cast<float>() - (mesh == 0 ? garments : bodies)[i][order[v]]).norm(), 1e-4F);
            }
            const Json& primitive = file.root.find("meshes")->elements()[1].find("primitives")->elements()[0];
            if (i == 0) continue;
            const Json& target = primitive.find("targets")->elements()[i - 1];
            const Json* sparse = accessor_of(file, target, "POSITION").find("sparse");
            ASSERT_NE(sparse, nullptr);
            EXPECT_EQ(index_of(*sparse, "count"), 1U) << "what the bones do takes no morph target";
        }
        Assimp::Importer importer;
        const aiScene* scene = importer.ReadFile((folder / "cache.glb").string(), 0);
        ASSERT_NE(scene, nullptr) << importer.GetErrorString();
        EXPECT_EQ(scene->mMeshes[1]->mNumBones, 2U);
        EXPECT_EQ(scene->mAnimations[0]->mNumChannels, 2U);
    }
}

TEST(MeshCache, glb_carries_textures_of_the_garment_and_not_of_its_body) {
    const TemporaryFolder folder;
    const DrawMesh surface = body_mesh(shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 3));
    const GarmentTextures textures{.base_colour = std::string("\x89PNG\r\n\x1A\n12345", 13), .normal = "normal"};
    for (const std::size_t frames : {std::size_t{1}, std::size_t{4}}) {  // of four that are planned
        const auto cache =
            open_mesh_cache(folder / "cache.glb", two_panels(), {.frames = 4, .textures = textures}, &surface);
        for (std::size_t i = 0; i < frames; ++i) cache->add(frame_of(two_panels(), i), frame_of(surface, i));
        cache->finish();
        const Container file = open(read_file(folder / "cache.glb", kLimit));
        expect_sound_accessors(file);
        const auto& images = file.root.find("images")->elements();
        ASSERT_EQ(images.size(), 2U);
        const Json& view = file.root.find("bufferViews")->elements()[index_of(images[0], "bufferView")];
        EXPECT_EQ(file.buffer.substr(index_of(view, "byteOffset"), index_of(view, "byteLength")), textures.base_colour);
        const auto& materials = file.root.find("materials")->elements();
        ASSERT_EQ(materials.size(), 3U);
        for (const std::size_t panel : {0U, 1U}) EXPECT_TRUE(materials[panel].find("normalTexture"));
        EXPECT_FALSE(materials[2].find("normalTexture"));
    }
}

TEST(MeshCache, of_obj_frames_is_one_garment_per_file) {
    const TemporaryFolder folder;
    write_frames(folder / "made/here/*.obj", two_panels(), 3, {.frames = 3, .first_frame = 9});
    EXPECT_EQ(names_in(folder / "made/here"), (std::vector<std::string>{"0009.obj", "0010.obj", "0011.obj"}));
    const DrawMesh read = read_garment(folder / "made/here/0011.obj");
    const std::vector<Vec3f> x = frame_of(two_panels(), 2);
    ASSERT_EQ(read.triangles.size(), 4U);
    for (std::size_t t = 0; t < 4; ++t)
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(read.x[read.triangles[t][k]], x[two_panels().triangles[t][k]]);
    EXPECT_EQ(frame_path("a/b_*.obj", 12345), "a/b_12345.obj");
    EXPECT_EQ(frame_path("*.obj", -3), "-0003.obj");
    EXPECT_EQ(frame_path("a/b/", 12), "a/b/0012.obj");
    for (const int time : {1, 2}) {  // the second time the folder is there
        write_frames(folder / (time == 1 ? "folder/" : "folder"), two_panels(), 2, {.frames = 2});
        EXPECT_EQ(names_in(folder / "folder"), (std::vector<std::string>{"0001.obj", "0002.obj"}));
    }
}

TEST(MeshCache, names_the_figures_of_what_does_not_fit_before_it_writes) {
    const TemporaryFolder folder;
    DrawMesh large = two_panels();
    large.x.resize(100'000, Vec3f::Zero());
    large.u.clear();
    large.panel.clear();
    for (std::uint32_t v = 0; v + 2 < 100'000; ++v) large.triangles.push_back({v, v + 1, v + 2});
    EXPECT_EQ(message_of(folder / "cache.glb", large, {.frames = 2000}),
              (folder / "cache.glb").string() +
                  ": 2000 frames of 100000 vertices need 4.8 GB, and a .glb file holds 4.3 GB: use fewer frames, a "
                  "coarser mesh or .pc2");
    EXPECT_NE(message_of(folder / "cache.glb", two_panels(), {.frames = 8193})
                  .find("8193 frames: a .glb file has at most 8192; "),
              std::string::npos);
    EXPECT_NE(message_of(folder / "cache.glb", two_panels(), {.frames = 5'000'000'000}).find("5000000000 frames: "),
              std::string::npos);
    EXPECT_NE(message_of(folder / "cache.pc2", large, {.frames = 2'000'000'000}).find("needs 2.4 PB, and "),
              std::string::npos);
    EXPECT_NE(message_of(folder / "cache.pc2", two_panels(), {.frames = 3'000'000'000}).find("2147483647"),
              std::string::npos);
    EXPECT_TRUE(names_in(folder / "").empty());
}

TEST(MeshCache, refuses_what_it_cannot_write_in_one_line) {
    const TemporaryFolder folder;
    const DrawMesh mesh = two_panels();
    for (const char* name : {"cache.abc", "cache", "frame.obj", "a*b*.obj", "*.pc"}) {
        EXPECT_FALSE(is_mesh_cache(name)) << name;
        EXPECT_NE(message_of(folder / name, mesh, {}).find("use .pc2, .glb or a folder, frames/"), std::string::npos);
    }
    for (const char* name : {"cache.PC2", "cache.Glb", "f_*.OBJ"}) EXPECT_TRUE(is_mesh_cache(name)) << name;
    EXPECT_NE(message_of(folder / "cache.pc2", mesh, {}, &mesh).find("only into .glb"), std::string::npos);
    EXPECT_NE(message_of(folder / "cache.pc2", DrawMesh(), {}).find("no triangles"), std::string::npos);
    for (const char* name : {"no/folder/cache.pc2", "no/folder/cache.glb"})
        EXPECT_NE(message_of(folder / name, mesh, {}).find("cannot write"), std::string::npos);
    write_file_atomically(folder / "taken", "x");
    EXPECT_NE(message_of(folder / "taken/*.obj", mesh, {}).find("cannot make the folder"), std::string::npos);
}

TEST(MeshCache, names_the_frame_and_the_vertex_that_is_not_finite) {
    const TemporaryFolder folder;
    for (const char* name : {"cache.pc2", "cache.glb", "*.obj"}) {
        const auto cache = open_mesh_cache(folder / name, two_panels(), {.frames = 3, .first_frame = 5});
        cache->add(two_panels().x);
        std::vector<Vec3f> bad = two_panels().x;
        bad[3].y() = std::numeric_limits<float>::quiet_NaN();
        try {
            cache->add(bad);
            ADD_FAILURE() << name;
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), "frame 6, vertex 3");
        }
    }
}

TEST(MeshCache, is_the_same_to_the_byte_each_time) {
    const TemporaryFolder folder;
    for (const char* name : {"a.pc2", "b.pc2", "a.glb", "b.glb"})
        write_frames(folder / name, two_panels(), 7, {.frames = 7});
    EXPECT_EQ(read_file(folder / "a.pc2", kLimit), read_file(folder / "b.pc2", kLimit));
    EXPECT_EQ(read_file(folder / "a.glb", kLimit), read_file(folder / "b.glb", kLimit));
}

}  // namespace
}  // namespace selvedge::sim
